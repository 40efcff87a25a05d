// A witness as electricians read it: the networks that matter, as ladder with the power flow of the scans that matter.
// Tested by tests/show/witness_drawing_test.cpp.
#pragma once

#include <cstdint>
#include <set>
#include <vector>

#include "analysis/proof/prover.hpp"
#include "frontend/report.hpp"
#include "ir/program.hpp"

namespace rungproof {

struct WitnessDrawingOptions {
  Form form = Form::Ladder;
  bool asRead = false;        ///< FBD programs as FBD, whatever `form` says
  std::size_t lastScans = 3;  ///< of the run, drawn for a page
  bool lastOnly = false;      ///< as text: the last scan and no other
  bool text = true;
  bool svg = false;
  int width = 100;  ///< columns; longer rungs are wrapped
};

/// The networks that drive the addresses of the property, then those that drive what these read, until there are enough
/// for a page; in program order.
std::vector<std::pair<const Pou*, const Network*>> networksThatMatter(const Program& program,
                                                                      const ProofResult& result);

/// The scans that people look at: the first, the last ones in which something changes that is asked about, and the
/// last.
std::set<std::uint64_t> scansThatMatter(const Program& program, const Choices& choices, const ProofResult& result);

/// The scans that matter as text, the last ones for a page, replayed by the reference engine. Empty without a witness.
std::vector<ShownScan> shownScans(const Program& program, const Choices& choices, const ProofResult& result,
                                  const WitnessDrawingOptions& options);

}  // namespace rungproof
