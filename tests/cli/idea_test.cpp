// Every word that a report can print behind "by", and every verdict, has a page.
#include <gtest/gtest.h>

#include "frontend/page/idea_page.hpp"
#include "frontend/report/report.hpp"

namespace rungproof {
namespace {

TEST(Ideas, EveryVerdictHasAPage) {
  for (const Outcome outcome : {Outcome::Proved, Outcome::Violated, Outcome::Reachable, Outcome::Unreachable,
                                Outcome::HoldsToBound, Outcome::Vacuous, Outcome::NotCovered, Outcome::Unknown})
    EXPECT_NE(ideaNamed(verdictText(outcome, 7)), nullptr) << verdictText(outcome, 7);
}

TEST(Ideas, EveryMethodHasAPage) {
  for (const char* method :
       {"one scan", "simulation", "BMC", "k-induction", "7-induction", "IC3", "IC3 on words", "invariant",
        "explicit search", "held inputs", "accelerated search", "exploration", "runs of both programs"})
    EXPECT_NE(ideaNamed(method), nullptr) << method;
  EXPECT_EQ(ideaNamed("guessing"), nullptr);
}

TEST(Ideas, AreNamedOnce) {
  for (const Idea& idea : ideas()) EXPECT_EQ(ideaNamed(idea.name), &idea) << idea.name;
}

}  // namespace
}  // namespace rungproof
