// Which instructions the static analyses treat on their own, as an enumeration looked up by opcode: comparing
// mnemonics in every rule would be slow and would scatter the spellings. Everything not named here is Kind::Other
// and is known through its descriptor alone. Tested by tests/rules/facts_test.cpp.
#pragma once

#include <cstdint>

#include "ir/desc.hpp"
#include "ir/program.hpp"

namespace rungproof {

enum class Kind : std::uint8_t {
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
  Assign,
  AssignImmediate,
  Set,
  Reset,
  SetImmediate,
  ResetImmediate,
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
  Mul,
  Div,
  DivInt,
  DivDInt,
  DivReal,
  MoveByte,
  MoveWord,
  MoveDWord,
  MoveReal,
  BlockByte,
  BlockWord,
  BlockDWord,
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
  StringConvert,
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
  Xmt,
  Rcv,
  Gpa,
  Spa,
  Todr,
  Todw,
  IncDWord,
  DecDWord,
  AddDInt,
  SubDInt,
  AddInt,
  SubInt,
  Wdr
};

/// Kind of an instruction; a table look-up by opcode.
Kind kindOf(const Desc& desc);
inline Kind kindOf(const Instruction& instruction) { return kindOf(*instruction.desc); }

/// TON, TOF, TONR or an IEC timer box.
bool isTimerBox(Kind kind);
/// CTU, CTD, CTUD or an IEC counter box.
bool isCounterBox(Kind kind);
/// = and =I.
inline bool isCoil(Kind kind) { return kind == Kind::Assign || kind == Kind::AssignImmediate; }
inline bool isSet(Kind kind) { return kind == Kind::Set || kind == Kind::SetImmediate; }
inline bool isReset(Kind kind) { return kind == Kind::Reset || kind == Kind::ResetImmediate; }
/// A contact, an operation on stack levels, or an edge: what may stand left of the first output of a rung.
bool isLogic(Kind kind);

}  // namespace rungproof
