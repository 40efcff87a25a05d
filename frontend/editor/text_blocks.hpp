// The blocks of a text of IEC 61131-3 as their tokens show them: what is declared in them, and which words may be
// variables. Tested by tests/editor/rename_test.cpp and structured_navigation_test.cpp.
#pragma once

#include <string_view>
#include <vector>

#include "frontend/editor/structured_text.hpp"
#include "ir/iec/syntax.hpp"

namespace rungproof {

bool isWord(const iec::IecToken& token, std::string_view word);

/// A PROGRAM, FUNCTION or FUNCTION_BLOCK: its tokens, from its first word to its END.
struct TextBlock {
  std::string_view name;
  bool isProgram = false;
  std::size_t begin = 0, end = 0;
};
std::vector<TextBlock> textBlocksOf(const std::vector<iec::IecToken>& tokens);

/// Walks over the tokens of a block and knows whether a section of variables is open.
class BlockWalk {
 public:
  BlockWalk(const std::vector<iec::IecToken>& tokens, const TextBlock& block)
      : tokens_(tokens), block_(block), i_(block.begin) {}

  bool atEnd() const { return i_ >= block_.end; }
  std::size_t index() const { return i_; }
  std::string_view section() const { return section_; }
  bool declares() const { return declares_; }  ///< before the colon
  void next();
  /// Whether the word here may be a variable of the block.
  bool isVariable(const iec::ProjectSyntax* project) const;

 private:
  const std::vector<iec::IecToken>& tokens_;
  const TextBlock& block_;
  std::size_t i_;
  std::string_view section_;
  bool declares_ = false;
  int depth_ = 0;
};

/// The section that declares a name of the block: "VAR_INPUT"; empty if none does.
std::string_view sectionOf(const std::vector<iec::IecToken>& tokens, const TextBlock& block, std::string_view name);

}  // namespace rungproof
