// Spelling of numbers and texts.
#include "frontend/stl/constant_reader.hpp"

#include <array>
#include <bit>
#include <charconv>
#include <cmath>

#include "frontend/stl/stl_lexer.hpp"

namespace rungproof {

namespace {

int digitValue(char c) {
  if (isDigit(c)) return c - '0';
  const char u = upper(c);
  return u >= 'A' && u <= 'F' ? u - 'A' + 10 : 99;
}

struct Prefix {
  std::string_view spelling;
  Width width;
};
/// B# is shown for no type in the manual; DW# is (001:6811). The others are those of the import syntax.
constexpr std::array<Prefix, 11> prefixes = {{{"B", Width::Byte},
                                              {"W", Width::Word},
                                              {"DW", Width::DWord},
                                              {"D", Width::DWord},
                                              {"BYTE", Width::Byte},
                                              {"WORD", Width::Word},
                                              {"DWORD", Width::DWord},
                                              {"INT", Width::Word},
                                              {"DINT", Width::DWord},
                                              {"REAL", Width::DWord},
                                              {"L", Width::DWord}}};

ConstantResult fail(ConstantFault fault) {
  ConstantResult result;
  result.fault = fault;
  return result;
}
ConstantResult give(std::int64_t value, ConstantForm form) { return {ConstantFault::None, constant(value, form)}; }

ConstantResult readBased(std::string_view digits, int base, ConstantForm form) {
  std::uint64_t value = 0;
  int count = 0;
  for (const char c : digits) {
    if (c == '_') continue;
    const int digit = digitValue(c);
    if (digit >= base) return fail(ConstantFault::BadDigits);
    if (value > (~0ULL >> 1) / static_cast<unsigned>(base)) return fail(ConstantFault::TooLarge);
    value = value * static_cast<unsigned>(base) + static_cast<unsigned>(digit);
    ++count;
  }
  if (count == 0) return fail(ConstantFault::Empty);
  return give(static_cast<std::int64_t>(value), form);
}

ConstantResult readReal(std::string_view text) {
  float value = 0;
  const std::string_view digits = text[0] == '+' ? text.substr(1) : text;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (end != digits.data() + digits.size() || error == std::errc::invalid_argument)
    return fail(ConstantFault::BadDigits);
  if (error == std::errc::result_out_of_range) {
    double wide = 0;  // too small for single precision is 0, too large is a fault
    if (std::from_chars(digits.data(), digits.data() + digits.size(), wide).ec != std::errc() || std::fabs(wide) > 1)
      return fail(ConstantFault::TooLarge);
    value = static_cast<float>(wide);
  }
  return give(std::bit_cast<std::uint32_t>(value), ConstantForm::Real);
}

ConstantResult readDecimal(std::string_view text) {
  const bool isSigned = text[0] == '+' || text[0] == '-';
  const std::string_view digits = isSigned ? text.substr(1) : text;
  if (digits.empty()) return fail(ConstantFault::NotAConstant);
  std::int64_t value = 0;
  for (const char c : digits) {
    if (!isDigit(c)) return fail(ConstantFault::BadDigits);
    if (value > 99999999999) return fail(ConstantFault::TooLarge);
    value = value * 10 + (c - '0');
  }
  if (text[0] == '-') value = -value;
  if (value > 0xFFFFFFFFLL || value < -0x80000000LL) return fail(ConstantFault::TooLarge);
  return give(value, isSigned ? ConstantForm::SignedDecimal : ConstantForm::Decimal);
}

ConstantResult readQuoted(std::string_view text, TextEncoding encoding) {
  const char kind = quoteAt(text, 0).kind;
  const std::optional<std::string> characters = unquoted(text, encoding);
  if (!characters) return fail(ConstantFault::BadDigits);
  if (kind == '"') {
    ConstantResult result{ConstantFault::None, {}};
    result.operand.kind = OperandKind::Text;
    result.operand.text = *characters;
    return result;
  }
  if (characters->empty()) return fail(ConstantFault::Empty);
  if (characters->size() > 4) return fail(ConstantFault::TooLong);
  std::int64_t value = 0;
  for (const char c : *characters) value = value << 8 | static_cast<unsigned char>(c);
  return give(value, ConstantForm::Ascii);
}

ConstantResult readTyped(std::string_view prefix, std::string_view rest) {
  for (const Prefix& row : prefixes) {
    if (!equalsIgnoringCase(row.spelling, prefix)) continue;
    if (rest.empty()) return fail(ConstantFault::Empty);
    ConstantResult result = readConstant(rest);
    if (result.fault != ConstantFault::None)
      return fail(result.fault == ConstantFault::NotAConstant ? ConstantFault::BadDigits : result.fault);
    if (result.operand.kind != OperandKind::Constant) return fail(ConstantFault::BadDigits);
    const std::int64_t limit = 1LL << bits(row.width);
    if (result.operand.value >= limit || result.operand.value < -limit / 2) return fail(ConstantFault::DoesNotFit);
    if (result.operand.form != ConstantForm::Real) result.operand.form = ConstantForm::Typed;
    result.operand.width = row.width;
    return result;
  }
  return fail(ConstantFault::NotAConstant);
}

}  // namespace

std::optional<std::string> unquoted(std::string_view text, TextEncoding encoding) {
  if (text.empty()) return std::nullopt;
  const Quote open = quoteAt(text, 0);
  if (open.length == 0) return std::nullopt;
  std::string plain;
  std::string result;
  std::size_t i = open.length;
  while (i < text.size()) {
    const Quote close = quoteAt(text, i);
    if (close.kind == open.kind) {
      if (i + close.length != text.size()) return std::nullopt;
      return result + encodeForController(plain, encoding);
    }
    if (text[i] != '$' || i + 1 >= text.size()) {
      plain += text[i++];
      continue;
    }
    result += encodeForController(plain, encoding);
    plain.clear();
    const char escape = upper(text[i + 1]);
    const int high = digitValue(escape), low = i + 2 < text.size() ? digitValue(text[i + 2]) : 99;
    static constexpr std::string_view letters = "LNPRT", values = "\n\n\f\r\t";
    if (high < 16 && low < 16) {
      result += static_cast<char>(high * 16 + low);
      i += 3;
      continue;
    }
    const std::size_t letter = letters.find(escape);
    result += letter == std::string_view::npos ? text[i + 1] : values[letter];
    i += 2;
  }
  return std::nullopt;
}

ConstantResult readConstant(std::string_view text, TextEncoding encoding) {
  if (text.empty()) return fail(ConstantFault::NotAConstant);
  if (quoteAt(text, 0).length > 0) return readQuoted(text, encoding);
  const char first = text[0];
  const bool isNumber =
      isDigit(first) || first == '+' || first == '-' || (first == '.' && text.size() > 1 && isDigit(text[1]));
  const std::size_t hash = text.find('#');
  if (!isNumber) {
    if (equalsIgnoringCase(text, "TRUE") || equalsIgnoringCase(text, "ON")) return give(1, ConstantForm::Boolean);
    if (equalsIgnoringCase(text, "FALSE") || equalsIgnoringCase(text, "OFF")) return give(0, ConstantForm::Boolean);
    if (hash == std::string_view::npos || hash == 0 || hash > 5) return fail(ConstantFault::NotAConstant);
    return readTyped(text.substr(0, hash), text.substr(hash + 1));
  }
  if (hash != std::string_view::npos) {
    const std::string_view base = text.substr(0, hash);
    if (base == "16") return readBased(text.substr(hash + 1), 16, ConstantForm::Hex);
    if (base == "2") return readBased(text.substr(hash + 1), 2, ConstantForm::Binary);
    return fail(ConstantFault::BadBase);
  }
  if (text.find_first_of(".eE") != std::string_view::npos) return readReal(text);
  return readDecimal(text);
}

std::string_view faultText(ConstantFault fault) {
  switch (fault) {
    case ConstantFault::BadDigits: return "has a character that does not belong there";
    case ConstantFault::BadBase: return "has a base other than 16# and 2#";
    case ConstantFault::TooLarge: return "is too large";
    case ConstantFault::TooLong: return "has more than four characters";
    case ConstantFault::Empty: return "has no digits";
    case ConstantFault::DoesNotFit: return "does not fit the size of its prefix";
    default: return "is not a constant";
  }
}

}  // namespace rungproof
