// What lint says of an S7-300/400 beside its proofs: nothing twice, and nothing as confirmed that nobody has confirmed.
#include "tests/step7/run7.hpp"

namespace rungproof {
namespace {

using test7::block, test7::Output;

Output lintOf(const std::string& statements, const std::vector<std::string>& more) {
  const test::TemporaryFolder folder;
  folder.file("main.awl", block(1, statements));
  std::vector<std::string> arguments = {"lint", folder.path("main.awl")};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return test7::run(arguments);
}

// The RLO is never on, nor is the bit of the timer, so it never goes off either.
TEST(ProvedLint, ATimerThatNeverFiresIsToldOnce) {
  const Output output = lintOf("A I 0.0;AN I 0.0;L S5T#10S;SD T 1;A T 1;= Q 0.0", {"--prove", "--select", "TIM008"});
  EXPECT_TRUE(output.has("the bit of T1 can never be 1")) << output.text;
  EXPECT_FALSE(output.has("never returns to 0")) << output.text;
}

// Held for ever once it is on: the other answer stays.
TEST(ProvedLint, ATimerThatNeverGoesOffIsTold) {
  const Output output =
      lintOf("A I 0.0;O M 10.0;= M 10.0;A M 10.0;L S5T#20MS;SD T 1;A T 1;= Q 0.0", {"--prove", "--select", "TIM008"});
  EXPECT_FALSE(output.has("can never be 1")) << output.text;
  EXPECT_TRUE(output.has("once on, the bit of T1 never returns to 0")) << output.text;
}

TEST(ProvedLint, WhatMayBeIsUnconfirmed) {
  const Output division = lintOf("L MW 0;L MW 2;/I;T MW 4", {"--select", "ARI001", "--format", "json"});
  EXPECT_TRUE(division.has("\"confirmed\": false")) << division.text;
  const Output zero = lintOf("L MW 0;L 0;/I;T MW 4", {"--select", "ARI001", "--format", "json"});
  EXPECT_TRUE(zero.has("\"confirmed\": true")) << zero.text;
  const Output product = lintOf("L MW 0;L MW 2;*I;T MW 4", {"--select", "ARI002", "--format", "json"});
  EXPECT_TRUE(product.has("\"confirmed\": false")) << product.text;
}

}  // namespace
}  // namespace rungproof
