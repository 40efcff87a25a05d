// What a starter or an interlock costs to prove in its S7-300 form beside its S7-200 twin: the properties that both
// have, one proof beside the other. One and a half times is what is wanted; the rows that allow more say what is
// reached.
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
    {"wound_rotor", 9},
    {"star_delta", 3},
    {"notaus", 4.5},
    {"muting_limit", 4.5},
    {"hoist", 4},
    {"star_delta_dead_time", 10},
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

class FamilyPair : public testing::TestWithParam<Pair> {};

TEST_P(FamilyPair, CostsAtMostSoManyTimesItsTwin) {
  const std::vector<std::string> own = linesOf("s7300", GetParam().name), twin = linesOf("interlocks", GetParam().name);
  const std::string text = shared(own, propertiesOf(twin)), old = shared(twin, propertiesOf(own));
  double least = 1e9, leastOld = 1e9;
  std::size_t questions = 0;
  const auto isWithin = [&] { return least <= GetParam().most * leastOld + allowance; };
  for (int run = 0; run < runs && (run < 2 || !isWithin()); ++run) {
    const MeasuredProof before = measureProof(old, {}, 1), now = measureProof(text, {}, 1);
    questions = now.verdicts.size();
    EXPECT_EQ(questions, before.verdicts.size());
    leastOld = std::min(leastOld, before.cpuSeconds);
    least = std::min(least, now.cpuSeconds);
  }
  EXPECT_GE(questions, 9U);
  std::printf("%zu properties: %.3f s, S7-200 %.3f s: x%.2f of x%.1f\n", questions, least, leastOld, least / leastOld,
              GetParam().most);
  EXPECT_TRUE(isWithin());
}

INSTANTIATE_TEST_SUITE_P(Corpus, FamilyPair, testing::ValuesIn(pairs),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace rungproof::test
