// Numbers of cells.
#include "frontend/logger/trace_cell.hpp"

#include <fmt/format.h>

#include <cmath>

namespace rungproof {

std::string lowered(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
  return result;
}

std::optional<double> numberIn(std::string_view text) {
  const std::string lower = lowered(text);
  if (lower == "true") return 1;
  if (lower == "false") return 0;
  const auto whole = [](std::string_view digits, int base) -> std::optional<double> {
    std::uint64_t value = 0;
    if (digits.empty() || digits.size() > 64) return std::nullopt;
    for (const char c : digits) {
      if (c == '_') continue;
      const int digit = c >= '0' && c <= '9' ? c - '0' : c >= 'a' && c <= 'f' ? c - 'a' + 10 : 99;
      if (digit >= base || value >> 32 != 0) return std::nullopt;
      value = value * static_cast<unsigned>(base) + static_cast<unsigned>(digit);
    }
    return static_cast<double>(value);
  };
  if (lower.starts_with("16#")) return whole(std::string_view(lower).substr(3), 16);
  if (lower.starts_with("2#")) return whole(std::string_view(lower).substr(2), 2);
  std::size_t used = 0;
  try {
    const double value = std::stod(std::string(text), &used);
    const bool isPlain = lower.find_first_of("xp") == std::string::npos;
    return used == text.size() && isPlain ? std::optional<double>(value) : std::nullopt;
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

std::optional<double> valueIn(std::string_view text, const TraceSignal& signal, std::string& reason) {
  const std::optional<double> number = numberIn(text);
  if (!number) {
    reason = fmt::format("'{}' is no value for {}", text, signal.name);
    return std::nullopt;
  }
  const bool isBits = text.starts_with("16#") || text.starts_with("2#");
  if (signal.type == SignalType::Real && isBits)
    return numberOf(static_cast<std::uint64_t>(*number), SignalType::Real, signal.width());
  if (signal.isReal()) return number;
  if (*number != std::floor(*number)) {
    reason = fmt::format("{} takes whole numbers, not {}", signal.name, text);
    return std::nullopt;
  }
  const double range = std::exp2(signal.width());
  const double low = signal.type == SignalType::Signed ? -range / 2 : 0;
  if (*number < low || *number >= range) {
    reason = signal.type == SignalType::Bool
                 ? fmt::format("{} is a bit: 0 or 1, not {}", signal.name, text)
                 : fmt::format("{} does not hold {}: the range is {:.0f} to {:.0f}", signal.name, text, low, range - 1);
    return std::nullopt;
  }
  return numberOf(valueOf(*number, signal.type, signal.width()), signal.type, signal.width());
}

}  // namespace rungproof
