// The head of a stored block as text: attributes and declarations, up to its body.
#pragma once

#include <string>

#include "frontend/mc7/stored_block.hpp"

namespace rungproof::mc7 {

struct BlockHead {
  std::string text;   ///< from FUNCTION to the last END_VAR
  std::string fault;  ///< why the declaration cannot be read; empty: it can
};

/// `withProtection`: KNOW_HOW_PROTECT stands in it.
BlockHead headOf(const StoredBlock& block, bool withProtection);
/// "END_FUNCTION" and the like.
std::string_view endKeywordOf(step7::BlockKind kind);
/// A text of people on lines of their own, behind // each.
std::string asRemarks(std::string_view text);
/// A title, which has one line.
std::string asTitle(std::string_view text);

}  // namespace rungproof::mc7
