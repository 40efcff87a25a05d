// Cones are copies: what a stage adds to its bits afterwards does not reach the engines.
#include "analysis/portfolio/cone_race.hpp"

#include <utility>

#include "analysis/schedule/schedule.hpp"

namespace rungproof {

ConeRace::ConeRace(const TransitionSystem& system, BitBlast& blast, const Invariants& invariants,
                   const Questions& questions, const std::vector<QuestionAnswer>& answers,
                   const PortfolioOptions& options)
    : system_(system),
      mayUseWords_(blast.unmodelled().empty()),  // certificates leave REAL operations open
      seed_(options.seed) {
  std::vector<Lit> wanted;
  for (const std::vector<Lit>& clause : invariants.clauses) wanted.insert(wanted.end(), clause.begin(), clause.end());
  std::vector<RaceQuestion> contests;
  for (const std::size_t q : questions) {
    Contestant& contestant = contestants_.emplace_back(
        q, makeCone(blast.bits(), {blast.badOf(q)}, blast.isTotal(), invariants.equal, wanted));
    RaceQuestion& contest = contests.emplace_back();
    contest.system = &contestant.cone.system;
    contest.invariants = contestant.cone.translated(invariants.clauses);
    contest.verdict.depth = answers[q].depth;
    if (options.effort != Effort::Apart || q < options.ofMany) continue;
    contest.share = schedule::ruleRaceShare;
    for (const Technique technique : {Technique::HeldInputs, Technique::KInduction})
      contest.techniques.leaveOut(technique);
  }
  race_ = std::make_unique<Race>(std::move(contests),
                                 RaceOptions{options.jobs, options.seed, options.bound, options.cancel, options.log});
}

void ConeRace::run(const RaceRun& run) {
  std::vector<RaceQuestion>& contests = race_->questions();
  const bool areWordsWanted = mayUseWords_ && run.techniques.has(Technique::WordIc3);
  for (std::size_t i = 0; i < contests.size(); ++i) {
    Contestant& contestant = contestants_[i];
    contestant.seconds = -contests[i].seconds;
    const auto size = static_cast<double>(contestant.cone.system.gates.size());
    if (!areWordsWanted || contestant.words || size > schedule::wordEngineCone * run.seconds) continue;
    EngineOptions options;
    options.seed = seed_;
    contestant.words = makeWordEngine(system_, contestant.question, options);
    contests[i].words = contestant.words.get();
  }
  race_->run(run);
  for (std::size_t i = 0; i < contests.size(); ++i) {
    Contestant& contestant = contestants_[i];
    contestant.seconds += contests[i].seconds;
    contestant.verdict = contests[i].verdict;
    if (contestant.verdict.answer == Answer::Unknown) contestant.verdict.method = enginesOf(run.techniques);
  }
}

}  // namespace rungproof
