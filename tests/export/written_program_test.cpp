// Exports print the program as it is written: what a simplification decides by itself is still a question to the reader
// of the file, names are unique, and a word-level file says what a state begins with before the state.
#include <gtest/gtest.h>

#include <set>
#include <sstream>

#include "frontend/cli/cli.hpp"
#include "tests/corpus/command_output.hpp"
#include "tests/temporary_folder.hpp"

namespace rungproof::test {
namespace {

std::string exported(const std::string& file, const std::string& format, const std::vector<std::string>& more = {}) {
  std::istringstream in;
  std::ostringstream out, err;
  std::vector<std::string> arguments{"export", "--isolated", file, "--format", format};
  arguments.insert(arguments.end(), more.begin(), more.end());
  EXPECT_EQ(runProgram(arguments, {in, out, err}), 0) << err.str();
  return out.str();
}

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

const std::string lamp =
    "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD I0.0\nAN I0.1\n= Q0.0\nEND_ORGANIZATION_BLOCK\n";

TEST(WrittenProgram, NothingIsBadByConstruction) {
  const TemporaryFolder folder;
  // The rewriter alone decides all three: a product implies its factor, nothing writes M9.0, SM0.0 is always 1.
  const std::string file = folder.file("p.awl",
                                       "//@ prove a: Q0.0 implies I0.0\n//@ prove b: never M9.0\n"
                                       "//@ prove c: always SM0.0\n" +
                                           lamp);
  std::set<std::string> constants;
  std::size_t bads = 0;
  for (const std::string& line : linesOf(exported(file, "btor2"))) {
    std::istringstream words(line);
    std::string id, kind, first, second;
    words >> id >> kind >> first >> second;
    if (kind == "constd" || kind == "const") constants.insert(id);
    if (kind != "bad") continue;
    ++bads;
    EXPECT_FALSE(constants.contains(first)) << line;
  }
  EXPECT_EQ(bads, 3U);
  const std::string smv = exported(file, "smv");
  EXPECT_EQ(smv.find(":= !TRUE"), std::string::npos) << smv;
  EXPECT_EQ(smv.find(":= !FALSE"), std::string::npos) << smv;
  const std::string smt = exported(file, "smt2");
  EXPECT_EQ(smt.find("(and false"), std::string::npos) << smt;
  EXPECT_NE(smt.find("|M9.0@0|"), std::string::npos) << smt;
}

TEST(WrittenProgram, OnlyWritesTheNamedProperties) {
  const TemporaryFolder folder;
  const std::string file = folder.file(
      "p.awl",
      "//@ prove left: Q0.0 implies I0.0\n//@ prove right: never M9.0\n//@ prove lever: always SM0.0\n" + lamp);
  const auto badsOf = [&](const std::vector<std::string>& more) {
    std::vector<std::string> names;
    for (const std::string& line : linesOf(exported(file, "btor2", more))) {
      std::istringstream words(line);
      std::string id, kind, node, name;
      if (words >> id >> kind >> node >> name && kind == "bad") names.push_back(name);
    }
    return names;
  };
  EXPECT_EQ(badsOf({}), (std::vector<std::string>{"left", "right", "lever"}));
  EXPECT_EQ(badsOf({"--only", "right"}), std::vector<std::string>{"right"});
  EXPECT_EQ(badsOf({"--only", "le*"}), (std::vector<std::string>{"left", "lever"}));
}

TEST(WrittenProgram, NamesOfBitsAreUnique) {
  const TemporaryFolder folder;
  const std::string file = folder.file(
      "p.awl", "//@ prove q: once(falls(I0.0)) leads to M0.0 or once(I0.1) within 40ms\n//@ reach I0.0: Q0.0\n" + lamp);
  for (const std::string format : {"aiger", "aiger-ascii"}) {
    std::set<std::string> names;
    const std::string text = exported(file, format);
    const std::size_t symbols = text.rfind("i0 ");
    ASSERT_NE(symbols, std::string::npos);
    for (const std::string& line : linesOf(text.substr(symbols))) {
      if (line == "c") break;
      EXPECT_TRUE(names.insert(line.substr(line.find(' ') + 1)).second) << format << ": " << line;
    }
    EXPECT_GT(names.size(), 10U);
  }
  const std::string aiger = folder.file("p.aig", exported(file, "aiger"));
  const std::string answer = outputOf("berkeley-abc -c 'read_aiger " + aiger + "; print_stats'");
  EXPECT_NE(answer.find("lat ="), std::string::npos) << answer;
}

TEST(WrittenProgram, InitialValuesStandBeforeTheirStates) {
  const TemporaryFolder folder;
  const std::string file = folder.file("p.awl", "//@ prove a: Q0.0 implies I0.0\n" + lamp);
  std::size_t initials = 0;
  for (const std::string& line : linesOf(exported(file, "btor2"))) {
    std::istringstream words(line);
    std::string id, kind;
    std::size_t type = 0, state = 0, value = 0;
    if (!(words >> id >> kind >> type >> state >> value) || kind != "init") continue;
    ++initials;
    EXPECT_LT(value, state) << line;
  }
  EXPECT_GT(initials, 0U);
}

}  // namespace
}  // namespace rungproof::test
