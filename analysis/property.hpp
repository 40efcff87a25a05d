// Properties: what an engineer states about a program (assume, prove, reach and the environment
// lines). An expression is a small tree over addresses and constants; functions that look back in time own cells
// that monitor.hpp carries from scan end to scan end. Read by frontend/property/property_reader, tested by
// tests/property.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ir/operand.hpp"

namespace rungproof {

enum class ExprOp : std::uint8_t {
  Constant,  ///< value; a truth value, a number or a REAL pattern by type
  Address,   ///< operand; its type decides how it is read
  Not,
  And,
  Or,
  Xor,
  Implies,
  Equal,
  NotEqual,
  Less,
  LessEqual,
  Greater,
  GreaterEqual,
  Add,
  Sub,
  Mul,
  Negate,
  Rises,
  Falls,
  Prev,
  Once,   // one argument
  Since,  // a, b: b has been true and a ever since
  Held,   // e for `milliseconds`
  FirstScan
};
inline constexpr std::size_t exprOpCount = static_cast<std::size_t>(ExprOp::FirstScan) + 1;

enum class ExprType : std::uint8_t { Truth, Number, Real };

/// The cell of an operator that carries nothing from scan end to scan end.
inline constexpr std::uint32_t noCell = 0xFFFFFFFF;

/// One node of an expression; `args` are indices in the same Expr::nodes, smaller than their own.
struct ExprNode {
  ExprOp op = ExprOp::Constant;
  ExprType type = ExprType::Truth;
  std::uint8_t width = 1;  ///< Truth: 1; Real: 32; Number: bits of the signed value
  std::int64_t value = 0;
  Operand operand{};              ///< Address
  bool isWhole = false;           ///< Address: a whole number beside a REAL too
  std::int64_t milliseconds = 0;  ///< Held
  std::vector<std::uint32_t> args{};
  std::uint32_t cell = noCell;  ///< first monitor cell of a function that looks back
  Span span{};
};

/// A tree in one row; the root is the last node.
struct Expr {
  std::vector<ExprNode> nodes;
  std::string text;     ///< as written
  std::string premise;  ///< of an implication: its left side as written

  const ExprNode& root() const { return nodes.back(); }
  bool empty() const { return nodes.empty(); }
};

enum class PropertyKind : std::uint8_t {
  Assume,        ///< first
  Always,        ///< first
  Never,         ///< first
  LeadsToScans,  ///< first leads to second within `bound` scans
  LeadsToTime,   ///< ... within `bound` ms
  OnlyAfter,     ///< first only after second
  Unless,        ///< first unless second
  HeldImplies,   ///< first held `bound` ms implies second
  Reach,         ///< first
  Pulse          ///< first (an address) rises at most every `bound` ms
};

/// A bit of memory that a property carries from one scan end to the next; 0 before the first scan.
struct MonitorCell {
  std::string name;
  std::uint8_t width;
};

struct Property {
  std::string name;
  PropertyKind kind = PropertyKind::Always;
  Expr first;
  Expr second;
  std::int64_t bound = 0;  ///< scans or ms
  bool atEveryInstruction = false;
  std::vector<MonitorCell> cells;  ///< of the expressions and of the pattern itself; filled by layoutCells()
  std::uint32_t patternCell = 0;   ///< first cell of the pattern
  /// Unit in which its clocks count, 1, 10 or 100 ms: with that of the program's timers they run in step with them.
  /// What the property means does not depend on it.
  int timeBase = 1;
  Span span{};
  std::string text;                  ///< the statement as written
  std::vector<std::string> remarks;  ///< what its author may not have meant, for the report

  bool isGoal() const { return kind != PropertyKind::Assume && kind != PropertyKind::Pulse; }
};

/// `external VB100..VB199`: written by a panel or network, any value in any scan.
struct ExternalRange {
  Operand first;
  Operand last;
  Span span{};              ///< of its declaration; empty: a setting
  bool isPanelTag = false;  ///< a row of a panel's tag list
};

/// A statement that could not be read, or a file of statements, and may say something about the world around the
/// program: an assumption, external memory, the start. What it would have changed is not known, so nothing is settled.
struct UnreadStatement {
  std::string text;
  Span span{};
};

/// Everything that the directives of a program and its property files say.
struct PropertySet {
  std::vector<UnreadStatement> unread;
  std::vector<Property> properties;  ///< assumptions and pulses as well as goals, in the order of the text
  std::vector<ExternalRange> externals;
  std::vector<Operand> resetDominant;  ///< bits whose set and reset in one scan are meant to end off
  bool initialRetentive = false;
};

/// Gives each function that looks back, and the pattern, its cells. Call after parsing and after a change of timeBase.
void layoutCells(Property& property);
/// Whether it measures time.
bool hasClock(const Property& property);
/// Ticks at which a clock that tells whether `milliseconds` have passed stops (monitor.hpp).
constexpr std::int64_t clockCap(std::int64_t milliseconds, int timeBase) {
  return milliseconds / timeBase + (timeBase == 1 ? 0 : 2);
}
/// Bits needed to hold 0 .. highest.
int bitsFor(std::uint64_t highest);
/// Bits of the number that an address stands for; T and C: of the current value.
int numberBits(const Operand& operand);
/// All addresses that the property reads.
std::vector<const Operand*> addressesOf(const Property& property);

}  // namespace rungproof
