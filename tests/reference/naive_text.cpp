// The naive interpreter: characters and strings (001:3579-3939, 001:6067-6254).
#include <bit>
#include <cmath>
#include <cstdlib>

#include "naive.hpp"

namespace rungproof::naive {

namespace {

bool isDigit(char c) { return c >= '0' && c <= '9'; }

/// A whole number over 10^places, as ITA writes it: no plus sign, one digit at least in front of the point.
std::string decimal(bool negative, std::string figures, std::size_t places, char point) {
  while (figures.size() < places + 1) figures.insert(figures.begin(), '0');
  if (places > 0) figures.insert(figures.size() - places, 1, point);
  return (negative ? "-" : "") + figures;
}
std::string rightJustified(const std::string& text, std::size_t size) {
  return std::string(size - text.size(), ' ') + text;
}

/// Digits of |number| * 10^places, halves rounded up; empty for what is no number or has more than 15 of them.
std::string figuresOf(float number, int places) {
  if (!std::isfinite(number)) return {};
  const long double scaled =
      std::fabs(static_cast<long double>(number)) * std::pow(10.0L, places);  // exact: 24 + 17 bits
  const long double whole = std::floor(scaled + 0.5L);
  return whole >= 1e15L ? std::string() : std::to_string(static_cast<long long>(whole));
}

}  // namespace

/// ATH, HTA: characters to half bytes and back, the high half first.
bool Interpreter::digits(const Instruction& i, const std::string& name) {
  if (name != "ATH" && name != "HTA") return false;
  const int count = static_cast<int>(read(i.operands[2], 1));
  const Operand &from = i.operands[0], &to = i.operands[1];
  const bool packs = name == "ATH";
  if (!fits(packs ? from : to, count, 1) || !fits(packs ? to : from, (count + 1) / 2, 1)) return fail("0091");
  std::vector<std::uint32_t> source;  // read before anything is written: the manual is silent
  for (int k = 0; k < (packs ? count : (count + 1) / 2); ++k) source.push_back(read(from, 1, k));
  if (!packs) {
    for (int k = 0; k < count; ++k) {
      const std::uint32_t half = source[static_cast<std::size_t>(k / 2)] >> (k % 2 == 0 ? 4 : 0) & 15;
      write(to, 1, static_cast<std::uint32_t>("0123456789ABCDEF"[half]), k);
    }
    return true;
  }
  status(7, false);
  for (int k = 0; k < count; ++k) {
    const auto c = static_cast<char>(source[static_cast<std::size_t>(k)]);
    if (!isDigit(c) && !(c >= 'A' && c <= 'F')) {  // what stands before it is written
      status(7, true);
      return fail("SM1.7");
    }
    const auto half = static_cast<std::uint32_t>(isDigit(c) ? c - '0' : c - 'A' + 10);
    const std::uint32_t old = read(to, 1, k / 2);
    write(to, 1, k % 2 == 0 ? half << 4 | (old & 15) : (old & 0xF0) | half, k / 2);
  }
  return true;
}

/// ITA DTA RTA into a buffer, ITS DTS RTS into a string. FMT: bits 0-2 digits behind the point, bit 3 a comma, bits 4-7
/// the size of the buffer of a REAL.
bool Interpreter::numberToText(const Instruction& i, const std::string& name) {
  static const std::string kinds = "IDR";
  if (name.size() != 3 || kinds.find(name[0]) == std::string::npos || name[1] != 'T' ||
      (name[2] != 'A' && name[2] != 'S'))
    return false;
  const bool isString = name[2] == 'S', isReal = name[0] == 'R';
  const Operand &to = i.operands[isString ? 2 : 1], &form = i.operands[isString ? 1 : 2];
  const std::uint32_t format = read(form, 1), value = read(i.operands[0], name[0] == 'I' ? 2 : 4);
  const std::uint32_t places = format & 7, upper = format >> 4;
  const int size = name[0] == 'I' ? 8 : name[0] == 'D' ? 12 : static_cast<int>(upper);
  if (isReal ? size < 3 : upper != 0 && places <= 5) return fail("");
  const int first = isString ? 1 : 0;
  if (!fits(to, size + first, 1)) return fail("0091");
  std::string text;
  const char point = (format & 8) != 0 ? ',' : '.';
  if (isReal) {
    const float number = std::bit_cast<float>(value);
    const std::string figures = places <= 5 ? figuresOf(number, static_cast<int>(places)) : "";
    const bool isZero = figures.find_first_not_of('0') == std::string::npos;  // -0.0004 shows no minus
    if (!figures.empty()) text = decimal(number < 0 && !isZero, figures, places, point);
    if (size < static_cast<int>(places) + 3) text.clear();
  } else if (places <= 5) {
    const std::int64_t number = name[0] == 'I' ? static_cast<std::int16_t>(value) : static_cast<std::int32_t>(value);
    text = decimal(number < 0, std::to_string(std::llabs(number)), places, point);
  }
  const bool bad = text.empty() || static_cast<int>(text.size()) > size;
  text = rightJustified(bad ? "" : text, static_cast<std::size_t>(size));
  if (isString) write(to, 1, static_cast<std::uint32_t>(size));
  for (int k = 0; k < size; ++k) write(to, 1, static_cast<std::uint8_t>(text[static_cast<std::size_t>(k)]), k + first);
  return bad ? fail("") : true;
}

/// STI, STD, STR: blanks, one sign, digits, for STR a point or comma and digits; the rest does not count.
bool Interpreter::textToNumber(const Instruction& i, const std::string& name) {
  if (name != "STI" && name != "STD" && name != "STR") return false;
  const std::optional<std::string> text = stringAt(i.operands[0]);
  const std::uint32_t index = read(i.operands[1], 1);
  if (!text) fail("0091");
  if (index == 0) fail("009B");
  if (!text || index == 0) return true;
  std::size_t at = index - 1;
  const auto here = [&] { return at < text->size() ? (*text)[at] : '\0'; };
  while (here() == ' ') ++at;
  std::string number;
  if (here() == '+' || here() == '-') number += (*text)[at++];
  const std::size_t firstDigit = number.size();
  while (isDigit(here())) number += (*text)[at++];
  const bool found = number.size() > firstDigit;
  if (found && name == "STR" && (here() == '.' || here() == ',')) {
    number += '.';
    for (++at; isDigit(here()); ++at) number += (*text)[at];
  }
  bool fitsTarget = found;
  std::uint32_t result = 0;
  if (found && name == "STR") {
    const float value = std::strtof(number.c_str(), nullptr);
    fitsTarget = std::isfinite(value);
    result = std::bit_cast<std::uint32_t>(value);
  } else if (found) {
    const long double value = std::strtold(number.c_str(), nullptr);
    const long double most = name == "STI" ? 32767.0L : 2147483647.0L;
    fitsTarget = value <= most && value >= -most - 1;
    if (fitsTarget) result = static_cast<std::uint32_t>(static_cast<std::int64_t>(value));
  }
  status(1, !fitsTarget);
  if (!fitsTarget) return fail("SM1.1");
  write(i.operands[2], name == "STI" ? 2 : 4, result);
  return true;
}

/// Strings may overlap: the length byte is written first, then character by character.
bool Interpreter::strings(const Instruction& i, const std::string& name) {
  if (name != "SLEN" && name != "SCPY" && name != "SCAT" && name != "SSCPY") return findInString(i, name);
  const Operand &from = i.operands[0], &to = i.operands.back();
  const std::optional<std::string> text = stringAt(from);
  if (name == "SLEN") {
    if (!text) return fail("0091");
    write(to, 1, static_cast<std::uint32_t>(text->size()));
    return true;
  }
  int first = 1, count = text ? static_cast<int>(text->size()) : 0, behind = 0;
  if (name == "SCAT") {
    const std::optional<std::string> old = stringAt(to);
    if (!text || !old || old->size() + text->size() > 254) return fail("0091");
    behind = static_cast<int>(old->size());
  }
  if (name == "SSCPY") {
    first = static_cast<int>(read(i.operands[1], 1));
    if (first == 0) return fail("009B");
    count = std::min(std::max(count - first + 1, 0), static_cast<int>(read(i.operands[2], 1)));
  }
  if (!text || !fits(to, behind + count + 1, 1)) return fail("0091");
  write(to, 1, static_cast<std::uint32_t>(behind + count));
  for (int k = 0; k < count; ++k) write(to, 1, read(from, 1, first + k), behind + k + 1);
  return true;
}

/// SFND, CFND: OUT is where the search begins and what it finds; an empty search text is not found.
bool Interpreter::findInString(const Instruction& i, const std::string& name) {
  if (name != "SFND" && name != "CFND") return false;
  const std::optional<std::string> text = stringAt(i.operands[0]), wanted = stringAt(i.operands[1]);
  const std::uint32_t start = read(i.operands[2], 1);
  if (start == 0) return fail("009B");
  if (!text || !wanted) return fail("0091");
  const std::size_t at = wanted->empty()  ? std::string::npos
                         : name == "SFND" ? text->find(*wanted, start - 1)
                                          : text->find_first_of(*wanted, start - 1);
  write(i.operands[2], 1, at == std::string::npos ? 0 : static_cast<std::uint32_t>(at + 1));
  return true;
}

}  // namespace rungproof::naive
