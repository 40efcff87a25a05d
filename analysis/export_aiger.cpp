// AIGER 1.9 ascii: header "aag M I L O A B C", latches with reset, bad states and constraints, symbol table.
#include <fmt/format.h>

#include "analysis/bit_blast.hpp"
#include "analysis/export_system.hpp"

namespace rungproof {

namespace {

std::string oneLine(std::string name) {
  for (char& c : name) {
    if (static_cast<unsigned char>(c) < 32) c = ' ';
  }
  return name;
}

}  // namespace

std::string exportAiger(const TransitionSystem& system) {
  std::vector<std::size_t> all;
  for (std::size_t q = 0; q < system.questions.size(); ++q) all.push_back(q);
  const BitBlast blast(system, all);
  const BitSystem& bits = blast.bits();
  // AIGER numbers inputs, then latches, then gates.
  std::vector<std::uint32_t> number(bits.variableCount(), 0);
  std::uint32_t next = 1;
  for (const std::uint32_t v : bits.inputs) number[v] = next++;
  for (const Latch& latch : bits.latches) number[latch.variable] = next++;
  for (const std::uint32_t v : bits.gateVariables) number[v] = next++;
  const auto literal = [&](Lit l) { return 2 * number[variableOf(l)] + (l & 1U); };
  std::string text = fmt::format("aag {} {} {} 0 {} {} {}\n", next - 1, bits.inputs.size(), bits.latches.size(), bits.gates.size(),
                                 bits.bads.size(), bits.constraints.size());
  for (const std::uint32_t v : bits.inputs) text += fmt::format("{}\n", 2 * number[v]);
  for (const Latch& latch : bits.latches) {
    const std::uint32_t self = 2 * number[latch.variable];
    const std::uint32_t reset = latch.init == LatchInit::Free ? self : latch.init == LatchInit::One ? 1 : 0;
    text += fmt::format("{} {} {}\n", self, literal(latch.next), reset);
  }
  for (const Lit l : bits.bads) text += fmt::format("{}\n", literal(l));
  for (const Lit l : bits.constraints) text += fmt::format("{}\n", literal(l));
  for (std::size_t i = 0; i < bits.gates.size(); ++i) {
    text += fmt::format("{} {} {}\n", 2 * number[bits.gateVariables[i]], literal(bits.gates[i].right), literal(bits.gates[i].left));
  }
  for (std::size_t i = 0; i < bits.inputs.size(); ++i) text += fmt::format("i{} {}\n", i, oneLine(bits.inputNames[i]));
  for (std::size_t i = 0; i < bits.latches.size(); ++i) text += fmt::format("l{} {}\n", i, oneLine(bits.latches[i].name));
  for (std::size_t i = 0; i < all.size(); ++i) text += fmt::format("b{} {}\n", i, oneLine(system.questions[i].name));
  return text;
}

}  // namespace rungproof
