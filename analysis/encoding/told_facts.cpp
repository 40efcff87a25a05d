// Decisions, lists of values and footprints of an encoding, written as nodes of it.
#include "analysis/encoding/told_facts.hpp"

#include <algorithm>
#include <unordered_set>

#include "analysis/encoding/scan_encoding.hpp"

namespace rungproof {

namespace {

bool isFree(Graph& graph, Graph::Bool fact) {
  return graph[fact.node].op == Op::Constant && graph[fact.node].value == 1;
}

}  // namespace

std::vector<Node> ScanEncoding::decidedFacts() {
  std::vector<Node> facts;
  for (const Graph::Decided& d : graph.decided()) {
    const int w = graph[d.node].width;
    const Graph::Bits value = graph.literal(d.value, w);
    Graph::Bool fact = w > 1          ? graph.equal({d.node}, value, w)
                       : d.value != 0 ? Graph::Bool{d.node}
                                      : graph.lnot({d.node});
    if (d.guard != noNode && graph[d.guard].op != Op::Constant) fact = graph.lor(graph.lnot({d.guard}), fact);
    facts.push_back(fact.node);
  }
  return facts;
}

/// What the encoding was built on: values of cells at the start of scans, in the first one and later.
void ScanEncoding::addKnownValues(ToldFacts& told) {
  std::vector<Node> firsts;
  for (const Cell& cell : cells()) {
    if (std::ranges::find(knowledge_.firstScans, cell.place) != knowledge_.firstScans.end())
      firsts.push_back(cell.start);
  }
  for (const Node first : firsts) {
    if (first != firsts.front())
      told.known[indexOf(first)].push_back(graph.lnot(graph.lxor({firsts.front()}, {first})).node);
  }
  for (const Cell& cell : cells()) {
    if (cell.kind != CellKind::State) continue;
    std::vector<Node>& facts = told.known[indexOf(cell.start)];
    if (const auto values = knowledge_.values.find(cell.place); values != knowledge_.values.end()) {
      if (const Graph::Bool fact = isIn(graph, cell.start, values->second); !isFree(graph, fact))
        facts.push_back(fact.node);
    }
    if (const auto later = knowledge_.later.find(cell.place); later != knowledge_.later.end() && !firsts.empty()) {
      const Graph::Bool fact = isIn(graph, cell.start, later->second);
      if (!isFree(graph, fact)) facts.push_back(graph.lor({firsts.front()}, fact).node);
      if (const Node first = init(cell.place); first != noNode) {
        const Graph::Bool isInitial = graph.equal({cell.start}, {first}, cell.place.width);
        facts.push_back(graph.lor(graph.lnot({firsts.front()}), isInitial).node);
      }
    }
    if (facts.empty()) told.known.erase(indexOf(cell.start));
  }
  for (const KnownWalk& walk : knowledge_.walks) {
    std::vector<Node> nodes;
    for (const Place& place : walk.cells) {
      const auto cell = std::ranges::find(cells(), place, &Cell::place);
      if (cell != cells().end()) nodes.push_back(cell->start);
    }
    if (firsts.empty() || nodes.size() != walk.cells.size()) continue;
    Graph::Bool fact{firsts.front()};
    for (const std::vector<std::uint64_t>& values : walk.together) {
      Graph::Bool are = graph.constant(true);
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        const int w = graph[nodes[i]].width;
        are = graph.land(are, graph.equal({nodes[i]}, graph.literal(values[i], w), w));
      }
      fact = graph.lor(fact, are);
    }
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      std::vector<Node>& facts = told.known[indexOf(nodes[i])];
      facts.push_back(fact.node);
      if (const Node first = init(walk.cells[i]); first != noNode) {
        const Graph::Bool isInitial = graph.equal({nodes[i]}, {first}, graph[nodes[i]].width);
        facts.push_back(graph.lor(graph.lnot({firsts.front()}), isInitial).node);
      }
    }
  }
}

ToldFacts ScanEncoding::toldFacts() {
  ToldFacts told;
  if (!graph.isAsWritten()) return told;
  const auto once = [](std::vector<Node> nodes) {
    std::unordered_set<std::uint32_t> seen;
    std::erase_if(nodes, [&](Node n) { return !seen.insert(indexOf(n)).second; });
    return nodes;
  };
  told.conditions = once(decidedFacts());
  told.pointers = once(listFacts);
  if (effects_ != nullptr) told.effects = effects_->asFacts(graph, plan_, layout_);
  // Which places of the program an interrupt can come to, and what routines write that say no more than that.
  bool isBeyond = Footprints(knowledge_.footprints).merge(footprints_);
  isBeyond = isBeyond || TableTargets(knowledge_.tables).add(tableTargets_);
  if (isBeyond) told.effects.push_back(graph.constantNode(0, 1));
  addKnownValues(told);
  for (const KeptCell& cell : keptCells) {
    const int w = graph[cell.node].width;
    told.known[indexOf(cell.node)] = {graph.equal({cell.node}, graph.literal(cell.value, w), w).node};
  }
  return told;
}

}  // namespace rungproof
