// Pages of the S7-300/400: instructions, boxes of ladder and FBD, organization blocks, blocks of the CPU and the
// libraries, and what is not covered. Tested by tests/step7/explain_test.cpp.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "frontend/files/json.hpp"
#include "frontend/files/read_options.hpp"
#include "frontend/text/excerpt.hpp"

namespace rungproof {

struct Step7Page {
  std::string text;
  Json json;
};

/// The page of "A(", "ADD_I", "OB35", "SFC 20", "TON", "coverage"; capitals. With a set of mnemonics only the
/// instruction that it means by the word; otherwise both, where the sets disagree.
std::optional<Step7Page> step7Page(std::string_view word, Mnemonics mnemonics, const Paint& paint);
/// Whether the family has an instruction of that name.
bool isStep7Instruction(std::string_view word);
/// The places of programs beside which nothing is proved, one each: the lines of the guide and of the page "coverage".
std::vector<std::string> step7NotCovered();

}  // namespace rungproof
