// Candidates are told apart by evaluating them in the two states; no solver is asked.
#include "analysis/words/refinement.hpp"

#include <algorithm>
#include <tuple>

#include "analysis/schedule/schedule.hpp"
#include "analysis/words/terms.hpp"

namespace rungproof {

namespace {}  // namespace

Refinement::Refinement(WordCone& cone, Predicates& predicates) : cone_(cone), predicates_(predicates) {
  std::vector<Node> nodes = linearPredicates(cone, predicates.samples());
  for (const Node n : orderPredicates(cone, schedule::predicateStore)) nodes.push_back(n);
  for (const Node n : nodes) {
    if (cone.graph()[n].op == Op::Constant) continue;
    store_.push_back({n, predicates.overSamples(n)});
  }
}

bool Refinement::add(const std::vector<Node>& nodes, std::size_t most) {
  std::size_t added = 0;
  for (std::size_t i = 0; i < nodes.size() && added < most; ++i) added += predicates_.add(nodes[i]) ? 1 : 0;
  return added > 0;
}

bool Refinement::refine(const WordState& reached, const WordStep& step, Node goal) {
  std::vector<Node> all;
  for (const Candidate& c : store_) all.push_back(c.node);
  for (const Node n : carriedBack(step.state, step.inputs, goal)) all.push_back(n);
  const std::vector<bool> here = predicates_.valuesIn(reached, all), there = predicates_.valuesIn(step.state, all);

  const std::vector<std::uint64_t> inCube = predicates_.samplesIn(step.cube);
  const auto count = [](const std::vector<std::uint64_t>& bits) {
    std::size_t ones = 0;
    for (const std::uint64_t block : bits) ones += static_cast<std::size_t>(std::popcount(block));
    return ones;
  };
  const std::size_t whole = count(inCube);
  struct Telling {
    std::size_t ofCube, ofAll;  ///< samples that it tells from the state
    Node node;
  };
  std::vector<Telling> telling;
  std::vector<Node> carried;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (here[i] == there[i]) continue;
    if (i >= store_.size()) {
      carried.push_back(all[i]);
      continue;
    }
    std::vector<std::uint64_t> different = predicates_.samplesIn({});
    for (std::size_t block = 0; block < different.size(); ++block)
      different[block] &= store_[i].samples[block] ^ (there[i] ? ~0ULL : 0);
    Telling t{0, count(different), all[i]};
    for (std::size_t block = 0; block < different.size(); ++block) different[block] &= inCube[block];
    t.ofCube = count(different);
    telling.push_back(t);
  }
  std::ranges::stable_sort(telling, [](const Telling& a, const Telling& b) {
    return std::tie(a.ofCube, a.ofAll) > std::tie(b.ofCube, b.ofAll);
  });
  std::vector<Node> best;
  for (const Telling& t : telling) best.push_back(t.node);
  const bool tellsAll = !telling.empty() && telling[0].ofCube == whole;
  const bool hasTelling = add(best, schedule::mostTelling);
  const bool hasCarried = !(tellsAll && hasTelling) && add(carried, schedule::mostCarried);
  return hasTelling || hasCarried;
}

std::vector<Node> Refinement::carriedBack(const WordState& state, const std::vector<std::uint64_t>& inputs, Node goal) {
  Graph& graph = cone_.graph();
  std::unordered_map<std::uint32_t, Node> chosen;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const Node input = cone_.system().inputs[i];
    chosen.emplace(indexOf(input), graph.constantNode(inputs[i], graph[input].width));
  }
  const Node root = Substitution(graph, std::move(chosen))(goal);

  // Terms take the arms that the state chooses; the conditions of the choices are predicates as well.
  const Node roots[] = {root};
  Evaluator evaluator(graph, roots);
  for (std::size_t i = 0; i < state.size(); ++i) evaluator.set(cone_.system().states[i].node, state[i]);
  evaluator.run();
  std::vector<Node> result;
  std::unordered_map<std::uint32_t, Node> straight;
  for (const Node n : coneOf(graph, roots)) {
    const NodeData node = graph[n];
    if (node.op == Op::Variable || node.op == Op::Constant) {
      straight.emplace(indexOf(n), n);
      if (node.op == Op::Variable && node.width == 1) result.push_back(n);
      continue;
    }
    if (node.op == Op::Ite && node.width > 1) {
      straight.emplace(indexOf(n), straight.at(indexOf(node.child[evaluator[node.child[0]] != 0 ? 1 : 2])));
      continue;
    }
    std::array<Node, 3> child = node.child;
    for (Node& c : child) {
      if (c != noNode) c = straight.at(indexOf(c));
    }
    const Node made =
        child == node.child ? n : graph.make(node.op, node.width, child[0], child[1], child[2], node.value);
    straight.emplace(indexOf(n), made);
    const bool isOverWords = node.width == 1 && graph[node.child[0]].width > 1;
    if (isOverWords && graph[made].op != Op::Constant) result.push_back(made);
  }
  return result;
}

}  // namespace rungproof
