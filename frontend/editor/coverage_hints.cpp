// Tables are run anew for each state of the text, and up to a limit: an editor waits for no long test.
#include "frontend/editor/coverage_hints.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

#include "analysis/unread/unread_code.hpp"
#include "engine/coverage/coverage_recorder.hpp"
#include "engine/platform/names.hpp"
#include "engine/testing/test_player.hpp"
#include "frontend/files/disk_file.hpp"
#include "frontend/testing/table_reader.hpp"

namespace rungproof {

namespace {

constexpr std::uint64_t mostScans = 100000;

std::vector<std::string> tablesBeside(const std::string& file) {
  namespace fs = std::filesystem;
  const fs::path path(file);
  const std::string stem = pathName(path.stem()) + ".";
  std::vector<std::string> tables;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(path.parent_path(), error)) {
    const std::string name = pathName(entry.path().filename());
    if (name.starts_with(stem) && name.ends_with(".test.csv")) tables.push_back(pathName(entry.path()));
  }
  std::ranges::sort(tables);
  return tables;
}

/// False: the limit was reached.
bool runTables(const Program& program, const std::vector<std::string>& files, CoverageRecorder& recorder) {
  std::uint64_t scans = 0;
  for (const std::string& file : files) {
    const std::optional<std::string> bytes = bytesOfInput(file);
    if (!bytes) continue;
    std::vector<Failure> failures;
    const TestTable table = readTestTable(file, *bytes, program, 0, failures);
    if (!failures.empty()) continue;
    for (const TestCase& test : table.tests) {
      TestPlayOptions play;
      const std::vector<StepTimes> times = stepTimesOf(test, play.length);
      if (!times.empty()) scans += times.back().compares;
      if (scans > mostScans) return false;
      play.stopsAtFailure = false;
      play.observer = &recorder;
      play.beforeScan = [&](std::uint64_t) { recorder.beginScan(); };
      Simulator simulator(program, play.engine);
      playTest(simulator, table, test, play);
    }
  }
  return true;
}

std::string contactText(const CoverageRecorder& recorder, std::size_t leaf) {
  const bool on = recorder.contactSeen(leaf, true), off = recorder.contactSeen(leaf, false);
  return on && off ? "1 0" : on ? "1, never 0" : off ? "0, never 1" : "never run";
}

}  // namespace

Json coverageHints(const CheckedDocument& document, const std::string& path) {
  Json hints = Json::array();
  const std::vector<std::string> files = document.failure() ? std::vector<std::string>() : tablesBeside(path);
  if (files.empty()) return hints;
  const UnreadCode unread(document.program());
  if (unread.isRefused() || unread.hinderRuns()) return hints;
  const Program program = unread.executable();
  if (program.main() == nullptr) return hints;
  const CoverageMap map(program);
  CoverageRecorder recorder(map);
  const bool isWhole = runTables(program, files, recorder);
  const auto add = [&](const Instruction& instruction, std::string text, const std::string& tip) {
    if (!document.isHere(instruction.span)) return;
    const Json range = document.range(instruction.span);
    hints.push_back({{"position", *range.find("end")},
                     {"label", std::move(text)},
                     {"paddingLeft", true},
                     {"tooltip", tip + (isWhole ? "" : "; the tables are too long to be run here to their end")}});
  };
  for (std::size_t leaf = 0; leaf < map.leaves().size(); ++leaf) {
    const CoverageLeaf& contact = map.leaves()[leaf];
    if (contact.kind == LeafKind::Contact)
      add(*contact.instruction, contactText(recorder, leaf), "what the contact was in the tests beside the program");
  }
  for (std::size_t d = 0; d < map.decisions().size(); ++d) {
    const Decision& decision = map.decisions()[d];
    std::vector<std::string> open;
    std::size_t conditions = 0;
    for (std::size_t i = 0; i < decision.leaves.size(); ++i) {
      const CoverageLeaf& leaf = map.leaves()[decision.leaves[i]];
      if (leaf.kind != LeafKind::Contact) continue;
      ++conditions;
      if (recorder.pair(d, i) == PairState::None) open.push_back(map.instructionText(*leaf.instruction));
    }
    add(*decision.instruction, fmt::format("{} of {} pairs", conditions - open.size(), conditions),
        open.empty() ? "each condition has alone decided the outcome, as 1 and as 0"
                     : fmt::format("has not decided the outcome as 1 and as 0: {}", fmt::join(open, ", ")));
  }
  return hints;
}

}  // namespace rungproof
