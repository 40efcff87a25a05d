// Asks the rule about loops.
#include "analysis/equivalence/scan_length.hpp"

#include <algorithm>

#include "analysis/flow/facts.hpp"
#include "analysis/lint/lint.hpp"

namespace rungproof {

extern const Rule ctl004_loop_may_outlast_watchdog;  // analysis/checks

namespace {

/// The network that holds an instruction with that span.
std::optional<NetworkRef> networkAt(const Program& program, const Span& span) {
  for (std::size_t p = 0; p < program.pous.size(); ++p) {
    for (std::size_t n = 0; n < program.pous[p].networks.size(); ++n) {
      const std::vector<Instruction>& all = program.pous[p].networks[n].instructions;
      if (std::ranges::any_of(all, [&](const Instruction& i) { return i.span == span; })) return NetworkRef{p, n};
    }
  }
  return std::nullopt;
}

/// Whether anything in the program can run more than once in a scan by itself.
bool mayLoop(const Program& program) {
  for (const Pou& pou : program.pous) {
    for (const Network& network : pou.networks) {
      for (const Instruction& i : network.instructions) {
        if (i.desc->control == Control::For || i.desc->control == Control::Jump) return true;
      }
    }
  }
  return false;
}

void collect(const Program& program, std::string_view side, bool isOld, const ProgramMatch& match, LongScans& result) {
  if (!mayLoop(program)) return;
  const Facts facts(program);
  const RuleSelection aboutLoops({std::string(ctl004_loop_may_outlast_watchdog.id)}, {});
  for (const Finding& finding : runRules(facts, aboutLoops, {})) {
    const std::optional<NetworkRef> where = networkAt(program, finding.span);
    const bool isInBoth = where && std::ranges::any_of(match.networks, [&](const NetworkPair& pair) {
                            const std::optional<NetworkRef>& own = isOld ? pair.before : pair.after;
                            return pair.isSame && own && *own == *where;
                          });
    result.areInBoth = result.areInBoth || isInBoth;
    if (!isInBoth)
      result.ofOne.push_back("execution times are not modelled: in " + std::string(side) + " " + finding.message);
  }
}

}  // namespace

LongScans longScansOf(const Program& before, const Program& after, const ProgramMatch& match) {
  LongScans result;
  collect(before, "OLD", true, match, result);
  collect(after, "NEW", false, match, result);
  return result;
}

}  // namespace rungproof
