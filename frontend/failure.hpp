// Failure: why the tool could not do what it was asked (exit code 2). Printed to standard error in the anatomy of
// findings: what, where, help. Findings about programs are ir/finding.hpp.
#pragma once

#include <iosfwd>
#include <string>

namespace rungproof {

struct Failure {
  std::string message;     ///< one sentence without a full stop
  std::string place = {};  ///< "rungproof.toml:3:1", a file name, or empty
  std::string help = {};   ///< what to do; may be empty
};

void print(std::ostream& err, const Failure& failure);

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
