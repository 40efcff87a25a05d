// SMT-LIB 2: an unrolling from an initial state, and for each question whether it can be bad within it.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analysis/export/system.hpp"
#include "analysis/graph/smt_text.hpp"

namespace rungproof {

std::string exportSmt2(const TransitionSystem& system, int scans, const ExportRemarks& remarks) {
  SmtText smt(system);
  std::unordered_set<std::uint32_t> states;
  for (const StateVariable& s : system.states) {
    smt.term(s.node, scans);
    states.insert(indexOf(s.node));
  }
  const std::vector<std::string> initial = smt.initialEquations(states);
  std::string assertions;
  for (const std::string& equation : initial) assertions += fmt::format("(assert {})\n", equation);
  // A scan counts only if the constraints hold in it and in all scans before it.
  std::vector<std::string> legal;
  std::string kept = "true";
  for (int scan = 0; scan < scans; ++scan) {
    for (const Node n : system.constraints) kept += " " + smt.term(n, scan);
    legal.push_back(kept);
  }
  for (const Question& question : system.questions) {
    std::vector<std::string> bads{"false", "false"};
    for (int scan = 0; scan < scans; ++scan)
      bads.push_back(fmt::format("(and {} {})", smt.term(question.bad, scan), legal[static_cast<std::size_t>(scan)]));
    assertions += fmt::format("; {}\n(push 1)\n(assert (or {}))\n(check-sat)\n(pop 1)\n", exportLine(question.name),
                              fmt::join(bads, " "));
  }
  std::string head;
  for (const std::string& remark : remarks) head += "; " + exportLine(remark) + "\n";
  return head + "(set-logic QF_BV)\n" + smt.text() + assertions;
}

}  // namespace rungproof
