// From recorded code to machine code of this processor.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "engine/compiled/code.hpp"

namespace rungproof::compiled {

/// What the machine code works on.
struct Workspace {
  std::array<std::uint8_t*, areaCount> area{};
  std::uint32_t* registers = nullptr;
  std::uint8_t* slots = nullptr;           ///< a byte for each bit of Code::slots, kept from scan to scan
  std::uint64_t* counts = nullptr;         ///< by error site: occurrences in this scan
  const std::uint8_t* isListed = nullptr;  ///< by error site: has happened before, the place and scan are known
  std::uint64_t hasCounted = 0;
  std::uint64_t position = 0;  ///< out: time that the program took, 10 ns (Code::countsTime)
  std::uint64_t mostTime = 0;  ///< a longer program is one for the reference engine
  std::uint64_t ticks100 = 0;
};

class MachineCode {
 public:
  virtual ~MachineCode() = default;
  /// False: the scan is one for the reference engine, and what was written is to be taken back.
  virtual bool run(Workspace& workspace) const = 0;
};

/// Whether there is machine code for this processor.
bool canTranslate();
/// `isNeeded`: by step. nullptr: it does not work on this machine.
std::unique_ptr<MachineCode> translated(const Code& code, const std::vector<bool>& isNeeded);

}  // namespace rungproof::compiled
