// Names, ranges and literals.
#include "frontend/graphical/iec_type.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "frontend/stl/operand_reader.hpp"
#include "frontend/stl/stl_lexer.hpp"

namespace rungproof {

namespace {

struct TypeRow {
  std::string_view name;
  Width width;
  std::int64_t low, high;
};
constexpr std::array<TypeRow, 14> typeRows = {{{"", Width::Bit, 0, 0},
                                               {"BOOL", Width::Bit, 0, 1},
                                               {"SINT", Width::Byte, -128, 127},
                                               {"USINT", Width::Byte, 0, 255},
                                               {"BYTE", Width::Byte, 0, 255},
                                               {"INT", Width::Word, -32768, 32767},
                                               {"UINT", Width::Word, 0, 65535},
                                               {"WORD", Width::Word, 0, 65535},
                                               {"DINT", Width::DWord, -2147483648LL, 2147483647LL},
                                               {"UDINT", Width::DWord, 0, 4294967295LL},
                                               {"DWORD", Width::DWord, 0, 4294967295LL},
                                               {"TIME", Width::DWord, -2147483648LL, 2147483647LL},
                                               {"REAL", Width::DWord, 0, 4294967295LL},
                                               {"STRING", Width::Byte, 0, 0}}};
const TypeRow& rowOf(IecType type) { return typeRows[static_cast<std::size_t>(type)]; }

std::string withoutUnderscores(std::string_view text) {
  std::string result(text);
  std::erase(result, '_');
  return result;
}

std::optional<std::int64_t> integer(std::string_view text) {
  std::string digits = withoutUnderscores(text);
  int base = 10;
  const std::size_t mark = digits.find('#');
  if (mark != std::string::npos) {
    const std::string prefix = digits.substr(0, mark);
    base = prefix == "16" ? 16 : prefix == "8" ? 8 : prefix == "2" ? 2 : 0;
    if (base == 0) return std::nullopt;
    digits.erase(0, mark + 1);
  }
  const char* begin = digits.data() + (!digits.empty() && digits[0] == '+' ? 1 : 0);
  const char* end = digits.data() + digits.size();
  std::int64_t value = 0;
  const auto result = std::from_chars(begin, end, value, base);
  if (begin == end || result.ec != std::errc() || result.ptr != end) return std::nullopt;
  return value;
}

std::optional<std::int64_t> real(std::string_view text) {
  const std::string digits = withoutUnderscores(text);
  if (digits.find_first_of(".eE") == std::string::npos ||
      digits.find_first_not_of("0123456789.eE+-") != std::string::npos)
    return std::nullopt;
  char* end = nullptr;
  const float value = std::strtof(digits.c_str(), &end);
  if (end != digits.c_str() + digits.size() || !std::isfinite(value)) return std::nullopt;
  return static_cast<std::int64_t>(std::bit_cast<std::uint32_t>(value));
}

/// 1d2h3m4s5ms, any part with a fraction; ms in all, exact.
std::optional<std::int64_t> duration(std::string_view text) {
  std::string rest = withoutUnderscores(text);
  const bool isNegative = !rest.empty() && rest[0] == '-';
  if (isNegative) rest.erase(0, 1);
  if (rest.empty()) return std::nullopt;
  double sum = 0;
  std::size_t at = 0;
  while (at < rest.size()) {
    std::size_t end = at;
    while (end < rest.size() && (isDigit(rest[end]) || rest[end] == '.')) ++end;
    std::size_t unitEnd = end;
    while (unitEnd < rest.size() && isLetter(rest[unitEnd])) ++unitEnd;
    std::string unit = rest.substr(end, unitEnd - end);
    std::transform(unit.begin(), unit.end(), unit.begin(), upper);
    const double factor = unit == "MS"  ? 1
                          : unit == "S" ? 1000
                          : unit == "M" ? 60000
                          : unit == "H" ? 3600000
                          : unit == "D" ? 86400000
                                        : 0;
    if (end == at || end - at > 15 || factor == 0) return std::nullopt;
    sum += std::strtod(rest.substr(at, end - at).c_str(), nullptr) * factor;
    at = unitEnd;
  }
  if (sum > 2147483647.0 || sum != std::floor(sum)) return std::nullopt;
  return static_cast<std::int64_t>(isNegative ? -sum : sum);
}

}  // namespace

IecType iecTypeNamed(std::string_view name) {
  for (std::size_t i = 1; i < typeRows.size(); ++i) {
    if (equalsIgnoringCase(typeRows[i].name, name)) return static_cast<IecType>(i);
  }
  return IecType::None;
}

std::string_view iecTypeName(IecType type) {
  return type == IecType::None ? std::string_view("no type") : rowOf(type).name;
}
Width widthOf(IecType type) { return rowOf(type).width; }

std::string_view moveOf(IecType type) {
  if (type == IecType::Real) return "MOVR";
  switch (widthOf(type)) {
    case Width::Byte: return "MOVB";
    case Width::Word: return "MOVW";
    default: return "MOVD";
  }
}
bool isSignedInteger(IecType type) {
  return type == IecType::Sint || type == IecType::Int || type == IecType::Dint || type == IecType::Time;
}
bool isUnsignedInteger(IecType type) {
  return type == IecType::Usint || type == IecType::Uint || type == IecType::Udint;
}
bool isBitString(IecType type) { return type == IecType::Byte || type == IecType::Word || type == IecType::Dword; }
bool fits(std::int64_t value, IecType type) { return value >= rowOf(type).low && value <= rowOf(type).high; }

std::optional<IecLiteral> iecLiteral(std::string_view text) {
  text = trimmed(text);
  if (text.empty()) return std::nullopt;
  if (equalsIgnoringCase(text, "TRUE")) return IecLiteral{IecType::Bool, 1};
  if (equalsIgnoringCase(text, "FALSE")) return IecLiteral{IecType::Bool, 0};
  const std::size_t mark = text.find('#');
  if (mark != std::string_view::npos && isLetter(text[0])) {
    const std::string_view prefix = text.substr(0, mark), rest = text.substr(mark + 1);
    if (equalsIgnoringCase(prefix, "T") || equalsIgnoringCase(prefix, "TIME")) {
      const auto value = duration(rest);
      return value ? std::optional(IecLiteral{IecType::Time, *value}) : std::nullopt;
    }
    const IecType type = iecTypeNamed(prefix);
    if (type == IecType::None || type == IecType::String || type == IecType::Time) return std::nullopt;
    const auto inner = iecLiteral(rest);
    if (!inner) return std::nullopt;
    if (type == IecType::Real) return inner->type == IecType::Real ? inner : std::nullopt;
    if (inner->type != IecType::None && inner->type != type && !(type == IecType::Bool && inner->type == IecType::Bool))
      return std::nullopt;
    if (!fits(inner->value, type)) return std::nullopt;
    return IecLiteral{type, inner->value};
  }
  if (const auto value = integer(text)) {
    if (*value < -2147483648LL || *value > 4294967295LL) return std::nullopt;
    return IecLiteral{IecType::None, *value};
  }
  if (const auto value = real(text)) return IecLiteral{IecType::Real, *value};
  return std::nullopt;
}

std::optional<Operand> locatedAddress(std::string_view text) {
  text = trimmed(text);
  if (text.size() < 3 || text[0] != '%') return std::nullopt;
  const std::string_view address = text.substr(1);
  Operand operand;
  if (readAddress(address, Spelling::International, operand)) return operand;
  const char area = upper(address[0]);
  const char size = upper(address[1]);
  if ((area != 'I' && area != 'Q' && area != 'M') || size != 'X') return std::nullopt;
  const std::string_view digits = address.substr(2);
  const std::size_t point = digits.find('.');
  const auto byte = integer(digits.substr(0, point));
  if (!byte || *byte < 0 || *byte > 99999) return std::nullopt;
  const Area place = area == 'I' ? Area::I : area == 'Q' ? Area::Q : Area::M;
  if (point == std::string_view::npos)
    return direct(place, Width::Bit, static_cast<std::uint32_t>(*byte / 8), static_cast<unsigned>(*byte % 8));
  const auto bit = integer(digits.substr(point + 1));
  if (!bit || *bit < 0 || *bit > 7) return std::nullopt;
  return direct(place, Width::Bit, static_cast<std::uint32_t>(*byte), static_cast<unsigned>(*bit));
}

}  // namespace rungproof
