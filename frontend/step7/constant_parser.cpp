// One function for each kind of constant.
#include "frontend/step7/constant_parser.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <chrono>

#include "frontend/stl/stl_lexer.hpp"

namespace rungproof::step7 {

using s7300::Constant;
using s7300::ConstantKind;

namespace {

struct ConstantPrefix {
  std::string_view text;
  ConstantKind kind;
};
constexpr std::array<ConstantPrefix, 26> constantPrefixes = {{
    {"B", ConstantKind::Byte},         {"BYTE", ConstantKind::Byte},
    {"W", ConstantKind::Word},         {"WORD", ConstantKind::Word},
    {"DW", ConstantKind::DWord},       {"DWORD", ConstantKind::DWord},
    {"L", ConstantKind::Long},         {"DINT", ConstantKind::Long},
    {"I", ConstantKind::Integer},      {"INT", ConstantKind::Integer},
    {"REAL", ConstantKind::Real},      {"BOOL", ConstantKind::Boolean},
    {"C", ConstantKind::Count},        {"COUNTER", ConstantKind::Count},
    {"S5T", ConstantKind::S5Time},     {"S5TIME", ConstantKind::S5Time},
    {"T", ConstantKind::Time},         {"TIME", ConstantKind::Time},
    {"D", ConstantKind::Date},         {"DATE", ConstantKind::Date},
    {"TOD", ConstantKind::TimeOfDay},  {"TIME_OF_DAY", ConstantKind::TimeOfDay},
    {"DT", ConstantKind::DateAndTime}, {"DATE_AND_TIME", ConstantKind::DateAndTime},
    {"P", ConstantKind::Pointer},      {"CHAR", ConstantKind::Text},
}};

/// Codes of the element types of an ANY (002:2257-2263).
constexpr std::array<std::pair<std::string_view, std::uint8_t>, 23> anyTypes = {{
    {"VOID", 0x00},     {"BOOL", 0x01},        {"BYTE", 0x02},          {"CHAR", 0x03},      {"WORD", 0x04},
    {"INT", 0x05},      {"DWORD", 0x06},       {"DINT", 0x07},          {"REAL", 0x08},      {"DATE", 0x09},
    {"TOD", 0x0A},      {"TIME", 0x0B},        {"S5TIME", 0x0C},        {"DT", 0x0E},        {"STRING", 0x13},
    {"BLOCK_FB", 0x17}, {"BLOCK_FC", 0x18},    {"BLOCK_DB", 0x19},      {"BLOCK_SDB", 0x1A}, {"COUNTER", 0x1C},
    {"TIMER", 0x1D},    {"TIME_OF_DAY", 0x0A}, {"DATE_AND_TIME", 0x0E},
}};

class ConstantParser {
 public:
  ConstantParser(Cursor& cursor, MnemonicSet set, TextEncoding encoding)
      : cursor_(cursor), set_(set), encoding_(encoding), begin_(cursor.at()) {}

  ConstantOutcome read() {
    const char c = cursor_.peek();
    if (c == '\'') {
      text();
    } else if (isDecimal(c) || ((c == '-' || c == '+') && (isDecimal(cursor_.peek(1)) || cursor_.peek(1) == '.'))) {
      number();
    } else if (!prefixed()) {
      return {};
    }
    if (!fault_.empty()) return {std::nullopt, fault_};
    if (isWordByte(cursor_.peek())) return {std::nullopt, "text behind the constant"};
    result_.span = cursor_.spanFrom(begin_);
    return {std::move(result_), {}};
  }

 private:
  void fail(std::string fault) {
    if (fault_.empty()) fault_ = std::move(fault);
  }

  bool prefixed() {
    const std::string_view word = cursor_.peekWord();
    if (equalsWord(word, "TRUE") || equalsWord(word, "FALSE")) {
      cursor_.skip(word.size());
      result_.kind = ConstantKind::Boolean;
      result_.value = word.size() == 4 ? 1 : 0;
      return true;
    }
    if (word.empty() || cursor_.peek(word.size()) != '#') return false;
    const auto row =
        std::ranges::find_if(constantPrefixes, [&](const ConstantPrefix& r) { return equalsWord(word, r.text); });
    if (row == constantPrefixes.end()) {
      fail(fmt::format("no constants begin with {}#", word));
      return true;
    }
    if (row->kind == ConstantKind::Pointer && cursor_.peek(word.size() + 1) == '#') return false;  // P##name
    cursor_.skip(word.size() + 1);
    result_.kind = row->kind;
    switch (row->kind) {
      case ConstantKind::Byte: byteOrBytes(); break;
      case ConstantKind::Word: bits(0xFFFF); break;
      case ConstantKind::DWord: bits(0xFFFFFFFF); break;
      case ConstantKind::Boolean: {
        const bool isWord = cursor_.takeWord("TRUE");
        if (isWord || cursor_.takeWord("FALSE"))
          result_.value = isWord ? 1 : 0;
        else
          bits(1);
        break;
      }
      case ConstantKind::Long: signedNumber(INT32_MIN, INT32_MAX); break;
      case ConstantKind::Integer: signedNumber(-32768, 32767); break;
      case ConstantKind::Count: count(); break;
      case ConstantKind::Real: number(); break;
      case ConstantKind::S5Time: s5Time(); break;
      case ConstantKind::Time: time(); break;
      case ConstantKind::Date: result_.value = date(); break;
      case ConstantKind::TimeOfDay: result_.value = timeOfDay(); break;
      case ConstantKind::DateAndTime: dateAndTime(); break;
      case ConstantKind::Pointer: pointer(); break;
      default: text(); break;
    }
    return true;
  }

  /// Digits of a base with underscores between them; fails if there are none or they exceed 2^40.
  std::int64_t digits(int base) {
    std::int64_t value = 0;
    bool any = false;
    for (;; cursor_.skip(1)) {
      const char c = upper(cursor_.peek());
      const int digit = isDecimal(c) ? c - '0' : c >= 'A' && c <= 'F' ? c - 'A' + 10 : 99;
      if (c == '_' && any) continue;
      if (digit >= base) break;
      any = true;
      if (value < (std::int64_t{1} << 40)) value = value * base + digit;
    }
    if (!any) fail("digits are missing");
    return value;
  }

  void inRange(std::int64_t value, std::int64_t least, std::int64_t most) {
    if (value < least || value > most) fail(fmt::format("the value is outside of {} to {}", least, most));
    result_.value = value;
  }

  /// 16#.., 2#.. or decimal digits.
  void bits(std::int64_t most) {
    int base = 10;
    if (cursor_.startsWith("16#")) base = 16;
    if (cursor_.startsWith("2#")) base = 2;
    if (base != 10) cursor_.skip(base == 16 ? 3 : 2);
    const std::int64_t value = digits(base);
    if (value > most) fail(fmt::format("the value is larger than 16#{:X}", most));
    result_.value = value;
  }

  void byteOrBytes() {
    if (!cursor_.take('(')) return bits(0xFF);
    std::int64_t value = 0;
    int count = 0;
    do {
      cursor_.skipBlanks();
      const std::int64_t part = digits(10);
      if (part > 255) fail("each part is 0 to 255");
      value = value << 8 | part;
      ++count;
      cursor_.skipBlanks();
    } while (count < 5 && cursor_.take(','));
    if (!cursor_.take(')')) fail("the closing parenthesis is missing");
    if (count != 2 && count != 4) fail("two or four bytes stand in the parentheses");
    result_.kind = count == 4 ? ConstantKind::FourBytes : ConstantKind::TwoBytes;
    result_.value = value;
  }

  void signedNumber(std::int64_t least, std::int64_t most) {
    if (cursor_.startsWith("16#") || cursor_.startsWith("2#")) return bits(static_cast<std::int64_t>(most) * 2 + 1);
    const bool isNegative = cursor_.peek() == '-';
    if (isNegative || cursor_.peek() == '+') cursor_.skip(1);
    const std::int64_t value = digits(10);
    inRange(isNegative ? -value : value, least, most);
  }

  void count() {
    const std::int64_t value = digits(10);
    if (value > 999) fail("a counter value is 0 to 999");
    result_.value = value / 100 << 8 | value / 10 % 10 << 4 | value % 10;
  }

  /// 5, -33, 1.5, 1.5e+3, 16#FF, 2#10.
  void number() {
    if (cursor_.startsWith("16#") || cursor_.startsWith("2#")) {
      result_.kind = cursor_.startsWith("16#") ? ConstantKind::Hex : ConstantKind::Binary;
      return bits(0xFFFFFFFF);
    }
    const std::uint32_t from = cursor_.at();
    if (cursor_.peek() == '-' || cursor_.peek() == '+') cursor_.skip(1);
    while (isDecimal(cursor_.peek()) || cursor_.peek() == '_') cursor_.skip(1);
    bool isReal = result_.kind == ConstantKind::Real;
    if (cursor_.peek() == '.' && isDecimal(cursor_.peek(1))) {
      isReal = true;
      cursor_.skip(1);
      while (isDecimal(cursor_.peek()) || cursor_.peek() == '_') cursor_.skip(1);
    }
    if (upper(cursor_.peek()) == 'E') {
      const std::size_t sign = cursor_.peek(1) == '-' || cursor_.peek(1) == '+' ? 1 : 0;
      if (isDecimal(cursor_.peek(1 + sign))) {
        isReal = true;
        cursor_.skip(1 + sign);
        while (isDecimal(cursor_.peek())) cursor_.skip(1);
      }
    }
    std::string written(cursor_.slice(from, cursor_.at()));
    std::erase(written, '_');
    if (!written.empty() && written[0] == '+') written.erase(0, 1);
    const char* const end = written.data() + written.size();
    if (isReal) {
      float value = 0;
      const auto [stop, error] = std::from_chars(written.data(), end, value);
      if (error == std::errc::result_out_of_range) {
        // Too large to be a REAL, or so small that it is 0.
        double wide = 0;
        std::from_chars(written.data(), end, wide);
        if (wide > 1 || wide < -1) fail("the value is larger than a REAL");
        value = 0;
      } else if (error != std::errc() || stop != end) {
        fail("the number cannot be read");
      }
      result_.kind = ConstantKind::Real;
      result_.value = std::bit_cast<std::uint32_t>(value);
      return;
    }
    std::int64_t value = 0;
    const auto [stop, error] = std::from_chars(written.data(), end, value);
    if (error != std::errc() || stop != end) fail("the number cannot be read");
    result_.kind = ConstantKind::Integer;
    inRange(value, INT32_MIN, UINT32_MAX);
  }

  void text() {
    if (cursor_.peek() != '\'') return fail("an apostrophe is missing");
    const std::uint32_t from = cursor_.at(), end = cursor_.quotedEnd();
    if (end == 0) {
      cursor_.to(cursor_.lineEnd());
      return fail("the text has no second apostrophe");
    }
    result_.kind = ConstantKind::Text;
    std::string plain;
    const auto flush = [&] {
      result_.text += encodeForController(plain, encoding_);
      plain.clear();
    };
    const std::string_view inside = cursor_.slice(from + 1, end - 1);
    for (std::size_t i = 0; i < inside.size(); ++i) {
      if (inside[i] != '$' || i + 1 == inside.size()) {
        plain += inside[i];
        continue;
      }
      flush();
      i += escape(inside.substr(i + 1));
    }
    flush();
    cursor_.to(end);
  }

  /// The character that $ and the beginning of `rest` mean; returns how much of `rest` that is.
  std::size_t escape(std::string_view rest) {
    constexpr std::string_view letters = "LNPRT", meanings = "\n\n\f\r\t";
    if (const std::size_t which = letters.find(upper(rest[0])); which != std::string_view::npos) {
      result_.text += meanings[which];
      return 1;
    }
    unsigned code = 0;
    if (rest.size() >= 2 && std::from_chars(rest.data(), rest.data() + 2, code, 16).ptr == rest.data() + 2) {
      result_.text += static_cast<char>(code);
      return 2;
    }
    result_.text += rest[0];
    return 1;
  }

  /// Milliseconds of 1D_2H_3M_4S_5MS; each unit at most once, larger ones first.
  std::int64_t duration() {
    struct Unit {
      std::string_view text;
      std::int64_t ms;
    };
    constexpr std::array<Unit, 5> units = {{{"D", 86400000}, {"H", 3600000}, {"M", 60000}, {"S", 1000}, {"MS", 1}}};
    std::int64_t sum = 0;
    std::size_t next = 0;
    while (isDecimal(cursor_.peek())) {
      const std::int64_t number = digits(10);
      std::string letters;
      while (isLetter(cursor_.peek())) {
        letters += upper(cursor_.peek());
        cursor_.skip(1);
      }
      const auto unit = std::ranges::find(units, letters, &Unit::text);
      if (unit == units.end()) {
        fail("a time is written with D, H, M, S and MS");
        return 0;
      }
      const auto index = static_cast<std::size_t>(unit - units.begin());
      if (index < next) fail("the parts of a time go from D to MS");
      next = index + 1;
      sum += number * unit->ms;
      if (cursor_.peek() == '_') cursor_.skip(1);
    }
    if (next == 0) fail("a time is written with D, H, M, S and MS");
    return sum;
  }

  void s5Time() {
    const std::int64_t ms = duration();
    if (ms > 9'990'000) return fail("an S5TIME is at most 2H46M30S");
    std::int64_t base = 0, unit = 10;
    while (ms / unit > 999) {
      ++base;
      unit *= 10;
    }
    const std::int64_t value = ms / unit;  // rounded down to the base (003:1043)
    result_.value = base << 12 | value / 100 << 8 | value / 10 % 10 << 4 | value % 10;
  }

  void time() {
    const bool isNegative = cursor_.take('-');
    const std::int64_t ms = duration();
    if ((isNegative ? -ms : ms) < INT32_MIN || (isNegative ? -ms : ms) > INT32_MAX)
      return fail("a TIME is at most 24D20H31M23S647MS");
    result_.value = static_cast<std::uint32_t>(isNegative ? -ms : ms);
  }

  bool takeMark(char mark) {
    if (cursor_.take(mark)) return true;
    fail(fmt::format("\"{}\" is missing", mark));
    return false;
  }

  /// Days since 1990-01-01 of 1990-1-1 or 90-1-1.
  std::int64_t date() {
    namespace ch = std::chrono;
    std::int64_t year = digits(10);
    if (year < 100) year += year >= 90 ? 1900 : 2000;
    if (!takeMark('-')) return 0;
    const std::int64_t month = digits(10);
    if (!takeMark('-')) return 0;
    const std::int64_t day = digits(10);
    const ch::year_month_day given{ch::year(static_cast<int>(std::min<std::int64_t>(year, 9999))),
                                   ch::month(static_cast<unsigned>(std::min<std::int64_t>(month, 99))),
                                   ch::day(static_cast<unsigned>(std::min<std::int64_t>(day, 99)))};
    if (!given.ok() || year < 1990 || year > 2168) {
      fail("there is no such day between 1990 and 2168");
      return 0;
    }
    const ch::sys_days first = ch::year_month_day{ch::year(1990), ch::month(1), ch::day(1)};
    year_ = year;
    month_ = month;
    day_ = day;
    weekday_ = ch::weekday(ch::sys_days(given)).c_encoding() + 1;
    return (ch::sys_days(given) - first).count();
  }

  /// Milliseconds since midnight of 1:10:3.3.
  std::int64_t timeOfDay() {
    const std::int64_t hours = digits(10);
    if (!takeMark(':')) return 0;
    const std::int64_t minutes = digits(10);
    if (!takeMark(':')) return 0;
    const std::int64_t seconds = digits(10);
    std::int64_t ms = 0;
    if (cursor_.peek() == '.' && isDecimal(cursor_.peek(1))) {
      cursor_.skip(1);
      std::int64_t place = 100;
      for (; isDecimal(cursor_.peek()); cursor_.skip(1), place /= 10) ms += (cursor_.peek() - '0') * place;
    }
    if (hours > 23 || minutes > 59 || seconds > 59) fail("a time of day is 0:0:0.0 to 23:59:59.999");
    return ((hours * 60 + minutes) * 60 + seconds) * 1000 + ms;
  }

  void dateAndTime() {
    date();
    if (!takeMark('-')) return;
    const std::int64_t ms = timeOfDay();
    if (year_ > 2089) return fail("a DATE_AND_TIME ends with the year 2089");
    const auto digitsOf = [](std::int64_t value) { return static_cast<std::uint64_t>(value / 10 << 4 | value % 10); };
    std::uint64_t bytes = digitsOf(year_ % 100);
    for (const std::int64_t part : {month_, day_, ms / 3600000, ms / 60000 % 60, ms / 1000 % 60, ms % 1000 / 10})
      bytes = bytes << 8 | digitsOf(part);
    bytes = bytes << 8 | static_cast<std::uint64_t>(ms % 10) << 4 | weekday_;
    result_.value = static_cast<std::int64_t>(bytes);
  }

  /// Behind P#: 1.0, M 1.0, DBX 1.0, DB1.DBX 1.0, each with or without the type and number of an ANY.
  void pointer() {
    std::uint32_t area = 0;
    bool hasArea = !isDecimal(cursor_.peek());
    if (hasArea) {
      std::string letters;
      while (isLetter(cursor_.peek())) {
        letters += upper(cursor_.peek());
        cursor_.skip(1);
      }
      cursor_.skipBlanks();
      if (letters == "DB" && isDecimal(cursor_.peek())) {
        const std::int64_t block = digits(10);
        if (block > 65535) fail("there is no such data block");
        result_.block = static_cast<std::uint16_t>(block);
        if (!takeMark('.')) return;
        letters.clear();
        while (isLetter(cursor_.peek())) {
          letters += upper(cursor_.peek());
          cursor_.skip(1);
        }
        cursor_.skipBlanks();
        if (letters != "DBX") return fail("a pointer into a data block is written P#DB1.DBX0.0");
      }
      const bool isGerman = set_ == MnemonicSet::German;
      const std::string_view in = isGerman ? "E" : "I", out = isGerman ? "A" : "Q";
      const std::array<std::string_view, 8> areas = {"P", in, out, "M", "DBX", "DIX", "L", "V"};
      const auto found = std::ranges::find(areas, letters);
      if (found == areas.end()) return fail(fmt::format("pointers know no area {}", letters));
      area = 0x80000000U | static_cast<std::uint32_t>(found - areas.begin()) << 24;
    }
    const std::int64_t byte = digits(10);
    std::int64_t bit = 0;
    if (cursor_.peek() == '.' && isDecimal(cursor_.peek(1))) {
      cursor_.skip(1);
      bit = digits(10);
    } else {
      fail("the bit number is missing, as in P#2.0");
    }
    if (byte > 65535 || bit > 7) fail("a pointer is at most P#65535.7");
    result_.value = area | byte << 3 | bit;
    element(hasArea);
  }

  /// BYTE 10 behind a pointer makes it an ANY.
  void element(bool hasArea) {
    const std::uint32_t back = cursor_.at();
    cursor_.skipBlanks();
    const std::string_view word = cursor_.peekWord();
    const auto type = std::ranges::find_if(anyTypes, [&](const auto& row) { return equalsWord(word, row.first); });
    if (!hasArea || type == anyTypes.end()) return cursor_.to(back);
    cursor_.skip(word.size());
    cursor_.skipBlanks();
    const std::int64_t count = digits(10);
    if (count > 65535) fail("an ANY has at most 65535 elements");
    result_.kind = ConstantKind::Any;
    result_.anyType = type->second;
    result_.anyCount = static_cast<std::uint16_t>(count);
  }

  Cursor& cursor_;
  MnemonicSet set_;
  TextEncoding encoding_;
  std::uint32_t begin_;
  Constant result_;
  std::string fault_;
  std::int64_t year_ = 0, month_ = 0, day_ = 0;
  unsigned weekday_ = 0;  ///< 1: Sunday
};

}  // namespace

ConstantOutcome readConstant(Cursor& cursor, MnemonicSet set, TextEncoding encoding) {
  return ConstantParser(cursor, set, encoding).read();
}

}  // namespace rungproof::step7
