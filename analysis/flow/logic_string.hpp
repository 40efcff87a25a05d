// Logic strings of an S7-300/400 block: what is known of /FC, RLO and BR in front of each statement, where the RLO
// comes from, and how deep parentheses stand open. The effects follow those of ir/s7300/isa; the block begins with /FC
// 0 (a call and the start of an OB leave it so). Tested by tests/rules/nesting_rules_test.cpp.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "analysis/flow/statement_paths.hpp"
#include "ir/machine/statement_registers.hpp"

namespace rungproof {

/// Values that a bit may have: a set.
using BitValues = std::uint8_t;
inline constexpr BitValues mayBe0 = 1, mayBe1 = 2, mayBeAny = 3;

/// Who may have made a bit: a set.
using Makers = std::uint8_t;
inline constexpr Makers byBlock = 1, byCaller = 2, byCallee = 4;

struct LogicState {
  static constexpr std::uint8_t unknownDepth = 0xFF;

  BitValues firstCheck = mayBe0;  ///< /FC: 1 where a logic string goes on
  BitValues rlo = mayBeAny;
  Makers rloMaker = byCaller;
  Makers brMaker = byCaller;
  std::uint8_t depth = 0;                             ///< open parentheses; unknownDepth: paths differ
  std::array<std::uint32_t, nestingLevels> opened{};  ///< steps of those that are open

  bool join(const LogicState& other);
};

/// By step of the flow; one more at the end.
using LogicStates = std::vector<std::optional<LogicState>>;
LogicStates logicStates(const Flow& flow);

/// Whether the statement does something by the RLO that stands in front of it.
bool usesRlo(StatementRole role);
/// Whether the statement does another thing by /FC: it begins a logic string or goes on with it.
bool asksFirstCheck(StatementRole role);

}  // namespace rungproof
