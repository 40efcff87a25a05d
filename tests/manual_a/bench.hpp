// Bench: a few statements on the machine with plain numbers. Statements are written as in the manual's examples; the
// bench reads them itself so that these tests depend on nothing but the instruction table and the meanings. A program
// of tests says in one source what a run is: bench_run.cpp here; tests/mutation runs the same tests on changed
// meanings.
#pragma once

#include <gtest/gtest.h>

#include <bit>
#include <cstdlib>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "engine/concrete.hpp"
#include "error_log.hpp"
#include "ir/isa.hpp"

namespace rungproof::manual {

/// Operand from its spelling: I0.0, VW10, T37, AC1, *VD4, &VB0, 12, +12, -3, 16#FF, 1.5, "text".
inline Operand operandOf(std::string_view text) {
  Operand o;
  if (text.front() == '"') {
    o.kind = OperandKind::Text;
    o.text = text.substr(1, text.size() - 2);
    return o;
  }
  if (text.front() == '*' || text.front() == '&') {
    o = operandOf(text.substr(1));
    o.kind = text.front() == '*' ? OperandKind::Indirect : OperandKind::Address;
    return o;
  }
  const std::string s(text);
  if (s.starts_with("16#")) return constant(std::strtoll(s.c_str() + 3, nullptr, 16), ConstantForm::Hex);
  if (std::string_view("+-0123456789").find(s[0]) != std::string_view::npos) {
    if (s.find('.') == std::string::npos) return constant(std::strtoll(s.c_str(), nullptr, 10));
    return constant(std::bit_cast<std::uint32_t>(std::strtof(s.c_str(), nullptr)), ConstantForm::Real);
  }
  static constexpr std::string_view areas[] = {"SM", "AC", "AI", "AQ", "HC", "I", "Q", "V", "M", "S", "L", "T", "C"};
  static constexpr Area values[] = {Area::SM, Area::AC, Area::AI, Area::AQ, Area::HC, Area::I, Area::Q,
                                    Area::V,  Area::M,  Area::S,  Area::L,  Area::T,  Area::C};
  std::size_t k = 0;
  while (!s.starts_with(areas[k])) ++k;
  std::size_t at = areas[k].size();
  Width width = Width::Bit;
  if (s[at] == 'B') width = Width::Byte;
  if (s[at] == 'W') width = Width::Word;
  if (s[at] == 'D' || values[k] == Area::AC || values[k] == Area::HC) width = Width::DWord;
  if (s[at] == 'B' || s[at] == 'W' || s[at] == 'D') ++at;
  const std::size_t dot = s.find('.');
  const auto bit = dot == std::string::npos ? 0U : static_cast<unsigned>(std::atoi(s.c_str() + dot + 1));
  return direct(values[k], width, static_cast<std::uint32_t>(std::atoi(s.c_str() + at)), bit);
}

/// Statement from its spelling: "ITA VW2, VB10, 16#0B".
inline Instruction statement(std::string_view line) {
  Instruction instruction;
  const std::size_t space = line.find(' ');
  const std::string_view name = line.substr(0, space);
  instruction.desc = instructionNamed(name);
  CHECK(instruction.desc != nullptr, std::string(name).c_str());
  std::string word;
  bool quoted = false;
  const auto flush = [&] {
    if (!word.empty()) instruction.operands.push_back(operandOf(word));
    word.clear();
  };
  for (const char c : space == std::string_view::npos ? std::string_view{} : line.substr(space)) {
    if (c == '"') quoted = !quoted;
    if (!quoted && c == ',')
      flush();
    else if (quoted || c != ' ')
      word += c;
  }
  flush();
  return instruction;
}

/// What the program meets outside: values by kind and index, and the errors it raised.
struct World final : Outside {
  std::map<std::pair<External, std::uint32_t>, std::uint64_t> values;
  ErrorLog errors;
  const std::vector<Hazard>& hazards() const { return errors.list(); }
  std::uint64_t external(const ExternalSite& site, int) override {
    const auto found = values.find({site.kind, site.index});
    return found == values.end() ? 0 : found->second;
  }
  void report(Hazard hazard, const Instruction* place) override { errors.add(hazard, place); }
};

/// What a run leaves besides the store.
struct Outcome {
  std::array<bool, 9> stack{};
  bool halted = false;
  bool faulted = false;
  friend bool operator==(const Outcome&, const Outcome&) = default;
};

class Bench {
 public:
  /// Main program; `interrupt` is the body of INT_0. Memory is all 0, the first scan is still to come.
  explicit Bench(const std::vector<std::string>& lines, Target target = {},
                 const std::vector<std::string>& interrupt = {}) {
    program_.target = target;
    addBlock(PouKind::Main, lines);
    addBlock(PouKind::Interrupt, interrupt);
    program_.number();
    plan_ = std::make_unique<Plan>(program_);
    store = Concrete::Store(target, plan_->edgeCount);
    store.set(Reg::FirstScan, 0, 1, true);
    store.set(Reg::Running, 0, 1, true);
    store.area(Area::SM)[0] = 1;  // SM0.0
  }

  ~Bench() { world.errors.clear(); }
  Bench(Bench&&) = default;

  Concrete::Store store;
  World world;
  Choices choices;
  std::array<bool, 9> stack{};  ///< logic stack after the last run
  bool halted = false;          ///< whether the last run ended in a fatal error

  /// One scan; hazards of earlier scans are forgotten.
  Bench& scan() { return run(false, {}); }
  /// INT_0 once.
  Bench& interrupt() { return run(true, {}); }
  /// The main program with the logic stack given instead of empty.
  Bench& scanWithStack(const std::array<bool, 9>& start) { return run(false, start); }

  std::uint64_t value(std::string_view address) {
    const Operand o = operandOf(address);
    Concrete domain(world);
    Machine<Concrete> machine(domain, store, *plan_);
    return machine.load(o.area, o.offset, o.width, o.bit);
  }
  /// Current value of a counter or timer, signed.
  int current(std::string_view number) {
    const Operand o = operandOf(number);
    return static_cast<std::int16_t>(store.get(o.area == Area::T ? Reg::TimerCurrent : Reg::CounterCurrent, o.offset));
  }
  float real(std::string_view address) { return std::bit_cast<float>(static_cast<std::uint32_t>(value(address))); }
  std::string text(std::uint32_t byte, std::size_t count) const {
    const auto* start = store.area(Area::V).data() + byte;
    return std::string(start, start + count);
  }
  void set(std::string_view address, std::int64_t v) {
    const Operand o = operandOf(address);
    Concrete domain(world);
    Machine<Concrete> machine(domain, store, *plan_);
    machine.save(o.area, o.offset, o.width, static_cast<std::uint64_t>(v) & Concrete::mask(bits(o.width)), o.bit);
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
  bool eno() {
    if (store.get(Reg::Eno, 0) == 0) world.hazards();  // the test knows of the error
    return store.get(Reg::Eno, 0) != 0;
  }
  bool errorBit() {
    if (value("SM4.3") != 0) world.hazards();
    return value("SM4.3") != 0;
  }
  std::uint64_t reg(Reg reg, std::uint32_t index = 0) { return store.get(reg, index); }
  bool met(Hazard hazard) const {
    return std::find(world.hazards().begin(), world.hazards().end(), hazard) != world.hazards().end();
  }
  bool quiet() const { return world.hazards().empty(); }

 private:
  void addBlock(PouKind kind, const std::vector<std::string>& lines) {
    Pou pou;
    pou.kind = kind;
    pou.networks.push_back({});
    for (const std::string& line : lines) pou.networks[0].instructions.push_back(statement(line));
    program_.pous.push_back(std::move(pou));
  }
  using Start = std::optional<std::array<bool, 9>>;

  friend struct BenchRun;
  Bench& run(bool asInterrupt, const Start& start);

  Program program_;
  std::unique_ptr<Plan> plan_;
};

}  // namespace rungproof::manual
