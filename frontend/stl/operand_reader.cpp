// Spelling of addresses.
#include "frontend/stl/operand_reader.hpp"

#include <algorithm>
#include <array>

#include "frontend/stl/stl_lexer.hpp"

namespace rungproof {

namespace {

/// How an area may be written after its letters: bit ".b", sizes B W D, or just a number.
enum class AddressShape : std::uint8_t { Sized, WordOnly, Numbered };

struct AreaRow {
  std::string_view international;
  std::string_view german;
  Area area;
  AddressShape shape;
};
/// Longer spellings first, so that SM is not taken for S.
constexpr std::array<AreaRow, 13> areaRows = {{
    {"SM", "SM", Area::SM, AddressShape::Sized},
    {"AI", "AE", Area::AI, AddressShape::WordOnly},
    {"AQ", "AA", Area::AQ, AddressShape::WordOnly},
    {"AC", "AC", Area::AC, AddressShape::Numbered},
    {"HC", "HZ", Area::HC, AddressShape::Numbered},
    {"I", "E", Area::I, AddressShape::Sized},
    {"Q", "A", Area::Q, AddressShape::Sized},
    {"V", "V", Area::V, AddressShape::Sized},
    {"M", "M", Area::M, AddressShape::Sized},
    {"S", "S", Area::S, AddressShape::Sized},
    {"L", "L", Area::L, AddressShape::Sized},
    {"T", "T", Area::T, AddressShape::Numbered},
    {"C", "Z", Area::C, AddressShape::Numbered},
}};

struct Letters {
  const AreaRow* row = nullptr;
  char size = 0;  ///< 0, 'B', 'W', 'D', 'X'
};

Letters lettersOf(std::string_view letters, Spelling spelling) {
  std::array<char, 4> buffer{};
  if (letters.empty() || letters.size() > 3) return {};
  for (std::size_t i = 0; i < letters.size(); ++i) buffer[i] = upper(letters[i]);
  const std::string_view text(buffer.data(), letters.size());
  for (const AreaRow& row : areaRows) {
    const std::string_view name = spelling == Spelling::German ? row.german : row.international;
    const bool isHcInGerman = spelling == Spelling::German && row.area == Area::HC && text.substr(0, 2) == "HC";
    if (!isHcInGerman && (text[0] != name[0] || !text.starts_with(name))) continue;
    const std::string_view size = text.substr(name.size());
    if (size.empty()) return {&row, 0};
    if (size.size() > 1) continue;
    const bool fits = row.shape == AddressShape::Sized ? size.find_first_of("BWDX") == 0
                                                       : row.shape == AddressShape::WordOnly && size == "W";
    if (fits) return {&row, size[0]};
  }
  return {};
}

/// Decimal digits as a number below 2^32.
bool readNumber(std::string_view digits, std::uint32_t& number) {
  if (digits.empty() || digits.size() > 9) return false;
  number = 0;
  for (const char c : digits) {
    if (!isDigit(c)) return false;
    number = number * 10 + static_cast<std::uint32_t>(c - '0');
  }
  return true;
}

std::size_t countLetters(std::string_view text) {
  std::size_t count = 0;
  while (count < text.size() && isLetter(text[count])) ++count;
  return count;
}

OperandResult symbol(std::string_view text) {
  OperandResult result;
  result.fault = OperandFault::None;
  result.operand.kind = OperandKind::Symbol;
  result.operand.value = -1;
  result.operand.text = text;
  return result;
}
OperandResult faulty(OperandFault fault) {
  OperandResult result;
  result.fault = fault;
  return result;
}

OperandResult readPointer(std::string_view target, std::string_view whole, Spelling spelling) {
  OperandResult result = faulty(OperandFault::Pointer);
  Operand& o = result.operand;
  if (readAddress(target, spelling, o)) {
    const bool mayHold = mayHoldPointer(o.area) && (o.area == Area::AC || o.width == Width::DWord);
    if (!mayHold) return result;
    o.kind = OperandKind::Indirect;
    result.fault = OperandFault::None;
    return result;
  }
  return isName(target) || (!target.empty() && target[0] == '#' && isName(target.substr(1))) ? symbol(whole) : result;
}

OperandResult readAddressOf(std::string_view target, std::string_view whole, Spelling spelling) {
  OperandResult result = faulty(OperandFault::AddressOf);
  Operand& o = result.operand;
  if (readAddress(target, spelling, o)) {
    const bool isNumbered = addressedByNumber(o.area);
    if (o.width == Width::Bit && !isNumbered) return result;
    o.kind = OperandKind::Address;
    if (!isNumbered && !isAnalogue(o.area)) o.width = Width::Byte;
    result.fault = OperandFault::None;
    return result;
  }
  return isName(target) || (!target.empty() && target[0] == '#' && isName(target.substr(1))) ? symbol(whole) : result;
}

}  // namespace

bool isName(std::string_view text) {
  if (text.empty() || isDigit(text[0])) return false;
  // General punctuation, mathematical signs, CJK punctuation and full-width ASCII are no letters.
  static constexpr std::array<std::string_view, 5> signs = {"\xE2\x80", "\xE2\x88", "\xE3\x80", "\xEF\xBC", "\xEF\xBD"};
  if (std::any_of(signs.begin(), signs.end(),
                  [&](std::string_view sign) { return text.find(sign) != std::string_view::npos; }))
    return false;
  return std::all_of(text.begin(), text.end(), [](char c) {
    return isLetter(c) || isDigit(c) || c == '_' || static_cast<unsigned char>(c) >= 0x80;
  });
}

/// VB9999999999: an address whose number cannot be held.
static bool hasTooManyDigits(std::string_view text, Spelling spelling) {
  const std::size_t count = countLetters(text);
  const std::string_view digits = text.substr(count);
  return digits.size() > 9 && isAreaPrefix(text.substr(0, count), spelling) &&
         std::all_of(digits.begin(), digits.end(), isDigit);
}

bool isAreaPrefix(std::string_view letters, Spelling spelling) { return lettersOf(letters, spelling).row != nullptr; }

bool isPartOfAddress(std::string_view text, Spelling spelling) {
  const std::size_t count = countLetters(text);
  const Letters letters = lettersOf(text.substr(0, count), spelling);
  std::uint32_t number = 0;
  return letters.row != nullptr && readNumber(text.substr(count), number);
}

bool readAddress(std::string_view text, Spelling spelling, Operand& operand) {
  const std::size_t count = countLetters(text);
  if (count == 0 || count > 3 || count == text.size()) return false;
  const Letters letters = lettersOf(text.substr(0, count), spelling);
  if (letters.row == nullptr) return false;
  const std::string_view rest = text.substr(count);
  const std::size_t point = rest.find('.');
  std::uint32_t number = 0;
  if (!readNumber(rest.substr(0, point), number)) return false;
  const AreaRow& row = *letters.row;
  Width width = Width::Bit;
  std::uint32_t bit = 0;
  if (point != std::string_view::npos) {
    const bool isBitOfArea = row.shape == AddressShape::Sized && (letters.size == 0 || letters.size == 'X');
    if (!isBitOfArea || !readNumber(rest.substr(point + 1), bit)) return false;
    bit = std::min(bit, 255U);
  } else if (row.shape == AddressShape::Numbered) {
    width = hasBitAndWord(row.area) ? Width::Bit : areaInfo(row.area).width.value_or(Width::Bit);
  } else if (row.shape == AddressShape::WordOnly) {
    if (letters.size != 'W') return false;
    width = Width::Word;
  } else if (letters.size == 'B') {
    width = Width::Byte;
  } else if (letters.size == 'W') {
    width = Width::Word;
  } else if (letters.size == 'D') {
    width = Width::DWord;
  } else {
    return false;
  }
  operand.kind = OperandKind::Direct;
  operand.area = row.area;
  operand.width = width;
  operand.offset = number;
  operand.bit = static_cast<std::uint8_t>(bit);
  return true;
}

/// Start:I0.0, "Motor on":Q0.5: a symbol and its address, as the editor can show them together. Left to the resolver as
/// a name, ':' and the address in international spelling; nothing if it is something else.
static std::optional<OperandResult> readNamedAddress(std::string_view text, Spelling spelling) {
  const bool isQuoted = text[0] == '"';
  const std::size_t colon = isQuoted ? text.find("\":") : text.find(':');
  if (colon == std::string_view::npos || colon < 1 || (isQuoted && colon < 2)) return std::nullopt;
  const std::string_view name = isQuoted ? text.substr(1, colon - 1) : text.substr(0, colon);
  std::string_view address = text.substr(colon + (isQuoted ? 2 : 1));
  if (address.starts_with('%')) address.remove_prefix(1);
  Operand place;
  if ((!isQuoted && !isName(name)) || !readAddress(address, spelling, place)) return std::nullopt;
  return symbol(std::string(name) + namedAddressMark + toString(place));
}

OperandResult readOperand(std::string_view text, const OperandContext& context) {
  if (text.empty()) return faulty(OperandFault::Unreadable);
  if (auto named = readNamedAddress(text, context.spelling)) return std::move(*named);
  const char first = text[0];
  if (first == '?')
    return text.find_first_not_of("?.") == std::string_view::npos
               ? OperandResult{OperandFault::None, ConstantFault::None, {}}
               : faulty(OperandFault::Unreadable);
  if (first == '*') return readPointer(text.substr(1), text, context.spelling);
  if (first == '&') return readAddressOf(text.substr(1), text, context.spelling);
  if (first == '#') return isName(text.substr(1)) ? symbol(text) : faulty(OperandFault::Unreadable);
  OperandResult result;
  if (first == '%') {
    const bool isAddress = readAddress(text.substr(1), context.spelling, result.operand);
    result.fault = isAddress ? OperandFault::None : OperandFault::Unreadable;
    return result;
  }
  if (isLetter(first) && readAddress(text, context.spelling, result.operand)) {
    result.fault = OperandFault::None;
    return result;
  }
  if (hasTooManyDigits(text, context.spelling)) return faulty(OperandFault::Number);
  ConstantResult value = readConstant(text, context.encoding);
  if (value.fault == ConstantFault::None) {
    result.fault = OperandFault::None;
    result.operand = std::move(value.operand);
    return result;
  }
  if (value.fault != ConstantFault::NotAConstant) {
    result.fault = OperandFault::Constant;
    result.constantFault = value.fault;
    return result;
  }
  return isName(text) ? symbol(text) : faulty(OperandFault::Unreadable);
}

namespace {

struct Imitation {
  std::string_view character;
  char meant;
};
/// Cyrillic and Greek letters that print like ASCII capitals, and typographic signs.
constexpr std::array<Imitation, 34> imitations = {{
    {"\xD0\x90", 'A'},     {"\xD0\x92", 'B'},     {"\xD0\xA1", 'C'},     {"\xD0\x95", 'E'},     {"\xD0\x9D", 'H'},
    {"\xD0\x86", 'I'},     {"\xD0\x9A", 'K'},     {"\xD0\x9C", 'M'},     {"\xD0\x9E", 'O'},     {"\xD0\xA0", 'P'},
    {"\xD0\xA2", 'T'},     {"\xD0\xA5", 'X'},     {"\xD0\x85", 'S'},     {"\xD0\x97", '3'},     {"\xD0\xB0", 'a'},
    {"\xD1\x81", 'c'},     {"\xD0\xB5", 'e'},     {"\xD0\xBE", 'o'},     {"\xD1\x80", 'p'},     {"\xD1\x85", 'x'},
    {"\xD1\x96", 'i'},     {"\xCE\x91", 'A'},     {"\xCE\x92", 'B'},     {"\xCE\x95", 'E'},     {"\xCE\x99", 'I'},
    {"\xCE\x9C", 'M'},     {"\xCE\x9D", 'N'},     {"\xCE\x9F", 'O'},     {"\xCE\xA4", 'T'},     {"\xE2\x80\x93", '-'},
    {"\xE2\x88\x92", '-'}, {"\xE2\x80\x90", '-'}, {"\xE2\x88\x97", '*'}, {"\xE3\x80\x82", '.'},
}};

/// Number part: O and o to 0; l, I, i and | to 1. Empty if another letter stands there.
std::string mendedDigits(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (isDigit(c) || c == '.') {
      result += c;
    } else if (c == 'O' || c == 'o') {
      result += '0';
    } else if (c == 'l' || c == 'I' || c == 'i' || c == '|') {
      result += '1';
    } else {
      return {};
    }
  }
  return result;
}

}  // namespace

std::string plainCharacters(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if (byte < 0x80) {
      result += text[i++];
      continue;
    }
    const auto third = i + 2 < text.size() ? static_cast<unsigned char>(text[i + 2]) : 0U;
    if (byte == 0xEF && i + 2 < text.size() && (text[i + 1] == '\xBC' || text[i + 1] == '\xBD')) {  // U+FF01..U+FF5E
      const unsigned code = (text[i + 1] == '\xBC' ? 0x00U : 0x40U) + (third & 0x3FU);
      if (code >= 1 && code <= 0x5E) {
        result += static_cast<char>(code + 0x20);
        i += 3;
        continue;
      }
    }
    const auto found = std::find_if(imitations.begin(), imitations.end(), [&](const Imitation& row) {
      return text.substr(i, row.character.size()) == row.character;
    });
    if (found != imitations.end()) {
      result += found->meant;
      i += found->character.size();
    } else {
      result += text[i++];
    }
  }
  return result;
}

std::string mendedOperand(std::string_view text, Spelling spelling, bool bitOnly) {
  if (text.empty() || text.size() > 40) return {};
  const std::string plain = plainCharacters(text);
  const auto isReadable = [&](std::string_view candidate) {
    const OperandResult result = readOperand(candidate, {spelling});
    const bool isConstant = result.operand.kind == OperandKind::Constant;
    return result.fault == OperandFault::None && result.operand.kind != OperandKind::Symbol && !(bitOnly && isConstant);
  };
  if (plain != text && isReadable(plain)) return plain;
  const bool isPointer = plain[0] == '*' || plain[0] == '&';
  const std::string sign = isPointer ? plain.substr(0, 1) : std::string();
  const std::string body = isPointer ? plain.substr(1) : plain;
  for (std::size_t k = 1; k <= 3 && k < body.size(); ++k) {
    std::string letters = body.substr(0, k);
    for (char& c : letters) c = c == '1' || c == 'l' || c == '|' ? 'I' : upper(c);
    const std::string digits = mendedDigits(std::string_view(body).substr(k));
    if (!digits.empty() && isAreaPrefix(letters, spelling) && isReadable(sign + letters + digits))
      return sign + letters + digits;
  }
  const bool isSigned = plain.size() > 1 && (plain[0] == '+' || plain[0] == '-');
  if (bitOnly || isPointer || !(isSigned || isDigit(plain[0]))) return {};
  std::string number = plain;
  const std::size_t hash = plain.find('#');
  const bool isHex = hash != std::string::npos && plain.substr(0, hash) == "16";
  for (std::size_t i = 0; i < number.size(); ++i) {
    char& c = number[i];
    if (c == 'O' || c == 'o') c = '0';
    if (c == 'l' || c == 'I' || (c == 'i' && !isHex)) c = '1';
  }
  return number != text && isReadable(number) ? number : std::string();
}

}  // namespace rungproof
