// From recorded code to machine code of this processor.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "engine/compiled/code.hpp"

namespace rungproof::compiled {

/// The head of what the machine code works on. Behind it stand, at the bytes that Layout gives, a byte for each bit of
/// Code::slots, eight for each state of the walk, the errors, and room for values.
struct Workspace {
  std::array<std::uint8_t*, areaCount> area{};
  std::uint32_t* registers = nullptr;
  std::uint64_t ticks100 = 0;
  std::uint64_t mostTime = 0;    ///< 10 ns; a longer program is one for the reference engine
  std::uint64_t position = 0;    ///< out: time that the program took (Code::countsTime)
  std::uint64_t isLeft = 0;      ///< out, straight code: not 0, the scan is one for the reference engine
  std::uint64_t hasErrors = 0;   ///< out: an error has happened that is new (Layout::news)
  std::uint64_t hasCounted = 1;  ///< out: not 0, an error has happened, new or not
  std::uint64_t allOnes = ~std::uint64_t{0};
};

/// Bytes of the workspace.
struct Layout {
  std::size_t slots = 0;  ///< the bits of Code::slots
  std::size_t states = 0;
  std::size_t errors = 0;  ///< by error site 8 bytes: how often it has happened, added up over the scans
  std::size_t news = 0;    ///< by error site a byte, 1: it has not yet been told
  std::size_t size = 0;
};

class MachineCode {
 public:
  virtual ~MachineCode() = default;
  /// False: the scan is one for the reference engine, and what was written is to be taken back.
  virtual bool run(Workspace& workspace) const = 0;
  Layout layout;
};

/// Whether there is machine code for this processor.
bool canTranslate();
/// `isNeeded`: by step. nullptr: it does not work on this machine.
std::unique_ptr<MachineCode> translated(const Code& code, const std::vector<bool>& isNeeded);

}  // namespace rungproof::compiled
