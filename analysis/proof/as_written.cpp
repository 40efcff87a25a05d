// Variables of both systems are the same in the same order, but for the cells that keep their value.
#include "analysis/proof/as_written.hpp"

#include <array>
#include <unordered_set>
#include <utility>

#include "analysis/encoding/exact_reals.hpp"
#include "analysis/graph/evaluate.hpp"
#include "analysis/schedule/schedule.hpp"

namespace rungproof {

namespace {}  // namespace

AsWritten::AsWritten(QuestionSystem& simplified, std::unique_ptr<QuestionSystem> side)
    : from_(*simplified.system().graph), side_(std::move(side)) {
  const Graph& to = *side_->system().graph;
  for (const KeptCell& cell : side_->askedProperties().encoding().keptCells()) kept_[indexOf(cell.node)] = cell.value;
  for (const StateVariable& state : side_->system().states) next_[indexOf(state.node)] = state.next;
  std::size_t at = 0;
  for (const Variable& variable : from_.variables()) {
    while (at < to.variables().size() && kept_.contains(indexOf(to.variables()[at].node))) ++at;
    if (at == to.variables().size()) break;
    const Variable& other = to.variables()[at++];
    if (other.name != variable.name || to[other.node].width != from_[variable.node].width) break;
    copies_[indexOf(variable.node)] = other.node;
  }
}

ToldProof& AsWritten::told() {
  const EncodedScan& encoding = side_->askedProperties().encoding();
  if (!told_)
    told_.emplace(side_->system(), encoding.toldFacts(), encoding.keptCells(), encoding.approximations().empty());
  return *told_;
}

const TransitionSystem& AsWritten::system(std::size_t question, bool isWritten) {
  if (!isWritten) return side_->system();
  const auto found = written_.find(question);
  if (found != written_.end()) return found->second;
  return written_.emplace(question, withExactReals(side_->only(question), RealScope::All)).first->second;
}

const Question& AsWritten::question(std::size_t question, bool isWritten) {
  return system(question, isWritten).questions[isWritten ? 0 : question];
}

bool AsWritten::isDecidedByForm(std::size_t question) {
  return (*side_->system().graph)[side_->system().questions[question].bad].op == Op::Constant;
}

/// noNode if it has no counterpart.
Node AsWritten::copied(Node root) {
  Graph& to = *side_->system().graph;
  const Node roots[] = {root};
  for (const Node n : coneOf(from_, roots)) {
    if (copies_.contains(indexOf(n))) continue;
    const NodeData& node = from_[n];
    Node copy = noNode;
    if (node.op == Op::Constant) {
      copy = to.constantNode(node.value, node.width);
    } else if (node.op != Op::Variable) {
      std::array<Node, 3> child = node.child;
      bool isWhole = true;
      for (Node& c : child) {
        if (c != noNode) isWhole = (c = copies_.at(indexOf(c))) != noNode && isWhole;
      }
      if (isWhole) copy = to.make(node.op, node.width, child[0], child[1], child[2], node.value);
    }
    copies_.emplace(indexOf(n), copy);
  }
  return copies_.at(indexOf(root));
}

/// Equations of all cells that keep their value and that a proof meets: in the nodes that it looks at once, in what
/// becomes of the variables of those that it follows into the next scan (`isLong`: into any number of scans), and in
/// what becomes of these cells.
std::vector<Node> AsWritten::keptBehind(const std::vector<Node>& once, const std::vector<Node>& followed, bool isLong) {
  Graph& graph = *side_->system().graph;
  std::unordered_set<std::uint32_t> taken;
  std::vector<Node> facts, open;
  std::unordered_set<std::uint32_t> seenOnce, seenFollowed;
  const auto visit = [&](const std::vector<Node>& roots, bool follows) {
    std::unordered_set<std::uint32_t>& seen = follows ? seenFollowed : seenOnce;
    std::vector<Node> stack = roots;
    while (!stack.empty()) {
      const Node n = stack.back();
      stack.pop_back();
      if (n == noNode || !seen.insert(indexOf(n)).second) continue;
      stack.insert(stack.end(), graph[n].child.begin(), graph[n].child.end());
      const auto next = next_.find(indexOf(n));
      if (next == next_.end()) continue;
      const auto kept = kept_.find(indexOf(n));
      if (kept == kept_.end() && !follows) continue;
      if (!taken.insert(indexOf(n)).second) continue;
      open.push_back(next->second);
      if (kept != kept_.end())
        facts.push_back(graph.make(Op::Equal, 1, n, graph.constantNode(kept->second, graph[n].width)));
    }
  };
  visit(followed, true);
  visit(once, isLong);
  while (!open.empty()) visit(std::exchange(open, {}), isLong);
  return facts;
}

std::optional<WordCertificate> AsWritten::translated(std::size_t question, bool isWritten,
                                                     const WordCertificate& certificate, Purpose purpose) {
  const TransitionSystem& whole = system(question, isWritten);
  const Node bad = this->question(question, isWritten).bad;
  WordCertificate own;
  if (!certificate.open.empty() && purpose == Purpose::Check) {
    if (const auto open = proveLocally(whole, bad, Budget::seconds(schedule::asWrittenSeconds), kept_, &own.invariant);
        open && !open->empty()) {
      std::vector<Node> once = own.invariant;
      once.insert(once.end(), whole.constraints.begin(), whole.constraints.end());
      own.open = *open;
      own.invariant = keptBehind(once, {}, false);
      return own;
    }
    own.invariant.clear();
  }
  own.k = certificate.k;
  own.simplePath = certificate.simplePath;
  own.isChain = certificate.isChain;
  bool isWhole = true;
  const auto copyAll = [&](const std::vector<Node>& nodes) {
    std::vector<Node> result;
    for (const Node n : nodes) {
      result.push_back(copied(n));
      isWhole = isWhole && result.back() != noNode;
    }
    return result;
  };
  own.invariant = copyAll(certificate.invariant);
  own.immediate = copyAll(certificate.immediate);
  own.pathBits = copyAll(certificate.pathBits);
  std::vector<Node> followed = own.invariant;
  for (KeptDifference d : certificate.differences) {
    for (Node* n : {&d.left.word, &d.left.increment, &d.left.next, &d.right.word, &d.right.increment, &d.right.next,
                    &d.difference}) {
      *n = copied(*n);
      isWhole = isWhole && *n != noNode;
      followed.push_back(*n);
    }
    own.differences.push_back(d);
  }
  for (KeptSum sum : certificate.sums) {
    std::vector<Node*> nodes{&sum.sum, &sum.next};
    for (std::vector<Node>* presumed : {&sum.facts, &sum.steps}) {
      for (Node& n : *presumed) nodes.push_back(&n);
    }
    for (SumTerm& t : sum.terms) {
      nodes.insert(nodes.end(), {&t.term, &t.next});
      if (t.counts != noNode) nodes.push_back(&t.counts);
    }
    for (Node* n : nodes) {
      *n = copied(*n);
      isWhole = isWhole && *n != noNode;
      followed.push_back(*n);
    }
    own.sums.push_back(std::move(sum));
  }
  if (!isWhole) return std::nullopt;
  std::vector<Node> once = whole.constraints;
  once.push_back(bad);
  const std::vector<Node> facts = keptBehind(once, followed, own.k > 0);
  own.invariant.insert(own.invariant.begin(), facts.begin(), facts.end());
  if (!own.immediate.empty()) own.immediate.insert(own.immediate.begin(), facts.begin(), facts.end());
  return own;
}

}  // namespace rungproof
