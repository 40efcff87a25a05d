// Every format that `export` writes, over the corpus, read by strict readers of the format's own rules: BTOR2, AIGER
// and SMV by those of this folder, SMT-LIB by cvc5. And that these readers refuse what the formats forbid.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <stdexcept>

#include "frontend/cli/cli.hpp"
#include "tests/corpus/command_output.hpp"
#include "tests/corpus/corpus_program.hpp"
#include "tests/export/bit_reader.hpp"
#include "tests/export/word_reader.hpp"
#include "tests/temporary_folder.hpp"

namespace rungproof::test {
namespace {

/// Programs of the corpus that are read to their end and have properties.
constexpr std::size_t leastExported = 100;

std::string textIn(const std::string& file) {
  std::stringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

std::size_t countOf(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(StrictExport, EveryFormatOfTheCorpus) {
  ASSERT_NE(outputOf("command -v cvc5"), "") << "the package cvc5 is missing; see .ci/install";
  const TemporaryFolder folder;
  std::size_t exported = 0;
  for (const std::filesystem::path& path : corpusFiles()) {
    std::vector<std::string> arguments{"export", "--isolated", path.string()};
    for (const auto& [name, value] : optionsOf(path)) arguments.insert(arguments.end(), {name, value});
    for (const std::string format : {"btor2", "aiger", "aiger-ascii", "smt2", "smv"})
      arguments.insert(arguments.end(), {"--format", format + "=" + folder.path(format)});
    std::istringstream in;
    std::ostringstream out, err;
    if (runProgram(arguments, {in, out, err}) != 0) continue;  // not read to its end, or without properties
    ++exported;
    const std::string btor2 = textIn(folder.path("btor2")), smv = textIn(folder.path("smv")),
                      smt2 = textIn(folder.path("smt2"));
    const std::size_t questions = countOf(smt2, "(check-sat)");
    EXPECT_GT(questions, 0u) << path;
    try {
      const WordStep words = btor2Step(btor2, {}, {}), texts = smvStep(smv, {}, {});
      EXPECT_EQ(words.bads.size(), questions) << path;
      EXPECT_EQ(texts.bads.size(), questions) << path;
      EXPECT_EQ(btor2Shape(btor2).states, smvShape(smv).states) << path;
      const AigerShape binary = readAiger(textIn(folder.path("aiger"))),
                       ascii = readAiger(textIn(folder.path("aiger-ascii")));
      EXPECT_EQ(binary.bads, questions) << path;
      EXPECT_EQ(ascii.bads, questions) << path;
      EXPECT_EQ(binary.constraints, 0u) << path;
      EXPECT_EQ(binary.names.size(), binary.inputs + binary.latches + binary.bads) << path;
      EXPECT_EQ(ascii.names.size(), ascii.inputs + ascii.latches + ascii.bads) << path;
    } catch (const std::exception& error) {
      ADD_FAILURE() << path << ": " << error.what();
    }
    EXPECT_EQ(outputOf("cvc5 --parse-only --strict-parsing --incremental --lang smt2 " + folder.path("smt2")), "")
        << path;
  }
  std::printf("%zu programs exported\n", exported);
  EXPECT_GE(exported, leastExported);
}

TEST(StrictExport, Btor2ThatTheFormatForbids) {
  const std::string good =
      "10 sort bitvec 1\n20 constd 10 0\n30 state 10 a\n40 init 10 30 20\n50 next 10 30 30\n60 bad 30 b\n";
  EXPECT_EQ(btor2Step(good, {}, {}).bads.size(), 1u);
  const std::vector<std::pair<const char*, const char*>> changes = {
      {"40 init 10 30 20", "41 constd 10 1\n42 init 10 30 41"},  // begins with what stands behind it
      {"20 constd 10 0", "20 input 10 x"},                       // begins with an input
      {"40 init 10 30 20", "40 init 10 20 20"},                  // no state begins
      {"20 constd 10 0", "20 constd 10 2"},
      {"60 bad 30 b", "60 bad 30 b c"},
      {"60 bad 30 b", "60 bad  30 b"},
      {"60 bad 30 b", "50 bad 30 b"},
      {"60 bad 30 b", "60 bad 70 b"},
      {"60 bad 30 b", "60 input 10 a"},  // the name of the state
      {"60 bad 30 b", "60 next 10 30 20"},
      {"60 bad 30 b", "60 worse 10 30"},
      {"10 sort bitvec 1", "10 sort bitvec 2"},  // a bad state of two bits
      {"10 sort bitvec 1", "10 sort bitvec 0"},
  };
  for (const auto& [from, to] : changes) {
    std::string bad = good;
    bad.replace(bad.find(from), std::string(from).size(), to);
    EXPECT_THROW(btor2Step(bad, {}, {}), std::runtime_error) << bad;
  }
  EXPECT_THROW(btor2Step(good.substr(0, good.size() - 1), {}, {}), std::runtime_error) << "no end of the last line";
}

TEST(StrictExport, AigerThatTheFormatForbids) {
  const std::string good = "aag 3 1 1 0 1 1\n2\n4 6 0\n6\n6 4 2\ni0 x\nl0 y\nb0 z\nc\nanything\n";
  EXPECT_EQ(readAiger(good).names.size(), 3u);
  const std::vector<std::pair<const char*, const char*>> changes = {
      {"aag 3", "aag 2"}, {"aag 3", "aag 03"}, {"aag 3", "aag  3"}, {"\n2\n", "\n3\n"}, {"\n2\n", "\n4\n"},
      {"4 6 0", "4 6 2"}, {"4 6 0", "4 8 0"},  {"6 4 2", "6 6 2"},  {"6 4 2", "4 4 2"}, {"l0 y", "l0 x"},
      {"l0 y", "l1 y"},   {"l0 y", "i0 y"},    {"l0 y", "k0 y"},    {"b0 z", "b0 "},    {"c\nanything\n", "z"},
  };
  for (const auto& [from, to] : changes) {
    std::string bad = good;
    bad.replace(bad.find(from), std::string(from).size(), to);
    EXPECT_THROW(readAiger(bad), std::runtime_error) << bad;
  }
  // The same in binary: the gate is 6 with the differences 2 and 2.
  const std::string binary = "aig 3 1 1 0 1 1\n6 0\n6\n\x02\x02i0 x\n";
  EXPECT_EQ(readAiger(binary).gates, 1u);
  const std::vector<std::pair<std::string, std::string>> differences = {
      {"\x02\x02", std::string("\0\x02", 2)},  // an operand that is the gate itself
      {"\x02\x02", "\x02\x05"},                // a second operand below 0
      {"\x02\x02", "\x82"},                    // another byte was announced: 'i', then the text is no symbol
      {"aig 3", "aig 4"},
  };
  for (const auto& [from, to] : differences) {
    std::string bad = binary;
    bad.replace(bad.find(from), from.size(), to);
    EXPECT_THROW(readAiger(bad), std::runtime_error) << testing::PrintToString(bad);
  }
}

TEST(StrictExport, SmvThatTheFormatForbids) {
  const std::string good =
      "MODULE main\nVAR\n  a_ : boolean;\n  w_ : unsigned word[8];\nDEFINE\n  n1 := !a_;\nASSIGN\n  init(a_) := "
      "FALSE;\n"
      "  next(a_) := n1;\nINVARSPEC NAME p0 := !n1;\n";
  EXPECT_EQ(smvStep(good, {}, {}).bads.size(), 1u);
  const std::vector<std::pair<const char*, const char*>> changes = {
      {"w_ : unsigned word[8]", "a_ : boolean"},
      {"n1 := !a_", "n1 := !b_"},
      {"n1 := !a_", "n1 := w_ & a_"},
      {"init(a_) := FALSE", "init(a_) := w_"},
      {"NAME p0 := !n1", "NAME p0 := w_"},
      {"next(a_) := n1", "next(a_) := n2"},
  };
  for (const auto& [from, to] : changes) {
    std::string bad = good;
    bad.replace(bad.find(from), std::string(from).size(), to);
    EXPECT_THROW(smvStep(bad, {}, {}), std::runtime_error) << bad;
  }
}

}  // namespace
}  // namespace rungproof::test
