// CoverageRecorder: watches a run and notes what it covers of a CoverageMap. What is noted of a decision is each
// combination of its conditions that occurred, with the outcome; MC/DC follows from these. A combination whose outcome
// is not the power flow that the machine shows is not noted: then something decided that the text does not show.
// Covered by tests/tables/coverage_test.cpp.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "engine/coverage/coverage_map.hpp"
#include "engine/instruction_observer.hpp"

namespace rungproof {

/// What is known of a condition of a decision.
enum class PairState : std::uint8_t { None, Masking, Unique };

class CoverageRecorder final : public InstructionObserver {
 public:
  /// The map must outlive the recorder.
  explicit CoverageRecorder(const CoverageMap& map);

  /// In front of every scan.
  void beginScan();
  void before(const Machine<Concrete>& machine, const Instruction& instruction) override;
  void external(const ExternalSite& site, std::uint64_t value) override;
  void programEnded(const Machine<Concrete>& machine) override;

  const CoverageMap& map() const { return map_; }
  bool networkReached(std::size_t network) const { return networks_[network]; }
  /// Whether the contact's own bit was that value.
  bool contactSeen(std::size_t leaf, bool value) const { return contacts_[leaf][value ? 1 : 0]; }
  bool transitionTaken(std::size_t transition) const { return transitions_[transition]; }
  /// Of a condition, counted among Decision::leaves.
  PairState pair(std::size_t decision, std::size_t condition) const;
  /// Whether the condition was that value in a scan in which it decided the outcome.
  bool conditionDecided(std::size_t decision, std::size_t condition, bool value) const {
    const Shown& shown = decisions_[decision].shown[condition];
    return shown.decides[value ? 1 : 0][0] || shown.decides[value ? 1 : 0][1];
  }
  /// Whether it decided the outcome to be that, as whatever value.
  bool outcomeDecided(std::size_t decision, std::size_t condition, bool outcome) const {
    const Shown& shown = decisions_[decision].shown[condition];
    return shown.decides[0][outcome ? 1 : 0] || shown.decides[1][outcome ? 1 : 0];
  }
  /// What a leaf was in the last scan; nothing: it was not executed in it.
  std::optional<bool> lastValue(std::size_t leaf) const {
    return stamps_[leaf] == scan_ ? std::optional(values_[leaf] != 0) : std::nullopt;
  }
  /// Grows with everything new that was covered.
  std::size_t news() const { return news_; }
  /// Takes what another recorder of the same map has seen too.
  void add(const CoverageRecorder& other);

 private:
  struct Shown {
    std::array<std::array<bool, 2>, 2> decides{};  ///< by value of the condition and outcome
    bool isUnique = false;
  };
  struct Seen {
    std::unordered_map<std::string, bool> outcomes;  ///< by values of the leaves
    std::vector<Shown> shown;
  };
  void finish(const Machine<Concrete>& machine, const Instruction* next);
  void note(std::uint32_t leaf, bool value);
  void judge(const Machine<Concrete>& machine, const Instruction& instruction);
  void noteDecision(std::size_t decision, const std::string& key, bool outcome);
  std::optional<bool> power(const Machine<Concrete>& machine, const Instruction& instruction, unsigned level) const;
  std::optional<bool> valueInFront(const Machine<Concrete>& machine, const Instruction& instruction) const;
  bool edgeGate(const Machine<Concrete>& machine, const Instruction& instruction) const;

  const CoverageMap& map_;
  std::uint32_t scan_ = 0;
  std::vector<std::uint32_t> stamps_;  ///< by leaf: scan in which its value was noted
  std::vector<char> values_;
  std::vector<std::array<bool, 2>> contacts_;
  std::vector<bool> networks_, transitions_;
  std::vector<Seen> decisions_;
  std::size_t news_ = 0;
  /// A contact whose bit shows behind it.
  const Instruction* pending_ = nullptr;
  bool topBefore_ = false;
  std::optional<bool> guess_;
  std::string key_;
};

/// Two relations of a value with another one, signed or not.
bool relates(Relation relation, double left, double right);

}  // namespace rungproof
