// Readers of the word-level exports, written from the definitions of the formats and not from the printers: they check
// declarations, sorts and the order of definitions, and can compute one step for given values, so that the texts can be
// compared with the system they came from. Mistakes throw std::runtime_error with the line.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace rungproof::test {

/// What a file says after one step.
struct WordStep {
  std::vector<std::uint64_t> next;  ///< by state variable
  std::vector<std::uint64_t> init;  ///< by state variable that has an initial value, else 0
  std::vector<bool> constraints;
  std::vector<bool> bads;
};

struct WordFileShape {
  std::vector<int> states;  ///< widths of state variables, in order
  std::vector<int> inputs;  ///< widths of inputs, in order
};

inline std::uint64_t mask(int width) { return width >= 64 ? ~0ULL : (1ULL << width) - 1; }

WordFileShape btor2Shape(const std::string& text);
WordStep btor2Step(const std::string& text, const std::vector<std::uint64_t>& states,
                   const std::vector<std::uint64_t>& inputs);

/// SMV: state variables are those with a next, inputs those without, both in the order of their declarations.
WordFileShape smvShape(const std::string& text);
WordStep smvStep(const std::string& text, const std::vector<std::uint64_t>& states,
                 const std::vector<std::uint64_t>& inputs);

}  // namespace rungproof::test
