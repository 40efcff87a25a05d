// A witness as electricians read it: the networks that matter, as ladder with the power flow of the last scans.
// Tested by tests/show/witness_drawing_test.cpp.
#pragma once

#include <vector>

#include "analysis/proof/prover.hpp"
#include "frontend/report.hpp"
#include "ir/program.hpp"

namespace rungproof {

struct WitnessDrawingOptions {
  Form form = Form::Ladder;
  bool asRead = false;    ///< FBD programs as FBD, whatever `form` says
  std::size_t scans = 3;  ///< the last ones of the run
  bool text = true;
  bool svg = false;
};

/// The networks that drive the addresses of the property, then those that drive what these read, until there are enough
/// for a page; in program order.
std::vector<std::pair<const Pou*, const Network*>> networksThatMatter(const Program& program,
                                                                      const ProofResult& result);

/// The last scans of the witness, replayed by the reference engine. Empty without a witness.
std::vector<ShownScan> shownScans(const Program& program, const Choices& choices, const ProofResult& result,
                                  const WitnessDrawingOptions& options);

}  // namespace rungproof
