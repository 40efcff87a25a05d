// Text sources of a project beside its blocks: the same statements say nothing, others are a note at the source.
#include <gtest/gtest.h>

#include "tests/s7project/plant.hpp"

namespace rungproof {
namespace {

using test::TemporaryFolder;

test::ProgramRun lintWith(const std::map<std::string, std::string>& sources) {
  const TemporaryFolder folder;
  test::ProjectPart part = test::plantPart();
  part.sources = sources;
  return test::run({"lint", "--isolated", "--select", "SYN", writeFiles(folder, test::writeProject({part}, 1252))});
}

std::string changedPlant(const std::string& before, const std::string& after) {
  std::string source = test::plantSource();
  const std::size_t at = source.find(before);
  EXPECT_NE(at, std::string::npos);
  return source.replace(at, before.size(), after);
}

TEST(S7TextSources, SameStatementsSayNothing) {
  const test::ProgramRun run = lintWith({{"Plant", test::plantSource()}});
  EXPECT_FALSE(run.says("SYN073")) << run.out;
  EXPECT_EQ(run.exit, 0) << run.out << run.err;
}

TEST(S7TextSources, OtherStatementsAreNoted) {
  const test::ProgramRun run =
      lintWith({{"Plant", test::plantSource()}, {"Newer", changedPlant("      AN    #Stop;\n", "")}});
  EXPECT_TRUE(run.says("note[SYN073]: FC1 is another one in the source Newer than the block that runs: network 1"))
      << run.out;
  EXPECT_EQ(run.out.find("SYN073"), run.out.rfind("SYN073")) << run.out;
  EXPECT_EQ(run.exit, 0) << run.out;
}

// The German spelling of a source and names of parameters are no difference.
TEST(S7TextSources, SpellingIsNoDifference) {
  const test::ProgramRun run =
      lintWith({{"German",
                 "FUNCTION FC 1 : VOID\nVAR_INPUT\n  Ein : BOOL ;\n  Aus : BOOL ;\nEND_VAR\nVAR_IN_OUT\n  M : BOOL ;\n"
                 "END_VAR\nBEGIN\nNETWORK\n      U(    ;\n      O     #Ein;\n      O     #M;\n      )     ;\n"
                 "      UN    #Aus;\n      =     #M;\nEND_FUNCTION\n"}});
  EXPECT_FALSE(run.says("SYN073")) << run.out;
}

}  // namespace
}  // namespace rungproof
