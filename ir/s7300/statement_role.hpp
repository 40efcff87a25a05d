// What an instruction of the S7-300/400 is for, in the words of those who follow a block statement by statement: which
// ones join the RLO, which use it, which move registers. The meanings stand in ir/s7300/isa; here only their kinds.
// Tested by tests/ir/step7_role_test.cpp.
#pragma once

#include <cstdint>
#include <optional>

#include "ir/program.hpp"

namespace rungproof {

enum class StatementRole : std::uint8_t {
  Other,
  AndScan,
  OrScan,
  XorScan,   ///< A, O, X and their negations, with an operand
  OrOfAnds,  ///< O without operand
  Open,
  Close,             ///< A( and its kind; )
  Edge,              ///< FP, FN
  Compare,           ///< ==I and its kind: a new RLO
  CompareRealEqual,  ///< ==R, <>R: the same
  Negate,
  SetRlo,
  ClearRlo,
  Save,    ///< RLO into BR
  Assign,  ///< =
  Latch,   ///< S and R of a bit
  StartTimer,
  ResetTimer,
  FreeTimer,
  CountUp,
  CountDown,
  SetCounter,
  ResetCounter,
  FreeCounter,
  JumpAlways,
  JumpByRlo,       ///< JC, JCN
  JumpKeepingRlo,  ///< JCB, JNB: RLO into BR
  JumpByBr,
  JumpByResult,  ///< by OV, OS, CC1 and CC0
  Loop,
  Distributor,
  End,  ///< BE, BEU
  EndByRlo,
  Call,  ///< CALL, UC
  CallByRlo,
  OpenRelay,   ///< MCR(
  CloseRelay,  ///< )MCR
  Relay,       ///< MCRA, MCRD
  Load,
  Transfer,
  TransferStatus,
  LoadAr1,
  LoadAr2,
  StoreAr1,
  StoreAr2,
  Ar2ToAr1,
  Ar1ToAr2,
  ExchangeAr,
  MoveAr1,
  MoveAr2,  ///< +AR1, +AR2
  OpenBlock,
  ExchangeBlocks,
  FromBcd,
  IntegerMath,  ///< ACCU2 with ACCU1: a binary number
  IntegerStep,  ///< ACCU1 with a constant: the same
  RealMath,     ///< ACCU2 with ACCU1
  MoveAccus,    ///< TAK, PUSH, POP, ENT, LEAVE
  Nothing       ///< NOP, BLD
};

constexpr bool isComparison(StatementRole role) {
  return role == StatementRole::Compare || role == StatementRole::CompareRealEqual;
}
/// Other for what no one asks about, and for every instruction of another family.
StatementRole statementRole(const Instruction& instruction);
/// How a scan or an opening parenthesis joins what stands before it: AndScan, OrScan or XorScan.
struct ScanJoin {
  StatementRole role = StatementRole::AndScan;
  bool negated = false;
};
ScanJoin scanJoin(const Instruction& instruction);
/// The bits of ACCU1 that are all 0 where a division has no quotient: 16 of /I, 32 of /D and MOD, all but the sign of
/// /R.
std::optional<std::uint32_t> divisorBits(const Instruction& instruction);
/// What an integer multiplication leaves in ACCU1: *I all of the product, *D its low half.
enum class Product : std::uint8_t { Whole, LowHalf };
std::optional<Product> productOf(const Instruction& instruction);
/// ==I, <>I, ==D, <>D.
bool comparesForEquality(const Instruction& instruction);
/// L and LC of a timer or counter.
bool loadsElement(const Instruction& instruction);
/// L STW.
bool loadsStatus(const Instruction& instruction);
/// L DBNO, L DINO, L DBLG, L DILG.
bool loadsBlockFact(const Instruction& instruction);
/// L DINO.
bool loadsInstanceNumber(const Instruction& instruction);
/// SET, for a place where a logic string shall begin anew.
const Desc* setRloStatement();
/// JO, JOS, and scans of OV and OS.
bool asksOverflow(const Instruction& instruction);
/// Whether it starts, moves, sets or resets a timer or counter by its RLO, and so ends the logic string.
constexpr bool drivesElement(StatementRole role) {
  switch (role) {
    case StatementRole::StartTimer:
    case StatementRole::ResetTimer:
    case StatementRole::FreeTimer:
    case StatementRole::CountUp:
    case StatementRole::CountDown:
    case StatementRole::SetCounter:
    case StatementRole::ResetCounter:
    case StatementRole::FreeCounter: return true;
    default: return false;
  }
}
/// =, S and R of a bit: they end the logic string too.
/// The master control relay: MCR(, )MCR, MCRA, MCRD.
constexpr bool isOfRelay(StatementRole role) {
  return role == StatementRole::OpenRelay || role == StatementRole::CloseRelay || role == StatementRole::Relay;
}
constexpr bool drivesBit(StatementRole role) { return role == StatementRole::Assign || role == StatementRole::Latch; }
/// Whether it leaves all accumulators alone and the next statement of the text runs behind it.
constexpr bool keepsAccus(StatementRole role) {
  switch (role) {
    case StatementRole::AndScan:
    case StatementRole::OrScan:
    case StatementRole::XorScan:
    case StatementRole::OrOfAnds:
    case StatementRole::Open:
    case StatementRole::Close:
    case StatementRole::Edge:
    case StatementRole::Negate:
    case StatementRole::SetRlo:
    case StatementRole::ClearRlo:
    case StatementRole::Save:
    case StatementRole::Transfer:
    case StatementRole::Nothing: return true;
    default: return drivesElement(role) || drivesBit(role);
  }
}
/// Whether it starts a timer, or moves or sets a counter, when its RLO rises or falls.
constexpr bool remembersRlo(StatementRole role) {
  return role == StatementRole::StartTimer || role == StatementRole::CountUp || role == StatementRole::CountDown ||
         role == StatementRole::SetCounter;
}

}  // namespace rungproof
