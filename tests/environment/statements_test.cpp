// What properties say of one moment: the whole before its parts, and no more of a long chain than can be kept.
#include <gtest/gtest.h>

#include "analysis/encoding/state_rule.hpp"
#include "tests/environment/asked.hpp"

namespace rungproof {
namespace {

std::vector<Expr> statementsOf(const std::string& property) {
  Program program = readText("test.awl", "ORGANIZATION_BLOCK MAIN:OB1\n//@ prove p: " + property +
                                             "\nBEGIN\nNetwork 1\nLD I0.0\n= Q0.0\nEND_ORGANIZATION_BLOCK\n");
  const PropertySet set = readProperties(program, {}, lookupIn(program));
  EXPECT_EQ(set.properties.size(), 1U);
  return statementsIn(set.properties.at(0));
}

TEST(Statements, TheWholeStandsBeforeItsParts) {
  // "I0.0 or Q0.0", "Q0.0" and "I0.0", each behind its opposite, which has one node more.
  std::vector<std::size_t> nodes;
  for (const Expr& statement : statementsOf("I0.0 or Q0.0")) nodes.push_back(statement.nodes.size());
  EXPECT_EQ(nodes, (std::vector<std::size_t>{4, 3, 2, 1, 2, 1}));
}

TEST(Statements, AChainOfThousandsIsKeptInPart) {
  std::string chain = "Q0.0";
  for (int i = 0; i < 3000; ++i) chain += " or I0.0";
  const std::vector<Expr> statements = statementsOf(chain);
  std::size_t nodes = 0;
  for (const Expr& statement : statements) nodes += statement.nodes.size();
  EXPECT_LE(nodes, 20'000U);  // all parts would have nine million
  ASSERT_GE(statements.size(), 2U);
  EXPECT_EQ(statements[1].nodes.size(), 6001U);  // 3001 addresses and 3000 operators
}

}  // namespace
}  // namespace rungproof
