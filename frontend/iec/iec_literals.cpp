// Literals: numbers, durations, dates.
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdlib>

#include "frontend/iec/iec_types.hpp"

namespace rungproof::iec {

bool isWithinReal(double real, int width) {
  return std::isfinite(width == 64 ? real : static_cast<double>(static_cast<float>(real)));
}

namespace {

/// Digits of a number in some base, without underscores.
std::optional<std::uint64_t> digitsOf(std::string_view text, int base) {
  std::string digits;
  for (const char c : text) {
    if (c != '_') digits += c;
  }
  std::uint64_t value = 0;
  const auto result = std::from_chars(digits.data(), digits.data() + digits.size(), value, base);
  if (digits.empty() || result.ec != std::errc() || result.ptr != digits.data() + digits.size()) return std::nullopt;
  return value;
}

/// A whole number without a type.
std::optional<Value> integerOf(std::string_view text) {
  const bool isNegative = text.starts_with("-");
  if (isNegative || text.starts_with("+")) text.remove_prefix(1);
  const std::size_t mark = text.find('#');
  int base = 10;
  if (mark != std::string_view::npos) {
    std::from_chars(text.data(), text.data() + mark, base);
    if (base != 2 && base != 8 && base != 16) return std::nullopt;
    text.remove_prefix(mark + 1);
  }
  const auto value = digitsOf(text, base);
  if (!value) return std::nullopt;
  Value made{nullptr, static_cast<std::int64_t>(*value)};
  made.isHuge = made.number < 0;
  made.isPattern = mark != std::string_view::npos;
  if (!isNegative) return made;
  if (made.isHuge && *value != std::uint64_t{1} << 63) return std::nullopt;
  made.number = static_cast<std::int64_t>(0 - *value);
  made.isHuge = false;
  return made;
}

bool isRealText(std::string_view text) {
  return text.find('#') == std::string_view::npos &&
         (text.find('.') != std::string_view::npos || text.find_first_of("eE") != std::string_view::npos);
}

/// Nothing, with the reason, where the number is beyond the largest one of the type; without a type it may be an LREAL.
std::optional<Value> realValue(std::string_view text, const Type* type, std::string& reason) {
  std::string digits;
  for (const char c : text) {
    if (c != '_') digits += c;
  }
  const double real = std::strtod(digits.c_str(), nullptr);
  if (isWithinReal(real, type != nullptr ? type->width : 64)) return realConstant(real, type);
  reason = fmt::format("{} is too large for {}", excerpt(text), type != nullptr ? type->name : "LREAL");
  return std::nullopt;
}

/// Days from 1970-01-01 to a date of the Gregorian calendar; nothing if there is no such date.
std::optional<std::int64_t> daysTo(std::int64_t year, std::int64_t month, std::int64_t day) {
  static constexpr int lengths[] = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
  if (year < 1970 || year > 2262 || month < 1 || month > 12 || day < 1) return std::nullopt;
  const auto isLeap = [](std::int64_t y) { return (y % 4 == 0 && y % 100 != 0) || y % 400 == 0; };
  if (day > lengths[month - 1] + (month == 2 && isLeap(year) ? 1 : 0)) return std::nullopt;
  std::int64_t days = day - 1;
  for (std::int64_t y = 1970; y < year; ++y) days += isLeap(y) ? 366 : 365;
  for (std::int64_t m = 1; m < month; ++m) days += lengths[m - 1] + (m == 2 && isLeap(year) ? 1 : 0);
  return days;
}

/// Numbers between marks: `2024-02-29`.
std::optional<std::vector<std::int64_t>> numbersIn(std::string_view text, char mark, std::size_t count) {
  std::vector<std::int64_t> numbers;
  for (;;) {
    const std::size_t end = std::min(text.find(mark), text.size());
    const auto number = digitsOf(text.substr(0, end), 10);
    if (!number || *number > 100'000) return std::nullopt;
    numbers.push_back(static_cast<std::int64_t>(*number));
    if (end == text.size()) break;
    text.remove_prefix(end + 1);
  }
  return numbers.size() == count ? std::optional(numbers) : std::nullopt;
}

/// Ns since midnight of `15:36:55.36`.
std::optional<std::int64_t> timeOfDay(std::string_view text) {
  const std::size_t point = text.find('.');
  const auto parts = numbersIn(text.substr(0, point), ':', 3);
  if (!parts || (*parts)[0] > 23 || (*parts)[1] > 59 || (*parts)[2] > 59) return std::nullopt;
  std::int64_t ns = (((*parts)[0] * 60 + (*parts)[1]) * 60 + (*parts)[2]) * 1'000'000'000;
  if (point == std::string_view::npos) return ns;
  std::string fraction(text.substr(point + 1));
  std::erase(fraction, '_');
  if (fraction.size() > 9) return std::nullopt;
  fraction.resize(9, '0');
  const auto digits = digitsOf(fraction, 10);
  return digits ? std::optional(ns + static_cast<std::int64_t>(*digits)) : std::nullopt;
}

/// A date, a time of day or both, as the type counts.
std::optional<Value> dateValue(const Type& type, std::string_view text) {
  constexpr std::int64_t day = 86'400'000'000'000;
  std::int64_t ns = 0;
  const bool hasDate = !type.name.ends_with("TOD"), hasTime = !type.name.ends_with("DATE");
  if (hasDate) {
    std::size_t end = text.size();
    if (hasTime) {
      end = text.rfind('-');
      if (end == std::string_view::npos) return std::nullopt;
    }
    const auto parts = numbersIn(text.substr(0, end), '-', 3);
    const auto days = parts ? daysTo((*parts)[0], (*parts)[1], (*parts)[2]) : std::nullopt;
    if (!days || *days > 106'751) return std::nullopt;  // 2^63 ns
    ns = *days * day;
    text.remove_prefix(hasTime ? end + 1 : end);
  }
  if (hasTime) {
    const auto time = timeOfDay(text);
    if (!time) return std::nullopt;
    ns += *time;
  }
  const std::int64_t unit = type.isLong() ? 1 : hasDate ? 1'000'000'000 : 1'000'000;
  if (ns % unit != 0 || (!type.isLong() && ns / unit > type.high)) return std::nullopt;
  return Value{&type, ns / unit};
}

std::optional<Value> numberOf(const Type& type, const std::string& text) {
  auto value = integerOf(text);
  if (!value) return std::nullopt;
  value->type = &type;
  if (type.isLong()) {
    const bool isPattern = text.find('#') != std::string::npos;
    if (value->isHuge ? type.isSigned && !isPattern : !type.isSigned && value->number < 0) return std::nullopt;
    if (type.isSigned) value->isHuge = false;
    return value;
  }
  if (value->isHuge) return std::nullopt;
  if (value->number >= type.low && value->number <= type.high) return value;
  const std::int64_t top = std::int64_t{1} << type.width;
  if (text.find('#') == std::string::npos || value->number < 0 || value->number >= top) return std::nullopt;
  value->number -= top;
  return value;
}

}  // namespace

std::int64_t realPattern(double real, int width) {
  return width == 64 ? std::bit_cast<std::int64_t>(real)
                     : static_cast<std::int64_t>(std::bit_cast<std::uint32_t>(static_cast<float>(real)));
}

Value realConstant(double real, const Type* type) {
  Value made;
  made.type = type;
  made.isReal = true;
  made.real = real;
  made.number = realPattern(real, type != nullptr ? type->width : 32);
  return made;
}

std::optional<Value> literalValue(const Expr& literal, std::string& reason) {
  const std::string& text = literal.text;
  if (literal.prefix.empty()) {
    const std::string word = foldedName(text);
    if (word == "TRUE" || word == "FALSE") return Value{elementaryType("BOOL"), word == "TRUE" ? 1 : 0};
    if (isRealText(text)) return realValue(text, nullptr, reason);
    if (const auto value = integerOf(text)) return value;
    reason = fmt::format("{} does not fit into 64 bits", excerpt(text));
    return std::nullopt;
  }
  if (literal.prefix == "T" || literal.prefix == "TIME") {
    if (const auto ms = millisecondsOf(text)) return Value{elementaryType("TIME"), *ms};
    reason = fmt::format("{}#{} is no duration of whole milliseconds up to 24 days", literal.prefix, excerpt(text));
    return std::nullopt;
  }
  if (literal.prefix == "LT" || literal.prefix == "LTIME") {
    if (const auto ns = nanosecondsOf(text)) return Value{elementaryType("LTIME"), *ns};
    reason = fmt::format("{}#{} is no duration of whole nanoseconds up to 292 years", literal.prefix, excerpt(text));
    return std::nullopt;
  }
  const Type* type = elementaryType(literal.prefix == "D" ? "DATE" : literal.prefix == "LD" ? "LDATE" : literal.prefix);
  if (type == nullptr || type->kind == Kind::Unsupported || type->kind == Kind::Text) {
    reason = fmt::format("{}# is not modelled", excerpt(literal.prefix));
    return std::nullopt;
  }
  if (type->kind == Kind::Real) return realValue(text, type, reason);
  if (type->kind == Kind::Date) {
    const auto value = dateValue(*type, text);
    if (!value) reason = fmt::format("{}#{} is no {}", literal.prefix, excerpt(text), type->name);
    return value;
  }
  const std::string word = foldedName(text);
  if (type->kind == Kind::Bool && (word == "TRUE" || word == "FALSE")) return Value{type, word == "TRUE" ? 1 : 0};
  const auto value = numberOf(*type, text);
  if (!value) reason = fmt::format("{} does not fit into {}", excerpt(text), type->name);
  return value;
}

}  // namespace rungproof::iec
