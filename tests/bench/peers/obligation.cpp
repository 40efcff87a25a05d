// Obligations from the heads of the corpus, from the prover's own report of its times, and from generators.
#include "tests/bench/peers/obligation.hpp"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/bench/peers/contender.hpp"
#include "tests/corpus/corpus_program.hpp"
#include "tests/timing/obligation_families.hpp"

namespace rungproof::peers {

namespace {

std::vector<std::string> commandLineOptions(const std::filesystem::path& file) {
  std::vector<std::string> words;
  for (const auto& [name, value] : test::optionsOf(file)) words.insert(words.end(), {name, value});
  return words;
}

/// By stratum: folder of the corpus, verdict.
std::map<std::string, std::vector<Obligation>> strataOfCorpus() {
  std::map<std::string, std::vector<Obligation>> strata;
  for (const std::filesystem::path& file : test::corpusFiles()) {
    const std::vector<std::string> options = commandLineOptions(file);
    for (const auto& [property, verdict] : test::trueVerdicts(file)) {
      if (verdict == "NOT COVERED") continue;
      strata[file.parent_path().filename().string() + " " + verdict].push_back(
          {"corpus", file, property, options, verdict});
    }
  }
  return strata;
}

struct Generated {
  std::string family;
  int size;
  std::string text;
  std::string stated = "PROVED";
  std::vector<std::string> options{};
};

std::vector<Generated> generatedPrograms() {
  std::vector<Generated> programs;
  const std::vector<std::string> oneTick{"--scan-time", "100ms"};
  for (const int n : {4, 16, 64}) {
    programs.push_back({"starter", n, families::starter(n), "PROVED", oneTick});
    programs.push_back({"phase", n, families::phase(n), "PROVED", oneTick});
    programs.push_back({"chain", n, families::chain(n), "PROVED", oneTick});
  }
  for (const int preset : {100, 1000, 30000})
    programs.push_back({"timed preset", preset, families::timed(1, preset), "PROVED", oneTick});
  for (const int n : {4, 16}) programs.push_back({"timed", n, families::timed(n, 100), "PROVED", oneTick});
  for (const families::ObligationFamily& family : families::obligationFamilies()) {
    for (const int n : family.sizes)
      programs.push_back({std::string(family.name), n, family.program(n), std::string(family.verdict)});
  }
  return programs;
}

}  // namespace

std::vector<Obligation> corpusSample(std::size_t count) {
  const auto strata = strataOfCorpus();
  std::size_t all = 0;
  for (const auto& [stratum, obligations] : strata) all += obligations.size();
  std::vector<Obligation> sample;
  for (const auto& [stratum, obligations] : strata) {
    const std::size_t share =
        std::clamp<std::size_t>((obligations.size() * count + all / 2) / all, 1, obligations.size());
    for (std::size_t i = 0; i < share; ++i) sample.push_back(obligations[i * obligations.size() / share]);
  }
  return sample;
}

std::vector<Obligation> slowestOfCorpus(std::size_t count, const std::string& rungproof) {
  std::vector<std::pair<double, Obligation>> timed;
  for (const std::filesystem::path& file : test::corpusFiles()) {
    const std::map<std::string, std::string> verdicts = test::trueVerdicts(file);
    if (verdicts.empty()) continue;
    const std::vector<std::string> options = commandLineOptions(file);
    std::vector<std::string> command{rungproof, "prove", file.string(), "--isolated", "--quiet", "--format", "json"};
    command.insert(command.end(), options.begin(), options.end());
    constexpr double longest = 600;  // s; more than any program of the corpus takes
    const std::string output = runProcess(command, longest).output;
    const nlohmann::json report =
        nlohmann::json::parse(output.substr(std::min(output.find('{'), output.size())), nullptr, false);
    if (!report.is_object()) continue;
    for (const auto& property : report["properties"]) {
      const auto verdict = verdicts.find(property["name"].get<std::string>());
      if (verdict == verdicts.end() || verdict->second == "NOT COVERED") continue;
      timed.push_back({property["seconds"].get<double>(), {"slowest", file, verdict->first, options, verdict->second}});
    }
  }
  std::ranges::stable_sort(timed, [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<Obligation> slowest;
  for (std::size_t i = 0; i < std::min(count, timed.size()); ++i) slowest.push_back(timed[i].second);
  return slowest;
}

std::vector<Obligation> familyObligations(const std::filesystem::path& folder) {
  std::vector<Obligation> obligations;
  for (const Generated& generated : generatedPrograms()) {
    std::string stem = generated.family + " " + std::to_string(generated.size);
    std::ranges::replace(stem, ' ', '_');
    const std::filesystem::path file = folder / (stem + ".awl");
    std::ofstream(file) << generated.text;
    const std::vector<Property> goals = test::goalsOf(test::corpusInput(file).properties);
    std::set<std::size_t> picked{0, goals.size() / 2, goals.size() - 1};
    for (const std::size_t i : picked)
      obligations.push_back({generated.family, file, goals.at(i).name, generated.options, generated.stated});
  }
  return obligations;
}

}  // namespace rungproof::peers
