// A second interpreter, slow and plain on purpose: it is written from the manual alone, knows neither the instruction
// table nor the machine of ir/, and dispatches on the text of the mnemonic. It exists to be believed. It is linked into
// tests only; nothing else may use it. Where the manual is silent it follows the defaults of ir/machine/choices.hpp.
// Left out: the devices (HDEF, HSC, PLS, XMT, RCV, NETR, NETW) and interrupt routines that run.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "ir/program.hpp"

namespace rungproof::naive {

/// What the operands of a mnemonic are, one letter each: b w d r read a byte, word, double word or REAL, capitals write
/// one; x X bits; p q m buffers of bytes, words, double words; t a table at TL, f one at EC; s a string or a string
/// constant, S a string in memory; k a number of the text. Empty for mnemonics without operands and for those whose
/// operands are not values (LBL). Nothing: the naive interpreter does not know the mnemonic.
std::optional<std::string_view> signatureOf(const std::string& mnemonic);

class Interpreter {
 public:
  explicit Interpreter(const Program& program);

  /// One pass of the main program. Ticks of the 10 ms and 100 ms time bases since the start of the scan before.
  void scan(int ticks10, int ticks100);
  /// Lets ticks of 1 ms pass for the 1 ms timers.
  void pass(int ticks) { refresh(1, ticks); }

  std::map<Area, std::vector<std::uint8_t>> memory;
  std::array<std::uint32_t, 4> accumulator{};
  std::array<std::uint32_t, 6> highSpeed{};  ///< HC0 to HC5
  std::array<std::int16_t, 256> timer{}, counter{};
  std::array<bool, 256> timerBit{}, counterBit{};
  std::array<bool, 9> stack{};
  bool eno = false;
  bool firstScan = true;
  bool stopped = false;  ///< STOP or a fatal error has ended the program
  std::array<bool, 8> pidHistory{};

  // The world outside.
  std::array<std::uint8_t, 16> inputs{}, outputs{};  ///< terminals
  std::array<std::uint8_t, 19> clock{};              ///< what TODR and TODRX read
  std::uint32_t milliseconds = 0;                    ///< what BITIM reads
  std::array<std::uint8_t, 2> stationAddress{};      ///< of the system block, or what SPA has set
  std::array<int, 34> routine{};                     ///< by event: 0, or the number of the attached routine + 1
  std::vector<std::uint8_t> clockSetting;            ///< what TODW or TODWX has set
  std::vector<std::string> told;                     ///< "attach 3", "detach 3", "clear 3", "watchdog", "stop"
  std::vector<std::string> errors;                   ///< codes of Table C-2, or the status bit of an error without code
  std::set<std::uint32_t> expired;                   ///< 1 and 10 ms timers that came to their preset in updates
  bool diagnosticLed = false;

  std::map<std::string, std::uint64_t> executed;  ///< boxes: with power flow only

  /// Value of an operand of the instruction that ran last, its pointers followed; element: so many widths further on.
  std::uint32_t read(const Operand& o, int bytes, int element = 0);
  void write(const Operand& o, int bytes, std::uint32_t value, int element = 0);

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
  /// Where an operand stands once its pointer has been followed.
  struct Place {
    Area area = Area::V;
    std::uint32_t offset = 0;
  };

  void run(const Pou& pou);
  std::size_t step(const std::vector<Element>& code, std::size_t at);
  std::size_t loop(const std::vector<Element>& code, std::size_t at);
  bool logic(const Instruction& i, const std::string& name);
  bool compareInstruction(const Instruction& i, const std::string& name);
  bool compareStrings(const Instruction& i, bool& equal);
  void joinResult(const std::string& joint, bool holds);
  bool bistable(const Instruction& i, const std::string& name);
  void box(const Instruction& i, const std::string& name);
  bool smartArithmetic(const Instruction& i, const std::string& name);
  bool arithmetic(const Instruction& i, const std::string& name);
  bool divide(const Instruction& i, const std::string& name);
  bool realArithmetic(const Instruction& i, const std::string& name);
  bool realFunction(const Instruction& i, const std::string& name);
  void storeReal(const Operand& to, float result, bool bad);
  bool bitwise(const Instruction& i, const std::string& name);
  bool shifts(const Instruction& i, const std::string& name);
  bool moves(const Instruction& i, const std::string& name);
  bool conversions(const Instruction& i, const std::string& name);
  bool tables(const Instruction& i, const std::string& name);
  bool strings(const Instruction& i, const std::string& name);
  bool findInString(const Instruction& i, const std::string& name);
  bool digits(const Instruction& i, const std::string& name);
  bool numberToText(const Instruction& i, const std::string& name);
  bool textToNumber(const Instruction& i, const std::string& name);
  bool clockBox(const Instruction& i, const std::string& name);
  bool immediateMove(const Instruction& i, const std::string& name);
  bool interrupts(const Instruction& i, const std::string& name);
  bool ports(const Instruction& i, const std::string& name);
  void pid(const Instruction& i);
  void timerBox(const Instruction& i, const std::string& name);
  void counterBox(const Instruction& i, const std::string& name);
  void iecCounter(const Instruction& i, const std::string& name);
  void refresh(int resolution, int ticks);
  void setOrReset(const Instruction& i, bool value, bool immediate);
  void shiftRegister(const Instruction& i);
  bool fail(std::string_view code);
  bool fatal(std::string_view code);

  bool follow(const Instruction& i, std::string_view signature);
  Place placeOf(const Operand& o) const;
  /// Whether `count` elements from the operand on are inside its area.
  bool fits(const Operand& o, int count, int bytes) const;
  /// A string operand with its length byte; nothing if it is too long or leaves its area.
  std::optional<std::string> stringAt(const Operand& o);
  bool bitAt(Area area, std::uint32_t byte, unsigned bit) const;
  void putBit(Area area, std::uint32_t byte, unsigned bit, bool value);
  bool readBit(const Operand& o);
  void writeBit(const Operand& o, bool value);
  void status(int bit, bool value) { putBit(Area::SM, 1, static_cast<unsigned>(bit), value); }
  void push(bool value);
  bool pop();
  bool power() const { return stack[0] && scr_; }

  const Program& program_;
  bool scr_ = true;
  Operand segment_;
  int ticks100_ = 0;
  std::map<const Instruction*, bool> edge_;
  std::map<std::uint32_t, TimerState> timers_;
  std::map<std::uint32_t, std::pair<bool, bool>> countInputs_;
  std::map<const Operand*, Place> followed_;
};

}  // namespace rungproof::naive
