// Matches networks, follows their influence, asks for equality.
#include "frontend/sides/program_difference.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/unread/influence.hpp"
#include "analysis/unread/statement_influence.hpp"
#include "engine/trace.hpp"
#include "frontend/sides/difference_report.hpp"
#include "ir/iec/variables.hpp"

namespace rungproof {

namespace {

std::string nameWithSymbol(const Program& program, const Operand& operand) {
  const Symbol* symbol = program.symbolOf(wholeVariable(program, operand));
  if (symbol != nullptr && dialectOf(program.target).memory.isOfVariables) return symbol->name;
  return symbol == nullptr ? toString(operand) : fmt::format("{} ({})", toString(operand), symbol->name);
}

/// What one program's networks can influence, in the addresses of OLD where there is one.
class ReachOfChange {
 public:
  ReachOfChange(const Program& program, const AddressPairs& pairs, bool isOld)
      : program_(program), facts_(program), signals_(touchedSignals(program)), pairs_(pairs), isOld_(isOld) {}

  void add(NetworkChange& change, const NetworkRef& network, const std::vector<ObservedVerdict>& verdicts) const {
    const NetworkPlace place{static_cast<std::uint32_t>(network.pou), static_cast<std::uint32_t>(network.network)};
    if (facts_.form() == StatementForm::Accumulators) {
      StatementInfluence influence(facts_);
      influence.addNetwork(place, 1);
      influence.spread();
      return add(change, influence, verdicts);
    }
    Influence influence(facts_);
    influence.addChangedNetwork(place, 1);
    influence.spread();
    add(change, influence, verdicts);
  }

 private:
  template <class Spread>
  void add(NetworkChange& change, const Spread& influence, const std::vector<ObservedVerdict>& verdicts) const {
    change.isEverything = change.isEverything || influence.everything() != Influence::none;
    if (change.isEverything) addPulses(change, verdicts);
    for (const TraceSignal& signal : signals_) {
      const Operand& o = signal.operand;
      const bool isOutput = isOutputArea(o.area);
      if (isInputArea(o.area) || o.area == Area::SM) continue;
      bool isObserved = isOutput;
      for (std::uint32_t i = 0; i < extentOf(o); ++i) {
        const Address own{o.area, addressOf(o).index + i};
        const Operand bit = operandAt(own);
        if (isInfluenced(influence, bit, 1)) isObserved = addOutput(change, own, bit, verdicts) || isObserved;
      }
      if (!isObserved && isInfluenced(influence, o, 1)) addMemory(change, nameWithSymbol(program_, o));
    }
  }
  template <class Spread>
  static bool isInfluenced(const Spread& influence, const Operand& o, std::uint32_t elements) {
    return influence.causeAt(rowOf(o.area, o.width, o.offset, o.bit, elements)) != Influence::none;
  }
  static void addMemory(NetworkChange& change, const std::string& name) {
    if (std::ranges::find(change.memory, name) == change.memory.end()) change.memory.push_back(name);
  }
  /// What sets a device going can influence anything; pulse outputs have no other place.
  static void addPulses(NetworkChange& change, const std::vector<ObservedVerdict>& verdicts) {
    for (const ObservedVerdict& verdict : verdicts) {
      if (verdict.pulses &&
          std::ranges::find(change.outputs, verdict.name, &InfluencedOutput::name) == change.outputs.end())
        change.outputs.push_back({verdict.name, verdict.equality});
    }
  }
  /// False if it is not compared: memory that nobody observes.
  bool addOutput(NetworkChange& change, const Address& own, const Operand& bit,
                 const std::vector<ObservedVerdict>& verdicts) const {
    const std::optional<Address> there = isOld_ ? own : pairs_.before(own);
    const Operand observed = there ? operandAt(*there) : bit;
    const auto verdict = std::ranges::find(verdicts, toString(observed), &ObservedVerdict::name);
    const std::string name = nameWithSymbol(program_, bit);
    if (verdict == verdicts.end()) return false;
    const auto known = std::ranges::find(change.outputs, name, &InfluencedOutput::name);
    if (known == change.outputs.end())
      change.outputs.push_back({name, verdict->equality});
    else if (known->equality == Equality::Equal || verdict->equality == Equality::Different)
      known->equality = verdict->equality;  // the bits of one variable
    return true;
  }

  const Program& program_;
  const Facts facts_;
  const std::vector<TraceSignal> signals_;
  const AddressPairs& pairs_;
  const bool isOld_;
};

/// The properties that OLD declares, read for NEW: addresses and symbols are NEW's.
PropertySet declaredFor(const Program& declaring, Program& program) {
  PropertySet set;
  for (const Directive& directive : declaring.directives) {
    const std::uint32_t file = program.sources->add("declared in OLD", directive.text);
    std::vector<Finding> mistakes;  // a property that NEW's symbols do not explain is one that changed
    readPropertyText(file, directive.text, 0, withReals(program, lookupIn(program)), set, mistakes, &program.target);
  }
  return set;
}

std::vector<VerdictChange> changedVerdicts(const Sides& sides, const ProverOptions& options) {
  std::vector<VerdictChange> changes;
  Program before = *sides.runBefore, after = *sides.runAfter;
  const PropertySet ofBefore = declaredFor(before, before), ofAfter = declaredFor(before, after);
  if (std::ranges::none_of(ofBefore.properties, [](const Property& p) { return p.isGoal(); })) return changes;
  const ProofRun then = prove(before, ofBefore, options), now = prove(after, ofAfter, options);
  for (const ProofResult& result : then.results) {
    const auto same = std::ranges::find_if(
        now.results, [&](const ProofResult& r) { return r.property.name == result.property.name; });
    const std::string was = verdictText(result.outcome, result.depth);
    const std::string is = same == now.results.end() ? "cannot be read" : verdictText(same->outcome, same->depth);
    if (same == now.results.end() || same->outcome != result.outcome)
      changes.push_back({result.property.name, was, is});
  }
  return changes;
}

}  // namespace

std::size_t ProgramDifference::countOf(Equality equality) const {
  return static_cast<std::size_t>(std::ranges::count(equivalence.outputs, equality, &ObservedVerdict::equality));
}

ProgramDifference differenceOf(const Sides& sides, const EquivalenceOptions& given, const std::string& form,
                               int width) {
  ProgramDifference difference;
  EquivalenceOptions options = given;
  options.everyOutput = true;
  const ProgramMatch match = matchPrograms(*sides.runBefore, *sides.runAfter, sides.pairs);
  difference.equivalence = compareBehaviour(sides.oldSide(), sides.newSide(), options);
  const ReachOfChange ofBefore(*sides.runBefore, sides.pairs, true), ofAfter(*sides.runAfter, sides.pairs, false);
  for (const NetworkPair& pair : match.networks) {
    if (pair.isSame) continue;
    NetworkChange& change = difference.changes.emplace_back();
    change.networks = pair;
    if (pair.before) ofBefore.add(change, *pair.before, difference.equivalence.outputs);
    if (pair.after) ofAfter.add(change, *pair.after, difference.equivalence.outputs);
  }
  difference.values = changedValues(sides.before.program, sides.after.program);
  difference.verdicts = changedVerdicts(sides, options.prover);
  if (difference.equivalence.run) {
    difference.first.emplace();
    difference.first->equal = false;
    difference.first->verdict = "DIFFERENT";
    DifferenceReport(sides, options, *difference.equivalence.run).describe(*difference.first, form, width);
  }
  if (difference.changes.empty()) return difference;
  const auto leaveOpen = [&](std::string reason) {
    difference.equivalence.notes.push_back(std::move(reason));
    for (ObservedVerdict& output : difference.equivalence.outputs) {
      if (output.equality == Equality::Equal) output.equality = Equality::Unknown;
    }
  };
  if (sides.runBefore->main() == nullptr || sides.runAfter->main() == nullptr) {
    for (NetworkChange& change : difference.changes) change.isOfPart = true;
    leaveOpen("there is no main program: give the whole project, a folder or more files with --with");
  } else if (std::ranges::all_of(difference.equivalence.outputs, &ObservedVerdict::isRun)) {
    leaveOpen("neither program writes an output: name memory to be compared with --observe");
  }
  return difference;
}

}  // namespace rungproof
