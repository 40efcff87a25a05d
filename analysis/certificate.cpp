// Obligations of a certificate as text, and their check by Z3's own reader and solver.
#include "analysis/certificate.hpp"

#include <fmt/format.h>
#include <z3++.h>

#include <algorithm>
#include <chrono>

#include "analysis/smt_text.hpp"

namespace rungproof {

namespace {

/// Not all of the invariant holds.
void denyInvariant(SmtText& smt, const std::vector<Node>& invariant, int frame) {
  std::string line = "(assert (not (and true true";
  for (const Node n : invariant) line += " " + smt.truth(n, frame);
  smt.add(line + ")))\n");
}

Obligation initiation(const TransitionSystem& system, const WordCertificate& certificate) {
  SmtText smt(system);
  smt.assertInitial(smt.statesUnder(certificate.invariant));
  denyInvariant(smt, certificate.invariant, 0);
  return {"initiation", smt.text()};
}

Obligation consecution(const TransitionSystem& system, const WordCertificate& certificate) {
  SmtText smt(system);
  for (const Node n : certificate.invariant) smt.assertTrue(n, 0);
  for (const Node n : system.constraints) smt.assertTrue(n, 0);
  denyInvariant(smt, certificate.invariant, 1);
  return {"consecution", smt.text()};
}

/// k good scans of states in the invariant, then a bad one; k = 0: one bad scan.
Obligation step(const TransitionSystem& system, const Question& question, const WordCertificate& certificate) {
  SmtText smt(system);
  for (int frame = 0; frame <= certificate.k; ++frame) {
    for (const Node n : certificate.invariant) smt.assertTrue(n, frame);
    for (const Node n : system.constraints) smt.assertTrue(n, frame);
    if (frame < certificate.k) smt.assertFalse(question.bad, frame);
  }
  smt.assertTrue(question.bad, certificate.k);
  for (int later = 1; certificate.simplePath && later <= certificate.k; ++later) {
    for (int earlier = 0; earlier < later; ++earlier) {
      std::string line = "(assert (or false false";
      for (const Node n : certificate.pathBits) line += fmt::format(" (xor {} {})", smt.truth(n, earlier), smt.truth(n, later));
      smt.add(line + "))\n");
    }
  }
  return {"safety", smt.text()};
}

/// Some of the first k scans from an initial state is bad.
Obligation base(const TransitionSystem& system, const Question& question, const WordCertificate& certificate) {
  SmtText smt(system);
  std::vector<Node> roots = system.constraints;
  roots.push_back(question.bad);
  // A bad scan needs the constraints of the scans up to it only; each scan gets its own disjunct.
  std::string line = "(assert (or false false";
  std::string legal = "true";
  for (int frame = 0; frame < certificate.k; ++frame) {
    for (const Node n : system.constraints) legal += " " + smt.truth(n, frame);
    line += fmt::format(" (and {} {})", smt.truth(question.bad, frame), legal);
  }
  // Only variables that the unrolling reached matter; the others would be declared for nothing.
  std::unordered_set<std::uint32_t> reached;
  std::unordered_set<std::uint32_t> frontier = smt.statesUnder(roots);
  for (int frame = 0; frame < certificate.k && !frontier.empty(); ++frame) {
    std::vector<Node> next;
    for (const StateVariable& state : system.states) {
      if (frontier.contains(indexOf(state.node)) && reached.insert(indexOf(state.node)).second) next.push_back(state.next);
    }
    frontier = smt.statesUnder(next);
  }
  reached.insert(frontier.begin(), frontier.end());
  smt.assertInitial(reached);
  smt.add(line + "))\n");
  return {"base", smt.text()};
}

CheckResult check(const std::string& text, double seconds) {
  if (seconds <= 0) return CheckResult::Unknown;
  try {
    z3::context context;
    z3::solver solver(context, "QF_BV");
    solver.set("timeout", static_cast<unsigned>(std::max(1.0, seconds * 1000)));
    solver.from_string(text.c_str());
    switch (solver.check()) {
      case z3::unsat: return CheckResult::Valid;
      case z3::sat: return CheckResult::Invalid;
      default: return CheckResult::Unknown;
    }
  } catch (const z3::exception&) {
    return CheckResult::Unknown;
  }
}

}  // namespace

std::vector<Obligation> obligationsOf(const TransitionSystem& system, const Question& question, const WordCertificate& certificate) {
  std::vector<Obligation> result;
  result.push_back(initiation(system, certificate));
  result.push_back(consecution(system, certificate));
  if (certificate.k > 0) result.push_back(base(system, question, certificate));
  result.push_back(step(system, question, certificate));
  return result;
}

std::string certificateText(const TransitionSystem& system, const Question& question, const WordCertificate& certificate) {
  std::string text = "(set-logic QF_BV)\n";
  for (const Obligation& obligation : obligationsOf(system, question, certificate)) {
    text += fmt::format("(push 1)\n; {}\n{}(check-sat) ; expected: unsat\n(pop 1)\n", obligation.name, obligation.text);
  }
  return text;
}

CheckResult checkCertificate(const TransitionSystem& system, const Question& question, const WordCertificate& certificate, double seconds) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point end = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
  CheckResult result = CheckResult::Valid;
  for (const Obligation& obligation : obligationsOf(system, question, certificate)) {
    const CheckResult one = check(obligation.text, std::chrono::duration<double>(end - Clock::now()).count());
    if (one == CheckResult::Invalid) return one;
    if (one == CheckResult::Unknown) result = one;
  }
  return result;
}

}  // namespace rungproof
