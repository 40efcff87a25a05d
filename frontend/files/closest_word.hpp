// The word that a misspelled one was meant to be: for "did you mean" in errors about mnemonics, options, rules and
// keys. Tests: tests/golden/errors, tests/cli/settings_test.cpp.
#pragma once

#include <string_view>

namespace rungproof {

/// The candidate that was most likely meant, or empty: at most a third of the letters may differ.
template <class Names>
std::string_view closest(std::string_view written, const Names& names);

/// Number of letters to insert, delete, change or swap (neighbours) to come from one word to the other.
std::size_t editDistance(std::string_view a, std::string_view b);

template <class Names>
std::string_view closest(std::string_view written, const Names& names) {
  std::string_view best;
  std::size_t bestDistance = written.size() / 3 + 1;
  for (const auto& name : names) {
    const std::size_t distance = editDistance(written, name);
    if (distance > bestDistance || (distance == bestDistance && !best.empty())) continue;
    best = name;
    bestDistance = distance;
  }
  return best;
}

}  // namespace rungproof
