// What can be settled on a property's surface, then the stages on the merged system and, where that leaves questions
// open, on the capped one; then the certificates, which are about the given system, are checked.
#include "analysis/portfolio/portfolio.hpp"

#include <algorithm>

#include "analysis/bits/bit_blast.hpp"
#include "analysis/bits/engine_contract.hpp"
#include "analysis/graph/evaluate.hpp"
#include "analysis/portfolio/absorption.hpp"
#include "analysis/portfolio/first_scan.hpp"
#include "analysis/portfolio/local_proof.hpp"
#include "analysis/portfolio/merging.hpp"
#include "analysis/portfolio/stages.hpp"
#include "analysis/portfolio/word_caps.hpp"
#include "analysis/portfolio/word_runs.hpp"
#include "analysis/schedule/schedule.hpp"
#include "ir/check.hpp"

namespace rungproof {

namespace {

/// What is settled on the surface, then what is left on the merged system, then the certificates about the given one.
class Answers {
 public:
  Answers(const TransitionSystem& system, const PortfolioOptions& options)
      : system_(system), options_(options), answers_(system.questions.size()) {}

  std::vector<QuestionAnswer> run(const Questions& questions) {
    find(withoutWordRuns(questions));
    if (options_.check) checkCertificates();
    return std::move(answers_);
  }

 private:
  void find(const Questions& questions) {
    const Budget budget = options_.budget();
    Questions open;
    for (const std::size_t q : questions) {
      if (!settleLocally(q, budget) && !searchFirstScan(q) && !searchUnabsorbed(q)) open.push_back(q);
    }
    if (!open.empty() && options_.effort != Effort::Surface) {
      const auto begin = Budget::Clock::now();
      const MergedSystem merged = merge(open, budget);
      const double each =
          std::chrono::duration<double>(Budget::Clock::now() - begin).count() / static_cast<double>(open.size());
      std::vector<QuestionAnswer> found = search(merged.system, open);
      for (const std::size_t q : open) {
        found[q].seconds += each;
        answers_[q] = onGivenSystem(q, std::move(found[q]), merged);
      }
    }
  }
  /// Those for which no run on numbers is found. They are made once, while all questions are treated at once.
  Questions withoutWordRuns(const Questions& questions) {
    if (options_.effort != Effort::Together || options_.bound > 0 || !options_.techniques.has(Technique::Simulation))
      return questions;
    TechniqueTurn turn(options_.log, Technique::Simulation, questions.size());
    const auto begin = Budget::Clock::now();
    std::vector<std::optional<WordTrace>> runs = wordRuns(system_, questions, options_.seed, options_.budget());
    Questions open;
    for (std::size_t i = 0; i < questions.size(); ++i) {
      if (!runs[i]) {
        open.push_back(questions[i]);
        continue;
      }
      QuestionAnswer& answer = answers_[questions[i]];
      answer.answer = Answer::Violated;
      answer.method = "simulation";
      answer.depth = static_cast<int>(runs[i]->inputs.size()) - 1;
      answer.trace = std::move(runs[i]);
      answer.seconds = std::chrono::duration<double>(Budget::Clock::now() - begin).count();
      turn.settled();
    }
    return open;
  }

  /// The search in another system that stands for this one as far as the question is concerned.
  template <class System>
  void searchIn(const System& other, Technique technique, std::size_t q) {
    TechniqueTurn turn(options_.log, technique, 1);
    PortfolioOptions options = options_;
    // What leaves nodes open would leave open what the two systems have in common.
    for (const Technique t : {Technique::OneScan, Technique::FirstScan, Technique::Absorption})
      options.techniques.leaveOut(t);
    Answers inner(other.system, options);
    inner.find({q});
    answers_[q] = onGivenSystem(std::move(inner.answers_[q]), other);
    if (answers_[q].answer != Answer::Unknown) turn.settled();
  }

  bool searchFirstScan(std::size_t q) {
    if (options_.effort == Effort::Surface || !options_.techniques.has(Technique::FirstScan)) return false;
    const std::optional<FirstScanSystem> first = inFirstScan(system_, q);
    if (first) searchIn(*first, Technique::FirstScan, q);
    return first.has_value();
  }
  /// Where it has come to, the run begins.
  QuestionAnswer onGivenSystem(QuestionAnswer answer, const FirstScanSystem& first) const {
    Graph& graph = *system_.graph;
    answer.depth = answer.answer == Answer::Violated ? 0 : answer.depth;
    if (answer.certificate) {
      std::vector<Node> facts = first.starts;
      facts.insert(facts.end(), answer.certificate->invariant.begin(), answer.certificate->invariant.end());
      answer.certificate.emplace();
      for (const Node n : facts) answer.certificate->invariant.push_back(graph.make(Op::Or, 1, first.isLater, n));
    }
    if (answer.trace) {
      for (std::size_t s = 0; s < system_.states.size(); ++s) {
        const Node init = system_.states[s].init;
        if (init != noNode && graph[init].op == Op::Constant) answer.trace->initial[s] = graph[init].value;
      }
      answer.trace->inputs.erase(answer.trace->inputs.begin(), answer.trace->inputs.end() - 1);
    }
    return answer;
  }

  /// Without the scans after which the question can no longer be bad, where there are such. Not while all questions are
  /// treated at once.
  bool searchUnabsorbed(std::size_t q) {
    if (options_.effort < Effort::Mined || !options_.techniques.has(Technique::Absorption)) return false;
    const std::optional<UnabsorbedSystem> unabsorbed = beforeAbsorption(system_, q);
    if (unabsorbed) searchIn(*unabsorbed, Technique::Absorption, q);
    return unabsorbed.has_value();
  }
  QuestionAnswer onGivenSystem(QuestionAnswer answer, const UnabsorbedSystem& unabsorbed) const {
    Graph& graph = *system_.graph;
    if (answer.certificate) {
      for (Node& n : answer.certificate->invariant) n = graph.make(Op::Or, 1, unabsorbed.latched, n);
      for (Node& n : answer.certificate->immediate) n = graph.make(Op::Or, 1, unabsorbed.latched, n);
    }
    if (answer.trace) {
      for (const auto& [input, value] : unabsorbed.fixedInputs) {
        for (std::vector<std::uint64_t>& scan : answer.trace->inputs) scan[input] = value;
      }
    }
    return answer;
  }

  /// Without time nothing is merged.
  MergedSystem merge(const Questions& open, const Budget& budget) const {
    if (!options_.techniques.has(Technique::Merging)) return mergeStates(system_, open, options_.seed, budget.slice(0));
    const TechniqueTurn turn(options_.log, Technique::Merging, open.size());
    const double seconds = options_.seconds * static_cast<double>(open.size()) * schedule::mergeShare;
    return mergeStates(system_, open, options_.seed, budget.slice(std::min(seconds, schedule::mostMerging)));
  }
  bool settleLocally(std::size_t q, const Budget& budget) {
    if (!options_.techniques.has(Technique::OneScan)) return false;
    TechniqueTurn turn(options_.log, Technique::OneScan, 1);
    const auto begin = Budget::Clock::now();
    const std::optional<std::vector<Node>> open = proveLocally(system_, system_.questions[q].bad, budget);
    if (!open) return false;
    turn.settled();
    QuestionAnswer& answer = answers_[q];
    answer.answer = Answer::Proved;
    answer.method = "one scan";
    answer.certificate = WordCertificate{};
    answer.certificate->open = *open;
    answer.seconds = std::chrono::duration<double>(Budget::Clock::now() - begin).count();
    return true;
  }

  /// The portfolio on the system as it is; where that leaves questions open, what is left of the time on the capped
  /// one.
  std::vector<QuestionAnswer> search(const TransitionSystem& system, const Questions& asked) const {
    if (options_.effort < Effort::Apart || !options_.check || !options_.techniques.has(Technique::WordCaps) ||
        std::min(options_.seconds, options_.left()) < schedule::leastForBoth)
      return runStages(system, asked, options_);
    PortfolioOptions first = options_;
    first.seconds *= schedule::uncappedShare;
    if (first.deadline) {
      const std::chrono::duration<double> most(options_.left() * schedule::uncappedShare);
      first.deadline = Budget::Clock::now() + std::chrono::duration_cast<Budget::Clock::duration>(most);
    }
    std::vector<QuestionAnswer> answers = runStages(system, asked, first);
    Questions open;
    for (const std::size_t q : asked) {
      if (answers[q].answer == Answer::Unknown) open.push_back(q);
    }
    const Budget budget = options_.budget();
    if (open.empty() || budget.isExhausted()) return answers;
    TechniqueTurn turn(options_.log, Technique::WordCaps, open.size());
    const CappedSystem capped = capWords(system, open, budget.slice(options_.seconds * schedule::mergeShare));
    if (capped.words.empty()) return answers;
    PortfolioOptions second = options_;
    second.seconds *= 1 - schedule::uncappedShare;
    std::vector<QuestionAnswer> found = runStages(capped.system, open, second);
    for (const std::size_t q : open) {
      found[q].seconds += answers[q].seconds;
      found[q].depth = std::max(found[q].depth, answers[q].depth);
      if (found[q].answer == Answer::Unknown) continue;
      if (found[q].certificate && !onWholeWords(system, system.questions[q], *found[q].certificate, capped)) continue;
      answers[q] = std::move(found[q]);
      turn.settled();
    }
    return answers;
  }

  /// The certificate about the system with whole words; false if it rests on states being different or on sums, which
  /// it cannot say.
  static bool onWholeWords(const TransitionSystem& system, const Question& question, WordCertificate& certificate,
                           const CappedSystem& capped) {
    if (certificate.simplePath || !certificate.sums.empty()) return false;
    Graph& graph = *system.graph;
    const auto whole = [&](Node& n) { n = capped.onGivenSystem(graph, n); };
    for (Node& n : certificate.invariant) whole(n);
    for (Node& n : certificate.immediate) whole(n);
    for (KeptDifference& d : certificate.differences) {
      for (Node* n : {&d.left.word, &d.left.increment, &d.left.next, &d.right.word, &d.right.increment, &d.right.next,
                      &d.difference})
        whole(*n);
    }
    std::vector<Replaced> ranges;
    for (const CappedWord& word : capped.words) ranges.push_back({.word = word.given, .equation = word.range});
    std::vector<Node> roots = certificate.invariant;
    roots.push_back(question.bad);
    roots.insert(roots.end(), system.constraints.begin(), system.constraints.end());
    const std::vector<Node> facts = factsBehind(system, ranges, roots);
    certificate.invariant.insert(certificate.invariant.begin(), facts.begin(), facts.end());
    certificate.immediate.insert(certificate.immediate.begin(), facts.begin(), facts.end());
    return true;
  }

  QuestionAnswer onGivenSystem(std::size_t q, QuestionAnswer answer, const MergedSystem& merged) const {
    if (answer.certificate) {
      std::vector<Node> roots = answer.certificate->invariant;
      roots.push_back(system_.questions[q].bad);
      roots.insert(roots.end(), system_.constraints.begin(), system_.constraints.end());
      std::vector<Node> facts = factsBehind(system_, merged.facts, roots);
      if (options_.log != nullptr && !facts.empty()) options_.log->add(Technique::Merging, {0, 1, 0});
      std::vector<Node>& invariant = answer.certificate->invariant;
      invariant.insert(invariant.begin(), facts.begin(), facts.end());
      answer.certificate->immediate.insert(answer.certificate->immediate.begin(), facts.begin(), facts.end());
    }
    if (answer.trace) {
      std::vector<std::uint64_t> initial;
      for (const StateVariable& state : system_.states)
        initial.push_back(state.init == noNode ? 0 : (*system_.graph)[state.init].value);
      for (std::size_t i = 0; i < merged.kept.size(); ++i) initial[merged.kept[i]] = answer.trace->initial[i];
      answer.trace->initial = std::move(initial);
    }
    return answer;
  }

  /// A proof whose certificate Z3 does not confirm is not reported as one.
  void checkCertificates() {
    std::vector<std::size_t> certified;
    std::vector<Claim> claims;
    for (std::size_t q = 0; q < answers_.size(); ++q) {
      if (!answers_[q].certificate) continue;
      certified.push_back(q);
      claims.push_back({&system_.questions[q], &*answers_[q].certificate});
    }
    if (certified.empty()) return;
    // What was found before an interruption is worth a short look.
    const bool isCancelled = options_.cancel != nullptr && options_.cancel->load(std::memory_order_relaxed);
    CheckLimits limits;
    limits.each = std::max(options_.seconds, schedule::leastForCertificate);
    limits.total = isCancelled         ? schedule::leastCheck
                   : options_.deadline ? std::max(options_.left(), schedule::leastCheck)
                                       : 1e9;
    limits.memory = options_.memory;
    limits.cancel = isCancelled ? nullptr : options_.cancel;
    const auto begin = Budget::Clock::now();
    const std::vector<CheckResult> results = checked(claims, certified, limits);
    const double each =
        std::chrono::duration<double>(Budget::Clock::now() - begin).count() / static_cast<double>(certified.size());
    for (const std::size_t q : certified) answers_[q].seconds += each;
    for (std::size_t i = 0; i < certified.size(); ++i) {
      if (results[i] == CheckResult::Valid) continue;
      const bool isWrong = results[i] == CheckResult::Invalid;
      CHECK(!isWrong || restsOnReals(system_.questions[certified[i]]), "a certificate is wrong");
      QuestionAnswer& answer = answers_[certified[i]];
      answer.answer = Answer::Unknown;
      answer.method +=
          isWrong ? " (certificate rests on results of REAL operations)" : " (certificate not checked in time)";
      answer.certificate.reset();
    }
  }

  /// Whether there is a REAL operation of which the check knows nothing, while a reduction computes it where it knows
  /// all values that its operand takes (graph/value_set.hpp): COS of a word that is 0, or 1.0 after that.
  bool restsOnReals(const Question& question) const {
    std::vector<Node> roots = system_.constraints;
    roots.push_back(question.bad);
    for (const StateVariable& state : system_.states) roots.push_back(state.next);
    return std::ranges::any_of(coneOf(*system_.graph, roots),
                               [&](Node n) { return (*system_.graph)[n].op >= Op::RealAdd; });
  }

  /// By the judge if there is one, and the rest against the given system.
  std::vector<CheckResult> checked(const std::vector<Claim>& claims, const std::vector<std::size_t>& questions,
                                   const CheckLimits& limits) {
    std::vector<CheckResult> results(claims.size(), CheckResult::Unknown);
    if (options_.judge) {
      CheckLimits most = limits;
      if (limits.total < 1e9) most.total *= schedule::judgeShare;
      results = options_.judge(claims, most);
    }
    CertificateWriter writer(system_);
    std::vector<std::size_t> rest;
    for (std::size_t i = 0; i < claims.size(); ++i) {
      if (results[i] == CheckResult::Valid) {
        answers_[questions[i]].isJudged = true;
        continue;
      }
      rest.push_back(i);
      writer.add(*claims[i].question, *claims[i].certificate);
    }
    if (rest.empty()) return results;
    CheckLimits left = limits;
    if (limits.total < 1e9 && options_.deadline) left.total = std::max(options_.left(), schedule::leastCheck);
    const std::vector<CheckResult> own = writer.check(left);
    for (std::size_t i = 0; i < rest.size(); ++i) results[rest[i]] = own[i];
    return results;
  }

  const TransitionSystem& system_;
  const PortfolioOptions& options_;
  std::vector<QuestionAnswer> answers_;
};

}  // namespace

std::optional<WordTrace> shallowSearch(const TransitionSystem& system, int depth, double seconds) {
  // Where others take most of the machine, ten times as long is enough of waiting.
  const Budget budget = Budget::ofThread(seconds, Budget::seconds(10 * seconds));
  try {
    const BitBlast blast(system, {0}, {}, &budget);
    EngineOptions options;
    options.bound = depth;
    const Verdict verdict = makeBmc(blast.bits(), options)->advance(budget);
    if (verdict.answer == Answer::Violated) return blast.wordTrace(*verdict.trace);
  } catch (const OutOfBudget&) {
    return std::nullopt;
  }
  return std::nullopt;
}

std::vector<QuestionAnswer> answerQuestions(const TransitionSystem& system, const Questions& questions,
                                            const PortfolioOptions& options) {
  return Answers(system, options).run(questions);
}

}  // namespace rungproof
