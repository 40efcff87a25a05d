// Graph nodes as Z3 bit-vector terms, REAL operations as exact IEEE 754 single arithmetic. One object serves one Z3
// context; terms are shared as the nodes are. Exceptions of Z3 stay inside: a term that Z3 refuses to build, or a
// query that fails, answers Unknown.
// Covered by tests/differential/domain_laws_test.cpp.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analysis/graph/graph.hpp"

namespace z3 {
class context;
class expr;
}  // namespace z3

namespace rungproof {

class Z3Terms {
 public:
  Z3Terms(z3::context& context, const Graph& graph);
  ~Z3Terms();
  Z3Terms(const Z3Terms&) = delete;
  Z3Terms& operator=(const Z3Terms&) = delete;

  /// The term of a node, bit-vector sort of its width. May throw z3::exception.
  z3::expr term(Node node);
  /// The node as a truth value; width 1. May throw z3::exception.
  z3::expr truth(Node node);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

/// Whether values of the variables exist for which all `conditions` (width 1) are 1, within `milliseconds`. Unknown:
/// nothing. `witness`, if given, receives the values of `wanted` nodes, in their order. `steps`: as Z3 counts its work,
/// which is the same on every machine; 0: any number.
std::optional<bool> satisfiable(const Graph& graph, std::span<const Node> conditions, unsigned milliseconds,
                                std::span<const Node> wanted = {}, std::vector<std::uint64_t>* witness = nullptr,
                                unsigned steps = 0);

/// The same question as SMT-LIB 2 text, for another solver.
std::string smtLibText(const Graph& graph, std::span<const Node> conditions);

}  // namespace rungproof
