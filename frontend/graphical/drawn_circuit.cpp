// Lines, circuits, loops, order.
#include "frontend/graphical/drawn_circuit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <tuple>

namespace rungproof {

namespace {

bool isRail(const DrawnElement& element) {
  return element.kind == DrawnKind::LeftRail || element.kind == DrawnKind::RightRail;
}

bool writesAtPins(const DrawnElement& block) {
  return std::any_of(block.outputs.begin(), block.outputs.end(),
                     [](const DrawnPin& pin) { return !pin.expression.empty(); });
}

int rootOf(std::vector<int>& parent, int i) {
  while (parent[static_cast<std::size_t>(i)] != i) {
    int& up = parent[static_cast<std::size_t>(i)];
    up = parent[static_cast<std::size_t>(up)];
    i = up;
  }
  return i;
}

}  // namespace

int DrawnCircuit::sourceOf(const DrawnLink& link) const {
  const auto found = byId_.find(link.from);
  return found == byId_.end() ? nothing : found->second;
}

int DrawnCircuit::connectorOf(int continuation) const {
  const auto found = connectors_.find(element(continuation).text);
  return found == connectors_.end() ? nothing : found->second;
}

void DrawnCircuit::build() {
  const auto size = network_.elements.size();
  consumers_.resize(size);
  cut_.assign(size, false);
  loop_.assign(size, false);
  loose_.assign(size, false);
  indexElements();
  findCircuits();
  connect();
  cutLoops();
  findLoose();
  results_ = orderedResults(true);
}

void DrawnCircuit::indexElements() {
  for (int i = 0; i < count(); ++i) {
    byId_.emplace(element(i).id, i);
    if (element(i).kind == DrawnKind::Connector) connectors_.emplace(element(i).text, i);
  }
}

void DrawnCircuit::findCircuits() {
  std::vector<int> parent(network_.elements.size());
  std::iota(parent.begin(), parent.end(), 0);
  for (int i = 0; i < count(); ++i) {
    if (isRail(element(i))) continue;
    for (const DrawnPin& pin : element(i).inputs) {
      for (const DrawnLink& link : pin.links) {
        const int from = sourceOf(link);
        if (from != nothing && !isRail(element(from)))
          parent[static_cast<std::size_t>(rootOf(parent, i))] = rootOf(parent, from);
      }
    }
  }
  std::vector<int> number(network_.elements.size(), nothing);
  int circuits = 0;
  for (int i = 0; i < count(); ++i) {
    int& root = number[static_cast<std::size_t>(rootOf(parent, i))];
    if (root == nothing) root = circuits++;
    circuit_.push_back(root);
  }
  damaged_.assign(static_cast<std::size_t>(circuits), false);
}

void DrawnCircuit::connect() {
  for (int i = 0; i < count(); ++i) {
    const DrawnElement& e = element(i);
    if (byId_.at(e.id) != i) {
      sink_.circuit(e, fmt::format("the number {} is given to two elements", e.id));
      damage(i);
      damage(byId_.at(e.id));
    }
    if (e.kind == DrawnKind::Continuation && connectorOf(i) == nothing) {
      sink_.circuit(e, fmt::format("there is no connector {}", e.text));
      damage(i);
    }
    if (e.kind == DrawnKind::Connector && connectors_.at(e.text) != i) {
      sink_.circuit(e, fmt::format("two connectors are named {}", e.text));
      damage(i);
    }
    for (const DrawnPin& pin : e.inputs) {
      for (const DrawnLink& link : pin.links) {
        const int from = sourceOf(link);
        if (from != nothing) {
          consumers_[static_cast<std::size_t>(from)].push_back({i, &pin, &link});
          continue;
        }
        sink_.circuit(e, fmt::format("a line comes from element {}, which does not exist", link.from));
        damage(i);
      }
    }
  }
}

std::vector<int> DrawnCircuit::feedersOf(int i) const {
  std::vector<int> feeders;
  if (element(i).kind == DrawnKind::Continuation) {
    const int connector = connectorOf(i);
    if (connector != nothing && !isCut(connector)) feeders.push_back(connector);
  }
  for (const DrawnPin& pin : element(i).inputs) {
    for (const DrawnLink& link : pin.links) {
      const int from = sourceOf(link);
      if (from != nothing && !isRail(element(from)) && !isCut(from)) feeders.push_back(from);
    }
  }
  return feeders;
}

/// Strongly connected parts with a loop, by Tarjan's algorithm without recursion.
std::vector<std::vector<int>> DrawnCircuit::loops() const {
  const auto size = network_.elements.size();
  std::vector<int> index(size, nothing), low(size, 0);
  std::vector<bool> onStack(size, false);
  std::vector<int> stack;
  std::vector<std::vector<int>> found;
  struct Frame {
    int node;
    std::vector<int> feeders;
    std::size_t next;
  };
  int counter = 0;
  std::vector<Frame> frames;
  for (int start = 0; start < count(); ++start) {
    if (index[static_cast<std::size_t>(start)] != nothing || isRail(element(start))) continue;
    frames.push_back({start, feedersOf(start), 0});
    while (!frames.empty()) {
      Frame& frame = frames.back();
      const auto node = static_cast<std::size_t>(frame.node);
      if (frame.next == 0 && index[node] == nothing) {
        index[node] = low[node] = counter++;
        stack.push_back(frame.node);
        onStack[node] = true;
      }
      if (frame.next < frame.feeders.size()) {
        const int to = frame.feeders[frame.next++];
        const auto target = static_cast<std::size_t>(to);
        if (index[target] == nothing) {
          frames.push_back({to, feedersOf(to), 0});
        } else if (onStack[target]) {
          low[node] = std::min(low[node], index[target]);
        }
        continue;
      }
      if (low[node] == index[node]) {
        std::vector<int> part;
        int member = nothing;
        do {
          member = stack.back();
          stack.pop_back();
          onStack[static_cast<std::size_t>(member)] = false;
          part.push_back(member);
        } while (member != frame.node);
        const bool toItself = std::find(frame.feeders.begin(), frame.feeders.end(), frame.node) != frame.feeders.end();
        if (part.size() > 1 || toItself) {
          std::sort(part.begin(), part.end());
          found.push_back(std::move(part));
        }
      }
      const int lowest = low[node];
      frames.pop_back();
      if (!frames.empty()) {
        int& above = low[static_cast<std::size_t>(frames.back().node)];
        above = std::min(above, lowest);
      }
    }
  }
  return found;
}

void DrawnCircuit::cutLoops() {
  for (const std::vector<int>& loop : loops()) {
    for (const int i : loop) cut_[static_cast<std::size_t>(i)] = hasMemory_[static_cast<std::size_t>(i)];
  }
  for (const std::vector<int>& loop : loops()) {
    for (const int i : loop) {
      const DrawnKind kind = element(i).kind;
      cut_[static_cast<std::size_t>(i)] =
          kind == DrawnKind::Connector || (variablesKeep_ && kind == DrawnKind::InOutVariable);
    }
  }
  for (const std::vector<int>& loop : loops()) {
    for (const int i : loop) loop_[static_cast<std::size_t>(i)] = true;
    sink_.circuit(
        element(loop.front()),
        fmt::format("{} elements feed each other in a circle, and none of them keeps a value from the previous scan",
                    loop.size()));
    damage(loop.front());
  }
}

/// Of boxes that nobody needs and that feed each other the last ones: they ask for those in front of them.
void DrawnCircuit::findLoose() {
  std::vector<bool> isAsked(network_.elements.size(), false);
  std::vector<int> open;
  const auto askFeeders = [&](int i) {
    for (const int feeder : feedersOf(i)) {
      if (isAsked[static_cast<std::size_t>(feeder)]) continue;
      isAsked[static_cast<std::size_t>(feeder)] = true;
      open.push_back(feeder);
    }
  };
  const auto follow = [&](int i) {
    askFeeders(i);
    while (!open.empty()) {
      const int at = open.back();
      open.pop_back();
      askFeeders(at);
    }
  };
  const auto isBox = [&](int i) {
    return element(i).kind == DrawnKind::Block && !hasMemory_[static_cast<std::size_t>(i)];
  };
  for (int i = 0; i < count(); ++i) {
    if (isResult(i) && !(isBox(i) && !writesAtPins(element(i)))) follow(i);
  }
  std::vector<int> unneeded;
  for (int i = 0; i < count(); ++i) {
    if (isBox(i) && !isAsked[static_cast<std::size_t>(i)] && !writesAtPins(element(i))) unneeded.push_back(i);
  }
  for (const int i : unneeded) follow(i);
  for (const int i : unneeded) loose_[static_cast<std::size_t>(i)] = !isAsked[static_cast<std::size_t>(i)];
}

bool DrawnCircuit::isResult(int i) const {
  const DrawnElement& e = element(i);
  switch (e.kind) {
    case DrawnKind::Coil:
    case DrawnKind::OutVariable:
    case DrawnKind::Jump:
    case DrawnKind::Label:
    case DrawnKind::Return: return true;
    case DrawnKind::InOutVariable:
      return std::any_of(e.inputs.begin(), e.inputs.end(), [](const DrawnPin& pin) { return !pin.links.empty(); });
    case DrawnKind::Connector: return isCut(i);
    case DrawnKind::Block:
      return writesAtPins(e) || hasMemory_[static_cast<std::size_t>(i)] || isLoose(i) ||
             (variablesKeep_ && e.order > 0);
    default: return false;
  }
}

std::size_t DrawnCircuit::below(const DrawnNote& note, const std::vector<int>& circuits) const {
  std::vector<double> top(damaged_.size(), std::numeric_limits<double>::max());
  bool hasPlaces = false;
  for (int i = 0; i < count(); ++i) {
    if (isRail(element(i))) continue;
    double& height = top[static_cast<std::size_t>(circuitOf(i))];
    height = std::min(height, element(i).y);
    hasPlaces = hasPlaces || element(i).y != 0;
  }
  std::size_t chosen = circuits.size();
  for (std::size_t k = 0; k < circuits.size(); ++k) {
    if (circuits[k] == nothing) return 0;
    if (hasPlaces) {
      const double height = top[static_cast<std::size_t>(circuits[k])];
      if (height >= note.y && (chosen == circuits.size() || height < top[static_cast<std::size_t>(circuits[chosen])]))
        chosen = k;
    } else if (note.before < network_.elements.size() && chosen == circuits.size()) {
      if (circuits[k] == circuitOf(static_cast<int>(note.before))) chosen = k;
    }
  }
  return chosen;
}

std::vector<int> DrawnCircuit::orderedResults(bool byStatedOrder) const {
  // A circuit is as high as its highest element; circuits of equal height keep the order of the file.
  constexpr double below = std::numeric_limits<double>::max();
  std::vector<double> top(damaged_.size(), below);
  for (int i = 0; i < count(); ++i) {
    if (isRail(element(i))) continue;
    double& height = top[static_cast<std::size_t>(circuitOf(i))];
    height = std::min(height, element(i).y);
  }
  std::vector<int> ordered;
  for (int i = 0; i < count(); ++i) {
    if (isResult(i)) ordered.push_back(i);
  }
  const auto key = [&](int i) {
    const DrawnElement& e = element(i);
    const int order = byStatedOrder && e.order > 0 ? e.order : std::numeric_limits<int>::max();
    return std::tuple(order, top[static_cast<std::size_t>(circuitOf(i))], circuitOf(i), e.y, e.x);
  };
  std::stable_sort(ordered.begin(), ordered.end(), [&](int a, int b) { return key(a) < key(b); });
  return ordered;
}

}  // namespace rungproof
