// What the S7-200 SMART adds for its networks: GET and PUT between CPUs, open communication (TCON TSEND TRECV TDCON),
// the CPU's address (GIP SIP), PROFINET (BLKMOV_BIR BLKMOV_BIW RDREC WRREC), and GERR. A request goes on after its
// instruction: its table's first byte, and for those that read a buffer named by a pointer in the table, change later
// and from outside. Such networks are left out (Desc::modelling). Tests: tests/smart.
#pragma once

#include "ir/s7200/error_codes.hpp"
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

/// GET and PUT. The table: 0 status, 1-4 address of the partner, 5-6 zero, 7-10 pointer to its data, 11 length, 12-15
/// pointer to the own data.
inline constexpr int requestTableBytes = 16;
template <Role role, Modelling modelling, Name stlName, Name meaning>
struct Request : InScan {
  static constexpr OperandDesc table =
      inout("TABLE", Type::Byte, ethernetTable).elements(requestTableBytes, requestTableBytes);
  static constexpr Desc desc = [] {
    Desc d = ethernetDesc(stlName.view(), {}, meaning.view(), modelling, {table});
    d.role = role;
    return d;
  }();
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

using GetRequest = Request<Role::Get, Modelling::WritesAnything, "GET", "read from another CPU by Ethernet">;
using PutRequest = Request<Role::Put, Modelling::WritesOperands, "PUT", "write to another CPU by Ethernet">;
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
