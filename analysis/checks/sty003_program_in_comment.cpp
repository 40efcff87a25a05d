// STY003: a comment that is an instruction with an address. Off by default. Tested by its examples and
// tests/rules/data_rules_test.cpp.
#include <fmt/format.h>

#include <string>
#include <string_view>

#include "analysis/facts.hpp"
#include "analysis/rule.hpp"
#include "ir/isa.hpp"

namespace rungproof {

namespace {

char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }
bool isDigit(char c) { return c >= '0' && c <= '9'; }

/// Letters of an area, a number, and for bits a point and a digit.
bool isAddress(std::string_view word) {
  std::size_t letters = 0;
  if (!word.empty() && (word[0] == '*' || word[0] == '&')) word.remove_prefix(1);
  while (letters < word.size() && upper(word[letters]) >= 'A' && upper(word[letters]) <= 'Z') ++letters;
  if (letters == 0 || letters > 3 || letters == word.size()) return false;
  for (const char c : word.substr(letters)) {
    if (!isDigit(c) && c != '.') return false;
  }
  return true;
}

/// "LD I0.0", "MOVW VW0, VW2": a mnemonic with operands, all of them addresses or numbers and at least one an address.
bool isInstruction(std::string_view text) {
  const auto skip = [&] {
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t' || text.front() == '/')) text.remove_prefix(1);
  };
  const auto word = [&] {
    skip();
    const std::size_t end = text.find_first_of(" \t,");
    const std::string_view result = text.substr(0, end);
    text.remove_prefix(result.size());
    return result;
  };
  std::string mnemonic;
  for (const char c : word()) mnemonic += upper(c);
  const Desc* desc = instructionNamed(mnemonic);
  if (desc == nullptr || desc->operandCount == 0) return false;
  bool hasAddress = false;
  int operands = 0;
  while (true) {
    skip();
    if (text.starts_with(",")) text.remove_prefix(1);
    const std::string_view operand = word();
    if (operand.empty()) break;
    const bool isNumber =
        isDigit(operand.back()) && (isDigit(operand.front()) || operand.front() == '+' || operand.front() == '-');
    if (!isNumber && !isAddress(operand)) return false;
    hasAddress = hasAddress || isAddress(operand);
    ++operands;
  }
  return hasAddress && operands <= desc->operandCount;
}

void checkSty003(const Facts& facts, FindingSink& sink) {
  const SourceSet& sources = *facts.program().sources;
  const auto look = [&](const Comment& comment) {
    if (!isInstruction(sources.text(comment.span))) return;
    sink.report(comment.span, "this comment is program text").help =
        "remove it; old versions belong into the version control";
  };
  for (const Pou& pou : facts.program().pous) {
    for (const Comment& comment : pou.comments) look(comment);
    for (const Network& network : pou.networks) {
      for (const Comment& comment : network.comments) look(comment);
    }
  }
}

}  // namespace

extern constexpr Rule sty003_program_in_comment = {
    .id = "STY003",
    .title = "Program text in a comment",
    .severity = Severity::Note,
    .needs = Needs::Text,
    .detects = "a comment that reads as an instruction with its addresses",
    .why = "nobody knows whether it was switched off for a reason or forgotten",
    .bad = "Network 1\nLD I0.0\n// A I0.1\n= Q0.0\n",
    .good = "Network 1\nLD I0.0\n// the door switch is not wired yet\n= Q0.0\n",
    .peers = "SA0140; C4",
    .enabledByDefault = false,
    .check = checkSty003,
};

}  // namespace rungproof
