// The comparison with other provers: that a handful of obligations goes through it with one answer from all, that its
// figures are computed as they are named, and that the guide quotes the table which was measured.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "tests/bench/peers/measurement.hpp"
#include "tests/temporary_folder.hpp"

namespace rungproof::peers {
namespace {

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

constexpr double limit = 20;
constexpr const char* program = RUNGPROOF_BINARY_DIR "/rungproof";

TEST(Peers, AllGiveTheSameAnswers) {
  const test::TemporaryFolder folder;
  const std::string text =
      "ORGANIZATION_BLOCK MAIN:OB1\n//@ prove apart: never Q0.0 and Q0.1\n//@ prove free: never Q0.0\n"
      "//@ reach second: Q0.1\n//@ reach both: Q0.0 and Q0.1\nBEGIN\nNetwork 1\nLD I0.0\nAN Q0.1\n= Q0.0\n"
      "Network 2\nLD I0.1\nAN Q0.0\n= Q0.1\nEND_ORGANIZATION_BLOCK\n";
  const std::string file = folder.file("two.awl", text);
  std::vector<Row> rows;
  // The second coil sees the first one of the same scan: never both, each alone.
  const std::map<std::string, std::string> stated = {
      {"apart", "PROVED"}, {"free", "VIOLATED"}, {"second", "REACHABLE"}, {"both", "UNREACHABLE"}};
  for (const auto& [property, verdict] : stated) {
    const std::optional<Row> row =
        measure({"two coils", file, property, {}, verdict}, {program, folder.folder(), limit, 1});
    ASSERT_TRUE(row) << property << " was not exported";
    EXPECT_EQ(row->verdict, verdict) << property;
    for (std::size_t i = 0; i < row->peers.size(); ++i) {
      if (peerTable()[i].searchesOnly && answerOfVerdict(verdict) == Answer::Safe) continue;
      EXPECT_EQ(row->peers[i].answer, answerOfVerdict(verdict)) << property << " by " << peerTable()[i].name;
    }
    EXPECT_GT(row->ours.seconds, 0);
    EXPECT_GT(row->best(), 0);
    rows.push_back(*row);
  }
  const Figures figures = figuresOf(rows);
  EXPECT_EQ(figures.settled, stated.size());
  EXPECT_TRUE(figures.contradicted.empty());
  EXPECT_TRUE(figures.leftOpen.empty());
}

TEST(Peers, ObligationsComeFromEveryStratum) {
  const std::vector<Obligation> sample = corpusSample(240);
  EXPECT_GE(sample.size(), 240u);
  std::set<std::string> folders, verdicts;
  std::set<std::pair<std::string, std::string>> given;
  for (const Obligation& o : sample) {
    folders.insert(o.program.parent_path().filename().string());
    verdicts.insert(o.stated);
    EXPECT_TRUE(given.insert({o.program.string(), o.property}).second) << o.name() << " stands twice";
  }
  for (const char* folder : {"interlocks", "timers", "sequences", "data", "smart", "s7300", "plcopen", "defects"})
    EXPECT_TRUE(folders.contains(folder)) << folder;
  for (const char* verdict : {"PROVED", "VIOLATED", "REACHABLE", "UNREACHABLE"})
    EXPECT_TRUE(verdicts.contains(verdict)) << verdict;
  const test::TemporaryFolder folder;
  const std::vector<Obligation> families = familyObligations(folder.folder());
  EXPECT_GE(families.size(), 100u);
  for (const Obligation& o : families) EXPECT_TRUE(std::filesystem::exists(o.program)) << o.name();
}

Row rowOf(const std::string& verdict, double ours, std::vector<double> peers) {
  Row row;
  row.obligation = {"made", "made.awl", "p", {}, verdict == "UNKNOWN" ? "PROVED" : verdict};
  row.verdict = verdict;
  row.ours = {answerOfVerdict(verdict), ours};
  // Negative: left open at a limit of that many seconds.
  for (const double seconds : peers)
    row.peers.push_back({seconds < 0 ? Answer::Open : answerOfVerdict(row.obligation.stated), std::abs(seconds)});
  return row;
}

TEST(Peers, FiguresAreWhatTheirNamesSay) {
  const std::vector<Row> rows = {
      rowOf("PROVED", 1, {2, 4, -10, -10}),       // within
      rowOf("VIOLATED", 3, {1, 6, -10, -10}),     // lost: more than 1.5 x 1 s and 15 ms
      rowOf("PROVED", 0.02, {0.01, 1, 1, 1}),     // within: 1.5 x 10 ms and 15 ms is 30 ms
      rowOf("UNKNOWN", 10, {-10, 5, -10, -10}),   // left open
      rowOf("PROVED", 2, {-10, -10, -10, -10}),   // settled by us alone
      rowOf("UNKNOWN", 10, {-10, -10, -10, -10})  // by nobody: counts in no total
  };
  const Figures figures = figuresOf(rows);
  EXPECT_EQ(figures.obligations, 6u);
  EXPECT_EQ(figures.settled, 4u);
  EXPECT_EQ(figures.settledAlone, 1u);
  EXPECT_DOUBLE_EQ(figures.seconds, 1 + 3 + 0.02 + 10 + 2);
  EXPECT_EQ(figures.within, 4u);  // where no peer settles, none is quicker
  ASSERT_EQ(figures.lost.size(), 1u);
  EXPECT_EQ(figures.lost[0], &rows[1]);
  ASSERT_EQ(figures.leftOpen.size(), 1u);
  EXPECT_EQ(figures.leftOpen[0], &rows[3]);
  EXPECT_TRUE(figures.contradicted.empty());
  const PeerFigures& first = figures.peers[0];
  EXPECT_EQ(first.settled, 3u);
  EXPECT_DOUBLE_EQ(first.seconds, 2 + 1 + 0.01 + 10 + 10);
  EXPECT_DOUBLE_EQ(first.ratio, 16.02 / 23.01);
  EXPECT_DOUBLE_EQ(first.ratioOfBoth, 4.02 / 3.01);
  EXPECT_DOUBLE_EQ(first.median, 2);  // of 0.5, 3 and 2
  EXPECT_DOUBLE_EQ(first.lowQuartile, 1.25);
  EXPECT_DOUBLE_EQ(first.highQuartile, 2.5);
  EXPECT_EQ(figures.bestPeer, 0u);  // 23.01 s; the second takes 26 s, the others more
}

TEST(Peers, AContradictionShows) {
  std::vector<Row> rows = {rowOf("PROVED", 1, {1, 1, 1, 1}), rowOf("PROVED", 1, {1, 1, 1, 1})};
  rows[1].peers[2].answer = Answer::Unsafe;
  const Figures figures = figuresOf(rows);
  ASSERT_EQ(figures.contradicted.size(), 1u);
  EXPECT_EQ(figures.contradicted[0], &rows[1]);
  EXPECT_NE(textOf(figures).find("contradictions: 1\n"), std::string::npos);
}

TEST(Peers, ReportsAreWellFormed) {
  const std::vector<Row> rows = {rowOf("PROVED", 1, {2, 4, -10, -10}), rowOf("VIOLATED", 3, {1, 6, -10, 2})};
  const Figures figures = figuresOf(rows);
  std::size_t tableRows = 0;
  for (const std::string& line : linesOf(markdownOf(figures, {"v1", "2020-01-31", 20, 25}))) {
    if (!line.starts_with("|")) continue;
    EXPECT_EQ(std::ranges::count(line, '|'), 8) << line;
    ++tableRows;
  }
  EXPECT_EQ(tableRows, 2 + peerTable().size());
  const auto fields = [](const std::string& line) { return std::ranges::count(line, ','); };
  EXPECT_EQ(fields(historyHead()), fields(historyLine(figures, {"v1", "2020-01-31", 20, 25})));
  const std::vector<std::string> csv = linesOf(rowsAsCsv(rows));
  ASSERT_EQ(csv.size(), 3u);
  EXPECT_EQ(fields(csv[0]), fields(csv[1]));
}

/// The fields of the history's last line, by the names at its head.
std::map<std::string, std::string> lastOfHistory() {
  std::ifstream file(RUNGPROOF_SOURCE_DIR "/tests/bench/history.csv");
  std::stringstream text;
  text << file.rdbuf();
  const std::vector<std::string> lines = linesOf(text.str());
  std::map<std::string, std::string> fields;
  if (lines.size() < 2) return fields;
  std::istringstream head(lines.front()), last(lines.back());
  for (std::string name, value; std::getline(head, name, ',') && std::getline(last, value, ',');) fields[name] = value;
  return fields;
}

TEST(Peers, TheGuideQuotesTheLastMeasurement) {
  std::map<std::string, std::string> last = lastOfHistory();
  ASSERT_EQ(last.size(), 16U);
  std::ifstream file(RUNGPROOF_SOURCE_DIR "/frontend/guide/80_measured.md");
  std::stringstream chapter;
  chapter << file.rdbuf();
  const auto share = fmt::format("{:.1f} %. Lost: {}. Left open where a peer settles: {}.",
                                 100 * std::stod(last["within"]), last["lost"], last["left_open"]);
  for (const std::string& quoted : {"Measured " + last["date"] + ": " + last["obligations"] + " obligations", share,
                                    fmt::format("rungproof settles {} in {:.1f} s, {} of them alone", last["settled"],
                                                std::stod(last["seconds"]), last["alone"]),
                                    fmt::format("| `{}` |", last["best_peer"]), "version " + last["version"]})
    EXPECT_NE(chapter.str().find(quoted), std::string::npos) << quoted;
  EXPECT_GE(std::stoi(last["obligations"]), 300);
  EXPECT_LE(std::stod(last["ratio"]), 0.5);
  EXPECT_EQ(last["left_open"], "0");
}

TEST(Peers, OutputOfAbcIsUnderstood) {
  EXPECT_EQ(answerOfAbc("Property proved.\nStatus = 1  Frames = 1   Cex is not defined.\n"), Answer::Safe);
  EXPECT_EQ(answerOfAbc("Status = 0  Frames = 0   CEX: Po =   0\n"), Answer::Unsafe);
  EXPECT_EQ(answerOfAbc("Status = -1  Frames = 12   Cex is not defined.\n"), Answer::Open);
  EXPECT_EQ(answerOfAbc(""), Answer::Open);
}

TEST(Peers, AProcessIsCutAtItsLimit) {
  const ProcessRun run = runProcess({"sh", "-c", "while :; do :; done"}, 1);
  EXPECT_TRUE(run.isCut);
  EXPECT_GE(run.seconds, 0.9);
  EXPECT_LE(run.seconds, 2.5);
  EXPECT_FALSE(runProcess({"sh", "-c", "echo done"}, 1).isCut);
}

}  // namespace
}  // namespace rungproof::peers
