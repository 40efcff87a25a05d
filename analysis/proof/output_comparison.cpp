// The second system is copied into the graph of the first; its inputs are those of the first with the same name. Asked
// first is one scan from a shared state: its states are those of the first. What that leaves open is asked with states
// of its own, so that a difference of states that no output shows does not count.
#include "analysis/proof/output_comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "analysis/graph/evaluate.hpp"
#include "analysis/portfolio/portfolio.hpp"

namespace rungproof {

namespace {

class Copier {
 public:
  Copier(Graph& to, const Graph& from, const TransitionSystem& target, bool sharesStates) : to_(to), from_(from) {
    for (const Node n : target.inputs) inputs_[nameOf(n)] = n;
    if (!sharesStates) return;
    for (const StateVariable& state : target.states) states_[nameOf(state.node)] = state.node;
    sharesStates_ = true;
  }

  Node copy(Node n) {
    if (n == noNode) return noNode;
    const Node roots[] = {n};
    for (const Node inner : coneOf(from_, roots)) {
      if (!copies_.contains(inner)) copies_[inner] = make(inner);
    }
    return copies_.at(n);
  }
  const std::vector<Node>& newInputs() const { return newInputs_; }
  /// The state of the first system that stands for a state of the second; noNode: none does.
  Node shared(Node state) const {
    const Variable& variable = from_.variables()[from_[state].value];
    const auto found = states_.find(variable.name);
    return found != states_.end() && to_[found->second].width == from_[state].width ? found->second : noNode;
  }

 private:
  std::string nameOf(Node n) const { return to_.variables()[to_[n].value].name; }
  Node make(Node n) {
    const NodeData& data = from_[n];
    if (data.op == Op::Constant) return to_.constantNode(data.value, data.width);
    if (data.op == Op::Variable) return variable(n, from_.variables()[data.value], data.width);
    const auto child = [&](std::size_t i) { return data.child[i] == noNode ? noNode : copies_.at(data.child[i]); };
    return to_.make(data.op, data.width, child(0), child(1), child(2), data.value);
  }
  Node variable(Node n, const Variable& variable, int width) {
    if (variable.isState && sharesStates_ && shared(n) != noNode) return shared(n);
    if (variable.isState) return to_.variable(variable.name + " of the other", width, true);
    const auto known = inputs_.find(variable.name);
    if (known != inputs_.end() && to_[known->second].width == width) return known->second;
    newInputs_.push_back(to_.variable(variable.name + " of the other", width, false));
    return newInputs_.back();
  }

  Graph& to_;
  const Graph& from_;
  std::map<std::string, Node> inputs_, states_;
  bool sharesStates_ = false;
  std::map<Node, Node> copies_;
  std::vector<Node> newInputs_;
};

void collectOutputs(const EncodedScan& encoding, std::set<std::pair<Area, std::uint32_t>>& bytes) {
  for (const Place& place : encoding.places()) {
    if (place.isRegister || (place.area != Area::Q && place.area != Area::AQ)) continue;
    for (std::uint32_t bit = place.at; bit < place.at + place.width; ++bit) bytes.emplace(place.area, bit / 8);
  }
}

/// An output bit as the two programs leave it.
struct OutputBit {
  Place place;
  Node left = noNode, right = noNode;
};
using Outputs = std::vector<OutputBit>;

/// Both programs encoded, and each output bit of either as the two see it.
struct Sides {
  Sides(const Program& left, const Program& right, const PropertySet& set, const ProverOptions& options)
      : one(left, set, {}, encoderOptionsOf(options)), other(right, set, {}, encoderOptionsOf(options)) {
    std::set<std::pair<Area, std::uint32_t>> bytes;
    collectOutputs(one.encoding(), bytes);
    collectOutputs(other.encoding(), bytes);
    for (const auto& [area, byte] : bytes) {
      for (std::uint32_t bit = 0; bit < 8; ++bit) {
        const Place place = memoryPlace(area, byte, Width::Bit, bit);
        outputs.push_back({place, one.encoding().atEnd(place), other.encoding().atEnd(place)});
      }
    }
  }
  Obligations one, other;
  Outputs outputs;
};

QuestionAnswer ask(const TransitionSystem& system, const ProverOptions& options, double seconds) {
  PortfolioOptions portfolio;
  portfolio.seconds = seconds;
  portfolio.jobs = options.jobs;
  portfolio.seed = options.seed;
  portfolio.check = false;
  portfolio.cancel = options.cancel;
  return answerQuestions(system, portfolio)[0];
}

/// Whether, from every reachable state of the first, one scan of either leads to the same state and outputs. Then, scan
/// by scan, both have the same runs. The second system's constraints are left out: more runs can only refute it.
bool haveSameScans(TransitionSystem first, const TransitionSystem& second, const Outputs& outputs,
                   const ProverOptions& options, double seconds) {
  Graph& graph = *first.graph;
  Copier copier(graph, *second.graph, first, true);
  Graph::Bool differs = graph.constant(false);
  const auto compare = [&](Node a, Node b) {
    differs = graph.lor(differs, graph.lnot(graph.equal({a}, {b}, graph[a].width)));
  };
  std::set<Node> met;
  for (const StateVariable& state : second.states) {
    const Node own = copier.shared(state.node);
    if (own == noNode) return false;  // memory that the first knows by another name, or not at all
    met.insert(own);
    const auto same =
        std::find_if(first.states.begin(), first.states.end(), [&](const StateVariable& s) { return s.node == own; });
    if ((same->init == noNode) != (state.init == noNode)) return false;
    if (state.init != noNode) compare(same->init, copier.copy(state.init));
    compare(same->next, copier.copy(state.next));
  }
  // What the second does not touch keeps its value there.
  for (const StateVariable& state : first.states) {
    if (!met.contains(state.node)) compare(state.next, state.node);
  }
  for (const OutputBit& output : outputs) compare(output.left, copier.copy(output.right));
  if (const auto known = graph.truth(differs)) return !*known;
  first.inputs.insert(first.inputs.end(), copier.newInputs().begin(), copier.newInputs().end());
  first.questions = {{"a scan differs", differs.node}};
  return ask(first, options, seconds).answer == Answer::Proved;
}

/// Which output differs at the end of the run.
std::string differenceIn(const TransitionSystem& both, const WordTrace& trace, const Outputs& outputs, Copier& copier) {
  std::vector<std::pair<Node, Node>> pairs;
  std::vector<Node> roots;
  for (const OutputBit& output : outputs) {
    pairs.emplace_back(output.left, copier.copy(output.right));
    roots.insert(roots.end(), {pairs.back().first, pairs.back().second});
  }
  for (const StateVariable& state : both.states) roots.push_back(state.next);
  Evaluator evaluator(*both.graph, roots);
  std::vector<std::uint64_t> states = trace.initial;
  for (const std::vector<std::uint64_t>& inputs : trace.inputs) {
    for (std::size_t i = 0; i < states.size(); ++i) evaluator.set(both.states[i].node, states[i]);
    for (std::size_t i = 0; i < inputs.size(); ++i) evaluator.set(both.inputs[i], inputs[i]);
    evaluator.run();
    for (std::size_t i = 0; i < states.size(); ++i) states[i] = evaluator[both.states[i].next];
  }
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (evaluator[pairs[i].first] != evaluator[pairs[i].second])
      return fmt::format("{} in scan {}", nameOf(outputs[i].place), trace.inputs.size());
  }
  return {};
}

}  // namespace

bool haveSameScans(const Program& left, const Program& right, const PropertySet& set, const ProverOptions& options,
                   double seconds) {
  Sides sides(left, right, set, options);
  return haveSameScans(sides.one.system(), sides.other.system(), sides.outputs, options, seconds);
}

OutputComparison compareOutputs(const Program& left, const Program& right, const PropertySet& set,
                                const ProverOptions& options, double seconds, std::string* where) {
  Sides sides(left, right, set, options);
  TransitionSystem both = sides.one.system();
  const TransitionSystem second = sides.other.system();
  const Outputs& outputs = sides.outputs;
  if (haveSameScans(both, second, outputs, options, seconds / 2)) return OutputComparison::Equal;
  Graph& graph = *both.graph;
  Copier copier(graph, *second.graph, both, false);
  for (const StateVariable& state : second.states)
    both.states.push_back({copier.copy(state.node), copier.copy(state.init), copier.copy(state.next)});
  for (const Node constraint : second.constraints) {
    const Node copied = copier.copy(constraint);
    if (std::find(both.constraints.begin(), both.constraints.end(), copied) != both.constraints.end()) continue;
    both.constraints.push_back(copied);  // not a total one: its inputs now serve two programs
  }
  Graph::Bool differs = graph.constant(false);
  for (const OutputBit& output : outputs)
    differs = graph.lor(differs, graph.lxor({output.left}, {copier.copy(output.right)}));
  both.inputs.insert(both.inputs.end(), copier.newInputs().begin(), copier.newInputs().end());
  both.questions = {{"outputs differ", differs.node}};
  if (const auto known = graph.truth(differs); known && !*known) return OutputComparison::Equal;
  const QuestionAnswer answer = ask(both, options, seconds / 2);
  if (answer.answer == Answer::Proved) return OutputComparison::Equal;
  // A run that may rest on values that the CPU does not give shows nothing.
  if (answer.answer != Answer::Violated || answer.usesFreeReals) return OutputComparison::Undecided;
  if (where != nullptr) *where = differenceIn(both, *answer.trace, outputs, copier);
  return OutputComparison::Different;
}

}  // namespace rungproof
