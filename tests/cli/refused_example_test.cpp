// What lint refuses no other command executes: the bad example of every rule that refuses goes through sim, prove,
// export and equiv. A rule of severity error says whether the editor and the CPU take such a program: it refuses, or
// it stands in the list below.
#include <gtest/gtest.h>

#include <algorithm>

#include "analysis/rule.hpp"
#include "tests/program_run.hpp"

namespace rungproof {
namespace {

using test::ProgramRun;
using test::run;
using test::TemporaryFolder;

class RefusedExample : public ::testing::TestWithParam<const Rule*> {};

TEST_P(RefusedExample, IsExecutedByNoCommand) {
  const Rule& rule = *GetParam();
  const TemporaryFolder folder;
  const std::string file = folder.file("a.awl", std::string(rule.bad));
  std::vector<std::string> files = {file};
  if (!rule.exampleSymbols.empty()) files.push_back(folder.file("symbols.csv", std::string(rule.exampleSymbols)));
  const std::vector<std::string> cpu = {"--cpu", std::string(rule.exampleCpu)};
  const auto exitOf = [&](std::vector<std::string> line, bool isPair = false) {
    line.insert(line.end(), files.begin(), isPair ? files.begin() + 1 : files.end());
    if (isPair) line.push_back(file);
    line.insert(line.end(), cpu.begin(), cpu.end());
    const ProgramRun result = run(line);
    if (result.exit != 2) ADD_FAILURE() << line.front() << ": exit " << result.exit << '\n' << result.out << result.err;
    return result;
  };
  exitOf({"sim", "--scans", "1"});
  const ProgramRun proof = exitOf({"prove", "--builtin"});
  EXPECT_NE((proof.out + proof.err).find("is not executed"), std::string::npos) << proof.out << proof.err;
  exitOf({"export", "--builtin", "--format", "btor2"});
  exitOf({"equiv"}, true);
}

std::vector<const Rule*> refusingRules() {
  std::vector<const Rule*> rules;
  std::ranges::copy_if(allRules(), std::back_inserter(rules), [](const Rule* rule) {
    const bool takesExample = rule->id == "SCR001";  // its step without an exit is taken by the CPU
    return rule->refuses && rule->severity == Severity::Error && !takesExample;
  });
  return rules;
}

INSTANTIATE_TEST_SUITE_P(Rules, RefusedExample, ::testing::ValuesIn(refusingRules()),
                         [](const auto& info) { return std::string(info.param->id); });

/// Errors of programs that the editor and the CPU take, and of which the manual says what they do: the other commands
/// run them and show it.
struct Executed {
  std::string_view rule, why;
};
constexpr Executed executed[] = {
    {"ARI003", "only a run meets it: the CPU stops there (001:13934-13937), and so do runs and proofs"},
    {"DBA002", "only a run meets it: OB121 runs, or the CPU stops (002:1284-1290)"},
    {"DBA006", "only a run meets it: OB121 runs, or the CPU stops (002:1284-1290)"},
    {"HSP001", "only a run meets it: run-time errors 0001 and 000A, without effect (001:13949, 001:13958)"},
    {"IEC011", "the first of two equal labels is taken; the standard's CASE runs the first group that has the value"},
    {"LIB003", "the library block is known to write any value there at any call, and so no proof rests on it"},
    {"PRT001", "legal on the target, whose own meaning is run; the finding says what it meant on the other family"},
    {"PTR001", "only a run meets it: run-time errors 0006 and 0091, without effect (001:13954, 001:13968)"},
    {"PTR004", "run-time error 0091 in a run (001:13968); --choice block-move-overlap has both orders of an overlap"},
    {"SCR002", "an S bit is one bit of memory in whichever block it stands; the download takes it (001:13978-14008)"},
    {"STK001", "the manual says that the ninth level is lost (001:2870), not from which depth on 0081 refuses it"},
    {"SUB002", "only a run meets it: run-time error 0008, the call is left out; an S7-300/400 stops (001:13956)"},
    {"SUB006", "the box has one memory for all calls; two calls that exclude each other are legal (001:6771)"},
    {"TIM001", "each number has one current value, and each box does to it what its text says (001:4117)"},
};

TEST(ErrorRules, SayWhetherTheProgramIsExecuted) {
  for (const Rule* rule : allRules()) {
    if (rule->severity != Severity::Error || rule->check == nullptr) continue;
    EXPECT_NE(rule->refuses, std::ranges::find(executed, rule->id, &Executed::rule) != std::end(executed)) << rule->id;
  }
}

TEST(RefusedBoxes, TooFewInputsAreRefusedAndTooManyAreNot) {
  const TemporaryFolder folder;
  for (const char* box : {"CTD C1, 5", "CTU C1, 5", "SR M0.0, Q0.0", "RS M0.0, Q0.0"}) {
    const std::string text = test::mainBlock(std::string("Network 1\nLD I0.0\n") + box + "\n");
    EXPECT_EQ(run({"sim", "--scans", "1", folder.file("a.awl", text)}).exit, 2) << box;
  }
  const std::string shortBy2 = test::mainBlock("Network 1\nLD I0.0\nCTUD C1, 5\n");
  EXPECT_EQ(run({"sim", "--scans", "1", folder.file("a.awl", shortBy2)}).exit, 2);
  const std::string tooMany = test::mainBlock("Network 1\nLD I0.0\nLD I0.1\nLD I0.2\nCTU C1, 5\n");
  EXPECT_EQ(run({"sim", "--scans", "1", folder.file("a.awl", tooMany)}).exit, 0);
}

// What stands open at the end of a block or is closed without being open, and what the stacks do not hold (8 zones and
// 7 parentheses, general knowledge): all commands refuse it, in whatever family's words it is drawn.
TEST(RefusedNesting, LevelsThatDoNotPairAreExecutedByNoCommand) {
  const auto nested = [](const std::string& open, const std::string& inner, const std::string& close, int depth) {
    std::string text = "A I 0.0;\n";
    for (int i = 0; i < depth; ++i) text += open + ";\n";
    text += inner + "\n";
    for (int i = 0; i < depth; ++i) text += close + ";\n";
    return text;
  };
  const std::string use = "= Q 0.0;\n";
  const TemporaryFolder folder;
  const auto file = [&](const std::string& body) {
    return folder.file("p.awl", "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n" + body + "END_ORGANIZATION_BLOCK\n");
  };
  const std::vector<std::vector<std::string>> commands = {
      {"lint"}, {"sim", "--scans", "1"}, {"prove", "--builtin"}, {"export", "--builtin", "--format", "btor2"}};
  for (const std::string& body : {
           nested("A(", "A I 0.1;", ")", 9) + use,
           nested("A(", "A I 0.1;", ")", 8) + use,
           nested("MCR(", "A I 0.1;\n" + use, ")MCR", 9),
           std::string("A(;\nA I 0.0;\n") + use,
           std::string("A I 0.0;\n);\n") + use,
           std::string("A(;\nA I 0.0;\nBEC;\nA I 0.1;\n);\n") + use,
           "MCRA;\nA I 0.0;\nMCR(;\nA I 0.1;\n" + use,
           "A I 0.0;\n" + use + ")MCR;\n",
           std::string("MCRA;\nA I 0.0;\nMCR(;\nA I 0.1;\nJC m;\n)MCR;\nm: A I 0.2;\n") + use,
       }) {
    for (std::vector<std::string> command : commands) {
      command.push_back(file(body));
      const ProgramRun result = run(command);
      EXPECT_EQ(result.exit, command.front() == "lint" ? 1 : 2) << command.front() << body << result.out << result.err;
    }
    const ProgramRun both = run({"equiv", file(body), file(body)});
    EXPECT_EQ(both.exit, 2) << body << both.out << both.err;
    const std::string properties = folder.file("p.prop", "prove one: Q0.0 implies I0.0\n");
    const ProgramRun proof = run({"prove", "--props", properties, file(body)});
    EXPECT_EQ(proof.exit, 2) << body;
    EXPECT_TRUE(proof.says("NOT COVERED")) << body << proof.out << proof.err;
  }
  for (const std::string& body :
       {nested("A(", "A I 0.1;", ")", 7) + use, "MCRA;\n" + nested("MCR(", "A I 0.1;\n" + use, ")MCR", 8) + "MCRD;\n",
        "MCRA;\nA I 0.0;\nMCR(;\nA I 0.1;\n" + use + "A I 0.2;\nBEC;\n)MCR;\n"}) {
    EXPECT_EQ(run({"sim", "--scans", "1", file(body)}).exit, 0) << body;
  }
}

}  // namespace
}  // namespace rungproof
