// A second interpreter, slow and plain on purpose: it is written from the manual alone, knows neither the instruction
// table nor the machine of ir/, and dispatches on the text of the mnemonic. It exists to be believed. It is linked into
// this test only; nothing else may use it.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "ir/program.hpp"

namespace rungproof::naive {

class Interpreter {
 public:
  explicit Interpreter(const Program& program);

  /// One pass of the main program. Ticks of the 10 ms and 100 ms time bases since the start of the scan before.
  void scan(int ticks10, int ticks100);

  std::map<Area, std::vector<std::uint8_t>> memory;
  std::array<std::uint32_t, 4> accumulator{};
  std::array<std::int16_t, 256> timer{}, counter{};
  std::array<bool, 256> timerBit{}, counterBit{};

 private:
  struct Element {
    const Instruction* instruction;
    std::string name;
  };
  struct TimerState {
    std::string kind;
    int preset = 0;
    bool counting = false;
    bool input = false;
  };

  void run(const Pou& pou);
  std::size_t step(const std::vector<Element>& code, std::size_t at);
  bool logic(const Instruction& i, const std::string& name);
  bool compareInstruction(const Instruction& i, const std::string& name);
  void box(const Instruction& i, const std::string& name);
  bool arithmetic(const Instruction& i, const std::string& name);
  bool realArithmetic(const Instruction& i, const std::string& name);
  bool bitwise(const Instruction& i, const std::string& name);
  bool shifts(const Instruction& i, const std::string& name);
  bool moves(const Instruction& i, const std::string& name);
  bool conversions(const Instruction& i, const std::string& name);
  bool tables(const Instruction& i, const std::string& name);
  void timerBox(const Instruction& i, const std::string& name);
  void counterBox(const Instruction& i, const std::string& name);
  void refresh(int resolution, int ticks);
  void setOrReset(const Instruction& i, bool value);
  void shiftRegister(const Instruction& i);

  bool bitAt(Area area, std::uint32_t byte, unsigned bit) const;
  void putBit(Area area, std::uint32_t byte, unsigned bit, bool value);
  bool readBit(const Operand& o);
  void writeBit(const Operand& o, bool value);
  std::uint32_t read(const Operand& o, int bytes, int element = 0);
  void write(const Operand& o, int bytes, std::uint32_t value, int element = 0);
  void status(int bit, bool value) { putBit(Area::SM, 1, static_cast<unsigned>(bit), value); }
  void push(bool value);
  bool pop();
  bool power() const { return stack_[0] && scr_; }

  const Program& program_;
  std::array<bool, 9> stack_{};
  bool scr_ = true;
  Operand segment_;
  bool eno_ = false;
  bool firstScan_ = true;
  int ticks100_ = 0;
  std::map<const Instruction*, bool> edge_;
  std::map<std::uint32_t, TimerState> timers_;
  std::map<std::uint32_t, std::pair<bool, bool>> countInputs_;
};


}  // namespace rungproof::naive
