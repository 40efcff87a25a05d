// Program text inside comments: whether a comment is an instruction that was switched off, or holds instructions that
// it has swallowed because the end of its line was lost on the way. What stands behind a comment on one line is no part
// of the program, although everybody reads it as one. Tested by tests/rules/comment_rules_test.cpp.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace rungproof {

enum class CommentedCode : std::uint8_t {
  None,      ///< words, or words that quote an instruction
  Disabled,  ///< nothing but an instruction
  Swallowed  ///< words and then instructions up to the end, or several instructions run together
};

struct CommentText {
  CommentedCode kind = CommentedCode::None;
  std::size_t begin = 0;                    ///< of the first instruction, in the text
  std::vector<std::string> instructions{};  ///< as they are written, blanks taken together
};

/// What a comment with its marker holds; `isName` tells whether a name may stand for an address.
CommentText codeInComment(std::string_view comment, const std::function<bool(std::string_view)>& isName);

}  // namespace rungproof
