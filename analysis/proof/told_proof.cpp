// What the facts rest on is followed through the next-state functions, from cell to cell of which something was known.
#include "analysis/proof/told_proof.hpp"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

#include "analysis/encoding/exact_reals.hpp"
#include "analysis/graph/evaluate.hpp"

namespace rungproof {

namespace {

Node conjunction(Graph& graph, const std::vector<Node>& facts) {
  Graph::Bool all = graph.constant(true);
  for (const Node fact : facts) all = graph.land(all, {fact});
  return all.node;
}

/// What is known of all cells under the roots, of all under the next values of these, and so on.
std::vector<Node> knownBehind(const TransitionSystem& system, const ToldFacts& told, std::vector<Node> roots) {
  std::unordered_map<std::uint32_t, Node> next;
  for (const StateVariable& state : system.states) next.emplace(indexOf(state.node), state.next);
  std::unordered_set<std::uint32_t> seen;
  std::vector<Node> facts;
  while (!roots.empty()) {
    const Node n = roots.back();
    roots.pop_back();
    if (n == noNode || !seen.insert(indexOf(n)).second) continue;
    const NodeData& node = (*system.graph)[n];
    roots.insert(roots.end(), node.child.begin(), node.child.end());
    const auto known = told.known.find(indexOf(n));
    const auto state = next.find(indexOf(n));
    if (known == told.known.end() || state == next.end()) continue;
    facts.insert(facts.end(), known->second.begin(), known->second.end());
    roots.insert(roots.end(), known->second.begin(), known->second.end());  // they may speak of the first scan
    roots.push_back(state->second);
  }
  return facts;
}

}  // namespace

ToldProof::ToldProof(const TransitionSystem& system, const ToldFacts& told) : system_(system) {
  Graph& graph = *system_.graph;
  std::vector<Node> roots;
  for (const auto& [name, facts] :
       {std::pair("known conditions", &told.conditions), std::pair("targets of pointers", &told.pointers),
        std::pair("effects of interrupt routines", &told.effects)}) {
    if (facts->empty()) continue;
    parts_.push_back({name, conjunction(graph, *facts)});
    roots.push_back(parts_.back().fact);
  }
  invariant_ = knownBehind(system_, told, roots);
}

void ToldProof::addParts(CertificateWriter& writer) const {
  WordCertificate invariant;
  invariant.invariant = invariant_;
  writer.addInvariant("what the encoding was told", invariant);
  for (const Part& part : parts_) writer.addConsequence(part.name, invariant, part.fact);
}

CheckResult ToldProof::check(const CheckLimits& limits) {
  if (result_) return *result_;
  result_ = CheckResult::Valid;
  if (parts_.empty()) return *result_;
  const auto judge = [&] {
    CertificateWriter writer(system_);
    addParts(writer);
    const std::vector<CheckResult> results = writer.check(limits);
    result_ = CheckResult::Valid;
    reason_.clear();
    for (std::size_t i = 0; i < results.size(); ++i) {
      if (results[i] == CheckResult::Valid) continue;
      if (result_ == CheckResult::Valid || results[i] == CheckResult::Invalid) result_ = results[i];
      if (!reason_.empty()) reason_ += ", ";
      reason_ += i == 0 ? "values that cells keep" : parts_[i - 1].name;
    }
  };
  judge();
  if (result_ == CheckResult::Valid) return *result_;
  // What simplification knew of REAL operations is shown by writing them out.
  const Graph& graph = *system_.graph;
  std::vector<Node> roots;
  for (const Part& part : parts_) roots.push_back(part.fact);
  for (const StateVariable& state : system_.states) roots.push_back(state.next);
  const std::vector<Node> cone = coneOf(graph, roots);
  if (std::ranges::none_of(cone, [&](Node n) { return isRealOperation(graph[n].op); })) return *result_;
  system_.questions.clear();
  for (const Part& part : parts_) system_.questions.push_back({part.name, part.fact});
  system_ = withExactReals(system_, RealScope::All);
  for (std::size_t i = 0; i < parts_.size(); ++i) parts_[i].fact = system_.questions[i].bad;
  judge();
  return *result_;
}

std::string ToldProof::text() const {
  if (parts_.empty()) return {};
  CertificateWriter writer(system_);
  addParts(writer);
  return writer.text();
}

}  // namespace rungproof
