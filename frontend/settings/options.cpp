// The table of common options. Adding a row is all it takes: command line, help, completion, configuration and
// `rungproof config` follow.
#include "frontend/settings/options.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "analysis/schedule/technique.hpp"
#include "frontend/files/closest_word.hpp"
#include "frontend/property/external_range.hpp"
#include "frontend/settings/code_list.hpp"
#include "frontend/settings/retentive_range.hpp"
#include "ir/s7200/cpu.hpp"
#include "ir/s7300/cpu.hpp"

namespace rungproof {

namespace {

using namespace option_group;

/// The names of CPUs, as "212|214|...": those of the S7-200, or of all families.
struct CpuNames {
  std::array<char, 256> text{};
  std::size_t length = 0;

  constexpr explicit CpuNames(bool all) {
    for (const CpuRow& row : cpu_rows::rows) add(row.name);
    if (!all) return;
    for (const Step7CpuRow& row : cpu_rows::step7) add(row.name);
  }
  constexpr void add(std::string_view name) {
    if (length > 0) text[length++] = '|';
    for (const char c : name) text[length++] = c;
  }
  constexpr std::string_view view() const { return {text.data(), length}; }
};

// clang-format off
constexpr CpuNames s7200CpuNames(false), cpuNames(true);

constexpr std::array table = {
    OptionInfo{Opt::Cpu, Reading, Arity::One, "cpu", cpuNames.view(), "226", "CPU whose limits count; of an S7-300/400 the largest, unless one is named"},
    OptionInfo{Opt::Edition, Reading, Arity::One, "edition", "2003|2004|smart-2.7|smart-2.8", "2004", "edition of the system manual whose tables count, or firmware of an S7-200 SMART"},
    OptionInfo{Opt::Dialect, Reading, Arity::One, "dialect", "auto|s7-200|s7-300|s7-400|iec", "auto", "what the files are written in"},
    OptionInfo{Opt::Mnemonics, Reading, Arity::One, "mnemonics", "auto|international|german", "auto", "which set of mnemonics the files use"},
    OptionInfo{Opt::Encoding, Reading, Arity::One, "encoding", "auto|utf-8|cp1252|cp1251|gb18030", "auto", "character encoding of the files"},
    OptionInfo{Opt::Symbols, Reading, Arity::List, "symbols", "FILE", "", "symbol table that belongs to the program"},
    OptionInfo{Opt::Tags, Reading, Arity::List, "tags", "FILE", "", "tag list of an operator panel (CSV: name, address, type, access); what it does not mark as read-only counts as external"},
    OptionInfo{Opt::External, Reading, Arity::List, "external", "RANGE", "", "what a panel or a network writes in any scan, as VW100 or VB100..VB199"},
    OptionInfo{Opt::Exclude, Reading, Arity::List, "exclude", "PATTERN", "", "files that a folder does not stand for, by their name in the project, such as old/*"},
    OptionInfo{Opt::Program, Reading, Arity::One, "program", "NAME", "", "STEP 7 project: the program that is meant, by its name or the end of its path; 'show --list' lists them"},
    OptionInfo{Opt::Protected, Reading, Arity::One, "protected", "analysed|contract", "analysed", "STEP 7 project: whether the code of know-how protected blocks is run and analysed, or taken as hidden; it is never printed"},
    OptionInfo{Opt::StdinFilename, Reading, Arity::One, "stdin-filename", "NAME", "", "name for standard input, which is read where FILE is '-'", false},
    OptionInfo{Opt::Retentive, Running, Arity::List, "retentive", "RANGE", "", "what keeps its value without power, as VB0..VB99, MB0..MB13, T0..T31, C0..C255 or DB10.DBB0..DBB19 (S7-200: all of V, MB14..MB31, T0..T31, T64..T95, C0..C255; S7-200 SMART: nothing; S7-300/400: MB0..MB15, C0..C7, data blocks without NON_RETAIN)"},
    OptionInfo{Opt::LibraryMemory, Running, Arity::List, "library-memory", "RANGE", "", "V memory of the libraries, as VB1000..VB1285, or of one block, as RCP0_READ=VB100..VB119"},
    OptionInfo{Opt::ClockMemory, Running, Arity::One, "clock-memory", "MB", "", "S7-300/400: byte whose bits the CPU flashes, as MB100: 0.1, 0.2, 0.4, 0.5, 0.8, 1, 1.6 and 2 s from bit 0 to bit 7"},
    OptionInfo{Opt::CycleMonitoring, Running, Arity::One, "cycle-monitoring", "TIME", "150ms", "S7-300/400: longest scan, 1ms to 6s; a longer one calls OB80 or stops the CPU"},
    OptionInfo{Opt::Start, Running, Arity::One, "start", "warm|cold", "warm", "S7-300/400: restart that a run begins with; cold: OB102 and nothing retained"},
    OptionInfo{Opt::Ob30, Hidden, Arity::One, "ob30", "TIME", "5s", "period of OB30"},
    OptionInfo{Opt::Ob31, Hidden, Arity::One, "ob31", "TIME", "2s", "period of OB31"},
    OptionInfo{Opt::Ob32, Hidden, Arity::One, "ob32", "TIME", "1s", "period of OB32"},
    OptionInfo{Opt::Ob33, Hidden, Arity::One, "ob33", "TIME", "500ms", "period of OB33"},
    OptionInfo{Opt::Ob34, Hidden, Arity::One, "ob34", "TIME", "200ms", "period of OB34"},
    OptionInfo{Opt::Ob35, Running, Arity::One, "ob35", "TIME", "100ms", "S7-300/400: period of the cyclic interrupt OB35, 1ms to 60s; --ob30 to --ob38 likewise (5s, 2s, 1s, 500ms, 200ms, 100ms, 50ms, 20ms, 10ms)"},
    OptionInfo{Opt::Ob36, Hidden, Arity::One, "ob36", "TIME", "50ms", "period of OB36"},
    OptionInfo{Opt::Ob37, Hidden, Arity::One, "ob37", "TIME", "20ms", "period of OB37"},
    OptionInfo{Opt::Ob38, Hidden, Arity::One, "ob38", "TIME", "10ms", "period of OB38"},
    OptionInfo{Opt::ScanTime, Running, Arity::One, "scan-time", "MIN..MAX", "", "length of a scan, as 5ms..20ms or one value (sim: 10ms; prove: 1ms up to the watchdog)"},
    OptionInfo{Opt::Phase, Running, Arity::One, "phase", "TIME", "0ms", "time since the last tick of the 10 ms and 100 ms timers when RUN begins (sim; proofs cover any)"},
    OptionInfo{Opt::Timeout, Running, Arity::One, "timeout", "TIME", "30s", "time limit for each property"},
    OptionInfo{Opt::Memory, Running, Arity::One, "memory", "SIZE", "", "memory limit, as 500MB or 2GB (three quarters of the machine; lint --prove: 2GB)"},
    OptionInfo{Opt::Bound, Running, Arity::One, "bound", "N", "", "look at no more than N scans"},
    OptionInfo{Opt::Jobs, Running, Arity::One, "jobs", "N", "", "threads to use (all processors)"},
    OptionInfo{Opt::Cache, Proving, Arity::One, "cache", "DIR", "", "prove: keep results in this folder, and repeat them while nothing that they depend on has changed"},
    OptionInfo{Opt::Seed, Running, Arity::One, "seed", "N", "1", "seed of everything random"},
    OptionInfo{Opt::Without, Hidden, Arity::List, "without", "NAME", "", "technique that the prover does without", false},
    OptionInfo{Opt::ChoiceOf, Running, Arity::List, "choice", "KEY=VALUE", "", "reading of a point that the manual leaves open; see 'rungproof explain choices'", false},
    OptionInfo{Opt::Select, Rules, Arity::List, "select", "CODE", "", "rules to run, by id or prefix (ADR001, ADR, ALL); those that are on by default"},
    OptionInfo{Opt::Ignore, Rules, Arity::List, "ignore", "CODE", "", "rules not to run, by id or prefix"},
    OptionInfo{Opt::PortTo, Rules, Arity::One, "port-to", s7200CpuNames.view(), "", "CPU that the program is to be ported to: PRT001 tells what is not the same there"},
    OptionInfo{Opt::Level, Rules, Arity::One, "level", "error|warning|note", "note", "report findings of this severity and above"},
    OptionInfo{Opt::FailLevel, Rules, Arity::One, "fail-level", "error|warning|note", "warning", "findings of this severity and above make the exit code 1 (sim --expect: error)"},
    OptionInfo{Opt::ExitZero, Rules, Arity::Flag, "exit-zero", "", "", "exit with 0 whatever is found; with 2 only if the job could not be done"},
    OptionInfo{Opt::NoSuppress, Rules, Arity::Flag, "no-suppress", "", "", "report findings although an allow-comment silences them"},
    OptionInfo{Opt::Baseline, Rules, Arity::One, "baseline", "FILE", "", "leave out the findings that the baseline file lists"},
    OptionInfo{Opt::Budget, Rules, Arity::One, "budget", "TIME", "60s", "lint --prove: time for all questions together"},
    OptionInfo{Opt::TimeColumn, Traces, Arity::One, "time-column", "NAME", "", "column of a logger's file that holds the time: its heading, or its number from 1"},
    OptionInfo{Opt::TimeUnit, Traces, Arity::One, "time-unit", "ns|us|ms|s|min|h", "", "unit of that column where its heading does not say it; dates and times of day need none"},
    OptionInfo{Opt::Separator, Traces, Arity::One, "separator", "auto|comma|semicolon|tab|bar", "auto", "what separates the cells of a trace or stimulus file"},
    OptionInfo{Opt::Rename, Traces, Arity::List, "rename", "COLUMN=ADDRESS", "", "what a column of a trace or stimulus file is; COLUMN=- leaves it out, '*=-' all that mean nothing in the program"},
    OptionInfo{Opt::Format, Output, Arity::List, "format", "NAME[=FILE]", "", "form of the report; with FILE written there; may be repeated"},
    OptionInfo{Opt::Color, Output, Arity::One, "color", "auto|always|never", "auto", "colours; auto: on a terminal unless NO_COLOR is set"},
    OptionInfo{Opt::Quiet, Output, Arity::Flag, "quiet", "", "", "results only: no closing line, no progress"},
    OptionInfo{Opt::Verbose, Proving, Arity::Flag, "verbose", "", "", "also what each technique of the prover was asked, what it settled, and the time it took"},
    OptionInfo{Opt::Isolated, Configuration, Arity::Flag, "isolated", "", "", "read no configuration file", false},
    OptionInfo{Opt::Config, Configuration, Arity::One, "config", "FILE", "", "configuration file (rungproof.toml beside the first FILE or above it)", false},
};
// clang-format on

constexpr bool tableIsInOrder() {
  for (std::size_t i = 0; i < table.size(); ++i) {
    if (static_cast<std::size_t>(table[i].id) != i) return false;
  }
  return table.size() == static_cast<std::size_t>(Opt::count);
}
static_assert(tableIsInOrder(), "the table must follow the enumeration");

std::string orList(const std::vector<std::string_view>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) text += i + 1 == words.size() ? " or " : ", ";
    text += words[i];
  }
  return text;
}

std::optional<std::int64_t> wholeNumber(std::string_view text) {
  if (text.empty() || text.size() > 18) return std::nullopt;
  std::int64_t value = 0;
  for (const char c : text) {
    if (c < '0' || c > '9') return std::nullopt;
    value = value * 10 + (c - '0');
  }
  return value;
}

/// Free text that has a form of its own: numbers, times, codes of rules.
std::optional<Failure> checkForm(const OptionInfo& info, std::string_view text) {
  if (info.value == "N") {
    const auto value = wholeNumber(text);
    const bool zeroAllowed = info.id == Opt::Seed;
    if (value && (*value > 0 || zeroAllowed)) return std::nullopt;
    return Failure{fmt::format("'{}' is no value for --{}", text, info.name),
                   {},
                   zeroAllowed ? "give a whole number" : "give a whole number above 0"};
  }
  if ((info.id == Opt::Timeout || info.id == Opt::Budget || info.id == Opt::Phase) && !durationNamed(text)) {
    return Failure{
        fmt::format("'{}' is no time", text), {}, "write a number with its unit, such as 30s, 500ms or 2min"};
  }
  if (info.id >= Opt::Ob30 && info.id <= Opt::Ob38) {
    const auto period = durationNamed(text);
    if (period && period->count() % 1000 == 0 && *period >= Duration(1000) && *period <= Duration(60'000'000))
      return std::nullopt;
    return Failure{
        fmt::format("'{}' is no period of a cyclic interrupt", text), {}, "write whole milliseconds, from 1ms to 60s"};
  }
  if (info.id == Opt::CycleMonitoring) {
    const auto time = durationNamed(text);
    if (time && time->count() % 1000 == 0 && *time >= Duration(1000) && *time <= Duration(6'000'000))
      return std::nullopt;
    return Failure{
        fmt::format("'{}' is no time of the cycle monitoring", text), {}, "write whole milliseconds, from 1ms to 6s"};
  }
  if (info.id == Opt::ClockMemory && !clockMemoryNamed(text)) {
    return Failure{fmt::format("'{}' is no byte for clock memory", text), {}, "write a byte of M, such as MB100"};
  }
  if (info.id == Opt::Memory && !memoryNamed(text)) {
    return Failure{fmt::format("'{}' is no amount of memory", text),
                   {},
                   "write a whole number with its unit, such as 500MB or 2GB"};
  }
  if (info.id == Opt::Retentive && !retentiveRangeNamed(text)) {
    return Failure{fmt::format("'{}' is no retentive range", text),
                   {},
                   "write bytes of V, M or a data block, or numbers of T or C, such as VB0..VB99, C0..C15 or "
                   "DB10.DBB0..DBB19"};
  }
  if (info.id == Opt::External && !externalRangeNamed(text)) {
    return Failure{
        fmt::format("'{}' is nothing that is written from outside", text),
        {},
        "write an address of V, M, DB, S, SM or Q, or the first and the last, such as VW100 or VB100..VB199"};
  }
  if (info.id == Opt::LibraryMemory && !libraryMemoryNamed(text)) {
    return Failure{fmt::format("'{}' is no library memory", text),
                   {},
                   "write bytes of V, such as VB1000..VB1285, or MBUS_SLAVE=VB1000..VB1778"};
  }
  if (info.id == Opt::ScanTime && !scanTimeNamed(text)) {
    return Failure{fmt::format("'{}' is no scan time", text),
                   {},
                   "write one time above zero, or the shortest and the longest, such as 10ms or 5ms..20ms"};
  }
  if (info.id == Opt::Without && techniqueNamed(text) == nullptr) {
    std::vector<std::string_view> names;
    for (const TechniqueInfo& technique : techniqueTable()) names.push_back(technique.name);
    return Failure{
        fmt::format("the prover has no technique '{}'", text), {}, fmt::format("it has {}", fmt::join(names, ", "))};
  }
  if (info.id == Opt::Select || info.id == Opt::Ignore) {
    const std::string id = asCode(text);
    if (id == "ALL") return std::nullopt;
    std::vector<std::string_view> ids;
    for (const Code& code : allCodes()) {
      if (code.id.starts_with(id) && !id.empty()) return std::nullopt;
      ids.push_back(code.id);
    }
    const std::string_view meant = closest(text, ids);
    return Failure{fmt::format("no rule is called '{}' or begins so", text),
                   {},
                   meant.empty() ? "'rungproof rules' lists them" : fmt::format("did you mean '{}'?", meant)};
  }
  return std::nullopt;
}

}  // namespace

std::span<const OptionInfo> optionTable() { return table; }
const OptionInfo& optionInfo(Opt id) { return table[static_cast<std::size_t>(id)]; }

std::optional<std::uint64_t> memoryNamed(std::string_view text) {
  for (const auto& [unit, bytes] :
       {std::pair<std::string_view, std::uint64_t>{"MB", 1'000'000}, {"GB", 1'000'000'000}}) {
    if (!text.ends_with(unit)) continue;
    const auto value = wholeNumber(text.substr(0, text.size() - unit.size()));
    if (value && *value > 0 && *value < 1'000'000) return static_cast<std::uint64_t>(*value) * bytes;
  }
  return std::nullopt;
}

const OptionInfo* optionNamed(std::string_view name) {
  for (const OptionInfo& info : table) {
    if (info.name == name) return &info;
  }
  return nullptr;
}

std::vector<std::string_view> permittedWords(std::string_view value) {
  std::vector<std::string_view> words;
  if (value.find('|') == std::string_view::npos) return words;
  for (std::size_t begin = 0; begin <= value.size();) {
    const std::size_t end = std::min(value.find('|', begin), value.size());
    words.push_back(value.substr(begin, end - begin));
    begin = end + 1;
  }
  return words;
}

std::optional<Failure> checkValue(const OptionInfo& info, std::string_view text) {
  const auto words = permittedWords(info.value);
  if (words.empty()) return checkForm(info, text);
  if ((info.id == Opt::Cpu || info.id == Opt::PortTo) && cpuNamed(text)) return std::nullopt;  // in any case of letters
  for (const std::string_view word : words) {
    if (word == text) return std::nullopt;
  }
  return Failure{fmt::format("'{}' is no value for --{}", text, info.name), {}, "it can be " + orList(words)};
}

}  // namespace rungproof
