// bench_tables: the bars of generated tests over the corpus, each program with what it has cost. Exit code 1: a bar is
// not met.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>

#include "tests/bench/tables/measured_tables.hpp"
#include "tests/corpus/corpus_program.hpp"

namespace {

using namespace rungproof;
using tables::Faults;
using tables::Figures;

constexpr std::size_t mostInstructions = 300;
constexpr double mostOpen = 0.01, mostSeconds = 30, mostTiming = 0.05, leastNoticed = 0.95, mostOfRandomSteps = 0.25;
constexpr std::size_t leastPrograms = 80, programsOfRandom = 20;

bool hasMissed = false;
void bar(const std::string& text, bool isMet) {
  hasMissed = hasMissed || !isMet;
  fmt::print("{:9} {}\n", isMet ? "met" : "NOT MET", text);
}

void add(Faults& sum, const Faults& more) {
  sum.noticed += more.noticed;
  sum.unnoticed += more.unnoticed;
  sum.withoutEffect += more.withoutEffect;
  sum.undecided += more.undecided;
}
std::string faultsText(const Faults& f) {
  return fmt::format("{:.1f} % of {} faults noticed ({} without effect, {} undecided)", 100 * f.share(),
                     f.noticed + f.unnoticed, f.withoutEffect, f.undecided);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Generates tests for the corpus and measures them.");
  tables::Questions questions;
  std::string match;
  std::size_t every = 1;
  bool listsMissed = false;
  app.add_option("--match", match, "only programs in whose path this stands");
  app.add_option("--every", every, "only every so manieth program")->capture_default_str();
  app.add_option("--replays", questions.replays, "of each table, at random scan times and skews")
      ->capture_default_str();
  app.add_option("--text-mutants", questions.textMutants, "of each text")->capture_default_str();
  app.add_flag("--kills,!--no-kills", questions.kills, "plant the faults of --kill");
  app.add_flag("--missed", listsMissed, "list what is open and what is not noticed");
  CLI11_PARSE(app, argc, argv);

  std::vector<Figures> all;
  Faults planted, ofText;
  std::size_t goals = 0, open = 0, rows = 0, timing = 0, failures = 0, number = 0;
  std::size_t stepsOfTests = 0, stepsOfRandom = 0, random = 0;
  double longest = 0;
  fmt::print("{:<44} {:>5} {:>6} {:>5} {:>6} {:>5} {:>6} {:>5}  {:>8} {:>8} {:>7}\n", "program", "instr", "goals",
             "open", "s", "rows", "timing", "fail", "planted", "of text", "random");
  for (const std::filesystem::path& file : test::corpusFiles()) {
    if (file.string().find(match) == std::string::npos || number++ % std::max<std::size_t>(every, 1) != 0) continue;
    questions.random = random < programsOfRandom;
    const std::optional<Figures> found = tables::measure(file, questions, mostInstructions);
    if (!found) continue;
    const Figures& f = *found;
    const auto share = [](const Faults& faults) {
      const std::size_t matter = faults.noticed + faults.unnoticed;
      return matter == 0 ? std::string("-") : fmt::format("{}/{}", faults.noticed, matter);
    };
    fmt::print("{:<44} {:>5} {:>6} {:>5} {:>6.1f} {:>5} {:>6} {:>5}  {:>8} {:>8} {:>7}\n", f.program, f.instructions,
               f.goals, f.open, f.seconds, f.rows, f.timingRows, f.failures, share(f.planted), share(f.ofText),
               questions.random ? fmt::format("{}{}", f.isRandomCut ? ">" : "", f.randomSteps) : "");
    if (listsMissed) {
      for (const std::string& goal : f.openGoals) fmt::print("    open: {}\n", goal);
      for (const std::string& fault : f.planted.missed) fmt::print("    planted: {}\n", fault);
      for (const std::string& fault : f.ofText.missed) fmt::print("    of text: {}\n", fault);
    }
    std::fflush(stdout);
    goals += f.goals;
    open += f.open;
    rows += f.rows;
    timing += f.timingRows;
    failures += f.failures;
    longest = std::max(longest, f.seconds);
    add(planted, f.planted);
    add(ofText, f.ofText);
    if (questions.random) {
      ++random;
      stepsOfTests += f.coverageSteps;
      stepsOfRandom += f.randomSteps;
    }
    all.push_back(f);
  }
  const auto percent = [](std::size_t part, std::size_t whole) {
    return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
  };
  fmt::print("\n");
  if (match.empty() && every == 1) bar(fmt::format("{} programs", all.size()), all.size() >= leastPrograms);
  bar(fmt::format("{:.2f} % of {} goals open", 100 * percent(open, goals), goals), percent(open, goals) <= mostOpen);
  bar(fmt::format("longest generation {:.1f} s of processor time", longest), longest <= mostSeconds);
  bar(fmt::format("{} failures in {} replays of each table", failures, questions.replays), failures == 0);
  bar(fmt::format("{:.1f} % of {} steps say timing", 100 * percent(timing, rows), rows),
      percent(timing, rows) <= mostTiming);
  if (questions.kills) bar("planted by --kill: " + faultsText(planted), planted.share() >= leastNoticed);
  if (questions.textMutants > 0) bar("planted in the text: " + faultsText(ofText), ofText.share() >= leastNoticed);
  bar(fmt::format("{:.0f} % of the steps of random testing, on {} programs", 100 * percent(stepsOfTests, stepsOfRandom),
                  random),
      percent(stepsOfTests, stepsOfRandom) <= mostOfRandomSteps);
  return hasMissed ? 1 : 0;
}
