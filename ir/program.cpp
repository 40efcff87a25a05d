// Look-ups in a program.
#include "ir/program.hpp"

#include <algorithm>

namespace rungproof {

void Program::number() {
  std::uint32_t next = 0;
  for (Pou& pou : pous) {
    for (Network& network : pou.networks) {
      for (Instruction& instruction : network.instructions) instruction.id = next++;
    }
  }
}

std::size_t Program::instructionCount() const {
  std::size_t count = 0;
  for (const Pou& pou : pous) {
    for (const Network& network : pou.networks) count += network.instructions.size();
  }
  return count;
}

namespace {

const Pou* find(const std::vector<Pou>& pous, PouKind kind, int number) {
  const auto found =
      std::find_if(pous.begin(), pous.end(), [&](const Pou& pou) { return pou.kind == kind && pou.number == number; });
  return found == pous.end() ? nullptr : &*found;
}

bool sameCell(const Operand& a, const Operand& b) {
  const bool byNumber = hasBitAndWord(a.area);
  return a.kind == b.kind && a.area == b.area && a.offset == b.offset &&
         (byNumber || (a.width == b.width && a.bit == b.bit));
}

}  // namespace

const Pou* Program::main() const {
  const auto found = std::find_if(pous.begin(), pous.end(), [](const Pou& pou) { return pou.kind == PouKind::Main; });
  return found == pous.end() ? nullptr : &*found;
}

const Pou* Program::subroutine(int number) const { return find(pous, PouKind::Subroutine, number); }
const Pou* Program::interrupt(int number) const { return find(pous, PouKind::Interrupt, number); }

const Symbol* Program::symbolOf(const Operand& address) const {
  const auto found = std::find_if(symbols.begin(), symbols.end(),
                                  [&](const Symbol& symbol) { return sameCell(symbol.address, address); });
  return found == symbols.end() ? nullptr : &*found;
}

const Symbol* Program::symbolNamed(std::string_view name) const {
  const auto found =
      std::find_if(symbols.begin(), symbols.end(), [&](const Symbol& symbol) { return symbol.name == name; });
  return found == symbols.end() ? nullptr : &*found;
}

}  // namespace rungproof
