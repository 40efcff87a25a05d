// Code: the program's part of a scan as a list of steps over values, recorded from the instructions' meanings
// (engine/compiled/recorder.hpp) and translated to machine code (engine/compiled/emitter.hpp). A step makes a value,
// touches memory or branches; a value is known by the index of its step. Truth values are bytes of eight equal bits, so
// that a bit of memory joins them without conversion.
#pragma once

#include <cstdint>
#include <vector>

#include "ir/area.hpp"
#include "ir/hazard.hpp"
#include "ir/program.hpp"

namespace rungproof::compiled {

using ValueId = std::uint32_t;

enum class CodeOp : std::uint8_t {
  // Truth values.
  False,
  True,
  And,
  Or,
  Xor,
  Not,
  SelectBit,  // a ? b : c
  TestBit,    // bit `value` of a
  Equal,
  Less,          // unsigned
  LessSigned,    // both operands have `width` bits
  AddOverflows,  // a + b as numbers with sign of `width` bits, 16 or 32
  SubOverflows,
  RealEqual,
  RealLess,
  RealLegal,
  LoadBit,    // slot `value`
  LoadState,  // truth value `value` of those that the walk keeps, at the beginning of a block
  // Words of `width` bits, the bits above are 0.
  Constant,
  FromBit,
  Add,
  Sub,
  Mul,
  DivideUnsigned,
  RemainderUnsigned,
  DivideSigned,
  RemainderSigned,
  BitAnd,
  BitOr,
  BitXor,
  BitNot,
  ShiftLeft,
  ShiftRight,
  Select,   // a ? b : c
  Signed,   // a of `value` bits, its sign continued
  Extract,  // `width` bits of a from bit `value`
  Join,     // a above the `value` bits of b
  RealAdd,
  RealSub,
  RealMul,
  RealDiv,
  RealFunction,  // `value`: which
  RealFromInt,
  RealToInt,      // `value` 1: rounded
  LoadMemory,     // `width` bits from byte `value` of `area`
  LoadSlots,      // the byte whose first slot is `value`
  LoadRegister,   // `value`: index among all registers
  LoadTicks,      // of this scan, `value`: of 100 ms; where Code::isWholeScan, 1: of 10 ms, 2: of 1 ms
  LoadAt,         // `width` bits from byte a + `value` of `area`
  LoadStateWord,  // word `value` of those that the walk keeps, at the beginning of a block
  // Steps without a value.
  StoreBit,        // a to slot `value`
  StoreState,      // a to truth value `value` of the walk
  StoreStateWord,  // a to word `value` of the walk
  StoreMemory,     // a to byte `value` of `area`
  StoreSlots,      // byte a to eight slots from `value` on
  StoreRegister,   // a to register `value`
  StoreAt,         // b to byte a + `value` of `area`
  Leave,           // where a holds, the scan is one for the reference engine
  Count,           // where a holds, error `value` of Code::sites has happened
  Mark,            // a block begins: branches to `value` come here
  Branch,          // to `value`
  BranchIf,        // to `value` where a holds
  BranchUnless,
  AddTime,    // `value`, 10 ns
  AddTimeIf,  // `value` more where a holds
  CheckTime   // a scan that has lasted too long is one for the reference engine
};

constexpr bool isTruth(CodeOp op) { return op <= CodeOp::LoadState; }
/// Whether one comparison of integers makes it.
constexpr bool isComparison(CodeOp op) {
  return op == CodeOp::TestBit || op == CodeOp::Equal || op == CodeOp::Less || op == CodeOp::LessSigned ||
         op == CodeOp::AddOverflows || op == CodeOp::SubOverflows;
}
constexpr bool hasValue(CodeOp op) { return op < CodeOp::StoreBit; }
constexpr bool isBranch(CodeOp op) {
  return op == CodeOp::Branch || op == CodeOp::BranchIf || op == CodeOp::BranchUnless;
}

struct Step {
  CodeOp op;
  std::uint8_t width = 0;
  Area area = Area::V;
  ValueId a = 0, b = 0, c = 0;
  std::uint64_t value = 0;
};

/// How many of a, b and c are values.
constexpr int operandCount(CodeOp op) {
  switch (op) {
    case CodeOp::False:
    case CodeOp::True:
    case CodeOp::LoadBit:
    case CodeOp::LoadState:
    case CodeOp::Constant:
    case CodeOp::LoadMemory:
    case CodeOp::LoadSlots:
    case CodeOp::LoadRegister:
    case CodeOp::LoadTicks:
    case CodeOp::LoadStateWord:
    case CodeOp::Mark:
    case CodeOp::Branch:
    case CodeOp::AddTime:
    case CodeOp::CheckTime: return 0;
    case CodeOp::SelectBit:
    case CodeOp::Select: return 3;
    case CodeOp::Not:
    case CodeOp::TestBit:
    case CodeOp::RealLegal:
    case CodeOp::FromBit:
    case CodeOp::BitNot:
    case CodeOp::Signed:
    case CodeOp::Extract:
    case CodeOp::RealFunction:
    case CodeOp::RealFromInt:
    case CodeOp::RealToInt:
    case CodeOp::LoadAt:
    case CodeOp::StoreBit:
    case CodeOp::StoreState:
    case CodeOp::StoreStateWord:
    case CodeOp::StoreMemory:
    case CodeOp::StoreSlots:
    case CodeOp::StoreRegister:
    case CodeOp::Leave:
    case CodeOp::Count:
    case CodeOp::BranchIf:
    case CodeOp::BranchUnless:
    case CodeOp::AddTimeIf: return 1;
    default: return 2;
  }
}

/// An error that can be reported at an instruction.
struct ErrorSite {
  Hazard hazard;
  const Instruction* place;
};

/// Bytes of memory of which every bit has a byte of its own while the compiled program runs.
struct SlotByte {
  Area area;
  std::uint32_t byte;
  friend bool operator==(const SlotByte&, const SlotByte&) = default;
  friend auto operator<=>(const SlotByte&, const SlotByte&) = default;
};

/// Bytes that computed addresses reach: places of memory as the state keeps it.
struct Reached {
  Area area;
  std::uint32_t first, count;
  bool isWritten;
  friend bool operator==(const Reached&, const Reached&) = default;
};

struct Code {
  std::vector<Step> steps;
  std::vector<SlotByte> slots;  ///< slots 8 * i to 8 * i + 7 are the bits of slots[i]
  std::vector<ErrorSite> sites;
  std::vector<Reached> reached;
  std::uint32_t marks = 0;       ///< numbers of blocks that are in use
  std::uint32_t states = 0;      ///< values that the walk keeps from block to block
  std::uint64_t mostTime = 0;    ///< of one pass without loops, 10 ns
  bool hasLoops = false;         ///< or other ways back
  bool countsTime = false;       ///< AddTime and AddTimeIf are there
  bool hasTerminals = true;      ///< PI and PQ are the terminals and no areas of the program
  bool asksOutside = false;      ///< terminals or analog inputs are read
  bool expectsAlwaysOn = false;  ///< SM0.0 is on, and stays on
  bool takesFree = false;        ///< what an S7-300/400 leaves open is read, as 0
  bool isWholeScan = false;      ///< with timers around the program; the first scan is one like others
  bool isStraight = false;       ///< no branches: what is to be left is left at the end, without a branch either
};

}  // namespace rungproof::compiled
