// Reads them.
#include "frontend/settings/retentive_range.hpp"

#include "frontend/property/external_range.hpp"
#include "frontend/step7/name_lookup.hpp"
#include "frontend/stl/operand_reader.hpp"

namespace rungproof {

namespace {

std::optional<Operand> endNamed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  Operand operand;
  if (!readAddress(text, Spelling::International, operand)) {
    const std::optional<Operand> step7 = step7::addressNamed(text);
    if (!step7) return std::nullopt;
    operand = *step7;
  }
  if (!areaInfo(operand.area).mayRetain) return std::nullopt;
  const bool isByte = operand.width == Width::Byte;
  return isByte || hasBitAndWord(operand.area) ? std::optional(operand) : std::nullopt;
}

}  // namespace

std::optional<RetentiveRange> retentiveRangeNamed(std::string_view text) {
  const std::size_t dots = text.find("..");
  const auto first = endNamed(text.substr(0, dots));
  const auto last =
      dots == std::string_view::npos ? first : endNamed(lastOfRange(text.substr(0, dots), text.substr(dots + 2)));
  if (!first || !last || !areOfOneArea(*first, *last) || last->offset < first->offset) return std::nullopt;
  return RetentiveRange{first->area, first->offset, last->offset};
}

std::optional<std::uint32_t> clockMemoryNamed(std::string_view text) {
  const auto range = retentiveRangeNamed(text);
  const bool isByte = range && range->area == Area::M && range->first == range->last;
  return isByte ? std::optional(range->first) : std::nullopt;
}

std::optional<LibraryMemory> libraryMemoryNamed(std::string_view text) {
  const std::size_t equals = text.find('=');
  const std::string_view block = equals == std::string_view::npos ? std::string_view() : text.substr(0, equals);
  const auto range = retentiveRangeNamed(text.substr(equals == std::string_view::npos ? 0 : equals + 1));
  if (!range || range->area != Area::V || (block.empty() && equals != std::string_view::npos)) return std::nullopt;
  return LibraryMemory{std::string(block), range->first, range->last};
}

}  // namespace rungproof
