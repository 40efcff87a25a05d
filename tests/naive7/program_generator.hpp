// Random S7-300/400 programs as sources of blocks: all statements, nesting, jumps, loops, pointers, data blocks, calls
// of FCs and FBs, timers and counters. They are legal; a few stop the CPU on purpose.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace naive7 {

struct GeneratorChoices {
  bool is400 = false;
  bool functions = false;  ///< trigonometry, EXP and LN too, whose last bit the description leaves open
  bool errors = true;      ///< now and then a statement that stops the CPU
  bool timers = true;
  bool overlappingModules = true;  ///< PIW 256, PIW 257, PIB 258 ...: otherwise each byte of PI is read by one name
  int snippets = 12;               ///< of OB1
  /// OB35 and OB40 too; where a run of the text has an interrupt, BLD 235 and BLD 240 stand.
  bool interrupts = false;
};

class ProgramGenerator {
 public:
  ProgramGenerator(std::uint64_t seed, const GeneratorChoices& choices) : engine_(seed), choices_(choices) {}

  /// DB1 (100 bytes), DB2 (20), DB3, DB4 and DB5 (instances), FB1 to FB3, FC1 to FC6, OB1, now and then OB35 and OB40;
  /// one statement a line.
  std::string program();

  /// 0 .. limit - 1.
  std::uint32_t below(std::uint32_t limit) { return static_cast<std::uint32_t>(engine_() % limit); }
  bool chance(std::uint32_t percent) { return below(100) < percent; }

 private:
  struct Locals {
    std::vector<std::string> bits, words, doubles;
  };

  std::string pick(const std::vector<std::string>& list) {
    return list[below(static_cast<std::uint32_t>(list.size()))];
  }
  std::string number(std::uint32_t limit) { return std::to_string(below(limit)); }
  void say(const std::string& statement) { text_ += "  " + statement + " ;\n"; }
  std::string newLabel();

  std::string bit(bool isWritten);
  std::string byteOperand(bool isWritten);
  std::string word(bool isWritten);
  std::string doubleWord(bool isWritten);
  std::string wordConstant();
  std::string doubleConstant();
  std::string realConstant();
  std::string statusBit();
  void loadAny();
  void scan();
  void logicString();
  void group(int depth);
  void math();
  void comparison();
  void shiftOrConversion();
  void realMath();
  void jump();
  void distributor();
  void loop();
  void timerOrCounter();
  void pointers();
  void dataBlocks();
  void accumulators();
  void status();
  void relay();
  void calls();
  void pointerCalls(std::uint32_t kind);
  void registersAgain();
  void error();
  void snippet(int depth);
  void body(int count);
  std::string fc1();
  std::string fc2();
  std::string fc3();
  std::string fc4();
  std::string fc5();
  std::string fc6();
  std::string fb1();
  std::string fb2();
  std::string fb3();
  void ownRegisters();
  std::string ob1();
  std::string interruptBlock(int number);
  std::string interrupted(const std::string& source, const std::vector<std::string>& marks);

  std::mt19937_64 engine_;
  GeneratorChoices choices_;
  Locals locals_;
  std::string text_;
  int labels_ = 0, depth_ = 0, loops_ = 0;
  bool isOb1_ = false, mayCall_ = false;
};

}  // namespace naive7
