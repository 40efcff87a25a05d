// Silencing of findings by comments `// rungproof: allow ADR001 REASON`. A comment behind an instruction, or alone on
// the line before one, speaks for that instruction's line; before the first instruction of a network for the network;
// in the head of a block for the block; in a text of IEC 61131-3, which has no networks, one alone on its line speaks
// for the line of code below it, or in the head of a block for the block; between `// rungproof: begin ADR001 REASON`
// and `// rungproof: end` for all that stands there in the file. A comment that silences nothing is a finding itself
// (SUP001), and so is one that names no rule or gives no reason (SUP002). Tested by tests/cli/suppress_test.cpp.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ir/program.hpp"

namespace rungproof {

enum class AllowScope : std::uint8_t { Line, Network, Block, Range };

/// One allow-comment.
struct Allow {
  Span comment;
  std::vector<std::string> ids;  ///< as written, in capitals
  std::string reason;
  std::string problem;  ///< why it silences nothing; empty if it is well formed
  AllowScope scope = AllowScope::Line;
  std::uint32_t line = 0;    ///< Line: the line it speaks for
  std::uint32_t until = 0;   ///< Range: where the comment stands that ends it
  const Pou* pou = nullptr;  ///< nullptr: a text has it outside of what runs
  const Network* network = nullptr;
  std::optional<Span> block;  ///< Block, of a text: the whole of it
};

/// All allow-comments of a program, in program order; comments that do not begin with "rungproof:" are not among them.
std::vector<Allow> allowsOf(const Program& program);

/// What the run knows about rule ids.
struct KnownRules {
  std::function<bool(std::string_view)> exists;
  std::function<bool(std::string_view)> ran;  ///< a comment for a rule that did not run is not called unused
};

/// Removes the silenced findings and adds those of SUP001 and SUP002; gives the number that was removed. Errors of the
/// readers stay, because a program that was not read cannot be judged.
std::size_t applySuppressions(const Program& program, const KnownRules& rules, std::vector<Finding>& findings);

}  // namespace rungproof
