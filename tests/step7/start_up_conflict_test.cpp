// OB100 ends before the first scan (002:1367-1375): what it sets or resets is no conflict with OB1.
#include "tests/step7/run7.hpp"

namespace rungproof {
namespace {

using test7::Output, test7::run;

Output builtin(const std::string& startUp, const std::string& scan) {
  const test::TemporaryFolder folder;
  return run({"prove",
              folder.file("p.awl", "ORGANIZATION_BLOCK OB 100\nBEGIN\nNETWORK\n" + startUp +
                                       "\nEND_ORGANIZATION_BLOCK\nORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n" + scan +
                                       "\nEND_ORGANIZATION_BLOCK\n"),
              "--builtin", "--isolated"});
}

TEST(StartUpConflicts, AFirstValueIsNone) {
  const std::string latch = "A I 0.0; AN I 0.1; S M 10.0; A I 0.1; R M 10.0; A M 10.0; = Q 0.0;";
  for (const char* first : {"SET; R M 10.0;", "SET; S M 10.0;", "CLR; = M 10.0;"}) {
    const Output output = builtin(first, latch);
    EXPECT_FALSE(output.has("conflict on M10.0")) << output.text;  // I0.1 excludes the one or the other
    EXPECT_EQ(output.exit, 0) << output.text;
  }
}

// I0.0 and I0.1 together; and two statements of the start-up itself, where no input has been read yet.
TEST(StartUpConflicts, OnesOfAScanAndOfTheStartUpAreFound) {
  EXPECT_TRUE(builtin("SET; R M 10.0;", "A I 0.0; S M 10.0; A I 0.1; R M 10.0; A I 0.2; S M 10.0;")
                  .has("M10.0 is set and reset in one scan"));
  EXPECT_TRUE(
      builtin("SET; R M 10.0; AN I 0.0; S M 10.0;", "A M 10.0; = Q 0.0;").has("M10.0 is set and reset in one scan"));
}

}  // namespace
}  // namespace rungproof
