// Certificates of an equality, over both programs as they are written. "memory" says that every pair of states which
// stand for each other starts equal, and that no scan which begins with all pairs equal ends with a pair that differs:
// then all of them are equal in every scan. On that rests the certificate of each output: in the system in which one
// state stands for each pair, the output never differs. Where outputs depend on devices, which are one and the same for
// both programs there, one more for each request says that both ask the same. What is asked is asked of the encodings
// along the trails of the simplified ones (encoding/trail.hpp): values that were simplified need not be believed, nor
// the decisions of the trails: one more certificate for each program shows known conditions, targets of pointers and
// effects of interrupt routines (proof/told_proof.hpp). Tested by tests/equivalence/certificates_test.cpp.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "analysis/encoding/exact_reals.hpp"
#include "analysis/equivalence/correspondence.hpp"

namespace rungproof {

/// The system with REAL operations of that scope written out; itself if it has none.
TransitionSystem withWrittenReals(const TransitionSystem& system, RealScope scope);

class EqualityProof {
 public:
  /// `written`: follows the trails. `names`: the states of the simplified product's NEW, of which `found` speaks.
  /// `seconds`: for each question that is hard. `withRequests`: what is asked of devices decides outputs.
  EqualityProof(ProgramProduct& written, const std::vector<std::string>& names, const Correspondence& found, Ask ask,
                double seconds, bool withRequests);

  /// Name and text.
  const std::vector<std::pair<std::string, std::string>>& certificates() const { return certificates_; }
  /// What could not be proved again in this form.
  const std::vector<std::string>& missing() const { return missing_; }

 private:
  /// Proves the questions of that system; those that are left open.
  std::vector<Question> prove(const TransitionSystem& system, const std::vector<Question>& questions, double longest,
                              CertificateWriter& writer);
  void writeMemory(const JoinedSystem& joined, const std::vector<std::string>& names);
  void writeOutputs(ProgramProduct& written, const JoinedSystem& joined, const std::vector<bool>& isMerged);
  void writeTold(const TransitionSystem& system, const EncodedScan& encoding, const std::string& side);
  bool writeOutput(const TransitionSystem& system, const Question& question, double longest);

  const std::vector<PairCondition>& conditions_;
  Ask ask_;
  double seconds_;
  bool withRequests_;
  std::vector<std::pair<std::string, std::string>> certificates_;
  std::vector<std::string> missing_;
};

}  // namespace rungproof
