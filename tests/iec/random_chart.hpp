// Random charts beside a token game that is played with plain sets and stopwatches: nothing of reader, lowering and
// engine is shared. All four readings of charts are drawn too. Scans last 10 ms.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "tests/iec/iec_run.hpp"

namespace rungproof::iec_chart {

struct TokenStep {
  bool isActive = false, wasActive = false;
  std::int64_t time = 0;
};

struct TokenAssociation {
  std::size_t step;
  std::string qualifier;
  std::int64_t duration;
  bool isStored = false;
  std::int64_t storedFor = 0;
};

struct TokenAction {
  std::string name;
  bool isBody;
  std::vector<TokenAssociation> uses;
  bool isActive = false;
  std::int64_t value = 0;  ///< of the variable; of a body the number of its runs
};

struct TokenTransition {
  std::vector<std::size_t> from, to;
  std::int64_t priority;
  std::string text;
  std::function<bool(const std::vector<TokenStep>&, const std::vector<bool>&)> condition;
};

class TokenGame {
 public:
  explicit TokenGame(std::uint64_t seed) : random_(seed) {
    steps_.resize(static_cast<std::size_t>(pick(2, 5)));
    steps_[0].isActive = true;
    for (const char* const name : {"q0", "q1", "n1", "n0"}) actions_.push_back({name, name[0] == 'n', {}, false, 0});
    for (std::size_t step = 0; step < steps_.size(); ++step) {
      for (TokenAction& action : actions_) {
        if (pick(0, 2) == 0) associate(action, step);
      }
    }
    const std::int64_t count = pick(2, 7);
    for (int i = 0; i < count; ++i) addTransition();
    actionsFirst_ = pick(0, 1) == 0;
    initialEdge_ = pick(0, 1) == 0;
    finalScan_ = pick(0, 1) == 0;
    alphabetical_ = pick(0, 1) == 0;
  }

  std::string text() const {
    std::string chart;
    for (std::size_t step = 0; step < steps_.size(); ++step) {
      chart += fmt::format("{}STEP S{}:", step == 0 ? "INITIAL_" : "", step);
      for (const TokenAction& action : actions_) {
        for (const TokenAssociation& use : action.uses) {
          if (use.step != step) continue;
          chart += fmt::format(" {}({}{});", action.name, use.qualifier,
                               use.duration > 0 ? fmt::format(", T#{}ms", use.duration) : std::string());
        }
      }
      chart += " END_STEP\n";
    }
    for (const TokenTransition& t : transitions_) {
      chart += fmt::format("TRANSITION (PRIORITY := {}) FROM ({}) TO ({}) := {}; END_TRANSITION\n", t.priority,
                           names(t.from), names(t.to), t.text);
    }
    chart += "ACTION n1: n1v := n1v + 1; last := 1; END_ACTION\nACTION n0: n0v := n0v + 1; last := 2; END_ACTION\n";
    return iecProgram("VAR_INPUT x0, x1, x2 : BOOL; END_VAR VAR q0, q1 : BOOL; n0v, n1v, last : INT; END_VAR", chart);
  }
  IecChoices choices() const {
    return {{"iec-sfc-order", actionsFirst_ ? "actions-first" : "transitions-first"},
            {"iec-sfc-initial-edge", initialEdge_ ? "yes" : "no"},
            {"iec-sfc-final-scan", finalScan_ ? "yes" : "no"},
            {"iec-sfc-action-order", alphabetical_ ? "alphabetical" : "declaration"}};
  }

  void scan(const std::vector<bool>& inputs) {
    for (TokenStep& step : steps_) {
      if (step.isActive && hasBegun_) step.time += 10;
    }
    if (!hasBegun_) steps_[0].wasActive = !initialEdge_;
    if (actionsFirst_) act();
    evolve(inputs);
    if (!actionsFirst_) act();
    hasBegun_ = true;
  }

  std::int64_t pick(std::int64_t low, std::int64_t high) {
    return std::uniform_int_distribution<std::int64_t>(low, high)(random_);
  }
  const std::vector<TokenStep>& steps() const { return steps_; }
  const std::vector<TokenAction>& actions() const { return actions_; }
  std::int64_t last() const { return last_; }

 private:
  static std::string names(const std::vector<std::size_t>& list) {
    std::string text;
    for (const std::size_t step : list) text += fmt::format("{}S{}", text.empty() ? "" : ", ", step);
    return text;
  }
  void associate(TokenAction& action, std::size_t step) {
    static const char* const qualifiers[] = {"N", "N", "S", "R", "L", "D", "P", "P0", "P1", "SD", "DS", "SL"};
    const std::string qualifier = qualifiers[pick(0, 11)];
    const bool isTimed = qualifier == "L" || qualifier == "D" || (qualifier.size() == 2 && qualifier[0] != 'P');
    action.uses.push_back({step, qualifier, isTimed ? 10 * pick(1, 4) : 0});
  }
  std::vector<std::size_t> someSteps() {
    std::vector<std::size_t> made = {static_cast<std::size_t>(pick(0, static_cast<std::int64_t>(steps_.size()) - 1))};
    const auto other = static_cast<std::size_t>(pick(0, static_cast<std::int64_t>(steps_.size()) - 1));
    if (other != made[0] && pick(0, 2) == 0) made.push_back(other);
    return made;
  }
  void addTransition() {
    TokenTransition made;
    made.from = someSteps();
    made.to = someSteps();
    made.priority = pick(1, 3);
    const auto input = static_cast<std::size_t>(pick(0, 2));
    const std::size_t step = made.from[0];
    const std::int64_t duration = 10 * pick(1, 3);
    switch (pick(0, 4)) {
      case 0:
        made.text = fmt::format("NOT x{}", input);
        made.condition = [input](const auto&, const std::vector<bool>& in) { return !in[input]; };
        break;
      case 1:
        made.text = fmt::format("S{}.T >= T#{}ms", step, duration);
        made.condition = [step, duration](const std::vector<TokenStep>& s, const auto&) {
          return s[step].time >= duration;
        };
        break;
      case 2:
        made.text = fmt::format("S0.X AND x{}", input);
        made.condition = [input](const std::vector<TokenStep>& s, const std::vector<bool>& in) {
          return s[0].isActive && in[input];
        };
        break;
      default:
        made.text = fmt::format("x{}", input);
        made.condition = [input](const auto&, const std::vector<bool>& in) { return in[input]; };
    }
    transitions_.push_back(std::move(made));
  }

  /// Tokens are taken on the situation of before; the lowest number first, then from left to right.
  void evolve(const std::vector<bool>& inputs) {
    std::vector<const TokenTransition*> order;
    for (std::int64_t priority = 1; priority <= 3; ++priority) {
      for (const TokenTransition& t : transitions_) {
        if (t.priority == priority) order.push_back(&t);
      }
    }
    std::vector<bool> tokens;
    for (const TokenStep& step : steps_) tokens.push_back(step.isActive);
    std::vector<const TokenTransition*> fired;
    for (const TokenTransition* t : order) {
      const bool isEnabled = std::ranges::all_of(t->from, [&](std::size_t s) { return tokens[s]; });
      if (!isEnabled || !t->condition(steps_, inputs)) continue;
      for (const std::size_t s : t->from) tokens[s] = false;
      fired.push_back(t);
    }
    for (const TokenTransition* t : fired) {
      for (const std::size_t s : t->from) steps_[s].isActive = false;
    }
    for (const TokenTransition* t : fired) {
      for (const std::size_t s : t->to) steps_[s] = {true, steps_[s].wasActive, 0};
    }
  }

  bool isReset(const TokenAction& action) const {
    return std::ranges::any_of(
        action.uses, [&](const TokenAssociation& use) { return use.qualifier == "R" && steps_[use.step].isActive; });
  }

  /// Whether this association makes its action active in this scan.
  bool makesActive(TokenAssociation& use, bool resets) {
    const TokenStep& step = steps_[use.step];
    const std::string& q = use.qualifier;
    if (q == "N") return step.isActive;
    if (q == "L") return step.isActive && step.time < use.duration;
    if (q == "D") return step.isActive && step.time >= use.duration;
    if (q == "P" || q == "P1") return step.isActive && !step.wasActive;
    if (q == "P0") return !step.isActive && step.wasActive;
    if (q == "R") return false;
    const bool sets = q == "DS" ? step.isActive && step.time >= use.duration : step.isActive;
    const bool stayed = use.isStored;
    use.isStored = !resets && (use.isStored || sets);
    use.storedFor = use.isStored && stayed ? use.storedFor + 10 : 0;
    if (q == "SD") return use.isStored && use.storedFor >= use.duration;
    if (q == "SL") return use.isStored && use.storedFor < use.duration;
    return use.isStored;
  }

  void act() {
    std::vector<TokenAction*> running, ending;
    for (TokenAction& action : actions_) {
      const bool wasActive = action.isActive, resets = isReset(action);
      bool isActive = false, isPulsed = false;
      for (TokenAssociation& use : action.uses) {
        const bool made = makesActive(use, resets);
        const bool isApart = action.isBody && (use.qualifier == "P0" || use.qualifier == "P1");
        (isApart ? isPulsed : isActive) |= made;
      }
      action.isActive = isActive && !resets;
      if (action.isBody) {
        if (action.isActive || isPulsed)
          running.push_back(&action);
        else if (wasActive && finalScan_)
          ending.push_back(&action);
      } else if (action.isActive) {
        action.value = 1;
      } else if (wasActive || resets) {
        action.value = 0;
      }
    }
    for (std::vector<TokenAction*>* const list : {&ending, &running}) {
      // Declared: n1 before n0.
      if (alphabetical_) std::ranges::reverse(*list);
      for (TokenAction* action : *list) {
        ++action->value;
        last_ = action->name == "n1" ? 1 : 2;
      }
    }
    for (TokenStep& step : steps_) step.wasActive = step.isActive;
  }

  std::mt19937_64 random_;
  std::vector<TokenStep> steps_;
  std::vector<TokenTransition> transitions_;
  std::vector<TokenAction> actions_;
  bool actionsFirst_ = false, initialEdge_ = true, finalScan_ = false, alphabetical_ = false;
  bool hasBegun_ = false;
  std::int64_t last_ = 0;
};

}  // namespace rungproof::iec_chart
