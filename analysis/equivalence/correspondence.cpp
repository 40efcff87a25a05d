// All pairs first; then those that a scan does not keep equal are dropped, until nothing changes.
#include "analysis/equivalence/correspondence.hpp"

#include <algorithm>
#include <numeric>
#include <ranges>

#include "analysis/graph/evaluate.hpp"

namespace rungproof {

namespace {

constexpr double pairSeconds = 2;            ///< for a pair of states that is not settled at once
constexpr std::size_t mostConditions = 400;  ///< under which states may correspond
constexpr int pairScans = 8;                 ///< of a run that shows that states do not correspond

constexpr std::size_t allRelations = ~std::size_t{0};  ///< in place of a state or condition: what holds for all

class CorrespondenceSearch {
 public:
  CorrespondenceSearch(ProgramProduct& product, bool withConditions, const Ask& ask,
                       const std::function<double()>& left)
      : product_(product), withConditions_(withConditions), ask_(ask), left_(left) {}

  Correspondence find() {
    for (std::size_t i = 0; i < product_.newStateCount(); ++i) found_.isMerged.push_back(product_.isMergeable(i));
    found_.conditions = product_.relationConditions();
    dropLooseRelations();
    while (left_() > 0) {
      const JoinedSystem merged = product_.merged(found_.isMerged, true, found_.conditions);
      TransitionSystem system = merged.system;
      std::vector<std::size_t> open;  // states, then conditions
      const Graph& graph = *system.graph;
      const auto ask = [&](std::size_t what, Node differs, const std::string& name) {
        if (differs == noNode || graph.truth({differs}) == false) return;
        open.push_back(what);
        system.questions.push_back({"what stands for " + name + " differs", differs});
      };
      for (std::size_t i = 0; i < found_.isMerged.size(); ++i) ask(i, merged.nextDiffers[i], nameOfState(i));
      Graph::Bool anyRelation = system.graph->constant(false);
      for (std::size_t i = 0; i < found_.conditions.size(); ++i) {
        if (asksTogether_ && found_.conditions[i].condition.empty())
          anyRelation = system.graph->lor(anyRelation, {merged.conditionBreaks[i]});
        else
          ask(found_.isMerged.size() + i, merged.conditionBreaks[i], found_.conditions[i].state);
      }
      ask(allRelations, anyRelation.node, "some relation");
      if (open.empty()) return std::move(found_);
      std::vector<std::size_t> dropped;
      for (const std::size_t i : withConditions_ ? brokenSoon(system, pairScans) : brokenOrOpen(system))
        dropped.push_back(open[i]);
      if (dropped.empty() && withConditions_) {
        for (const std::size_t i : brokenOrOpen(system)) dropped.push_back(open[i]);
      }
      if (dropped.empty()) return std::move(found_);
      if (std::erase(dropped, allRelations) > 0) asksTogether_ = false;
      drop(dropped);
    }
    return {std::vector<bool>(found_.isMerged.size(), false), {}};  // not settled: nothing is known to correspond
  }

 private:
  /// Relations that some scan does not keep, from whatever memory in which all of them hold.
  void dropLooseRelations() {
    if (found_.conditions.empty()) return;
    const JoinedSystem merged = product_.merged(found_.isMerged, true, found_.conditions);
    TransitionSystem system = merged.system;
    for (StateVariable& state : system.states) state.init = noNode;
    std::vector<std::size_t> kept(found_.conditions.size());
    std::iota(kept.begin(), kept.end(), std::size_t{0});
    for (bool isSettled = false; !isSettled && !kept.empty() && left_() > 0;) {
      system.constraints = merged.system.constraints;
      std::erase_if(system.constraints, [&](Node c) { return std::ranges::count(merged.conditionStarts, c) > 0; });
      system.questions.clear();
      for (const std::size_t i : kept) {
        if (merged.conditionStarts[i] != noNode) system.constraints.push_back(merged.conditionStarts[i]);
        system.questions.push_back({found_.conditions[i].state, merged.conditionBreaks[i]});
      }
      const std::vector<std::size_t> broken = brokenSoon(system, 1);
      for (const std::size_t i : std::views::reverse(broken)) kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(i));
      isSettled = broken.empty();
    }
    std::vector<PairCondition> conditions;
    for (const std::size_t i : kept) conditions.push_back(found_.conditions[i]);
    found_.conditions = std::move(conditions);
  }
  static Node anyOf(const TransitionSystem& system) {
    Graph::Bool any = system.graph->constant(false);
    for (const Question& question : system.questions) any = system.graph->lor(any, {question.bad});
    return any.node;
  }
  /// Questions that a short run answers with yes: all that are so in one run.
  std::vector<std::size_t> brokenSoon(const TransitionSystem& system, int scans) const {
    TransitionSystem asked = system;
    asked.questions = {{"something differs", anyOf(system)}};
    const auto trace = shallowSearch(asked, scans, std::min(pairSeconds, left_()));
    return trace ? brokenIn(system, *trace) : std::vector<std::size_t>{};
  }
  static std::vector<std::size_t> brokenIn(const TransitionSystem& system, const WordTrace& trace) {
    std::vector<Node> roots;
    for (const Question& question : system.questions) roots.push_back(question.bad);
    for (const StateVariable& state : system.states) roots.push_back(state.next);
    Evaluator evaluator(*system.graph, roots);
    std::vector<std::uint64_t> now = trace.initial;
    for (const std::vector<std::uint64_t>& scan : trace.inputs) {
      for (std::size_t i = 0; i < now.size(); ++i) evaluator.set(system.states[i].node, now[i]);
      for (std::size_t i = 0; i < scan.size(); ++i) evaluator.set(system.inputs[i], scan[i]);
      evaluator.run();
      for (std::size_t i = 0; i < now.size(); ++i) now[i] = evaluator[system.states[i].next];
    }
    std::vector<std::size_t> broken;
    for (std::size_t i = 0; i < system.questions.size(); ++i) {
      if (evaluator[system.questions[i].bad] != 0) broken.push_back(i);
    }
    return broken;
  }
  /// Questions that are answered with yes; if there are none, the first one that is not answered with no.
  std::vector<std::size_t> brokenOrOpen(const TransitionSystem& system) {
    const std::vector<QuestionAnswer> answers = ask_(system, pairSeconds, Effort::Together);
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < answers.size(); ++i) {
      if (answers[i].answer == Answer::Violated) found.push_back(i);
    }
    for (std::size_t i = 0; found.empty() && i < answers.size(); ++i) {
      if (answers[i].answer == Answer::Proved) continue;
      TransitionSystem one = system;
      one.questions = {system.questions[i]};
      if (ask_(one, pairSeconds, Effort::Full)[0].answer != Answer::Proved) found.push_back(i);
    }
    return found;
  }
  void drop(const std::vector<std::size_t>& dropped) {
    std::vector<PairCondition> kept;
    for (std::size_t i = 0; i < found_.conditions.size(); ++i) {
      if (std::ranges::find(dropped, found_.isMerged.size() + i) == dropped.end()) kept.push_back(found_.conditions[i]);
    }
    found_.conditions = std::move(kept);
    const std::vector<std::string> bits = withConditions_ ? product_.oldBitNames() : std::vector<std::string>{};
    for (const std::size_t i : dropped) {
      if (i >= found_.isMerged.size()) continue;
      found_.isMerged[i] = false;
      if (found_.conditions.size() + 2 * bits.size() > mostConditions) continue;
      for (const std::string& bit : bits) {
        for (const bool when : {true, false}) found_.conditions.push_back({nameOfState(i), bit, when});
      }
    }
  }
  std::string nameOfState(std::size_t i) const {
    const TransitionSystem& system = product_.newSystem();
    return system.graph->variables()[(*system.graph)[system.states[i].node].value].name;
  }

  ProgramProduct& product_;
  const bool withConditions_;
  const Ask& ask_;
  const std::function<double()>& left_;
  bool asksTogether_ = true;  ///< whether all relations hold, in one question
  Correspondence found_;
};

}  // namespace

Correspondence findCorrespondence(ProgramProduct& product, bool withConditions, const Ask& ask,
                                  const std::function<double()>& left) {
  return CorrespondenceSearch(product, withConditions, ask, left).find();
}

}  // namespace rungproof
