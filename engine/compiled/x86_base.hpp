// A register through which a stretch of memory is reached. It points into the stretch, where most of what is used lies
// within 128 bytes to either side: displacements up to there take one byte instead of four, and how many bytes code has
// decides how fast long code runs.
#pragma once

#include <asmjit/x86.h>

#include <cstdint>

namespace rungproof::compiled {

struct X86Base {
  asmjit::x86::Gp reg;
  std::int32_t origin = 0;  ///< byte of the stretch that the register points to

  /// `size`: bytes of the operand, 0: as the instruction says.
  asmjit::x86::Mem at(std::uint64_t byte, std::uint32_t size = 0) const {
    return asmjit::x86::ptr(reg, static_cast<std::int32_t>(byte) - origin, size);
  }
  /// Byte `byte` plus `index` shifted to the left.
  asmjit::x86::Mem at(const asmjit::x86::Gp& index, std::uint32_t shift, std::uint64_t byte, std::uint32_t size) const {
    return asmjit::x86::ptr(reg, index, shift, static_cast<std::int32_t>(byte) - origin, size);
  }
};

}  // namespace rungproof::compiled
