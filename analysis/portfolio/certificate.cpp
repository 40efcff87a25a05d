// Obligations of certificates, and their check: step by step first, the rest by Z3.
#include "analysis/portfolio/certificate.hpp"

#include <algorithm>
#include <chrono>
#include <unordered_map>

#include "analysis/portfolio/certificate_text.hpp"
#include "analysis/recheck/refutation.hpp"
#include "analysis/recheck/scan_clauses.hpp"
#include "analysis/schedule/schedule.hpp"

namespace rungproof {

namespace {

void addAll(std::vector<Formula>& parts, const std::vector<Node>& nodes, int scan) {
  for (const Node n : nodes) parts.push_back(truthOf(n, scan));
}

Formula notAll(const std::vector<Node>& nodes, int scan) {
  std::vector<Formula> parts;
  addAll(parts, nodes, scan);
  return notOf(allOf(std::move(parts)));
}

/// The theorem for the scan from state 0 to state 1.
Formula keeps(const KeptDifference& d) {
  const auto counts = [](const Summand& s) { return equals({s.word, 1}, {s.next, 0}); };
  const auto increment = [](const Summand& s) { return ScanNode{s.increment, s.isPending ? 1 : 0}; };
  return anyOf({notOf(allOf({counts(d.left), counts(d.right), equals(increment(d.left), increment(d.right))})),
                equals({d.difference, 1}, {d.difference, 0})});
}

/// The theorem for the scan from that state to the next.
Formula keeps(const KeptSum& sum, int scan) {
  std::vector<Formula> count;
  for (const SumTerm& t : sum.terms) count.push_back(equals({t.term, scan + 1}, {t.next, scan}));
  return anyOf({notOf(allOf(std::move(count))), equals({sum.sum, scan + 1}, {sum.next, scan})});
}

}  // namespace

void CertificateWriter::addSums(Parts& parts, const WordCertificate& certificate, int scan) const {
  for (const KeptSum& sum : certificate.sums) {
    if (consistsOfSums(*system_.graph, sum)) parts.push_back(keeps(sum, scan));
  }
}

/// Words become what is said where they count, and then their sum stays what it is.
void CertificateWriter::addGuide(const WordCertificate& certificate, int scan) {
  std::vector<Formula>& guide = obligations_.back().guide;
  for (const KeptSum& sum : certificate.sums) {
    addAll(guide, sum.facts, scan);
    for (const SumTerm& t : sum.terms) {
      const Formula becomes = equals({t.term, scan + 1}, {t.next, scan});
      guide.push_back(t.counts == noNode ? becomes : anyOf({notOf(truthOf(t.counts, scan)), becomes}));
    }
    addAll(guide, sum.steps, scan);
    addAll(guide, sum.facts, scan + 1);
  }
}

void CertificateWriter::oblige(const char* name, Parts parts) {
  obligations_.push_back({questions_.size() - 1, name, allOf(std::move(parts))});
}

CertificateWriter::Parts CertificateWriter::initialEquations(const std::unordered_set<std::uint32_t>& variables) const {
  Parts parts;
  for (const StateVariable& state : system_.states) {
    if (state.init != noNode && variables.contains(indexOf(state.node)))
      parts.push_back(equals({state.node, 0}, {state.init, 0}));
  }
  return parts;
}

void CertificateWriter::initiation(const WordCertificate& certificate) {
  Parts parts = initialEquations(statesUnder(system_, certificate.invariant));
  parts.push_back(notAll(certificate.invariant, 0));
  oblige("initiation", std::move(parts));
}

void CertificateWriter::consecution(const WordCertificate& certificate) {
  Parts parts;
  addAll(parts, certificate.invariant, 0);
  if (!certificate.invariant.empty()) addAll(parts, system_.constraints, 0);
  for (const KeptDifference& d : certificate.differences) {
    if (!consistsOfSums(*system_.graph, d)) continue;
    obligations_.push_back({questions_.size() - 1, "arithmetic", {}, d});
    parts.push_back(keeps(d));
  }
  for (const KeptSum& sum : certificate.sums) {
    if (consistsOfSums(*system_.graph, sum)) obligations_.push_back({questions_.size() - 1, "arithmetic", {}, sum});
  }
  addSums(parts, certificate, 0);
  parts.push_back(notAll(certificate.invariant, 1));
  oblige("consecution", std::move(parts));
  addGuide(certificate, 0);
  if (certificate.isChain || !certificate.differences.empty())
    addAll(obligations_.back().guide, certificate.invariant, 1);
}

/// k good scans of states in the invariant, then a bad one; k = 0: one bad scan.
void CertificateWriter::step(const Question& question, const WordCertificate& certificate) {
  Parts parts;
  for (int scan = 0; scan <= certificate.k; ++scan) {
    addAll(parts, certificate.immediate.empty() ? certificate.invariant : certificate.immediate, scan);
    addAll(parts, system_.constraints, scan);
    addSums(parts, certificate, scan);
    const Formula bad = truthOf(question.bad, scan);
    parts.push_back(scan < certificate.k ? notOf(bad) : bad);
  }
  for (int later = 1; certificate.simplePath && later <= certificate.k; ++later) {
    for (int earlier = 0; earlier < later; ++earlier) {
      Parts differences;
      for (const Node n : certificate.pathBits) differences.push_back(notOf(equals({n, earlier}, {n, later})));
      parts.push_back(anyOf(std::move(differences)));
    }
  }
  oblige("safety", std::move(parts));
  for (int scan = 0; scan <= certificate.k; ++scan) addGuide(certificate, scan);
}

/// Some of the first k scans from an initial state is bad.
void CertificateWriter::base(const Question& question, const WordCertificate& certificate) {
  Parts bads, legal;
  for (int scan = 0; scan < certificate.k; ++scan) {
    addAll(legal, system_.constraints, scan);
    Parts bad{truthOf(question.bad, scan)};
    bad.insert(bad.end(), legal.begin(), legal.end());
    bads.push_back(allOf(std::move(bad)));
  }
  std::vector<Node> roots = system_.constraints;
  roots.push_back(question.bad);
  std::unordered_set<std::uint32_t> reached;
  std::unordered_set<std::uint32_t> frontier = statesUnder(system_, roots);
  for (int scan = 0; scan < certificate.k && !frontier.empty(); ++scan) {
    std::vector<Node> next;
    for (const StateVariable& state : system_.states) {
      if (frontier.contains(indexOf(state.node)) && reached.insert(indexOf(state.node)).second)
        next.push_back(state.next);
    }
    frontier = statesUnder(system_, next);
  }
  Parts parts = initialEquations(reached);
  parts.push_back(anyOf(std::move(bads)));
  oblige("base", std::move(parts));
}

/// Bad is impossible in one scan whatever the values of the open nodes; no scan needs to be known but this one, and of
/// the invariant what it says about this one.
void CertificateWriter::surface(const Question& question, const WordCertificate& certificate) {
  std::unordered_set<std::uint32_t>& open = surfaces_.emplace_back();
  for (const Node n : certificate.open) open.insert(indexOf(n));
  Parts parts{truthOf(question.bad, 0)};
  addAll(parts, certificate.invariant, 0);
  oblige("safety", std::move(parts));
  obligations_.back().surface = surfaces_.size() - 1;
}

void CertificateWriter::add(const Question& question, const WordCertificate& certificate) {
  questions_.push_back(question.name);
  initiation(certificate);
  consecution(certificate);
  if (certificate.k > 0) base(question, certificate);
  if (certificate.open.empty())
    step(question, certificate);
  else
    surface(question, certificate);
}

void CertificateWriter::addStart(const std::string& name, const std::vector<Node>& facts) {
  questions_.push_back(name);
  WordCertificate start;
  start.invariant = facts;
  initiation(start);
}

void CertificateWriter::addInvariant(const std::string& name, const WordCertificate& certificate) {
  questions_.push_back(name);
  initiation(certificate);
  consecution(certificate);
}

void CertificateWriter::addConsequence(const char* name, const WordCertificate& certificate, Node fact) {
  questions_.push_back(std::string(questions_.back()));
  Parts parts;
  addAll(parts, certificate.invariant, 0);
  addAll(parts, system_.constraints, 0);
  parts.push_back(notAll({fact}, 0));
  oblige(name, std::move(parts));
}

std::string CertificateWriter::text() const {
  CertificateText text(system_, surfaces_);
  for (const Obligation& o : obligations_) text.add(o, questions_[o.certificate]);
  return text.file();
}

/// Equal formulas have equal literals, and are refuted once.
std::vector<CheckResult> CertificateWriter::checkStepByStep(const CheckLimits& limits) const {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point begin = Clock::now();
  std::vector<CheckResult> results(obligations_.size(), CheckResult::Unknown);
  ScanClauses shared(system_);
  std::unordered_map<int, CheckResult> known;
  const auto refuted = [&](ScanClauses& clauses, int literal, const std::vector<Formula>& guide) {
    if (literal == -GateClauses::yes) return CheckResult::Valid;
    const double used = std::chrono::duration<double>(Clock::now() - begin).count();
    std::vector<int> guiding;
    const double most = guide.empty() ? schedule::stepByStepSeconds : schedule::guidedSeconds;
    for (const Formula& formula : guide) guiding.push_back(clauses.literalOf(formula));
    return refute(clauses.gates().clausesOf(literal, guiding),
                  {std::min({most, limits.each, limits.total - used}), limits.cancel});
  };
  for (std::size_t i = 0; i < obligations_.size(); ++i) {
    const Obligation& o = obligations_[i];
    if (o.theorem) {
      results[i] = CheckResult::Valid;  // only sums are added to the obligations
    } else if (o.surface) {
      ScanClauses own(system_, surfaces_[*o.surface]);
      results[i] = refuted(own, own.literalOf(o.formula), o.guide);
    } else {
      const int literal = shared.literalOf(o.formula);
      const auto [at, isNew] = known.try_emplace(literal, CheckResult::Unknown);
      if (isNew) at->second = refuted(shared, literal, o.guide);
      results[i] = at->second;
    }
  }
  return results;
}

/// What is too long for that.
void CertificateWriter::checkWithZ3(const std::vector<std::size_t>& open, const CheckLimits& limits,
                                    std::vector<CheckResult>& results) const {
  CertificateText text(system_, surfaces_);
  for (const std::size_t i : open) text.add(obligations_[i], questions_[obligations_[i].certificate]);
  const std::vector<CheckResult> found = text.check(limits);
  for (std::size_t i = 0; i < open.size(); ++i) results[open[i]] = found[i];
}

std::vector<CheckResult> CertificateWriter::check(const CheckLimits& limits) const {
  const auto begin = std::chrono::steady_clock::now();
  std::vector<CheckResult> found = checkStepByStep(limits);
  std::vector<bool> isRefused(questions_.size(), false);
  for (std::size_t i = 0; i < obligations_.size(); ++i) {
    if (found[i] == CheckResult::Invalid) isRefused[obligations_[i].certificate] = true;
  }
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < obligations_.size(); ++i) {
    if (found[i] == CheckResult::Unknown && !isRefused[obligations_[i].certificate]) open.push_back(i);
  }
  if (!open.empty()) {
    CheckLimits rest = limits;
    rest.total -= std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    checkWithZ3(open, rest, found);
  }
  std::vector<CheckResult> results(questions_.size(), CheckResult::Valid);
  for (std::size_t i = 0; i < obligations_.size(); ++i) {
    CheckResult& result = results[obligations_[i].certificate];
    if (result == CheckResult::Valid || found[i] == CheckResult::Invalid) result = found[i];
  }
  return results;
}

}  // namespace rungproof
