// A section of variables opens with VAR and closes with END_VAR.
#include "frontend/editor/text_blocks.hpp"

#include <algorithm>

#include "frontend/stl/stl_lexer.hpp"

namespace rungproof {

using iec::IecToken;
using iec::TokenKind;

namespace {

bool isAnyWord(const IecToken& token, std::initializer_list<std::string_view> words) {
  return std::ranges::any_of(words, [&](std::string_view word) { return isWord(token, word); });
}

}  // namespace

bool isWord(const IecToken& token, std::string_view word) {
  return token.kind == TokenKind::Word && equalsIgnoringCase(token.text, word);
}

std::vector<TextBlock> textBlocksOf(const std::vector<IecToken>& tokens) {
  std::vector<TextBlock> blocks;
  for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
    for (const std::string_view word : {"PROGRAM", "FUNCTION", "FUNCTION_BLOCK", "ORGANIZATION_BLOCK"}) {
      if (!isWord(tokens[i], word)) continue;
      const std::string last = "END_" + std::string(word);
      std::size_t end = i;
      while (end + 1 < tokens.size() && !isWord(tokens[end], last)) ++end;
      // "PROGRAM P1 WITH Task : Main;" in a configuration is no block.
      if (!isWord(tokens[end], last)) continue;
      blocks.push_back({tokens[i + 1].text, word == "PROGRAM", i, end});
      i = end;
      break;
    }
  }
  return blocks;
}

void BlockWalk::next() {
  const IecToken& token = tokens_[i_++];
  depth_ += token.text == "(" ? 1 : token.text == ")" ? -1 : 0;
  if (i_ >= block_.end) return;
  const IecToken& now = tokens_[i_];
  const TextWord* const word = now.kind == TokenKind::Word ? structuredTextWord(now.text) : nullptr;
  if (word != nullptr && word->word.starts_with("VAR")) {
    section_ = word->word;
    declares_ = true;
  } else if (isWord(now, "END_VAR")) {
    section_ = {};
    declares_ = false;
  } else if (now.text == ":") {
    declares_ = false;
  } else if (now.text == ";") {
    declares_ = !section_.empty();
  }
}

bool BlockWalk::isVariable(const iec::ProjectSyntax* project) const {
  const IecToken& token = tokens_[i_];
  if (token.kind != TokenKind::Word || i_ == block_.begin + 1) return false;
  const IecToken& before = tokens_[i_ - 1];
  if (before.text == ".") return false;
  const bool isAssigned = i_ + 1 < tokens_.size() && (tokens_[i_ + 1].text == ":=" || tokens_[i_ + 1].text == "=>");
  if (depth_ > 0 && isAssigned) return false;  // "IN" of "T1(IN := x)"
  const bool isResult = before.text == ":" && i_ == block_.begin + 3;
  const bool isDeclared = !section_.empty() && !declares_;
  const bool isType = isDeclared && (before.text == ":" || isAnyWord(before, {"OF", "TO", "REF_TO"}));
  if (isResult || isType || isAnyWord(before, {"EXTENDS", "IMPLEMENTS"})) return false;
  // Steps and actions of a chart have names of their own.
  if (isAnyWord(before, {"STEP", "INITIAL_STEP", "ACTION", "TRANSITION", "FROM"})) return false;
  const bool isCall = i_ + 1 < tokens_.size() && tokens_[i_ + 1].text == "(";
  return !isCall || project == nullptr || std::ranges::none_of(project->blocks, [&](const iec::BlockSyntax& block) {
    return block.kind == iec::BlockKind::Function && equalsIgnoringCase(block.name, token.text);
  });
}

std::string_view sectionOf(const std::vector<IecToken>& tokens, const TextBlock& block, std::string_view name) {
  for (BlockWalk walk(tokens, block); !walk.atEnd(); walk.next()) {
    if (walk.declares() && isWord(tokens[walk.index()], name)) return walk.section();
  }
  return {};
}

}  // namespace rungproof
