// Formulas as terms, then all together as one file or as one question to Z3.
#include "analysis/portfolio/certificate_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <functional>
#include <numeric>
#include <string_view>

namespace rungproof {

namespace {

std::string termOf(SmtText& smt, const Formula& formula) {
  const auto term = [&](std::size_t i) { return smt.term(formula.terms[i].node, formula.terms[i].scan); };
  std::vector<std::string> parts;
  for (const Formula& part : formula.parts) parts.push_back(termOf(smt, part));
  switch (formula.kind) {
    case Formula::Kind::Truth: return term(0);
    case Formula::Kind::Equal: {
      const std::string first = term(0);
      return fmt::format("(= {} {})", first, term(1));
    }
    case Formula::Kind::Not: return fmt::format("(not {})", parts[0]);
    case Formula::Kind::All: return fmt::format("(and true true {})", fmt::join(parts, " "));
    case Formula::Kind::Any: return fmt::format("(or false false {})", fmt::join(parts, " "));
  }
  return {};
}

}  // namespace

/// The theorem for any words of that width, once for each form of it: else empty.
std::string CertificateText::theorem(const KeptDifference& d) {
  const int width = system_.graph->operator[](d.difference).width;
  const std::string form = fmt::format("{} {} {}", width, d.left.isPending, d.right.isPending);
  const auto [at, isNew] = proved_.emplace(form, static_cast<int>(proved_.size()));
  if (!isNew) return {};
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
  return fmt::format("(and true true {} {} (= {} {}) (not (= (bvsub {} {}) (bvsub {} {}))))", left[0], right[0],
                     left[1], right[1], left[3], right[3], left[2], right[2]);
}

/// The theorem for any words under the sums, once for each form of it: else empty.
std::string CertificateText::theorem(const KeptSum& sum) {
  const Graph& graph = *system_.graph;
  const int width = graph[sum.sum].width;
  const auto formula = [&](const std::string& prefix, std::string& declarations) {
    std::unordered_map<std::uint32_t, std::string> symbols;
    const auto variable = [&](const std::string& name, int bits) {
      declarations += fmt::format("(declare-fun {}{} () (_ BitVec {}))\n", prefix, name, bits);
      return prefix + name;
    };
    const std::function<std::string(Node)> written = [&](Node n) -> std::string {
      const NodeData& node = graph[n];
      if (node.op == Op::Add || node.op == Op::Sub)
        return fmt::format("({} {} {})", node.op == Op::Add ? "bvadd" : "bvsub", written(node.child[0]),
                           written(node.child[1]));
      if (node.op == Op::Sext || node.op == Op::Zext)
        return fmt::format("((_ {} {}) {})", node.op == Op::Sext ? "sign_extend" : "zero_extend",
                           node.width - graph[node.child[0]].width, written(node.child[0]));
      if (node.op == Op::Constant) return fmt::format("(_ bv{} {})", node.value, node.width);
      const auto [at, isNew] = symbols.emplace(indexOf(n), std::string());
      if (isNew) at->second = variable(fmt::format("part{}", symbols.size()), node.width);
      return at->second;
    };
    std::string counts, after = fmt::format("(_ bv0 {})", width), before = after;
    for (std::size_t i = 0; i < sum.terms.size(); ++i) {
      const SumTerm& t = sum.terms[i];
      const std::string then = variable(fmt::format("after{}", i), width), op = t.isSubtracted ? "bvsub" : "bvadd";
      counts += fmt::format(" (= {} {})", then, written(t.next));
      after = fmt::format("({} {} {})", op, after, then);
      before = fmt::format("({} {} {})", op, before, written(t.term));
    }
    const std::string next = written(sum.next), now = written(sum.sum);
    // What the sum is beside the terms, a constant, is the same before and after.
    return fmt::format("(and true true{} (not (= (bvsub {} {}) (bvsub {} {}))))", counts, next, after, now, before);
  };
  std::string ignored;
  const auto [at, isNew] = proved_.emplace(formula("", ignored), static_cast<int>(proved_.size()));
  return isNew ? formula(fmt::format("theorem{}.", at->second), theorems_) : std::string();
}

void CertificateText::add(const Obligation& obligation, const std::string& question) {
  std::string name = question;
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return c < 32; }, ' ');
  Entry entry{fmt::format("{} of: {}", obligation.name, name), {}};
  if (obligation.theorem) {
    entry.formula = std::visit([&](const auto& kept) { return theorem(kept); }, *obligation.theorem);
    if (entry.formula.empty()) return;
  } else if (obligation.surface) {
    SmtText smt(system_, fmt::format(".{}", *obligation.surface + 1), surfaces_[*obligation.surface]);
    entry.formula = termOf(smt, obligation.formula);
    surfaceDeclarations_ += smt.declarations();
    surfaceDefinitions_.insert(surfaceDefinitions_.end(), smt.definitions().begin(), smt.definitions().end());
  } else {
    entry.formula = termOf(smt_, obligation.formula);
  }
  entries_.push_back(std::move(entry));
}

std::vector<SmtText::Definition> CertificateText::definitions() const {
  std::vector<SmtText::Definition> all = smt_.definitions();
  all.insert(all.end(), surfaceDefinitions_.begin(), surfaceDefinitions_.end());
  return all;
}

std::string CertificateText::file() const {
  std::string text = "(set-logic QF_BV)\n" + declarations();
  const std::vector<SmtText::Definition> all = definitions();
  for (const Entry& e : entries_)
    text += fmt::format("; {}\n(push 1)\n(assert {})\n(check-sat) ; expected: unsat\n(pop 1)\n", e.title,
                        withDefinitions(all, e.formula));
  return text;
}

/// Certificates of one system share obligations word for word; each is read and checked once. All are arguments of one
/// predicate, so that they share their definitions.
std::vector<CheckResult> CertificateText::check(const CheckLimits& limits) const {
  std::string sorts, arguments = "true";
  std::unordered_map<std::string_view, std::size_t> index;
  std::vector<std::size_t> formulaOf;
  for (const Entry& e : entries_) {
    const auto [at, isNew] = index.emplace(e.formula, index.size());
    formulaOf.push_back(at->second);
    if (!isNew) continue;
    sorts += " Bool";
    arguments += " " + e.formula;
  }
  std::vector<std::size_t> owners(index.size());
  std::iota(owners.begin(), owners.end(), std::size_t{0});
  const std::string formulas =
      declarations() + fmt::format("(declare-fun obligations (Bool{}) Bool)\n(assert {})\n", sorts,
                                   withDefinitions(definitions(), fmt::format("(obligations {})", arguments)));
  const std::vector<CheckResult> checked = checkApart(formulas, owners, owners.size(), limits);
  std::vector<CheckResult> results;
  for (const std::size_t formula : formulaOf) results.push_back(checked[formula]);
  return results;
}

}  // namespace rungproof
