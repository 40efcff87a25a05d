// The frames of IC3, which both of its engines share.
#include "analysis/bits/lemma_frames.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rungproof {
namespace {

constexpr Lit a = positive(1), b = positive(2), c = positive(3);

TEST(LemmaFrames, ALemmaReplacesThoseThatSayLessUpToItsLevel) {
  LemmaFrames frames;
  for (int i = 0; i < 3; ++i) frames.addFrame();
  frames.add({a, b}, 1);
  frames.add({a, c}, 3);
  frames.add({a}, 2);
  EXPECT_TRUE(frames.at(1).empty());
  EXPECT_EQ(frames.at(2), (std::vector<Cube>{{a}}));
  EXPECT_EQ(frames.at(3), (std::vector<Cube>{{a, c}})) << "it holds where {a} is not known to";
  EXPECT_EQ(frames.size(), 2u);
  EXPECT_EQ(frames.above(2), (std::vector<Cube>{{a, c}}));
  EXPECT_TRUE(frames.isBlocked({a, b}, 2));
  EXPECT_FALSE(frames.isBlocked({a, b}, 3));
}

TEST(LemmaFrames, PropagationFindsTheLevelFromWhichOnEverythingHolds) {
  LemmaFrames frames;
  for (int i = 0; i < 3; ++i) frames.addFrame();
  frames.add({a}, 1);
  frames.add({b}, 1);
  const auto all = [](const Cube& lemma, int) { return std::optional(lemma); };
  const auto onlyA = [](const Cube& lemma, int) { return lemma[0] == a ? std::optional(lemma) : std::nullopt; };
  const auto add = [&](const Cube& core, int level) { frames.add(core, level); };
  EXPECT_EQ(frames.propagate(onlyA, add), 2) << "{b} stays at 1, {a} goes on to 3 and leaves 2 empty";
  EXPECT_EQ(frames.at(3), (std::vector<Cube>{{a}}));
  EXPECT_EQ(frames.propagate(all, add), 1);
  EXPECT_EQ(frames.above(1).size(), 2u);
}

TEST(LemmaFrames, ActivitiesStayFiniteAndInOrder) {
  LemmaFrames frames;
  frames.addFrame();
  frames.add({a}, 1);
  frames.add({b}, 1);
  for (int i = 0; i < 100'000; ++i) frames.add({b, c}, 1);
  EXPECT_TRUE(std::isfinite(frames.activity(b)));
  EXPECT_GT(frames.activity(c), 0);
  EXPECT_GT(frames.activity(b), frames.activity(a)) << "recent lemmas count more";
}

}  // namespace
}  // namespace rungproof
