// Sources in SCL beside sources in other languages: bodies, data alone, sections, what is not covered. tests/scl has
// the language itself.
#include "tests/step7/run7.hpp"

namespace rungproof {
namespace {

using test7::Output;

const char* const scaling =
    "FUNCTION \"Scale\" : Int\n{ S7_Optimized_Access := 'FALSE' }\nVERSION : 0.1\nVAR_INPUT\n  x : Int;\nEND_VAR\n"
    "BEGIN\n  // half of it\n  IF #x > 100 THEN\n    #Scale := 100;\n  ELSE\n    #Scale := #x / 2;\n  END_IF;\n"
    "END_FUNCTION\n\nDATA_BLOCK \"Set\"\nVERSION : 0.1\nSTRUCT\n  limit : Int := "
    "7;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n";

// Called from a statement list: 5 / 2 is 2.
TEST(SclSource, BodyIsProvedBesideAStatementList) {
  const test::TemporaryFolder folder;
  folder.file("scale.scl", scaling);
  folder.file("main.awl", test7::block(1,
                                       "A I 0.0;= Q 0.0;L \"Set\".limit;T MW 20;CALL \"Scale\" (x := 5, RET_VAL := "
                                       "MW 10);L MW 10;T MW 12"));
  folder.file("p.prop", "prove same: Q0.0 = I0.0\nprove limit: MW20 == 7\nprove value: MW12 == 2\n");
  const Output lint = test7::run({"lint", folder.path("scale.scl"), folder.path("main.awl")});
  EXPECT_FALSE(lint.has("SYN037")) << lint.text;
  EXPECT_FALSE(lint.has("error")) << lint.text;
  const Output proof =
      test7::run({"prove", folder.path("scale.scl"), folder.path("main.awl"), "--props", folder.path("p.prop")});
  EXPECT_EQ(proof.exit, 0) << proof.text;
  EXPECT_TRUE(proof.has("PROVED  value")) << proof.text;
}

// A statement that is not covered leaves the block open, by name; the call may leave any value, the rest is proved.
TEST(SclSource, WhatIsNotCoveredIsSaid) {
  const test::TemporaryFolder folder;
  std::string text = scaling;
  text.replace(text.find("#x / 2"), 6, "PEEK('ab')");
  folder.file("scale.scl", text);
  folder.file("main.awl", test7::block(1, "CALL \"Scale\" (x := 5, RET_VAL := MW 10);L MW 10;T MW 12"));
  folder.file("p.prop", "prove value: MW12 == 2\n");
  const Output lint = test7::run({"lint", folder.path("scale.scl"), folder.path("main.awl")});
  EXPECT_TRUE(lint.has("warning[SYN037]: the function PEEK is not covered")) << lint.text;
  const Output proof =
      test7::run({"prove", folder.path("scale.scl"), folder.path("main.awl"), "--props", folder.path("p.prop")});
  EXPECT_TRUE(proof.has("NOT COVERED  value")) << proof.text;
}

// STEP 7 V5: constants and labels of the body in sections of their own, no BEGIN.
TEST(SclSource, SectionsOfTheBody) {
  const test::TemporaryFolder folder;
  folder.file("x.scl",
              "FUNCTION_BLOCK FB 7\nCONST\n  LIMIT := 5;\nEND_CONST\nLABEL\n  again;\nEND_LABEL\nVAR\n  n : INT;\n"
              "END_VAR\n  IF n > LIMIT THEN\n    n := 0;\n  END_IF;\nEND_FUNCTION_BLOCK\n");
  const Output output = test7::run({"lint", folder.path("x.scl")});
  EXPECT_FALSE(output.has("SYN0")) << output.text;
  EXPECT_FALSE(output.has("error")) << output.text;
}

// Data alone, with a name that has no marks.
TEST(SclSource, DataBlockAlone) {
  const test::TemporaryFolder folder;
  folder.file("x.scl", "DATA_BLOCK Globals\nSTRUCT\n  state : INT := -1;\nEND_STRUCT\nBEGIN\nEND_DATA_BLOCK\n");
  folder.file("main.awl", test7::block(1, "L \"Globals\".state;T MW 20"));
  folder.file("p.prop", "prove value: MW20 == -1\n");
  const Output proof =
      test7::run({"prove", folder.path("x.scl"), folder.path("main.awl"), "--props", folder.path("p.prop")});
  EXPECT_EQ(proof.exit, 0) << proof.text;
}

// A body of comments does nothing.
TEST(SclSource, EmptyBody) {
  const test::TemporaryFolder folder;
  folder.file("x.scl",
              "FUNCTION FC 3 : VOID\nVAR_TEMP\n  n : Int;\nEND_VAR\nBEGIN\n  // later\nEND_FUNCTION\n"
              "ORGANIZATION_BLOCK OB 1\nBEGIN\n  Q0.0 := FALSE;\n  FC3();\nEND_ORGANIZATION_BLOCK\n");
  folder.file("p.prop", "prove nothing: not Q0.0\n");
  const Output proof = test7::run({"prove", folder.path("x.scl"), "--props", folder.path("p.prop")});
  EXPECT_EQ(proof.exit, 0) << proof.text;
}

}  // namespace
}  // namespace rungproof
