// A folder stands for its programs whatever their ending: a text is a program by what is in it, and tables, traces,
// stimuli, test tables and notes are none.
#include "frontend/input/program_text.hpp"

#include <gtest/gtest.h>

#include "tests/program_run.hpp"

namespace rungproof {
namespace {

using test::mainBlock;
using test::ProgramRun;
using test::run;
using test::TemporaryFolder;

constexpr const char* network = "Network 1\nLD I0.0\nA I0.1\n= Q0.0\n";

TEST(ProgramText, IsKnownByItsContent) {
  const TemporaryFolder folder;
  const auto isProgram = [&](const std::string& name, const std::string& text) {
    return isProgramText(folder.file(name, text));
  };
  EXPECT_TRUE(isProgram("export.txt", mainBlock(network)));
  EXPECT_TRUE(
      isProgram("symbols_and_program.txt", "SYMBOL_TABLE\nStart,I0.0,\nEND_SYMBOL_TABLE\n" + mainBlock(network)));
  EXPECT_TRUE(isProgram("broken.txt", mainBlock("Network 1\nLD I0.0\nXYZ Q0.0\n")));  // its errors have to be told
  EXPECT_TRUE(isProgram("subroutine.txt",
                        "SUBROUTINE_BLOCK SBR_0:SBR0\nBEGIN\nNetwork 1\nLD I0.0\n= Q0.1\nEND_SUBROUTINE_BLOCK\n"));
  EXPECT_TRUE(isProgram("bare.txt", network));
  EXPECT_TRUE(isProgram("older.txt", "LD I0.0\nA I0.1\n= Q0.0\nMEND\n"));
  EXPECT_TRUE(
      isProgram("step7.txt", "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nU E 0.0;\n= A 4.0;\nEND_ORGANIZATION_BLOCK\n"));
  EXPECT_TRUE(isProgram("block.txt", "DATA_BLOCK DB 1\nSTRUCT\n Run : BOOL;\nEND_STRUCT\nBEGIN\nEND_DATA_BLOCK\n"));
  EXPECT_TRUE(isProgram("text.txt", "PROGRAM p VAR a AT %QX0.0 : BOOL; END_VAR a := TRUE; END_PROGRAM\n"));
}

TEST(ProgramText, TablesTracesAndNotesAreNone) {
  const TemporaryFolder folder;
  const std::vector<std::string> texts = {
      "Start\tI0.0\tpush button\nMotor\tQ0.0\t\n",
      "Start,I0.0,push button\nMotor,Q0.0,\n",
      "SYMBOL_TABLE\nStart,I0.0,\nEND_SYMBOL_TABLE\n",
      "126,Start                   E       0.0 BOOL      push button\n",
      "DATA_BLOCK DATA_BLOCK\nBEGIN\nVB0 1,2,3\nEND_DATA_BLOCK\n",
      "scan,I0.0,Q0.0\n1,0,0\n",
      "time_ms,I0.0\n0,1\n",
      "test,step,wait,set I0.0,expect Q0.0\nstarts,press,1 scan,1,1\n",
      "The pump starts with I0.0.\nNot before the lid is closed; see Network 3.\n",
      "not done\n",
      "Program of the press, written in May.\nFunction of the lid: it stops Q0.0.\n",
      "configuration of the bus:\n9600 baud\n",
      ""};
  for (const std::string& text : texts) EXPECT_FALSE(isProgramText(folder.file("a.txt", text))) << text;
}

TEST(ProgramText, AFolderHoldsIt) {
  const TemporaryFolder folder;
  folder.file("m/a.awl", mainBlock(network));
  folder.file("m/b.txt", mainBlock("Network 1\nLD I0.2\nXYZ\n= Q0.2\n"));
  folder.file("m/note.txt", "The pump starts with I0.0.\nnot done\n");
  folder.file("m/stimulus.csv", "scan,I0.0\n1,1\n");
  const ProgramRun lint = run({"lint", "--isolated", folder.path("m")});
  EXPECT_EQ(lint.exit, 2) << lint.out << lint.err;
  EXPECT_TRUE(lint.says("b.txt:5:1")) << lint.out;
  EXPECT_FALSE(lint.says("note.txt")) << lint.out;
  EXPECT_FALSE(lint.says("stimulus.csv")) << lint.out;

  // Nothing but such a file, and its table beside it.
  folder.file("t/main.txt", mainBlock("Network 1\nLD Start\n= Motor\n"));
  folder.file("t/names.txt", "Start\tI0.0\tpush button\nMotor\tQ0.0\t\n");
  const std::string properties = folder.file("p.prop", "prove p: Motor implies Start\n");
  const ProgramRun proof = run({"prove", "--isolated", folder.path("t"), "--props", properties});
  EXPECT_EQ(proof.exit, 0) << proof.out << proof.err;
  EXPECT_EQ(run({"check", "--isolated", folder.path("t")}).exit, 0);

  folder.file("n/note.txt", "Program of the press, written in May.\n");
  EXPECT_TRUE(run({"lint", "--isolated", folder.path("n")}).says("the folder holds no program"));
}

}  // namespace
}  // namespace rungproof
