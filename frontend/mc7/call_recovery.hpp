// Calls as they were written: the compiler frames each by two BLD, between which it copies parameters. Where all of
// that is of its making, CALL with names stands for it; else the statements stay as they are. Tested by
// tests/mc7/call_recovery_test.cpp.
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "frontend/mc7/code_text.hpp"
#include "frontend/step7/block_catalogue.hpp"
#include "ir/s7300/declaration.hpp"

namespace rungproof::mc7 {

/// What a program knows of the block that a call names; nullptr: nothing.
using CalleeInterface = std::function<const s7300::Structure*(step7::BlockKey)>;

struct CallContext {
  const std::vector<CodeItem>& items;
  const CodeNames& names;
  const CalleeInterface& interface;
  const s7300::Structure* instance = nullptr;   ///< of the block itself, if it has one
  const s7300::Structure* temporary = nullptr;  ///< its local data; nullptr: their names are not known
  const std::set<std::uint32_t>& targets;       ///< offsets to which jumps lead
};

/// Whether some instruction may read the bit of local data that the compiler saves behind the first BLD of a call.
bool readsSavedBit(const std::vector<CodeItem>& items, std::uint32_t byte, unsigned bit);

struct RecoveredCall {
  std::size_t end = 0;             ///< index of the item behind it
  std::vector<std::string> lines;  ///< statements without semicolon
  std::uint32_t editorLines = 1;   ///< the editor has one for the call and one for each parameter
};

/// The call whose first BLD is items[index]; nothing if what follows is not exactly of the compiler's making.
std::optional<RecoveredCall> recoverCall(const CallContext& context, std::size_t index, std::size_t networkEnd);

/// UC FC and the like with its list as CALL: what it means is the same wherever it stands. Nothing where the callee is
/// not known, or where an entry has no operand of its own.
std::optional<std::string> callOf(const CallContext& context, const CodeItem& item);

}  // namespace rungproof::mc7
