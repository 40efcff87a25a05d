// A naive interpreter of S7-300/400 statement lists: everything as plainly as the descriptions say it, by looking at
// the text of each statement when it is executed. It shares no line with the product and referees it.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace naive7 {

/// A statement as it is written: `m1: L MW [AR1,P#2.0]`, blanks removed from the operand.
struct Statement {
  std::string label;
  std::string op;
  std::string operand;                                       ///< "MW[AR1,P#2.0]", "FC1", ""
  std::vector<std::pair<std::string, std::string>> actuals;  ///< of CALL: formal name, operand
};

enum class Section { In, Out, InOut, Static, Temp };

struct Variable {
  std::string name;
  std::string type;  ///< "BOOL", "INT", "FB1", ...
  Section section = Section::In;
  std::uint32_t bit = 0;  ///< first bit in the instance or the local data
};

struct Block {
  std::string name;  ///< "OB1", "FC5", "FB2"
  std::vector<Variable> variables;
  std::uint32_t instanceBytes = 0;
  std::vector<Statement> statements;
  std::map<std::string, std::size_t> labels;
};

struct Program {
  std::map<std::string, Block> blocks;
  std::map<int, std::vector<std::uint8_t>> dataBlocks;  ///< with the values they are loaded with
  std::vector<std::string> errors;
};

/// Reads sources of blocks: OB, FC, FB, DB with a STRUCT of elementary types and byte arrays, instance DB.
Program readProgram(const std::string& text);

/// A place: area I, Q, M, P, D (with a block number), L (with the depth of its frame).
struct Place {
  char area = 'M';
  int number = 0;  ///< of the data block, of the frame
  std::uint32_t bit = 0;
  int width = 0;  ///< 1, 8, 16, 32
  bool isConstant = false;
  std::uint32_t value = 0;  ///< of a constant; the number of a timer or counter
};

struct Timer {
  std::string kind;  ///< SP, SE, SD, SS, SF
  bool isRunning = false, isDone = false, input = false, lastStart = false, lastFree = false;
  std::uint32_t units = 0, base = 10, rest = 0, baseCode = 0;
  std::int64_t startedAt = 0;
};

struct Counter {
  int value = 0;
  bool lastUp = false, lastDown = false, lastSet = false, lastFree = false;
};

struct Nested {
  std::string kind;
  bool rlo = false, isOr = false, first = false;
};

/// The CPU has gone to STOP: number as in OB121_SW_FLT, 0xFF for others (endless program, text that is not known).
struct Stop {
  int fault = 0xFF;
  std::string text;
};

class Machine {
 public:
  explicit Machine(const Program& program, bool isS7400);

  // The registers, as the status word names them.
  bool br = false, cc1 = false, cc0 = false, ov = false, os = false, orBit = false, sta = false, rlo = false,
       fc = false;
  std::uint32_t accu[4] = {0, 0, 0, 0};
  std::uint32_t ar[2] = {0, 0};
  int db = 0, di = 0;
  std::vector<std::uint8_t> inputs, outputs, memory, peripheralIn, peripheralOut;
  std::map<int, std::vector<std::uint8_t>> dataBlocks;
  std::map<int, Timer> timers;
  std::map<int, Counter> counters;
  std::int64_t now = 0;        ///< ms
  std::function<void()> mark;  ///< what the pseudo-statement @ does

  /// Start of a scan: time goes on and timers that have run out are seen.
  void advance(std::int64_t milliseconds);
  /// Runs a block to its end; throws Stop.
  void run(const std::string& block);
  /// Runs statements as if they stood in a block of their own that OB1 consists of.
  void runStatements(const Block& block);

  std::string statusText() const;
  void setStatus(const std::string& nine);
  bool timerBit(int number) const;
  std::uint32_t timerValue(int number) const;
  std::uint32_t read(const Place& place, int fault = 0x22) const;
  void write(const Place& place, std::uint32_t value);
  /// `DB1.DBW0`, `M0.0`, `PIW300`: a direct address.
  Place direct(const std::string& text) const;

 private:
  struct Frame {
    const Block* block = nullptr;
    std::vector<std::uint8_t> local = std::vector<std::uint8_t>(1024);
    std::map<std::string, Place> references;  ///< formal parameters of an FC
    int instance = 0;
    std::uint32_t base = 0;  ///< bit of the instance in its data block
    std::vector<Nested> nesting;
    std::vector<bool> relay;
    bool relayActive = false;
  };

  bool step(const Statement& s, std::size_t& next);  ///< false: the block ends
  void interrupt(int block);                         ///< an organization block, if its priority is the higher one
  bool bitStatement(const Statement& s);
  bool wordStatement(const Statement& s);
  bool realStatement(const Statement& s);
  bool conversion(const Statement& s);
  bool shift(const Statement& s);
  bool loadStatement(const Statement& s);
  bool timerStatement(const Statement& s);
  bool blockStatement(const Statement& s);
  bool jump(const Statement& s, std::size_t& next);
  void call(const Statement& s);
  std::vector<std::uint8_t> handedBytes(const std::string& actual, bool isAny) const;
  std::uint32_t addressOfParameter(const std::string& name) const;
  bool systemBlock(const std::string& target, const Statement& s);
  void leaveSystemBlock(bool isGood);
  void enter(const Block& block, int instance, std::uint32_t base, const std::map<std::string, Place>& references);
  void startTimer(const std::string& kind, Timer& t);

  Frame& frame() { return frames_.back(); }
  Place place(const std::string& operand) const;
  Place local(const std::string& name) const;
  Place crossing(std::uint32_t pointer, int width) const;
  std::uint32_t pointerOf(const std::string& inside) const;  ///< "MD20" or "AR1,P#2.0" in brackets
  bool operandBit(const std::string& operand);
  int objectNumber(const std::string& operand, char letter) const;  ///< T5, T[MW10], #name
  void openFor(const std::string& operand);                         ///< a full address opens its block
  bool relayOff();
  void load(std::uint32_t value);
  void popMath();
  void setMath(std::int64_t exact, std::uint32_t stored, bool overflow);
  void setReal(float result, bool isSmall, bool hasDenormal, std::uint32_t invalid);
  void endString() { orBit = false, fc = false; }

  const Program* program_;
  bool is400_;
  std::vector<Frame> frames_;
  std::int64_t steps_ = 0;
  int running_ = 1;  ///< organization block
};

/// A pointer constant: `P#DB1.DBX 4.0 INT 2`.
struct AnyText {
  int block = 0, type = 0, count = 0;
  std::uint32_t address = 0;
};
bool readAny(const std::string& text, AnyText& any);

std::uint32_t constantValue(const std::string& text);  ///< "W#16#1000", "S5T#1S", "P#M40.0", "1.5", "'ab'"
bool isConstantText(const std::string& text);
int widthOfType(const std::string& type);  ///< bits; 0 for TIMER, COUNTER and blocks

}  // namespace naive7
