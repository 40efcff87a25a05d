// The trace is binary DRAT: 'a' or 'd', then each literal as 2 * variable + sign in groups of seven bits, then 0. Only
// clauses that follow are accepted, none that merely keeps the formula satisfiable.
#include "analysis/recheck/refutation.hpp"

#include <array>
#include <cadical.hpp>
#include <chrono>
#include <cstdio>
#include <memory>
#include <utility>

#include "analysis/recheck/rup_checker.hpp"
#include "analysis/schedule/schedule.hpp"
#include "engine/platform/memory_stream.hpp"
#include "ir/check.hpp"

namespace rungproof {

namespace {

class RefutationEnd final : public CaDiCaL::Terminator {
 public:
  explicit RefutationEnd(const RefutationLimits& limits)
      : end_(Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(limits.seconds))),
        cancel_(limits.cancel) {}
  bool terminate() override {
    return Clock::now() >= end_ || (cancel_ != nullptr && cancel_->load(std::memory_order_relaxed));
  }

 private:
  using Clock = std::chrono::steady_clock;
  const Clock::time_point end_;
  const std::atomic<bool>* cancel_;
};

/// Follows the trace; false where a step does not hold, or the time is over.
bool follow(std::span<const unsigned char> trace, int variables, RupChecker& checker, RefutationEnd& end) {
  std::vector<int> clause;
  std::size_t steps = 0;
  for (std::size_t at = 0; at < trace.size() && !checker.isRefuted();) {
    const unsigned char kind = trace[at++];
    if (kind != 'a' && kind != 'd') return false;
    clause.clear();
    for (bool isOpen = true; isOpen;) {
      std::uint64_t number = 0;
      bool goesOn = true;
      for (unsigned shift = 0; goesOn; shift += 7) {
        if (at == trace.size() || shift > 28) return false;
        number |= static_cast<std::uint64_t>(trace[at] & 0x7FU) << shift;
        goesOn = (trace[at++] & 0x80U) != 0;
      }
      isOpen = number != 0;
      if (!isOpen) break;
      if (number / 2 == 0 || number / 2 > static_cast<std::uint64_t>(variables)) return false;
      const int v = static_cast<int>(number / 2);
      clause.push_back((number & 1U) != 0 ? -v : v);
    }
    if (++steps % schedule::stepsBetweenLooks == 0 && end.terminate()) return false;
    if (kind == 'd')
      checker.forget(clause);
    else if (!checker.derive(clause))
      return false;
  }
  return true;
}

/// `trace`: what the solver writes, for as long as it lives.
CheckResult refuteWith(CaDiCaL::Solver& solver, const MemoryStream& trace, const GateClauses::Clauses& clauses,
                       RupChecker& checker, RefutationEnd& end) {
  solver.set("quiet", 1);
  solver.set("lucky", 0);
  for (const char* technique : {"walk", "probe", "elim", "subsume", "vivify", "ternary", "transred", "decompose",
                                "condition", "cover", "block", "rephase", "compact", "stabilize", "shrink", "profile"})
    CHECK(solver.set(technique, 0), "CaDiCaL knows the option");
  CHECK(solver.trace_proof(trace.file(), "memory"), "CaDiCaL writes a trace");
  for (const int l : clauses.literals) solver.add(l);
  solver.connect_terminator(&end);
  std::size_t followed = 0;
  const auto goesOn = [&] {
    const std::span<const unsigned char> whole = trace.bytes();
    return follow(whole.subspan(std::exchange(followed, whole.size())), clauses.variables, checker, end);
  };
  for (const int l : clauses.guide) {
    solver.assume(-l);
    if (solver.solve() != 20) continue;
    if (!goesOn()) return CheckResult::Unknown;
    if (checker.isRefuted()) return CheckResult::Valid;
    if (!checker.derive(std::array{l})) continue;
    solver.add(l);
    solver.add(0);
  }
  const int result = solver.solve();
  solver.disconnect_terminator();
  solver.close_proof_trace();
  if (result == 10) return CheckResult::Invalid;
  if (result != 20 || !goesOn() || !checker.isRefuted()) return CheckResult::Unknown;
  return CheckResult::Valid;
}

}  // namespace

CheckResult refute(const GateClauses::Clauses& clauses, const RefutationLimits& limits) {
  RupChecker checker(clauses.variables);
  for (std::size_t begin = 0, end = 0; end < clauses.literals.size() && !checker.isRefuted(); begin = ++end) {
    while (clauses.literals[end] != 0) ++end;
    checker.add(std::span(clauses.literals).subspan(begin, end - begin));
  }
  if (checker.isRefuted()) return CheckResult::Valid;
  RefutationEnd end(limits);
  if (end.terminate()) return CheckResult::Unknown;
  const MemoryStream trace;
  auto solver = std::make_unique<CaDiCaL::Solver>();
  try {
    return refuteWith(*solver, trace, clauses, checker, end);
  } catch (...) {
    static_cast<void>(solver.release());  // memory ended: it is half changed, and cannot be taken down
    throw;
  }
}

}  // namespace rungproof
