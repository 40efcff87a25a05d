// Places of statements that stand in comments: findings and properties point at the words themselves, however the
// comment is written.
#include <gtest/gtest.h>

#include "frontend/input/program_input.hpp"

namespace rungproof {
namespace {

/// The words that the first finding of the property reader marks.
std::string markedIn(const std::string& name, const std::string& text) {
  Program program = readText(name, text);
  program.findings.clear();
  readProperties(program, {}, lookupIn(program));
  return program.findings.empty() ? "" : std::string(program.sources->text(program.findings[0].span));
}

TEST(DirectivePlace, MistakesAreMarkedWhereTheyStand) {
  EXPECT_EQ(markedIn("a.awl", "Network 1\nLD I0.0 //@ prove p: never Q0.0 and Nobody\n= Q0.0\n"), "Nobody");
  EXPECT_EQ(markedIn("a.awl", "Network 1\n//@prove p: never Nobody\nLD I0.0\n= Q0.0\n"), "Nobody");
  EXPECT_EQ(markedIn("a.awl", "Network 1 // Größe\n//@ \t prove p: never Nobody\nLD I0.0\n= Q0.0\n"), "Nobody");
  EXPECT_EQ(markedIn("a.awl", "//@ reach r: Q0.0 and Nobody\nNetwork 1\nLD I0.0\n= Q0.0\n"), "Nobody");
}

TEST(DirectivePlace, APropertyIsItsStatement) {
  Program program = readText("a.awl", "Network 1\n//@   prove p: never Q0.0 and Q0.1  \nLD I0.0\n= Q0.0\n");
  const PropertySet set = readProperties(program, {}, lookupIn(program));
  ASSERT_EQ(set.properties.size(), 1u);
  EXPECT_EQ(program.sources->text(set.properties[0].span), "prove p: never Q0.0 and Q0.1");
}

}  // namespace
}  // namespace rungproof
