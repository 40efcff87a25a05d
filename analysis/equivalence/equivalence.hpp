// Do two programs drive the same outputs, for every sequence of inputs and scan times? First it is found out which
// memory of NEW always holds what OLD's holds: pairs of states are assumed equal at the start of a scan, and those that
// the scan does not keep equal are dropped until nothing changes (van Eijk's correspondence). What is left is usually
// one scan without memory of its own; where it is not, both programs run side by side and the portfolio decides each
// output. A difference counts once the reference engine has shown it on both programs. Tested by tests/equivalence and
// tests/cli.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "analysis/equivalence/product.hpp"
#include "analysis/proof/prover.hpp"

namespace rungproof {

enum class Equality : std::uint8_t { Equal, Different, Unknown };

struct EquivalenceOptions {
  ProverOptions prover;  ///< timeout: for the whole comparison
  AddressPairs pairs;
  Operands observed;
  std::vector<Property> assumptions;  ///< that speak of both programs (ProductOptions)
  bool steadyInputs = false;
  std::uint32_t latency = 0;
  std::uint32_t settleMs = 0;
  bool interruptsInside = false;  ///< events come anywhere in a scan; otherwise between scans
  bool oneScan = false;           ///< only what one scan from memory that corresponds can prove
  bool everyOutput = false;       ///< goes on after the first difference until each output has its verdict
};

/// A run that ends with a difference, as the reference engine has made it on both programs.
struct EquivalenceRun {
  std::vector<ReplayScan> before, after;
  std::optional<Concrete::Store> initialBefore, initialAfter;
  std::uint64_t scan = 0;          ///< in which they differ, from 1
  std::uint64_t milliseconds = 0;  ///< at its end
  std::string signal;              ///< "Q0.1", "PLS0.width", or "RUN" where one program has stopped
  std::optional<Address> addressBefore, addressAfter;
  std::uint64_t valueBefore = 0, valueAfter = 0;
  /// Readings of open points that it needs and that are not those of the choices: index into ChoiceInfo::values.
  std::vector<std::pair<Choice, std::uint8_t>> readings;
};

struct ObservedVerdict {
  std::string name;  ///< "Q0.1", "PLS0.width", "RUN"
  Equality equality = Equality::Unknown;
  std::optional<Address> before, after;  ///< nothing: that program does not have it
  std::optional<PulseSignal> pulses{};   ///< in place of addresses
  bool isRun() const { return !before && !after && !pulses; }
};

struct Equivalence {
  Equality equality = Equality::Unknown;
  std::string method;
  double seconds = 0;
  int depth = 0;  ///< Unknown: no difference in so many first scans
  std::vector<ObservedVerdict> outputs;
  std::optional<EquivalenceRun> run;  ///< of the first difference
  std::vector<std::string> notes;     ///< why nothing is decided
  std::vector<std::string> assumptions;
  std::vector<std::string> approximations;
  /// Equal, if asked for: "memory" and each output with its SMT-LIB 2 text (equality_proof.hpp).
  std::vector<std::pair<std::string, std::string>> certificates;
  std::vector<std::string> uncertified;  ///< what the certificates that were asked for leave out
  std::vector<Disagreement> disagreements;
};

Equivalence compareBehaviour(const Side& before, const Side& after, const EquivalenceOptions& options);

}  // namespace rungproof
