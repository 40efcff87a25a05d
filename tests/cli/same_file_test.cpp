// A file that a command line names twice, or by its folder too, is one file.
#include <gtest/gtest.h>

#include "tests/program_run.hpp"

namespace rungproof {
namespace {

using test::mainBlock;
using test::ProgramRun;
using test::run;

TEST(SameFile, IsReadOnce) {
  const test::TemporaryFolder folder;
  const std::string program = folder.file("a.awl", mainBlock("Network 1\nLD I0.0\n= Q0.0\n"));
  const std::string same = folder.path("./a.awl");
  const std::string properties = folder.file("p.prop", "prove p: Q0.0 implies I0.0\n");
  const std::vector<std::vector<std::string>> twice = {{program, program}, {program, same}, {folder.path(""), same}};
  for (const std::vector<std::string>& files : twice) {
    const auto command = [&](std::vector<std::string> arguments) {
      arguments.insert(arguments.end(), files.begin(), files.end());
      return run(arguments);
    };
    EXPECT_TRUE(command({"lint", "--isolated"}).says("in 2 instructions")) << command({"lint", "--isolated"}).out;
    const ProgramRun proof = command({"prove", "--isolated", "--props", properties});
    EXPECT_EQ(proof.exit, 0) << proof.out << proof.err;
    EXPECT_TRUE(proof.says("1 property proved")) << proof.out;
    EXPECT_EQ(command({"sim", "--isolated"}).exit, 0);
    EXPECT_EQ(command({"check", "--isolated"}).out, run({"check", "--isolated", program}).out);
  }
}

// The same of a table of symbols that the configuration names and the folder holds.
TEST(SameFile, ATableOfSymbolsIsReadOnce) {
  const test::TemporaryFolder folder;
  folder.file("rungproof.toml", "symbols = [\"sym.csv\"]\n");
  const std::string table = folder.file("sym.csv", "Symbol,Address,Comment\nStart,I0.0,\nPump,Q0.0,\n");
  const std::string program = folder.file("a.awl", mainBlock("Network 1\nLD \"Start\"\n= \"Pump\"\n"));
  for (const std::vector<std::string>& files :
       {std::vector{folder.path("")}, std::vector{program, table}, std::vector{program}}) {
    std::vector<std::string> arguments{"lint"};
    arguments.insert(arguments.end(), files.begin(), files.end());
    const ProgramRun lint = run(arguments);
    EXPECT_EQ(lint.exit, 0) << lint.out << lint.err;
    EXPECT_FALSE(lint.says("SYM002")) << lint.out;
  }
}

}  // namespace
}  // namespace rungproof
