// What a certificate owes: conditions over nodes of a transition system in several scans that no values meet. The same
// obligations are printed as SMT-LIB 2 and checked here. Tested by tests/certificate.
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "analysis/graph/transition_system.hpp"

namespace rungproof {

/// A node in scan `scan`, counted from 0; a state variable has there its value at the start of the scan.
struct ScanNode {
  Node node = noNode;
  int scan = 0;
};

struct Formula {
  enum class Kind : std::uint8_t {
    Truth,  ///< terms[0], of width 1
    Equal,  ///< both terms, of one width
    Not,    ///< of parts[0]
    All,    ///< of parts
    Any     ///< of parts
  };
  Kind kind = Kind::All;
  std::array<ScanNode, 2> terms{};
  std::vector<Formula> parts{};
};

inline Formula truthOf(Node n, int scan) { return {Formula::Kind::Truth, {ScanNode{n, scan}, {}}}; }
inline Formula equals(ScanNode a, ScanNode b) { return {Formula::Kind::Equal, {a, b}}; }
inline Formula notOf(Formula part) {
  Formula result{Formula::Kind::Not};
  result.parts.push_back(std::move(part));
  return result;
}
inline Formula allOf(std::vector<Formula> parts) { return {Formula::Kind::All, {}, std::move(parts)}; }
inline Formula anyOf(std::vector<Formula> parts) { return {Formula::Kind::Any, {}, std::move(parts)}; }

}  // namespace rungproof
