// Asks again, of the systems as they are written.
#include "analysis/equivalence/equality_proof.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

#include "analysis/proof/told_proof.hpp"

namespace rungproof {

namespace {
constexpr double quickProof = 2;  ///< seconds for each question while all are asked together

bool hasReals(const TransitionSystem& system) {
  const Graph& graph = *system.graph;
  for (std::size_t i = 0; i < graph.size(); ++i) {
    if (isRealOperation(graph[static_cast<Node>(i)].op)) return true;
  }
  return false;
}

}  // namespace

TransitionSystem withWrittenReals(const TransitionSystem& system, RealScope scope) {
  return hasReals(system) ? withExactReals(system, scope) : system;
}

EqualityProof::EqualityProof(ProgramProduct& written, const std::vector<std::string>& names,
                             const Correspondence& found, Ask ask, double seconds, bool withRequests)
    : conditions_(found.conditions), ask_(std::move(ask)), seconds_(seconds), withRequests_(withRequests) {
  std::unordered_map<std::string, bool> known;
  for (std::size_t i = 0; i < names.size(); ++i) known.emplace(names[i], found.isMerged[i]);
  const std::vector<std::string> own = written.newStateNames();
  std::vector<bool> merges;
  for (std::size_t i = 0; i < own.size(); ++i) {
    const auto state = known.find(own[i]);
    merges.push_back(!own[i].empty() && written.isMergeable(i) && state != known.end() && state->second);
  }
  const JoinedSystem joined = written.merged(merges, true, conditions_);
  writeMemory(joined, own);
  writeOutputs(written, joined, merges);
  writeTold(written.oldSystem(), written.oldSide().encoding(), "OLD");
  writeTold(written.newSystem(), written.newSide().encoding(), "NEW");
}

void EqualityProof::writeTold(const TransitionSystem& system, const EncodedScan& encoding, const std::string& side) {
  ToldProof proof(system, encoding.toldFacts(), encoding.keptCells(), encoding.approximations().empty());
  if (proof.check({.each = seconds_, .total = 3 * seconds_}) != CheckResult::Valid)
    missing_.push_back(fmt::format("what the encoding of {} was told: {}", side, proof.reason()));
  else if (std::string text = proof.text(); !text.empty())
    certificates_.emplace_back("decisions_" + side, std::move(text));
}

std::vector<Question> EqualityProof::prove(const TransitionSystem& system, const std::vector<Question>& questions,
                                           double longest, CertificateWriter& writer) {
  std::vector<Question> open = questions;
  for (const auto& [each, effort] : {std::pair{quickProof, Effort::Together}, std::pair{longest, Effort::Full}}) {
    if (open.empty()) break;
    TransitionSystem asked = system;
    asked.questions = open;
    const std::vector<QuestionAnswer> answers = ask_(asked, each, effort);
    std::vector<Question> still;
    for (std::size_t i = 0; i < open.size(); ++i) {
      if (answers[i].answer == Answer::Proved && answers[i].certificate)
        writer.add(open[i], *answers[i].certificate);
      else
        still.push_back(open[i]);
    }
    open = std::move(still);
  }
  return open;
}

void EqualityProof::writeMemory(const JoinedSystem& joined, const std::vector<std::string>& names) {
  std::vector<Question> questions;
  for (std::size_t i = 0; i < joined.nextDiffers.size(); ++i) {
    if (joined.nextDiffers[i] != noNode)
      questions.push_back({"what stands for " + names[i] + " ends a scan with another value", joined.nextDiffers[i]});
  }
  for (std::size_t i = 0; i < joined.conditionBreaks.size(); ++i) {
    const PairCondition& condition = conditions_[i];
    const std::string what = condition.condition.empty()
                                 ? condition.state + " does not hold at the end of a scan"
                                 : "what stands for " + condition.state + " ends a scan with another value and " +
                                       condition.condition + (condition.when ? " 1" : " 0");
    questions.push_back({what, joined.conditionBreaks[i]});
  }
  std::vector<Question> open;
  for (const RealScope scope : {RealScope::Comparisons, RealScope::All}) {
    TransitionSystem system = joined.system;
    system.questions = questions;
    system = withWrittenReals(system, scope);
    CertificateWriter writer(system);
    writer.addStart("pairs start equal", joined.starts);
    open = prove(system, system.questions, seconds_, writer);
    if (!open.empty() && scope == RealScope::Comparisons && hasReals(system)) continue;
    certificates_.emplace_back("memory", writer.text());
    break;
  }
  for (const Question& question : open) missing_.push_back(question.name);
}

bool EqualityProof::writeOutput(const TransitionSystem& given, const Question& question, double longest) {
  for (const RealScope scope : {RealScope::Comparisons, RealScope::All}) {
    TransitionSystem system = given;
    system.questions = {question};
    system = withWrittenReals(system, scope);
    CertificateWriter writer(system);
    if (!prove(system, system.questions, longest, writer).empty()) continue;
    certificates_.emplace_back(question.name.substr(0, question.name.find(' ')), writer.text());
    return true;
  }
  return false;
}

void EqualityProof::writeOutputs(ProgramProduct& written, const JoinedSystem& joined,
                                 const std::vector<bool>& isMerged) {
  const auto questionsOf = [&](const JoinedSystem& system) {
    std::vector<Question> questions = outputQuestions(system);
    if (!withRequests_) return questions;
    for (Question& question : requestQuestions(system)) questions.push_back(std::move(question));
    return questions;
  };
  std::optional<JoinedSystem> both;
  for (const Question& question : questionsOf(joined)) {
    if (writeOutput(joined.system, question, quickProof)) continue;
    if (!both) both = written.merged(isMerged, false, conditions_);
    const std::vector<Question> again = questionsOf(*both);
    const auto same = std::ranges::find(again, question.name, &Question::name);
    if (same == again.end() || !writeOutput(both->system, *same, seconds_)) missing_.push_back(question.name);
  }
}

}  // namespace rungproof
