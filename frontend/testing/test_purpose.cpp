// A step whose input did something elsewhere and does nothing here is refused: by the inputs that were otherwise there.
#include "frontend/testing/test_purpose.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

namespace rungproof {

namespace {

constexpr std::size_t mostClauses = 3;

/// A step that changes one input, and what the outputs did.
struct Attempt {
  std::size_t input = 0;
  TraceNumber value = 0;
  std::vector<TraceNumber> others;  ///< all inputs behind the step
  bool hasChanged = false;          ///< some output
  bool isWhole = true;              ///< all outputs are compared, here and before
};

class PurposeWriter {
 public:
  explicit PurposeWriter(const TestTable& table) : table_(table) {
    for (const TestCase& test : table.tests)
      walk(test, [&](const TestRow&, const Attempt* attempt, const auto&) {
        if (attempt != nullptr) attempts_.push_back(*attempt);
      });
  }

  std::string of(const TestCase& test) {
    std::vector<std::string> all, fresh;
    walk(test, [&](const TestRow& row, const Attempt* attempt, const std::vector<std::string>& changes) {
      std::string clause;
      if (!changes.empty())
        clause = fmt::format("{} {}", fmt::join(changes, " and "), occasion(row, attempt));
      else if (attempt != nullptr && attempt->isWhole)
        clause = refusal(*attempt);
      if (clause.empty() || std::ranges::find(all, clause) != all.end()) return;
      all.push_back(clause);
      if (said_.insert(clause).second) fresh.push_back(clause);
    });
    std::vector<std::string>& shown = fresh.empty() ? all : fresh;
    const std::size_t left = shown.size() > mostClauses ? shown.size() - mostClauses : 0;
    shown.resize(shown.size() - left);
    if (shown.empty()) return "no output changes";
    return fmt::format("{}{}", fmt::join(shown, "; "), left > 0 ? fmt::format("; and {} more", left) : "");
  }

 private:
  /// Calls `visit` with each row, the attempt that it is (or nullptr), and the outputs that change in words.
  template <class Visit>
  void walk(const TestCase& test, const Visit& visit) const {
    std::vector<TraceNumber> inputs(table_.sets.size(), 0);
    std::vector<std::optional<TestRange>> outputs(table_.expects.size(), TestRange{0, 0});
    for (const TestRow& row : test.rows) {
      std::vector<std::size_t> set;
      for (std::size_t i = 0; i < inputs.size(); ++i) {
        if (row.sets[i] && *row.sets[i] != inputs[i]) set.push_back(i);
        inputs[i] = row.sets[i].value_or(inputs[i]);
      }
      Attempt attempt{set.empty() ? 0 : set.front(), 0, inputs, false, true};
      std::vector<std::string> changes;
      for (std::size_t i = 0; i < outputs.size(); ++i) {
        const std::optional<TestRange>& now = row.expects[i];
        attempt.isWhole = attempt.isWhole && now && outputs[i];
        const bool isSame = now && outputs[i] && now->low == outputs[i]->low && now->high == outputs[i]->high;
        if (now && outputs[i] && !isSame) changes.push_back(changeText(table_.expects[i], *now));
        outputs[i] = now;
      }
      attempt.hasChanged = !changes.empty();
      const bool isAttempt = set.size() == 1;
      if (isAttempt) attempt.value = inputs[set.front()];
      visit(row, isAttempt ? &attempt : nullptr, changes);
    }
  }

  static std::string changeText(const TraceSignal& signal, const TestRange& now) {
    if (signal.type == SignalType::Bool) return signalText(signal) + (now.low != 0 ? " comes" : " goes");
    return fmt::format("{} becomes {}", signalText(signal), rangeText(now, signal.type));
  }
  std::string stateText(std::size_t input, TraceNumber value) const {
    const TraceSignal& signal = table_.sets[input].signal;
    if (signal.type == SignalType::Bool) return fmt::format("{} is {}", signalText(signal), value != 0 ? "on" : "off");
    return fmt::format("{} is {}", signalText(signal), numberText(value, signal.type));
  }
  std::string occasion(const TestRow& row, const Attempt* attempt) const {
    if (attempt == nullptr) return row.wait.isTime() ? "by time" : "at power-on";
    const TraceSignal& signal = table_.sets[attempt->input].signal;
    if (signal.type != SignalType::Bool)
      return fmt::format("when {} is set to {}", signalText(signal), numberText(attempt->value, signal.type));
    return fmt::format("when {} is switched {}", signalText(signal), attempt->value != 0 ? "on" : "off");
  }

  /// What keeps a step from doing what it did elsewhere; empty: it does nothing anywhere.
  std::string refusal(const Attempt& attempt) const {
    if (attempt.value == 0) return "";
    std::vector<std::size_t> least;
    bool isFound = false;
    for (const Attempt& other : attempts_) {
      if (!other.hasChanged || other.input != attempt.input || other.value != attempt.value) continue;
      std::vector<std::size_t> differing;
      for (std::size_t i = 0; i < attempt.others.size(); ++i) {
        if (attempt.others[i] != other.others[i]) differing.push_back(i);
      }
      if (isFound && differing.size() >= least.size()) continue;
      least = std::move(differing);
      isFound = true;
    }
    if (!isFound) return "";
    const std::string name = signalText(table_.sets[attempt.input].signal);
    if (least.empty()) return name + " is refused after what came before";
    std::vector<std::string> reasons;
    for (const std::size_t input : least) reasons.push_back(stateText(input, attempt.others[input]));
    return fmt::format("{} is refused while {}", name, fmt::join(reasons, " and "));
  }

  const TestTable& table_;
  std::vector<Attempt> attempts_;
  std::set<std::string> said_;
};

}  // namespace

std::vector<std::string> purposesOf(const TestTable& table) {
  PurposeWriter writer(table);
  std::vector<std::string> purposes;
  for (const TestCase& test : table.tests) purposes.push_back(writer.of(test));
  return purposes;
}

}  // namespace rungproof
