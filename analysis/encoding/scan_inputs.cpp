// Memory is given byte by byte, as areas overlap.
#include "analysis/encoding/scan_inputs.hpp"

#include <algorithm>

#include "analysis/encoding/device_writes.hpp"

namespace rungproof {

namespace {

/// What a scan finds in a high-speed counter, be it counted or kept; noNode: it cannot count.
Node countIn(const EncodedScan& scan, std::uint32_t counter) {
  const auto counted = scan.deviceInputs().find(DeviceWrites::countName(counter));
  if (counted == scan.deviceInputs().end()) return noNode;
  const auto startOf = [&](Reg reg) {
    const auto cell = std::ranges::find(scan.cells(), registerPlace(reg, counter), &Cell::place);
    return cell == scan.cells().end() ? noNode : cell->start;
  };
  const Node enabled = startOf(Reg::HscEnabled), kept = startOf(Reg::HscCurrent);
  return enabled == noNode || kept == noNode ? noNode : scan.graph().make(Op::Ite, 32, enabled, counted->second, kept);
}

}  // namespace

std::vector<ScanInput> scanInputsOf(const EncodedScan& scan) {
  std::vector<ScanInput> inputs;
  for (const Cell& cell : scan.cells()) {
    if (cell.kind != CellKind::Input) continue;
    const Place& p = cell.place;
    if (p.isRegister) continue;
    if (p.width == 1) {
      inputs.push_back({direct(p.area, Width::Bit, p.byte(), p.bit()), cell.start});
    } else {
      for (int i = 0; i < p.width; i += 8) {
        inputs.push_back(
            {direct(p.area, Width::Byte, p.byte() + static_cast<std::uint32_t>(i) / 8), cell.start, p.width - 8 - i});
      }
    }
  }
  for (std::uint32_t counter = 0; counter < regInfo(Reg::HscCurrent).count; ++counter) {
    const Node seen = countIn(scan, counter);
    if (seen != noNode) inputs.push_back({direct(Area::HC, Width::DWord, counter), seen});
  }
  const Area analog = scan.plan().dialect().memory.analogInputs;
  for (const auto& [byte, sample] : scan.analogInputs()) inputs.push_back({direct(analog, Width::Word, byte), sample});
  return inputs;
}

}  // namespace rungproof
