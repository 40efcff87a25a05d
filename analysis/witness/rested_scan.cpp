// Cells of memory are replaced by their values of power-up.
#include "analysis/witness/rested_scan.hpp"

#include <unordered_map>

#include "analysis/witness/scan_run.hpp"

namespace rungproof {

namespace {

/// What the program remembers. Edges keep their memory: whether a button was pressed just now is no old state.
bool isMemory(const Place& place) {
  if (!place.isRegister) return place.area != Area::SM;
  switch (place.reg) {
    case Reg::Accumulator:
    case Reg::TimerCurrent:
    case Reg::TimerBit:
    case Reg::TimerRunning:
    case Reg::CounterCurrent:
    case Reg::CounterBit: return true;
    default: return false;
  }
}

}  // namespace

Substitution restedScan(EncodedScan& encoding) {
  const Concrete::Store rest = powerUpState(encoding.plan(), encoding.options().choices);
  std::unordered_map<std::uint32_t, Node> atRest;
  for (const Cell& cell : encoding.cells()) {
    if (cell.kind == CellKind::State && isMemory(cell.place))
      atRest[indexOf(cell.start)] = encoding.graph().constantNode(valueAt(cell.place, rest), cell.place.width);
  }
  return Substitution(encoding.graph(), std::move(atRest));
}

std::map<Place, const Instruction*> outputsOf(const EncodedScan& encoding) {
  std::map<Place, const Instruction*> outputs;
  for (const BitWrite& write : encoding.bitWrites()) {
    if (!write.place.isRegister && write.place.area == Area::Q && write.instruction != nullptr)
      outputs.emplace(write.place, write.instruction);
  }
  return outputs;
}

}  // namespace rungproof
