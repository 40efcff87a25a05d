// Names of a finished program.
#include "frontend/step7/name_lookup.hpp"

#include <algorithm>

#include "frontend/step7/operand_parser.hpp"
#include "ir/block_map.hpp"
#include "ir/s7300/declarations.hpp"

namespace rungproof::step7 {

namespace {

/// `declarations`: names of data blocks; nullptr: only numbers are known.
std::optional<rungproof::Operand> placeOfAddress(const s7300::Declarations* declarations, const Operand& operand) {
  static constexpr Area areas[] = {Area::I, Area::Q,  Area::M,  Area::PI, Area::PQ,
                                   Area::L, Area::DB, Area::DB, Area::T,  Area::C};
  std::uint32_t offset = operand.number;
  if (operand.place == Place::DB || operand.place == Place::DI || operand.place == Place::L) {
    if (!operand.block || operand.place != Place::DB) return std::nullopt;  // no place without a block that is open
    std::uint32_t block = operand.block->number;
    if (!operand.block->kind) {
      if (declarations == nullptr) return std::nullopt;
      const auto named = declarations->dataBlockNames.find(s7300::foldedName(operand.block->symbol));
      if (named == declarations->dataBlockNames.end()) return std::nullopt;
      block = named->second;
    }
    if (block == 0 || block > lastDataBlock) return std::nullopt;
    offset = dataByte(block, operand.number);
  }
  return direct(areas[static_cast<int>(operand.place)], static_cast<Width>(operand.size), offset, operand.bit);
}

/// The block by its name, or by a number that was read.
std::optional<rungproof::Operand> placeOfParts(const Program& program, const std::optional<BlockName>& numbered,
                                               std::string_view block, std::span<const PathStep> path,
                                               std::string_view text) {
  const s7300::Declarations& declarations = *program.declarations;
  const auto named = declarations.dataBlockNames.find(s7300::foldedName(block));
  if (!numbered && named == declarations.dataBlockNames.end()) return std::nullopt;
  std::optional<rungproof::Operand> place = declarations.place(numbered ? numbered->number : named->second, path);
  if (place) place->text = text;
  return place;
}

}  // namespace

std::optional<rungproof::Operand> addressNamed(std::string_view text) {
  for (const MnemonicSet set : {MnemonicSet::International, MnemonicSet::German}) {
    Cursor cursor(text, 0);
    const OperandOutcome read = readOperand7(cursor, {set, TextEncoding::Utf8});
    if (!read.fault.empty() || !cursor.atEnd() || read.operand.form != OperandForm::Address) continue;
    return placeOfAddress(nullptr, read.operand);
  }
  return std::nullopt;
}

namespace {

/// Data blocks end where their declarations end, and only those of the program are there.
bool isInBlock(const Program& program, const rungproof::Operand& operand) {
  if (operand.area != Area::DB) return true;
  const std::uint32_t end = byteInBlock(operand.offset) + static_cast<std::uint32_t>(bytes(operand.width));
  return std::ranges::any_of(program.dataBlocks, [&](const DataBlock& block) {
    return block.number == blockOfByte(operand.offset) && end <= block.bytes.size();
  });
}

std::optional<rungproof::Operand> namedAnywhere(const Program& program, std::string_view text) {
  if (const Symbol* symbol = program.symbolNamed(text)) {
    rungproof::Operand operand = symbol->address;
    operand.text = symbol->name;
    return operand;
  }
  for (const MnemonicSet set : {MnemonicSet::International, MnemonicSet::German}) {
    Cursor cursor(text, 0);
    const OperandOutcome read = readOperand7(cursor, {set, TextEncoding::Utf8});
    if (!read.fault.empty() || !cursor.atEnd()) continue;
    if (read.operand.form == OperandForm::Address) return placeOfAddress(program.declarations.get(), read.operand);
    if (read.operand.form == OperandForm::Symbol) {
      if (!read.operand.path.empty())
        return placeOfParts(program, read.operand.block, read.operand.name, read.operand.path, text);
      if (const Symbol* symbol = program.symbolNamed(read.operand.name)) return symbol->address;
    }
    // Motor.Speed: a data block's name without its marks, DB10.Speed.
    const bool isPath =
        read.operand.form == OperandForm::Local && read.operand.path.size() > 1 && !text.starts_with('#');
    if (!isPath) continue;
    const auto parts = std::span(read.operand.path).subspan(1);
    if (auto place = placeOfParts(program, std::nullopt, read.operand.path[0].name, parts, text)) return place;
  }
  return std::nullopt;
}

}  // namespace

std::optional<rungproof::Operand> placeNamed(const Program& program, std::string_view text) {
  if (program.declarations == nullptr) return std::nullopt;
  const std::optional<rungproof::Operand> operand = namedAnywhere(program, text);
  return operand && isInBlock(program, *operand) ? operand : std::nullopt;
}

}  // namespace rungproof::step7
