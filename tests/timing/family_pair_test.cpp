// What a starter or an interlock costs to prove in its S7-300 form beside its S7-200 twin: the properties that both
// have, for the same scan times, one proof beside the other. One and a half times is what is wanted; the rows that
// allow more say what is reached.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "tests/timing/measured_proof.hpp"

namespace rungproof::test {
namespace {

constexpr double allowance = 0.02;  ///< s, of scatter and of reading the blocks of the library
constexpr int runs = 4;
constexpr double mostInSum = 2;  ///< times the S7-200 forms; 1.5 is measured
/// The watchdogs differ, and with them the longest scan where nothing is said.
const std::vector<std::string> sameScans = {"--scan-time", "1ms..500ms"};

struct Pair {
  const char* name;
  double most;  ///< times the S7-200 form
};

std::ostream& operator<<(std::ostream& out, const Pair& pair) { return out << pair.name; }

constexpr Pair pairs[] = {
    {"guard_door", 2.4},
    {"guard_locking", 1.5},
    {"press_two_hand", 1.5},
    {"reversing", 1.5},
    {"press_two_hand_faulty", 1.5},
    {"pump_alternation", 1.5},
    {"two_speed", 1.5},
    {"reversing_faulty", 1.5},
    {"wound_rotor", 3.5},
    {"star_delta", 2.5},
    {"notaus", 3.5},
    {"muting_limit", 3.5},
    {"hoist", 2.5},
    {"star_delta_dead_time", 3},
};

std::vector<std::string> linesOf(const char* folder, const std::string& name) {
  std::ifstream stream(std::filesystem::path(RUNGPROOF_SOURCE_DIR) / "corpus" / folder / (name + ".awl"),
                       std::ios::binary);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  EXPECT_FALSE(lines.empty()) << folder << "/" << name;
  return lines;
}

/// "stop drops all" of "//@ prove stop drops all: ...".
std::string propertyOf(const std::string& line) {
  for (const std::string_view start : {"//@ prove ", "//@ reach "}) {
    if (line.starts_with(start)) return line.substr(start.size(), line.find(':') - start.size());
  }
  return {};
}

std::set<std::string> propertiesOf(const std::vector<std::string>& lines) {
  std::set<std::string> names;
  for (const std::string& line : lines) names.insert(propertyOf(line));
  return names;
}

/// Without the properties that the other one does not have.
std::string shared(const std::vector<std::string>& lines, const std::set<std::string>& others) {
  std::string text;
  for (const std::string& line : lines) {
    if (others.contains(propertyOf(line))) text += line + "\n";
  }
  return text;
}

struct Cost {
  double now = 1e9, before = 1e9;  ///< s: in the S7-300 form, in that of the S7-200
  std::size_t questions = 0;
};

/// The least of several runs, which end as soon as `isEnough` is content.
template <class IsEnough>
Cost costOf(const std::string& name, IsEnough&& isEnough) {
  const std::vector<std::string> own = linesOf("s7300", name), twin = linesOf("interlocks", name);
  const std::string text = shared(own, propertiesOf(twin)), old = shared(twin, propertiesOf(own));
  Cost cost;
  for (int run = 0; run < runs && (run < 2 || !isEnough(cost)); ++run) {
    const MeasuredProof before = measureProof(old, sameScans, 1), now = measureProof(text, sameScans, 1);
    cost.questions = now.verdicts.size();
    EXPECT_EQ(cost.questions, before.verdicts.size());
    cost.before = std::min(cost.before, before.cpuSeconds);
    cost.now = std::min(cost.now, now.cpuSeconds);
  }
  return cost;
}

class FamilyPair : public ::testing::TestWithParam<Pair> {};

TEST_P(FamilyPair, CostsAtMostSoManyTimesItsTwin) {
  const double most = GetParam().most;
  const auto isWithin = [&](const Cost& cost) { return cost.now <= most * cost.before + allowance; };
  const Cost cost = costOf(GetParam().name, isWithin);
  EXPECT_GE(cost.questions, 9U);
  std::printf("%zu properties: %.3f s, S7-200 %.3f s: x%.2f of x%.1f\n", cost.questions, cost.now, cost.before,
              cost.now / cost.before, most);
  EXPECT_TRUE(isWithin(cost));
}

TEST(FamilyPairs, InSum) {
  Cost sum{0, 0, 0};
  for (const Pair& pair : pairs) {
    const Cost cost = costOf(pair.name, [](const Cost&) { return true; });
    sum.now += cost.now;
    sum.before += cost.before;
  }
  std::printf("all: %.3f s, S7-200 %.3f s: x%.2f of x%.1f\n", sum.now, sum.before, sum.now / sum.before, mostInSum);
  EXPECT_LE(sum.now, mostInSum * sum.before);
}

INSTANTIATE_TEST_SUITE_P(Corpus, FamilyPair, ::testing::ValuesIn(pairs),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace rungproof::test
