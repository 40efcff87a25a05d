// One thing that nobody knows does not switch the tool off: projects with one name, type, block, value or line missing
// or wrong. The double coil of Q 0.0 is still found, what does not depend on it is proved and violated as ever, what
// does is NOT COVERED, and sim runs until what runs needs it. Each expectation is reasoned beside its project.
#include "tests/step7/run7.hpp"

namespace rungproof {
namespace {

using test7::Output, test7::run;

/// Whether what runs needs what is not known; `Anything`: what is not known may write any place.
enum class Need : std::uint8_t { Nothing, Something, Anything };

struct OneMissing {
  std::string name;
  std::string blocks;      ///< besides OB 1
  std::string statements;  ///< network of OB 1 that uses them; may set MW 10 or Q 1.0
  Need need;
};

std::string db(const std::string& head, const std::string& values = "") {
  return "DATA_BLOCK " + head + "\nBEGIN\n" + values + "END_DATA_BLOCK\n";
}
const std::string plainDb = "STRUCT\n a : INT ;\n b : INT := 5 ;\n c : BOOL ;\nEND_STRUCT ;";
std::string fc(int number, const std::string& statements, const std::string& declarations = "") {
  return "FUNCTION FC " + std::to_string(number) + " : VOID\n" + declarations + "BEGIN\nNETWORK\n" + statements +
         "\nEND_FUNCTION\n";
}
std::string fb(int number, const std::string& declarations, const std::string& statements) {
  return "FUNCTION_BLOCK FB " + std::to_string(number) + "\n" + declarations + "BEGIN\nNETWORK\n" + statements +
         "\nEND_FUNCTION_BLOCK\n";
}

const std::string outputs = "VAR_OUTPUT\n q : BOOL ;\nEND_VAR\n";

std::string textOf(const OneMissing& project) {
  return project.blocks + "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n      A I 0.0;\n      = Q 0.0;\n" +
         "NETWORK\n      A I 0.1;\n      = Q 0.0;\n" +
         (project.statements.empty() ? "" : "NETWORK\n" + project.statements + "\n") +
         "NETWORK\n      L MW 10;\n      T MW 12;\n"
         "NETWORK\n      A Q 1.0;\n      = Q 1.1;\n"
         "NETWORK\n      A I 0.2;\n      = Q 0.1;\nEND_ORGANIZATION_BLOCK\n";
}

std::vector<OneMissing> oneMissingProjects() {
  const std::string use = "L DB5.DBW 0; T MW 10;", useBit = "A DB5.DBX 4.0; = Q 1.0;";
  const std::string idle = "NOP 0;";
  return {
      // Nobody uses the data block.
      {"instance of a missing FB", db("DB 5\nFB 77"), "", Need::Nothing},
      {"data block of a missing UDT", db("DB 5\nUDT 9"), "", Need::Nothing},
      {"data block of a type without a row", db("DB 5\n\"Recipe\""), "", Need::Nothing},
      {"field of a missing type", db("DB 5\nSTRUCT\n a : INT ;\n x : \"Recipe\" ;\nEND_STRUCT ;"), "", Need::Nothing},
      {"array of a missing type", db("DB 5\nSTRUCT\n x : ARRAY [1..4] OF UDT 9 ;\nEND_STRUCT ;"), "", Need::Nothing},
      {"start value of another type", db("DB 5\nSTRUCT\n a : INT := TRUE ;\nEND_STRUCT ;"), "", Need::Nothing},
      {"value of another type", db("DB 5\n" + plainDb, "a := 1.5 ;\n"), "", Need::Nothing},
      {"value of no field", db("DB 5\n" + plainDb, "nobody := 1 ;\n"), "", Need::Nothing},
      {"value that cannot be read", db("DB 5\n" + plainDb, "a = 1 ;\n"), "", Need::Nothing},
      {"declaration that cannot be read", db("DB 5\nSTRUCT\n a INT ;\n b : INT ;\nEND_STRUCT ;"), "", Need::Nothing},
      {"UDT with a missing type", "TYPE UDT 8\nSTRUCT\n x : UDT 9 ;\nEND_STRUCT ;\nEND_TYPE\n" + db("DB 5\nUDT 8"), "",
       Need::Nothing},
      {"data block without its end", "DATA_BLOCK DB 5\n" + plainDb + "\nBEGIN\n", "", Need::Nothing},
      // Somebody does: what MW 10 or Q 1.0 is, nobody knows.
      {"instance of a missing FB, read", db("DB 5\nFB 77"), use, Need::Something},
      {"instance of a missing FB, opened", db("DB 5\nFB 77"), "OPN DB 5; L DBW 2; T MW 10;", Need::Something},
      {"data block of a missing UDT, read", db("DB 5\nUDT 9"), useBit, Need::Something},
      {"field of a missing type, by name",
       "DATA_BLOCK \"Set\"\nSTRUCT\n x : \"Recipe\" ;\n a : INT ;\nEND_STRUCT\nBEGIN\n"
       "END_DATA_BLOCK\n",
       "L \"Set\".a; T MW 10;", Need::Something},
      {"value of another type, read", db("DB 5\n" + plainDb, "a := 1.5 ;\n"), use, Need::Something},
      {"start value of another type, read", db("DB 5\nSTRUCT\n a : INT := TRUE ;\nEND_STRUCT ;"), use, Need::Something},
      {"declaration that cannot be read, used", db("DB 5\nSTRUCT\n a INT ;\n b : INT ;\nEND_STRUCT ;"), use,
       Need::Something},
      {"missing data block", "", "L DB7.DBW 0; T MW 10;", Need::Something},
      {"missing data block, opened", "", "OPN DB 7; L DBW 0; T MW 10;", Need::Something},
      {"missing data block by name", "", "A \"Nobody\".x; = Q 1.0;", Need::Something},
      {"missing symbol", "", "A \"Nobody\"; = Q 1.0;", Need::Something},
      {"missing symbol, loaded", "", "L \"Nobody\"; T MW 10;", Need::Something},
      {"missing symbol in parentheses", "", "A I 1.0; A( ; O I 1.1; O \"Nobody\"; ) ; = Q 1.0;", Need::Something},
      {"missing symbol in a block", fc(3, "A \"Nobody\"; = Q 1.0;"), "UC FC 3;", Need::Something},
      {"local name that is not declared", fc(3, "L #nobody; T MW 10;"), "UC FC 3;", Need::Something},
      {"type of a parameter",
       fb(6, "VAR_INPUT\n x : UDT 9 ;\n a : INT ;\nEND_VAR\n", "L #a; T MW 10;") + db("DB 6\nFB 6"), "CALL FB 6, DB 6;",
       Need::Something},
      {"type of temporary data", fc(3, "L #t; T MW 10;", "VAR_TEMP\n x : UDT 9 ;\n t : INT ;\nEND_VAR\n"), "UC FC 3;",
       Need::Something},
      // CALL copies from the instance what others have written into it: the block itself, one that it holds, a
      // statement elsewhere, the start value. The system works on the whole instance.
      {"output of an FB", fb(1, outputs, "A \"Nobody\"; = #q;") + db("DB 6\nFB 1"), "CALL FB 1, DB 6 (q := Q 1.0);",
       Need::Something},
      {"output of an FB behind memory", fb(1, outputs, "A M 1.0; = #q;") + db("DB 6\nFB 1"),
       "A \"Nobody\"; = M 1.0;\nNETWORK\nCALL FB 1, DB 6 (q := Q 1.0);", Need::Something},
      {"in out of an FB",
       fb(1, "VAR_IN_OUT\n n : INT ;\nEND_VAR\n", "L \"Nobody\"; T #n;") + db("DB 6\nFB 1") +
           fc(3, "CALL FB 1, DB 6 (n := MW 10);"),
       "UC FC 3;", Need::Something},
      {"output of an instance inside an instance",
       fb(1, outputs, "A \"Nobody\"; = #q;") + fb(2, "VAR\n inner : FB 1 ;\nEND_VAR\n", "CALL #inner (q := Q 1.0);") +
           db("DB 6\nFB 2"),
       "CALL FB 2, DB 6;", Need::Something},
      {"output with a start value of another type", fb(1, outputs, "NOP 0;") + db("DB 6\nFB 1", "q := 1.5 ;\n"),
       "CALL FB 1, DB 6 (q := Q 1.0);", Need::Something},
      {"time of an SFB", db("DB 6\nSFB 4"),
       "L \"Nobody\"; T DB6.PT;\nNETWORK\nCALL SFB 4, DB 6 (IN := I 1.0, Q := Q 1.0);", Need::Something},
      // In blocks that nothing calls.
      {"missing block, called by nobody", fc(3, "CALL FC 99;"), "", Need::Nothing},
      {"unknown instruction, run by nobody", fc(3, "FROB I 0.0;"), "", Need::Nothing},
      {"operand of another width, run by nobody", fc(3, "A MW 0;"), "", Need::Nothing},
      {"missing symbol, run by nobody", fc(3, "A \"Nobody\"; = Q 1.0;"), "", Need::Nothing},
      {"function without its end, run by nobody", "FUNCTION FC 3 : VOID\nBEGIN\nNETWORK\n A I 0.0;\n = Q 1.0;\n", "",
       Need::Nothing},
      {"label that is missing, run by nobody", fc(3, "JU away;"), "", Need::Nothing},
      // What may write anything.
      {"missing block", "", "CALL FC 99;", Need::Anything},
      {"missing FB", "", "CALL FB 77, DB 5;", Need::Anything},
      {"missing symbol, written", "", "A I 1.0; = \"Nobody\";", Need::Anything},
      {"unknown instruction", "", "FROB I 0.0;", Need::Anything},
      {"damaged heading", "FUNCTIO FC 3 : VOID\nBEGIN\nNETWORK\n A I 0.0;\n = Q 1.0;\nEND_FUNCTION\n", idle,
       Need::Anything},
      {"protected block that is called", "FUNCTION FC 3 : VOID\nKNOW_HOW_PROTECT\nBEGIN\nEND_FUNCTION\n", "CALL FC 3;",
       Need::Anything},
  };
}

class OneUnknown : public ::testing::TestWithParam<OneMissing> {
 protected:
  Output of(const std::string& command, const std::vector<std::string>& more = {}) const {
    const test::TemporaryFolder folder;
    folder.file("main.awl", textOf(GetParam()));
    folder.file("main.prop",
                "prove same: Q0.1 = I0.2\nprove never: never Q0.1\nprove word: MW12 = 0\nprove bit: never Q1.1\n");
    std::vector<std::string> arguments = {command, folder.path("main.awl")};
    if (command == "prove" || command == "export")
      arguments.insert(arguments.end(), {"--props", folder.path("main.prop")});
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }
};

TEST_P(OneUnknown, LintFindsTheRest) {
  const Output output = of("lint");
  EXPECT_TRUE(output.has("warning[OUT001]: Q0.0 is driven by 2 coils")) << output.text;
  const bool isNote = GetParam().name == "protected block that is called";
  EXPECT_EQ(output.exit, isNote ? 1 : 2) << output.text;
}

TEST_P(OneUnknown, WhatDoesNotDependIsProved) {
  const Output output = of("prove");
  const bool isAnything = GetParam().need == Need::Anything;
  EXPECT_EQ(output.has("PROVED  same"), !isAnything) << output.text;
  EXPECT_EQ(output.has("VIOLATED  never"), !isAnything) << output.text;
  const bool isWord =
      GetParam().statements.find("MW 10") != std::string::npos || GetParam().blocks.find("MW 10") != std::string::npos;
  const bool needsWord = isAnything || (GetParam().need == Need::Something && isWord);
  const bool needsBit = isAnything || (GetParam().need == Need::Something && !isWord);
  EXPECT_EQ(output.has("NOT COVERED  word"), needsWord) << output.text;
  EXPECT_EQ(output.has("NOT COVERED  bit"), needsBit) << output.text;
  // Of what is not run MW 12 stays 0, and Q 1.1 off.
  EXPECT_EQ(output.has("PROVED  word"), !needsWord) << output.text;
  EXPECT_EQ(output.has("PROVED  bit"), !needsBit) << output.text;
}

// Every use stands in the way of the first scan, so that no scan is told.
TEST_P(OneUnknown, SimRunsUntilItIsNeeded) {
  const Output output = of("sim", {"--scans", "2"});
  const bool isRun = GetParam().need == Need::Nothing, isFrame = GetParam().name == "damaged heading";
  EXPECT_EQ(output.has("\n1,10,10,"), isRun) << output.text;
  EXPECT_EQ(output.has("the run ends in scan 1, in "), !isRun && !isFrame) << output.text;
  EXPECT_EQ(output.has("the program is not run: "), isFrame) << output.text;
  EXPECT_EQ(output.exit, 2) << output.text;
}

TEST_P(OneUnknown, ExportLeavesOutWhatDepends) {
  const Output output = of("export", {"--format", "smv"});
  EXPECT_EQ(output.has("MODULE main"), GetParam().need != Need::Anything) << output.text;
  EXPECT_EQ(output.has("-- not covered: "), GetParam().need == Need::Something) << output.text;
}

TEST_P(OneUnknown, IsDrawnAndCrossReferenced) {
  EXPECT_TRUE(of("xref").has("Q0.1\n    write")) << of("xref").text;
  EXPECT_TRUE(of("show").has("Q0.1")) << of("show").text;
}

std::ostream& operator<<(std::ostream& out, const OneMissing& project) { return out << project.name; }

INSTANTIATE_TEST_SUITE_P(Projects, OneUnknown, ::testing::ValuesIn(oneMissingProjects()),
                         [](const ::testing::TestParamInfo<OneMissing>& project) {
                           std::string name = project.param.name;
                           std::erase_if(name, [](char c) { return c == ','; });
                           std::ranges::replace(name, ' ', '_');
                           return name;
                         });

// A name that is missed at many places is one finding, at the first one, with their number.
TEST(MissingNames, AreToldOnce) {
  OneMissing project{"", fc(3, "A \"Nobody\"; = Q 1.0;\nNETWORK\nL \"Other\"; T MW 20; CALL FC 99;"),
                     "A \"Nobody\"; A \"Nobody\"; = Q 1.2; CALL FC 99; L DB7.DBW 0; L DB7.DBW 2; T MW 10;",
                     Need::Anything};
  const test::TemporaryFolder folder;
  folder.file("main.awl", textOf(project));
  const Output output = run({"lint", folder.path("main.awl")});
  const auto countOf = [&](const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = output.text.find(part); at != std::string::npos; at = output.text.find(part, at + 1)) ++count;
    return count;
  };
  EXPECT_TRUE(output.has("nothing defines \"Nobody\" (3 uses, this is the first)")) << output.text;
  EXPECT_TRUE(output.has("FC99 is in none of the files (2 uses, this is the first)")) << output.text;
  EXPECT_TRUE(output.has("DB7 is in none of the files (2 uses, this is the first)")) << output.text;
  EXPECT_EQ(countOf("error[SYN046]"), 2U) << output.text;
  EXPECT_EQ(countOf("error[SYN049]"), 2U) << output.text;
}

// What a run was asked to show and nobody knows is an error, not the value that an empty block would have.
TEST(OneUnknownValue, IsShownByNoRun) {
  const OneMissing project{"", db("DB 5\n" + plainDb, "a := 1.5 ;\n"), "L 3; T DB5.DBW 2;", Need::Nothing};
  const test::TemporaryFolder folder;
  folder.file("main.awl", textOf(project));
  const Output asked = run({"sim", folder.path("main.awl"), "--scans", "1", "--signals", "DB5.DBW0"});
  EXPECT_TRUE(asked.has("DB5.DBW0 has no known value")) << asked.text;
  EXPECT_EQ(asked.exit, 2);
  const Output other = run({"sim", folder.path("main.awl"), "--scans", "1", "--signals", "DB5.DBW2"});
  EXPECT_TRUE(other.has("1,10,10,3")) << other.text;
}

}  // namespace
}  // namespace rungproof
