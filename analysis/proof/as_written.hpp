// AsWritten: the system of a program beside the simplified one on which proofs are found: the same scan encoded along
// the same trail, but with every operation as it was written. Certificates are about this one, and exports print it: a
// value that a simplification gets wrong cannot pass for a proof. What the trail says is followed, and shown beside the
// property (told()): which conditions have a known value, which targets a pointer can have, what runs of interrupt
// routines leave. Cells that keep their value are part of each invariant. Covered by tests/certificate.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <unordered_map>

#include "analysis/portfolio/certificate.hpp"
#include "analysis/portfolio/local_proof.hpp"
#include "analysis/proof/question_system.hpp"
#include "analysis/proof/told_proof.hpp"

namespace rungproof {

class AsWritten {
 public:
  /// `side`: encoded along the trail that `simplified` has left.
  AsWritten(QuestionSystem& simplified, std::unique_ptr<QuestionSystem> side);

  /// `isWritten`: with REAL operations written out.
  const TransitionSystem& system(std::size_t question, bool isWritten);
  const Question& question(std::size_t question, bool isWritten);
  /// That what the encoding was told along the trail holds.
  ToldProof& told();
  /// Whether what is asked is a constant, though nothing was simplified.
  bool isDecidedByForm(std::size_t question);

  /// Check: as little as the proof needs. Text: with the whole of the program that the question depends on.
  enum class Purpose : bool { Check, Text };
  /// The certificate in terms of this system, with the cells that keep their value as part of the invariant; nothing
  /// if it speaks of variables that are not here.
  std::optional<WordCertificate> translated(std::size_t question, bool isWritten, const WordCertificate& certificate,
                                            Purpose purpose);

 private:
  Node copied(Node n);
  std::vector<Node> keptBehind(const std::vector<Node>& once, const std::vector<Node>& followed, bool isLong);

  const Graph& from_;
  std::unique_ptr<QuestionSystem> side_;
  std::unordered_map<std::uint32_t, Node> copies_;   ///< by node of the simplified graph; noNode: has none
  KnownVariables kept_;                              ///< variables here that keep a value
  std::unordered_map<std::uint32_t, Node> next_;     ///< of state variables
  std::map<std::size_t, TransitionSystem> written_;  ///< by question
  std::optional<ToldProof> told_;
};

}  // namespace rungproof
