// Certificates over the original transition system: an inductive invariant in its own terms, written as SMT-LIB 2
// that any solver of QF_BV can check without knowing this program. The check in process reads the same text with
// Z3, so it is independent of bit-blasting and of the engines. Tested by tests/certificate.
#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "analysis/graph/smt_text.hpp"
#include "analysis/portfolio/certificate_check.hpp"

namespace rungproof {

/// A word as part of a sum: at a step at which it counts it becomes `next` = word + increment. Nodes of one width over
/// states and, unless the increment is pending, inputs.
struct Summand {
  Node word = noNode;
  Node increment = noNode;
  Node next = noNode;
  /// The increment is known at the start of the scan, because it came about in the scan before.
  bool isPending = false;
  /// What two words are compared by: with a pending increment, what the word is about to become.
  Node progress() const { return isPending ? next : word; }
};

/// A theorem that spares solvers the reasoning about adders: two words that count on by the same amount keep the
/// difference of what they are compared by. Holds by modular arithmetic, whatever the words are.
struct KeptDifference {
  Summand left, right;
  Node difference = noNode;  ///< left.progress() - right.progress()
};

/// With I the conjunction of `invariant` (width-1 nodes over states): I holds initially, I and the constraints keep
/// I, and: k = 0: I and the constraints exclude bad; k > 0: bad does not occur in the first k scans, and k scans
/// without bad that satisfy I are not followed by a bad one - with simplePath: if their states differ pairwise in
/// `pathBits`.
struct WordCertificate {
  std::vector<Node> invariant;
  int k = 0;
  bool simplePath = false;
  std::vector<Node> pathBits;
  /// Of the invariant: what excludes bad (in the step case, in every scan); empty: all of it.
  std::vector<Node> immediate;
  std::vector<KeptDifference> differences;  ///< used in the step from I to I; each is an obligation of its own
  /// Nodes that may have any value: the proof does not look below them. Only with k = 0; then bad is excluded in every
  /// scan in which the invariant holds, whatever the constraints.
  std::vector<Node> open;
};

/// A proof that is to be checked.
struct Claim {
  const Question* question;
  const WordCertificate* certificate;
};

/// The obligations of one certificate or several, over shared declarations and definitions.
class CertificateWriter {
 public:
  explicit CertificateWriter(const TransitionSystem& system) : system_(system), smt_(system) {}
  void add(const Question& question, const WordCertificate& certificate);
  /// Only that these nodes over states are 1 at the start of the first scan.
  void addStart(const std::string& name, const std::vector<Node>& facts);
  /// A self-contained file: each obligation between push and pop, with the expected answer unsat.
  std::string text() const;
  /// Checks the obligations with Z3, as their text says. By certificate, in the order of add().
  std::vector<CheckResult> check(const CheckLimits& limits) const;

 private:
  struct Condition {
    std::size_t certificate;
    std::string name;     ///< "initiation", "consecution", "base", "safety"
    std::string formula;  ///< must be unsatisfiable
  };
  std::vector<SmtText::Definition> definitions() const;
  using Terms = std::vector<std::string>;
  void oblige(const char* name, const Terms& terms);
  std::string notAll(const std::vector<Node>& nodes, int frame);
  void addAll(Terms& terms, const std::vector<Node>& nodes, int frame);
  void initiation(const WordCertificate& certificate);
  void consecution(const WordCertificate& certificate);
  std::string keeps(const KeptDifference& d);
  void theorem(const KeptDifference& d);
  void step(const Question& question, const WordCertificate& certificate);
  void surface(const Question& question, const WordCertificate& certificate);
  void base(const Question& question, const WordCertificate& certificate);

  const TransitionSystem& system_;
  SmtText smt_;
  std::string surfaces_;  ///< declarations of certificates with open nodes
  std::vector<SmtText::Definition> surfaceDefinitions_;
  std::vector<std::string> questions_;
  std::vector<Condition> obligations_;
  std::string theorems_;                         ///< declarations of their variables
  std::unordered_map<std::string, int> proved_;  ///< theorems that are obligations already, by their form
};

/// The file for one certificate.
inline std::string certificateText(const TransitionSystem& system, const Question& question,
                                   const WordCertificate& certificate) {
  CertificateWriter writer(system);
  writer.add(question, certificate);
  return writer.text();
}

}  // namespace rungproof
