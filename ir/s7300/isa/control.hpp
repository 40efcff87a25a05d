// Jumps, block ends, calls and the master control relay (002:2790-2828, 002:1585-1596). A jump decides here whether it
// is taken and what it does to the status word; ir/s7300/control.hpp takes it. The MCR is general knowledge.
#pragma once

#include "ir/s7300/index_check.hpp"
#include "ir/s7300/isa/load.hpp"

namespace rungproof::isa::step7 {

constexpr Desc controlDesc(std::string_view stl, std::string_view german, std::string_view meaning, Control control,
                           std::string_view manual) {
  Desc desc = accuDesc(stl, german, meaning, "program control", manual);
  desc.control = control;
  return desc;
}
constexpr Desc jumpDesc(std::string_view stl, std::string_view german, std::string_view meaning,
                        std::string_view manual) {
  Desc desc = withOperands(controlDesc(stl, german, meaning, Control::Branch, manual),
                           {in("label", Type::Label, form7::Const)});
  desc.group = "jumps";
  return desc;
}

/// The mark of a label; a statement of its own.
struct Label {
  static constexpr Desc desc = withOperands(controlDesc("LABEL", {}, "label", Control::LabelMark, "002:1262"),
                                            {in("label", Type::Label, form7::Const)});
  template <class D>
  static void run(Step7Args<D>&) {}
};

/// What a body in SCL asks before it computes the place of an element: whether the DINT in ACCU1 lies between the
/// bounds. The CPU itself does not ask. Nobody writes it.
struct IndexCheck {
  static constexpr Desc desc = [] {
    Desc d = withOperands(accuDesc(indexCheck, {}, "compare an index with the bounds of its array", "SCL", "002:2068"),
                          {in("first", Type::DInt, form7::Const), in("last", Type::DInt, form7::Const)});
    d.drawingOnly = true;
    return d;
  }();
  template <class D>
  static void run(Step7Args<D>& a) {
    const auto bound = [&](std::size_t i) {
      return a.number(static_cast<std::uint64_t>(a.instruction.operands[i].value) & 0xFFFFFFFF);
    };
    const auto isInside = a.d.land(a.d.sle(bound(0), a.accu1(), 32), a.d.sle(a.accu1(), bound(1), 32));
    a.m.note(Hazard::SclIndex, a.d.lnot(isInside));
  }
};

/// The end of a body in SCL that writes no OK: BR is ENO. Whether the compiler was told to set OK is not known; then an
/// overflow clears it. OS remembers one since the last call; `lost`: it may have forgotten one.
struct BodyEnd {
  static constexpr Desc desc = [] {
    Desc d = withOperands(accuDesc(bodyEnd, {}, "ENO of a body in SCL", "SCL", "general knowledge"),
                          {in("lost", Type::DInt, form7::Const)});
    d.drawingOnly = true;
    return d;
  }();
  template <class D>
  static void run(Step7Args<D>& a) {
    constexpr std::uint32_t index = 0x30B;  // beside what instructions leave open
    const bool isLost = a.instruction.operands[0].value != 0;
    const auto mayFail = isLost ? a.d.constant(true) : a.s.os;
    if (const auto known = a.d.truth(mayFail); known && !*known) return a.m.put(a.s.br, a.d.constant(true));
    a.m.put(a.s.br, a.d.lnot(a.d.land(mayFail, a.m.externalBit(External::UnknownResult, index))));
  }
};

/// ACCU1 and the RLO, of which no text tells what they are: any value in proofs; a run keeps them.
struct OpenValue {
  static constexpr Desc desc = [] {
    Desc d = accuDesc(openValue, {}, "a value that no text tells", "SCL", "general knowledge");
    d.drawingOnly = true;
    return d;
  }();
  template <class D>
  static void run(Step7Args<D>& a) {
    constexpr std::uint32_t index = 0x30C;  // beside what instructions leave open
    a.m.put(a.s.accu[0], a.d.bxor(a.s.accu[0], a.m.external(External::UnknownResult, index, 32), 32), 32);
    a.m.put(a.s.rlo, a.d.lxor(a.s.rlo, a.m.externalBit(External::UnknownResult, index + 1)));
  }
};

enum class JumpOn : std::uint8_t { Always, Ov, Zero, NotZero, Plus, Minus, PlusOrZero, MinusOrZero, Unordered };

/// JU, JO, JZ, JN, JP, JM, JPZ, JMZ, JUO: no status bit changes.
template <JumpOn on, Name stlName, Name germanName, Name meaning, Name manualLine>
struct PlainJump {
  /// The unconditional one can stand in the list of a distributor.
  static constexpr Desc desc = [] {
    Desc d = jumpDesc(stlName.view(), germanName.view(), meaning.view(), manualLine.view());
    if (on == JumpOn::Always) d.execution = Execution::Control;
    return d;
  }();
  template <class D>
  static void run(Step7Args<D>& a) {
    D& d = a.d;
    switch (on) {
      case JumpOn::Always: a.s.jumps = a.yes(); break;
      case JumpOn::Ov: a.s.jumps = a.s.ov; break;
      case JumpOn::Zero: a.s.jumps = a.conditionCode(false, false); break;
      case JumpOn::NotZero: a.s.jumps = d.lxor(a.s.cc1, a.s.cc0); break;
      case JumpOn::Plus: a.s.jumps = a.conditionCode(true, false); break;
      case JumpOn::Minus: a.s.jumps = a.conditionCode(false, true); break;
      case JumpOn::PlusOrZero: a.s.jumps = d.lnot(a.s.cc0); break;
      case JumpOn::MinusOrZero: a.s.jumps = d.lnot(a.s.cc1); break;
      case JumpOn::Unordered: a.s.jumps = a.conditionCode(true, true); break;
    }
  }
};

/// JOS: resets OS.
struct JumpOs {
  static constexpr Desc desc = jumpDesc("JOS", "SPS", "jump if OS = 1", "002:2801");
  template <class D>
  static void run(Step7Args<D>& a) {
    a.s.jumps = a.s.os;
    a.setBit(a.s.os, a.no());
  }
};

/// JC, JCN, JCB, JNB: RLO is 1 afterwards; the latter two keep it in BR.
template <bool onOne, bool saves, Name stlName, Name germanName, Name manualLine>
struct RloJump {
  static constexpr Desc desc =
      jumpDesc(stlName.view(), germanName.view(), onOne ? "jump if RLO = 1" : "jump if RLO = 0", manualLine.view());
  template <class D>
  static void run(Step7Args<D>& a) {
    a.s.jumps = onOne ? a.s.rlo : a.d.lnot(a.s.rlo);
    if constexpr (saves) a.setBit(a.s.br, a.s.rlo);
    a.setBit(a.s.rlo, a.yes());
    a.endString(a.yes());
  }
};

template <bool onOne, Name stlName, Name germanName, Name manualLine>
struct BrJump {
  static constexpr Desc desc =
      jumpDesc(stlName.view(), germanName.view(), onOne ? "jump if BR = 1" : "jump if BR = 0", manualLine.view());
  template <class D>
  static void run(Step7Args<D>& a) {
    a.s.jumps = onOne ? a.s.br : a.d.lnot(a.s.br);
    a.endString(a.yes());
  }
};

/// LOOP: ACCU1-L less 1, modulo 65536; jumps while it is not 0 (002:1783-1785).
struct Loop {
  static constexpr Desc desc = jumpDesc("LOOP", {}, "count ACCU1-L down, jump while it is not 0", "002:2809");
  template <class D>
  static void run(Step7Args<D>& a) {
    const auto left = a.d.sub(a.low1(), a.number(1, 16), 16);
    a.setLow1(left);
    a.s.jumps = a.d.lnot(a.d.equal(left, a.number(0, 16), 16));
  }
};

/// JL: ACCU1-L-L chooses one of the JU that follow; beyond the list it goes to its own label.
struct Distributor {
  static constexpr Desc desc = [] {
    Desc d = jumpDesc("JL", "SPL", "jump distributor", "002:2793");
    d.control = Control::Distributor;
    return d;
  }();
  template <class D>
  static void run(Step7Args<D>&) {}
};

/// BE, BEU. What a block leaves behind in the status word is the same whether an instruction or its text ends it:
/// control.hpp says it.
template <Name stlName, Name germanName, Name manualLine>
struct BlockEnd {
  static constexpr Desc desc =
      controlDesc(stlName.view(), germanName.view(), "end of the block", Control::BlockEnd, manualLine.view());
  template <class D>
  static void run(Step7Args<D>& a) {
    a.s.jumps = a.yes();
  }
};

struct BlockEndConditional {
  static constexpr Desc desc = controlDesc("BEC", "BEB", "end of the block if RLO = 1", Control::BlockEnd, "002:2823");
  template <class D>
  static void run(Step7Args<D>& a) {
    a.s.jumps = a.s.rlo;
    a.setBit(a.s.rlo, a.yes());
    a.endString(a.yes());
  }
};

/// CALL, UC, CC. CC writes the status bits whether it calls or not.
template <bool conditional, Name stlName, Name manualLine>
struct BlockCall {
  static constexpr Desc desc = withOperands(
      controlDesc(stlName.view(), {}, conditional ? "call if RLO = 1" : "call", Control::BlockCall, manualLine.view()),
      {in("block", Type::Block, form7::Const), optional(in("parameters", Type::Parameter, ~Forms{0}))});
  template <class D>
  static void run(Step7Args<D>& a) {
    a.s.jumps = conditional ? a.s.rlo : a.yes();
    a.setBit(a.s.os, a.no());
    if constexpr (conditional) a.setBit(a.s.rlo, a.yes());
    a.endString(a.yes());
  }
};

struct OpenRelay {
  static constexpr Desc desc = accuDesc("MCR(", {}, "begin an MCR zone", "program control", "002:2825");
  template <class D>
  static void run(Step7Args<D>& a) {
    for (std::size_t i = mcrLevels - 1; i > 0; --i) a.m.put(a.s.mcr[i], a.s.mcr[i - 1]);
    a.m.put(a.s.mcr[0], a.s.rlo);
    a.endString(a.yes());
  }
};

struct CloseRelay {
  static constexpr Desc desc = accuDesc(")MCR", {}, "end an MCR zone", "program control", "002:2826");
  template <class D>
  static void run(Step7Args<D>& a) {
    for (std::size_t i = 0; i + 1 < mcrLevels; ++i) a.m.put(a.s.mcr[i], a.s.mcr[i + 1]);
    a.m.put(a.s.mcr[mcrLevels - 1], a.yes());
    a.endString(a.yes());
  }
};

template <bool on, Name stlName, Name manualLine>
struct ActivateRelay {
  static constexpr Desc desc = accuDesc(stlName.view(), {}, on ? "activate the MCR" : "deactivate the MCR",
                                        "program control", manualLine.view());
  template <class D>
  static void run(Step7Args<D>& a) {
    a.m.put(a.s.mcrActive, a.d.constant(on));
  }
};

using Step7ControlGroup =
    Group<Label, IndexCheck, BodyEnd, OpenValue, PlainJump<JumpOn::Always, "JU", "SPA", "jump", "002:2792">,
          Distributor, RloJump<true, false, "JC", "SPB", "002:2794">, RloJump<false, false, "JCN", "SPBN", "002:2795">,
          RloJump<true, true, "JCB", "SPBB", "002:2796">, RloJump<false, true, "JNB", "SPBNB", "002:2797">,
          BrJump<true, "JBI", "SPBI", "002:2798">, BrJump<false, "JNBI", "SPBIN", "002:2799">,
          PlainJump<JumpOn::Ov, "JO", "SPO", "jump if OV = 1", "002:2800">, JumpOs,
          PlainJump<JumpOn::Zero, "JZ", "SPZ", "jump if the result is 0", "002:2802">,
          PlainJump<JumpOn::NotZero, "JN", "SPN", "jump if the result is not 0", "002:2803">,
          PlainJump<JumpOn::Plus, "JP", "SPP", "jump if the result is positive", "002:2804">,
          PlainJump<JumpOn::Minus, "JM", "SPM", "jump if the result is negative", "002:2805">,
          PlainJump<JumpOn::PlusOrZero, "JPZ", "SPPZ", "jump if the result is not negative", "002:2806">,
          PlainJump<JumpOn::MinusOrZero, "JMZ", "SPMZ", "jump if the result is not positive", "002:2807">,
          PlainJump<JumpOn::Unordered, "JUO", "SPU", "jump if the result is no number", "002:2808">, Loop,
          BlockCall<false, "CALL", "002:2815">, BlockCall<true, "CC", "002:2820">, BlockCall<false, "UC", "002:2821">,
          BlockEnd<"BE", "BE", "002:2822">, BlockEndConditional, BlockEnd<"BEU", "BEA", "002:2824">, OpenRelay,
          CloseRelay, ActivateRelay<true, "MCRA", "002:2827">, ActivateRelay<false, "MCRD", "002:2828">>;

}  // namespace rungproof::isa::step7
