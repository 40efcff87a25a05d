// A symbol and its address together, as listings show them: the address counts, and the symbol table has to agree.
#include "tests/step7/read7.hpp"
#include "tests/step7/run7.hpp"

namespace rungproof {
namespace {

std::string boundText(const std::string& statements) {
  const Program program = readOb1(statements);
  return findings7(program) + (program.pous.empty() ? "" : show7(program.pous[0]));
}

TEST(NamedAddress, IsTheAddress) {
  EXPECT_EQ(boundText("A \"Start, now\":I 0.0; = \"Motor\":Q4.0; L Level:MW 10; A \"OV\":I 0.1; A \"Run\":T 5;"),
            "A I0.0; = Q4.0; L MW10; A I0.1; A T5");
  for (const char* none : {"A \"Start\":;", "A \"Start\":5;", "A \"Start\":\"Stop\";", "A \"D\".x:I 0.0;"})
    EXPECT_NE(findings7(readOb1(none)), "") << none;
}

TEST(NamedAddress, TheTableHasToAgree) {
  const auto lintOf = [](const std::string& statements) {
    const test::TemporaryFolder folder;
    folder.file("a.awl", "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n" + statements + "\nEND_ORGANIZATION_BLOCK\n");
    folder.file("a.sdf", "\"Start\",\"I 0.0\",\"BOOL\",\"\"\n");
    return test7::run({"lint", folder.path("a.awl"), folder.path("a.sdf"), "--select", "SYN"});
  };
  EXPECT_FALSE(lintOf("A \"Start\":I 0.0;\n= Q 4.0;").has("error"));
  const test7::Output differs = lintOf("A \"Start\":I 0.1;\n= Q 4.0;");
  EXPECT_TRUE(differs.has("the symbol table has another address for \"Start\" than I0.1, which is written here"))
      << differs.text;
}

}  // namespace
}  // namespace rungproof
