// One solver for all words: "the word has one of the values so far" is a chain of variables, one for each value; a
// model in which the next value is another one adds a link.
#include "analysis/portfolio/invariants_values.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "analysis/bits/bit_unrolling.hpp"
#include "analysis/bits/simulation_runs.hpp"
#include "analysis/schedule/schedule.hpp"

namespace rungproof {

namespace {

class ValueSearch {
 public:
  ValueSearch(const TransitionSystem& system, BitBlast& blast, const Invariants& known, std::uint64_t seed,
              const Budget& budget)
      : system_(system),
        graph_(*system.graph),
        blast_(blast),
        budget_(budget),
        seed_(seed),
        steps_(blast.bits(), Unrolling::Start::Any),
        sat_(Sat::Use::Many),
        cnf_(steps_.graph(), sat_) {
    for (const Lit constraint : blast.bits().constraints) sat_.add({cnf_.literal(steps_.at(0, constraint))});
    for (const std::vector<Lit>& clause : known.clauses) {
      std::vector<int> literals;
      for (const Lit l : clause) literals.push_back(cnf_.literal(steps_.at(0, l)));
      sat_.add(literals);
    }
  }

  std::vector<WordValues> run() {
    collect();
    sample();
    std::ranges::stable_sort(words_, {}, [](const Candidate& w) { return w.values.size(); });
    // A word whose values follow from those of a later one has its chance when these are known.
    for (int pass = 0; pass < schedule::valuePasses; ++pass) {
      const auto before = static_cast<std::size_t>(std::ranges::count_if(words_, &Candidate::isClosed));
      for (Candidate& word : words_) {
        if (!word.isClosed && !budget_.isExhausted()) close(word);
      }
      if (static_cast<std::size_t>(std::ranges::count_if(words_, &Candidate::isClosed)) == before) break;
    }
    std::vector<WordValues> result;
    for (const Candidate& word : words_) {
      if (word.isClosed) result.push_back({word.state, {word.values.begin(), word.values.end()}});
    }
    return result;
  }

 private:
  struct Candidate {
    std::size_t state = 0;
    LitVector bits;  ///< lowest first
    std::set<std::uint64_t> values;
    std::array<std::uint64_t, 64> last{};  ///< by run
    std::size_t changes = 0;
    bool isClosed = false;
    /// Of many values hardly any comes twice, as of results of arithmetic on inputs.
    bool isScattered() const { return values.size() > schedule::fewValues && 2 * values.size() > changes; }
  };
  /// More values than are listed, or most of a range, of which bounds say as much.
  static bool isHopeless(const std::set<std::uint64_t>& values) {
    return values.size() > schedule::valueLimit ||
           (values.size() > schedule::fewValues && 2 * values.size() > *values.rbegin() - *values.begin());
  }

  /// Words of the cone that begin with one value. Timers count through all of theirs, which bounds say better.
  void collect() {
    std::set<Node> timers;
    for (const TimerHint& timer : system_.timers) timers.insert({timer.current, timer.rest});
    std::set<std::size_t> seen;
    for (std::uint32_t latch = 0; latch < blast_.bits().latches.size(); ++latch) {
      const std::size_t state = blast_.stateBit(latch).state;
      const StateVariable& variable = system_.states[state];
      if (graph_[variable.node].width < 2 || variable.init == noNode || graph_[variable.init].op != Op::Constant ||
          timers.contains(variable.node))
        continue;
      if (!seen.insert(state).second) continue;
      words_.push_back({state, blast_.of(variable.node), {graph_[variable.init].value}});
    }
  }

  /// Words with more values than the limit are soon known by random runs.
  void sample() {
    SimulationRuns runs(blast_.bits(), seed_);
    for (int scan = 0; scan < schedule::valueScans && !budget_.isExhausted() && runs.choose(); ++scan) {
      for (Candidate& word : words_) {
        for (std::uint64_t lanes = runs.live() & schedule::valueLanes; lanes != 0; lanes &= lanes - 1) {
          const auto lane = static_cast<std::size_t>(std::countr_zero(lanes));
          std::uint64_t value = 0;
          for (std::size_t bit = 0; bit < word.bits.size(); ++bit)
            value |= (runs.simulator().value(word.bits[bit]) >> lane & 1U) << bit;
          word.values.insert(value);
          if (std::exchange(word.last[lane], value) != value) ++word.changes;
        }
      }
      std::erase_if(words_, [](const Candidate& w) { return w.isScattered() || isHopeless(w.values); });
      runs.step();
    }
  }

  int equals(int frame, const Candidate& word, std::uint64_t value) {
    Lit result = trueLit;
    for (std::size_t bit = 0; bit < word.bits.size(); ++bit) {
      const Lit l = steps_.at(frame, word.bits[bit]);
      result = steps_.graph().addAnd(result, (value >> bit & 1U) != 0 ? l : negate(l));
    }
    return cnf_.literal(result);
  }

  /// Adds values until a scan makes no other of them; gives up beyond the limit.
  void close(Candidate& word) {
    std::set<std::uint64_t> values = word.values;
    const int isOther = sat_.newVariable();  // behind the scan
    int link = 0;
    const auto add = [&](std::uint64_t value) {
      const int next = sat_.newVariable(), now = equals(0, word, value);
      if (link == 0)
        sat_.add({-next, now});
      else
        sat_.add({-next, now, link});
      link = next;
      sat_.add({-isOther, -equals(1, word, value)});
    };
    for (const std::uint64_t value : values) add(value);
    for (const Lit l : word.bits) cnf_.literal(steps_.at(1, l));
    Sat::Outcome outcome = Sat::Outcome::Satisfiable;
    while (!isHopeless(values)) {
      outcome = sat_.solve({link, isOther}, budget_);
      if (outcome != Sat::Outcome::Satisfiable) break;
      std::uint64_t value = 0;
      for (std::size_t bit = 0; bit < word.bits.size(); ++bit)
        value |= static_cast<std::uint64_t>(isTrue(steps_.at(1, word.bits[bit]))) << bit;
      if (!values.insert(value).second) return;
      add(value);
    }
    if (outcome != Sat::Outcome::Unsatisfiable) return;
    word.values = std::move(values);
    word.isClosed = true;
    sat_.add({link});  // from here on known of the state before a scan
  }
  bool isTrue(Lit l) const { return l == trueLit || (l != falseLit && cnf_.value(l)); }

  const TransitionSystem& system_;
  const Graph& graph_;
  BitBlast& blast_;
  const Budget& budget_;
  const std::uint64_t seed_;
  Unrolling steps_;
  Sat sat_;
  BitCnf cnf_;
  std::vector<Candidate> words_;
};

}  // namespace

std::vector<WordValues> mineWordValues(const TransitionSystem& system, BitBlast& blast, const Invariants& known,
                                       std::uint64_t seed, const Budget& budget) {
  return ValueSearch(system, blast, known, seed, budget).run();
}

Node isOneOf(Graph& graph, Node word, const std::vector<std::uint64_t>& values) {
  const int width = graph[word].width;
  Node result = graph.constantNode(0, 1);
  for (std::size_t begin = 0, end = 0; begin < values.size(); begin = end) {
    for (end = begin + 1; end < values.size() && values[end] == values[end - 1] + 1;) ++end;
    const Node low = graph.constantNode(values[begin], width), high = graph.constantNode(values[end - 1], width);
    const Node isIn = end == begin + 1 ? graph.make(Op::Equal, 1, word, low)
                                       : graph.make(Op::And, 1, graph.make(Op::Ule, 1, low, word),
                                                    graph.make(Op::Ule, 1, word, high));
    result = graph.make(Op::Or, 1, result, isIn);
  }
  return result;
}

}  // namespace rungproof
