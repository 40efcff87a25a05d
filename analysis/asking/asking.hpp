// Asking: what a rule finds at hand when it puts its questions - the program, its encoding, and the record of what a
// scan does at each instruction. ruleQuestions() goes through the rules in their order; it knows none by its id.
// Covered by tests/prover/builtin_test.cpp, tests/prover/rule_questions_test.cpp and tests/prover/own_rule_test.cpp.
#pragma once

#include <array>
#include <map>
#include <vector>

#include "analysis/asking/rule_question.hpp"
#include "analysis/encoding/asked_properties.hpp"
#include "analysis/encoding/execution_record.hpp"

namespace rungproof {

class Asking {
 public:
  /// The record must have listened to the encoding.
  Asking(const Program& program, const PropertySet& set, bool settles, AskedProperties& askedProperties,
         const ExecutionRecord& record)
      : program_(program), set_(set), settles_(settles), askedProperties_(askedProperties), record_(record) {}

  const Program& program() const { return program_; }
  const PropertySet& properties() const { return set_; }
  AskedProperties& askedProperties() { return askedProperties_; }
  EncodedScan& encoding() { return askedProperties_.encoding(); }
  Graph& graph() { return encoding().graph(); }
  const ExecutionRecord& record() const { return record_; }
  /// Whether candidates of the flow analysis wait for the answers, so that what is plain is to be asked as well.
  bool settles() const { return settles_; }

  /// All executions of one instruction in a scan together.
  struct Runs {
    Graph::Bool guard;                       ///< whether there is one
    std::array<Graph::Bool, 3> on{}, off{};  ///< by stack level that it samples: one with, one without power
    bool samples(std::size_t level) const { return on[level].node != noNode; }
  };
  /// nullptr: no scan comes to the instruction.
  const Runs* runsOf(const Instruction& instruction);
  /// Instructions that a scan comes to, in the order in which it first does.
  const std::vector<const Instruction*>& executed();
  const Network& networkOf(const Instruction& instruction);
  /// Contacts and compare contacts that decide the top of the stack in front of the instruction.
  std::vector<const Instruction*> rungOf(const Instruction& instruction);

  void ask(RuleQuestion question);
  /// For the runner: the rule that asks next.
  void begin(const Rule& rule) { rule_ = &rule; }
  std::size_t asked() const { return questions_.size(); }
  std::vector<RuleQuestion> take() { return std::move(questions_); }

 private:
  struct Position {
    const Network* network;
    std::size_t index;
  };
  const Position& positionOf(const Instruction& instruction);
  void gatherRuns();

  const Program& program_;
  const PropertySet& set_;
  const bool settles_;
  AskedProperties& askedProperties_;
  const ExecutionRecord& record_;
  const Rule* rule_ = nullptr;
  std::vector<RuleQuestion> questions_;
  bool hasRuns_ = false;
  std::map<const Instruction*, Runs> runs_;
  std::vector<const Instruction*> executed_;
  std::map<const Instruction*, Position> positions_;
  struct Rung {
    const Network* network = nullptr;
    std::size_t index = 0;
    std::vector<const Instruction*> contacts{};
  };
  Rung lastRung_;  ///< that was asked for
};

/// Contacts that are there to be constant or to come once: special memory.
bool isOfSpecialMemory(const Instruction& contact);
/// A contact of that bit's image, normally closed if `negated`.
bool isContactOf(const Instruction& contact, const Operand& bit, bool negated);
/// A box whose first operand is of that type: a timer, a counter.
bool isBoxOf(const Instruction& instruction, Type type);

/// Whether some scan comes to the block; a block that nothing calls is CTL007's.
bool isExecuted(Asking& asking, const Flow& flow);

/// The questions of all rules that those groups ask, in the rules' order.
std::vector<RuleQuestion> ruleQuestions(const Program& program, const PropertySet& set, const CheckGroups& groups,
                                        AskedProperties& askedProperties, const ExecutionRecord& record);

}  // namespace rungproof
