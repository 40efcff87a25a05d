// Numbers of code blocks of an S7-300/400: one number for kind and number together, as Pou::number and the operand of
// a call hold it.
#pragma once

#include <cstdint>
#include <string>

#include "ir/program.hpp"

namespace rungproof {

constexpr int blockNumber(BlockType type, int number) { return static_cast<int>(type) << 16 | number; }
constexpr BlockType blockTypeOf(int block) { return static_cast<BlockType>(block >> 16); }
constexpr int numberOfBlock(int block) { return block & 0xFFFF; }
/// Whether a call names data of its own for the block.
constexpr bool hasInstance(BlockType type) { return type == BlockType::Fb || type == BlockType::Sfb; }
inline bool hasInstance(const Pou& pou) { return hasInstance(pou.type); }
/// What a call means whose block is a number that the run computes, or a parameter: the IR holds block 0 of its kind.
constexpr BlockType typeOfComputedCall(std::int64_t block) {
  return blockTypeOf(static_cast<int>(block)) == BlockType::Fb ? BlockType::Fb : BlockType::Fc;
}
/// TP, TON and TOF: SFB 3 to 5 (002:2516-2532).
constexpr bool isIecTimer(int block) {
  return blockTypeOf(block) == BlockType::Sfb && numberOfBlock(block) >= 3 && numberOfBlock(block) <= 5;
}
/// "FC5", "SFB4".
std::string blockName(int block);

}  // namespace rungproof
