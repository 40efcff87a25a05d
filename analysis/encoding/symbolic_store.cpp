// Symbolic memory and registers. Bits of an area stand in the order of significance within a word: index
// byte * 8 + (7 - bit), so a word is a run of indices from its most significant bit.
#include "analysis/encoding/symbolic_store.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "ir/check.hpp"

namespace rungproof {

Place memoryPlace(Area area, std::uint32_t byte, Width width, std::uint32_t bit) {
  const std::uint32_t at = width == Width::Bit ? (byte + bit / 8) * 8 + (7 - bit % 8) : byte * 8;
  return {false, area, Reg::Accumulator, at, static_cast<std::uint8_t>(bits(width))};
}

Place registerPlace(Reg reg, std::uint32_t index) { return {true, Area::V, reg, index, regInfo(reg).width}; }

std::string nameOf(const Place& place) {
  if (place.isRegister) {
    const RegInfo& info = regInfo(place.reg);
    if (place.reg == Reg::Reading) {
      const ChoiceInfo& choice = choiceInfo(choiceOfReading(place.at));
      return fmt::format("{} = {}", choice.key, choice.values[valueOfReading(place.at)]);
    }
    if (info.count == 1) return std::string(info.name);
    const std::size_t dot = info.name.find('.');
    const std::string_view head = info.name.substr(0, dot);
    return fmt::format("{}{}{}", head, place.at, dot == std::string_view::npos ? "" : info.name.substr(dot));
  }
  if (place.width == 1) return addressName(place.area, Width::Bit, place.byte(), place.bit());
  const Width width = widthOfBits(place.width);
  if (bits(width) == place.width) return addressName(place.area, width, place.byte());
  return fmt::format("{}..{}", addressName(place.area, Width::Byte, place.byte()), place.byte() + place.width / 8U - 1);
}

Graph::Store::Store(Graph& graph, const MemoryLayout& layout, CellSource& source, const Plan& plan)
    : graph_(graph), layout_(layout), blocks_(plan.blocks), source_(source), localEntry_(plan.localBytes) {
  for (const RegInfo& info : regTable)
    registers_[static_cast<std::size_t>(info.reg)].assign(registerCount(info, plan), noNode);
}

std::vector<Graph::Store::BitRef>& Graph::Store::bitsOf(Area area) {
  std::vector<BitRef>& bits = bits_[static_cast<std::size_t>(area)];
  if (bits.empty()) bits.resize(static_cast<std::size_t>(layout_.size(area)) * 8);
  return bits;
}

/// Makes cells for the bits of [first, first + width) that have none.
void Graph::Store::touch(Area area, std::uint32_t first, int width) {
  std::vector<BitRef>& bits = bitsOf(area);
  const std::uint32_t end = first + static_cast<std::uint32_t>(width);
  for (std::uint32_t at = first; at < end;) {
    if (bits[at].node != noNode) {
      ++at;
      continue;
    }
    const std::uint32_t byte = at / 8;
    if (area == Area::L) {
      const auto [entry, inBlock] = localEntry_[byte];
      const Node node = source_.localByte(entry, inBlock);
      for (std::uint32_t i = 0; i < 8; ++i) {
        if (bits[byte * 8 + i].node == noNode) bits[byte * 8 + i] = {node, 7 - i};
      }
      continue;
    }
    Place place{false, area, Reg::Accumulator, named(area, at), 1};
    std::uint32_t from = at;
    if (!layout_.isSingleBits(area, byte)) {
      const MemoryLayout::Word word = layout_.wordOf(area, byte);
      from = word.first * 8;
      place.at = named(area, from);
      place.width = static_cast<std::uint8_t>(word.bytes * 8);
    }
    Cell cell = source_.cellAt(place);
    cells_.push_back(cell);
    Node start = source_.atScan(cell);
    for (const Havoc& h : havocs_) start = graph_.make(Op::Ite, place.width, h.guard, h.fresh(place), start);
    for (std::uint32_t i = 0; i < place.width; ++i) {
      if (bits[from + i].node == noNode) bits[from + i] = {start, place.width - 1 - i};
    }
  }
}

void Graph::Store::touchRegister(Reg reg, std::uint32_t index) {
  std::vector<Node>& nodes = registers_[static_cast<std::size_t>(reg)];
  CHECK(index < nodes.size(), "register number");
  if (nodes[index] != noNode) return;
  const Place place = registerPlace(reg, index);
  const Cell cell = source_.cellAt(place);
  cells_.push_back(cell);
  Node start = source_.atScan(cell);
  const bool isReachable = reg == Reg::TimerCurrent || reg == Reg::CounterCurrent;
  if (isReachable) {
    for (const Havoc& h : havocs_) start = graph_.make(Op::Ite, place.width, h.guard, h.fresh(place), start);
  }
  nodes[index] = start;
}

Node Graph::Store::join(Area area, std::uint32_t first, int width) {
  const std::vector<BitRef>& bits = bitsOf(area);
  Node result = noNode;
  int done = 0;
  while (done < width) {
    const BitRef start = bits[first + static_cast<std::uint32_t>(done)];
    int run = 1;
    while (done + run < width) {
      const BitRef next = bits[first + static_cast<std::uint32_t>(done + run)];
      if (next.node != start.node || next.low + static_cast<std::uint32_t>(run) != start.low) break;
      ++run;
    }
    const Node part =
        graph_.make(Op::Extract, run, start.node, noNode, noNode, start.low + 1 - static_cast<std::uint32_t>(run));
    result = result == noNode ? part : graph_.make(Op::Concat, done + run, result, part);
    done += run;
  }
  return result;
}

void Graph::Store::put(Area area, std::uint32_t first, int width, Node value) {
  std::vector<BitRef>& bits = bitsOf(area);
  for (int i = 0; i < width; ++i)
    bits[first + static_cast<std::uint32_t>(i)] = {value, static_cast<std::uint32_t>(width - 1 - i)};
}

Graph::Bits Graph::Store::load(Area area, std::uint32_t offset, int width) {
  const std::uint32_t at = width == 1 ? offset / 8 * 8 + (7 - offset % 8) : offset / 8 * 8;
  const std::uint32_t first = inRow(area, at);
  const std::uint32_t size = layout_.size(area) * 8;
  if (first >= size) return graph_.literal(0, width);
  const int inside = static_cast<int>(std::min<std::uint32_t>(static_cast<std::uint32_t>(width), size - first));
  note({false, area, Reg::Accumulator, at, static_cast<std::uint8_t>(inside)}, false);
  touch(area, first, inside);
  const Node node = read(join(area, first, inside));
  return {inside == width ? node : graph_.make(Op::Concat, width, node, graph_.constantNode(0, width - inside))};
}

void Graph::Store::save(Area area, std::uint32_t offset, int width, Bits value, Bool guard) {
  if (graph_.truth(guard) == false) return;
  const std::uint32_t at = width == 1 ? offset / 8 * 8 + (7 - offset % 8) : offset / 8 * 8;
  const std::uint32_t first = inRow(area, at);
  const std::uint32_t size = layout_.size(area) * 8;
  if (first >= size) return;
  const int inside = static_cast<int>(std::min<std::uint32_t>(static_cast<std::uint32_t>(width), size - first));
  const Place place{false, area, Reg::Accumulator, at, static_cast<std::uint8_t>(inside)};
  note(place, true);
  if (width == 1 && machine_ != nullptr && machine_->current != nullptr && area != Area::L && area != Area::SM) {
    bitWrites_.push_back({machine_->current, place, value.node, guard.node});
  }
  Node stored =
      graph_.make(Op::Extract, inside, value.node, noNode, noNode, static_cast<std::uint64_t>(width - inside));
  if (graph_.truthEverywhere(guard) != true) {
    touch(area, first, inside);
    stored = graph_.make(Op::Ite, inside, guard.node, stored, join(area, first, inside));
  }
  put(area, first, inside, stored);
}

Graph::Bits Graph::Store::get(Reg reg, std::uint32_t index) {
  note(registerPlace(reg, index), false);
  touchRegister(reg, index);
  return {read(registers_[static_cast<std::size_t>(reg)][index])};
}

void Graph::Store::set(Reg reg, std::uint32_t index, Bits value, Bool guard) {
  if (graph_.truth(guard) == false) return;
  note(registerPlace(reg, index), true);
  const int width = regInfo(reg).width;
  CHECK(graph_[value.node].width == width, "register written in another width");
  Node stored = value.node;
  if (graph_.truthEverywhere(guard) != true) {
    touchRegister(reg, index);
    stored = graph_.make(Op::Ite, width, guard.node, stored, registers_[static_cast<std::size_t>(reg)][index]);
  }
  registers_[static_cast<std::size_t>(reg)][index] = stored;
}

Node Graph::Store::value(const Place& place) {
  if (place.isRegister) {
    touchRegister(place.reg, place.at);
    return registers_[static_cast<std::size_t>(place.reg)][place.at];
  }
  const std::uint32_t first = inRow(place.area, place.at);
  touch(place.area, first, place.width);
  return join(place.area, first, place.width);
}

void Graph::Store::replace(const Place& place, Node value, Bool guard) {
  note(place, true);
  const Node chosen = graph_.make(Op::Ite, place.width, guard.node, value, this->value(place));
  if (place.isRegister)
    registers_[static_cast<std::size_t>(place.reg)][place.at] = chosen;
  else
    put(place.area, inRow(place.area, place.at), place.width, chosen);
}

void Graph::Store::forgetLocal(std::uint32_t base, std::uint32_t byte, std::uint32_t entry) {
  std::vector<BitRef>& bits = bitsOf(Area::L);
  const std::uint32_t at = base + byte;
  localEntry_[at] = {entry, byte};
  for (std::uint32_t i = 0; i < 8; ++i) bits[at * 8 + i] = {};
}

std::vector<Place> Graph::Store::places() const {
  std::vector<Place> result;
  for (int a = 0; a < areaCount; ++a) {
    const Area area = static_cast<Area>(a);
    const std::vector<BitRef>& bits = bits_[static_cast<std::size_t>(a)];
    if (area == Area::L) continue;
    for (std::uint32_t at = 0; at < bits.size(); ++at) {
      if (bits[at].node == noNode) continue;
      std::uint32_t run = 1;
      while (run < 64 && at + run < bits.size() && bits[at + run].node == bits[at].node &&
             bits[at + run].low + run == bits[at].low)
        ++run;
      result.push_back({false, area, Reg::Accumulator, named(area, at), static_cast<std::uint8_t>(run)});
      at += run - 1;
    }
  }
  for (const RegInfo& info : regTable) {
    const std::vector<Node>& nodes = registers_[static_cast<std::size_t>(info.reg)];
    for (std::uint32_t i = 0; i < nodes.size(); ++i) {
      if (nodes[i] != noNode) result.push_back(registerPlace(info.reg, i));
    }
  }
  return result;
}

void Graph::Store::havoc(Bool guard, std::function<Node(const Place&)> fresh) {
  // What has a value changes now; the rest when it is touched.
  for (const Place& place : places()) {
    const bool isReachable = !place.isRegister || place.reg == Reg::TimerCurrent || place.reg == Reg::CounterCurrent;
    if (!isReachable) continue;
    const Node changed = graph_.make(Op::Ite, place.width, guard.node, fresh(place), value(place));
    if (place.isRegister)
      registers_[static_cast<std::size_t>(place.reg)][place.at] = changed;
    else
      put(place.area, inRow(place.area, place.at), place.width, changed);
  }
  havocs_.push_back({guard.node, std::move(fresh)});
}

}  // namespace rungproof
