// One row for each block whose outputs depend on what no program tells.
#include "ir/s7300/library_contract.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "ir/s7300/block.hpp"

namespace rungproof::s7300 {

namespace {

using enum BlockType;

/// SFC 26, 79 and 80 are statements whose RET_VAL nobody knows. Which characters numbers have in a STRING is not stated
/// (FC 5, 16, 30, 37 to 39).
constexpr auto contractRows = std::to_array<std::pair<BlockType, std::uint16_t>>({
    {Sfc, 15}, {Sfc, 26}, {Sfc, 79}, {Sfc, 80}, {Sfc, 27}, {Sfc, 28}, {Sfc, 29}, {Sfc, 30}, {Sfc, 31},
    {Sfc, 32}, {Sfc, 33}, {Sfc, 34}, {Sfc, 36}, {Sfc, 37}, {Sfc, 38}, {Sfc, 39}, {Sfc, 40}, {Sfc, 41},
    {Sfc, 42}, {Sfc, 44}, {Fc, 5},   {Fc, 16},  {Fc, 30},  {Fc, 37},  {Fc, 38},  {Fc, 39},
});

}  // namespace

bool isContractOnly(const LibraryBlock& block) {
  return std::ranges::find(contractRows, std::pair(block.type, block.number)) != contractRows.end();
}

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
  if (type != Sfc) return {};
  if (number == 15) return "what it sends to a DP slave is no output of the program";
  if (number == 26) return "every input of the image may change where it is called, whatever PART says";
  if (number == 79 || number == 80)
    return "it writes the image of the outputs, and the modules get that where the scan ends";
  if (number == 27) return "outputs are looked at where the scan ends, not where it writes them";
  return {};
}

}  // namespace rungproof::s7300
