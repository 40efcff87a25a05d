// What decides verdicts: texts, the CPU, options that are not as they were, choices.
#include "frontend/report_part.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace rungproof {

namespace {

/// Options that say how long and how hard somebody looks, or name a file whose text counts itself.
bool leavesVerdictsAlone(std::string_view option) {
  static constexpr std::array<std::string_view, 9> options = {
      "timeout", "memory", "jobs", "seed", "without", "phase", "tags", "symbols", "stdin-filename"};
  return std::ranges::find(options, option) != options.end();
}

Json basisOfProgram(const ProgramRecord& record) {
  Json files = Json::array(), options = Json::array();
  for (const FileRead& file : record.files) {
    if (file.kind != "configuration") files.push_back({{"name", file.name}, {"sha256", file.sha256}});
  }
  for (const OptionInForce& option : record.options) {
    if (!leavesVerdictsAlone(option.name)) options.push_back({{"name", option.name}, {"value", option.value}});
  }
  for (const ChoiceInForce& choice : record.choices) {
    if (!choice.origin.empty())
      options.push_back({{"name", "choice"}, {"value", fmt::format("{}={}", choice.key, choice.value)}});
  }
  const std::string cpu = record.cpu.empty() ? record.edition : fmt::format("{}, {}", record.cpu, record.edition);
  return {{"name", record.name}, {"cpu", cpu}, {"files", std::move(files)}, {"options", std::move(options)}};
}

}  // namespace

Json partJson(const Report& report) {
  Json programs = Json::array();
  for (const ProgramRecord& record : report.programs) programs.push_back(basisOfProgram(record));
  return {{"part", report.part->part},
          {"of", report.part->of},
          {"exit", static_cast<int>(exitOf(report))},
          {"programs", std::move(programs)}};
}

}  // namespace rungproof
