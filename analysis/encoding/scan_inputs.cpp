// Memory is given byte by byte, as areas overlap.
#include "analysis/encoding/scan_inputs.hpp"

namespace rungproof {

std::vector<ScanInput> scanInputsOf(const EncodedScan& scan) {
  std::vector<ScanInput> inputs;
  for (const Cell& cell : scan.cells()) {
    if (cell.kind != CellKind::Input) continue;
    const Place& p = cell.place;
    if (p.isRegister) {
      if (p.reg == Reg::HscCurrent) inputs.push_back({direct(Area::HC, Width::DWord, p.at), cell.start});
    } else if (p.width == 1) {
      inputs.push_back({direct(p.area, Width::Bit, p.byte(), p.bit()), cell.start});
    } else {
      for (int i = 0; i < p.width; i += 8) {
        inputs.push_back(
            {direct(p.area, Width::Byte, p.byte() + static_cast<std::uint32_t>(i) / 8), cell.start, p.width - 8 - i});
      }
    }
  }
  const Area analog = scan.plan().isStep7() ? Area::PI : Area::AI;
  for (const auto& [byte, sample] : scan.analogInputs()) inputs.push_back({direct(analog, Width::Word, byte), sample});
  return inputs;
}

}  // namespace rungproof
