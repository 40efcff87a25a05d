// The rows of the blocks, by kind and number.
#include <algorithm>
#include <array>
#include <utility>

#include "ir/check.hpp"
#include "ir/s7300/library.hpp"
#include "ir/s7300/library/list.hpp"

namespace rungproof::s7300 {

namespace {

/// Stands for any domain, where it matters only whether a block has a meaning.
struct SomeDomain;

template <class Block>
constexpr LibraryBlock rowOf() {
  LibraryBlock row = Block::block;
  row.actsOnCpu = requires(CpuCall<SomeDomain> & call) { Block::act(call); };
  return row;
}

template <class... Blocks>
constexpr auto rowsOf(isa::Group<Blocks...>) {
  std::array<LibraryBlock, sizeof...(Blocks)> rows = {rowOf<Blocks>()...};
  const auto place = [](const LibraryBlock& row) {
    const int kind = row.type == BlockType::Sfb ? 0 : row.type == BlockType::Sfc ? 1 : 2;
    return std::pair(kind, row.number);
  };
  std::ranges::sort(rows, {}, place);
  return rows;
}

constexpr auto libraryRows = rowsOf(library::AllBlocks{});

}  // namespace

std::span<const LibraryBlock> libraryBlocks() { return libraryRows; }

const LibraryBlock* libraryBlock(BlockType type, std::uint32_t number) {
  const auto row =
      std::ranges::find_if(libraryRows, [&](const LibraryBlock& r) { return r.type == type && r.number == number; });
  return row == libraryRows.end() ? nullptr : &*row;
}

const LibraryBlock* libraryBlockNamed(std::string_view name) {
  const auto row = std::ranges::find_if(libraryRows, [&](const LibraryBlock& r) { return isSameName(r.name, name); });
  return row == libraryRows.end() ? nullptr : &*row;
}

std::span<const std::uint16_t> functionsBeyondParameters() {
  // CREAT_DB, DEL_DB, GD_RCV, CREA_DBL, READ_DBL, WRIT_DBL, CREA_DB, SYNC_PI, SYNC_PO (002:2342-2358, general
  // knowledge)
  static constexpr auto numbers = std::to_array<std::uint16_t>({22, 23, 61, 82, 83, 84, 85, 126, 127});
  return numbers;
}

std::span<const std::uint16_t> blocksBeyondParameters() {
  // HS_COUNT, FREQ_MES, HSC_A_B, POS, ANALOG, DIGITAL (002:2367, general knowledge)
  static constexpr auto numbers = std::to_array<std::uint16_t>({29, 30, 38, 39, 44, 46});
  return numbers;
}

std::shared_ptr<const Structure> interfaceOf(const LibraryBlock& block) {
  auto structure = std::make_shared<Structure>();
  auto section = static_cast<int>(Section::Input);
  for (std::string_view rest = block.parameters; !rest.empty();) {
    if (rest[0] == '|' || rest[0] == ' ') {
      section += rest[0] == '|' ? 1 : 0;
      rest.remove_prefix(1);
      continue;
    }
    const std::string_view parameter = rest.substr(0, rest.find_first_of(" |"));
    rest.remove_prefix(parameter.size());
    const std::size_t colon = parameter.find(':');
    const std::optional<Type> type = typeNamed(parameter.substr(colon + 1));
    CHECK(type.has_value(), "the rows name types that exist");
    Field field;
    field.name = parameter.substr(0, colon);
    field.type = *type;
    field.section = static_cast<Section>(section);
    structure->fields.push_back(std::move(field));
  }
  if (block.type == BlockType::Sfb) layOutInstance(*structure);  // parameters of functions stand where the call says
  return structure;
}

}  // namespace rungproof::s7300
