// NST001: parentheses of a logic string and zones of the master control relay that are not closed, closed without being
// open, or nested too deep. Tested by its examples and tests/rules/nesting_rules_test.cpp.
#include <fmt/format.h>

#include <array>

#include "analysis/flow/logic_string.hpp"
#include "analysis/flow/step7_blocks.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

/// Zones of the master control relay that are open in front of a statement, as LogicState has parentheses.
struct ZoneState {
  static constexpr std::uint8_t unknownDepth = LogicState::unknownDepth;

  std::uint8_t depth = 0;
  std::array<std::uint32_t, mcrLevels> opened{};  ///< steps of those that are open

  bool join(const ZoneState& other) {
    if (depth == unknownDepth || depth == other.depth) return false;
    depth = unknownDepth;
    return true;
  }
};

std::vector<std::optional<ZoneState>> zoneStates(const Flow& flow) {
  const auto roleOf = [](const FlowStep& step) { return statementRole(*step.instruction); };
  if (std::ranges::none_of(flow.steps, isOfRelay, roleOf)) return {};
  return statesOf(flow, ZoneState{}, [&](ZoneState& state, const FlowStep& step) {
    if (state.depth == ZoneState::unknownDepth) return;
    const StatementRole role = roleOf(step);
    if (role == StatementRole::OpenRelay && state.depth < mcrLevels)
      state.opened[state.depth++] = static_cast<std::uint32_t>(&step - flow.steps.data());
    if (role == StatementRole::CloseRelay && state.depth > 0) --state.depth;
  });
}

/// Parentheses or zones: what opens and closes them, and how they are called.
struct Brackets {
  StatementRole opens, closes;
  std::size_t levels;
  std::string_view several;  ///< what is open
  std::string_view closing;  ///< what closes
  std::string_view stack;
  std::string_view openers;
  std::string_view instead;  ///< of one more level
  bool isJoinedAtEnd;        ///< what stays open at a conditional end is joined with what the caller does next
};
constexpr Brackets parentheses = {StatementRole::Open,
                                  StatementRole::Close,
                                  nestingLevels,
                                  "parentheses",
                                  ")",
                                  "nesting stack",
                                  "A(, O( or X(",
                                  "keep a part of the logic in a temporary bit",
                                  true};
// The zones of a block end with it: general knowledge.
constexpr Brackets zones = {StatementRole::OpenRelay,
                            StatementRole::CloseRelay,
                            mcrLevels,
                            "MCR zones",
                            ")MCR",
                            "MCR stack",
                            "MCR(",
                            "state the condition at the outputs themselves",
                            false};

void reportOpen(const Facts& facts, FindingSink& sink, const Flow& flow, std::uint32_t openedAt, const Brackets& words,
                const Instruction* leaves) {
  const Instruction& open = *flow.steps[openedAt].instruction;
  Finding& finding = sink.report(
      open.span, leaves == nullptr ? fmt::format("{} is not closed before {} ends", Facts::text(open), flow.pou->name)
                                   : fmt::format("{} is still open where {} leaves {}", Facts::text(open),
                                                 Facts::text(*leaves), flow.pou->name));
  if (leaves != nullptr) finding.related.push_back({leaves->span, networkText(facts, leaves->id)});
  finding.help = fmt::format("write the missing {} before the {}", words.closing,
                             words.isJoinedAtEnd ? "result is used" : "block ends");
}

/// Reports the first mismatch: the depths that follow it say nothing.
template <class State>
void checkLevels(const Facts& facts, FindingSink& sink, const Flow& flow,
                 const std::vector<std::optional<State>>& states, const Brackets& words) {
  for (std::uint32_t at = 0; at < flow.steps.size() && !states.empty(); ++at) {
    if (!states[at]) continue;
    const State& state = *states[at];
    const Instruction& instruction = *flow.steps[at].instruction;
    const StatementRole role = statementRole(instruction);
    const bool leaves = role == StatementRole::End || (role == StatementRole::EndByRlo && words.isJoinedAtEnd);
    if (state.depth == State::unknownDepth) {
      Finding& finding = sink.report(instruction.span, fmt::format("{} is reached with different numbers of open {}",
                                                                   Facts::text(instruction), words.several));
      finding.help = fmt::format("close all {} before a jump and before a label", words.several);
      return;
    }
    if (role == words.closes && state.depth == 0) {
      Finding& finding = sink.report(instruction.span, fmt::format("this {} closes nothing", words.closing));
      finding.help = fmt::format("remove it, or write the {} that it belongs to", words.openers);
      return;
    }
    if (role == words.opens && state.depth == words.levels) {
      Finding& finding =
          sink.report(instruction.span, fmt::format("{} opens level {}; the {} holds {}", Facts::text(instruction),
                                                    words.levels + 1, words.stack, words.levels));
      finding.help = words.instead;
      return;
    }
    if (leaves && state.depth > 0)
      return reportOpen(facts, sink, flow, state.opened[state.depth - 1U], words, &instruction);
  }
  if (states.empty() || !states.back()) return;
  const State& end = *states.back();
  if (end.depth != State::unknownDepth && end.depth > 0)
    reportOpen(facts, sink, flow, end.opened[end.depth - 1U], words, nullptr);
}

void checkNst001(const Facts& facts, FindingSink& sink) {
  eachReadStretch(facts, [&](std::uint32_t, const Flow& flow) {
    checkLevels(facts, sink, flow, logicStates(flow), parentheses);
    checkLevels(facts, sink, flow, zoneStates(flow), zones);
  });
}

}  // namespace

extern constexpr Rule nst001_nesting_not_closed = {
    .id = "NST001",
    .title = "Nesting not closed or too deep",
    .severity = Severity::Error,
    .needs = Needs::Text,
    .detects =
        "A(, O(, X( that no ) closes before the block ends, a ) without one, more than seven levels, a label reached "
        "with different numbers of them open; the same of MCR( and )MCR, with eight levels",
    .why =
        "a level that stays open joins a later result with an old one; beyond the last level the oldest is lost; "
        "zones that do not pair are a fault of the MCR stack",
    .manual = "002:2707, 002:2825-2826",
    .bad = "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nA(;\nO I 0.0;\nO I 0.1;\n= Q 0.0;\nEND_ORGANIZATION_BLOCK\n",
    .good = "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nA(;\nO I 0.0;\nO I 0.1;\n);\n= Q 0.0;\nEND_ORGANIZATION_BLOCK\n",
    .exampleCpu = "319-3",
    .dialects = dialect::S7300,
    .ofLists = true,
    .refuses = true,
    .check = checkNst001,
};

}  // namespace rungproof
