// Exit codes of whole runs, where results and diagnostics go, and files that are written as a whole.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "frontend/command.hpp"
#include "frontend/settings/config.hpp"
#include "ir/hazard.hpp"
#include "schema_check.hpp"
#include "tests/program_run.hpp"

namespace rungproof {
namespace {

using test::ProgramRun;
using test::run;
using test::TemporaryFolder;

const std::string clean = test::mainBlock("Network 1 // lamp\nLD I0.0\n= Q0.0\n");
const std::string faulty = test::mainBlock("Network 1 // lamp\nLD I0.9\n= Q0.0\n");
const std::string unreadable = test::mainBlock("Network 1\nLD I0.9\nFROB Q0.0\n= Q0.0\n");

TEST(LintExit, CleanFoundFailed) {
  const TemporaryFolder folder;
  EXPECT_EQ(run({"lint", "--select", "ADR001", folder.file("clean.awl", clean)}).exit, 0);
  EXPECT_EQ(run({"lint", "--select", "ADR001", folder.file("faulty.awl", faulty)}).exit, 1);
  EXPECT_EQ(run({"lint", "--select", "ADR001", folder.file("unreadable.awl", unreadable)}).exit, 2);
  EXPECT_EQ(run({"lint", "--select", "ADR001", folder.path("nowhere.awl")}).exit, 2);
}

TEST(LintExit, UnreadableInputWinsOverFindings) {
  const TemporaryFolder folder;
  const ProgramRun result =
      run({"lint", "--select", "ADR001", "--format", "concise", folder.file("a.awl", unreadable)});
  EXPECT_EQ(result.exit, 2);
  EXPECT_NE(result.out.find("SYN010"), std::string::npos);
  EXPECT_NE(result.out.find("ADR001"), std::string::npos);  // the rest of the program is checked all the same
}

TEST(LintExit, FindingsBelowTheLevelDoNotCount) {
  const TemporaryFolder folder;
  const std::string file =
      folder.file("a.awl", test::mainBlock("Network 1\nLD I0.0 // rungproof: allow ADR001 nothing here\n= Q0.0\n"));
  EXPECT_EQ(run({"lint", "--select", "SUP,ADR", file}).exit, 1);
  EXPECT_EQ(run({"lint", "--select", "SUP,ADR", "--exit-zero", file}).exit, 0);
  const ProgramRun lenient = run({"lint", "--select", "SUP,ADR", "--fail-level", "error", file});
  EXPECT_EQ(lenient.exit, 0);
  EXPECT_NE(lenient.out.find("SUP001"), std::string::npos) << "shown all the same";
  const ProgramRun errorsOnly = run({"lint", "--select", "SUP,ADR", "--level", "error", file});
  EXPECT_EQ(errorsOnly.exit, 0);
  EXPECT_EQ(errorsOnly.out.find("SUP001"), std::string::npos);
}

TEST(Streams, ResultsGoToOutAndDiagnosticsToErr) {
  const TemporaryFolder folder;
  const ProgramRun found = run({"lint", "--select", "ADR001", folder.file("a.awl", faulty)});
  EXPECT_FALSE(found.out.empty());
  EXPECT_EQ(found.err, "");
  const ProgramRun wrong = run({"lint", "--select", "NIX", folder.path("a.awl")});
  EXPECT_EQ(wrong.out, "");
  EXPECT_FALSE(wrong.err.empty());
}

TEST(Streams, NoColourWithoutATerminal) {
  const TemporaryFolder folder;
  const std::string file = folder.file("a.awl", faulty);
  EXPECT_EQ(run({"lint", "--select", "ADR001", file}).out.find('\x1B'), std::string::npos);
  EXPECT_NE(run({"lint", "--select", "ADR001", "--color", "always", file}).out.find('\x1B'), std::string::npos);
}

TEST(CommonOptions, MayStandBeforeTheCommand) {
  const TemporaryFolder folder;
  const std::string file = folder.file("a.awl", test::mainBlock("Network 1\nLD SM0.0\nMOVW AIW0, VW3000\n"));
  EXPECT_EQ(run({"--cpu", "226", "lint", "--select", "ADR001", file}).exit, 0);
  EXPECT_EQ(run({"--cpu", "222", "lint", "--select", "ADR001", file}).exit, 1);  // V ends at 2047 on the 222
  EXPECT_EQ(run({"lint", "--cpu=222", "--select", "ADR001", file}).exit, 1);
}

TEST(CommonOptions, AreAcceptedByEveryCommand) {
  for (const Command* command : allCommands()) {
    const ProgramRun help =
        run({std::string(command->name), "--cpu", "224", "--seed", "7", "--color", "never", "--help"});
    EXPECT_EQ(help.exit, 0) << command->name << help.err;
    EXPECT_TRUE(help.out.starts_with("rungproof " + std::string(command->name) + " - ")) << help.out;
    EXPECT_FALSE(command->summary.empty()) << command->name;
  }
}

TEST(Format, ThreeOutputsFromOneRun) {
  const TemporaryFolder folder;
  const std::string file = folder.file("a.awl", faulty);
  const ProgramRun result = run({"lint", "--select", "ADR001", "--format", "concise", "--format",
                                 "json=" + folder.path("r.json"), "--format", "html=" + folder.path("r.html"), file});
  EXPECT_EQ(result.exit, 1);
  EXPECT_EQ(std::count(result.out.begin(), result.out.end(), '\n'), 1);
  const nlohmann::json schema =
      nlohmann::json::parse(test::contentOf(std::string(RUNGPROOF_SOURCE_DIR) + "/frontend/report/schema.json"));
  EXPECT_EQ(test::schemaFaults(nlohmann::json::parse(test::contentOf(folder.path("r.json"))), schema),
            std::vector<std::string>());
  EXPECT_TRUE(test::contentOf(folder.path("r.html")).starts_with("<!DOCTYPE html>"));
}

TEST(Format, AFileIsWrittenWholeOrNotAtAll) {
  const TemporaryFolder folder;
  const std::string file = folder.file("a.awl", clean);
  folder.file("taken/inside", "x");  // a folder of that name: the rename must fail
  EXPECT_EQ(run({"lint", "--format", "json=" + folder.path("taken"), file}).exit, 2);
  EXPECT_EQ(test::contentOf(folder.path("taken/inside")), "x");
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path("."))) count += entry.exists() ? 1 : 0;
  EXPECT_EQ(count, 2u);  // the program and the folder; no part of a file is left
}

TEST(Config, TheNearestFileCounts) {
  const TemporaryFolder folder;
  const std::string wide = test::mainBlock("Network 1\nLD SM0.0\nMOVW AIW0, VW3000\n");
  folder.file("rungproof.toml", "cpu = \"222\"\n");
  folder.file("deep/er/rungproof.toml", "cpu = 226\n");
  const std::string outer = folder.file("deep/a.awl", wide);
  const std::string inner = folder.file("deep/er/a.awl", wide);
  EXPECT_EQ(run({"lint", "--select", "ADR001", outer}).exit, 1);
  EXPECT_EQ(run({"lint", "--select", "ADR001", inner}).exit, 0);
  EXPECT_EQ(run({"lint", "--select", "ADR001", "--isolated", outer}).exit, 0);
  EXPECT_EQ(run({"lint", "--select", "ADR001", "--cpu", "226", outer}).exit, 0);
  EXPECT_EQ(run({"lint", "--select", "ADR001", "--isolated", "--config", folder.path("rungproof.toml"), inner}).exit,
            1);
}

/// The line of `rungproof config` for a key, without runs of blanks.
std::string configLine(const std::string& text, const std::string& key) {
  const std::size_t begin = text.find("\n" + key + " = ");
  if (begin == std::string::npos) return {};
  std::string line = text.substr(begin + 1, text.find('\n', begin + 1) - begin - 1);
  for (std::size_t at = line.find("  "); at != std::string::npos; at = line.find("  ")) line.erase(at, 1);
  return line;
}

TEST(Config, EveryValueNamesItsOrigin) {
  const TemporaryFolder folder;
  folder.file("rungproof.toml",
              "# the plant\nlevel = \"warning\"\nselect = [\"ADR\", \"SUP\"]\nquiet = true\n\n[choices]\nwatchdog = "
              "\"300ms\"\n");
  const std::string program = folder.file("sub/a.awl", clean);
  const std::string text = run({"config", program, "--seed", "7", "--choice", "first-edge=first-execution"}).out;
  const auto endsWith = [&](const std::string& key, const std::string& value, const std::string& place) {
    const std::string line = configLine(text, key);
    EXPECT_TRUE(line.starts_with(key + " = " + value + " # ")) << line;
    EXPECT_TRUE(line.ends_with(place)) << line;
  };
  endsWith("level", "\"warning\"", "rungproof.toml:2");
  endsWith("select", "[\"ADR\", \"SUP\"]", "rungproof.toml:3");
  endsWith("quiet", "true", "rungproof.toml:4");
  endsWith("watchdog", "\"300ms\"", "rungproof.toml:7");
  endsWith("seed", "\"7\"", "# command line");
  endsWith("first-edge", "\"first-execution\"", "# command line");
  endsWith("edition", "\"2004\"", "# default");
}

// The pages of run-time errors and open points are made from their tables; each row must be there.
TEST(Explain, TablesAreShownWhole) {
  const std::string hazards = run({"explain", "hazards"}).out;
  for (const HazardInfo& info : hazardTable) EXPECT_NE(hazards.find(info.manual), std::string::npos) << info.text;
  const std::string choices = run({"explain", "choices"}).out;
  for (const ChoiceInfo& info : choiceTable) {
    EXPECT_NE(choices.find(fmt::format("  {}: {} (chosen)", info.key, info.values[0])), std::string::npos) << info.key;
  }
}

TEST(Config, WhatItPrintsCanBeReadAgain) {
  const TemporaryFolder folder;
  const ProgramRun first =
      run({"config", "--isolated", "--cpu", "224", "--select", "ADR,SUP", "--choice", "watchdog=300ms"});
  const std::string saved = folder.file("saved.toml", first.out);
  const nlohmann::json again = nlohmann::json::parse(run({"config", "--config", saved, "--format", "json"}).out);
  EXPECT_EQ(again["options"]["cpu"]["value"], "224");
  EXPECT_EQ(again["options"]["select"]["value"], (std::vector<std::string>{"ADR", "SUP"}));
  EXPECT_EQ(again["choices"]["watchdog"]["value"], "300ms");
}

TEST(Config, TheSchemaKnowsEveryKeyOfTheOutput) {
  const nlohmann::json schema = nlohmann::json::parse(run({"config", "--isolated", "--format", "schema"}).out);
  const nlohmann::json now = nlohmann::json::parse(run({"config", "--isolated", "--format", "json"}).out);
  for (const auto& [key, value] : now["options"].items()) EXPECT_TRUE(schema["properties"].contains(key)) << key;
  for (const auto& [key, value] : now["choices"].items()) {
    const nlohmann::json& known = schema["properties"]["choices"]["properties"][key]["enum"];
    EXPECT_NE(std::find(known.begin(), known.end(), value["value"]), known.end()) << key;
  }
}

// bash itself reads the script and completes commands, options and values.
TEST(Completion, BashCompletes) {
  const TemporaryFolder folder;
  const std::string script = folder.file("completion.bash", run({"completion", "bash"}).out);
  const auto complete = [&](const std::string& words, int current) {
    const std::string output = folder.path("reply");
    const std::string command = "bash -c 'source " + script + "; COMP_WORDS=(" + words +
                                "); COMP_CWORD=" + std::to_string(current) +
                                "; _rungproof; printf \"%s \" \"${COMPREPLY[@]}\"' > " + output;
    EXPECT_EQ(std::system(command.c_str()), 0);
    return test::contentOf(output);
  };
  EXPECT_EQ(complete("rungproof li", 1), "lint ");
  EXPECT_EQ(complete("rungproof lint --cpu 226", 3), "226 226XM ");
  EXPECT_EQ(complete("rungproof lint --no-s", 2), "--no-suppress ");
  EXPECT_EQ(complete("rungproof explain SUP00", 2), "SUP001 SUP002 SUP003 ");
  EXPECT_EQ(complete("rungproof completion z", 2), "zsh ");
}

TEST(Completion, EveryShellNamesEveryCommand) {
  for (const char* shell : {"bash", "zsh", "fish"}) {
    const std::string script = run({"completion", shell}).out;
    for (const Command* command : allCommands())
      EXPECT_NE(script.find(command->name), std::string::npos) << shell << ' ' << command->name;
  }
}

/// As an editor of Windows writes it: with a byte order mark, or a comment in CP1252.
TEST(PropertyFiles, OfAnyEncodingAreRead) {
  const TemporaryFolder folder;
  const std::string file = folder.file("a.awl", test::mainBlock("Network 1\nLD I0.0\n= Q0.0\n"));
  const std::string statement = "prove lamp: Q0.0 implies I0.0\n";
  for (const std::string& head : {std::string("\xEF\xBB\xBF"), std::string("# Pr\xFC"
                                                                           "fung\n")}) {
    const ProgramRun result = run({"prove", "--props", folder.file("a.prop", head + statement), file});
    EXPECT_EQ(result.exit, 0) << result.out;
    EXPECT_NE(result.out.find("PROVED  lamp"), std::string::npos);
  }
}

}  // namespace
}  // namespace rungproof
