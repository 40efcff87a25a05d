// Certificates over the original transition system: an inductive invariant in its own terms, written as SMT-LIB 2
// that any solver of QF_BV can check without knowing this program. The check in process makes clauses of the same
// obligations by circuits of its own and follows their refutation step by step; what is too long for that is read by
// Z3. Neither knows the engines or their circuits. Tested by tests/certificate.
#pragma once

#include <string>
#include <unordered_set>
#include <vector>

#include "analysis/portfolio/certificate_text.hpp"

namespace rungproof {

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
  /// Each of the invariant follows after a scan from those before it with little search, presumably.
  bool isChain = false;
  std::vector<KeptDifference> differences;  ///< used in the step from I to I; each is an obligation of its own
  std::vector<KeptSum> sums;                ///< the same, and where bad is excluded
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
  explicit CertificateWriter(const TransitionSystem& system) : system_(system) {}
  void add(const Question& question, const WordCertificate& certificate);
  /// Only that these nodes over states are 1 at the start of the first scan.
  void addStart(const std::string& name, const std::vector<Node>& facts);
  /// Only that the certificate's invariant holds in every scan.
  void addInvariant(const std::string& name, const WordCertificate& certificate);
  /// That the node is 1 in every scan in which the invariant holds; an obligation of that name.
  void addConsequence(const char* name, const WordCertificate& certificate, Node fact);
  /// A self-contained file: each obligation between push and pop, with the expected answer unsat.
  std::string text() const;
  /// Checks the obligations. By certificate, in the order of add().
  std::vector<CheckResult> check(const CheckLimits& limits) const;

 private:
  using Parts = std::vector<Formula>;
  void addSums(Parts& parts, const WordCertificate& certificate, int scan) const;
  void addGuide(const WordCertificate& certificate, int scan);
  void oblige(const char* name, Parts parts);
  void initiation(const WordCertificate& certificate);
  void consecution(const WordCertificate& certificate);
  void step(const Question& question, const WordCertificate& certificate);
  void surface(const Question& question, const WordCertificate& certificate);
  void base(const Question& question, const WordCertificate& certificate);
  Parts initialEquations(const std::unordered_set<std::uint32_t>& variables) const;
  std::vector<CheckResult> checkStepByStep(const CheckLimits& limits) const;
  void checkWithZ3(const std::vector<std::size_t>& open, const CheckLimits& limits,
                   std::vector<CheckResult>& results) const;

  const TransitionSystem& system_;
  std::vector<std::string> questions_;
  std::vector<Obligation> obligations_;
  std::vector<CertificateText::OpenNodes> surfaces_;
};

/// The file for one certificate.
inline std::string certificateText(const TransitionSystem& system, const Question& question,
                                   const WordCertificate& certificate) {
  CertificateWriter writer(system);
  writer.add(question, certificate);
  return writer.text();
}

}  // namespace rungproof
