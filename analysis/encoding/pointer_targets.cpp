// Values of pointers as places.
#include "analysis/encoding/pointer_targets.hpp"

#include "analysis/encoding/assumed.hpp"
#include "ir/s7300/place.hpp"

namespace rungproof {

ValueSet listedOrBounded(Graph& graph, Node pointer, Node guard, std::size_t limit, const ValuesWhere& valuesWhere) {
  const ValueSet values = valuesWhere(pointer, guard).listedIfFew(limit);
  if (values.isListed()) return values;
  const Assumed here = assuming(graph, pointer, guard);
  return valuesWhere(here.node, here.guard).listedIfFew(limit);
}

Graph::Bool isAmong(Graph& graph, Node pointer, std::span<const std::uint64_t> values) {
  const int width = graph[pointer].width;
  Graph::Bool result = graph.constant(false);
  for (const std::uint64_t value : values)
    result = graph.lor(result, graph.equal({pointer}, graph.literal(value, width), width));
  return result;
}

Graph::Bool leadTo(Graph& graph, const Machine<Graph>& machine, Graph::Bits pointer, Width width,
                   std::span<const std::uint64_t> values, Ref<Graph>& ref,
                   const std::function<void(std::uint32_t)>& tell) {
  Graph::Bool legal = graph.constant(true);
  for (const std::uint64_t value : values) {
    const Graph::Bool isValue = graph.equal(pointer, graph.literal(value, 32), 32);
    const auto address = static_cast<std::uint32_t>(value);
    if (pointer::isLegal(machine.target, address, width)) {
      tell(address);
      ref.targets.push_back({isValue, *pointer::areaOf(address), pointer::offsetOf(address)});
    } else {
      legal = graph.land(legal, graph.lnot(isValue));
    }
  }
  if (ref.targets.empty()) return graph.constant(false);
  if (values.size() == 1) {
    ref.isPlace = true;
    ref.area = ref.targets[0].area;
    ref.offset = ref.targets[0].offset;
    ref.targets.clear();
  }
  return legal;
}

std::optional<std::vector<std::uint64_t>> startOfBlock(const ValueSet& values) {
  const Graph::Facts facts = values.facts();
  const std::optional<std::uint32_t> block = blockOfLocation(facts.ones, facts.zeros | facts.ones);
  return block ? std::optional(std::vector{locationInBlock(*block, 0)}) : std::nullopt;
}

std::optional<std::vector<std::uint64_t>> placesInBlock(Graph& graph, const Plan& plan, Graph::Bits location,
                                                        std::uint64_t start, Width width, std::size_t limit,
                                                        Graph::Bool& isInBlock) {
  constexpr int addressBits = 24;
  const auto block = static_cast<std::uint32_t>(start >> addressBits & 0xFFFF);
  const int w = graph[location.node].width, above = w - addressBits;
  isInBlock =
      graph.equal(graph.extract(location, w - 1, addressBits), graph.literal(start >> addressBits, above), above);
  const std::uint32_t length = plan.blocks->length(block), own = static_cast<std::uint32_t>(bytes(width));
  const std::uint32_t step = width == Width::Bit ? 1 : 8, count = length < own ? 0 : (length - own + 1) * 8 / step;
  if (count > limit) return std::nullopt;
  std::vector<std::uint64_t> places;
  for (std::uint32_t i = 0; i < count; ++i) places.push_back(locationInBlock(block, i * step));
  return places;
}

}  // namespace rungproof
