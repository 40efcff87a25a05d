// What verdicts rest on, taken from the report.
#include "frontend/report_basis.hpp"

#include <algorithm>

namespace rungproof {

std::vector<std::string> remarksOf(const PropertyResult& property) {
  std::vector<std::string> lines = property.notes;
  for (const std::string& assumption : property.assumptions) lines.push_back("assumes: " + assumption);
  if (!property.networks.empty()) lines.push_back("rests on networks: " + property.networks);
  return lines;
}

std::vector<std::string> remarksBesideRun(const PropertyResult& property) {
  std::vector<std::string> lines = remarksOf(property);
  std::erase_if(lines,
                [&](const std::string& line) { return std::ranges::find(property.run, line) != property.run.end(); });
  return lines;
}

std::vector<std::string> basisOf(const Report& report) {
  const bool isOfPrograms = report.comparison && report.comparison->isOfPrograms();
  const bool isRun = report.command == "sim";
  std::vector<std::string> lines;
  if (report.properties.empty() && !isOfPrograms && !isRun && report.command != "lint") return lines;
  for (const std::string& assumption : report.assumptions) {
    if (!isRun) lines.push_back("assumes: " + assumption);  // of a run the trace tells
  }
  for (const std::string& place : report.coverage.approximated) lines.push_back("approximated: " + place);
  return lines;
}

}  // namespace rungproof
