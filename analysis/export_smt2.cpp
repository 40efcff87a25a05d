// SMT-LIB 2: the transition from @0 to @1, and for each question whether it can be bad in the first scan.
#include <fmt/format.h>

#include <algorithm>

#include "analysis/export_system.hpp"
#include "analysis/smt_text.hpp"

namespace rungproof {

std::string exportSmt2(const TransitionSystem& system) {
  SmtText smt(system);
  std::unordered_set<std::uint32_t> states;
  for (const StateVariable& s : system.states) {
    smt.term(s.node, 1);
    states.insert(indexOf(s.node));
  }
  const std::vector<std::string> initial = smt.initialEquations(states);
  std::string assertions;
  for (const Node n : system.constraints) assertions += fmt::format("(assert {})\n", smt.term(n, 0));
  for (const std::string& equation : initial) assertions += fmt::format("(assert {})\n", equation);
  for (const Question& question : system.questions) {
    std::string name = question.name;
    std::replace_if(name.begin(), name.end(), [](unsigned char c) { return c < 32; }, ' ');
    assertions += fmt::format("; {}\n(push 1)\n(assert {})\n(check-sat)\n(pop 1)\n", name, smt.term(question.bad, 0));
  }
  return "(set-logic QF_BV)\n" + smt.text() + assertions;
}

}  // namespace rungproof
