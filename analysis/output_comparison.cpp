// The second system is copied into the graph of the first: its states get names of their own, its inputs are those of
// the first with the same name.
#include "analysis/output_comparison.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "analysis/evaluate.hpp"
#include "analysis/portfolio.hpp"

namespace rungproof {

namespace {

class Copier {
 public:
  Copier(Graph& to, const Graph& from, const TransitionSystem& target) : to_(to), from_(from) {
    for (const Node n : target.inputs) inputs_[to.variables()[to[n].value].name] = n;
  }

  Node copy(Node n) {
    if (n == noNode) return noNode;
    const Node roots[] = {n};
    for (const Node inner : coneOf(from_, roots)) {
      if (!copies_.contains(inner)) copies_[inner] = make(from_[inner]);
    }
    return copies_.at(n);
  }
  const std::vector<Node>& newInputs() const { return newInputs_; }

 private:
  Node make(const NodeData& data) {
    if (data.op == Op::Constant) return to_.constantNode(data.value, data.width);
    if (data.op == Op::Variable) return variable(from_.variables()[data.value], data.width);
    const auto child = [&](std::size_t i) { return data.child[i] == noNode ? noNode : copies_.at(data.child[i]); };
    return to_.make(data.op, data.width, child(0), child(1), child(2), data.value);
  }
  Node variable(const Variable& variable, int width) {
    if (variable.isState) return to_.variable(variable.name + " of the other", width, true);
    const auto known = inputs_.find(variable.name);
    if (known != inputs_.end() && to_[known->second].width == width) return known->second;
    newInputs_.push_back(to_.variable(variable.name + " of the other", width, false));
    return newInputs_.back();
  }

  Graph& to_;
  const Graph& from_;
  std::map<std::string, Node> inputs_;
  std::map<Node, Node> copies_;
  std::vector<Node> newInputs_;
};

void collectOutputs(const EncodedScan& encoding, std::set<std::pair<Area, std::uint32_t>>& bytes) {
  for (const Place& place : encoding.places()) {
    if (place.isRegister || (place.area != Area::Q && place.area != Area::AQ)) continue;
    for (std::uint32_t bit = place.at; bit < place.at + place.width; ++bit) bytes.emplace(place.area, bit / 8);
  }
}

}  // namespace

OutputComparison compareOutputs(const Program& left, const Program& right, const PropertySet& set, const ProverOptions& options, double seconds) {
  Obligations one(left, set, {}, encoderOptionsOf(options)), other(right, set, {}, encoderOptionsOf(options));
  std::set<std::pair<Area, std::uint32_t>> bytes;
  collectOutputs(one.encoding(), bytes);
  collectOutputs(other.encoding(), bytes);
  std::vector<std::pair<Node, Node>> outputs;
  for (const auto& [area, byte] : bytes) {
    for (std::uint32_t bit = 0; bit < 8; ++bit) {
      const Place place = memoryPlace(area, byte, Width::Bit, bit);
      outputs.emplace_back(one.encoding().atEnd(place), other.encoding().atEnd(place));
    }
  }
  TransitionSystem both = one.system();
  const TransitionSystem second = other.system();
  Graph& graph = *both.graph;
  Copier copier(graph, *second.graph, both);
  for (const StateVariable& state : second.states) both.states.push_back({copier.copy(state.node), copier.copy(state.init), copier.copy(state.next)});
  for (const Node constraint : second.constraints) {
    const Node copied = copier.copy(constraint);
    if (std::find(both.constraints.begin(), both.constraints.end(), copied) != both.constraints.end()) continue;
    both.constraints.push_back(copied);  // not a total one: its inputs now serve two programs
  }
  Graph::Bool differs = graph.constant(false);
  for (const auto& [a, b] : outputs) differs = graph.lor(differs, graph.lxor({a}, {copier.copy(b)}));
  both.inputs.insert(both.inputs.end(), copier.newInputs().begin(), copier.newInputs().end());
  both.questions = {{"outputs differ", differs.node}};
  if (const auto known = graph.truth(differs); known && !*known) return OutputComparison::Equal;
  PortfolioOptions portfolio;
  portfolio.seconds = seconds;
  portfolio.jobs = options.jobs;
  portfolio.seed = options.seed;
  portfolio.check = false;
  portfolio.cancel = options.cancel;
  const QuestionAnswer answer = answerQuestions(both, portfolio)[0];
  return answer.answer == Answer::Proved ? OutputComparison::Equal : answer.answer == Answer::Violated ? OutputComparison::Different : OutputComparison::Undecided;
}

}  // namespace rungproof
