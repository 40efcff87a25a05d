// Names of data.
#include "ir/s7300/declarations.hpp"

#include "ir/block_map.hpp"

namespace rungproof::s7300 {

std::optional<Width> accessWidth(const Type& type) {
  if (type.kind == TypeKind::Bool || type.kind == TypeKind::Timer || type.kind == TypeKind::Counter) return Width::Bit;
  if (isComplex(type)) return std::nullopt;
  switch (sizeOf(type)) {
    case 1: return Width::Byte;
    case 2: return Width::Word;
    case 4: return Width::DWord;
    default: return std::nullopt;
  }
}

std::optional<Operand> Declarations::place(std::uint32_t dataBlock, std::span<const PathStep> path) const {
  const auto found = dataBlocks.find(dataBlock);
  if (found == dataBlocks.end() || found->second == nullptr) return std::nullopt;
  const PathResult result = lookUp(*found->second, path);
  if (result.fault != PathFault::None || result.type == nullptr || result.byReference) return std::nullopt;
  const std::optional<Width> width = accessWidth(*result.type);
  if (!width) return std::nullopt;
  return direct(Area::DB, *width, dataByte(dataBlock, result.byte), result.bit);
}

}  // namespace rungproof::s7300
