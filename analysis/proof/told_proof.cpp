// What the facts rest on is followed through the next-state functions, from cell to cell of which something was known.
#include "analysis/proof/told_proof.hpp"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

#include "analysis/encoding/exact_reals.hpp"
#include "analysis/graph/evaluate.hpp"
#include "analysis/portfolio/portfolio.hpp"
#include "analysis/schedule/schedule.hpp"

namespace rungproof {

namespace {

Node conjunction(Graph& graph, const std::vector<Node>& facts) {
  Graph::Bool all = graph.constant(true);
  for (const Node fact : facts) all = graph.land(all, {fact});
  return all.node;
}

/// What is known of cells under the roots, under the next values of these, and so on; `isMeant`: of which.
template <class IsMeant>
std::vector<Node> knownBehind(const TransitionSystem& system, const ToldFacts& told, std::vector<Node> roots,
                              IsMeant&& isMeant) {
  std::unordered_map<std::uint32_t, Node> next;
  for (const StateVariable& state : system.states) next.emplace(indexOf(state.node), state.next);
  std::unordered_set<std::uint32_t> seen;
  std::vector<Node> facts;
  while (!roots.empty()) {
    const Node n = roots.back();
    roots.pop_back();
    if (n == noNode || !seen.insert(indexOf(n)).second) continue;
    const NodeData& node = (*system.graph)[n];
    roots.insert(roots.end(), node.child.begin(), node.child.end());
    const auto known = told.known.find(indexOf(n));
    const auto state = next.find(indexOf(n));
    if (known == told.known.end() || state == next.end() || !isMeant(n)) continue;
    facts.insert(facts.end(), known->second.begin(), known->second.end());
    roots.insert(roots.end(), known->second.begin(), known->second.end());  // they may speak of the first scan
    roots.push_back(state->second);
  }
  return facts;
}

}  // namespace

ToldProof::ToldProof(const TransitionSystem& system, const ToldFacts& told, const std::vector<KeptCell>& kept,
                     bool isExact)
    : system_(system), isExact_(isExact) {
  std::unordered_set<Node> keeps;
  for (const KeptCell& cell : kept) keeps.insert(cell.node);
  const auto add = [&](const char* name, const std::vector<Node>& facts, bool isRefutable, auto&& isMeant) {
    if (facts.empty()) return;
    parts_.push_back({name, conjunction(*system_.graph, facts), isRefutable, {}});
    parts_.back().invariant.invariant = knownBehind(system_, told, {parts_.back().fact}, isMeant);
  };
  // Simplification knows of cells that keep their value; only what leads pointers rests on the values of others.
  add("known conditions", told.conditions, false, [&](Node n) { return keeps.contains(n); });
  add("effects of interrupt routines", told.effects, true, [&](Node n) { return keeps.contains(n); });
  add("targets of pointers", told.pointers, true, [](Node) { return true; });
}

Question ToldProof::questionOf(const Part& part) const {
  return {std::string("what the encoding was told, ") + part.name, system_.graph->lnot({part.fact}).node};
}

void ToldProof::addPart(CertificateWriter& writer, const Part& part) const {
  if (part.found) return writer.add(questionOf(part), *part.found);
  writer.addInvariant(questionOf(part).name, part.invariant);
  writer.addConsequence(part.name, part.invariant, part.fact);
}

/// Parts whose own invariants are not enough are questions to the engines like any other. Whether a proof was found.
bool ToldProof::search(const CheckLimits& limits) {
  TransitionSystem asked = system_;
  asked.questions.clear();
  std::vector<Part*> open;
  for (Part& part : parts_) {
    if (part.isShown) continue;
    open.push_back(&part);
    asked.questions.push_back(questionOf(part));
  }
  PortfolioOptions options;
  options.seconds = std::min({schedule::toldSearch, limits.each, limits.total});
  options.deadline =
      Budget::Clock::now() + std::chrono::duration_cast<Budget::Clock::duration>(
                                 std::chrono::duration<double>(options.seconds * static_cast<double>(open.size())));
  options.memory = limits.memory;
  options.cancel = limits.cancel;
  options.check = false;
  const std::vector<QuestionAnswer> answers = answerQuestions(asked, options);
  bool isFound = false;
  for (std::size_t i = 0; i < open.size(); ++i) {
    open[i]->isFalse = answers[i].answer == Answer::Violated;
    if (answers[i].answer != Answer::Proved || !answers[i].certificate) continue;
    open[i]->found = answers[i].certificate;
    isFound = true;
  }
  return isFound;
}

/// Of the parts that are not shown yet.
void ToldProof::checkParts(const CheckLimits& limits) {
  CertificateWriter writer(system_);
  std::vector<Part*> open;
  for (Part& part : parts_) {
    if (part.isShown) continue;
    open.push_back(&part);
    addPart(writer, part);
  }
  const std::vector<CheckResult> results = writer.check(limits);
  std::size_t next = 0;
  for (Part* part : open) {
    const CheckResult first = results[next++], second = part->found ? first : results[next++];
    part->isShown = first == CheckResult::Valid && second == CheckResult::Valid;
    part->isRefused = first == CheckResult::Invalid || second == CheckResult::Invalid;
  }
}

bool ToldProof::areShown(const CheckLimits& limits) {
  const auto all = [&] { return std::ranges::all_of(parts_, &Part::isShown); };
  checkParts(limits);
  if (!all() && search(limits)) checkParts(limits);
  return all();
}

/// What simplification knew of REAL operations is shown by writing them out; false: there are none.
bool ToldProof::writeOutReals() {
  std::vector<Node> roots;
  for (const Part& part : parts_) roots.push_back(part.fact);
  for (const StateVariable& state : system_.states) roots.push_back(state.next);
  const Graph& graph = *system_.graph;
  const std::vector<Node> cone = coneOf(graph, roots);
  if (std::ranges::none_of(cone, [&](Node n) { return isRealOperation(graph[n].op); })) return false;
  system_.questions.clear();
  for (const Part& part : parts_) system_.questions.push_back({part.name, part.fact});
  system_ = withExactReals(system_, RealScope::All);
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    Part& part = parts_[i];
    part.fact = system_.questions[i].bad;
    part.found.reset();
    part.isShown = part.isRefused = part.isFalse = false;
  }
  return true;
}

CheckResult ToldProof::check(const CheckLimits& limits) {
  if (result_) return *result_;
  result_ = CheckResult::Valid;
  if (areShown(limits) || (writeOutReals() && areShown(limits))) return *result_;
  for (const Part& part : parts_) {
    if (part.isShown) continue;
    isRefuted_ = isRefuted_ || (part.isFalse && isExact_) || (part.isRefused && part.isRefutable);
    if (result_ == CheckResult::Valid || part.isRefused)
      result_ = part.isRefused ? CheckResult::Invalid : CheckResult::Unknown;
    reason_ += (reason_.empty() ? "" : ", ") + std::string(part.name);
  }
  return *result_;
}

std::string ToldProof::text() const {
  if (parts_.empty()) return {};
  CertificateWriter writer(system_);
  for (const Part& part : parts_) addPart(writer, part);
  return writer.text();
}

}  // namespace rungproof
