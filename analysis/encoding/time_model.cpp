// Digits of time as state and inputs.
#include "analysis/encoding/time_model.hpp"

#include <bit>

#include "ir/check.hpp"

namespace rungproof {

TimeModel::TimeModel(Graph& graph, const TimeRange& range)
    : graph_(graph),
      low_(range.low),
      high_(range.relaxed ? std::max(range.high, relaxedHigh) : range.high),
      relaxed_(range.relaxed),
      // dt as computed from digits lies in -99 .. high + 198 and must not wrap into the range
      width_(std::bit_width(range.hasBases ? high_ + 198 : high_)) {
  CHECK(range.low >= 1 && range.low <= range.high && range.high <= 65535, "scan time range");
  if (!range.hasBases)
    plain();
  else if (low_ == high_)
    fixed(low_);
  else
    free();
}

Node TimeModel::state(const char* name, int width, Node next) {
  const Node node = graph_.variable(name, width, true);
  states_.push_back({node, number(0, width), next});
  return node;
}

/// The digit that a state of four bits means, which starts anywhere; its next value is set later.
Node TimeModel::digit(const char* name) {
  const Node raw = graph_.variable(name, 4, true);
  states_.push_back({raw, noNode, noNode});
  const Node isOver = graph_.make(Op::Ule, 1, number(10, 4), raw);
  return graph_.make(Op::Ite, 4, isOver, graph_.make(Op::Sub, 4, raw, number(10, 4)), raw);
}

void TimeModel::plain() {
  ten_ = one_ = tensNow_ = onesNow_ = number(0, 4);
  dt_ = number(low_, width_);
  if (low_ == high_) return;
  dt_ = graph_.variable("time.ms", width_, false);
  inputs_ = {dt_};
  constraint_ = graph_.make(Op::And, 1, graph_.make(Op::Ule, 1, dt_, number(high_, width_)),
                            graph_.make(Op::Ule, 1, number(low_, width_), dt_));
}

void TimeModel::free() {
  const std::uint32_t most = (high_ + 99) / 100;
  const int w = width_;
  const auto wide = [&](Node n) { return graph_.make(Op::Zext, w, n); };
  const auto times = [&](Node n, std::uint64_t k) { return graph_.make(Op::Mul, w, n, number(k, w)); };
  const auto add = [&](Node a, Node b) { return graph_.make(Op::Add, w, a, b); };
  const auto sub = [&](Node a, Node b) { return graph_.make(Op::Sub, w, a, b); };
  const Node n = graph_.variable("time.hundreds", std::bit_width(most), false);
  const Node d = graph_.variable("time.tens", 4, false);
  const Node u = graph_.variable("time.ones", 4, false);
  inputs_ = {n, d, u};
  hundredsNow_ = n;
  tensNow_ = d;
  onesNow_ = u;
  ten_ = digit("time.tens.start");
  states_.back().next = d;
  one_ = digit("time.ones.start");
  states_.back().next = u;
  const auto signedDigit = [&](Node n) { return graph_.make(Op::Zext, 5, n); };
  step_ = state("time.tens.step", 5, graph_.make(Op::Sub, 5, signedDigit(d), signedDigit(ten_)));
  hundreds_ = state("time.hundreds.start", std::bit_width(most), n);
  dt_ = add(add(times(wide(n), 100), times(sub(wide(d), wide(ten_)), 10)), sub(wide(u), wide(one_)));
  const auto atMost = [&](Node a, std::uint64_t limit) {
    return graph_.make(Op::Ule, 1, a, number(limit, graph_[a].width));
  };
  const auto both = [&](Node a, Node b) { return graph_.make(Op::And, 1, a, b); };
  const Node digits = both(both(atMost(d, 9), atMost(u, 9)), atMost(n, most));
  const Node range = both(atMost(dt_, high_), graph_.make(Op::Ule, 1, number(low_, w), dt_));
  constraint_ = both(digits, range);
}

/// A scan of fixed length adds its digits with carries; nothing is free.
void TimeModel::fixed(std::uint32_t length) {
  dt_ = number(length, width_);
  const std::uint32_t most = length / 100 + 1;
  const int w = std::bit_width(most);
  // Where a digit never carries, its start tells nothing.
  const bool tensMove = length % 100 != 0, onesMove = length % 10 != 0;
  ten_ = tensMove ? digit("time.tens.start") : number(0, 4);
  one_ = onesMove ? digit("time.ones.start") : number(0, 4);
  struct Digit {
    Node value, carry;
  };
  const auto add = [&](Node digit, std::uint64_t amount, Node carryIn) -> Digit {
    const Node sum =
        graph_.make(Op::Add, 5, graph_.make(Op::Add, 5, graph_.make(Op::Zext, 5, digit), number(amount, 5)),
                    graph_.make(Op::Zext, 5, carryIn));
    const Node carry = graph_.make(Op::Ule, 1, number(10, 5), sum);
    const Node kept = graph_.make(Op::Ite, 5, carry, graph_.make(Op::Sub, 5, sum, number(10, 5)), sum);
    return {graph_.make(Op::Extract, 4, kept), carry};
  };
  const Digit one = add(one_, length % 10, number(0, 1));
  const Digit ten = add(ten_, length / 10 % 10, one.carry);
  if (tensMove) states_.front().next = ten.value;
  if (onesMove) states_.back().next = one.value;
  const auto signedDigit = [&](Node n) { return graph_.make(Op::Zext, 5, n); };
  step_ = state("time.tens.step", 5, graph_.make(Op::Sub, 5, signedDigit(ten.value), signedDigit(ten_)));
  hundredsNow_ = graph_.make(Op::Add, w, number(length / 100, w), graph_.make(Op::Zext, w, ten.carry));
  hundreds_ = state("time.hundreds.start", w, hundredsNow_);
  tensNow_ = ten.value;
  onesNow_ = one.value;
}

std::vector<std::uint64_t> TimeModel::steadySteps() const {
  std::vector<std::uint64_t> steps;
  if (low_ != high_) return steps;
  for (const std::uint32_t base : {1U, 10U, 100U}) {
    if (low_ % base == 0) steps.push_back(low_ / base);
  }
  return steps;
}

Node TimeModel::saturated(Node value, int width) {
  const int w = graph_[value].width;
  if (w == width) return value;
  if (w < width) return graph_.make(Op::Zext, width, value);
  const Node most = number(Graph::maskOf(width), w);
  const Node cut = graph_.make(Op::Ite, w, graph_.make(Op::Ult, 1, most, value), most, value);
  return graph_.make(Op::Extract, width, cut);
}

/// Never negative: the tens digit can fall only by as much as the hundreds have grown.
Node TimeModel::ticksWithin(int base) {
  if (base == 1) return dt_;
  CHECK(hundredsNow_ != noNode, "ticks of a base that nobody counts in");
  if (base == 100) return hundredsNow_;
  const int w = graph_[hundredsNow_].width + 4;
  const auto wide = [&](Node n) { return graph_.make(Op::Zext, w, n); };
  const Node tens = graph_.make(Op::Mul, w, wide(hundredsNow_), number(10, w));
  return graph_.make(Op::Add, w, tens, graph_.make(Op::Sub, w, wide(tensNow_), wide(ten_)));
}

Node TimeModel::ticks100() {
  CHECK(hundreds_ != noNode, "ticks of a base that nobody counts in");
  return saturated16(hundreds_);
}

Node TimeModel::ticks10() {
  CHECK(hundreds_ != noNode, "ticks of a base that nobody counts in");
  const int w = std::max(16, graph_[hundreds_].width + 4);
  const auto wide = [&](Node n) { return graph_.make(Op::Zext, w, n); };
  const Node tens = graph_.make(Op::Mul, w, wide(hundreds_), number(10, w));
  return saturated16(graph_.make(Op::Add, w, tens, graph_.make(Op::Sext, w, step_)));
}

}  // namespace rungproof
