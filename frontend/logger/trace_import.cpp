// Options to the form of a file.
#include "frontend/logger/trace_import.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "frontend/logger/trace_cell.hpp"
#include "frontend/settings/options.hpp"

namespace rungproof {

namespace {

struct UnitName {
  std::string_view name;
  double nanoseconds;
};
constexpr std::array<UnitName, 24> unitNames = {
    {{"ps", 1e-3},      {"ns", 1},       {"us", 1e3},      {"\xC2\xB5s", 1e3}, {"\xCE\xBCs", 1e3}, {"usec", 1e3},
     {"ms", 1e6},       {"msec", 1e6},   {"s", 1e9},       {"sec", 1e9},       {"sek", 1e9},       {"second", 1e9},
     {"seconds", 1e9},  {"min", 6e10},   {"minute", 6e10}, {"minutes", 6e10},  {"h", 3.6e12},      {"hour", 3.6e12},
     {"hours", 3.6e12}, {"std", 3.6e12}, {"fs", 1e-6},     {"m", 6e10},        {"millis", 1e6},    {"micros", 1e3}}};

}  // namespace

std::optional<double> nanosecondsOf(std::string_view unit) {
  const std::string lower = lowered(unit);
  const auto found = std::ranges::find(unitNames, lower, &UnitName::name);
  return found == unitNames.end() ? std::nullopt : std::optional<double>(found->nanoseconds);
}

std::optional<double> nanosecondsInHeading(std::string_view heading) {
  std::string_view text = heading;
  if (!text.empty() && (text.back() == ']' || text.back() == ')')) text.remove_suffix(1);
  const std::size_t mark = text.find_last_of("[(/_ ");
  if (mark == std::string_view::npos) return nanosecondsOf(text);
  return nanosecondsOf(text.substr(mark + 1));
}

std::optional<std::string> TraceImport::nameFor(std::string_view heading) const {
  std::optional<std::string> result;
  const std::string lower = lowered(heading);
  for (std::size_t i = 0; i < renames.size(); ++i) {
    if (lowered(renames[i].first) != lower) continue;
    used->insert(i);
    result = renames[i].second;
  }
  return result;
}

TraceImport traceImportOf(const Settings& settings, std::vector<Failure>& failures) {
  TraceImport import;
  import.timeColumn = settings.text(Opt::TimeColumn);
  import.timeUnit = settings.text(Opt::TimeUnit);
  const std::string_view separator = settings.text(Opt::Separator);
  import.separator = separator == "comma"       ? ','
                     : separator == "semicolon" ? ';'
                     : separator == "tab"       ? '\t'
                     : separator == "bar"       ? '|'
                                                : '\0';
  for (const std::string& text : settings.list(Opt::Rename)) {
    const std::size_t equals = text.rfind('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == text.size()) {
      failures.push_back({fmt::format("'{}' renames no column", text),
                          {},
                          "write --rename COLUMN=ADDRESS, or --rename COLUMN=- for a column that does not count"});
    } else if (text.substr(0, equals) == "*" && text.substr(equals + 1) == "-") {
      import.dropsUnknown = true;
    } else {
      import.renames.emplace_back(text.substr(0, equals), text.substr(equals + 1));
    }
  }
  return import;
}

void checkRenames(const TraceImport& import, const std::string& names, std::vector<Failure>& failures) {
  for (std::size_t i = 0; i < import.renames.size(); ++i) {
    if (import.used->contains(i)) continue;
    failures.push_back({fmt::format("--rename names '{}', which is no column", import.renames[i].first), names,
                        "write the heading of the column as it stands in the file"});
  }
}

}  // namespace rungproof
