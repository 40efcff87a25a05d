// Finds sums "word + increment" in next-state functions, compares increments on random runs, and combines words of
// equal increment with conditions and stops.
#include "analysis/portfolio/bound_templates.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <unordered_map>

#include "analysis/bits/simulation_runs.hpp"
#include "analysis/graph/evaluate.hpp"
#include "analysis/portfolio/bound_rates.hpp"
#include "analysis/schedule/schedule.hpp"

namespace rungproof {

namespace {

class TemplateSearch {
 public:
  TemplateSearch(const TransitionSystem& system, const BitBlast& blast, const Invariants& known, std::uint64_t seed,
                 BoundScope scope, const Budget& budget)
      : system_(system),
        graph_(*system.graph),
        blast_(blast),
        known_(known),
        seed_(seed),
        scope_(scope),
        budget_(budget) {}

  BoundTemplates run() {
    const std::set<std::size_t> telling = tellingStates();
    for (std::uint32_t latch = 0; latch < blast_.bits().latches.size(); ++latch) {
      const std::uint32_t state = blast_.stateBit(latch).state;
      if (inCone_.insert(state).second && telling.contains(state)) order_.push_back(state);
    }
    for (const std::uint32_t state : order_) {
      if (budget_.isExhausted()) return {};
      collect(state);
    }
    if (words_.empty()) return {};
    collectGuards();
    if (scope_ == BoundScope::Chain) return chains();
    if (scope_ == BoundScope::Pending) collectEnds();
    for (const std::uint32_t state : order_) {
      const Node n = word(state);
      if (widthOf(n) > 1 && widthOf(n) <= schedule::smallWidth)
        templates_.push_back({noNode, noNode, graph_.make(Op::Zext, widthOf(n) + 1, n)});
    }
    if (scope_ == BoundScope::Few) rates();
    const std::vector<std::vector<std::size_t>> all = groups();
    for (const std::vector<std::size_t>& group : all) toOneWidth(group);
    // A clock against a timer tells most, two timers least.
    for (const int timers : {1, 0, 2}) {
      if (isNear() && timers != 1) break;
      for (const std::vector<std::size_t>& group : all) {
        for (const std::size_t x : group) {
          if (budget_.isExhausted()) return {};
          for (const std::size_t y : group) {
            if (x != y && (words_[x].isTimer() ? 1 : 0) + (words_[y].isTimer() ? 1 : 0) == timers)
              pair(static_cast<int>(x), static_cast<int>(y), timers == 1 ? clockGuards() : schedule::fewGuards);
          }
        }
      }
      for (const std::vector<std::size_t>& group : all) {
        for (const std::size_t x : group) {
          if (timers == 1 && group.size() > 1) single(words_[x]);
        }
      }
    }
    cutToLimit();
    return {std::move(words_), std::move(templates_), std::move(rates_)};
  }

 private:
  /// While a timer runs, the clock is ahead of it by what the timers before it have taken; when its bit comes, the
  /// clock has come that far.
  BoundTemplates chains() {
    for (const std::vector<std::size_t>& group : groups(schedule::chainedTimers)) {
      if (group.size() < schedule::leastChain) continue;
      toOneWidth(group);
      for (const std::size_t clock : group) {
        if (words_[clock].isTimer() || words_[clock].stops.empty()) continue;
        for (const std::size_t timer : group) {
          if (budget_.isExhausted()) return {};
          if (words_[timer].isTimer()) link(static_cast<int>(timer), static_cast<int>(clock));
        }
      }
    }
    cutToLimit();
    return {std::move(words_), std::move(templates_), {}};
  }
  void link(int timer, int clock) {
    const CountingWord& x = words_[static_cast<std::size_t>(timer)];
    const CountingWord& y = words_[static_cast<std::size_t>(clock)];
    const Node difference = this->difference(timer, clock);
    const Node value = y.sum.progress();
    const Node negative = graph_.make(Op::Sub, widthOf(value), graph_.constantNode(0, widthOf(value)), value);
    for (const Node guard : linkGuards(x)) {
      for (const std::uint64_t stop : y.stops)
        templates_.push_back({guard, hasReached(y, stop), difference, timer, clock});
      templates_.push_back({guard, noNode, negative});
    }
  }
  /// Of a timer that the encoder names: that it runs, and that its bit is on. Else what decides how the word changes,
  /// and that it has begun.
  std::vector<Node> linkGuards(const CountingWord& x) {
    const auto isLeft = [&](Node n) { return std::ranges::find(guards_, n) != guards_.end(); };  // not merged away
    for (const TimerHint& timer : system_.timers) {
      if (timer.current == word(x.state) && isLeft(timer.bit)) return {isAboveZero(x.state), timer.bit};
      if (timer.rest == word(x.state) && isLeft(timer.bit) && isLeft(timer.running)) return {timer.running, timer.bit};
    }
    std::vector<Node> result = guardsFor({x.state}, schedule::linkGuards);
    result.pop_back();  // without condition
    return result;
  }

  /// What the open questions depend on, in any number of scans. Of constraints those count that may end a run: others,
  /// such as the range of a clock, tell nothing of the rest.
  std::set<std::size_t> tellingStates() const {
    std::unordered_map<std::uint32_t, std::size_t> stateOf;
    for (std::size_t i = 0; i < system_.states.size(); ++i) stateOf.emplace(indexOf(word(i)), i);
    std::vector<Node> roots;
    for (const std::size_t q : blast_.questions()) roots.push_back(system_.questions[q].bad);
    for (const Node constraint : system_.constraints) {
      if (std::ranges::find(system_.totalConstraints, constraint) == system_.totalConstraints.end())
        roots.push_back(constraint);
    }
    std::set<std::size_t> found;
    std::vector<bool> isSeen(graph_.size(), false);
    while (!roots.empty()) {
      const Node n = roots.back();
      roots.pop_back();
      if (n == noNode || isSeen[indexOf(n)]) continue;
      isSeen[indexOf(n)] = true;
      if (graph_[n].op != Op::Variable) {
        roots.insert(roots.end(), graph_[n].child.begin(), graph_[n].child.end());
      } else if (const auto state = stateOf.find(indexOf(n)); state != stateOf.end()) {
        found.insert(state->second);
        roots.push_back(system_.states[state->second].next);
      }
    }
    return found;
  }

  /// A rate without a template has no difference to tell of: nobody makes bits of it.
  void cutToLimit() {
    if (templates_.size() <= schedule::templateLimit) return;
    templates_.resize(schedule::templateLimit);
    std::set<Node> kept;
    for (const BoundTemplate& t : templates_) kept.insert(t.difference);
    std::erase_if(rates_, [&](const Rate& rate) { return !kept.contains(rate.difference); });
  }

  bool isNear() const { return scope_ <= BoundScope::Stops; }
  std::size_t clockGuards() const { return isNear() ? schedule::nearGuards : schedule::guardLimit; }
  Node word(std::size_t state) const { return system_.states[state].node; }
  int widthOf(Node n) const { return graph_[n].width; }

  /// Whether all variables under a node are states, or all are inputs.
  bool dependsOnly(bool onStates, Node root) const {
    const Node roots[] = {root};
    for (const Node n : coneOf(graph_, roots)) {
      if (graph_[n].op == Op::Variable && graph_.variables()[graph_[n].value].isState != onStates) return false;
    }
    return true;
  }
  bool dependsOnStatesOnly(Node root) const { return dependsOnly(true, root); }
  bool dependsOnInputsOnly(Node root) const { return dependsOnly(false, root); }

  /// Sums of the word with something that is no constant, and the constants in its next-state function.
  void collect(std::size_t state) {
    const Node self = word(state);
    if (widthOf(self) < 2 || widthOf(self) > 32) return;
    const Node roots[] = {system_.states[state].next};
    std::optional<CountingWord> found;
    std::set<std::uint64_t> constants;
    std::size_t seen = 0;
    for (const Node n : coneOf(graph_, roots)) {
      if (++seen % schedule::nodesBetweenLooks == 0 && budget_.isExhausted()) return;
      const NodeData& node = graph_[n];
      if (node.op == Op::Constant && node.value > 1 && node.value <= Graph::maskOf(widthOf(self)))
        constants.insert(node.value);
      if (const Node taken = takenAway(node); taken != noNode && leadsTo(node.child[0], self)) {
        if (found && !found->countsDown) return;
        // The last subtraction of a scan: those before it stop the word, which then stands still.
        found = CountingWord{state, {lowPart(node.child[0], self), taken, n}, {}, Op::Zext, true};
        continue;
      }
      if (node.op != Op::Add) continue;
      for (std::size_t side = 0; side < 2; ++side) {
        const Node other = node.child[1 - side];
        if (!isStep(other)) continue;
        // What starts within a scan may be set to any moment of it; the length of the scan is added last.
        if (found && !found->countsDown && lowPart(node.child[side], found->sum.next, true) != noNode) {
          found->sum.increment = together(found->sum.increment, other);
          found->sum.next = n;
          found->isChained = true;
          continue;
        }
        const bool isSet = !carries(node.child[side], self);
        if (isSet && !(leadsTo(node.child[side], self) && dependsOnInputsOnly(other))) continue;
        if (found && (found->countsDown || (!isSet && found->sum.increment != other)))
          return;  // increased in several places
        const Node read = lowPart(node.child[side], self);
        found = CountingWord{state, {read == noNode ? self : read, other, n}, {}, graph_[node.child[side]].op};
      }
    }
    if (!found || !isBlasted(found->sum.increment)) return;
    found->sum.isPending = dependsOnStatesOnly(found->sum.increment);
    if (found->countsDown) constants.clear();  // a bit says whether it runs
    found->stops.assign(constants.begin(), constants.end());
    if (found->stops.size() > schedule::stopLimit)
      found->stops.erase(found->stops.begin() + 1, found->stops.end() - (schedule::stopLimit - 1));
    words_.push_back(std::move(*found));
  }
  /// What two additions in a row add.
  Node together(Node first, Node second) {
    first = withoutExtension(graph_, first);
    second = withoutExtension(graph_, second);
    const int width = std::max(widthOf(first), widthOf(second));
    return graph_.make(Op::Add, width, wide(first, width), wide(second, width));
  }
  /// What something counts by: not the constants of the program, but those that are the length of every scan.
  bool isStep(Node n) const {
    return graph_[n].op != Op::Constant ||
           std::ranges::find(system_.steadySteps, graph_[n].value) != system_.steadySteps.end();
  }
  /// What a node takes away of its first operand, if anything counts by that. A constant is taken away by adding it.
  Node takenAway(const NodeData& node) {
    if (node.op == Op::Sub) return isStep(node.child[1]) ? node.child[1] : noNode;
    if (node.op != Op::Add || graph_[node.child[1]].op != Op::Constant) return noNode;
    const std::uint64_t size = (~graph_[node.child[1]].value + 1) & Graph::maskOf(node.width);
    if (std::ranges::find(system_.steadySteps, size) == system_.steadySteps.end()) return noNode;
    return graph_.constantNode(size, node.width);
  }
  bool isBlasted(Node n) const { return graph_[n].op == Op::Constant || blast_.contains(n); }
  bool isWordOrLowPart(Node n, Node self) const {
    return n == self || (graph_[n].op == Op::Extract && graph_[n].child[0] == self && graph_[n].value == 0);
  }
  /// The word itself, or constants where it is set anew.
  bool carries(Node n, Node self, int depth = 8) const {
    n = withoutExtension(graph_, n);
    if (isWordOrLowPart(n, self)) return true;
    if (graph_[n].op != Op::Ite || depth == 0) return false;
    const auto isArm = [&](std::size_t i) {
      return graph_[graph_[n].child[i]].op == Op::Constant || carries(graph_[n].child[i], self, depth - 1);
    };
    return isArm(1) && isArm(2);
  }

  /// The word itself, or what is chosen between it and anything else.
  bool leadsTo(Node n, Node self) const { return lowPart(n, self) != noNode; }
  /// The word there, or its low part where merging has found its high bits constant; noNode: neither. `isCut`: also
  /// where only the low part of what is chosen is kept, as of a sum that stops at the largest value.
  Node lowPart(Node n, Node self, bool isCut = false) const {
    std::vector<Node> open{n};
    std::set<std::uint32_t> choices;
    while (!open.empty()) {
      const Node at = withoutExtension(graph_, open.back());
      open.pop_back();
      if (isWordOrLowPart(at, self)) return at;
      if (isCut && graph_[at].op == Op::Extract && graph_[at].value == 0) open.push_back(graph_[at].child[0]);
      if (graph_[at].op != Op::Ite || choices.size() == schedule::followedChoices ||
          !choices.insert(indexOf(at)).second)
        continue;
      open.push_back(graph_[at].child[2]);
      open.push_back(graph_[at].child[1]);
    }
    return noNode;
  }

  /// Words by equal increments: those added at once as they come about, pending ones a scan later.
  std::vector<std::vector<std::size_t>> groups(std::size_t most = schedule::incrementGroup) {
    std::vector<std::vector<std::uint64_t>> seen(words_.size());  // by scan, then bit
    SimulationRuns runs(blast_.bits(), seed_);
    int done = 0;
    for (; done < schedule::templateScans && !budget_.isExhausted() && runs.choose(); ++done) {
      for (std::size_t i = 0; i < words_.size(); ++i) {
        const NodeData& increment = graph_[words_[i].sum.increment];
        const LitVector bits = increment.op == Op::Constant ? LitVector{} : blast_.of(words_[i].sum.increment);
        for (std::size_t bit = 0; bit < schedule::comparedBits; ++bit) {
          const bool isSet = increment.op == Op::Constant && (increment.value >> bit & 1U) != 0;
          seen[i].push_back(bit < bits.size() ? runs.simulator().value(bits[bit]) : isSet ? ~0ULL : 0);
        }
      }
      runs.step();
    }
    if (done > 0) {
      for (std::vector<std::uint64_t>& increments : seen) {
        for (std::uint64_t& lanes : increments) lanes &= runs.live();
      }
      takeAsPending(seen);
    }
    std::map<std::vector<std::uint64_t>, std::vector<std::size_t>> byIncrement;
    for (std::size_t i = 0; i < words_.size(); ++i) byIncrement[seen[i]].push_back(i);
    std::vector<std::vector<std::size_t>> result;
    for (auto& [increments, group] : byIncrement) {
      if (group.size() > most) group.resize(most);
      result.push_back(std::move(group));
    }
    return result;
  }

  /// Leaves of what was seen of each word's increment the scans to compare: a pending one is that of the scan before.
  /// What depends on states alone is pending, but where every scan lasts as long, the ticks of this scan depend on
  /// states alone as well: it is added at once if another word adds the same one scan later.
  void takeAsPending(std::vector<std::vector<std::uint64_t>>& seen) {
    std::vector<std::vector<std::uint64_t>> later;
    std::map<std::vector<std::uint64_t>, std::size_t> pending;  // how many
    for (std::size_t i = 0; i < words_.size(); ++i) {
      later.emplace_back(seen[i].begin() + schedule::comparedBits, seen[i].end());
      seen[i].resize(seen[i].size() - schedule::comparedBits);
      if (words_[i].sum.isPending) ++pending[later[i]];
    }
    for (std::size_t i = 0; i < words_.size(); ++i) {
      Summand& sum = words_[i].sum;
      if (!sum.isPending) continue;
      const auto followers = pending.find(seen[i]);
      sum.isPending = followers == pending.end() || seen[i] == later[i];
      if (sum.isPending) seen[i] = std::move(later[i]);
    }
  }

  /// Sums and differences of a group never wrap.
  void toOneWidth(const std::vector<std::size_t>& group) {
    int width = 0;
    for (const std::size_t i : group)
      width =
          std::max({width, widthOf(words_[i].sum.word), widthOf(withoutExtension(graph_, words_[i].sum.increment))});
    width += 2;
    for (const std::size_t i : group) {
      Summand& sum = words_[i].sum;
      const Node own = sum.next;
      sum.word = wide(sum.word, width, words_[i].extension);
      sum.increment = wide(withoutExtension(graph_, sum.increment), width);
      if (words_[i].countsDown) {
        sum.word = graph_.make(Op::Not, width, sum.word);
        sum.next = graph_.make(Op::Add, width, sum.word, sum.increment);
        continue;
      }
      // The program's own adder, so that nobody has to find out that two adders are equal.
      sum.next = sum.isPending || words_[i].isChained || mayWrap(own) || widthOf(own) > width
                     ? graph_.make(Op::Add, width, sum.word, sum.increment)
                     : wide(own, width);
    }
  }

  /// Truth values of the state, one of each class of equal ones.
  void collectGuards() {
    std::set<Lit> taken;
    for (std::uint32_t latch = 0; latch < blast_.bits().latches.size(); ++latch) {
      const std::size_t state = blast_.stateBit(latch).state;
      if (widthOf(word(state)) != 1) continue;
      const Lit own = positive(blast_.bits().latches[latch].variable);
      const Lit same = variableOf(own) < known_.equal.size() ? known_.equal[variableOf(own)] : own;
      if (variableOf(same) == 0 || !taken.insert(same & ~1U).second) continue;
      guards_.push_back(word(state));
    }
  }

  /// How far below the next value of a state a node is: what decides whether a timer runs is near.
  std::size_t depthUnder(std::size_t state, Node n) {
    const auto [entry, isNew] = depths_.try_emplace(state);
    std::unordered_map<std::uint32_t, std::size_t>& depth = entry->second;
    if (isNew) {
      std::vector<Node> level{system_.states[state].next};
      for (std::size_t d = 0; !level.empty(); ++d) {
        std::vector<Node> below;
        for (const Node m : level) {
          if (m == noNode || !depth.emplace(indexOf(m), d).second || graph_[m].op == Op::Variable) continue;
          below.insert(below.end(), graph_[m].child.begin(), graph_[m].child.end());
        }
        level = std::move(below);
      }
    }
    const auto found = depth.find(indexOf(n));
    return found == depth.end() ? graph_.size() : found->second;
  }

  /// Conditions for some words: first those that decide how the words change.
  std::vector<Node> guardsFor(const std::vector<std::size_t>& states, std::size_t most) {
    std::vector<std::pair<std::size_t, Node>> byDepth;
    for (const Node guard : guards_) {
      std::size_t depth = graph_.size();
      for (const std::size_t s : states) depth = std::min(depth, depthUnder(s, guard));
      byDepth.emplace_back(depth, guard);
    }
    std::ranges::stable_sort(byDepth, {}, &std::pair<std::size_t, Node>::first);
    std::vector<Node> result;
    for (const auto& [depth, guard] : byDepth) result.push_back(guard);
    if (result.size() > most) result.resize(most);
    const std::size_t plain = isNear() ? 0 : result.size();
    for (std::size_t i = 0; i < plain; ++i) result.push_back(graph_.make(Op::Not, 1, result[i]));
    for (const std::size_t s : states) result.push_back(isAboveZero(s));
    result.push_back(noNode);
    return result;
  }

  Node isAboveZero(std::size_t state) {
    return graph_.make(Op::Ult, 1, graph_.constantNode(0, widthOf(word(state))), word(state));
  }
  Node wide(Node n, int width, Op extension = Op::Zext) {
    return widthOf(n) == width ? n : graph_.make(extension == Op::Sext ? Op::Sext : Op::Zext, width, n);
  }
  bool mayWrap(Node sum) const {
    const NodeData& node = graph_[sum];
    return graph_.highest(node.child[0]) + graph_.highest(node.child[1]) > Graph::maskOf(node.width);
  }

  /// Clocks against words that count scans.
  void rates() {
    std::vector<RateClock> clocks;
    for (const CountingWord& x : words_) {
      if (!x.isTimer() && !x.isChained) clocks.push_back({x.state, x.sum.increment, x.stops});
    }
    const auto guards = [&](std::size_t clock, std::size_t word) {
      return guardsFor({clock, word}, schedule::fewGuards);
    };
    BoundTemplates found;
    addRates(found, system_, blast_, clocks, order_, guards, budget_);
    templates_.insert(templates_.end(), found.templates.begin(), found.templates.end());
    rates_ = std::move(found.rates);
  }

  void single(const CountingWord& x) {
    const Node value = x.sum.progress();
    const int width = widthOf(value);
    const Node negative = graph_.make(Op::Sub, width, graph_.constantNode(0, width), value);
    for (const Node guard : guardsFor({x.state}, clockGuards())) {
      if (guard == noNode) continue;
      templates_.push_back({guard, noNode, value});
      templates_.push_back({guard, noNode, negative});
      // A timer that has not run out stands at nothing while what starts it is off, even if its own end has put it off.
      for (const std::uint64_t stop : endsOf(x)) templates_.push_back({guard, hasReached(x, stop), x.sum.word});
    }
  }

  /// What a timer's next value is compared with: where its own bit may end what started it.
  void collectEnds() {
    std::vector<Node> roots;
    for (const std::uint32_t state : order_) roots.push_back(system_.states[state].next);
    const std::vector<Node> cone = coneOf(graph_, roots);
    for (const CountingWord& x : words_) {
      if (!x.sum.isPending || x.countsDown) continue;
      std::vector<std::uint64_t>& ends = ends_[x.state];
      for (const Node n : cone) {
        if ((!isOrder(graph_[n].op) && graph_[n].op != Op::Equal) || ends.size() == schedule::stopLimit) continue;
        for (std::size_t side = 0; side < 2; ++side) {
          const NodeData& limit = graph_[graph_[n].child[side]];
          if (limit.op != Op::Constant || limit.value < 2 || !isNextOf(graph_[n].child[1 - side], x)) continue;
          if (std::ranges::find(ends, limit.value) == ends.end()) ends.push_back(limit.value);
        }
      }
    }
  }
  /// The sum, the word, or what is chosen between them and constants.
  bool isNextOf(Node n, const CountingWord& x, int depth = 8) const {
    n = withoutExtension(graph_, n);
    if (n == withoutExtension(graph_, x.sum.next) || n == word(x.state) || n == system_.states[x.state].next)
      return true;
    if (graph_[n].op == Op::Extract) return isNextOf(graph_[n].child[0], x, depth);
    if (graph_[n].op != Op::Ite || depth == 0) return false;
    const auto isArm = [&](std::size_t i) {
      return graph_[graph_[n].child[i]].op == Op::Constant || isNextOf(graph_[n].child[i], x, depth - 1);
    };
    return isArm(1) && isArm(2);
  }
  std::vector<std::uint64_t> endsOf(const CountingWord& x) const {
    const auto found = ends_.find(x.state);
    return found == ends_.end() ? std::vector<std::uint64_t>{} : found->second;
  }
  Node hasReached(const CountingWord& x, std::uint64_t stop) {
    return graph_.make(Op::Ule, 1, graph_.constantNode(stop, widthOf(word(x.state))), word(x.state));
  }

  /// Of two orders of a pair one is the complement of the other, which is its negative less 1: one adder does for both.
  Node difference(int left, int right) {
    if (left > right)
      return graph_.make(Op::Not, widthOf(words_[static_cast<std::size_t>(left)].sum.word), difference(right, left));
    const Summand& x = words_[static_cast<std::size_t>(left)].sum;
    const Summand& y = words_[static_cast<std::size_t>(right)].sum;
    return graph_.make(Op::Sub, widthOf(x.word), x.progress(), y.progress());
  }

  void pair(int left, int right, std::size_t most) {
    const CountingWord& x = words_[static_cast<std::size_t>(left)];
    const CountingWord& y = words_[static_cast<std::size_t>(right)];
    const Node difference = this->difference(left, right);
    for (const Node guard : guardsFor({x.state, y.state}, most)) {
      templates_.push_back({guard, noNode, difference, left, right});
      if (scope_ == BoundScope::Few) continue;
      for (const std::uint64_t stop : y.stops)
        templates_.push_back({guard, hasReached(y, stop), difference, left, right});
      for (const std::uint64_t stop : endsOf(x))
        templates_.push_back({guard, hasReached(x, stop), difference, left, right});
    }
  }

  const TransitionSystem& system_;
  Graph& graph_;
  const BitBlast& blast_;
  const Invariants& known_;
  const std::uint64_t seed_;
  const BoundScope scope_;
  const Budget& budget_;
  std::set<std::uint32_t> inCone_;
  std::vector<std::uint32_t> order_;
  std::vector<CountingWord> words_;
  std::vector<Node> guards_;
  std::map<std::size_t, std::vector<std::uint64_t>> ends_;                        ///< by state
  std::map<std::size_t, std::unordered_map<std::uint32_t, std::size_t>> depths_;  ///< by state, then node
  std::vector<BoundTemplate> templates_;
  std::vector<Rate> rates_;
};

}  // namespace

BoundTemplates boundTemplates(const TransitionSystem& system, const BitBlast& blast, const Invariants& known,
                              std::uint64_t seed, BoundScope scope, const Budget& budget) {
  return TemplateSearch(system, blast, known, seed, scope, budget).run();
}

}  // namespace rungproof
