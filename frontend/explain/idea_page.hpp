// Pages of ideas: the verdicts, the methods that stand behind "by", and the words that reports use. One row each.
// Tested by tests/golden/explain/ideas.test, and that every method has one by tests/cli/idea_test.cpp.
#pragma once

#include <span>
#include <string_view>

namespace rungproof {

struct Idea {
  std::string_view name;  ///< as reports print it
  std::string_view text;
};

std::span<const Idea> ideas();
/// By name in any case; "3-induction" is k-induction. nullptr: none.
const Idea* ideaNamed(std::string_view word);

}  // namespace rungproof
