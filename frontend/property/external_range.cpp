// Reads them.
#include "frontend/property/external_range.hpp"

#include <fmt/format.h>

#include "frontend/step7/name_lookup.hpp"
#include "frontend/stl/operand_reader.hpp"

namespace rungproof {

namespace {

std::optional<Operand> externalEndNamed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  Operand operand;
  if (!readAddress(text, Spelling::International, operand)) {
    const std::optional<Operand> step7 = step7::addressNamed(text);
    if (!step7) return std::nullopt;
    operand = *step7;
  }
  return mayBeExternal(operand.area) ? std::optional(operand) : std::nullopt;
}

std::uint32_t bitOfEnd(const Operand& o) { return o.offset * 8 + (o.width == Width::Bit ? o.bit : 0U); }

}  // namespace

std::optional<RangeFault> faultOfRange(const Operand& first, const Operand& last) {
  if (!areOfOneArea(first, last) || first.width != last.width)
    return RangeFault{"both ends of a range need the same area (or data block) and width",
                      "write for example: external VB100..VB199"};
  if (!mayBeExternal(first.area))
    return RangeFault{fmt::format("{} cannot be external: only V, M, DB, S, SM and Q memory is written from outside",
                                  toString(first)),
                      "inputs have any value anyway; let the panel write V or M memory"};
  if (bitOfEnd(first) > bitOfEnd(last))
    return RangeFault{fmt::format("the range ends at {} before it begins at {}", toString(last), toString(first)),
                      "write the lower address first"};
  return std::nullopt;
}

std::string lastOfRange(std::string_view first, std::string_view last) {
  const bool isShort = last.size() > 3 && last.starts_with("DB") && (last[2] < '0' || last[2] > '9');
  const std::size_t dot = first.find('.');
  return std::string(isShort && dot != std::string_view::npos ? first.substr(0, dot + 1) : "") + std::string(last);
}

std::optional<ExternalRange> externalRangeNamed(std::string_view text) {
  const std::size_t dots = text.find("..");
  const auto first = externalEndNamed(text.substr(0, dots));
  const auto last = dots == std::string_view::npos
                        ? first
                        : externalEndNamed(lastOfRange(text.substr(0, dots), text.substr(dots + 2)));
  if (!first || !last || faultOfRange(*first, *last)) return std::nullopt;
  return ExternalRange{.first = *first, .last = *last};
}

}  // namespace rungproof
