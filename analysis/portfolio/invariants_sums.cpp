// Properties speak of the end of a scan: their sums are of words' next values. The same sum of the words themselves is
// what is followed from scan to scan.
#include "analysis/portfolio/invariants_sums.hpp"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <optional>
#include <set>
#include <unordered_map>
#include <unordered_set>

#include "analysis/graph/evaluate.hpp"
#include "analysis/graph/substitution.hpp"
#include "analysis/portfolio/sum_facts.hpp"
#include "analysis/portfolio/word_change.hpp"
#include "analysis/schedule/schedule.hpp"

namespace rungproof {

namespace {

class SumSearch {
 public:
  SumSearch(const TransitionSystem& system, const Questions& questions) : system_(system), graph_(*system.graph) {
    std::vector<Node> bads;
    for (const std::size_t q : questions) bads.push_back(system.questions[q].bad);
    cone_ = coneOf(graph_, bads);
    for (const Node n : cone_) seen_.insert(indexOf(n));
    for (std::size_t s = 0; s < system.states.size(); ++s) {
      const NodeData& next = graph_[system.states[s].next];
      if (next.op != Op::Constant) stateOf_.emplace(indexOf(system.states[s].next), s);
    }
    questions_ = questions;
  }

  AskedSums run() {
    const std::vector<Node> comparisons = sumComparisons();
    findLimits();
    for (const Asked& asked : tops_) follow(asked);
    if (found_.sums.empty()) return {};
    for (const auto& [next, s] : stateOf_) {
      if (isSeen(system_.states[s].node)) replaced_.emplace(next, system_.states[s].node);
    }
    findFirstScans();
    guessSums(comparisons);
    guessStarts();
    guessRanges();
    return std::move(found_);
  }

 private:
  /// A word of a sum, and how it is extended to the width of the sum.
  struct Term {
    std::size_t state;
    Op extension;
    bool isSubtracted;
  };
  /// At the end of a scan: a sum, or the difference of two.
  struct Asked {
    Node end = noNode, left = noNode, right = noNode;
  };
  /// How often each part is added, extended like that, less how often it is taken away.
  using Parts = std::map<std::pair<AddedPart, Op>, int>;

  bool isSeen(Node n) const { return seen_.contains(indexOf(n)); }
  bool isAddition(Node n) const { return graph_[n].op == Op::Add || graph_[n].op == Op::Sub; }
  bool isExtension(Node n) const { return graph_[n].op == Op::Sext || graph_[n].op == Op::Zext; }
  bool isSum(Node n) const { return isAddition(n) || (isExtension(n) && isAddition(graph_[n].child[0])); }

  /// Nodes of width 1 that speak of a sum. Of two sides that both change, the difference is followed, else the sum.
  std::vector<Node> sumComparisons() {
    std::vector<Node> comparisons;
    for (const Node n : cone_) {
      const auto [left, right, unused] = graph_[n].child;
      const Op op = graph_[n].op;
      if ((op != Op::Equal && op != Op::Slt && op != Op::Ult) || (!isSum(left) && !isSum(right))) continue;
      comparisons.push_back(n);
      const bool isFixed = graph_[left].op == Op::Constant || graph_[right].op == Op::Constant;
      const Asked asked = isFixed ? Asked{isSum(left) ? left : right}
                                  : Asked{graph_.make(Op::Sub, graph_[left].width, left, right), left, right};
      if (std::ranges::find(tops_, asked.end, &Asked::end) != tops_.end()) continue;
      tops_.push_back(asked);
      if (!isFixed) comparisons.push_back(isZero(asked.end));
    }
    return comparisons;
  }
  Node isZero(Node n) { return graph_.make(Op::Equal, 1, n, graph_.constantNode(0, graph_[n].width)); }

  /// False where something else is added than next values of words and constants.
  bool open(Node n, Op extension, bool isSubtracted, std::vector<Term>& terms) const {
    const NodeData& node = graph_[n];
    if (isAddition(n)) {
      return open(node.child[0], extension, isSubtracted, terms) &&
             open(node.child[1], extension, isSubtracted != (node.op == Op::Sub), terms);
    }
    if (isExtension(n)) return open(node.child[0], node.op, isSubtracted, terms);
    if (node.op == Op::Constant) return true;
    const auto state = stateOf_.find(indexOf(n));
    if (state == stateOf_.end()) return false;
    terms.push_back({state->second, extension, isSubtracted});
    return terms.size() <= schedule::sumTerms;
  }
  Node extended(Node n, int width, Op extension) {
    return graph_[n].width == width ? n : graph_.make(extension, width, n);
  }
  void follow(const Asked& asked) {
    const Node top = asked.end;
    const int width = graph_[top].width;
    std::vector<Term> terms;
    if (!open(top, Op::Sext, false, terms) || terms.size() < 2) return;
    KeptSum kept;
    std::unordered_map<std::uint32_t, Node> starts;
    Node isKept = graph_.constantNode(1, 1);
    Parts all;
    std::vector<Node> guide;
    for (const Term& t : terms) {
      const StateVariable& state = system_.states[t.state];
      std::optional<WordChange> change = changeOf(graph_, state.node, state.next);
      if (!change) change = WordChange{{{{noNode, state.next}, 1}, {{noNode, state.node}, -1}}, noNode};
      SumTerm term{extended(state.node, width, t.extension), noNode, t.isSubtracted, change->counts};
      term.next = term.term;
      for (const auto& [part, times] : change->parts) {
        all[{part, t.extension}] += t.isSubtracted ? -times : times;
        for (int i = 0; i < std::abs(times); ++i)
          term.next = graph_.make(times < 0 ? Op::Sub : Op::Add, width, term.next, amountOf(part, t.extension, width));
      }
      const Node end = extended(state.next, width, t.extension);
      const Node becomes = graph_.make(Op::Equal, 1, end, term.next);
      isKept = graph_.make(Op::And, 1, isKept, becomes);
      const Node counts = term.counts == noNode ? graph_.constantNode(1, 1) : term.counts;
      guide.push_back(graph_.make(Op::Or, 1, graph_.make(Op::Not, 1, counts), becomes));
      starts.emplace(indexOf(state.next), state.node);
      kept.terms.push_back(term);
      words_.insert({t.state, t.extension});
    }
    Substitution atStart(graph_, std::move(starts));
    kept.sum = atStart(top);
    kept.next = withParts(kept.sum, all, kept.steps);
    if (!consistsOfSums(graph_, kept)) return;
    kept.steps.push_back(graph_.make(Op::Equal, 1, kept.next, kept.sum));
    kept.facts = factsOfSum(graph_, kept.sum, limits_);
    if (asked.left != noNode)
      kept.facts.push_back(graph_.make(Op::Equal, 1, isZero(kept.sum),
                                       graph_.make(Op::Equal, 1, atStart(asked.left), atStart(asked.right))));
    for (const Node n : kept.facts) found_.guide.push_back({n, false});
    for (const Node n : guide) found_.guide.push_back({n, false});
    for (const Node n : kept.steps) found_.guide.push_back({n, false});
    for (const Node n : kept.facts) found_.guide.push_back({n, true});
    const Node same = graph_.make(Op::Equal, 1, top, kept.next);
    found_.theorems.push_back(graph_.make(Op::Or, 1, graph_.make(Op::Not, 1, isKept), same));
    replaced_[indexOf(top)] = kept.sum;
    found_.sums.push_back(std::move(kept));
  }
  /// A part once, added or taken away.
  struct Single {
    AddedPart part;
    Op extension, op;
    bool endsPair = false;
  };
  /// Each part that takes back another one behind that, since both mostly are of one network: a solver which knows that
  /// their conditions are one has nothing left to add.
  static std::vector<Single> inPairs(const Parts& parts) {
    std::vector<Single> singles, result;
    for (const auto& [added, times] : parts) {
      for (int i = 0; i < std::abs(times); ++i)
        singles.push_back({added.first, added.second, times < 0 ? Op::Sub : Op::Add});
    }
    std::vector<bool> isTaken(singles.size(), false);
    for (std::size_t i = 0; i < singles.size(); ++i) {
      if (isTaken[i]) continue;
      result.push_back(singles[i]);
      for (std::size_t other = i + 1; other < singles.size(); ++other) {
        if (isTaken[other] || singles[other].op == singles[i].op || singles[other].extension != singles[i].extension ||
            singles[other].part.amount != singles[i].part.amount)
          continue;
        isTaken[other] = true;
        result.push_back(singles[other]);
        result.back().endsPair = true;
        break;
      }
    }
    return result;
  }
  Node amountOf(const AddedPart& part, Op extension, int width) {
    const Node amount = extended(part.amount, width, extension);
    return part.condition == noNode
               ? amount
               : graph_.make(Op::Ite, width, part.condition, amount, graph_.constantNode(0, width));
  }
  /// `nothings`: that what has been added up to then is nothing, again and again.
  Node withParts(Node sum, const Parts& parts, std::vector<Node>& nothings) {
    const int width = graph_[sum].width;
    const Node nothing = graph_.constantNode(0, width);
    Node change = nothing;
    for (const Single& single : inPairs(parts)) {
      change = graph_.make(single.op, width, change, amountOf(single.part, single.extension, width));
      if (single.endsPair) nothings.push_back(isZero(change));
    }
    return change == nothing ? sum : graph_.make(Op::Add, width, sum, change);
  }

  void guess(Node n) {
    for (const Node under : coneOf(graph_, std::vector{n})) {
      const NodeData& node = graph_[under];
      if (node.op == Op::Variable && (!graph_.variables()[node.value].isState || !isSeen(under))) return;
    }
    if (graph_[n].op != Op::Constant) found_.guesses.push_back(n);
  }
  /// Also: from the second scan on.
  void guessLater(Node n) {
    guess(n);
    for (const Node first : firstScans_) guess(graph_.make(Op::Or, 1, first, n));
  }
  void guessSums(const std::vector<Node>& comparisons) {
    Substitution atStart(graph_, replaced_);
    for (const std::size_t q : questions_) guess(graph_.make(Op::Not, 1, atStart(system_.questions[q].bad)));
    for (const Node n : comparisons) {
      const Node before = atStart(n);
      guessLater(before);
      guessLater(graph_.make(Op::Not, 1, before));
    }
  }

  /// Truths of the state that hold before the first scan and never again.
  void findFirstScans() {
    const auto isConstant = [&](Node n, std::uint64_t value) {
      return n != noNode && graph_[n].op == Op::Constant && graph_[n].value == value;
    };
    for (const StateVariable& state : system_.states) {
      if (graph_[state.node].width == 1 && isConstant(state.init, 1) && isConstant(state.next, 0))
        firstScans_.push_back(state.node);
    }
  }
  void guessStarts() {
    for (const auto& [s, extension] : words_) {
      const StateVariable& state = system_.states[s];
      if (state.init == noNode) continue;
      const Node isStart = graph_.make(Op::Equal, 1, state.node, state.init);
      for (const Node first : firstScans_) guess(graph_.make(Op::Or, 1, graph_.make(Op::Not, 1, first), isStart));
    }
  }

  /// Constants of the questions' cone that something is compared with.
  void findLimits() {
    for (const Node n : cone_) {
      const NodeData& node = graph_[n];
      if (node.op != Op::Equal && node.op != Op::Slt && node.op != Op::Ult) continue;
      for (const Node child : {node.child[0], node.child[1]}) {
        const NodeData& limit = graph_[child];
        const int above = 64 - limit.width;  // bits
        if (limit.op == Op::Constant && limits_.size() < schedule::sumLimits)
          limits_.insert(static_cast<std::int64_t>(limit.value << above) >> above);
      }
    }
  }
  void guessRanges() {
    for (const auto& [s, extension] : words_) {
      const Node word = system_.states[s].node;
      const int width = graph_[word].width;
      const std::uint64_t most = Graph::maskOf(width) >> (extension == Op::Sext ? 1 : 0);
      guess(graph_.make(Op::Not, 1, graph_.make(Op::Equal, 1, word, graph_.constantNode(most, width))));
      const Op less = extension == Op::Sext ? Op::Slt : Op::Ult;
      for (const std::int64_t limit : limits_) {
        const std::int64_t half = std::int64_t{1} << (width - 1);
        if (limit < -half || limit >= half) continue;
        const Node constant = graph_.constantNode(static_cast<std::uint64_t>(limit) & Graph::maskOf(width), width);
        guess(graph_.make(Op::Not, 1, graph_.make(less, 1, word, constant)));
        guess(graph_.make(Op::Not, 1, graph_.make(less, 1, constant, word)));
      }
    }
  }

  const TransitionSystem& system_;
  Graph& graph_;
  Questions questions_;
  std::vector<Node> cone_;  ///< of the questions
  std::unordered_set<std::uint32_t> seen_;
  std::unordered_map<std::uint32_t, std::size_t> stateOf_;  ///< by the node of its next value
  std::vector<Asked> tops_;
  std::unordered_map<std::uint32_t, Node> replaced_;  ///< ends of a scan by its start
  std::set<std::pair<std::size_t, Op>> words_;
  std::vector<Node> firstScans_;
  std::set<std::int64_t> limits_{0};
  AskedSums found_;
};

}  // namespace

AskedSums sumsAskedFor(const TransitionSystem& system, const Questions& questions) {
  return SumSearch(system, questions).run();
}

}  // namespace rungproof
