// Values of parameters that are timers, counters and blocks: STEP 7 writes `Timer_No := T 0;` into the source of an
// instance data block. The value is the number of the object; a call still has to name one.
#include "tests/step7/run7.hpp"

namespace rungproof {
namespace {

using test7::block, test7::lastRow, test7::Output, test7::run;

const std::string lamp =
    "FUNCTION_BLOCK FB 1\nVAR_INPUT\n  on : BOOL;\n  clock : TIMER;\n  number : COUNTER;\n  data : BLOCK_DB;\nEND_VAR\n"
    "VAR_OUTPUT\n  lit : BOOL;\nEND_VAR\nBEGIN\nNETWORK\nA #on;\nL S5T#20MS;\nSE #clock;\nA #clock;\n= #lit;\n"
    "END_FUNCTION_BLOCK\n";
const std::string plain = "DATA_BLOCK DB 9\nSTRUCT\n  x : INT;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n";
const std::string main1 =
    block(1, "CALL FB 1, DB 1 (on := I 0.0, clock := T 5, number := C 3, data := DB 9, lit := Q 0.0)");

std::string instanceWith(const std::string& values) {
  return "DATA_BLOCK DB 1\nFB 1\nBEGIN\n" + values + "END_DATA_BLOCK\n";
}
Output lintOf(const std::string& text) {
  const test::TemporaryFolder folder;
  folder.file("main.awl", text);
  return run({"lint", folder.path("main.awl"), "--cpu", "319-3"});
}

// S_PEXT of 20 ms lights the lamp for the first scans after the input. Both sets of mnemonics write counters.
TEST(ObjectValue, InstancesNameTimersCountersAndBlocks) {
  for (const char* values : {"  clock := T 0;\n  number := C 0;\n  data := DB 0;\n", "  clock := T0;\n",
                             "  number := Z 7;\n", "  clock := t 511 ;\n"}) {
    const std::string text = lamp + plain + instanceWith(values) + main1;
    EXPECT_FALSE(lintOf(text).has("SYN")) << values << lintOf(text).text;
    EXPECT_TRUE(lastRow(text, "Q0.0", {"--scans", "1", "--set", "I0.0=1"}).ends_with(",1")) << values;
  }
}

// A value of another kind, one that is no number, and one for a variable that holds no object.
TEST(ObjectValue, OthersAreFound) {
  for (const char* values : {"  clock := C 5;\n", "  number := T 5;\n", "  data := FC 9;\n", "  clock := T 70000;\n",
                             "  clock := T;\n", "  clock := T 5x;\n", "  on := T 1;\n"}) {
    const Output output = lintOf(lamp + plain + instanceWith(values) + main1);
    EXPECT_TRUE(output.has("error[SYN")) << values << output.text;
    EXPECT_EQ(output.exit, 2) << values;
  }
}

}  // namespace
}  // namespace rungproof
