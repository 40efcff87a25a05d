// A fixpoint from below: bounds hold initially, and every scan from a state that satisfies all of them ends in one that
// does; a scan that breaks a bound raises it, to the largest value that such a scan reaches.
#include "analysis/portfolio/invariants_bounds.hpp"

#include <algorithm>
#include <limits>
#include <unordered_map>

#include "analysis/bits/bit_arithmetic.hpp"
#include "analysis/bits/bit_unrolling.hpp"
#include "analysis/bits/simulation_runs.hpp"
#include "analysis/portfolio/bound_templates.hpp"
#include "analysis/schedule/schedule.hpp"

namespace rungproof {

namespace {

constexpr std::int64_t unreached = std::numeric_limits<std::int64_t>::min();

enum class Course : std::uint8_t { NotAsked, Falls, Grows };

struct Bound {
  Lit guard = trueLit, stopped = falseLit;
  std::size_t difference = 0;  ///< index in differences_
  std::int64_t high = unreached;
  int raises = 0;
  Course course = Course::NotAsked;
  bool isDropped = false;
};

class BoundSearch {
 public:
  BoundSearch(const TransitionSystem& system, BitBlast& blast, const Invariants& known, std::uint64_t seed,
              BoundScope scope, const Budget& budget)
      : system_(system),
        graph_(*system.graph),
        blast_(blast),
        known_(known),
        seed_(seed),
        scope_(scope),
        budget_(budget),
        found_(boundTemplates(system, blast, known, seed, scope, budget)),
        templates_(found_.templates) {}

  MinedBounds run(const std::vector<BoundTemplate>& tried) {
    MinedBounds mined{templates_, false, {}, {}};
    if (templates_.empty() || templates_ == tried) return mined;
    prepare();
    sample();
    if (!holdInitially() || !makeInductive()) {
      mined.isUnfinished = budget_.isExhausted();
      return mined;
    }
    mined.clauses = result();
    for (const Pair& pair : pairs_) {
      if (graph_[pair.node].op == Op::Sub)
        mined.differences.push_back({summand(pair.left), summand(pair.right), pair.node});
    }
    return mined;
  }

 private:
  void prepare() {
    std::vector<Node> nodes;
    for (const BoundTemplate& t : templates_) {
      for (const Node n : {t.guard, t.stopped, t.difference}) {
        if (n != noNode) nodes.push_back(n);
      }
    }
    for (const CountingWord& word : found_.words) {
      if (word.sum.next == noNode) continue;  // of no group
      for (const Node n : {word.sum.word, word.sum.increment, word.sum.next}) nodes.push_back(n);
    }
    for (const Rate& rate : found_.rates) nodes.insert(nodes.end(), {rate.clock, rate.increment, rate.word});
    blast_.add(nodes);
    std::unordered_map<std::uint32_t, std::size_t> index;
    for (const BoundTemplate& t : templates_) {
      Bound bound;
      if (t.guard != noNode) bound.guard = blast_.of(t.guard)[0];
      if (t.stopped != noNode) bound.stopped = blast_.of(t.stopped)[0];
      const auto [at, isNew] = index.emplace(indexOf(t.difference), differences_.size());
      if (isNew) {
        differences_.push_back(blast_.of(t.difference));
        if (t.left >= 0) pairs_.push_back({t.difference, at->second, t.left, t.right});
      }
      bound.difference = at->second;
      bounds_.push_back(bound);
    }
  }

  static std::int64_t signedValue(std::uint64_t value, std::size_t width) {
    const std::uint64_t sign = 1ULL << (width - 1);
    return static_cast<std::int64_t>(value ^ sign) - static_cast<std::int64_t>(sign);
  }

  const Summand& summand(int word) const { return found_.words[static_cast<std::size_t>(word)].sum; }

  void raise(Bound& bound, std::int64_t value) {
    if (value > bound.high) bound.high = value;
  }

  /// Words of ms are wider than those that count ticks.
  bool isHopeless(const Bound& bound) const {
    const auto range = static_cast<int>(differences_[bound.difference].size()) - schedule::hopelessBits;
    return bound.high > std::max(schedule::hopelessBound, std::int64_t{1} << std::max(range, 0));
  }

  void sample() {
    SimulationRuns runs(blast_.bits(), seed_);
    std::vector<std::array<std::int64_t, 64>> values(differences_.size());
    for (int scan = 0; scan < schedule::boundScans && !budget_.isExhausted() && runs.choose(); ++scan) {
      const BitSimulator& simulator = runs.simulator();
      for (std::size_t d = 0; d < differences_.size(); ++d) {
        const LitVector& bits = differences_[d];
        std::array<std::uint64_t, 64> raw{};
        for (std::size_t bit = 0; bit < bits.size(); ++bit) {
          const std::uint64_t lanes = simulator.value(bits[bit]);
          for (std::size_t lane = 0; lane < 64; ++lane) raw[lane] |= (lanes >> lane & 1U) << bit;
        }
        for (std::size_t lane = 0; lane < 64; ++lane) values[d][lane] = signedValue(raw[lane], bits.size());
      }
      for (Bound& bound : bounds_) {
        std::uint64_t lanes = runs.live() & simulator.value(bound.guard) & ~simulator.value(bound.stopped);
        for (; lanes != 0; lanes &= lanes - 1)
          raise(bound, values[bound.difference][static_cast<std::size_t>(std::countr_zero(lanes))]);
      }
      runs.step();
    }
    for (Bound& bound : bounds_) bound.isDropped = isHopeless(bound);
  }

  /// difference <= high, in a frame of an unrolling.
  Lit atMost(Unrolling& u, int frame, const LitVector& difference, std::int64_t high) const {
    const std::size_t width = difference.size();
    const std::uint64_t sign = 1ULL << (width - 1),
                        limit = static_cast<std::uint64_t>(high + static_cast<std::int64_t>(sign));
    Lit result = trueLit;  // of the bits below
    for (std::size_t bit = 0; bit < width; ++bit) {
      Lit l = u.at(frame, difference[bit]);
      if (bit + 1 == width) l = negate(l);
      result = (limit >> bit & 1U) != 0 ? u.graph().addOr(negate(l), result) : u.graph().addAnd(negate(l), result);
    }
    return result;
  }
  Lit isActive(Unrolling& u, int frame, const Bound& bound) const {
    return u.graph().addAnd(u.at(frame, bound.guard), negate(u.at(frame, bound.stopped)));
  }
  Lit holds(Unrolling& u, int frame, const Bound& bound) const {
    const Lit idle = negate(isActive(u, frame, bound));
    return bound.high == unreached
               ? idle
               : u.graph().addOr(idle, atMost(u, frame, differences_[bound.difference], bound.high));
  }
  std::int64_t valueOf(Unrolling& u, const BitCnf& cnf, int frame, const Bound& bound) const {
    const LitVector& bits = differences_[bound.difference];
    std::uint64_t value = 0;
    for (std::size_t bit = 0; bit < bits.size(); ++bit)
      value |= static_cast<std::uint64_t>(isTrue(cnf, u.at(frame, bits[bit]))) << bit;
    return signedValue(value, bits.size());
  }
  static bool isTrue(const BitCnf& cnf, Lit l) { return l == trueLit || (l != falseLit && cnf.value(l)); }

  bool holdInitially() {
    Unrolling start(blast_.bits(), Unrolling::Start::Initial);
    Sat sat(Sat::Use::Many);
    BitCnf cnf(start.graph(), sat);
    for (;;) {
      std::vector<int> broken;
      bool isBroken = false;
      for (Bound& bound : bounds_) {
        if (bound.isDropped) continue;
        const Lit l = holds(start, 0, bound);
        isBroken = isBroken || l != trueLit;
        if (l != trueLit) broken.push_back(-cnf.literal(l));
      }
      if (!isBroken) return true;
      const Sat::Outcome outcome = sat.solve({}, budget_, broken);
      if (outcome != Sat::Outcome::Satisfiable) return outcome == Sat::Outcome::Unsatisfiable;
      for (Bound& bound : bounds_) {
        if (bound.isDropped || isTrue(cnf, holds(start, 0, bound))) continue;
        raise(bound, valueOf(start, cnf, 0, bound));
      }
    }
  }

  bool makeInductive() {
    Unrolling steps(blast_.bits(), Unrolling::Start::Any);
    Sat sat(Sat::Use::Many);
    BitCnf cnf(steps.graph(), sat);
    for (const Lit constraint : blast_.bits().constraints) sat.add({cnf.literal(steps.at(0, constraint))});
    for (const std::vector<Lit>& clause : known_.clauses) {
      std::vector<int> literals;
      for (const Lit l : clause) literals.push_back(cnf.literal(steps.at(0, l)));
      sat.add(literals);
    }
    tellArithmetic(steps, sat, cnf);
    for (const Rate& rate : found_.rates) tellRate(rate, steps, sat, cnf);
    for (const Bound& bound : bounds_) {
      for (const Lit l : differences_[bound.difference]) cnf.literal(steps.at(1, l));
    }
    for (;;) {
      std::vector<int> assumed, broken;
      for (Bound& bound : bounds_) {
        if (bound.isDropped) continue;
        const Lit before = holds(steps, 0, bound), after = holds(steps, 1, bound);
        if (before != trueLit) assumed.push_back(cnf.literal(before));
        if (after == trueLit) continue;
        broken.push_back(-cnf.literal(after));
        sat.prefer(broken.back());  // one counterexample should raise many
      }
      if (broken.empty()) return true;
      const Sat::Outcome outcome = sat.solve(assumed, budget_, broken);
      if (outcome != Sat::Outcome::Satisfiable) return outcome == Sat::Outcome::Unsatisfiable;
      std::vector<Bound*> raised;
      const auto take = [&] {
        for (Bound& bound : bounds_) {
          if (bound.isDropped || isTrue(cnf, negate(isActive(steps, 1, bound)))) continue;
          const std::int64_t value = valueOf(steps, cnf, 1, bound);
          if (value <= bound.high) continue;
          if (bound.course == Course::NotAsked && isTrue(cnf, isActive(steps, 0, bound)) &&
              value > valueOf(steps, cnf, 0, bound))
            bound.course = Course::Grows;
          raise(bound, value);
          if (std::find(raised.begin(), raised.end(), &bound) == raised.end()) raised.push_back(&bound);
        }
      };
      take();
      if (raised.empty()) return false;
      for (std::size_t i = 0; i < raised.size(); ++i) {
        Bound& bound = *raised[i];
        if (bound.course == Course::NotAsked && !askCourse(steps, sat, cnf, bound)) return false;
        if (bound.course == Course::Grows && scope_ != BoundScope::Chain) {
          bound.isDropped = ++bound.raises > schedule::growthPatience;
        } else if (!maximise(steps, sat, cnf, bound, assumed, take)) {
          return false;
        }
      }
    }
  }

  /// Raises the bound to the largest value that a scan reaches under the assumptions; false when the budget ends.
  template <class Take>
  bool maximise(Unrolling& steps, Sat& sat, BitCnf& cnf, Bound& bound, std::vector<int>& assumed, Take&& take) {
    const LitVector& difference = differences_[bound.difference];
    const std::int64_t widest = (1LL << (difference.size() - 1)) - 1;
    assumed.push_back(cnf.literal(isActive(steps, 1, bound)));
    bool isNarrowing = false;
    for (std::int64_t step = 1; step > 0 && !isHopeless(bound);) {
      Sat::Outcome more = Sat::Outcome::Unsatisfiable;
      if (bound.high + step <= widest) {
        assumed.push_back(-cnf.literal(atMost(steps, 1, difference, bound.high + step - 1)));
        more = sat.solve(assumed, budget_);
        assumed.pop_back();
      }
      if (more == Sat::Outcome::Unknown) return false;
      if (more == Sat::Outcome::Satisfiable)
        take();
      else
        isNarrowing = true;
      step = isNarrowing ? step / 2 : step * 2;
    }
    assumed.pop_back();
    bound.isDropped = isHopeless(bound) || ++bound.raises > schedule::raisesAllowed;
    return true;
  }

  /// (x + i) - (y + i) = x - y: said once for every pair of words, so that the solver need not find it out from adders.
  /// And where x falls behind or y runs ahead, the difference does not grow; that is true of numbers, so it is said
  /// only of words so small that nothing wraps around.
  void tellArithmetic(Unrolling& steps, Sat& sat, BitCnf& cnf) {
    BitArithmetic arithmetic(steps.graph());
    const auto at = [&](int frame, Node n) {
      LitVector bits;
      for (const Lit l : blast_.of(n)) bits.push_back(steps.at(frame, l));
      return bits;
    };
    const auto atMost = [&](const LitVector& a, const LitVector& b) { return negate(arithmetic.lessSigned(b, a)); };
    // Between -2^(w - n) and 2^(w - n), w the width: the highest n bits are equal.
    const auto fits = [&](const LitVector& word, std::size_t n) {
      Lit result = trueLit;
      for (std::size_t i = 1; i < std::min(n, word.size()); ++i)
        result = steps.graph().addAnd(result,
                                      negate(steps.graph().addXor(word[word.size() - i], word[word.size() - i - 1])));
      return result;
    };
    for (const Pair& pair : pairs_) {
      const Summand& x = summand(pair.left);
      const Summand& y = summand(pair.right);
      const Lit same = arithmetic.equal(at(x.isPending ? 1 : 0, x.increment), at(y.isPending ? 1 : 0, y.increment));
      const LitVector xAfter = at(1, x.word), yAfter = at(1, y.word), xNext = at(0, x.next), yNext = at(0, y.next);
      const Lit together = steps.graph().addAnd(
          same, steps.graph().addAnd(arithmetic.equal(xAfter, xNext), arithmetic.equal(yAfter, yNext)));
      Lit falls = steps.graph().addAnd(same, steps.graph().addAnd(atMost(xAfter, xNext), atMost(yNext, yAfter)));
      for (const LitVector* word : {&xAfter, &yAfter, &xNext, &yNext})
        falls = steps.graph().addAnd(falls, fits(*word, 3));
      LitVector start, end;
      for (const Lit l : differences_[pair.difference]) {
        start.push_back(steps.at(0, l));
        end.push_back(steps.at(1, l));
      }
      falls = steps.graph().addAnd(falls, steps.graph().addAnd(fits(start, 2), fits(end, 2)));
      sat.add({-cnf.literal(falls), -cnf.literal(arithmetic.lessSigned(start, end))});
      for (const Lit l : differences_[pair.difference]) {
        const int before = cnf.literal(steps.at(0, l)), after = cnf.literal(steps.at(1, l)),
                  condition = cnf.literal(together);
        sat.add({-condition, -before, after});
        sat.add({-condition, before, -after});
      }
    }
  }

  /// Where the clock grows by no more than its increment and the word goes on by no less than its amount, the clock is
  /// no further ahead of the word than before; and the reverse. Multiples show that only bit by bit.
  void tellRate(const Rate& rate, Unrolling& steps, Sat& sat, BitCnf& cnf) {
    BitArithmetic arithmetic(steps.graph());
    const auto at = [&](int frame, Node n, std::size_t width, bool isSigned) {
      LitVector bits;
      for (const Lit l : blast_.of(n)) bits.push_back(steps.at(frame, l));
      const Lit sign = isSigned ? bits.back() : falseLit;
      bits.resize(width, sign);
      return bits;
    };
    const auto atMost = [&](const LitVector& a, const LitVector& b) { return negate(arithmetic.lessSigned(b, a)); };
    const std::size_t timeWidth = std::max(blast_.of(rate.clock).size(), blast_.of(rate.increment).size()) + 2;
    const LitVector timeAfter = at(1, rate.clock, timeWidth, false);
    const LitVector timeNext =
        arithmetic.add(at(0, rate.clock, timeWidth, false), at(0, rate.increment, timeWidth, false));
    const std::size_t wordWidth = blast_.of(rate.word).size() + 2;
    const auto amount = BitArithmetic::constant(rate.amount, static_cast<int>(wordWidth));
    const LitVector before = at(0, rate.word, wordWidth, rate.isSigned);
    const LitVector after = at(1, rate.word, wordWidth, rate.isSigned);
    const LitVector next = rate.isDown ? arithmetic.subtract(before, amount) : arithmetic.add(before, amount);
    const Lit isTimeSo = rate.isBehind ? atMost(timeNext, timeAfter) : atMost(timeAfter, timeNext);
    const Lit isWaySo = rate.isBehind == rate.isDown ? atMost(next, after) : atMost(after, next);
    const std::size_t width = blast_.of(rate.difference).size();
    const Lit grows = arithmetic.lessSigned(at(0, rate.difference, width, true), at(1, rate.difference, width, true));
    sat.add({-cnf.literal(isTimeSo), -cnf.literal(isWaySo), -cnf.literal(grows)});
  }

  /// Can a scan increase the difference while the condition stays? Then a counterexample raises it again and again.
  bool askCourse(Unrolling& steps, Sat& sat, BitCnf& cnf, Bound& bound) {
    const LitVector& bits = differences_[bound.difference];
    Lit grows = falseLit;  // as a comparison of signed words, lowest bit first
    for (std::size_t bit = 0; bit < bits.size(); ++bit) {
      Lit before = steps.at(0, bits[bit]), after = steps.at(1, bits[bit]);
      if (bit + 1 == bits.size()) std::swap(before, after);
      grows = steps.graph().addIte(steps.graph().addXor(before, after), after, grows);
    }
    const Lit both = steps.graph().addAnd(isActive(steps, 0, bound), isActive(steps, 1, bound));
    const Sat::Outcome outcome = sat.solve({cnf.literal(both), cnf.literal(grows)}, budget_);
    bound.course = outcome == Sat::Outcome::Satisfiable ? Course::Grows : Course::Falls;
    return outcome != Sat::Outcome::Unknown;
  }

  /// Bounds that say more than others on the same difference.
  std::vector<Node> result() {
    std::vector<Node> clauses;
    for (std::size_t i = 0; i < bounds_.size(); ++i) {
      const Bound& bound = bounds_[i];
      if (bound.isDropped) continue;
      const bool isImplied = std::any_of(bounds_.begin(), bounds_.end(), [&](const Bound& other) {
        if (other.isDropped || &other == &bound || other.difference != bound.difference || other.high > bound.high)
          return false;
        const bool covers = (other.guard == trueLit || other.guard == bound.guard) &&
                            (other.stopped == falseLit || other.stopped == bound.stopped);
        const bool isSame = other.guard == bound.guard && other.stopped == bound.stopped && other.high == bound.high;
        return covers && (!isSame || &other < &bound);
      });
      if (isImplied) continue;
      const BoundTemplate& t = templates_[i];
      Node clause = graph_.constantNode(0, 1);
      const int width = graph_[t.difference].width;
      if (bound.high != unreached)
        clause = graph_.make(Op::Sle, 1, t.difference,
                             graph_.constantNode(static_cast<std::uint64_t>(bound.high) & Graph::maskOf(width), width));
      if (t.guard != noNode) clause = graph_.make(Op::Or, 1, clause, graph_.make(Op::Not, 1, t.guard));
      if (t.stopped != noNode) clause = graph_.make(Op::Or, 1, clause, t.stopped);
      if (graph_[clause].op != Op::Constant) clauses.push_back(clause);
    }
    return clauses;
  }

  const TransitionSystem& system_;
  Graph& graph_;
  BitBlast& blast_;
  const Invariants& known_;
  const std::uint64_t seed_;
  const BoundScope scope_;
  const Budget& budget_;
  const BoundTemplates found_;
  const std::vector<BoundTemplate>& templates_;
  std::vector<LitVector> differences_;
  struct Pair {
    Node node;
    std::size_t difference;
    int left, right;
  };
  std::vector<Pair> pairs_;  ///< differences of two words
  std::vector<Bound> bounds_;
};

}  // namespace

MinedBounds mineBounds(const TransitionSystem& system, BitBlast& blast, const Invariants& known, std::uint64_t seed,
                       BoundScope scope, const Budget& budget, const std::vector<BoundTemplate>& tried) {
  return BoundSearch(system, blast, known, seed, scope, budget).run(tried);
}

}  // namespace rungproof
