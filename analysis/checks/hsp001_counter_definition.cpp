// HSP001: HSC without HDEF, HDEF twice, HSC in front of its HDEF, HDEF with a mode that the counter has not. Tested by
// its examples and tests/rules/data_rules_test.cpp.
#include <fmt/format.h>

#include <array>

#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"
#include "ir/s7200/hsc_inputs.hpp"

namespace rungproof {

namespace {

constexpr int counters = 6;
constexpr int highestMode = 12;

int counterOf(const Instruction& instruction) {
  if (instruction.operands.empty() || instruction.operands[0].kind != OperandKind::Constant) return -1;
  const std::int64_t number = instruction.operands[0].value;
  return number >= 0 && number < counters ? static_cast<int>(number) : -1;
}

/// The mode of an HDEF if it is a number; else -1.
int modeOf(const Instruction& instruction) {
  if (instruction.operands.size() < 2 || instruction.operands[1].kind != OperandKind::Constant) return -1;
  const std::int64_t mode = instruction.operands[1].value;
  return mode >= 0 && mode <= highestMode ? static_cast<int>(mode) : -1;  // ADR006 speaks of others
}

/// "modes 0, 3, 12"
std::string modesOf(const Target& target, int counter) {
  std::string text;
  int count = 0;
  for (int mode = 0; mode <= highestMode; ++mode) {
    if (!hscHasMode(target, counter, mode)) continue;
    text += fmt::format("{}{}", count++ == 0 ? "" : ", ", mode);
  }
  return fmt::format("mode{} {}", count == 1 ? "" : "s", text);
}

void checkHsp001(const Facts& facts, FindingSink& sink) {
  std::array<const Instruction*, counters> definition{}, use{};
  for (const InstructionPlace& place :
       facts.placesOf([](const Desc& desc) { return desc.role == Role::Hdef || desc.role == Role::Hsc; })) {
    const Instruction& instruction = *place.instruction;
    const Role role = roleOf(instruction);
    if (role != Role::Hdef && role != Role::Hsc) continue;
    const int counter = counterOf(instruction);
    if (counter < 0) continue;
    const auto n = static_cast<std::size_t>(counter);
    if (role == Role::Hsc) {
      if (use[n] == nullptr) use[n] = &instruction;
      continue;
    }
    if (const int mode = modeOf(instruction); mode >= 0 && !hscHasMode(facts.target(), counter, mode)) {
      sink.report(instruction.span, fmt::format("HSC{} has no mode {}", counter, mode)).help =
          fmt::format("it has {}: choose one of these, or another counter", modesOf(facts.target(), counter));
    }
    if (definition[n] == nullptr) {
      definition[n] = &instruction;
      continue;
    }
    Finding& finding =
        sink.report(instruction.span, fmt::format("{} defines HSC{} a second time; only the first definition counts",
                                                  Facts::text(instruction), counter));
    finding.related.push_back({definition[n]->span, "first definition"});
    finding.help = "define a counter once, in the first scan (error 000A, 001:13958, 001:4360)";
  }
  if (facts.hasHiddenCode()) return;
  for (std::size_t n = 0; n < counters; ++n) {
    if (use[n] == nullptr) continue;
    if (definition[n] == nullptr) {
      sink.report(use[n]->span, fmt::format("{} runs, but no HDEF defines HSC{}", Facts::text(*use[n]), n)).help =
          "run HDEF once before, in the first scan (error 0001, 001:13949)";
    } else if (use[n]->id < definition[n]->id && facts.blockOf(use[n]->id) == facts.blockOf(definition[n]->id) &&
               (facts.conditionOf(use[n]->id) & condition::FirstScan) != 0) {
      Finding& finding =
          sink.report(use[n]->span, fmt::format("{} runs before the HDEF of its counter", Facts::text(*use[n])));
      finding.related.push_back({definition[n]->span, "the definition follows here"});
      finding.help = "put HDEF first (error 0001, 001:4188)";
    }
  }
}

}  // namespace

extern constexpr Rule hsp001_counter_definition = {
    .id = "HSP001",
    .title = "HSC without or with double HDEF",
    .severity = Severity::Error,
    .needs = Needs::Flow,
    .detects =
        "HSC reached before HDEF or without one, HDEF twice for one counter, HDEF with a mode that the counter does "
        "not have (HSC3 and HSC5 count in mode 0 only, HSC3 also in mode 12)",
    .why = "run-time errors 0001 and 000A: the instruction does nothing",
    .manual = "001:4188, 001:4360, 001:13949, 001:13958",
    .bad = "Network 1\nLD SM0.1\nMOVB 16#F8, SMB37\nHSC 0\n",
    .good = "Network 1\nLD SM0.1\nMOVB 16#F8, SMB37\nHDEF 0, 0\nHSC 0\n",
    .falsePositives = "two HDEF of which only one runs",
    .dialects = dialect::S7200,
    .check = checkHsp001,
};

}  // namespace rungproof
