// From answers to results: what a verdict is called, what it rests on, what leaves it open.
#include "analysis/proof/prover.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <set>
#include <unordered_map>

#include "analysis/asking/asked_goals.hpp"
#include "analysis/broken_off.hpp"
#include "analysis/proof/proof_networks.hpp"
#include "analysis/proof/question_search.hpp"
#include "analysis/proof/unfollowed_routine.hpp"
#include "analysis/proof/untouched.hpp"
#include "analysis/schedule/schedule.hpp"
#include "analysis/unread/hidden_blocks.hpp"
#include "analysis/witness/circumstances.hpp"

namespace rungproof {

namespace {

/// A verdict that depends on code which was not read is none.
void leaveOpen(ProofResult& row, const std::vector<std::string>& reasons) {
  if (reasons.empty()) return;
  row.outcome = Outcome::NotCovered;
  row.method.clear();
  row.depth = 0;
  row.certificate.clear();
  row.witness.reset();
  row.networks.clear();
  row.notes.insert(row.notes.end(), reasons.begin(), reasons.end());
}

/// An exception while a question was answered.
void breakOff(ProofResult& row, const std::exception& error) {
  leaveOpen(row, {whyBrokenOff(error) + ", which leaves the question open"});
  row.outcome = Outcome::Unknown;
}

std::size_t goalCount(const PropertySet& set) {
  return static_cast<std::size_t>(
      std::count_if(set.properties.begin(), set.properties.end(), [](const Property& p) { return p.isGoal(); }));
}

class Session {
 public:
  using Clock = QuestionSearch::Clock;

  Session(const Program& program, const PropertySet& set, const ProverOptions& options)
      : program_(program), set_(set), options_(options), search_(program, set, options) {}

  ProofRun run(const ProofProgress& progress) {
    ProofRun result;
    result.assumptions = environmentTexts(program_, set_, options_.time, options_.choices);
    const std::size_t declared = goalCount(set_);
    try {
      search_.encode(deadlineOf(declared));
    } catch (const EncodingStopped&) {
      return notEncoded(declared, std::move(result));
    }
    const std::vector<RuleQuestion>& checks = search_.exact().checks();
    const std::size_t total = declared + checks.size();
    search_.answerQuickly(deadlineOf(total));
    const auto questionOf = [&](std::size_t i) { return i < declared ? i : goals().size() + (i - declared); };
    std::vector<std::size_t> order(total);
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto worthOf = [&](std::size_t i) { return i < declared ? 0 : checks[i - declared].rule->ask.cost; };
    if (options_.total > 0) {
      // The time may not suffice for all: what is worst not to know first.
      std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return worthOf(a) < worthOf(b); });
    } else {
      // Those with a run first: who waits for the first bad verdict need not wait for proofs.
      std::stable_partition(order.begin(), order.end(),
                            [&](std::size_t i) { return search_.quick(questionOf(i)).answer == Answer::Violated; });
    }
    std::vector<std::optional<ProofResult>> rows(total);
    for (std::size_t done = 0; done < total; ++done) {
      const std::size_t i = order[done];
      const Clock::time_point start = Clock::now();
      // One question may use its own time, and what those before it have left of theirs is not saved up.
      const bool isOfRule = i >= declared && (options_.checks.lint || !isAskedByProve(*checks[i - declared].rule));
      const double most = isOfRule ? std::min(options_.timeout, options_.ruleTimeout) : options_.timeout;
      ProofResult row;
      if (i < declared)
        row.property = goals()[i];
      else {
        row.builtin = checks[i - declared];
        row.property.name = row.builtin->name;
        if (row.builtin->place != nullptr) row.property.span = row.builtin->place->span;
      }
      const std::size_t question = questionOf(i);
      if (!search_.isSettled(question) && (isOver() || search_.watch().isStopped()))
        row.notes.push_back(reasonToStop());
      else
        settleAlone(question,
                    {.deadline = std::min(start + inSeconds(most), deadlineOf(done + 1)),
                     .processor = isOfRule ? std::min(most, schedule::ruleProcessorSeconds) : most,
                     .isOfMany = isOfRule},
                    row, result);
      row.seconds = secondsSince(start) + search_.quick(question).seconds;
      rows[i] = std::move(row);
      if (progress && !progress(*rows[i], done + 1, total)) break;
    }
    for (std::optional<ProofResult>& row : rows)
      if (row) result.results.push_back(std::move(*row));
    QuestionSystem& exact = search_.exact();
    for (const Approximation& approximation : exact.askedProperties().approximations()) {
      if (!isWrittenOut(*exact.system().graph, approximation) || noted_.contains(&approximation))
        result.approximations.push_back(approximationText(program_, approximation));
    }
    result.isInterrupted = search_.watch().isInterrupted();
    result.techniques = search_.techniques();
    return result;
  }

 private:
  const std::vector<Property>& goals() const { return search_.goals(); }
  /// When that many questions have used up their time.
  Clock::time_point deadlineOf(std::size_t questions) const {
    const double each = options_.timeout * static_cast<double>(std::max<std::size_t>(questions, 1));
    return begin_ + inSeconds(options_.total > 0 ? std::min(each, options_.total) : each);
  }
  bool isOver() const { return options_.total > 0 && secondsSince(begin_) >= options_.total; }
  std::string reasonToStop() const {
    return search_.watch().isInterrupted()   ? "interrupted"
           : search_.watch().isOutOfMemory() ? "the memory limit was reached"
                                             : "the time was over";
  }

  ProofRun notEncoded(std::size_t declared, ProofRun result) const {
    const auto add = [&](const Property& property) {
      ProofResult& row = result.results.emplace_back();
      row.property = property;
      row.seconds = secondsSince(begin_);
      row.notes.push_back(reasonToStop() + " before the program was encoded");
    };
    for (std::size_t i = 0; i < declared; ++i) {
      add(goals()[i]);
      if (const auto run = search_.early().find(i); run != search_.early().end())
        showRun(result.results.back(), run->second, "exploration");
    }
    if (options_.checks.builtin) {
      Property checks;
      checks.name = "built-in checks";
      add(checks);
    }
    result.isInterrupted = search_.watch().isInterrupted();
    return result;
  }

  /// A run of the engine is a run, whatever was or was not encoded.
  static void showRun(ProofResult& row, const Witness& witness, const char* method) {
    const bool wantsYes = row.builtin ? row.builtin->rule->ask.wantsYes : row.property.kind == PropertyKind::Reach;
    row.outcome = wantsYes ? Outcome::Reachable : Outcome::Violated;
    row.method = method;
    row.notes = row.property.remarks;
    row.depth = static_cast<int>(std::min<std::uint64_t>(witness.scanCount, 1U << 30));
    row.witness = witness;
  }

  /// What breaks for one question costs that question only.
  void settleAlone(std::size_t question, const QuestionSearch::Time& time, ProofResult& row, ProofRun& run) {
    try {
      settle(question, time, row, run);
    } catch (const std::exception& error) {
      breakOff(row, error);
    }
  }

  void settle(std::size_t question, const QuestionSearch::Time& time, ProofResult& row, ProofRun& run) {
    auto [answer, witness] = search_.answer(question, time);
    row.method = answer.method;
    row.depth = answer.depth;
    row.notes = row.property.remarks;
    const bool wantsYes = row.builtin ? row.builtin->rule->ask.wantsYes : row.property.kind == PropertyKind::Reach;
    if (witness && answer.answer == Answer::Proved) {
      row.notes.push_back("a proof and a run of the engine contradict each other");
      run.disagreements.push_back(
          {row.property.name, "it is proved, and the engine makes a run that shows the opposite", {}});
    } else if (witness) {
      row.outcome = wantsYes ? Outcome::Reachable : Outcome::Violated;
      row.depth = static_cast<int>(std::min<std::uint64_t>(witness->scanCount, 1U << 30));
      row.witness = std::move(witness);
    } else if (answer.answer == Answer::Proved) {
      row.outcome = wantsYes ? Outcome::Unreachable : Outcome::Proved;
      if (options_.certificates && answer.certificate) {
        row.certificate = search_.certificate(question, answer);
        if (row.certificate.empty())
          row.notes.push_back("the form of the program decides it: there is nothing to certify");
      }
      checkVacuity(row, answer.seconds + search_.quick(question).seconds);
      if (options_.evidence && options_.explains) row.networks = networksOf(question, answer);
    } else if (answer.answer == Answer::Violated) {
      unconfirmed(question, answer, row, run);
    } else {
      row.outcome = answer.depth > 0 && options_.bound > 0 ? Outcome::HoldsToBound : Outcome::Unknown;
      if (options_.bound > 0) row.depth = answer.depth = std::min(answer.depth, options_.bound);
      row.notes.push_back(fmt::format("{} in the first {} scans; {}", wantsYes ? "not reached" : "no violation",
                                      answer.depth,
                                      answer.method.empty() ? "no engine came to work" : "tried " + answer.method));
      if (search_.watch().isStopped()) row.notes.push_back(reasonToStop());
    }
    if (options_.explains || row.outcome == Outcome::Unknown) noteApproximations(question, row);
    guardInterrupts(row);
    guardLeftOut(row);
    guardDecisions(row);
    guardUnreadCode(row);
    if (options_.explains)
      nameCircumstances(question, row);
    else
      nameAnyValues(question, row);
  }

  /// Of the many questions of rules only what has any value is said.
  void nameAnyValues(std::size_t question, ProofResult& row) {
    const EncodedScan& encoding = search_.exact().askedProperties().encoding();
    if (!hasAnyValues_) hasAnyValues_ = hasAnyValues(encoding);
    if (*hasAnyValues_) row.assumptions = circumstancesOf(encoding, search_.exact().variablesOf(question)).anyValues;
  }

  /// The fixed choices that a question depends on without showing it: their readings are constants in its encoding, or
  /// reads of one sample are equal there. So it is looked at in another one.
  std::vector<Choice> fixedChoices(const EncodedScan& encoding, std::size_t question, const Circumstances& found) {
    std::vector<Choice> asked = fixedReadingsOf(encoding);
    if (!encoding.analogInputs().empty() && std::ranges::find(found.fixed, Choice::AnalogSampling) == found.fixed.end())
      asked.push_back(Choice::AnalogSampling);
    if (asked.empty() || question >= goals().size()) return asked;
    if (!open_) {
      EncoderOptions options = encoderOptionsOf(options_);
      options.coversAllReadings = true;
      options.isLeftOut = search_.leftOut();
      open_ = std::make_unique<QuestionSystem>(program_, set_, goals(), options, CheckGroups{});
    }
    const Circumstances all = circumstancesOf(open_->askedProperties().encoding(), open_->variablesOf(question));
    std::erase_if(asked, [&](Choice choice) { return std::ranges::find(all.fixed, choice) == all.fixed.end(); });
    return asked;
  }

  /// The choices that the verdict rests on; for a run, the readings that it needs.
  void nameCircumstances(std::size_t question, ProofResult& row) {
    EncodedScan& encoding = search_.exact().askedProperties().encoding();
    Circumstances found = circumstancesOf(encoding, search_.exact().variablesOf(question));
    for (const Choice choice : fixedChoices(encoding, question, found)) {
      if (std::ranges::find(found.fixed, choice) == found.fixed.end()) found.fixed.push_back(choice);
    }
    row.assumptions = assumptionsOf(found, options_.choices, program_.target);
    if (!row.witness || !options_.evidence) return;
    std::optional<Judge> judge;
    if (question < goals().size()) judge.emplace(program_, options_.choices, search_.assumptions(), goals()[question]);
    for (std::string& text : conditionsOf(found, *row.witness, program_, options_.choices, judge ? &*judge : nullptr))
      row.notes.push_back(std::move(text));
  }

  /// Nothing is decided about an instruction that depends on code which was not read.
  void guardUnreadCode(ProofResult& row) const {
    if (options_.unread == nullptr || options_.unread->empty() || !row.builtin || row.builtin->place == nullptr) return;
    const RuleQuestion& check = *row.builtin;
    const Operands operands = check.operands();
    std::vector<std::string> reasons = options_.unread->reasons(check.place->span, operands);
    if (reasons.empty() && check.other != nullptr) reasons = options_.unread->reasons(check.other->span, operands);
    leaveOpen(row, reasons);
  }

  /// What is not followed to its end leaves every proof open, unless it cannot occur.
  void guardLeftOut(ProofResult& row) {
    if (row.witness || !search_.mayLeaveOut(schedule::premiseSeconds)) return;
    row.outcome = Outcome::NotCovered;
    row.certificate.clear();
    for (const Approximation& approximation : search_.exact().askedProperties().approximations()) {
      if (approximation.leftOut != noNode)
        row.notes.push_back("not followed: " + approximationText(program_, approximation));
    }
  }

  /// A proof about a program that was read along a decision which does not hold is none.
  void guardDecisions(ProofResult& row) {
    if (row.outcome != Outcome::Proved && row.outcome != Outcome::Unreachable) return;
    const auto wrong = search_.wrongDecisions();
    if (wrong.text.empty()) return;
    row.notes.push_back((wrong.areRefuted ? "the proof is refused: " : "") + wrong.text);
    if (!wrong.areRefuted) return;
    row.outcome = Outcome::Unknown;
    row.certificate.clear();
  }

  /// Networks that decide the property: without earlier scans, those of the state that the invariant speaks of.
  std::vector<NetworkName> networksOf(std::size_t question, const QuestionAnswer& answer) {
    const Operands read = addressesOf(question);
    if (!facts_) facts_ = std::make_unique<Facts>(program_, set_.externals);
    std::unordered_set<std::uint32_t> variables;
    if (answer.certificate && answer.certificate->k == 0) {
      std::vector<Node> roots = answer.certificate->invariant;
      roots.push_back(search_.exact().system().questions[question].bad);
      variables = statesUnder(search_.exact().system(), roots);
    } else {
      variables = search_.exact().variablesOf(question);
    }
    if (!networks_) networks_ = std::make_unique<NetworksBehind>(*facts_, search_.exact().askedProperties().encoding());
    return networks_->of(read, variables);
  }

  /// A routine that is attached but whose events the encoding does not know leaves every proof open.
  void guardInterrupts(ProofResult& row) {
    if (row.outcome != Outcome::Proved && row.outcome != Outcome::Unreachable) return;
    if (!unfollowed_) unfollowed_ = unfollowedRoutine(program_, search_.exact().askedProperties().encoding());
    if (!*unfollowed_) return;
    row.outcome = Outcome::NotCovered;
    row.certificate.clear();
    row.notes.push_back(**unfollowed_);
  }

  void unconfirmed(std::size_t question, const QuestionAnswer& answer, ProofResult& row, ProofRun& run) {
    row.outcome = Outcome::Unknown;
    const bool rests =
        answer.usesFreeReals || !search_.exact().approximationsOf(question, search_.isWrittenOut(question)).empty();
    if (rests) {
      row.outcome = Outcome::NotCovered;
      row.notes.push_back(
          "the run that was found rests on values that are not modelled exactly; the engine does not repeat it");
      return;
    }
    if (outlastsWatchdog(*answer.trace)) {
      row.outcome = Outcome::NotCovered;
      row.notes.push_back(
          "execution times are not modelled: a scan of the run that was found takes longer than the watchdog allows");
      return;
    }
    row.notes.push_back("the run that was found is not repeated by the engine: a defect of rungproof");
    run.disagreements.push_back(
        {row.property.name, fmt::format("the solver's run of {} scans is not repeated by the engine", answer.depth + 1),
         bothTracesOf(program_, search_.exact().askedProperties().encoding(), search_.exact().system(), *answer.trace,
                      addressesOf(question))});
  }

  /// Whether the run ends in the engine because a scan takes too long by the times of Appendix F (001:13920).
  bool outlastsWatchdog(const WordTrace& trace) {
    EncodedScan& encoding = search_.exact().askedProperties().encoding();
    const TransitionSystem& system = search_.exact().system();
    const std::optional<Concrete::Store> initial = initialOf(encoding, system, trace);
    const std::vector<RunTimeError> errors =
        replay(program_, options_.choices, scansOf(encoding, system, trace, options_.time),
               initial ? &*initial : nullptr, [](const Concrete::Store&, std::size_t) { return true; })
            .errors;
    return std::ranges::any_of(errors, [](const RunTimeError& e) {
      return e.hazard == Hazard::FatalWatchdog || e.hazard == Hazard::S7CycleTime;
    });
  }

  /// That the question reads.
  Operands addressesOf(std::size_t question) {
    if (question >= goals().size()) return search_.exact().checks()[question - goals().size()].operands();
    Operands read;
    for (const Operand* operand : rungproof::addressesOf(goals()[question])) read.push_back(*operand);
    return read;
  }

  /// A property whose premise can never be met, assumptions that no run meets, or a program that ends no scan prove
  /// nothing.
  void checkVacuity(ProofResult& row, double proofSeconds) {
    if (row.builtin) return;
    if (goalOf_.empty()) {
      for (std::size_t i = 0; i < goals().size(); ++i) goalOf_.emplace(goals()[i].name, i);
    }
    const auto goalNamed = [&](const std::string& name) {
      const auto known = goalOf_.find(name);
      return known == goalOf_.end() ? goals().size() : known->second;
    };
    const std::size_t some = goalNamed(someRun().name), premise = goalNamed(row.property.name + " (premise)");
    const bool assumes = !std::ranges::all_of(set_.properties, [](const Property& p) { return p.isGoal(); });
    // That no run reaches something is true of a program that ends no scan.
    const bool saysNothing = assumes || row.outcome == Outcome::Proved;
    if (saysNothing && some < goals().size() && search_.quick(some).answer == Answer::Proved) {
      row.outcome = Outcome::Vacuous;
      row.notes.push_back(assumes ? "the assumptions contradict each other: no run meets them"
                                  : "no run comes to the end of a scan: each stops or loops before");
      return;
    }
    if (premise == goals().size() || row.outcome != Outcome::Proved) return;
    const double seconds =
        std::clamp(proofSeconds * schedule::premiseShare, schedule::leastPremiseSeconds, schedule::premiseSeconds);
    const Answer answer = search_.supporting(premise, seconds);
    if (answer == Answer::Proved) {
      row.outcome = Outcome::Vacuous;
      row.notes.push_back(fmt::format("the premise '{}' can never be met", goals()[premise].text));
    } else if (answer == Answer::Unknown) {
      row.notes.push_back(fmt::format("no run was found that meets the premise '{}'", goals()[premise].text));
    }
  }

  void noteApproximations(std::size_t question, ProofResult& row) {
    for (const Approximation* approximation :
         search_.exact().approximationsOf(question, search_.isWrittenOut(question))) {
      if (row.outcome == Outcome::Unknown) row.outcome = Outcome::NotCovered;
      row.notes.push_back("depends on " + approximationText(program_, *approximation));
      noted_.insert(approximation);
    }
  }

  const Program& program_;
  const PropertySet& set_;
  const ProverOptions& options_;
  const Clock::time_point begin_ = Clock::now();
  QuestionSearch search_;
  std::unique_ptr<Facts> facts_;
  std::unique_ptr<NetworksBehind> networks_;
  std::unordered_map<std::string, std::size_t> goalOf_;  ///< the first of each name
  std::unique_ptr<QuestionSystem> open_;                 ///< the program under all readings, those of fixed choices too
  std::optional<bool> hasAnyValues_;
  std::optional<std::optional<std::string>> unfollowed_;  ///< of an attached routine, once it was asked
  std::set<const Approximation*> noted_;                  ///< what some result rests on
};

/// Results of both in the order in which the set declares its goals, then those of built-in checks.
ProofRun merged(const PropertySet& set, ProofRun plain, ProofRun inside) {
  std::vector<ProofResult> results;
  auto ofPlain = plain.results.begin(), ofInside = inside.results.begin();
  const auto isNext = [](const auto& next, const auto& end, const Property& property) {
    return next != end && !next->builtin && next->property.span == property.span &&
           next->property.name == property.name;
  };
  for (const Property& property : set.properties) {
    if (!property.isGoal()) continue;
    if (isNext(ofPlain, plain.results.end(), property))
      results.push_back(std::move(*ofPlain++));
    else if (isNext(ofInside, inside.results.end(), property))
      results.push_back(std::move(*ofInside++));
  }
  results.insert(results.end(), std::make_move_iterator(ofPlain), std::make_move_iterator(plain.results.end()));
  results.insert(results.end(), std::make_move_iterator(ofInside), std::make_move_iterator(inside.results.end()));
  plain.results = std::move(results);
  for (std::string& text : inside.approximations) {
    if (std::ranges::find(plain.approximations, text) == plain.approximations.end())
      plain.approximations.push_back(std::move(text));
  }
  plain.disagreements.insert(plain.disagreements.end(), inside.disagreements.begin(), inside.disagreements.end());
  plain.isInterrupted = plain.isInterrupted || inside.isInterrupted;
  add(plain.techniques, inside.techniques);
  return plain;
}

/// What is asked inside scans needs interrupts and 1 ms ticks in front of many instructions; all else is proved on a
/// system without them.
ProofRun proveInParts(const Program& program, const PropertySet& set, const ProverOptions& options,
                      const ProofProgress& progress) {
  PropertySet plain = set, inside = set;
  std::erase_if(plain.properties, [](const Property& p) { return p.isGoal() && p.atEveryInstruction; });
  std::erase_if(inside.properties, [](const Property& p) { return p.isGoal() && !p.atEveryInstruction; });
  const std::size_t later = goalCount(inside);
  if (later == 0 || (goalCount(plain) == 0 && !options.checks.any()))
    return Session(program, set, options).run(progress);
  std::size_t before = 0;
  bool goesOn = true;
  ProofRun first =
      Session(program, plain, options).run([&](const ProofResult& row, std::size_t done, std::size_t total) {
        before = total;
        goesOn = !progress || progress(row, done, total + later);
        return goesOn;
      });
  if (!goesOn) return first;
  ProverOptions rest = options;
  rest.checks = {};
  return merged(set, std::move(first),
                Session(program, inside, rest).run([&](const ProofResult& row, std::size_t done, std::size_t total) {
                  return !progress || progress(row, before + done, before + total);
                }));
}

/// Where an error of ours ends what is done for all questions together, each is asked alone.
ProofRun proveApart(const Program& program, const PropertySet& set, const ProverOptions& options,
                    const ProofProgress& progress) {
  const std::size_t goals = goalCount(set), total = goals + (options.checks.any() ? 1 : 0);
  try {
    return proveInParts(program, set, options, progress);
  } catch (const std::exception& error) {
    if (total <= 1) {
      ProofRun run;
      run.assumptions = environmentTexts(program, set, options.time, options.choices);
      ProofResult& row = run.results.emplace_back();
      const auto goal = std::ranges::find_if(set.properties, [](const Property& p) { return p.isGoal(); });
      if (goal != set.properties.end())
        row.property = *goal;
      else
        row.property.name = "built-in checks";
      breakOff(row, error);
      if (progress) progress(row, 1, 1);
      return run;
    }
  }
  std::optional<ProofRun> whole;
  std::size_t done = 0;
  bool goesOn = true;
  const auto add = [&](const PropertySet& one, const ProverOptions& own) {
    if (!goesOn) return;
    ProofRun run = proveApart(program, one, own, [&](const ProofResult& row, std::size_t, std::size_t) {
      goesOn = !progress || progress(row, done + 1, total);
      return goesOn;
    });
    ++done;
    whole = whole ? merged(set, std::move(*whole), std::move(run)) : std::move(run);
  };
  ProverOptions plain = options;
  plain.checks = {};
  PropertySet none = set;
  std::erase_if(none.properties, [](const Property& p) { return p.isGoal(); });
  for (const Property& property : set.properties) {
    if (!property.isGoal()) continue;
    PropertySet one = none;
    one.properties.push_back(property);
    add(one, plain);
  }
  if (options.checks.any()) add(none, options);
  return std::move(*whole);
}

/// Why none of the properties can be settled: a statement about the world could not be read, an assumption speaks of
/// what unread code may write, or anything may be written.
std::vector<std::string> reasonsForAll(const Program& program, const PropertySet& set, const UnreadCode* unread) {
  std::vector<std::string> reasons;
  for (const UnreadStatement& statement : set.unread)
    reasons.push_back(fmt::format(
        "'{}' ({}:{}) could not be read: it may be an assumption, or say what is written from outside", statement.text,
        program.sources->file(statement.span.file).name(), program.sources->position(statement.span).line));
  if (!reasons.empty() || unread == nullptr) return reasons;
  reasons = unread->reasons();
  for (const Property& property : set.properties) {
    if (property.isGoal() || !reasons.empty()) continue;
    reasons = unread->reasons(property);
    if (!reasons.empty()) reasons.insert(reasons.begin(), fmt::format("the assumption '{}' is open", property.text));
  }
  return reasons;
}

ProofRun proveAll(const Program& program, const PropertySet& set, const ProverOptions& options,
                  const ProofProgress& progress) {
  if (set.unread.empty() && (options.unread == nullptr || options.unread->empty())) {
    ProofRun run = proveApart(program, set, options, progress);
    noteUntouched(program, set, options, run.results, proveInParts, breakOff);
    return run;
  }
  const std::vector<std::string> forAll = reasonsForAll(program, set, options.unread);
  PropertySet covered = set;
  std::vector<ProofResult> open;
  std::erase_if(covered.properties, [&](const Property& property) {
    if (!property.isGoal()) return false;
    const std::vector<std::string> reasons = forAll.empty() ? options.unread->reasons(property) : forAll;
    if (reasons.empty()) return false;
    ProofResult& row = open.emplace_back();
    row.property = property;
    row.notes = property.remarks;
    leaveOpen(row, reasons);
    return true;
  });
  ProofRun result;
  ProverOptions rest = options;
  if (!forAll.empty() && options.checks.any()) {
    rest.checks = {};
    ProofResult& row = open.emplace_back();
    row.property.name = "built-in checks";
    leaveOpen(row, forAll);
  }
  if (goalCount(covered) > 0 || rest.checks.any()) {
    result = proveApart(program, covered, rest, [&](const ProofResult& row, std::size_t done, std::size_t total) {
      return !progress || progress(row, open.size() + done, open.size() + total);
    });
    noteUntouched(program, set, options, result.results, proveInParts, breakOff);
  } else {
    result.assumptions = environmentTexts(program, set, options.time, options.choices);
  }
  result = merged(set, std::move(result), ProofRun{std::move(open), {}, {}, {}});
  if (forAll.empty()) result.assumptions.push_back("what is not executed does not stop the CPU");
  return result;
}

}  // namespace

/// What blocks without text write at any time is memory that is written from outside.
ProofRun prove(const Program& program, const PropertySet& set, const ProverOptions& given,
               const ProofProgress& progress) {
  ProverOptions options = given;
  options.choices = choicesFor(program.target, given.choices);
  if (!assumesOfCalls(program)) return proveAll(program, set, options, progress);
  const Facts facts(program, set.externals);
  PropertySet open = set;
  std::ranges::move(externalsOfCalls(facts), std::back_inserter(open.externals));
  std::optional<UnreadCode> unread;  // of a caller that does not look for it; accumulators hand on what is left out
  if (formOf(program.target) != StatementForm::Accumulators && options.unread == nullptr)
    options.unread = &unread.emplace(program, options.choices);
  ProofRun run = proveAll(program, open, options, progress);
  std::ranges::move(assumptionsOfCalls(facts), std::back_inserter(run.assumptions));
  return run;
}

}  // namespace rungproof
