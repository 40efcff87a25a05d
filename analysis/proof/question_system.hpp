// QuestionSystem: a program and its properties as one transition system with questions, and what each question depends
// on. The prover has two of them, the exact one and a relaxed one in which long scans stand for stretches of time; the
// export prints the exact one. Also says in words what every verdict about it rests on.
// Covered by tests/prover and tests/export.
#pragma once

#include <optional>
#include <string>
#include <unordered_set>
#include <vector>

#include "analysis/asking/asking.hpp"

namespace rungproof {

class QuestionSystem {
 public:
  /// Questions are the goals in their order, then checks() of those groups in their order, then leftOutQuestion().
  QuestionSystem(const Program& program, const PropertySet& set, const std::vector<Property>& goals,
                 const EncoderOptions& options, const CheckGroups& groups);

  AskedProperties& askedProperties() { return askedProperties_; }
  TransitionSystem& system() { return system_; }
  const std::vector<RuleQuestion>& checks() const { return checks_; }
  /// The question whether a scan can occur that the encoding does not follow to its end; nothing if none can.
  std::optional<std::size_t> leftOutQuestion() const { return leftOutQuestion_; }

  /// The system with one question only.
  TransitionSystem only(std::size_t question) const;
  /// Variables and REAL operations that the question depends on, through any number of scans. Constraints count, except
  /// total ones.
  std::unordered_set<std::uint32_t> variablesOf(std::size_t question) const;
  /// What is not exact and reaches the question; `isWritten`: its REAL operations are written out and exact.
  std::vector<const Approximation*> approximationsOf(std::size_t question, bool isWritten);
  /// How many REAL operations that can be written out the question depends on.
  std::size_t exactReals(std::size_t question) const;
  bool dependsOnTime(const std::unordered_set<std::uint32_t>& variables) const;
  /// Keeps only what the question depends on, so that unrelated changes do not end a stretch of equal scans.
  TransitionSystem accelerated(std::size_t question, const TimeRange& ordinary);

 private:
  ExecutionRecord record_;
  AskedProperties askedProperties_;
  std::vector<RuleQuestion> checks_;
  std::optional<std::size_t> leftOutQuestion_;
  TransitionSystem system_;
};

/// CPU, scan time, initial memory, external writers, declared assumptions.
std::vector<std::string> environmentTexts(const Program& program, const PropertySet& set, const TimeRange& time,
                                          const Choices& choices);
/// "PID at press.awl:41".
std::string placeText(const Program& program, const Instruction& instruction);
/// "PID at press.awl:41: result is any value".
std::string approximationText(const Program& program, const Approximation& approximation);
/// Whether it is gone once REAL operations are written out.
bool isWrittenOut(const Graph& graph, const Approximation& approximation);
/// Of all that stay.
std::vector<std::string> approximationTexts(const Program& program, AskedProperties& askedProperties);

}  // namespace rungproof
