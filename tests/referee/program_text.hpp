// The referee's own reading of a program: the lines of an export text become instructions with operands. It knows only
// the instructions that the referee runs, shares no code with the product, and refuses everything else.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace rungproof::referee {

enum class Area : std::uint8_t { None, Number, Routine, I, Q, M, V, S, SM, AI, T, C, HC, AC };

/// An operand as written: I0.0, VB100, T33, 16#1F, INT_0.
struct Operand {
  Area area = Area::None;
  int bytes = 0;           ///< 1, 2 or 4; 0 for a bit, a timer, a counter, an accumulator
  int offset = 0;          ///< byte offset, or the number of a timer, counter, accumulator, routine
  int bit = -1;            ///< 0 to 7, or -1
  std::int64_t value = 0;  ///< of a Number; the bit pattern of a REAL constant
};
Operand operandOf(const std::string& text);

enum class Joint : std::uint8_t { Load, And, Or };
enum class Relation : std::uint8_t { Equal, NotEqual, Less, LessEqual, Greater, GreaterEqual };
enum class Op : std::uint8_t {
  Contact,
  Compare,
  Not,
  EdgeUp,
  EdgeDown,
  Assign,
  Set,
  Reset,
  Move,
  Increment,
  Decrement,
  AddInteger,
  AndLoad,
  OrLoad,
  Push,
  Top,
  Pop,
  CountUp,
  CountDown,
  CountUpDown,
  OnDelay,
  RetentiveOnDelay,
  OffDelay,
  Attach,
  Detach,
  ClearEvents,
  Enable,
  Disable,
  ReturnFromInterrupt,
  Receive,
  Transmit,
  NetRead,
  NetWrite,
  DefineCounter,
  HighSpeed,
  PulseOutput,
  ReadClock,
  End,
  Stop,
  Call,
  ReturnIf,
  Nop
};

struct Instruction {
  Op op = Op::Nop;
  Joint joint = Joint::Load;
  Relation relation = Relation::Equal;
  bool negated = false;
  bool immediate = false;
  char width = 'B';  ///< B, W, D or R of a comparison, a move, INC, DEC
  Operand a, b;
  int edge = -1;  ///< which EU, ED or counter of the program this is
  std::string text;
};

/// Where an instruction stands in the text, so that the text can be made smaller.
struct Program {
  std::vector<Instruction> main;
  std::map<int, std::vector<Instruction>> interrupts, subroutines;
  std::vector<std::string> properties;  ///< the lines behind //@
  int edges = 0;
  std::vector<int> pool;  ///< small numbers that the text compares with: what devices should bring
};

/// Throws std::invalid_argument for an instruction or operand that the referee does not know.
Program programOf(const std::string& text);

}  // namespace rungproof::referee
