// Plant: a program of several blocks on the machine with plain numbers, and Bench: a few statements on it. One source
// of a program of tests says what a run is: plant_run.cpp here, changed meanings in tests/mutation.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "engine/concrete.hpp"
#include "error_log.hpp"
#include "statement.hpp"

namespace rungproof::manual {

/// What a run leaves besides the store.
struct Outcome {
  std::array<bool, 9> stack{};
  bool halted = false;
  bool faulted = false;
  friend bool operator==(const Outcome&, const Outcome&) = default;
};

/// A number as an example writes it: 12, -3, 16#FF, 2#101, or a REAL with a point.
inline std::uint64_t numberOf(const std::string& text) {
  if (text.starts_with("16#")) return std::strtoull(text.c_str() + 3, nullptr, 16);
  if (text.starts_with("2#")) return std::strtoull(text.c_str() + 2, nullptr, 2);
  if (text.find_first_of(".ni") != std::string::npos)
    return std::bit_cast<std::uint32_t>(std::strtof(text.c_str(), nullptr));
  return static_cast<std::uint64_t>(std::strtoll(text.c_str(), nullptr, 10));
}

/// A block of a program. A parameter of the local table reads "IN BOOL L0.0".
struct Block {
  PouKind kind = PouKind::Main;
  int number = 0;
  std::string statements;  ///< separated by ';'
  std::vector<std::string> locals{};
};

/// Outside that counts signals and answers externals with fixed values; unknown status bits have one value of their
/// own.
struct Surroundings final : Outside {
  std::map<std::pair<External, std::uint32_t>, std::uint64_t> values;
  std::uint64_t unknownStatus = 0;
  ErrorLog errors;
  const std::vector<Hazard>& hazards() const { return errors.list(); }
  std::vector<std::pair<Signal, std::uint32_t>> signals;
  std::uint64_t external(const ExternalSite& site, int) override {
    if (const auto found = values.find({site.kind, site.index}); found != values.end()) return found->second;
    return site.kind == External::UnknownStatus ? unknownStatus : 0;
  }
  void report(Hazard hazard, const Instruction* place) override { errors.add(hazard, place); }
  void signal(Signal which, std::uint32_t index) override { signals.emplace_back(which, index); }
};

class Plant {
 public:
  explicit Plant(const std::vector<Block>& blocks, Target target = {}) {
    program_.target = target;
    for (const Block& block : blocks) addBlock(block.kind, block.number, split(block.statements, ';'), block.locals);
    begin();
  }
  explicit Plant(std::string_view mainProgram, Target target = {})
      : Plant({Block{PouKind::Main, 0, std::string(mainProgram)}}, target) {}

  ~Plant() { outside.errors.clear(); }
  Plant(Plant&&) = default;

  Concrete::Store store;
  Surroundings outside;
  Choices choices;
  std::array<bool, 9> stack{};  ///< logic stack after the last run
  bool halted = false;
  std::uint64_t freshLocal = 0;                    ///< what L memory holds on entry to a block
  std::map<std::uint32_t, int> ms{};               ///< 1 ms ticks that pass before the instruction with that number
  std::map<std::uint32_t, int> interruptBefore{};  ///< routine that runs before the instruction with that number
  std::vector<std::pair<std::uint32_t, bool>> reached;  ///< timers that came to their preset in refreshes

  /// One scan; `ten` and `hundred` ticks have passed since the last one. Hazards of earlier scans are forgotten.
  Plant& scan(int ten = 0, int hundred = 0) { return run({.ten = ten, .hundred = hundred}); }
  /// INT_0 once.
  Plant& interrupt() { return run({.isInterrupt = true}); }
  /// A scan that finds the logic stack given instead of empty.
  Plant& scanWithStack(const std::array<bool, 9>& start) { return run({.stack = start}); }
  /// Scans several times, each with one tick of 100 ms and ten of 10 ms.
  Plant& scans(int count) {
    for (int i = 0; i < count; ++i) scan(10, 1);
    return *this;
  }
  /// "VW10" or a register: "T.value[37]".
  std::uint64_t value(std::string_view name) {
    if (const auto at = registerOf(name)) return store.get(at->first, at->second);
    const Operand o = operandOf(name);
    Concrete domain(outside);
    Machine<Concrete> machine(domain, store, *plan_);
    return machine.load(o.area, o.offset, o.width, o.bit);
  }
  Plant& set(std::string_view name, std::int64_t v) {
    if (const auto at = registerOf(name)) {
      store.set(at->first, at->second, static_cast<std::uint64_t>(v), true);
      return *this;
    }
    const Operand o = operandOf(name);
    Concrete domain(outside);
    Machine<Concrete> machine(domain, store, *plan_);
    machine.save(o.area, o.offset, o.width, static_cast<std::uint64_t>(v) & Concrete::mask(bits(o.width)), o.bit);
    return *this;
  }
  void setReal(std::string_view address, float v) { set(address, std::bit_cast<std::uint32_t>(v)); }
  void setText(std::uint32_t byte, std::string_view characters) {
    for (std::size_t i = 0; i < characters.size(); ++i)
      store.area(Area::V)[byte + i] = static_cast<std::uint8_t>(characters[i]);
  }
  /// A string with its length byte.
  void setString(std::uint32_t byte, std::string_view characters) {
    store.area(Area::V)[byte] = static_cast<std::uint8_t>(characters.size());
    setText(byte + 1, characters);
  }
  /// "VW0=5 SM1.0=1" on the store.
  Plant& set(std::string_view assignments);
  /// Current value of a counter or timer, signed.
  int current(std::string_view number) const {
    const Operand o = operandOf(number);
    return static_cast<std::int16_t>(store.get(o.area == Area::T ? Reg::TimerCurrent : Reg::CounterCurrent, o.offset));
  }
  int current(std::uint32_t timer) const { return static_cast<std::int16_t>(store.get(Reg::TimerCurrent, timer)); }
  bool timerBit(std::uint32_t timer) const { return store.get(Reg::TimerBit, timer) != 0; }
  float real(std::string_view address) { return std::bit_cast<float>(static_cast<std::uint32_t>(value(address))); }
  std::string text(std::uint32_t byte, std::size_t count) const {
    const auto* start = store.area(Area::V).data() + byte;
    return std::string(start, start + count);
  }
  std::uint64_t reg(Reg reg, std::uint32_t index = 0) const { return store.get(reg, index); }
  bool eno() {
    if (store.get(Reg::Eno, 0) == 0) outside.hazards();  // the test knows of the error
    return store.get(Reg::Eno, 0) != 0;
  }
  bool errorBit() {
    if (value("SM4.3") != 0) outside.hazards();
    return value("SM4.3") != 0;
  }
  bool met(Hazard hazard) const {
    return std::find(outside.hazards().begin(), outside.hazards().end(), hazard) != outside.hazards().end();
  }
  bool quiet() const { return outside.hazards().empty(); }
  /// Lets `count` ticks of that resolution pass outside a scan.
  void refresh(int resolution, int count);
  const Program& program() const { return program_; }
  const Plan& plan() const { return *plan_; }

 protected:
  explicit Plant(Target target) { program_.target = target; }
  void addBlock(PouKind kind, int number, const std::vector<std::string>& lines,
                const std::vector<std::string>& locals = {}) {
    Pou pou;
    pou.kind = kind;
    pou.number = number;
    pou.networks.push_back({});
    for (const std::string& line : lines) pou.networks[0].instructions.push_back(statement(line));
    for (const std::string& row : locals) pou.locals.push_back(local(row));
    program_.pous.push_back(std::move(pou));
  }
  /// Memory is all 0 but SM0.0.
  void begin() {
    program_.number();
    plan_ = std::make_unique<Plan>(program_);
    store = Concrete::Store(*plan_);
    store.set(Reg::Running, 0, 1, true);
    store.area(Area::SM)[0] = 1;
  }

 private:
  friend struct PlantRun;

  /// One run of the main program or of INT_0.
  struct Run {
    int ten = 0, hundred = 0;  ///< ticks since the last run
    bool isInterrupt = false;
    std::optional<std::array<bool, 9>> stack{};  ///< the logic stack that it finds; none: as Choices say
  };
  Plant& run(const Run& run);

  static std::optional<std::pair<Reg, std::uint32_t>> registerOf(std::string_view name) {
    const std::size_t open = name.find('[');
    if (open == std::string_view::npos) return std::nullopt;
    const auto found = std::find_if(regTable.begin(), regTable.end(),
                                    [&](const RegInfo& info) { return info.name == name.substr(0, open); });
    CHECK(found != regTable.end(), std::string(name).c_str());
    return std::pair{found->reg, static_cast<std::uint32_t>(std::atoi(name.data() + open + 1))};
  }
  static LocalVariable local(const std::string& row) {
    static const std::map<std::string, VarSection> sections = {{"IN", VarSection::Input},
                                                               {"IN_OUT", VarSection::InOut},
                                                               {"OUT", VarSection::Output},
                                                               {"TEMP", VarSection::Temp}};
    static const std::map<std::string, DataType> types = {
        {"BOOL", DataType::Bool},   {"BYTE", DataType::Byte}, {"WORD", DataType::Word}, {"INT", DataType::Int},
        {"DWORD", DataType::DWord}, {"DINT", DataType::DInt}, {"REAL", DataType::Real}, {"STRING", DataType::String}};
    const std::vector<std::string> parts = split(row, ' ');
    LocalVariable variable;
    variable.section = sections.at(parts[0]);
    variable.type = types.at(parts[1]);
    variable.address = operandOf(parts[2]);
    return variable;
  }
  Program program_;
  std::unique_ptr<Plan> plan_;
};

inline Plant& Plant::set(std::string_view assignments) {
  for (const std::string& pair : split(assignments, ' ')) {
    const std::size_t equal = pair.find('=');
    set(std::string_view(pair).substr(0, equal), numberOf(pair.substr(equal + 1)));
  }
  return *this;
}

/// A main program and the body of INT_0, line by line, in front of their first scan.
struct Bench : Plant {
  explicit Bench(const std::vector<std::string>& lines, Target target = {},
                 const std::vector<std::string>& interrupt = {})
      : Plant(target) {
    addBlock(PouKind::Main, 0, lines);
    addBlock(PouKind::Interrupt, 0, interrupt);
    begin();
    store.set(Reg::FirstScan, 0, 1, true);
  }
};

}  // namespace rungproof::manual
