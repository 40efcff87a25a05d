// The table of stated cases on the reference engine.
#include <gtest/gtest.h>

#include "tests/agreement7/case_run.hpp"

namespace rungproof::agreement7 {
namespace {

TEST(Cases7, EngineDoesWhatTheTableStates) {
  const std::vector<naive7::Case> cases =
      naive7::readCases(std::string(RUNGPROOF_SOURCE_DIR) + "/tests/data/s7300_cases.tsv");
  for (const naive7::Case& c : cases) EXPECT_EQ(differences(c), "") << c.name();
  EXPECT_GT(cases.size(), 2000u);
}

}  // namespace
}  // namespace rungproof::agreement7
