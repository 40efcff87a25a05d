// One question for each word and cap, over one scan; the smallest cap that holds is taken.
#include "analysis/portfolio/word_caps.hpp"

#include <algorithm>
#include <bit>
#include <set>
#include <unordered_map>

#include "analysis/bits/bit_blast.hpp"
#include "analysis/bits/bit_cnf.hpp"
#include "analysis/bits/sat.hpp"
#include "analysis/graph/evaluate.hpp"
#include "analysis/graph/substitution.hpp"
#include "analysis/schedule/schedule.hpp"

namespace rungproof {

namespace {

class WordCaps {
 public:
  WordCaps(const TransitionSystem& given, const Questions& questions, const Budget& budget)
      : given_(given), questions_(questions), graph_(*given.graph), budget_(budget) {}

  CappedSystem run() {
    CappedSystem result;
    result.system = given_;
    std::unordered_map<std::uint32_t, Node> wide;
    for (std::size_t s = 0; s < given_.states.size() && !budget_.isExhausted(); ++s) {
      const StateVariable& state = given_.states[s];
      if (graph_[state.node].width < schedule::cappedWidth || state.init == noNode) continue;
      if (const std::uint64_t cap = capOf(s); cap != 0) result.words.push_back(wordOf(s, cap));
    }
    if (result.words.empty()) return result;
    for (const CappedWord& word : result.words)
      wide.emplace(indexOf(word.given), graph_.make(Op::Zext, graph_[word.given].width, word.narrow));
    Substitution substituted(graph_, std::move(wide));
    for (StateVariable& state : result.system.states) state.next = substituted(state.next);
    for (const CappedWord& word : result.words) {
      StateVariable& state = result.system.states[word.state];
      const int width = graph_[word.narrow].width;
      state.node = word.narrow;
      state.init = graph_.constantNode(graph_[state.init].value, width);
      state.next = graph_.make(Op::Extract, width, minimum(state.next, word.cap));
    }
    for (Node& n : result.system.constraints) n = substituted(n);
    for (Node& n : result.system.totalConstraints) n = substituted(n);
    for (Question& question : result.system.questions) question.bad = noNode;
    for (const std::size_t q : questions_) result.system.questions[q].bad = substituted(given_.questions[q].bad);
    return result;
  }

 private:
  Node minimum(Node n, std::uint64_t cap) {
    const int width = graph_[n].width;
    const Node most = graph_.constantNode(cap, width);
    return graph_.make(Op::Ite, width, graph_.make(Op::Ult, 1, n, most), n, most);
  }

  CappedWord wordOf(std::size_t s, std::uint64_t cap) {
    CappedWord word;
    word.state = s;
    word.cap = cap;
    word.given = given_.states[s].node;
    const int width = graph_[word.given].width, narrow = std::bit_width(cap);
    word.narrow = graph_.variable(graph_.variables()[graph_[word.given].value].name + " capped", narrow, true);
    word.capped = graph_.make(Op::Extract, narrow, minimum(word.given, cap));
    word.range = graph_.make(Op::Ult, 1, word.given, graph_.constantNode(1ULL << (width - 1), width));
    return word;
  }

  bool dependsOn(Node root, Node variable) const {
    const Node roots[] = {root};
    const std::vector<Node> cone = coneOf(graph_, roots);
    return std::binary_search(cone.begin(), cone.end(), variable);
  }

  /// The smallest cap among the constants that a scan has beside the word, and their successors; 0: none.
  std::uint64_t capOf(std::size_t s) {
    const Node word = given_.states[s].node;
    const std::uint64_t init = graph_[given_.states[s].init].value;
    std::vector<Node> roots;
    const auto collect = [&](Node n) {
      if (dependsOn(n, word)) roots.push_back(n);
    };
    for (std::size_t i = 0; i < given_.states.size(); ++i) {
      if (i != s) collect(given_.states[i].next);
    }
    for (const Node n : given_.constraints) collect(n);
    for (const std::size_t q : questions_) collect(given_.questions[q].bad);
    const int width = graph_[word].width;
    std::set<std::uint64_t> constants;
    std::vector<Node> all = roots;
    all.push_back(given_.states[s].next);
    for (const Node n : coneOf(graph_, all)) {
      const std::uint64_t value = graph_[n].value;
      // A cap that saves no bit is not worth a question.
      if (graph_[n].op == Op::Constant && value > 1 && value + 1 < 1ULL << (width - 2))
        constants.insert({value, value + 1});
    }
    while (constants.size() > 2 * schedule::cappingConstants) constants.erase(constants.begin());
    for (const std::uint64_t cap : constants) {
      if (cap > init && !budget_.isExhausted() && holds(s, cap, roots)) return cap;
    }
    return 0;
  }

  /// For all values below 2^(width - 1): they stay there, the roots do not tell the word from its minimum with the cap,
  /// and the next values' minima are equal.
  bool holds(std::size_t s, std::uint64_t cap, const std::vector<Node>& roots) {
    const StateVariable& state = given_.states[s];
    const int width = graph_[state.node].width;
    Substitution capped(graph_, {{indexOf(state.node), minimum(state.node, cap)}});
    const auto differ = [&](Node a, Node b) { return graph_.make(Op::Not, 1, graph_.make(Op::Equal, 1, a, b)); };
    const auto either = [&](Node a, Node b) { return graph_.make(Op::Or, 1, a, b); };
    const Node half = graph_.constantNode(1ULL << (width - 1), width);
    Node wrong = either(graph_.make(Op::Not, 1, graph_.make(Op::Ult, 1, state.next, half)),
                        differ(minimum(state.next, cap), minimum(capped(state.next), cap)));
    for (const Node n : roots) wrong = either(wrong, differ(n, capped(n)));
    wrong = graph_.make(Op::And, 1, wrong, graph_.make(Op::Ult, 1, state.node, half));
    if (graph_[wrong].op == Op::Constant) return graph_[wrong].value == 0;
    const BitBlast blast(given_, wrong, {});
    if (!blast.unmodelled().empty()) return false;
    const Lit l = blast.bits().bads[0];
    if (variableOf(l) == 0) return l == falseLit;
    Sat sat(Sat::Use::Many);
    BitCnf cnf(blast.bits(), sat);
    sat.add({cnf.literal(l)});
    return sat.solve({}, budget_.slice(schedule::cappingQuerySeconds)) == Sat::Outcome::Unsatisfiable;
  }

  const TransitionSystem& given_;
  const Questions& questions_;
  Graph& graph_;
  const Budget& budget_;
};

}  // namespace

Node CappedSystem::onGivenSystem(Graph& graph, Node n) const {
  std::unordered_map<std::uint32_t, Node> back;
  for (const CappedWord& word : words) back.emplace(indexOf(word.narrow), word.capped);
  return Substitution(graph, std::move(back))(n);
}

CappedSystem capWords(const TransitionSystem& given, const Questions& questions, const Budget& budget) {
  return WordCaps(given, questions, budget).run();
}

}  // namespace rungproof
