// The type that a symbol table gives an address counts in rules as that of a declaration does.
#include "tests/step7/run7.hpp"

namespace rungproof {
namespace {

using test7::block, test7::Output;

Output lintOf(const std::string& statements, const std::string& rows) {
  const test::TemporaryFolder folder;
  folder.file("main.awl", block(1, statements));
  folder.file("names.sdf", rows);
  return test7::run({"lint", folder.path("main.awl"), folder.path("names.sdf")});
}

const std::string rows =
    "\"rs\",\"MD     30\",\"REAL\",\"\"\n\"is\",\"MW     34\",\"INT\",\"\"\n\"s5s\",\"MW     36\",\"S5TIME\",\"\"\n"
    "\"tms\",\"MD     38\",\"TIME\",\"\"\n\"ws\",\"MW     42\",\"WORD\",\"\"\n";

TEST(SymbolTypes, MixedNumbersAreFound) {
  EXPECT_TRUE(lintOf("L \"rs\";L 1;+I;T MW 20", rows).has("ARI008"));
  EXPECT_TRUE(lintOf("L \"rs\";T \"is\"", rows).has("ARI008"));
  EXPECT_TRUE(lintOf("L \"is\";L 1.0;>R;= M 0.2", rows).has("ARI008"));
  EXPECT_TRUE(lintOf("A M 0.3;L \"tms\";SD T 1", rows).has("ARI008"));
  EXPECT_FALSE(lintOf("L \"is\";L 1;+I;T \"is\"", rows).has("ARI008"));
  EXPECT_FALSE(lintOf("L \"ws\";L 1;+I;T \"ws\"", rows).has("ARI008"));
  // A byte of it is no REAL.
  EXPECT_FALSE(lintOf("L MB 30;L 1;+I;T MW 20", rows).has("ARI008"));
}

TEST(SymbolTypes, NumbersAreNoBcd) {
  EXPECT_TRUE(lintOf("A I 0.0;L \"is\";SD T 1", rows).has("S5T003"));
  EXPECT_FALSE(lintOf("A I 0.0;L \"s5s\";SD T 1", rows).has("S5T003"));
  EXPECT_FALSE(lintOf("A I 0.0;L \"ws\";SD T 1", rows).has("S5T003"));
}

// Two rows that differ: nobody knows which is meant.
TEST(SymbolTypes, TwoTypesAreNone) {
  EXPECT_FALSE(lintOf("L \"rs\";L 1;+I;T MW 20", rows + "\"ds\",\"MD     30\",\"DINT\",\"\"\n").has("ARI008"));
}

}  // namespace
}  // namespace rungproof
