// What a change has changed: the networks that do something else, what each can influence, which outputs can differ
// because of it, and which declared properties have another verdict. Tested by tests/equivalence.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/equivalence/equivalence.hpp"
#include "frontend/report.hpp"
#include "frontend/sides/changed_values.hpp"
#include "frontend/sides/sides.hpp"

namespace rungproof {

/// An output that a change can influence, with what is proved of it.
struct InfluencedOutput {
  std::string name;  ///< "Q0.1 (Pump)"
  Equality equality = Equality::Unknown;
};

struct NetworkChange {
  NetworkPair networks;
  std::vector<InfluencedOutput> outputs;
  std::vector<std::string> memory;  ///< places that it can influence beside them
  bool isEverything = false;        ///< it can influence more than is listed
  bool isOfPart = false;            ///< who runs it is not known: there is no main program
};

/// A property of OLD whose verdict is another one in NEW.
struct VerdictChange {
  std::string name;
  std::string before, after;
};

struct ProgramDifference {
  std::vector<NetworkChange> changes;
  std::vector<ValueChange> values;  ///< with which the programs begin
  std::vector<VerdictChange> verdicts;
  Equivalence equivalence;          ///< every observed output has its verdict
  std::optional<Comparison> first;  ///< the run of the first difference, lit in both programs
  std::size_t countOf(Equality equality) const;
};

/// `form`: how the run of the first difference is drawn; `width`: columns of its drawings.
ProgramDifference differenceOf(const Sides& sides, const EquivalenceOptions& options, const std::string& form,
                               int width);

}  // namespace rungproof
