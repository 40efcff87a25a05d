// Values of the common options in this run: defaults, configuration file, command line, in rising order of rank.
// Tested by tests/cli/settings_test.cpp.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "frontend/files/closest_word.hpp"
#include "frontend/settings/choice_bundle.hpp"
#include "frontend/settings/code_list.hpp"
#include "frontend/settings/options.hpp"
#include "frontend/settings/retentive_range.hpp"
#include "ir/check.hpp"
#include "ir/s7200/cpu.hpp"

namespace rungproof {

namespace {

/// Longest duration that options accept; keeps sums of durations far from overflow.
constexpr double longestSeconds = 366.0 * 24 * 3600;

std::vector<std::string> splitAtCommas(const std::vector<std::string>& texts) {
  std::vector<std::string> parts;
  for (const std::string& text : texts) {
    for (std::size_t begin = 0; begin <= text.size();) {
      const std::size_t end = std::min(text.find(',', begin), text.size());
      if (end > begin) parts.push_back(text.substr(begin, end - begin));
      begin = end + 1;
    }
  }
  return parts;
}

}  // namespace

std::optional<Duration> durationNamed(std::string_view text) {
  struct Unit {
    std::string_view name;
    double seconds;
  };
  static constexpr std::array units = {Unit{"us", 1e-6}, Unit{"ms", 1e-3}, Unit{"min", 60.0}, Unit{"s", 1.0}};
  const std::size_t end = text.find_first_not_of("0123456789.");
  if (end == 0 || end == std::string_view::npos) return std::nullopt;
  const std::string digits(text.substr(0, end));
  if (std::count(digits.begin(), digits.end(), '.') > 1 || digits == ".") return std::nullopt;
  for (const Unit& unit : units) {
    if (text.substr(end) != unit.name) continue;
    const double seconds = std::strtod(digits.c_str(), nullptr) * unit.seconds;
    if (seconds > longestSeconds) return std::nullopt;
    return Duration(std::llround(seconds * 1e6));
  }
  return std::nullopt;
}

std::optional<ScanTime> scanTimeNamed(std::string_view text) {
  const std::size_t dots = text.find("..");
  const auto low = durationNamed(text.substr(0, dots));
  const auto high = dots == std::string_view::npos ? low : durationNamed(text.substr(dots + 2));
  if (!low || !high || low->count() == 0 || *high < *low) return std::nullopt;
  return ScanTime{*low, *high};
}

Settings::Settings() {
  for (const OptionInfo& info : optionTable()) {
    if (!info.initial.empty()) values_[index(info.id)].texts = {std::string(info.initial)};
  }
  choiceOrigins_.fill("default");
}

std::string_view Settings::text(Opt id) const {
  const auto& texts = values_[index(id)].texts;
  return texts.empty() ? std::string_view() : std::string_view(texts.back());
}

std::int64_t Settings::number(Opt id, std::int64_t initial) const {
  const std::string value(text(id));
  return value.empty() ? initial : std::strtoll(value.c_str(), nullptr, 10);
}

std::optional<std::uint64_t> Settings::memory() const { return memoryNamed(text(Opt::Memory)); }

Target Settings::target() const {
  Target target;
  target.cpu = *cpuNamed(text(Opt::Cpu));
  // Without an explicit edition, the newest that describes the chosen CPU counts (the 226XM left the manual in 2004).
  target.edition = isSet(Opt::Edition) ? *editionNamed(text(Opt::Edition)) : usualEdition(target.cpu);
  return target;
}

std::optional<Target> Settings::portTo() const {
  const std::optional<Cpu> cpu = cpuNamed(text(Opt::PortTo));
  return cpu ? std::optional(Target{*cpu, usualEdition(*cpu)}) : std::nullopt;
}

Severity Settings::level() const { return severityNamed(text(Opt::Level)); }
Severity Settings::failLevel() const { return severityNamed(text(Opt::FailLevel)); }

std::vector<LibraryMemory> Settings::libraryMemory() const {
  std::vector<LibraryMemory> memory;
  for (const std::string& text : list(Opt::LibraryMemory)) memory.push_back(*libraryMemoryNamed(text));
  return memory;
}

std::optional<std::vector<RetentiveRange>> Settings::retentive() const {
  if (!isSet(Opt::Retentive)) return std::nullopt;
  std::vector<RetentiveRange> ranges;
  for (const std::string& text : list(Opt::Retentive)) ranges.push_back(*retentiveRangeNamed(text));
  return ranges;
}
std::array<std::uint16_t, cyclicBlockCount> Settings::cyclicPeriods() const {
  std::array<std::uint16_t, cyclicBlockCount> periods{};
  for (std::size_t i = 0; i < periods.size(); ++i) {
    const auto option = static_cast<Opt>(static_cast<std::size_t>(Opt::Ob30) + i);
    periods[i] = static_cast<std::uint16_t>(durationNamed(text(option))->count() / 1000);
  }
  return periods;
}
std::optional<std::uint32_t> Settings::clockMemory() const { return clockMemoryNamed(text(Opt::ClockMemory)); }
std::uint16_t Settings::cycleMonitoringMs() const {
  return static_cast<std::uint16_t>(durationNamed(text(Opt::CycleMonitoring))->count() / 1000);
}
std::optional<ScanTime> Settings::scanTime() const { return scanTimeNamed(text(Opt::ScanTime)); }
std::uint32_t Settings::phaseMs() const {
  return static_cast<std::uint32_t>(durationNamed(text(Opt::Phase)).value_or(Duration(0)).count() / 1000 % 100);
}
std::optional<Duration> Settings::timeout() const { return durationNamed(text(Opt::Timeout)); }
std::optional<Duration> Settings::budget() const { return durationNamed(text(Opt::Budget)); }

Choices Settings::choices() const { return choices_; }

void Settings::set(Opt id, const std::vector<std::string>& texts, const std::string& origin) {
  Value& value = values_[index(id)];
  const bool areFiles = id == Opt::Symbols || id == Opt::Tags;
  value.texts = optionInfo(id).arity == Arity::List && !areFiles ? splitAtCommas(texts) : texts;
  if (id == Opt::Select || id == Opt::Ignore) std::ranges::transform(value.texts, value.texts.begin(), asCode);
  value.origin = origin;
}

std::optional<Failure> Settings::setChoice(std::string_view key, std::string_view value, const std::string& origin) {
  std::vector<std::string_view> keys;
  for (const ChoiceBundle& one : choiceBundles) {
    keys.push_back(one.key);
    if (one.key != key || one.name != value) continue;
    for (const auto& [part, chosen] : one.choices) {
      if (auto failure = setChoice(part, chosen, origin)) return failure;
    }
    return std::nullopt;
  }
  if (const std::string names = bundlesOf(key); !names.empty())
    return Failure{fmt::format("'{}' is no value for the choice '{}'", value, key), {}, "it can be " + names};
  for (const ChoiceInfo& info : choiceTable) {
    keys.push_back(info.key);
    if (info.key != key) continue;
    if (choices_.set(key, value)) {
      choiceOrigins_[static_cast<std::size_t>(info.choice)] = origin;
      return std::nullopt;
    }
    std::string values;
    for (const std::string_view name : info.values) {
      if (!name.empty()) values += (values.empty() ? "" : ", ") + std::string(name);
    }
    return Failure{fmt::format("'{}' is no value for the choice '{}'", value, key), {}, "it can be " + values};
  }
  const std::string_view meant = closest(key, keys);
  return Failure{fmt::format("there is no choice called '{}'", key),
                 {},
                 meant.empty() ? "'rungproof explain choices' lists them" : fmt::format("did you mean '{}'?", meant)};
}

std::optional<Failure> Settings::setSeverity(std::string_view rule, std::string_view severity) {
  const std::optional<Code> code = codeNamed(asCode(rule));
  if (!code) return Failure{fmt::format("no rule is called '{}'", rule), {}, "'rungproof rules' lists them"};
  const Severity wanted = severityNamed(severity);
  if (severityName(wanted) != severity)
    return Failure{fmt::format("'{}' is no severity", severity), {}, "it can be error, warning or note"};
  severities_[std::string(code->id)] = wanted;
  return std::nullopt;
}

std::optional<Failure> Settings::addFileIgnore(FileIgnore ignore) {
  for (std::string& text : ignore.codes) {
    if (auto failure = checkValue(optionInfo(Opt::Ignore), text)) return failure;
    text = asCode(text);
  }
  fileIgnores_.push_back(std::move(ignore));
  return std::nullopt;
}

std::optional<Failure> Settings::setRuleOption(std::string_view id, std::string_view name, std::int64_t value) {
  const Rule* rule = ruleNamed(id);
  if (rule == nullptr) return Failure{fmt::format("no rule is called '{}'", id), {}, "'rungproof rules' lists them"};
  std::vector<std::string_view> names;
  for (const RuleOption& option : rule->options) {
    names.push_back(option.name);
    if (option.name != name) continue;
    if (value < option.low || value > option.high) {
      return Failure{fmt::format("{} is out of range for '{}' of {}", value, name, rule->id),
                     {},
                     fmt::format("it can be {} to {}", option.low, option.high)};
    }
    ruleSettings_[fmt::format("{}.{}", rule->id, name)] = static_cast<int>(value);
    return std::nullopt;
  }
  const std::string_view meant = closest(name, names);
  return Failure{
      fmt::format("{} has no option '{}'", rule->id, name),
      {},
      meant.empty() ? fmt::format("see 'rungproof explain {}'", rule->id) : fmt::format("did you mean '{}'?", meant)};
}

std::optional<Failure> Settings::check() const {
  const Target chosen = target();
  if (!editionCovers(chosen.edition, chosen.cpu)) {
    return Failure{isSmart(chosen.cpu) || chosen.edition == Edition::Smart27 || chosen.edition == Edition::Smart28
                       ? fmt::format("the CPU {} is not of the edition {}", text(Opt::Cpu), text(Opt::Edition))
                       : fmt::format("the {} edition of the manual does not describe the CPU {}", text(Opt::Edition),
                                     text(Opt::Cpu)),
                   {},
                   fmt::format("leave out --edition, or give --edition {}", editionName(usualEdition(chosen.cpu)))};
  }
  return std::nullopt;
}

}  // namespace rungproof
