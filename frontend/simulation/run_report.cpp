// Findings and assumptions of a run.
#include "frontend/simulation/run_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "ir/s7200/call_contract.hpp"
#include "ir/s7200/cpu.hpp"
#include "ir/s7300/organization_block.hpp"

namespace rungproof {

namespace {

/// "OB82, OB86"
std::string blocksOf(const std::set<int>& events) {
  std::string text;
  for (const int event : events) text += fmt::format("{}OB{}", text.empty() ? "" : ", ", blockOfEvent(event));
  return text;
}

/// Where the error is described. The S7-200 SMART has taken over the codes, in a manual of its own.
std::string whereDescribed(const HazardInfo& info, const Target& target) {
  if (isSmart(target) && !info.code.empty()) return fmt::format("the error codes of the {}", smartManual);
  return fmt::format("{} of the manual", info.manual);
}

Finding findingOf(const RunTimeError& error, const Simulator& simulator) {
  const Program& program = *simulator.plan().program;
  const HazardInfo& info = hazardInfo(error.hazard);
  Finding finding;
  const bool isFatal = info.kind == HazardClass::Fatal;
  finding.rule = error.hazard == Hazard::QueueOverflow ? "RUN003" : isFatal ? "RUN002" : "RUN001";
  finding.severity = isFatal ? Severity::Error : Severity::Warning;
  const std::string code = info.code.starts_with('F') ? fmt::format("fatal error {}", info.code.substr(1))
                           : isFatal || info.kind == HazardClass::NonFatal ? fmt::format("run-time error {}", info.code)
                                                                           : std::string("events lost");
  const std::string often = error.count > 1 ? fmt::format(", {} times in all", error.count) : "";
  const bool isNotLoaded = error.hazard == Hazard::S7NotLoaded;
  const std::string blocks = isNotLoaded ? blocksOf(simulator.eventsWithoutBlock()) : "";
  finding.message = fmt::format("{}: {}{} (scan {}, {} ms{})", code, info.text, isNotLoaded ? ": " + blocks : "",
                                error.scan, plainNumber(static_cast<double>(error.timeUs) / 1000), often);
  finding.help = fmt::format("{}see {}", isNotLoaded ? fmt::format("an empty {} keeps the CPU in RUN; ", blocks) : "",
                             whereDescribed(info, program.target));
  finding.confirmation = Confirmation::Confirmed;
  if (error.place == nullptr) {
    const auto main = std::ranges::find(program.pous, PouKind::Main, &Pou::kind);
    if (main != program.pous.end()) finding.span = {main->span.file, main->span.offset, 0};
    return finding;
  }
  finding.span = error.place->span;
  for (const Pou& pou : program.pous) {
    for (const Network& network : pou.networks) {
      for (const Instruction& instruction : network.instructions) {
        if (&instruction != error.place) continue;
        finding.pou = pou.name;
        finding.network = network.number;
      }
    }
  }
  return finding;
}

std::string placeOf(const Instruction* instruction, const Program& program) {
  if (instruction == nullptr) return "";
  const SourceFile& file = program.sources->file(instruction->span.file);
  return fmt::format(" at {}:{}", file.name(), file.position(instruction->span.offset).line);
}

/// Calls of blocks without text: what they write comes from the stimulus.
void listHiddenBlocks(Report& report, const Program& program) {
  const CallContracts contracts(program);
  for (const Pou& pou : program.pous) {
    for (const Network& network : pou.networks) {
      for (const Instruction& instruction : network.instructions) {
        const CallContract* contract = contracts.of(instruction);
        if (contract == nullptr) continue;
        const bool isLibrary = contract->source == CallContract::Source::Library;
        report.coverage.approximated.push_back(
            fmt::format("{}{}: {}", contract->name, placeOf(&instruction, program),
                        isLibrary ? "outputs come from the stimulus"
                                  : "its text is missing; it writes what the stimulus says, or nothing"));
      }
    }
  }
}

}  // namespace

std::string stopText(const Simulator& simulator) {
  if (simulator.isRunning() || simulator.errors().fatal() != nullptr) return "";
  return fmt::format("the CPU went to STOP{}", placeOf(simulator.stoppedBy(), *simulator.plan().program));
}

void describeRun(Report& report, const Simulator& simulator, const ScanTime& scanTime, bool countsLastScan) {
  const Plan& plan = simulator.plan();
  const Program& program = *plan.program;
  for (const RunTimeError& error : simulator.errors().list()) {
    if (!countsLastScan && error.scan == simulator.scanCount()) continue;
    const bool isLost = error.hazard == Hazard::QueueOverflow;
    if (hazardInfo(error.hazard).kind != HazardClass::StatusOnly || isLost)
      report.findings.push_back(findingOf(error, simulator));
  }
  for (const int event : simulator.eventsWithoutCause()) {
    Finding finding;
    finding.rule = "RUN004";
    finding.severity = Severity::Note;
    finding.message = fmt::format("event {} ({}) came from the stimulus although nothing could cause it then",
                                  shownEvent(event), eventInfo(event).text);
    finding.help = plan.dialect().run.startsBlocks
                       ? "OB30 to OB38 come with their period, OB20 to OB23 at the end of a delay of SFC 32 "
                         "(002:1096-1212)"
                       : "see 001:5378 of the manual for what causes each event";
    report.findings.push_back(std::move(finding));
  }
  listHiddenBlocks(report, program);
  const auto ms = [](Duration duration) { return static_cast<double>(duration.count()) / 1000; };
  const std::string range = scanTime.low == scanTime.high
                                ? fmt::format("{:g} ms", ms(scanTime.low))
                                : fmt::format("{:g} ms to {:g} ms", ms(scanTime.low), ms(scanTime.high));
  report.assumptions.push_back(fmt::format("CPU {}", cpuName(program.target.cpu)));
  if (plan.dialect().run.startsBlocks)
    std::ranges::move(s7300::startTexts(program), std::back_inserter(report.assumptions));
  report.assumptions.push_back(fmt::format("scan time {} where the stimulus says nothing", range));
  report.assumptions.push_back(fmt::format("{} scans, {} ms", simulator.scanCount(),
                                           plainNumber(static_cast<double>(simulator.timeUs()) / 1000)));
  if (const std::string text = stopText(simulator); !text.empty() && countsLastScan) report.assumptions.push_back(text);
}

}  // namespace rungproof
