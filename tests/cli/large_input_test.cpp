// Inputs of 100,000 elements and more: an answer or a refusal, in bounded memory. What grew with the square of the size
// would not come to an end here within the time that a test has.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/measured_process.hpp"
#include "tests/program_run.hpp"

namespace rungproof::test {
namespace {

constexpr double limit = 120;  ///< seconds of a process that hangs
constexpr std::uint64_t mebibyte = std::uint64_t{1} << 20;

ProcessRun execute(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), RUNGPROOF_BINARY_DIR "/rungproof");
  return runProcess(arguments, limit);
}

template <class Element>
std::string repeated(std::size_t count, const Element& element) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) text += element(i);
  return text;
}

const std::string oneRung = "Network 1\nLD I0.0\n= Q0.0\n";

// Forty kilobytes a finding before: 800 MB for this file. The text itself has 2.3 kB a finding.
TEST(LargeInput, ReportsOfManyFindingsTakeNoMoreMemoryThanTheFindings) {
  const TemporaryFolder folder;
  const std::string file = folder.file("p.awl", repeated(20000, [](std::size_t i) {
                                         return "Network " + std::to_string(i + 1) + "\nLD I0.0\n= Q9.9\n";
                                       }));
  for (const char* form : {"sarif", "json"}) {
    const std::string report = folder.path("report");
    const ProcessRun made = execute({"lint", "--isolated", std::string("--format=") + form + "=" + report, file});
    EXPECT_LT(made.peakBytes, 200 * mebibyte) << form << made.output.substr(0, 200);
    const nlohmann::json json = nlohmann::json::parse(contentOf(report), nullptr, false);
    ASSERT_FALSE(json.is_discarded()) << form;
    EXPECT_GE((form == std::string("json") ? json["findings"] : json["runs"][0]["results"]).size(), 20000U) << form;
  }
}

// Each finding has a place of its own in the page, though all have the same name.
TEST(LargeInput, PagesOfManyFindingsGrowWithThem) {
  const TemporaryFolder folder;
  const std::string file = folder.file("p.awl", repeated(50'000, [](std::size_t i) {
                                         return "Network " + std::to_string(i + 1) + "\nLD I0.0\n= Q9.9\n";
                                       }));
  const ProcessRun made = execute({"lint", "--isolated", "--format=html=" + folder.path("page.html"), file});
  EXPECT_FALSE(made.isCut);
  EXPECT_LT(made.peakBytes, 500 * mebibyte);
}

// Each branch asks what stands in front of it, which is in front of all.
TEST(LargeInput, BranchesOfOneRungAreFollowedOnce) {
  const TemporaryFolder folder;
  const std::string file = folder.file("p.awl", "Network 1\nLD I0.0\n" + repeated(200'000, [](std::size_t i) {
                                                  const std::string bit = "." + std::to_string(i % 8) + "\n";
                                                  return "LPS\nA V" + std::to_string(i / 8 % 4000) + bit + "= V" +
                                                         std::to_string(4000 + i / 8 % 4000) + bit + "LPP\n";
                                                }) + "= Q0.0\n");
  for (const char* command : {"lint", "show"}) {
    const ProcessRun made = execute({command, "--isolated", file});
    EXPECT_FALSE(made.isCut) << command;
    EXPECT_LT(made.peakBytes, 1000 * mebibyte) << command;
  }
}

// Outputs of one rung, contacts in series and in parallel: each is looked at once.
TEST(LargeInput, OneRungOfManyElements) {
  const TemporaryFolder folder;
  const auto bit = [](std::size_t i) {
    return "V" + std::to_string(i / 8 % 4000) + "." + std::to_string(i % 8) + "\n";
  };
  const std::string outputs = folder.file(
      "outputs.awl", "Network 1\nLD I0.0\n" + repeated(200'000, [&](std::size_t i) { return "= " + bit(i); }));
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"lint"}, {"sim", "--scans", "2"}, {"xref"}, {"show"}}) {
    std::vector<std::string> arguments = command;
    arguments.insert(arguments.end(), {"--isolated", outputs});
    const ProcessRun made = execute(arguments);
    EXPECT_FALSE(made.isCut) << command.front();
    EXPECT_LT(made.peakBytes, 1000 * mebibyte) << command.front();
  }
  for (const char* contact : {"A ", "O "}) {
    const std::string file = folder.file("rung.awl", "Network 1\nLD I0.0\n" + repeated(200'000, [&](std::size_t i) {
                                                       return contact + bit(i);
                                                     }) + "= Q0.0\n");
    const ProcessRun shown = execute({"show", "--isolated", file});
    EXPECT_FALSE(shown.isCut) << contact;
    EXPECT_LT(shown.peakBytes, 1000 * mebibyte) << contact;
  }
}

TEST(LargeInput, ManyNetworksAreShownAndTheirAddressesLookedUp) {
  const TemporaryFolder folder;
  const std::string file = folder.file("p.awl", repeated(60'000, [](std::size_t i) {
                                         const std::string bit = "." + std::to_string(i % 8) + "\n";
                                         return "Network " + std::to_string(i + 1) + "\nLD V" +
                                                std::to_string(i / 8 % 5000) + bit + "= M" +
                                                std::to_string(i / 8 % 30) + bit;
                                       }));
  for (const char* command : {"show", "lint"}) EXPECT_FALSE(execute({command, "--isolated", file}).isCut) << command;
}

// Each type is found by its number, each member by its name.
TEST(LargeInput, ManyTypesOfMembers) {
  const TemporaryFolder folder;
  const std::string file = folder.file(
      "p.awl", repeated(20'000,
                        [](std::size_t i) {
                          return "TYPE UDT " + std::to_string(i + 1) + "\nSTRUCT\n a : INT ;\nEND_STRUCT ;\nEND_TYPE\n";
                        }) +
                   "DATA_BLOCK DB 1\nSTRUCT\n" +
                   repeated(20'000,
                            [](std::size_t i) {
                              return " a" + std::to_string(i) + " : UDT " + std::to_string(i + 1) + " ;\n";
                            }) +
                   "END_STRUCT ;\nBEGIN\nEND_DATA_BLOCK\nORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n A I 0.0;\n"
                   " = Q 0.0;\nEND_ORGANIZATION_BLOCK\n");
  EXPECT_FALSE(execute({"lint", "--isolated", file}).isCut);
}

TEST(LargeInput, ALineOfMegabytesIsShownInPart) {
  const TemporaryFolder folder;
  const ProcessRun made = execute({"lint", "--isolated", folder.file("p.awl", std::string(20'000'000, 'A'))});
  EXPECT_LT(made.peakBytes, 400 * mebibyte);
  EXPECT_LT(made.output.size(), 2000U);
  EXPECT_NE(made.output.find("..."), std::string::npos) << made.output;
}

TEST(LargeInput, ColumnsAndNamesAreLookedUpOnce) {
  const TemporaryFolder folder;
  const std::string table =
      folder.file("t.csv", "scan" + repeated(200'000, [](std::size_t i) { return ",s" + std::to_string(i); }) + "\n1" +
                               repeated(200'000, [](std::size_t) { return ",1"; }) + "\n");
  const ProcessRun compared = execute({"compare", table, table});
  EXPECT_FALSE(compared.isCut);
  EXPECT_NE(compared.output.find("traces agree"), std::string::npos) << compared.output.substr(0, 500);
  const std::string program = folder.file(
      "p.awl",
      repeated(200'000, [](std::size_t i) { return "//@ prove p" + std::to_string(i) + ": Q0.0 implies I0.0\n"; }) +
          "//@ prove p7: Q0.0 implies I0.0\n" + oneRung);
  const ProcessRun linted = execute({"lint", "--isolated", program});
  EXPECT_FALSE(linted.isCut);
  EXPECT_NE(linted.output.find("the name 'p7' is already taken"), std::string::npos) << linted.output.substr(0, 500);
}

// Each pair of writers of a bit was looked for along all paths of the block.
TEST(LargeInput, WritersOfOneBitInALongBlock) {
  const TemporaryFolder folder;
  const std::string file =
      folder.file("p.awl", "ORGANIZATION_BLOCK OB 1\nBEGIN\n" + repeated(200'000, [](std::size_t i) {
                             return "NETWORK\n A I 0.0;\n = M " + std::to_string(i / 8 % 2000) + "." +
                                    std::to_string(i % 8) + ";\n";
                           }) + "END_ORGANIZATION_BLOCK\n");
  EXPECT_FALSE(execute({"lint", "--isolated", "--quiet", file}).isCut);
}

// A row of operators is as deep a tree as it is long. No program writes two thousand of them.
TEST(LargeInput, LongExpressionsOfStructuredTextAreReadOrRefused) {
  const TemporaryFolder folder;
  const auto lint = [&](std::size_t operators, const std::string& begin = "", const std::string& end = "") {
    const std::string text = begin + "a" + repeated(operators, [](std::size_t) { return " AND a"; }) + end;
    return run({"lint", "--isolated",
                folder.file("p.st", "PROGRAM P\nVAR\n  a, q : BOOL;\nEND_VAR\nq := " + text + ";\nEND_PROGRAM\n")});
  };
  EXPECT_NE(lint(2000).exit, 2);
  const ProgramRun chain = lint(100'000);
  EXPECT_EQ(chain.exit, 2);
  EXPECT_NE((chain.out + chain.err).find("at most 2000 operators"), std::string::npos) << chain.out << chain.err;
  std::string begin;
  for (int level = 0; level < 100; ++level)
    begin += "(a" + repeated(1000, [](std::size_t) { return " AND a"; }) + " AND ";
  EXPECT_EQ(lint(0, begin, std::string(100, ')')).exit, 2);
}

TEST(LargeInput, DeepNestingIsAnAnswerOrARefusal) {
  const TemporaryFolder folder;
  constexpr std::size_t depth = 100'000;
  const std::string program = folder.file("p.awl", oneRung), open(depth, '['), close(depth, ']');
  const ProgramRun baseline = run({"lint", "--isolated", "--baseline", folder.file("b.json", open + close), program});
  EXPECT_EQ(baseline.exit, 2) << baseline.out << baseline.err;
  for (const std::string& toml :
       {"inputs = " + open + close, "a." + repeated(depth, [](std::size_t) { return "a."; }) + "b = 1",
        repeated(depth, [](std::size_t) { return "[[a.b]]\n"; })})
    EXPECT_EQ(run({"lint", "--config", folder.file("c.toml", toml + "\n"), program}).exit, 2);
  for (const std::string& statement : {std::string(depth, '(') + "I0.0" + std::string(depth, ')'),
                                       repeated(depth, [](std::size_t) { return "not "; }) + "I0.0"}) {
    const ProcessRun proved =
        execute({"prove", "--isolated", "--props", folder.file("p.prop", "prove p: " + statement + "\n"), program});
    EXPECT_FALSE(proved.isCut) << proved.output.substr(0, 500);
  }
}

}  // namespace
}  // namespace rungproof::test
