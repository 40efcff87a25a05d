// Bits that a CPU keeps for the program, such as the one that is always on. Which they are, the dialect says.
#pragma once

#include "ir/operand.hpp"

namespace rungproof {

/// A bit that the CPU keeps for the program.
struct SystemBit {
  Area area = Area::SM;
  std::uint32_t byte = 0;
  std::uint8_t bit = 0;

  bool operator==(const SystemBit&) const = default;
  Operand operand() const { return direct(area, Width::Bit, byte, bit); }
};
/// Whether a direct operand names that bit.
inline bool isBit(const Operand& operand, const SystemBit& bit) {
  return operand.kind == OperandKind::Direct && SystemBit{operand.area, operand.offset, operand.bit} == bit;
}

struct SystemBits {
  SystemBit alwaysOn;
  SystemBit firstScan;    ///< on in the first scan after the change to RUN, and in no other
  SystemBit minuteClock;  ///< half a minute off, half a minute on
  SystemBit secondClock;  ///< half a second off, half a second on
  SystemBit scanClock;    ///< on in every other scan
};

}  // namespace rungproof
