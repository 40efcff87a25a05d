// What an instruction is for, in the words of those who ask: a contact, a coil, a timer, a move. Each descriptor in
// ir/s7200/isa/*.hpp names its role (Role::Other: nobody asks), and no reader looks at a spelling. Width and type are
// those of the operands: Role::Move with Type::Word is MOVW. Tested by tests/ir/role_test.cpp.
#pragma once

#include <cstdint>
#include <optional>

namespace rungproof {

enum class Role : std::uint8_t {
  Other,
  Load,
  And,
  Or,  ///< contacts and compare contacts by how they join the stack
  Not,
  Eu,
  Ed,
  Ald,
  Old,
  Lps,
  Lrd,
  Lpp,
  Lds,
  Aeno,
  Nop,
  Assign,
  Set,
  Reset,  ///< immediate forms too (Desc::immediate)
  Sr,
  Rs,
  Ton,
  Tof,
  Tonr,
  IecTimer,
  Ctu,
  Ctd,
  Ctud,
  IecCounter,
  Add,
  Sub,
  Mul,
  Div,  ///< operands and result of one type: +I, /R
  MulWide,
  DivWide,  ///< MUL, DIV: 16 bits to 32
  Increment,
  Decrement,
  Move,
  BlockMove,
  Fill,
  Shift,
  Rotate,
  Shrb,
  Att,
  Lifo,
  Fifo,
  Find,
  StringLength,
  StringCopy,
  StringAppend,
  StringPart,
  StringFind,
  StringConvert,  ///< from a string to a number
  AsciiToHex,
  HexToAscii,
  Atch,
  Dtch,
  Cevnt,
  Eni,
  Disi,
  Hdef,
  Hsc,
  Pls,
  Pid,
  Netr,
  Netw,
  Get,
  Put,  ///< by Ethernet
  Xmt,
  Rcv,
  Gpa,
  Spa,
  Todr,
  Todw,  ///< with the extended forms
  Wdr
};

/// Joins the stack with what it finds: a contact of a bit or a compare contact.
constexpr bool isContact(Role role) { return role == Role::Load || role == Role::And || role == Role::Or; }
constexpr bool isEdge(Role role) { return role == Role::Eu || role == Role::Ed; }
/// A contact, an operation on stack levels, or an edge: what may stand left of the first output of a rung.
constexpr bool isLogic(Role role) { return role >= Role::Load && role <= Role::Aeno; }
/// = and =I.
constexpr bool isCoil(Role role) { return role == Role::Assign; }
/// S and SI; R and RI.
constexpr bool isSet(Role role) { return role == Role::Set; }
constexpr bool isReset(Role role) { return role == Role::Reset; }
/// S, R and the bistables: the bit stays when their power flow has gone.
constexpr bool isLatch(Role role) {
  return role == Role::Set || role == Role::Reset || role == Role::Sr || role == Role::Rs;
}
/// TON, TOF, TONR or an IEC timer box.
constexpr bool isTimerBox(Role role) { return role >= Role::Ton && role <= Role::IecTimer; }
/// CTU, CTD, CTUD or an IEC counter box.
constexpr bool isCounterBox(Role role) { return role >= Role::Ctu && role <= Role::IecCounter; }

/// The role that does the contrary under the same power flow: S and R, SR and RS, EU and ED, TON and TOF.
constexpr std::optional<Role> oppositeOf(Role role) {
  switch (role) {
    case Role::Set: return Role::Reset;
    case Role::Reset: return Role::Set;
    case Role::Sr: return Role::Rs;
    case Role::Rs: return Role::Sr;
    case Role::Eu: return Role::Ed;
    case Role::Ed: return Role::Eu;
    case Role::Ton: return Role::Tof;
    case Role::Tof: return Role::Ton;
    default: return std::nullopt;
  }
}

/// How a compare contact or a table search relates its two values.
enum class Relation : std::uint8_t { None, Less, LessEqual, Equal, GreaterEqual, Greater, NotEqual };

}  // namespace rungproof
