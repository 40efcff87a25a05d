// CoverageMap: what of a program a test can cover, taken from its text. One definition serves all families:
//   contact     LD, A, O and their negated and immediate forms, or a comparison; IEC: a BOOL variable that is read, or
//   a
//               comparison. Covered when its own bit was 1 and 0.
//   network     covered when power flow reached one of its coils or boxes.
//   transition  SCRT, S of an S bit, a move of a constant to a step word, a transition of a chart. Covered when taken.
//   decision    what a coil, set, reset or box hangs on, as a tree over the bits of its contacts; each contact of it is
//   a
//               condition, which counts for MC/DC.
// Texts of libraries and what a chart is lowered to do not count. Covered by tests/tables/coverage_test.cpp.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "engine/coverage/logic_expression.hpp"
#include "ir/machine/choices.hpp"
#include "ir/machine/plan.hpp"
#include "ir/program.hpp"

namespace rungproof {

struct CoveragePlace {
  std::uint32_t pou = 0, network = 0;  ///< indices in Program::pous and Pou::networks
};

/// A bit that decisions hang on. Contact: counts as one. Edge: whether EU, ED, FP or FN lets a change through, which
/// their memory decides. Hidden: what no contact shows, such as the RLO that another block left.
enum class LeafKind : std::uint8_t { Contact, Edge, Hidden };

struct CoverageLeaf {
  LeafKind kind = LeafKind::Contact;
  const Instruction* instruction = nullptr;  ///< Hidden: may be nullptr
  CoveragePlace place{};
};

struct Decision {
  const Instruction* instruction = nullptr;  ///< the coil or box
  std::uint8_t level = 0;                    ///< stack level that it samples
  LogicNode condition = 0;
  std::vector<std::uint32_t> leaves{};  ///< Contact and Edge leaves
  bool isWhole = true;                  ///< nothing hidden decides it
  CoveragePlace place{};
};

enum class TransitionKind : std::uint8_t { Scrt, SetStep, StepWord, Chart };

struct StepTransition {
  TransitionKind kind = TransitionKind::Scrt;
  const Instruction* instruction = nullptr;
  std::string text{};       ///< "S0.1 -> S0.2"
  std::uint64_t value = 0;  ///< StepWord: of the step that is entered
  CoveragePlace place{};
};

class CoverageMap {
 public:
  /// The program must outlive the map. `choices`: where a statement hangs on the reading of an open point alone, only
  /// the one of the reading in force counts.
  explicit CoverageMap(const Program& program, const Choices& choices = {});

  const Program& program() const { return program_; }
  const Choices& choices() const { return choices_; }
  const Plan& plan() const { return plan_; }
  const LogicTrees& trees() const { return trees_; }
  /// All leaves; contacts are those of kind Contact.
  const std::vector<CoverageLeaf>& leaves() const { return leaves_; }
  const std::vector<Decision>& decisions() const { return decisions_; }
  const std::vector<StepTransition>& transitions() const { return transitions_; }
  /// Networks with a coil or a box.
  const std::vector<CoveragePlace>& networks() const { return networks_; }

  /// By Instruction::id; none: -1.
  int leafOf(std::uint32_t id) const { return sites_[id].leaf; }
  int networkOf(std::uint32_t id) const { return sites_[id].network; }
  int transitionOf(std::uint32_t id) const { return sites_[id].transition; }
  /// First decision of the instruction and how many it has.
  std::pair<std::uint32_t, std::uint32_t> decisionsOf(std::uint32_t id) const {
    return {sites_[id].decision, sites_[id].decisions};
  }
  /// Whether the instruction is a coil or a box that needs no power flow: it is reached where it runs.
  bool isUnconditional(std::uint32_t id) const { return sites_[id].isUnconditional; }
  /// Whether the instruction has a part in any count.
  bool isWatched(std::uint32_t id) const { return sites_[id].isWatched; }

  /// "MAIN:4".
  std::string placeText(CoveragePlace place) const;
  /// "A I0.2"; IEC: the variable.
  std::string instructionText(const Instruction& instruction) const;

 private:
  friend class LogicReader;
  struct Site {
    int leaf = -1, network = -1, transition = -1;
    std::uint32_t decision = 0, decisions = 0;
    bool isUnconditional = false, isWatched = false;
  };

  const Program& program_;
  const Choices choices_;
  Plan plan_;
  LogicTrees trees_;
  std::vector<CoverageLeaf> leaves_;
  std::vector<Decision> decisions_;
  std::vector<StepTransition> transitions_;
  std::vector<CoveragePlace> networks_;
  std::vector<Site> sites_;
};

}  // namespace rungproof
