// STY003: what counts as program text in a comment, and what only speaks of it.
#include <gtest/gtest.h>

#include "analysis/comment/swallowed_text.hpp"
#include "lint.hpp"

namespace rungproof::testing {
namespace {

CommentText codeIn(std::string_view comment) {
  return codeInComment(comment, [](std::string_view name) { return name == "Start_Button" || name == "Lamp"; });
}

std::string joinedCode(const std::vector<std::string>& instructions) {
  std::string text;
  for (const std::string& instruction : instructions) text += (text.empty() ? "" : "; ") + instruction;
  return text;
}

TEST(CommentedCode, SwallowedInstructionsAreFound) {
  for (const auto& [comment, instructions] :
       {std::pair{"// lamp test LD     I0.3=      Q0.5", "LD I0.3; = Q0.5"},
        std::pair{"//start buttonLD I0.0", "LD I0.0"}, std::pair{"// stop\tAN\tI0.1=\tQ0.0", "AN I0.1; = Q0.0"},
        std::pair{"// speed MOVW   VW0, VW2", "MOVW VW0, VW2"},
        std::pair{"// both hands LD I0.0 A I0.1 = Q0.0", "LD I0.0; A I0.1; = Q0.0"},
        std::pair{"// 灯测试LD     I0.3=      Q0.5", "LD I0.3; = Q0.5"},
        std::pair{"// проверка LD     I0.3 =      Q0.5", "LD I0.3; = Q0.5"},
        std::pair{"// runs on (5 s)TON    T37, 50", "TON T37, 50"},
        std::pair{"// end Network 4 // next LD     I0.0", "LD I0.0"},
        std::pair{"// high LDW>=  VW0, 100S      Q0.0, 1 // alarm", "LDW>= VW0, 100; S Q0.0, 1"},
        std::pair{"// by name LD     Start_Button=      Lamp", "LD Start_Button; = Lamp"},
        std::pair{"// start LD I0.0 // stop AN I0.1 // motor = Q0.0", "LD I0.0; AN I0.1; = Q0.0"},
        std::pair{"// start TON   T37, 50", "TON T37, 50"},
        std::pair{"// LD     I0.0=      Q0.0", "LD I0.0; = Q0.0"}}) {
    const CommentText found = codeIn(comment);
    EXPECT_EQ(found.kind, CommentedCode::Swallowed) << comment;
    EXPECT_EQ(joinedCode(found.instructions), instructions) << comment;
  }
}

TEST(CommentedCode, WhatSpeaksOfInstructionsIsNotSwallowed) {
  for (const char* comment :
       {"// motor = Q0.5", "// lamp= Q0.5", "// sensor A I0.1", "// switched ON I0.1", "// see network 5: LD I0.3",
        "// was: LD I0.0 A I0.1 = Q0.0", "// the rung (LD I0.3 = Q0.5) is in SBR1", "// MOVW VW0, VW2 copies the value",
        "// T37 = 5 s", "// I0.0 start, I0.1 stop, Q0.0 motor", "// reset by R Q0.0, 8", "// Q0.0 = I0.0 AND I0.1",
        "// uses LD I0.3, then = Q0.5 in the next network", "// old LD", "// S7-200 A I0.0", "//", "// ---- LD ----"})
    EXPECT_NE(codeIn(comment).kind, CommentedCode::Swallowed)
        << comment << ": " << joinedCode(codeIn(comment).instructions);
}

TEST(CommentedCode, SwitchedOffInstructionsAreTold) {
  for (const char* comment :
       {"// LD I0.0", "//A I0.1", "// MOVW VW0, VW2", "// = Q0.0", "// ton t37, 50", "//// S Q0.0, 1"})
    EXPECT_EQ(codeIn(comment).kind, CommentedCode::Disabled) << comment;
  for (const char* comment :
       {"// A new valve from 2004", "// LD", "// A 5", "// CALL the service", "// S Lamp", "// END"})
    EXPECT_EQ(codeIn(comment).kind, CommentedCode::None) << comment;
}

TEST(Sty003, WarnsOfSwallowedCodeAndNotesTheRestOnce) {
  const Linted linted(
      "Network 1 // lamp test LD     I0.3=      Q0.5\nLD I0.0\n// A I0.1\n// A I0.2\n= Q0.0\n// end\n// S Q0.1, 1\n");
  const std::vector<Finding> findings = linted.of("STY003");
  ASSERT_EQ(findings.size(), 3U);
  EXPECT_EQ(findings[0].severity, Severity::Warning);
  EXPECT_EQ(findings[0].message,
            "the comment has swallowed LD I0.3; = Q0.5: the end of its line was lost, so they are no part of the "
            "program");
  EXPECT_EQ(linted.program.sources->position(findings[0].span).column, 24U);
  EXPECT_EQ(findings[1].severity, Severity::Note);
  EXPECT_EQ(findings[1].message, "these 2 comments are program text");
  EXPECT_EQ(findings[2].message, "this comment is program text");
}

TEST(Sty003, SymbolsOfTheProgramAreOperands) {
  const std::string text = "Network 1\nLD I0.0 // release LD     Start=      Motor\n= Q0.0\n";
  EXPECT_EQ(Linted(text, {}, "Start\tI0.5\t\nMotor\tQ0.5\t\n").of("STY003").size(), 1U);
  EXPECT_EQ(Linted(text).of("STY003").size(), 0U);
}

TEST(Sty003, PropertiesAndExpectationsAreNoProgramText) {
  EXPECT_EQ(
      lines("STY003", "//@ prove a: never Q0.0 and Q0.1\n//! finding ADR001 MAIN 1\nNetwork 1\nLD I0.0\n= Q0.0\n"),
      Lines());
}

}  // namespace
}  // namespace rungproof::testing
