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
  std::uint64_t mostTime = 0;  ///< 10 ns; a longer program is one for the reference engine
  std::uint64_t position = 0;  ///< out: time that the program took (Code::countsTime)
  std::uint64_t isLeft = 0;    ///< out, straight code: not 0, the scan is one for the reference engine
  std::uint64_t happened = 0;  ///< out: error sites at which something has happened, numbers at Layout::happened
  std::uint64_t hasNews = 0;   ///< out: not 0, one of these is new
  std::uint64_t allOnes = ~std::uint64_t{0};
};

/// Bytes of the workspace.
struct Layout {
  std::size_t singles = 0;  ///< the lowest bits of those of Code::slots of which no other bit is used
  std::size_t slots = 0;    ///< the bits of the others
  std::size_t states = 0;
  std::size_t errors = 0;    ///< by error site 4 bytes: how often it has happened, 0 before the program
  std::size_t happened = 0;  ///< 4 bytes for the number of an error site each
  std::size_t news = 0;      ///< by error site a byte, 1: a scan in which it happens is one for the reference engine
  std::size_t size = 0;
};

class MachineCode {
 public:
  virtual ~MachineCode() = default;
  /// False: the scan is one for the reference engine, and what was written is to be taken back; bits that have slots
  /// are as before.
  virtual bool run(Workspace& workspace) const = 0;
  Layout layout;
};

/// Whether there is machine code for this processor.
bool canTranslate();
/// `isNeeded`: by step. nullptr: it does not work on this machine.
std::unique_ptr<MachineCode> translated(const Code& code, const std::vector<bool>& isNeeded);

}  // namespace rungproof::compiled
