// Matches networks, follows their influence, asks for equality.
#include "frontend/sides/program_difference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace rungproof {

namespace {

std::string nameWithSymbol(const Program& program, const Operand& operand) {
  const Symbol* symbol = program.symbolOf(operand);
  return symbol == nullptr ? toString(operand) : fmt::format("{} ({})", toString(operand), symbol->name);
}

/// The influence of both halves of a pair, in the addresses of OLD where there is one.
class Judgement {
 public:
  Judgement(const Sides& sides, const Equivalence& equivalence)
      : sides_(sides), equivalence_(equivalence), before_(sides.before.program), after_(sides.after.program) {}

  NetworkChange of(const NetworkPair& pair) {
    NetworkChange change;
    change.networks = pair;
    if (pair.before) add(change, influenceOf(before_, {*pair.before}), true);
    if (pair.after) add(change, influenceOf(after_, {*pair.after}), false);
    return change;
  }

 private:
  void add(NetworkChange& change, const Influence& influence, bool isOld) {
    change.isEverything = change.isEverything || influence.isEverything;
    const Program& program = isOld ? sides_.before.program : sides_.after.program;
    if (influence.isEverything) {
      for (const ObservedVerdict& output : equivalence_.outputs) addOutput(change, output.name, output.name);
    }
    for (const Address& address : influence.outputs) {
      const std::optional<Address> there = isOld ? address : sides_.pairs.before(address);
      const Operand own = direct(address.area, Width::Bit, address.index / 8, address.index % 8);
      const Operand shown = there ? direct(there->area, Width::Bit, there->index / 8, there->index % 8) : own;
      addOutput(change, toString(shown), nameWithSymbol(program, own));
    }
    for (const Operand& operand : influence.memory) {
      const std::string name = nameWithSymbol(program, operand);
      if (std::ranges::find(change.memory, name) == change.memory.end()) change.memory.push_back(name);
    }
  }
  void addOutput(NetworkChange& change, const std::string& observed, const std::string& shown) {
    const auto verdict = std::ranges::find(equivalence_.outputs, observed, &ObservedVerdict::name);
    if (verdict == equivalence_.outputs.end()) return;
    if (std::ranges::find(change.outputs, shown, &InfluencedOutput::name) == change.outputs.end())
      change.outputs.push_back({shown, verdict->equality});
  }

  const Sides& sides_;
  const Equivalence& equivalence_;
  const Facts before_, after_;
};

/// The properties that OLD declares, read for NEW: addresses and symbols are NEW's.
PropertySet declaredFor(const Program& declaring, Program& program) {
  PropertySet set;
  for (const Directive& directive : declaring.directives) {
    const std::uint32_t file = program.sources->add("declared in OLD", directive.text);
    std::vector<Finding> mistakes;  // a property that NEW's symbols do not explain is one that changed
    readPropertyText(file, directive.text, 0, lookupIn(program), set, mistakes, &program.target);
  }
  return set;
}

std::vector<VerdictChange> changedVerdicts(const Sides& sides, const ProverOptions& options) {
  std::vector<VerdictChange> changes;
  Program before = sides.before.program, after = sides.after.program;
  const PropertySet ofBefore = declaredFor(before, before), ofAfter = declaredFor(before, after);
  if (std::ranges::none_of(ofBefore.properties, [](const Property& p) { return p.isGoal(); })) return changes;
  const ProofRun then = prove(before, ofBefore, options), now = prove(after, ofAfter, options);
  for (const ProofResult& result : then.results) {
    const auto same = std::ranges::find_if(now.results, [&](const ProofResult& r) { return r.property.name == result.property.name; });
    const std::string was = verdictText(result.outcome, result.depth);
    const std::string is = same == now.results.end() ? "cannot be read" : verdictText(same->outcome, same->depth);
    if (same == now.results.end() || same->outcome != result.outcome) changes.push_back({result.property.name, was, is});
  }
  return changes;
}

}  // namespace

std::size_t ProgramDifference::countOf(Equality equality) const {
  return static_cast<std::size_t>(std::ranges::count(equivalence.outputs, equality, &ObservedVerdict::equality));
}

ProgramDifference differenceOf(const Sides& sides, const EquivalenceOptions& given) {
  ProgramDifference difference;
  EquivalenceOptions options = given;
  options.everyOutput = true;
  const ProgramMatch match = matchPrograms(sides.before.program, sides.after.program, sides.pairs);
  const Side before{&sides.before.program, sides.before.properties}, after{&sides.after.program, sides.after.properties};
  difference.equivalence = compareBehaviour(before, after, options);
  Judgement judgement(sides, difference.equivalence);
  for (const NetworkPair& pair : match.networks) {
    if (!pair.isSame) difference.changes.push_back(judgement.of(pair));
  }
  difference.verdicts = changedVerdicts(sides, options.prover);
  return difference;
}

}  // namespace rungproof
