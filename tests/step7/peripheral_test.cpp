// Direct access to modules: each read of PIW asks the module anew, each write to PQW reaches the image of the outputs
// too (002:1273, 002:1292).
#include "tests/step7/run7.hpp"

namespace rungproof {
namespace {

using test7::block, test7::lastRow, test7::Output, test7::proofOf, test7::run;

// The module may say something else at the second read; so it does not follow that both are the same.
TEST(Peripheral, IsReadAnew) {
  const std::string blocks = block(1, "L PIW 256;T MW 10;L PIW 256;T MW 12");
  const Output output = proofOf("prove same: MW10 = MW12\nprove last: MW12 = PIW256\n", blocks);
  EXPECT_TRUE(output.has("VIOLATED  same") && output.has("PROVED  last")) << output.text;
  const std::vector<std::string> filtered = {"--choice", "analog-sampling=each-scan"};
  EXPECT_TRUE(proofOf("prove same: MW10 = MW12\n", blocks, filtered).has("PROVED  same"));
}

// What is assumed of a module holds at each read of it: neither of two comparisons sees a value beyond the range,
// though the two may see different ones. PIB260 is assumed of as the high byte.
TEST(Peripheral, AssumptionsHoldAtEachRead) {
  const std::string blocks = block(1,
                                   "L PIW 256;L 27648;>I;= M 0.0;L PIW 256;L 0;<I;= M 0.1;L PIW 256;T MW 2;L PIW "
                                   "256;T MW 4;L PID 260;T MD 8;L PID 260;T MD 12;L PIB 264;T MB 16;L PIB 264");
  const Output output = proofOf(
      "assume range: PIW256 >= 0 and PIW256 <= 27648\nassume wide: PID260 > 0\nassume narrow: PIB264 < 5\n"
      "prove over: not M0.0\nprove under: not M0.1\nprove same: MW2 = MW4\nprove wide: MD8 > 0 and MD12 > 0\n"
      "prove narrow: MB16 < 5\n",
      blocks);
  for (const char* name : {"over", "under", "wide", "narrow"})
    EXPECT_TRUE(output.has(std::string("PROVED  ") + name)) << name << output.text;
  EXPECT_TRUE(output.has("VIOLATED  same")) << output.text;
}

// A run that needs one value a scan tells it as an input, by its name in this family; as a stimulus it shows the same:
// 16#80 or more in PIB0 sets Q4.7.
TEST(Peripheral, AWitnessIsAStimulus) {
  const std::string blocks = block(1, "L PIB 0;T PQB 4");
  const test::TemporaryFolder folder;
  folder.file("main.awl", blocks);
  folder.file("main.prop", "prove off: never Q4.7\n");
  const Output proof =
      run({"prove", folder.path("main.awl"), "--props", folder.path("main.prop"), "--traces", folder.path("runs")});
  EXPECT_TRUE(proof.has("VIOLATED  off") && proof.has("PIW0  Q4.7")) << proof.text;
  const Output again = run(
      {"sim", folder.path("main.awl"), "--stimulus", folder.path("runs/off.csv"), "--signals", "Q4.7", "--trace", "-"});
  EXPECT_TRUE(again.has(",1\n")) << again.text;
}

// A module says directly what it says to the image, unless the stimulus has words of its own for it: I0.0 and I0.7 are
// 129 in IB0 and PIB0; from the second scan on PIB0 is 7.
TEST(Peripheral, AnswersAsTheImage) {
  const std::vector<std::string> rows = test7::rowsOf(block(1, "L PIB 0;T MB 0;L IB 0;T MB 1"), "MB0,MB1",
                                                      {"--scans", "3"}, "scan,I0.0,I0.7,PIB0\n1,1,1,\n2,,,7\n3,,0,\n");
  ASSERT_EQ(rows.size(), 3U) << rows[0];
  EXPECT_TRUE(rows[0].ends_with(",129,129") && rows[1].ends_with(",7,129") && rows[2].ends_with(",7,1")) << rows[2];
}

// T PQB 4 writes QB4: what is said of it is no vacuous truth, and a list of references names the statement. MW2 of an
// image that ends before PQW 5000 is not touched.
TEST(Peripheral, WritesTheImage) {
  const std::string blocks = block(1, "L 7;T PQB 4;T PQW 8190");
  const Output output = proofOf("prove bits: Q4.0 and not Q4.7\nprove off: never Q4.7\n", blocks);
  EXPECT_TRUE(output.has("PROVED  bits") && output.has("PROVED  off")) << output.text;
  EXPECT_FALSE(output.has("no instruction writes")) << output.text;
  const test::TemporaryFolder folder;
  folder.file("main.awl", blocks);
  EXPECT_TRUE(run({"xref", folder.path("main.awl"), "Q4.0"}).has("T PQB4"));
  EXPECT_EQ(run({"lint", folder.path("main.awl")}).exit, 0);
}

// The map pairs words of modules with each other and with analog inputs of an S7-200; without it they are two inputs.
TEST(Peripheral, IsPairedByTheMap) {
  const test::TemporaryFolder folder;
  folder.file("old.awl", block(1, "L PIW 256;T QW 8;L PIW 260;L 100;>I;= Q 4.0"));
  folder.file("new.awl", block(1, "L PIW 260;T MW 20;L PIW 512;T MW 0;L MW 0;T QW 8;L MW 20;L 100;<=I;NOT;= Q 4.0"));
  folder.file("s7200.awl",
              "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLDW> AIW0, 100\n= Q4.0\nEND_ORGANIZATION_BLOCK\n");
  folder.file("s7300.awl", block(1, "L PIW 256;L 100;>I;= Q 4.0"));
  folder.file("words.map", "PIW256 = PIW512\n");
  folder.file("families.map", "AIW0 = PIW256\n");
  const auto verdict = [&](const char* before, const char* after, const char* map) {
    std::vector<std::string> arguments = {"equiv", folder.path(before), folder.path(after), "--dialect", "auto"};
    if (*map != 0) arguments.insert(arguments.end(), {"--map", folder.path(map)});
    return run(arguments).exit;
  };
  EXPECT_EQ(verdict("old.awl", "new.awl", "words.map"), 0);
  EXPECT_EQ(verdict("old.awl", "new.awl", ""), 1);
  EXPECT_EQ(verdict("s7200.awl", "s7300.awl", "families.map"), 0);
  EXPECT_EQ(verdict("s7200.awl", "s7300.awl", ""), 1);
}

}  // namespace
}  // namespace rungproof
