// Each call that the program makes of the system can fail: memory, files, processes, threads. Whatever fails, the
// program ends by itself with an exit code of the contract, says why, changes no verdict, and leaves each file as it
// was or whole. RUNGPROOF_FAULTS_PER_KIND=N: so many places of each kind in each command, from a seed that is printed;
// without it a few of each. "7+" means that the seventh call and all behind it fail.
#include <gtest/gtest.h>

#include <cctype>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <optional>
#include <random>

#include "tests/faults/fault_run.hpp"

namespace rungproof {
namespace {

using test::Contents;
using test::FaultRun;

constexpr std::uint64_t usualPlaces = 3;

std::uint64_t placesPerKind() {
  const char* const text = std::getenv("RUNGPROOF_FAULTS_PER_KIND");
  return text == nullptr ? usualPlaces : std::strtoull(text, nullptr, 10);
}

const char* const station =
    "ORGANIZATION_BLOCK MAIN:OB1\n//@ prove both: never Q0.0 and Q0.1\n//@ prove off: never Q0.0\n//@ reach on: Q0.1\n"
    "BEGIN\nNETWORK 1\nLD I0.0\nO Q0.0\nAN I0.1\n= Q0.0\nNETWORK 2\nLDN Q0.0\nA I0.2\nTON T37, 10\n"
    "NETWORK 3\nLD T37\nAN Q0.0\n= Q0.1\nEND_ORGANIZATION_BLOCK\n";
const char* const plain = "Network 1\nLD I0.0\nAN I0.1\n= Q0.0\n";

/// What lies in the folder; old.* are outputs of an earlier run.
Contents folder() {
  return {{"station.awl", station},
          {"plain.awl", plain},
          {"changed.awl", "Network 1\nLD I0.0\nAN I0.2\n= Q0.0\n"},
          {"table.csv", "test,wait,set I0.0,set I0.1,expect Q0.0\nstart,2 scans,1,0,1\nstart,2 scans,0,1,0\n"},
          {"stimulus.csv", "scan,I0.0,I0.1\n1,0,0\n2,1,0\n3,0,1\n"},
          {"old.json", "{}\n"},
          {"old.csv", "scan,Q0.0\n"},
          {"old.html", "<html></html>\n"}};
}

std::string withoutNumbers(const std::string& text) {
  std::string result;
  for (const char c : text) {
    const bool isDigit = std::isdigit(static_cast<unsigned char>(c)) != 0;
    if (!isDigit || result.empty() || result.back() != '#') result += isDigit ? '#' : c;
  }
  return result;
}

/// "both" -> "PROVED", from the lines of the report.
std::map<std::string, std::string> verdictsIn(const std::string& output) {
  std::map<std::string, std::string> verdicts;
  std::istringstream lines(output);
  for (std::string line; std::getline(lines, line);) {
    for (const std::string verdict : {"PROVED", "VIOLATED", "REACHABLE", "UNREACHABLE", "EQUAL", "DIFFERENT"}) {
      if (!line.starts_with(verdict + " ")) continue;
      const std::string name = line.substr(line.find_first_not_of(' ', verdict.size()));
      verdicts[name.substr(0, name.find("  "))] = verdict;
    }
  }
  return verdicts;
}

/// Whether a file has its end.
bool isWhole(const std::string& name, const std::string& text) {
  if (name.ends_with(".json")) return nlohmann::json::accept(text);
  if (name.ends_with(".html")) return text.ends_with("</html>\n");
  return text.ends_with("\n");
}

/// What is wrong with a run in which a call failed; empty: nothing.
std::string problemOf(const FaultRun& usual, const FaultRun& run, const std::string& kind) {
  if (run.exit < 0) return "it was ended by a signal, or did not end";
  if (run.exit > 3) return "it has no exit code of the contract";
  const Contents before = folder();
  bool hasReport = false;
  for (const auto& [name, text] : run.files) {
    const auto old = before.find(name);
    const bool isNew = old == before.end() || old->second != text;
    hasReport = hasReport || isNew;
    if (name.ends_with(".part")) return name + " is left";
    if (isNew && !name.starts_with("kept/") && !isWhole(name, text)) return name + " is not whole: " + text;
  }
  for (const auto& [name, text] : before) {
    if (!run.files.contains(name)) return name + " is gone";
  }
  if (run.output.find("internal error") != std::string::npos) return "it is taken for a mistake of the program";
  if (run.exit != usual.exit && run.output.empty() && !hasReport) return "it does not say why";
  const auto usualVerdicts = verdictsIn(usual.output);
  for (const auto& [name, verdict] : verdictsIn(run.output)) {
    const auto known = usualVerdicts.find(name);
    if (known != usualVerdicts.end() && known->second != verdict) return name + " has another verdict: " + verdict;
  }
  const bool isInvisible = kind == "short" || kind == "interrupted";
  if (isInvisible && (run.exit != usual.exit || withoutNumbers(run.output) != withoutNumbers(usual.output)))
    return "it says something else";
  return {};
}

class Faults : public ::testing::TestWithParam<std::vector<std::string>> {};

TEST_P(Faults, LeaveNoHarm) {
  const std::vector<std::string>& arguments = GetParam();
  const FaultRun usual = test::runWithFault(arguments, folder(), "");
  ASSERT_GE(usual.exit, 0) << usual.output;
  ASSERT_NE(usual.exit, 2) << usual.output;
  std::map<std::string, std::uint64_t> calls = test::countCalls(arguments, folder());
  ASSERT_GT(calls["memory"], 0U) << "the library counts nothing";
  constexpr std::uint32_t seed = 20261201;
  std::printf("seed %u\n", seed);
  std::mt19937 random(seed);
  std::uint64_t runs = 0;
  for (const auto& [kind, count] : calls) {
    const std::uint64_t places = std::min(count, placesPerKind());
    for (std::uint64_t i = 0; i < places; ++i) {
      const std::uint64_t at = places == count ? i + 1 : std::uniform_int_distribution<std::uint64_t>(1, count)(random);
      for (const char* const sign : {"", "+"}) {
        if (*sign == '+' && (kind == "short" || kind == "interrupted")) continue;
        const std::string fault = kind + ":" + std::to_string(at) + sign;
        const FaultRun run = test::runWithFault(arguments, folder(), fault);
        EXPECT_EQ(problemOf(usual, run, kind), "") << fault << ", exit " << run.exit << "\n" << run.output;
        ++runs;
      }
    }
  }
  std::printf("%llu runs\n", static_cast<unsigned long long>(runs));
}

using Words = std::vector<std::string>;
INSTANTIATE_TEST_SUITE_P(
    OfCommands, Faults,
    ::testing::Values(
        Words{"lint", "station.awl", "--format", "json=old.json", "--format", "human"},
        Words{"lint", "--prove", "station.awl", "--jobs", "1", "--format", "html=old.html", "--format", "human"},
        Words{"prove", "station.awl", "--builtin", "--jobs", "1", "--timeout", "5s", "--traces", "runs",
              "--certificate", "proofs", "--tables", "tables", "--format", "json=old.json", "--format", "html=old.html",
              "--format", "human"},
        Words{"prove", "station.awl", "--jobs", "2", "--timeout", "5s", "--cache", "kept"},
        Words{"sim", "plain.awl", "--stimulus", "stimulus.csv", "--trace", "old.csv"},
        Words{"test", "plain.awl", "--table", "table.csv", "--coverage"},
        Words{"test", "plain.awl", "--generate", "made", "--jobs", "1"},
        Words{"equiv", "plain.awl", "changed.awl", "--jobs", "1", "--trace", "old.csv"},
        Words{"diff", "plain.awl", "changed.awl", "--jobs", "1"}, Words{"export", "station.awl", "--format", "smt2"},
        Words{"show", "station.awl", "--svg"}, Words{"xref", "station.awl"}, Words{"check", "station.awl"},
        Words{"compare", "stimulus.csv", "stimulus.csv", "--trace", "old.html"}, Words{"explain", "STK002"}),
    [](const auto& instance) {
      std::string name = instance.param[0];
      return name + std::to_string(instance.index);
    });

}  // namespace
}  // namespace rungproof
