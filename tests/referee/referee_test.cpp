// `prove` against the referee: random programs with devices, interrupts, time and system bits; a run of the referee
// that breaks a PROVED or reaches an UNREACHABLE is a failure, printed with its seeds, its smallest program and the
// run. A longer campaign: REFEREE_PAIRS=5000 REFEREE_SEED=7 build/release/test_referee --gtest_filter=Referee.*
// REFEREE_IN_SCAN=1 lets devices change what the program reads inside a scan and before its end too.
// REFEREE_PROVER names another executable, REFEREE_TOPICS=0,2,4 other topics (numbers of enum Topic).
#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>
#include <sstream>

#include "comparison.hpp"
#include "tests/temporary_folder.hpp"

namespace rungproof::referee {
namespace {

std::string environmentOr(const char* name, const std::string& otherwise) {
  const char* value = std::getenv(name);
  return value == nullptr ? otherwise : value;
}

std::vector<Topic> topicsOf(const std::string& numbers) {
  std::vector<Topic> topics;
  std::istringstream list(numbers);
  for (std::string number; std::getline(list, number, ',');) topics.push_back(static_cast<Topic>(std::stoi(number)));
  return topics;
}

TEST(Referee, NoRunBreaksAVerdict) {
  const test::TemporaryFolder folder;
  Settings settings;
  settings.prover = environmentOr("REFEREE_PROVER", RUNGPROOF_EXECUTABLE);
  settings.folder = folder.path("");
  const int pairs = std::stoi(environmentOr("REFEREE_PAIRS", "400"));
  const std::uint64_t first = std::stoull(environmentOr("REFEREE_SEED", "1"));
  const std::vector<Topic> topics = topicsOf(environmentOr("REFEREE_TOPICS", "0,1,2,3,4,5,6,7,8,9,10,11,12,13"));
  const bool inScan = environmentOr("REFEREE_IN_SCAN", "0") == "1";
  settings.open.portsInScan = settings.open.portsBeforeEnd = settings.open.countersInScan = inScan;
  // Both starts of SM0.4 to SM0.6: with REFEREE_READINGS=0 the first one only.
  settings.open.scanClock = environmentOr("REFEREE_READINGS", "1") == "1";
  Outcomes all;
  for (std::uint64_t seed = first; all.pairs < pairs && all.complaints.size() < 5; ++seed) {
    const Case drawn = drawCase(seed, topics, settings);
    const Outcomes outcomes = compare(drawn, seed, settings);
    all.add(outcomes);
    for (const Contradiction& found : outcomes.contradictions) {
      ADD_FAILURE() << "seed " << seed << "\n" << shrink(drawn, found, settings).report();
    }
  }
  for (const std::string& complaint : all.complaints) ADD_FAILURE() << complaint;
  for (const std::string& witness : all.impossible) ADD_FAILURE() << witness;
  std::cout << "seeds from " << first << ": " << all.pairs << " pairs, " << all.contradictions.size()
            << " contradictions, " << all.proved << " claims, " << all.shown << " witnesses (" << all.reproduced
            << " met by the referee too), " << all.undecided << " undecided\n";
  EXPECT_GE(all.pairs, pairs);
  // Undecided is honest, but a comparison of undecided properties compares nothing.
  EXPECT_LE(all.undecided * 4, all.pairs);
}

}  // namespace
}  // namespace rungproof::referee
