// Blocks whose outputs depend on what no program tells.
#include "ir/s7300/library_contract.hpp"

#include <fmt/format.h>

#include "ir/s7300/block.hpp"

namespace rungproof::s7300 {

namespace {

using enum BlockType;

}  // namespace

bool isContractOnly(const LibraryBlock& block) { return block.isContract; }

bool isContractOnly(const Pou& pou) {
  if (pou.type != Fc && pou.type != Sfc && pou.type != Sfb) return false;
  const LibraryBlock* block = libraryBlock(pou.type, static_cast<std::uint32_t>(numberOfBlock(pou.number)));
  if (block == nullptr) return pou.type != Fc && pou.isBuiltIn;
  return isContractOnly(*block) && pou.name == standInName(*block);
}

std::string standInName(const LibraryBlock& block) {
  return fmt::format("{} {}", blockName(blockNumber(block.type, block.number)), block.name);
}

std::string_view effectOutside(BlockType type, int number) {
  // COUNT, FREQUENC, PULSE of a CPU 31xC (002:2367)
  if (type == Sfb && number >= 47 && number <= 49)
    return "an output of the CPU that the block drives itself is not the one of the image";
  const LibraryBlock* block = libraryBlock(type, static_cast<std::uint32_t>(number));
  return block == nullptr ? std::string_view() : block->outside;
}

}  // namespace rungproof::s7300
