// What the S7-200 SMART adds for its networks: GET and PUT between CPUs, open communication (TCON TSEND TRECV TDCON),
// the CPU's address (GIP SIP), PROFINET (BLKMOV_BIR BLKMOV_BIW RDREC WRREC), and GERR. A request goes on after its
// instruction: its table's first byte, and for those that read a buffer named by a pointer in the table, change later
// and from outside. GET and PUT are devices (ir/s7200/device_end.hpp); networks with the others are left out
// (Desc::modelling). Tests: tests/smart.
#pragma once

#include "ir/s7200/error_codes.hpp"
#include "ir/s7200/isa/comm.hpp"
#include "ir/s7200/isa/control.hpp"

namespace rungproof::isa {

inline constexpr Forms ethernetTable = (form::I | form::Q | form::V | form::M | form::SM | form::S | form::Pointers);

constexpr Desc ethernetDesc(std::string_view stl, std::string_view box, std::string_view meaning, Modelling modelling,
                            std::initializer_list<OperandDesc> operands) {
  return withOperands({.stl = stl,
                       .meaning = meaning,
                       .group = "communication",
                       .drawn = box,
                       .stack = {1, 0, 0},
                       .eno = true,
                       .cpus = smartCpus,
                       .modelling = modelling,
                       .manual = smartManual},
                      operands);
}

/// GET and PUT. The table: 0 status D A E 0 eeee, 1-4 address of the partner, 5-6 zero, 7-10 pointer to its data, 11
/// length, 12-15 pointer to the own data in I, Q, M or V. At most 16 at a time. What the CPU checks at once, and what
/// the end of the request tells, is not stated: any request may be refused at once with any code, and one with a wrong
/// table may seem to be accepted; nothing is read or written for it.
inline constexpr int requestTableBytes = 16;
template <bool writes, Name stlName, Name meaning>
struct Request {
  static constexpr OperandDesc table =
      inout("TABLE", Type::Byte, ethernetTable).elements(requestTableBytes, requestTableBytes);
  static constexpr Desc desc = [] {
    Desc d = ethernetDesc(stlName.view(), {}, meaning.view(), Modelling::Whole, {table});
    d.role = writes ? Role::Put : Role::Get;
    return d;
  }();
  static constexpr int lengthAt = 11, pointerElement = 3;  ///< byte; double word
  static constexpr std::uint64_t most = writes ? 212 : 222;
  static constexpr std::uint64_t done = 0x80, active = 0x40, error = 0x20, badTable = 1, queueFull = 2;

  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    D& d = m.d;
    const auto byte = [&](std::uint64_t value) { return m.number(value, 8); };
    const auto fits = a.fits(0, m.number(requestTableBytes, 16), Width::Byte);
    m.hazard(Hazard::OutOfRange, d.lnot(fits));
    const auto again = d.land(d.bit(a.value(0), 6), m.reads({Choice::NetworkAgain, "ignored"}));
    m.when(d.land(fits, d.lnot(again)), [&] {
      const auto length = a.element(0, lengthAt, Width::Byte);
      const auto own = a.element(0, pointerElement, Width::DWord);
      const auto isWrong = d.lnot(mayHold(m, own, length));
      const auto open = m.external(External::UnknownResult, 0, 8);
      const auto code = d.band(open, byte(0x0F), 8);
      const auto isCode = d.land(d.ule(byte(1), code, 8), d.ule(code, byte(lastNetworkError(m.target)), 8));
      const auto refuses = d.land(d.equal(d.band(open, byte(0x70), 8), byte(error), 8), isCode);
      const auto full = isQueueFull(m);
      const auto refused = d.lor(d.lor(full, refuses), d.land(isWrong, d.lnot(d.bit(open, 6))));
      const auto reason = d.select(full, byte(queueFull), d.select(isWrong, byte(badTable), code, 8), 8);
      const auto status = d.bor(d.bor(byte(error), reason, 8), d.band(open, byte(done), 8), 8);
      m.hazard(Hazard::PortParameter, refused);
      a.store(0, d.select(refused, status, byte(active), 8));
      m.when(d.lnot(refused), [&] {
        const auto none = m.number(0, 32);
        enterRequest(m, addressOf(m, a, 0), length, true, writes ? none : d.select(isWrong, none, own, 32));
      });
      if constexpr (!writes) {  // where the answer goes to is known to the proof from here
        Ref<D> buffer;
        m.when(d.lnot(d.lor(refused, isWrong)), [&] { a.follow(own, Width::Byte, buffer); });
      }
    });
  }

 private:
  /// Whether the length and the pointer to the own data are legal.
  template <class D>
  static typename D::Bool mayHold(Machine<D>& m, typename D::Bits own, typename D::Bits length) {
    D& d = m.d;
    auto isIn = d.constant(false);
    const auto end = d.add(d.zext(d.extract(own, 23, 0), 24, 32), d.zext(length, 8, 32), 32);
    for (const Area area : {Area::I, Area::Q, Area::M, Area::V}) {
      const auto isTag = d.equal(d.extract(own, 31, 24), m.number(*areaInfo(area).tag, 8), 8);
      isIn = d.lor(isIn, d.land(isTag, d.ule(end, m.number(m.areaSize(area), 32), 32)));
    }
    const auto isLength = d.land(d.lnot(d.equal(length, m.number(0, 8), 8)), d.ule(length, m.number(most, 8), 8));
    return d.land(isIn, isLength);
  }
};

/// A request on a connection. Whether TCON and its kin take the connection as a second operand is uncertain: they may.
template <Modelling modelling, Name stlName, Name meaning>
struct TableRequest : InScan {
  static constexpr OperandDesc table = inout("TABLE", Type::Byte, ethernetTable);
  static constexpr OperandDesc connection = optional(in("ConnID", Type::Word, form::wordIn));
  static constexpr Desc desc = ethernetDesc(stlName.view(), {}, meaning.view(), modelling, {table, connection});
};

/// GIP: address, subnet mask and gateway as the system block or SIP have set them.
struct GetAddress {
  static constexpr Desc desc =
      ethernetDesc("GIP", "GIP_ADDR", "get the IP address, subnet mask and gateway", Modelling::Whole,
                   {out("ADDR", Type::DWord, form::dwordOut), out("MASK", Type::DWord, form::dwordOut),
                    out("GATE", Type::DWord, form::dwordOut)});
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    for (std::uint32_t i = 0; i < 3; ++i) a.store(i, m.external(External::UnknownResult, i, 32));
  }
};

/// SIP: sets them; nothing of it shows in the program. Not in an interrupt routine (0004).
struct SetAddress {
  static constexpr Desc desc = [] {
    Desc d = ethernetDesc("SIP", "SIP_ADDR", "set the IP address, subnet mask and gateway", Modelling::Whole,
                          {in("ADDR", Type::DWord, form::dwordIn), in("MASK", Type::DWord, form::dwordIn),
                           in("GATE", Type::DWord, form::dwordIn)});
    d.notInInterrupt = true;
    return d;
  }();
  template <class D>
  static void run(Machine<D>& m, Args<D>&) {
    m.hazard(Hazard::NotInInterrupt, m.d.constant(m.inInterrupt));
  }
};

/// GERR: the code of a run-time error, which it clears together with SM4.3. Which one of several it is, is open: any
/// code of such an error.
struct GetError {
  static constexpr Desc desc = [] {
    Desc d = ethernetDesc("GERR", "GET_ERROR", "get and clear the code of a run-time error", Modelling::Whole,
                          {out("ECODE", Type::Word, form::wordOut)});
    d.group = "program control";
    return d;
  }();
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    const auto any = m.external(External::UnknownResult, errorCodeIndex, 16);
    auto isCode = m.d.constant(false);
    for (const auto& [first, last] : errorCodes) {
      const auto low = m.d.literal(first, 16), high = m.d.literal(last, 16);
      isCode = m.d.lor(isCode, m.d.land(m.d.ule(low, any, 16), m.d.ule(any, high, 16)));
    }
    const auto code = m.d.select(isCode, any, m.d.literal(badPointerCode, 16), 16);
    a.store(0, m.d.select(m.sm(4, 3), code, m.number(0, 16), 16));
    m.setSm(4, 3, m.d.constant(false));
  }
};

using GetRequest = Request<false, "GET", "read from another CPU by Ethernet">;
using PutRequest = Request<true, "PUT", "write to another CPU by Ethernet">;
using Connect = TableRequest<Modelling::WritesOperands, "TCON", "open a connection">;
using Send = TableRequest<Modelling::WritesOperands, "TSEND", "send on a connection">;
using ReceiveOn = TableRequest<Modelling::WritesAnything, "TRECV", "receive on a connection">;
using Disconnect = TableRequest<Modelling::WritesOperands, "TDCON", "close a connection">;

/// RDREC, WRREC, BLKMOV_BIR, BLKMOV_BIW: their operands in STL stand in no text.
template <Name stlName, Name meaning>
struct ProfinetAccess : InScan {
  static constexpr OperandDesc any(std::string_view name) { return optional(inout(name, Type::Byte, form::byteIn)); }
  static constexpr Desc desc =
      ethernetDesc(stlName.view(), {}, meaning.view(), Modelling::WritesAnything,
                   {any("operand 1"), any("operand 2"), any("operand 3"), any("operand 4"), any("operand 5")});
};
using ReadRecord = ProfinetAccess<"RDREC", "read a data record of a PROFINET device">;
using WriteRecord = ProfinetAccess<"WRREC", "write a data record of a PROFINET device">;
using ReadInputs = ProfinetAccess<"BLKMOV_BIR", "read PROFINET inputs at once">;
using WriteOutputs = ProfinetAccess<"BLKMOV_BIW", "write PROFINET outputs at once">;

using EthernetGroup = Group<GetRequest, PutRequest, GetAddress, SetAddress, Connect, Send, ReceiveOn, Disconnect,
                            ReadRecord, WriteRecord, ReadInputs, WriteOutputs, GetError>;

}  // namespace rungproof::isa
