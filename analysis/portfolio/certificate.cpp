// Obligations of certificates as text.
#include "analysis/portfolio/certificate.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace rungproof {

void CertificateWriter::oblige(const char* name, const Terms& terms) {
  obligations_.push_back({questions_.size() - 1, name, fmt::format("(and true true {})", fmt::join(terms, " "))});
}

void CertificateWriter::addAll(Terms& terms, const std::vector<Node>& nodes, int frame) {
  for (const Node n : nodes) terms.push_back(smt_.term(n, frame));
}

std::string CertificateWriter::notAll(const std::vector<Node>& nodes, int frame) {
  Terms terms;
  addAll(terms, nodes, frame);
  return fmt::format("(not (and true true {}))", fmt::join(terms, " "));
}

void CertificateWriter::initiation(const WordCertificate& certificate) {
  Terms terms = smt_.initialEquations(smt_.statesUnder(certificate.invariant));
  terms.push_back(notAll(certificate.invariant, 0));
  oblige("initiation", terms);
}

void CertificateWriter::consecution(const WordCertificate& certificate) {
  Terms terms;
  addAll(terms, certificate.invariant, 0);
  if (!certificate.invariant.empty()) addAll(terms, system_.constraints, 0);
  for (const KeptDifference& d : certificate.differences) {
    theorem(d);
    terms.push_back(keeps(d));
  }
  terms.push_back(notAll(certificate.invariant, 1));
  oblige("consecution", terms);
}

/// The theorem for the scan from state 0 to state 1.
std::string CertificateWriter::keeps(const KeptDifference& d) {
  const auto increment = [&](const Summand& s) { return smt_.term(s.increment, s.isPending ? 1 : 0); };
  const auto counts = [&](const Summand& s) {
    return fmt::format("(= {} {})", smt_.term(s.word, 1), smt_.term(s.next, 0));
  };
  return fmt::format("(=> (and {} {} (= {} {})) (= {} {}))", counts(d.left), counts(d.right), increment(d.left),
                     increment(d.right), smt_.term(d.difference, 1), smt_.term(d.difference, 0));
}

/// The same for any words of that width, once for each form of it.
void CertificateWriter::theorem(const KeptDifference& d) {
  const int width = system_.graph->operator[](d.difference).width;
  const std::string form = fmt::format("{} {} {}", width, d.left.isPending, d.right.isPending);
  const auto [at, isNew] = proved_.emplace(form, static_cast<int>(proved_.size()));
  if (!isNew) return;
  const int k = at->second;
  // x0, i0 before the step and x1, i1 after it; a pending increment i0 is added by the step, else i1.
  const auto variable = [&](const char* side, const char* name) {
    const std::string symbol = fmt::format("theorem{}.{}{}", k, side, name);
    theorems_ += fmt::format("(declare-fun {} () (_ BitVec {}))\n", symbol, width);
    return symbol;
  };
  const auto formOf = [&](const char* side, bool isPending) {
    const std::string x0 = variable(side, "x0"), x1 = variable(side, "x1"), i0 = variable(side, "i0"),
                      i1 = variable(side, "i1");
    const std::string next = fmt::format("(bvadd {} {})", x0, isPending ? i0 : i1);
    const std::string later = isPending ? fmt::format("(bvadd {} {})", x1, i1) : x1;
    return std::array<std::string, 4>{fmt::format("(= {} {})", x1, next), i1, isPending ? next : x0, later};
  };
  const auto left = formOf("left.", d.left.isPending), right = formOf("right.", d.right.isPending);
  oblige("arithmetic", {left[0], right[0], fmt::format("(= {} {})", left[1], right[1]),
                        fmt::format("(not (= (bvsub {} {}) (bvsub {} {})))", left[3], right[3], left[2], right[2])});
}

/// k good scans of states in the invariant, then a bad one; k = 0: one bad scan.
void CertificateWriter::step(const Question& question, const WordCertificate& certificate) {
  Terms terms;
  for (int frame = 0; frame <= certificate.k; ++frame) {
    addAll(terms, certificate.immediate.empty() ? certificate.invariant : certificate.immediate, frame);
    addAll(terms, system_.constraints, frame);
    const std::string bad = smt_.term(question.bad, frame);
    terms.push_back(frame < certificate.k ? fmt::format("(not {})", bad) : bad);
  }
  for (int later = 1; certificate.simplePath && later <= certificate.k; ++later) {
    for (int earlier = 0; earlier < later; ++earlier) {
      Terms differences;
      for (const Node n : certificate.pathBits)
        differences.push_back(fmt::format("(xor {} {})", smt_.term(n, earlier), smt_.term(n, later)));
      terms.push_back(fmt::format("(or false false {})", fmt::join(differences, " ")));
    }
  }
  oblige("safety", terms);
}

/// Some of the first k scans from an initial state is bad.
void CertificateWriter::base(const Question& question, const WordCertificate& certificate) {
  Terms bads;
  std::string legal = "true";
  for (int frame = 0; frame < certificate.k; ++frame) {
    for (const Node n : system_.constraints) legal += " " + smt_.term(n, frame);
    bads.push_back(fmt::format("(and {} {})", smt_.term(question.bad, frame), legal));
  }
  std::vector<Node> roots = system_.constraints;
  roots.push_back(question.bad);
  std::unordered_set<std::uint32_t> reached;
  std::unordered_set<std::uint32_t> frontier = smt_.statesUnder(roots);
  for (int frame = 0; frame < certificate.k && !frontier.empty(); ++frame) {
    std::vector<Node> next;
    for (const StateVariable& state : system_.states) {
      if (frontier.contains(indexOf(state.node)) && reached.insert(indexOf(state.node)).second)
        next.push_back(state.next);
    }
    frontier = smt_.statesUnder(next);
  }
  Terms terms = smt_.initialEquations(reached);
  terms.push_back(fmt::format("(or false false {})", fmt::join(bads, " ")));
  oblige("base", terms);
}

/// Bad is impossible in one scan whatever the values of the open nodes; no scan needs to be known but this one, and of
/// the invariant what it says about this one.
void CertificateWriter::surface(const Question& question, const WordCertificate& certificate) {
  std::unordered_set<std::uint32_t> open;
  for (const Node n : certificate.open) open.insert(indexOf(n));
  SmtText smt(system_, fmt::format(".{}", questions_.size()), std::move(open));
  Terms terms{smt.term(question.bad, 0)};
  for (const Node n : certificate.invariant) terms.push_back(smt.term(n, 0));
  surfaces_ += smt.declarations();
  surfaceDefinitions_.insert(surfaceDefinitions_.end(), smt.definitions().begin(), smt.definitions().end());
  oblige("safety", terms);
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

std::vector<SmtText::Definition> CertificateWriter::definitions() const {
  std::vector<SmtText::Definition> all = smt_.definitions();
  all.insert(all.end(), surfaceDefinitions_.begin(), surfaceDefinitions_.end());
  return all;
}

std::string CertificateWriter::text() const {
  std::string text = "(set-logic QF_BV)\n" + theorems_ + smt_.declarations() + surfaces_;
  const std::vector<SmtText::Definition> all = definitions();
  for (const Condition& o : obligations_) {
    std::string name = questions_[o.certificate];
    std::replace_if(
        name.begin(), name.end(), [](unsigned char c) { return c < 32; }, ' ');
    text += fmt::format("; {} of: {}\n(push 1)\n(assert {})\n(check-sat) ; expected: unsat\n(pop 1)\n", o.name, name,
                        withDefinitions(all, o.formula));
  }
  return text;
}

/// Certificates of one system share obligations word for word; each is read and checked once. All are arguments of one
/// predicate, so that they share their definitions.
std::vector<CheckResult> CertificateWriter::check(const CheckLimits& limits) const {
  std::string sorts, arguments = "true";
  std::unordered_map<std::string_view, std::size_t> index;
  std::vector<std::size_t> formulaOf, owners;
  for (const Condition& o : obligations_) {
    const auto [at, isNew] = index.emplace(o.formula, index.size());
    formulaOf.push_back(at->second);
    if (!isNew) continue;
    owners.push_back(at->second);
    sorts += " Bool";
    arguments += " " + o.formula;
  }
  const std::string formulas = theorems_ + smt_.declarations() + surfaces_ +
                               fmt::format("(declare-fun obligations (Bool{}) Bool)\n(assert {})\n", sorts,
                                           withDefinitions(definitions(), fmt::format("(obligations {})", arguments)));
  const std::vector<CheckResult> checked = checkApart(formulas, owners, owners.size(), limits);
  std::vector<CheckResult> results(questions_.size(), CheckResult::Valid);
  for (std::size_t i = 0; i < obligations_.size(); ++i) {
    CheckResult& result = results[obligations_[i].certificate];
    const CheckResult one = checked[formulaOf[i]];
    if (result == CheckResult::Valid || one == CheckResult::Invalid) result = one;
  }
  return results;
}

}  // namespace rungproof
