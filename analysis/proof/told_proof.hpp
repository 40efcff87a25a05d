// ToldProof: that what an encoding along a trail was told (analysis/encoding/told_facts.hpp) holds in every scan of the
// system: known conditions, effects of interrupt routines, targets of pointers, each with the invariant that it rests
// on: cells that keep their value; for pointers also which values other cells have. Where that is not enough the
// engines look for a proof. Whatever else is proved of the system rests on it, so its text stands in front of every
// certificate. Tested by tests/certificate.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/encoding/told_facts.hpp"
#include "analysis/encoding/trail.hpp"
#include "analysis/portfolio/certificate.hpp"

namespace rungproof {

class ToldProof {
 public:
  /// `system`: of the encoding that was told these facts. Adds nodes to its graph. `isExact`: nothing of it is
  /// approximated, so that a run which breaks a fact shows a mistake.
  ToldProof(const TransitionSystem& system, const ToldFacts& told, const std::vector<KeptCell>& kept, bool isExact);

  /// Valid: all of it holds. Checked once, then known; within the limits of the first call.
  CheckResult check(const CheckLimits& limits);
  /// What does not hold, or was not shown, after check().
  const std::string& reason() const { return reason_; }
  /// Whether the check shows a mistake: a list of targets or of effects fails, or a run breaks a known condition and
  /// nothing is approximated.
  bool isRefuted() const { return isRefuted_; }
  /// Empty if nothing was told.
  std::string text() const;

 private:
  struct Part {
    const char* name;
    Node fact;
    bool isRefutable;  ///< a failed check shows a mistake
    WordCertificate invariant{};
    std::optional<WordCertificate> found{};  ///< by the engines, where the invariant is not enough
    bool isShown = false;
    bool isRefused = false;  ///< its check fails
    bool isFalse = false;    ///< the engines have a run that breaks it
  };
  Question questionOf(const Part& part) const;
  void addPart(CertificateWriter& writer, const Part& part) const;
  bool search(const CheckLimits& limits);
  void checkParts(const CheckLimits& limits);
  bool areShown(const CheckLimits& limits);
  bool writeOutReals();

  TransitionSystem system_;
  bool isExact_;
  std::vector<Part> parts_;
  std::optional<CheckResult> result_;
  std::string reason_;
  bool isRefuted_ = false;
};

}  // namespace rungproof
