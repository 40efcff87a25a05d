// Ten times the elements cost at most thirteen times the work. Work is what no machine disturbs: the instructions that
// the program executes beyond those for one element, as valgrind counts them.
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "tests/cli/large_forms.hpp"
#include "tests/measured_process.hpp"

namespace rungproof::test {
namespace {

constexpr double mostGrowth = 13;  ///< for ten times the elements; n * log n has 12 or less
constexpr std::size_t fewElements = 40;
constexpr double countLimit = 300;  ///< seconds of a program that hangs

/// Instructions of a run, by valgrind's count; 0 where it says none.
double instructionsOf(const std::vector<std::string>& arguments, const std::string& input = "/dev/null") {
  std::string line =
      "exec valgrind --tool=cachegrind --cache-sim=no --cachegrind-out-file=/dev/null "
      "--log-fd=9 " RUNGPROOF_BINARY_DIR "/rungproof";
  for (const std::string& word : arguments) line += " '" + word + "'";
  const ProcessRun made = runProcess({"/bin/sh", "-c", line + " 9>&2 2>/dev/null >/dev/null <" + input}, countLimit);
  const std::size_t at = made.output.find("refs:");
  if (at == std::string::npos) return 0;
  std::string digits;
  for (std::size_t i = at + 5; i < made.output.size() && made.output[i] != '\n'; ++i) {
    if (made.output[i] >= '0' && made.output[i] <= '9') digits += made.output[i];
  }
  return digits.empty() ? 0 : std::stod(digits);
}

struct GrowingCase {
  std::string name;
  std::vector<std::string> command;
  std::string begin;
  std::string (*element)(std::size_t i);
  std::string end;
  const char* file = "p.awl";
};

std::string bitName(std::size_t i) { return fmt::format("V{}.{}", i / 8 % 4000, i % 8); }
std::string upperBit(std::size_t i) { return fmt::format("V{}.{}", 4000 + i / 8 % 4000, i % 8); }
std::string network(std::size_t i) { return fmt::format("Network {}\nLD {}\n= {}\n", i + 1, bitName(i), upperBit(i)); }
std::string output(std::size_t i) { return "= " + bitName(i) + "\n"; }

const std::vector<GrowingCase> growingCases = {
    {"findings as a page", {"lint", "--isolated", "--format", "html"}, "", network, ""},
    {"findings as SARIF", {"lint", "--isolated", "--format", "sarif"}, "", network, ""},
    {"networks drawn", {"show"}, "", network, ""},
    {"outputs of one network", {"lint", "--isolated"}, "Network 1\nLD I0.0\n", output, ""},
    {"outputs of one network, run", {"sim", "--isolated", "--scans", "2"}, "Network 1\nLD I0.0\n", output, ""},
    {"parallel contacts drawn",
     {"show"},
     "Network 1\nLD I0.0\n",
     [](std::size_t i) { return "O " + bitName(i) + "\n"; },
     "= Q0.0\n"},
    {"contacts in series drawn",
     {"show"},
     "Network 1\nLD I0.0\n",
     [](std::size_t i) { return "A " + bitName(i) + "\n"; },
     "= Q0.0\n"},
    {"branches",
     {"lint", "--isolated"},
     "Network 1\nLD I0.0\n",
     [](std::size_t i) { return "LPS\nA " + bitName(i) + "\n= " + upperBit(i) + "\nLPP\n"; },
     "= Q0.0\n"},
    {"properties",
     {"lint", "--isolated"},
     "",
     [](std::size_t i) { return fmt::format("//@ prove p{}: Q0.0 implies I0.0\n", i); },
     "Network 1\nLD I0.0\n= Q0.0\n"},
    {"members of a data block",
     {"lint", "--isolated"},
     "DATA_BLOCK DB 1\nSTRUCT\n",
     [](std::size_t i) { return fmt::format(" a{} : INT ;\n", i); },
     "END_STRUCT ;\nBEGIN\nEND_DATA_BLOCK\nORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n L DB1.DBW 0;\n T MW 0;\n"
     "END_ORGANIZATION_BLOCK\n"},
    {"types",
     {"lint", "--isolated"},
     "",
     [](std::size_t i) { return fmt::format("TYPE UDT {}\nSTRUCT\n a : INT ;\nEND_STRUCT ;\nEND_TYPE\n", i + 1); },
     "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n A I 0.0;\n = Q 0.0;\nEND_ORGANIZATION_BLOCK\n"},
    {"ELSIF",
     {"lint", "--isolated"},
     "PROGRAM P\nVAR\n  n : INT;\n  q : BOOL;\nEND_VAR\nIF n = 0 THEN q := TRUE;\n",
     [](std::size_t i) { return fmt::format("ELSIF n = {} THEN q := FALSE;\n", i); },
     "END_IF;\nEND_PROGRAM\n",
     "p.st"},
    {"functions",
     {"lint", "--isolated"},
     "",
     [](std::size_t i) {
       return fmt::format("FUNCTION FC {} : VOID\nBEGIN\nNETWORK\n A I 0.0;\n = Q 0.0;\nEND_FUNCTION\n", i + 1);
     },
     "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n CALL FC 1;\nEND_ORGANIZATION_BLOCK\n"},
    {"calls beside what cannot be read",
     {"lint", "--isolated"},
     "FUNCTION FC 1 : VOID\nVAR_INPUT\n x : INT ;\nEND_VAR\nBEGIN\nNETWORK\n L #x;\n T MW 0;\nEND_FUNCTION\n"
     "ORGANIZATION_BLOCK OB 1\nBEGIN\n",
     [](std::size_t) { return std::string("NETWORK\n CALL FC 1 ( x := MW 4);\nNETWORK\n A \"nope\";\n = M 1.0;\n"); },
     "END_ORGANIZATION_BLOCK\n"},
    {"instances",
     {"lint", "--isolated"},
     "PROGRAM P\nVAR\n  i : BOOL;\n",
     [](std::size_t i) { return fmt::format("  n{} : TON;\n", i); },
     "END_VAR\nn0(IN := i, PT := T#1s);\nEND_PROGRAM\n",
     "p.st"},
};

/// `work(n)`: instructions for n elements.
template <class Work>
void expectLinear(const std::string& name, std::size_t few, const Work& work) {
  const double one = work(1), some = work(few), many = work(10 * few);
  ASSERT_GT(one, 0) << name << ": valgrind has counted nothing (bash .ci/install installs it)";
  ASSERT_GT(some, one) << name;
  EXPECT_LT(many - one, mostGrowth * (some - one)) << name << ": " << one << ", " << some << ", " << many;
}

TEST(InstructionGrowth, TenTimesTheElementsAreThirteenTimesTheInstructionsAtMost) {
  for (const GrowingCase& one : growingCases) {
    const auto work = [&](std::size_t count) {
      const TemporaryFolder folder;
      std::vector<std::string> line = one.command;
      line.push_back(folder.file(one.file, one.begin + inARow(count, one.element) + one.end));
      return instructionsOf(line);
    };
    expectLinear(one.name, fewElements, work);
  }
}

TEST(InstructionGrowth, ColumnsOfTwoTraces) {
  const auto work = [](std::size_t count) {
    const TemporaryFolder folder;
    const std::string table =
        folder.file("t.csv", "scan" + inARow(count, [](std::size_t i) { return ",s" + std::to_string(i); }) + "\n1" +
                                 inARow(count, ",1") + "\n");
    return instructionsOf({"compare", table, table});
  };
  expectLinear("columns of two traces", 10 * fewElements, work);
}

// A document that an editor opens and shows.
TEST(InstructionGrowth, ADocumentInAnEditor) {
  const auto work = [](std::size_t count) {
    const TemporaryFolder folder;
    std::string session;
    const auto say = [&](const nlohmann::json& message) {
      const std::string text = message.dump();
      session += fmt::format("Content-Length: {}\r\n\r\n{}", text.size(), text);
    };
    say({{"jsonrpc", "2.0"},
         {"id", 1},
         {"method", "initialize"},
         {"params", {{"processId", nullptr}, {"rootUri", nullptr}, {"capabilities", nlohmann::json::object()}}}});
    say({{"jsonrpc", "2.0"}, {"method", "initialized"}, {"params", nlohmann::json::object()}});
    const std::string uri = "file:///p.awl";
    say({{"jsonrpc", "2.0"},
         {"method", "textDocument/didOpen"},
         {"params",
          {{"textDocument",
            {{"uri", uri}, {"languageId", "awl"}, {"version", 1}, {"text", inARow(count, network)}}}}}});
    say({{"jsonrpc", "2.0"},
         {"id", 2},
         {"method", "textDocument/documentSymbol"},
         {"params", {{"textDocument", {{"uri", uri}}}}}});
    say({{"jsonrpc", "2.0"}, {"id", 3}, {"method", "shutdown"}});
    say({{"jsonrpc", "2.0"}, {"method", "exit"}});
    return instructionsOf({"lsp"}, folder.file("session", session));
  };
  expectLinear("a document in an editor", fewElements, work);
}

}  // namespace
}  // namespace rungproof::test
