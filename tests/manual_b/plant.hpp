// Plant: a program of several blocks on the machine with plain numbers, and check(): one example of the manual as
// three short texts. Statements are spelled as in tests/manual_a/bench.hpp; as there, one source of a program of tests
// says what a scan is: plant_run.cpp here, changed meanings in tests/mutation.
#pragma once

#include <gtest/gtest.h>

#include <cctype>
#include <cstdlib>

#include "tests/manual_a/bench.hpp"

namespace rungproof::manual {

inline std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> parts;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(separator), text.size());
    std::string_view part = text.substr(0, end);
    while (!part.empty() && part.front() == ' ') part.remove_prefix(1);
    while (!part.empty() && part.back() == ' ') part.remove_suffix(1);
    if (!part.empty()) parts.emplace_back(part);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return parts;
}

/// A block of a program. A parameter of the local table reads "IN BOOL L0.0".
struct Block {
  PouKind kind = PouKind::Main;
  int number = 0;
  std::string statements;  ///< separated by ';'
  std::vector<std::string> locals{};
};

/// Outside that counts signals and answers externals with fixed values; unknown status bits have a value of their own.
struct Surroundings final : Outside {
  std::map<std::pair<External, std::uint32_t>, std::uint64_t> values;
  std::uint64_t unknownStatus = 0;
  ErrorLog errors;
  const std::vector<Hazard>& hazards() const { return errors.list(); }
  std::vector<std::pair<Signal, std::uint32_t>> signals;
  std::uint64_t external(const ExternalSite& site, int) override {
    if (site.kind == External::UnknownStatus) return unknownStatus;
    const auto found = values.find({site.kind, site.index});
    return found == values.end() ? 0 : found->second;
  }
  void report(Hazard hazard, const Instruction* place) override { errors.add(hazard, place); }
  void signal(Signal which, std::uint32_t index) override { signals.emplace_back(which, index); }
};

class Plant {
 public:
  explicit Plant(const std::vector<Block>& blocks, Target target = {}) {
    program_.target = target;
    for (const Block& block : blocks) add(block);
    program_.number();
    plan_ = std::make_unique<Plan>(program_);
    store = Concrete::Store(target, plan_->edgeCount);
    store.set(Reg::Running, 0, 1, true);
    store.area(Area::SM)[0] = 1;  // SM0.0
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

  /// One scan; `ten` and `hundred` ticks have passed since the last one.
  Plant& scan(int ten = 0, int hundred = 0);
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
  Plant& set(std::string_view name, std::uint64_t v) {
    if (const auto at = registerOf(name)) {
      store.set(at->first, at->second, v, true);
      return *this;
    }
    const Operand o = operandOf(name);
    Concrete domain(outside);
    Machine<Concrete> machine(domain, store, *plan_);
    machine.save(o.area, o.offset, o.width, v & Concrete::mask(bits(o.width)), o.bit);
    return *this;
  }
  /// "VW0=5 SM1.0=1" on the store.
  Plant& set(std::string_view assignments);
  int current(std::uint32_t timer) const { return static_cast<std::int16_t>(store.get(Reg::TimerCurrent, timer)); }
  bool timerBit(std::uint32_t timer) const { return store.get(Reg::TimerBit, timer) != 0; }
  float real(std::string_view address) { return std::bit_cast<float>(static_cast<std::uint32_t>(value(address))); }
  /// Lets `count` ticks of that resolution pass outside a scan.
  void refresh(int resolution, int count);
  const Program& program() const { return program_; }

 private:
  friend struct PlantRun;

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
  void add(const Block& block) {
    Pou pou;
    pou.kind = block.kind;
    pou.number = block.number;
    pou.networks.push_back({});
    for (const std::string& line : split(block.statements, ';'))
      pou.networks[0].instructions.push_back(statement(line));
    for (const std::string& row : block.locals) pou.locals.push_back(local(row));
    program_.pous.push_back(std::move(pou));
  }

  Program program_;
  std::unique_ptr<Plan> plan_;
};

/// A number as an example writes it: 12, -3, 16#FF, 2#101, or a REAL with a point.
inline std::uint64_t numberOf(const std::string& text) {
  if (text.starts_with("16#")) return std::strtoull(text.c_str() + 3, nullptr, 16);
  if (text.starts_with("2#")) return std::strtoull(text.c_str() + 2, nullptr, 2);
  if (text.find_first_of(".ni") != std::string::npos)
    return std::bit_cast<std::uint32_t>(std::strtof(text.c_str(), nullptr));
  return static_cast<std::uint64_t>(std::strtoll(text.c_str(), nullptr, 10));
}

inline Plant& Plant::set(std::string_view assignments) {
  for (const std::string& pair : split(assignments, ' ')) {
    const std::size_t equal = pair.find('=');
    set(std::string_view(pair).substr(0, equal), numberOf(pair.substr(equal + 1)));
  }
  return *this;
}

/// Settings of the open points for one example: "increment-overflow=keeps".
struct Example {
  std::string statements;
  std::string given;
  std::string expected;
  std::string hazards{};  ///< codes, separated by blanks
  std::string choices{};
  Target target{};
};

/// Runs `statements` with power flow from `given` and demands exactly `expected`: every byte, register and status bit
/// that is not named must stay as it was. Each example runs with SM1 and ENO all 0 and all 1 before. "SM1.0=?" means a
/// value that the manual leaves open. ENO must be 1 after boxes without errors and 0 after a hazard.
inline void check(const Example& e) {
  SCOPED_TRACE(e.statements + " | " + e.given);
  for (const bool before : {false, true}) {
    SCOPED_TRACE(before ? "status bits 1 before" : "status bits 0 before");
    Plant plant("LD SM0.0; " + e.statements, e.target);
    for (const std::string& choice : split(e.choices, ' ')) {
      const std::size_t equal = choice.find('=');
      EXPECT_TRUE(plant.choices.set(choice.substr(0, equal), choice.substr(equal + 1))) << choice;
    }
    plant.set(before ? "SMB1=255 ENO[0]=1" : "SMB1=0 ENO[0]=0");
    plant.set(e.given);
    plant.outside.unknownStatus = before ? 0 : 1;
    Plant wanted("LD SM0.0");
    wanted.store = plant.store;
    setReadings(wanted.store, plant.choices);
    bool hasEno = false;
    for (const Instruction& instruction : plant.program().pous[0].networks[0].instructions)
      hasEno = hasEno || instruction.desc->eno;
    if (hasEno) wanted.set(e.hazards.empty() ? "ENO[0]=1" : "ENO[0]=0");
    for (const std::string& pair : split(e.expected, ' ')) {
      const std::size_t equal = pair.find('=');
      const std::string name = pair.substr(0, equal), value = pair.substr(equal + 1);
      wanted.set(name, value == "?" ? plant.outside.unknownStatus : numberOf(value));
    }
    plant.scan();
    std::string hazards;
    for (const Hazard hazard : plant.outside.hazards()) {
      hazards += (hazards.empty() ? "" : " ") + std::string(hazardInfo(hazard).code);
      if (hazardInfo(hazard).kind == HazardClass::NonFatal) wanted.set("SM4.3", 1);
    }
    EXPECT_EQ(hazards, e.hazards);
    for (const std::string& pair : split(e.expected, ' ')) {
      const std::string name = pair.substr(0, pair.find('='));
      EXPECT_EQ(plant.value(name), wanted.value(name)) << name;
    }
    EXPECT_EQ(plant.value("ENO[0]"), wanted.value("ENO[0]")) << "ENO";
    EXPECT_EQ(plant.value("SMB1"), wanted.value("SMB1")) << "status bits";
    EXPECT_TRUE(plant.store == wanted.store) << "something not named in the example changed";
  }
}
inline void check(std::initializer_list<Example> examples) {
  for (const Example& example : examples) check(example);
}

}  // namespace rungproof::manual
