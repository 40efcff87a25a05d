// bench_peers: our prover against berkeley-abc on our own exports of the same obligations. Prints the figures, rewrites
// the table that the guide quotes and adds a line to the history where these are asked for. Exit code 1: a contradiction.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <iostream>

#include "tests/bench/peers/measurement.hpp"
#include "tests/corpus/command_output.hpp"
#include "tests/temporary_folder.hpp"

namespace {

using namespace rungproof;

std::string today() {
  const std::time_t now = std::time(nullptr);
  std::array<char, 16> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%d", std::localtime(&now));
  return text.data();
}

std::string versionOfSources() {
  std::string text = test::outputOf("git -C " RUNGPROOF_SOURCE_DIR " rev-parse --short HEAD");
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

/// Puts the sample, whose neighbours are of one folder, and what follows it into an order of which each beginning has
/// something of everything; the same in every run.
void mix(std::vector<peers::Obligation>& obligations, std::size_t ofSample) {
  std::vector<std::pair<double, std::size_t>> places;
  const auto spread = [&](std::size_t from, std::size_t to) {
    constexpr double golden = 0.6180339887498949;
    for (std::size_t i = from; i < to; ++i) places.push_back({std::fmod(static_cast<double>(i) * golden, 1.0), i});
  };
  spread(0, ofSample);
  spread(ofSample, obligations.size());
  std::ranges::sort(places);
  std::vector<peers::Obligation> mixed;
  for (const auto& [place, i] : places) mixed.push_back(std::move(obligations[i]));
  obligations = std::move(mixed);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Compares our prover with berkeley-abc on the same obligations; processor time of whole processes.");
  const test::TemporaryFolder folder;
  peers::Measurement measurement{RUNGPROOF_BINARY_DIR "/rungproof", folder.folder()};
  std::size_t corpus = 240, slowest = 25;
  std::string markdown, history, rowsFile, match, version = versionOfSources(), date = today();
  bool families = true;
  double minutes = 0;
  app.add_option("--corpus", corpus, "obligations of the corpus, evenly from its strata")->capture_default_str();
  app.add_option("--slowest", slowest, "slowest properties of the corpus")->capture_default_str();
  app.add_flag("--families,!--no-families", families, "generated families");
  app.add_option("--match", match, "only obligations in whose group or name this stands");
  app.add_option("--rungproof", measurement.rungproof, "the program that is measured")->capture_default_str();
  app.add_option("--limit", measurement.limit, "s of processor time for each run")->capture_default_str();
  app.add_option("--patience", measurement.patience, "cut peers at so many times our time")->capture_default_str();
  app.add_option("--rounds", measurement.rounds, "runs of what takes little time")->capture_default_str();
  app.add_option("--minutes", minutes, "begin no obligation later than that, and report on those before; 0: all")
      ->capture_default_str();
  app.add_option("--markdown", markdown, "FILE for the table");
  app.add_option("--history", history, "FILE that gets another line");
  app.add_option("--rows", rowsFile, "FILE for the times of each obligation");
  app.add_option("--version-name", version, "of what is measured, for the history")->capture_default_str();
  CLI11_PARSE(app, argc, argv);

  std::vector<peers::Obligation> obligations = peers::corpusSample(corpus);
  const auto add = [&](std::vector<peers::Obligation> more) {
    for (peers::Obligation& obligation : more) {
      const bool isKnown = std::ranges::any_of(obligations, [&](const peers::Obligation& known) {
        return known.program == obligation.program && known.property == obligation.property;
      });
      if (!isKnown) obligations.push_back(std::move(obligation));
    }
  };
  const std::size_t ofSample = obligations.size();
  if (slowest > 0) add(peers::slowestOfCorpus(slowest, measurement.rungproof));
  if (families) add(peers::familyObligations(folder.folder()));
  mix(obligations, ofSample);
  std::erase_if(obligations, [&](const peers::Obligation& o) {
    return (o.group + " " + o.name()).find(match) == std::string::npos;
  });

  const auto begin = std::chrono::steady_clock::now();
  const auto isOver = [&] {
    return minutes > 0 && std::chrono::steady_clock::now() - begin > std::chrono::duration<double>(60 * minutes);
  };
  std::vector<peers::Row> rows;
  std::size_t done = 0, notExported = 0;
  for (const peers::Obligation& obligation : obligations) {
    if (isOver()) break;
    std::optional<peers::Row> row = peers::measure(obligation, measurement);
    ++done;
    if (!row) {
      ++notExported;
      continue;
    }
    std::cerr << fmt::format("{} of {}: {:.3f} s, best peer {:.3f} s, {} {}\n", done, obligations.size(),
                             row->ours.seconds, row->best(), row->verdict, obligation.name());
    rows.push_back(std::move(*row));
    if (!rowsFile.empty()) std::ofstream(rowsFile) << peers::rowsAsCsv(rows);
  }
  const peers::Figures figures = peers::figuresOf(rows);
  std::cout << peers::textOf(figures) << "cannot be exported: " << notExported << '\n';
  const peers::Conditions conditions{version, date, measurement.limit, measurement.patience};
  if (!markdown.empty()) std::ofstream(markdown) << peers::markdownOf(figures, conditions);
  if (!history.empty()) {
    const bool isNew = !std::filesystem::exists(history);
    std::ofstream(history, std::ios::app)
        << (isNew ? peers::historyHead() : "") << peers::historyLine(figures, conditions);
  }
  return figures.contradicted.empty() ? 0 : 1;
}
