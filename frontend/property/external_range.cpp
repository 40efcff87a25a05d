// Reads them.
#include "frontend/property/external_range.hpp"

#include "frontend/stl/operand_reader.hpp"

namespace rungproof {

namespace {

std::optional<Operand> externalEndNamed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  Operand operand;
  if (!readAddress(text, Spelling::International, operand) || !mayBeExternal(operand.area)) return std::nullopt;
  return operand;
}

}  // namespace

std::optional<ExternalRange> externalRangeNamed(std::string_view text) {
  const std::size_t dots = text.find("..");
  const auto first = externalEndNamed(text.substr(0, dots));
  const auto last = dots == std::string_view::npos ? first : externalEndNamed(text.substr(dots + 2));
  if (!first || !last || first->area != last->area || first->width != last->width) return std::nullopt;
  const auto place = [](const Operand& o) { return o.offset * 8 + (o.width == Width::Bit ? o.bit : 0U); };
  if (place(*last) < place(*first)) return std::nullopt;
  return ExternalRange{.first = *first, .last = *last};
}

}  // namespace rungproof
