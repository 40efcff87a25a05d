// The networks behind a verdict: those that write what a property looks at, in the same scan or - where the question
// depends on it - in earlier ones, and those that decide whether these run. A network that is not named can be changed
// without touching the verdict. Covered by tests/prover/networks_test.cpp.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

#include "analysis/encoding/encoder.hpp"
#include "analysis/flow/facts.hpp"

namespace rungproof {

using NetworkName = std::pair<std::string, int>;  ///< block and network number

/// Made once for a program: each question costs what its own networks cost. Both must outlive it.
class NetworksBehind {
 public:
  NetworksBehind(const Facts& facts, const EncodedScan& encoding);
  ~NetworksBehind();

  /// `read`: what the property looks at, at the end of a scan; `variables`: node indices of the state that the verdict
  /// depends on. In program order.
  std::vector<NetworkName> of(const Operands& read, const std::unordered_set<std::uint32_t>& variables);

 private:
  class Walk;
  std::unique_ptr<Walk> walk_;
};

/// "MAIN 1, 3-5; SBR_0 2".
std::string networkList(const std::vector<NetworkName>& networks);

}  // namespace rungproof
