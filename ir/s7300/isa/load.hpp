// Load, transfer, address registers, accumulators and data block registers (002:2832-2863, 002:2905-2910;
// accumulators 002:1424-1545). None of them changes a status bit except T STW.
#pragma once

#include "ir/s7300/isa/step7_group.hpp"

namespace rungproof::isa::step7 {

constexpr Desc accuDesc(std::string_view stl, std::string_view german, std::string_view meaning, std::string_view group,
                        std::string_view manual) {
  Desc desc;
  desc.stl = stl;
  desc.german = german;
  desc.meaning = meaning;
  desc.group = group;
  desc.execution = Execution::Always;
  desc.manual = manual;
  return desc;
}

/// L: bytes and words fill up with zeros.
struct LoadValue {
  static constexpr Desc desc = withOperands(accuDesc("L", {}, "load", "load and transfer", "002:2842"),
                                            {in("value", Type::Value, form7::memory | form7::PI | form7::Const)});
  template <class D>
  static void run(Step7Args<D>& a) {
    const bool isMemory = a.operand().isMemory();  // the address of a parameter is a double word, as constants are
    const Width width = isMemory ? a.operand().width : Width::DWord;
    a.push(a.places.load(a.places.find(a.operand(), width), width));
  }
};

/// T: where a master control relay is off it writes 0.
struct TransferValue {
  static constexpr Desc desc = withOperands(accuDesc("T", {}, "transfer", "load and transfer", "002:2832"),
                                            {out("value", Type::Value, form7::memory | form7::PQ)});
  template <class D>
  static void run(Step7Args<D>& a) {
    const Width width = a.operand().width;
    const auto value = a.d.select(a.isRelayOff(), a.number(0), a.accu1(), 32);
    a.places.save(a.places.find(a.operand(), width), width, value);
  }
};

/// Bits of the status word from bit 0: /FC RLO STA OR OS OV CC0 CC1 BR. Some CPUs read and write three of them not at
/// all (002:1603).
template <class D, class Visit>
void eachStatusBit(Step7Args<D>& a, Visit&& visit) {
  auto& s = a.s;
  const bool hides = step7Row(a.m.target.cpu).hidesStatus;
  typename D::Bool* bits[] = {&s.firstCheck, &s.rlo, &s.sta, &s.orBit, &s.os, &s.ov, &s.cc0, &s.cc1, &s.br};
  for (int i = 0; i < 9; ++i) visit(i, *bits[i], hides && (i == 0 || i == 2 || i == 3));
}

struct LoadStatus {
  static constexpr Desc desc = accuDesc("L STW", {}, "load the status word", "load and transfer", "002:2843");
  template <class D>
  static void run(Step7Args<D>& a) {
    auto word = a.number(0);
    eachStatusBit(a, [&](int bit, const auto& value, bool isHidden) {
      if (!isHidden)
        word = a.d.bor(
            word, a.d.shl(a.d.zext(a.d.fromBool(value, 1), 1, 32), a.number(static_cast<std::uint64_t>(bit)), 32), 32);
    });
    a.push(word);
  }
};

struct TransferStatus {
  static constexpr Desc desc = accuDesc("T STW", {}, "transfer into the status word", "load and transfer", "002:2833");
  template <class D>
  static void run(Step7Args<D>& a) {
    const auto word = a.accu1();
    eachStatusBit(a, [&](int bit, auto& value, bool isHidden) {
      if (!isHidden) a.setBit(value, a.d.bit(word, bit));
    });
  }
};

/// L DBNO, L DINO, L DBLG, L DILG (002:663-671).
template <bool inDi, bool length, Name stlName, Name meaning, Name manualLine>
struct LoadBlockFact {
  static constexpr Desc desc = accuDesc(stlName.view(), {}, meaning.view(), "data blocks", manualLine.view());
  template <class D>
  static void run(Step7Args<D>& a) {
    const auto block = inDi ? a.s.di : a.s.db;
    if constexpr (!length) {
      a.push(a.d.zext(block, 16, 32));
    } else {
      auto value = a.number(0);
      for (const DataBlock& b : a.m.plan.program->dataBlocks)
        value = a.d.select(a.d.equal(block, a.number(b.number, 16), 16), a.number(b.bytes.size()), value, 32);
      a.push(value);
    }
  }
};

/// LAR1, LAR2: from ACCU1, or from the operand.
template <int ar, Name stlName, Name manualLine>
struct LoadAddressRegister {
  static constexpr Desc desc =
      withOperands(accuDesc(stlName.view(), {}, "load an address register", "load and transfer", manualLine.view()),
                   {optional(in("pointer", Type::DWord, form7::M | form7::L | form7::DB | form7::Const))});
  template <class D>
  static void run(Step7Args<D>& a) {
    const auto value =
        a.hasOperand() ? a.places.load(a.places.find(a.operand(), Width::DWord), Width::DWord) : a.accu1();
    a.m.put(a.s.ar[ar], value, 32);
  }
};

struct LoadAr1FromAr2 {
  static constexpr Desc desc = accuDesc("LAR1 AR2", {}, "AR2 to AR1", "load and transfer", "002:2846");
  template <class D>
  static void run(Step7Args<D>& a) {
    a.m.put(a.s.ar[0], a.s.ar[1], 32);
  }
};

template <int ar, Name stlName, Name manualLine>
struct TransferAddressRegister {
  static constexpr Desc desc =
      withOperands(accuDesc(stlName.view(), {}, "transfer an address register", "load and transfer", manualLine.view()),
                   {optional(out("pointer", Type::DWord, form7::M | form7::L | form7::DB))});
  template <class D>
  static void run(Step7Args<D>& a) {
    if (!a.hasOperand()) return a.push(a.s.ar[ar]);
    a.places.save(a.places.find(a.operand(), Width::DWord), Width::DWord, a.s.ar[ar]);
  }
};

struct TransferAr1ToAr2 {
  static constexpr Desc desc = accuDesc("TAR1 AR2", {}, "AR1 to AR2", "load and transfer", "002:2836");
  template <class D>
  static void run(Step7Args<D>& a) {
    a.m.put(a.s.ar[1], a.s.ar[0], 32);
  }
};

struct ExchangeAddressRegisters {
  static constexpr Desc desc = accuDesc("CAR", "TAR", "exchange AR1 and AR2", "load and transfer", "002:2849");
  template <class D>
  static void run(Step7Args<D>& a) {
    const auto first = a.s.ar[0];
    a.m.put(a.s.ar[0], a.s.ar[1], 32);
    a.m.put(a.s.ar[1], first, 32);
  }
};

/// +AR1, +AR2: the 24 bits of the address take the sum, the area stays; ACCU1-L counts with its sign.
template <int ar, Name stlName, Name manualLine>
struct AddToAddressRegister {
  static constexpr Desc desc =
      withOperands(accuDesc(stlName.view(), {}, "add to an address register", "accumulators", manualLine.view()),
                   {optional(in("pointer", Type::DWord, form7::Const))});
  template <class D>
  static void run(Step7Args<D>& a) {
    const auto step =
        a.hasOperand() ? a.number(static_cast<std::uint64_t>(a.operand().value), 24) : a.d.sext(a.low1(), 16, 24);
    const auto old = a.s.ar[ar];
    const auto sum = a.d.add(a.d.extract(old, 23, 0), step, 24);
    a.m.put(a.s.ar[ar], a.d.concat(a.d.extract(old, 31, 24), 8, sum, 24), 32);
  }
};

struct Toggle {
  static constexpr Desc desc = accuDesc("TAK", {}, "exchange ACCU1 and ACCU2", "accumulators", "002:1522");
  template <class D>
  static void run(Step7Args<D>& a) {
    const auto first = a.accu1();
    a.setAccu1(a.accu2());
    a.m.put(a.s.accu[1], first, 32);
  }
};

struct PushAccu {
  static constexpr Desc desc = accuDesc("PUSH", {}, "accumulators one further", "accumulators", "002:1520");
  template <class D>
  static void run(Step7Args<D>& a) {
    for (std::size_t i = a.hasFourAccumulators() ? 3 : 1; i > 0; --i) a.m.put(a.s.accu[i], a.s.accu[i - 1], 32);
  }
};

struct PopAccu {
  static constexpr Desc desc = accuDesc("POP", {}, "accumulators one back", "accumulators", "002:1521");
  template <class D>
  static void run(Step7Args<D>& a) {
    for (std::size_t i = 0; i < (a.hasFourAccumulators() ? 3U : 1U); ++i) a.m.put(a.s.accu[i], a.s.accu[i + 1], 32);
  }
};

constexpr CpuSet fourAccumulators = [] {
  CpuSet set = 0;
  for (std::size_t i = 0; i < cpu_rows::step7.size(); ++i) {
    if (cpu_rows::step7[i].accumulators == 4) set |= cpuBit(static_cast<Cpu>(firstStep7Cpu + i));
  }
  return set;
}();

struct Enter {
  static constexpr Desc desc = [] {
    Desc d = accuDesc("ENT", {}, "ACCU3 to ACCU4, ACCU2 to ACCU3", "accumulators", "002:1523");
    d.cpus = fourAccumulators;
    return d;
  }();
  template <class D>
  static void run(Step7Args<D>& a) {
    a.m.put(a.s.accu[3], a.s.accu[2], 32);
    a.m.put(a.s.accu[2], a.s.accu[1], 32);
  }
};

struct Leave {
  static constexpr Desc desc = [] {
    Desc d = accuDesc("LEAVE", {}, "ACCU3 to ACCU2, ACCU4 to ACCU3", "accumulators", "002:1524");
    d.cpus = fourAccumulators;
    return d;
  }();
  template <class D>
  static void run(Step7Args<D>& a) {
    a.m.put(a.s.accu[1], a.s.accu[2], 32);
    a.m.put(a.s.accu[2], a.s.accu[3], 32);
  }
};

/// INC, DEC: ACCU1-L-L only, modulo 256 (002:1487-1494).
template <bool up, Name stlName, Name manualLine>
struct CountByte {
  static constexpr Desc desc =
      withOperands(accuDesc(stlName.view(), {}, up ? "add to ACCU1-L-L" : "subtract from ACCU1-L-L", "accumulators",
                            manualLine.view()),
                   {in("number", Type::Byte, form7::Const).within({{0, 255}})});
  template <class D>
  static void run(Step7Args<D>& a) {
    const auto low = a.d.extract(a.accu1(), 7, 0);
    const auto n = a.number(static_cast<std::uint64_t>(a.operand().value), 8);
    a.setAccu1(a.d.concat(a.d.extract(a.accu1(), 31, 8), 24, up ? a.d.add(low, n, 8) : a.d.sub(low, n, 8), 8));
  }
};

/// NOP 0, NOP 1, BLD n: for displays and programming devices.
template <Name stlName, bool hasNumber, Name manualLine>
struct Nothing {
  static constexpr Desc desc = [] {
    Desc d = accuDesc(stlName.view(), {}, "no operation", "accumulators", manualLine.view());
    return hasNumber ? withOperands(d, {in("number", Type::Byte, form7::Const).within({{0, 255}})}) : d;
  }();
  template <class D>
  static void run(Step7Args<D>&) {}
};

/// OPN: the number becomes that of the open block, in the DB or the DI register (002:640-641). A block that is not
/// loaded is an error when it is opened; whether the one before stays open behind it is not stated.
struct OpenBlock {
  static constexpr Desc desc = withOperands(accuDesc("OPN", "AUF", "open a data block", "data blocks", "002:2905"),
                                            {in("block", Type::Block, form7::DB)});
  template <class D>
  static void run(Step7Args<D>& a) {
    const auto number = a.places.blockNumberOf(a.operand());
    auto exists = a.d.equal(number, a.number(0, 16), 16);  // OPN DB0 leaves none open
    for (const DataBlock& b : a.m.plan.program->dataBlocks) {
      if (!b.unlinked) exists = a.d.lor(exists, a.d.equal(number, a.number(b.number, 16), 16));
    }
    a.m.error(Hazard::S7BlockMissing, a.d.lnot(exists));
    const bool inDi = a.operand().reach != nullptr && a.operand().reach->inDi;
    auto& open = inDi ? a.s.di : a.s.db;
    auto opens = exists;
    if (a.m.survivesErrors()) opens = a.d.lor(exists, a.d.lnot(a.m.externalBit(External::UnknownResult, 0x305)));
    a.m.put(open, a.d.select(opens, number, open, 16), 16);
  }
};

struct ExchangeBlocks {
  static constexpr Desc desc = accuDesc("CDB", "TDB", "exchange DB and DI register", "data blocks", "002:2906");
  template <class D>
  static void run(Step7Args<D>& a) {
    const auto db = a.s.db;
    a.m.put(a.s.db, a.s.di, 16);
    a.m.put(a.s.di, db, 16);
  }
};

using Step7LoadGroup =
    Group<LoadValue, TransferValue, LoadStatus, TransferStatus,
          LoadBlockFact<false, false, "L DBNO", "number of the open data block", "002:665">,
          LoadBlockFact<true, false, "L DINO", "number of the open instance block", "002:666">,
          LoadBlockFact<false, true, "L DBLG", "length of the open data block", "002:670">,
          LoadBlockFact<true, true, "L DILG", "length of the open instance block", "002:671">,
          LoadAddressRegister<0, "LAR1", "002:2844">, LoadAddressRegister<1, "LAR2", "002:2847">, LoadAr1FromAr2,
          TransferAddressRegister<0, "TAR1", "002:2834">, TransferAddressRegister<1, "TAR2", "002:2837">,
          TransferAr1ToAr2, ExchangeAddressRegisters, AddToAddressRegister<0, "+AR1", "002:2860">,
          AddToAddressRegister<1, "+AR2", "002:2861">, Toggle, PushAccu, PopAccu, Enter, Leave,
          CountByte<true, "INC", "002:2859">, CountByte<false, "DEC", "002:2858">, Nothing<"NOP 0", false, "002:2863">,
          Nothing<"NOP 1", false, "002:2863">, Nothing<"BLD", true, "002:2862">, OpenBlock, ExchangeBlocks>;

}  // namespace rungproof::isa::step7
