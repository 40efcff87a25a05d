// From the elements of a whole drawing to networks: every circuit that is executed in one piece becomes a network of
// its own, as the S7-200 wants it (001:2230-2232); comments go to the circuit below them. A network in which something
// could not be read is incomplete, and is there even if nothing of it is left.
#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "analysis/drawing/lower.hpp"
#include "frontend/graphical/drawn_blocks.hpp"
#include "frontend/graphical/drawn_lowering.hpp"

namespace rungproof {

void DrawnLowering::begin() {
  states_.assign(network_->elements.size(), {});
  connectorBits_ = Operands(network_->elements.size());
  drawing_.elements.assign(1, Element{});
  drawing_.elements[0].span = network_->span;
  owner_.assign(1, DrawnCircuit::nothing);
  damaged_ = circuit_->damaged();
  place_.clear();
  idle_.assign(damaged_.size(), false);
}

/// Members of the pieces: connected by power, not through the rail, and not entangled in time with others.
std::vector<std::vector<std::uint32_t>> DrawnLowering::pieces() const {
  const auto size = static_cast<std::uint32_t>(drawing_.elements.size());
  std::vector<std::uint32_t> parent(size);
  std::iota(parent.begin(), parent.end(), 0U);
  const auto rootOf = [&](std::uint32_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  for (std::uint32_t i = 1; i < size; ++i) {
    for (const Wire wire : drawing_.elements[i].inputs) {
      if (wire.from != 0) parent[rootOf(i)] = rootOf(wire.from);
    }
  }
  std::vector<std::uint32_t> last(size, 0);
  for (std::uint32_t i = 1; i < size; ++i) last[rootOf(i)] = i;
  std::vector<std::vector<std::uint32_t>> result;
  std::uint32_t end = 0;  // last element of the piece that is open
  for (std::uint32_t i = 1; i < size; ++i) {
    // Boxes that one element became stay together.
    const bool isBox = drawing_.elements[i].shape == Shape::Box && !result.empty() &&
                       owner_[i] == owner_[result.back().back()] &&
                       drawing_.elements[result.back().back()].shape == Shape::Box;
    if (i > end && !isBox) result.emplace_back();
    end = std::max(end, last[rootOf(i)]);
    result.back().push_back(i);
  }
  return result;
}

void DrawnLowering::appendNetwork(std::vector<std::uint32_t> members, Form form, int circuit) {
  place_.resize(drawing_.elements.size(), 0);
  Network network;
  network.number = nextNumber_++;
  network.form = form;
  network.span = network_->span;
  network.complete =
      !network_->isDamaged && (circuit == DrawnCircuit::nothing || !damaged_[static_cast<std::size_t>(circuit)]);
  Drawing drawing;
  drawing.elements.push_back(drawing_.elements[0]);
  std::uint32_t first = 0xFFFFFFFF, end = 0;
  for (const std::uint32_t member : members) {
    Element element = drawing_.elements[member];
    for (Wire& wire : element.inputs) wire.from = wire.from == 0 ? 0 : place_[wire.from];
    place_[member] = static_cast<std::uint32_t>(drawing.elements.size());
    first = std::min(first, element.span.offset);
    end = std::max(end, element.span.offset + element.span.length);
    drawing.elements.push_back(std::move(element));
  }
  if (end > 0) network.span = {network_->span.file, first, end - first};
  if (!members.empty()) {
    const std::vector<int> owners = [&] {
      std::vector<int> list{DrawnCircuit::nothing};
      for (const std::uint32_t member : members) list.push_back(owner_[member]);
      return list;
    }();
    if (const auto fault = lowerInto(network, std::move(drawing))) {
      const int owner = owners[std::min<std::size_t>(fault->element, owners.size() - 1)];
      const DrawnElement& element = circuit_->element(std::max(owner, 0));
      sink_.setNetwork(network.number);
      sink_.circuit(element, fault->message);
      network.complete = false;
    }
  }
  pou_.networks.push_back(std::move(network));
}

void DrawnLowering::reportIdle() {
  for (int i = 0; i < circuit_->count(); ++i) {
    const DrawnElement& e = circuit_->element(i);
    const bool matters = e.kind == DrawnKind::Contact || e.kind == DrawnKind::Block;
    if (!matters || states_[static_cast<std::size_t>(i)].isDone ||
        damaged_[static_cast<std::size_t>(circuit_->circuitOf(i))])
      continue;
    if (circuit_->isInLoop(i)) continue;
    sink_.idle(e, "it leads to no coil and to no variable");
    idle_[static_cast<std::size_t>(circuit_->circuitOf(i))] = true;
  }
}

void DrawnLowering::body(const DrawnNetwork& network, Form form) {
  network_ = &network;
  sink_.setNetwork(nextNumber_);
  DrawnCircuit circuit(network, sink_,
                       [&](const DrawnElement& element) { return DrawnBlocks::hasMemory(build_, element); });
  circuit_ = &circuit;
  begin();
  for (const int i : circuit.results()) {
    sink_.setNetwork(nextNumber_);
    result(i);
    if (sink_.isDamaged()) damaged_[static_cast<std::size_t>(circuit.circuitOf(i))] = true;
  }
  reportIdle();
  finish(form);
}

/// Networks in the order of execution; a circuit of which nothing could be read has its place all the same.
std::vector<int> DrawnLowering::appendNetworks(Form form) {
  std::vector<std::vector<std::uint32_t>> list = pieces();
  std::vector<std::size_t> rank(damaged_.size(), circuit_->results().size());
  for (std::size_t k = circuit_->results().size(); k-- > 0;)
    rank[static_cast<std::size_t>(circuit_->circuitOf(circuit_->results()[k]))] = k;
  const auto circuitOfPiece = [&](const std::vector<std::uint32_t>& piece) {
    return circuit_->circuitOf(owner_[piece.front()]);
  };
  std::vector<bool> isThere(damaged_.size(), false);
  for (const std::vector<std::uint32_t>& piece : list) isThere[static_cast<std::size_t>(circuitOfPiece(piece))] = true;
  std::vector<int> missing;
  for (int circuit = 0; circuit < static_cast<int>(damaged_.size()); ++circuit) {
    const bool matters = damaged_[static_cast<std::size_t>(circuit)] || idle_[static_cast<std::size_t>(circuit)];
    if (matters && !isThere[static_cast<std::size_t>(circuit)]) missing.push_back(circuit);
  }
  const auto rankOf = [&](int circuit) { return rank[static_cast<std::size_t>(circuit)]; };
  std::stable_sort(missing.begin(), missing.end(), [&](int a, int b) { return rankOf(a) < rankOf(b); });
  std::vector<int> circuits;
  std::size_t next = 0;
  const auto appendMissing = [&](std::size_t before) {
    for (; next < missing.size() && rankOf(missing[next]) < before; ++next) {
      circuits.push_back(missing[next]);
      appendNetwork({}, form, missing[next]);
    }
  };
  for (std::vector<std::uint32_t>& piece : list) {
    const int circuit = circuitOfPiece(piece);
    appendMissing(rankOf(circuit));
    circuits.push_back(circuit);
    appendNetwork(std::move(piece), form, circuit);
  }
  appendMissing(circuit_->results().size() + 1);
  if (circuits.empty() && network_->isDamaged) {
    circuits.push_back(DrawnCircuit::nothing);
    appendNetwork({}, form, DrawnCircuit::nothing);
  }
  return circuits;
}

void DrawnLowering::finish(Form form) {
  const std::size_t firstNetwork = pou_.networks.size();
  const std::vector<int> circuits = appendNetworks(form);
  for (const DrawnSink::Pending& pending : sink_.takePending()) {
    const auto index = pending.element - network_->elements.data();
    if (index < 0 || index >= circuit_->count()) continue;
    const auto found = std::find(circuits.begin(), circuits.end(), circuit_->circuitOf(static_cast<int>(index)));
    Finding& finding = build_.program().findings[pending.finding];
    finding.network = found == circuits.end()
                          ? 0
                          : pou_.networks[firstNetwork + static_cast<std::size_t>(found - circuits.begin())].number;
  }
  for (const DrawnNote& note : network_->notes) {
    const std::size_t chosen = circuit_->below(note, circuits);
    if (chosen == circuits.size()) {
      pou_.comments.insert(pou_.comments.end(), note.lines.begin(), note.lines.end());
      continue;
    }
    Network& network = pou_.networks[firstNetwork + chosen];
    if (network.title.empty()) network.title = note.title;
    network.comments.insert(network.comments.end(), note.lines.begin(), note.lines.end());
  }
}

}  // namespace rungproof
