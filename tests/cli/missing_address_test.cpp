// An address that the CPU does not have is refused wherever it is named beside a program: in a map, on the command line
// of `equiv`, as a question to `xref`. The CPU 226 has I0.0 to I15.7, Q0.0 to Q15.7, VB0 to VB10239, AQW0 to AQW62
// (000: table of ranges).
#include <gtest/gtest.h>

#include "tests/program_run.hpp"

namespace rungproof::test {
namespace {

class MissingAddress : public testing::Test {
 protected:
  const TemporaryFolder folder;
  const std::string program = folder.file("a.awl", mainBlock("Network 1\nLD I0.0\n= Q0.0\n"));
};

TEST_F(MissingAddress, IsNotObserved) {
  for (const auto& [address, reason] : {std::pair{"Q77.0", "the CPU 226 has no Q77.0: the last one is Q15.7"},
                                        std::pair{"QW15", "the CPU 226 has no QW15: the last one is QW14"},
                                        std::pair{"VB99999", "the CPU 226 has no VB99999: the last one is VB10239"},
                                        std::pair{"T999", "the CPU 226 has no T999: the last one is T255"},
                                        std::pair{"Q0.9", "Q0.9 has bit number 9; a byte has bits 0 to 7"}}) {
    const ProgramRun found = run({"equiv", "--isolated", program, program, "--observe", address});
    EXPECT_EQ(found.exit, 2) << found.out;
    EXPECT_NE(found.err.find(std::string("--observe: ") + reason), std::string::npos) << found.err;
  }
}

TEST_F(MissingAddress, IsNotMapped) {
  const std::string map = folder.file("moved.map", "I0.0 = M9.9\nI77.0 = I0.0\n");
  const ProgramRun found = run({"equiv", "--isolated", program, program, "--map", map});
  EXPECT_EQ(found.exit, 2) << found.out;
  EXPECT_NE(found.err.find("moved.map:1"), std::string::npos) << found.err;
  EXPECT_NE(found.err.find("M9.9 has bit number 9"), std::string::npos) << found.err;
  EXPECT_NE(found.err.find("moved.map:2"), std::string::npos) << found.err;
  EXPECT_NE(found.err.find("the CPU 226 has no I77.0"), std::string::npos) << found.err;
}

TEST_F(MissingAddress, IsNoQuestionToTheCrossReference) {
  const ProgramRun found = run({"xref", "--isolated", program, "Q77.0"});
  EXPECT_EQ(found.exit, 2) << found.out;
  EXPECT_NE(found.err.find("the CPU 226 has no Q77.0"), std::string::npos) << found.err;
  EXPECT_EQ(run({"xref", "--isolated", program, "Q7.0"}).exit, 0) << "it exists, and nobody names it";
}

}  // namespace
}  // namespace rungproof::test
