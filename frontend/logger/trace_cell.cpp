// Numbers of cells.
#include "frontend/logger/trace_cell.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <limits>

namespace rungproof {

std::string lowered(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
  return result;
}

std::optional<TraceNumber> numberIn(std::string_view text) {
  const std::string lower = lowered(text);
  if (lower == "true") return 1;
  if (lower == "false") return 0;
  const auto whole = [](std::string_view digits, unsigned base) -> std::optional<TraceNumber> {
    std::uint64_t value = 0;
    if (digits.empty()) return std::nullopt;
    for (const char c : digits) {
      if (c == '_') continue;
      const auto digit = static_cast<unsigned>(c >= '0' && c <= '9'   ? c - '0'
                                               : c >= 'a' && c <= 'f' ? c - 'a' + 10
                                                                      : 99);
      if (digit >= base || value > (std::numeric_limits<std::uint64_t>::max() - digit) / base) return std::nullopt;
      value = value * base + digit;
    }
    return static_cast<TraceNumber>(value);
  };
  if (lower.starts_with("16#")) return whole(std::string_view(lower).substr(3), 16);
  if (lower.starts_with("2#")) return whole(std::string_view(lower).substr(2), 2);
  const bool isSigned = lower.starts_with('-') || lower.starts_with('+');
  const std::string_view digits = std::string_view(lower).substr(isSigned ? 1 : 0);
  if (digits.find_first_not_of("0123456789") == std::string_view::npos) {
    // A double would round it.
    if (const auto number = whole(digits, 10)) return lower.starts_with('-') ? -*number : *number;
  }
  std::size_t used = 0;
  try {
    const double value = std::stod(std::string(text), &used);
    const bool isPlain = lower.find_first_of("xp") == std::string::npos;
    return used == text.size() && isPlain ? std::optional<TraceNumber>(value) : std::nullopt;
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

std::optional<TraceNumber> valueIn(std::string_view text, const TraceSignal& signal, std::string& reason) {
  const std::optional<TraceNumber> number = numberIn(text);
  if (!number) {
    reason = fmt::format("'{}' is no value for {}", text, signal.name);
    return std::nullopt;
  }
  const bool isBits = text.starts_with("16#") || text.starts_with("2#");
  const bool isPattern = isBits && (signal.type == SignalType::Real || signal.type == SignalType::LongReal);
  if (signal.isReal() && !isPattern) return number;
  if (*number != std::floor(*number)) {
    reason = fmt::format("{} takes whole numbers, not {}", signal.name, text);
    return std::nullopt;
  }
  const TraceNumber range = std::exp2(static_cast<TraceNumber>(signal.width()));
  const TraceNumber low = signal.type == SignalType::Signed ? -range / 2 : 0;
  if (*number < low || *number >= range) {
    reason = signal.type == SignalType::Bool
                 ? fmt::format("{} is a bit: 0 or 1, not {}", signal.name, text)
                 : fmt::format("{} does not hold {}: the range is {} to {}", signal.name, text,
                               numberText(low, SignalType::Signed), numberText(range - 1, SignalType::Unsigned));
    return std::nullopt;
  }
  if (isPattern) return numberOf(static_cast<std::uint64_t>(*number), signal.type, signal.width());
  return numberOf(valueOf(*number, signal.type, signal.width()), signal.type, signal.width());
}

}  // namespace rungproof
