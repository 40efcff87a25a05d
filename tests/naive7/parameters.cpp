// Pointers as parameters in the naive interpreter: the bytes of POINTER and ANY, where the called block finds them, and
// the blocks of the system and the libraries that work through them. What a description leaves open is 0 here.
#include <algorithm>
#include <cctype>

#include "tests/naive7/machine.hpp"

namespace naive7 {
namespace {

struct TypeRow {
  const char* name;
  int code, bits;
};
const TypeRow typeRows[] = {{"VOID", 0, 0},  {"BOOL", 1, 1},  {"BYTE", 2, 8},   {"CHAR", 3, 8},
                            {"WORD", 4, 16}, {"INT", 5, 16},  {"DWORD", 6, 32}, {"DINT", 7, 32},
                            {"REAL", 8, 32}, {"DATE", 9, 16}, {"TIME", 11, 32}, {"S5TIME", 12, 16}};

int codeOfType(const std::string& name) {
  for (const TypeRow& row : typeRows) {
    if (name == row.name) return row.code;
  }
  return -1;
}

int codeOfWidth(int width) { return width == 1 ? 1 : width == 8 ? 2 : width == 16 ? 4 : 6; }

int bitsOfCode(int code) {
  for (const TypeRow& row : typeRows) {
    if (row.code == code) return row.bits;
  }
  return 0;
}

void append(std::vector<std::uint8_t>& bytes, std::uint32_t value, int count) {
  for (int i = count - 1; i >= 0; --i) bytes.push_back(static_cast<std::uint8_t>(value >> 8 * i));
}

}  // namespace

/// "P#DB1.DBX4.0INT2" or "P#M4.0BYTE2" without its number of elements and type: false if it is none.
bool readAny(const std::string& text, AnyText& any) {
  if (!text.starts_with("P#") || text.starts_with("P##")) return false;
  std::string rest = text.substr(2);
  if (rest.starts_with("DB") && std::isdigit(static_cast<unsigned char>(rest[2])) != 0) {
    any.block = std::atoi(rest.c_str() + 2);
    rest = rest.substr(rest.find('.') + 1);
  }
  std::size_t at = 0;
  while (at < rest.size() && std::isalpha(static_cast<unsigned char>(rest[at])) != 0) ++at;
  const std::string area = rest.substr(0, at);
  std::size_t end = rest.find('.');
  if (end == std::string::npos) return false;
  ++end;
  while (end < rest.size() && std::isdigit(static_cast<unsigned char>(rest[end])) != 0) ++end;
  any.address = constantValue("P#" + area + rest.substr(at, end - at));
  std::size_t digits = rest.size();
  while (digits > end && std::isdigit(static_cast<unsigned char>(rest[digits - 1])) != 0) --digits;
  any.count = digits < rest.size() ? std::atoi(rest.c_str() + digits) : 0;
  any.type = codeOfType(rest.substr(end, digits - end));
  return true;
}

/// The six or ten bytes that the running block makes of an actual parameter.
std::vector<std::uint8_t> Machine::handedBytes(const std::string& actual, bool isAny) const {
  std::vector<std::uint8_t> bytes;
  AnyText any;
  if (!readAny(actual, any)) {
    const bool isName = actual.starts_with("#");
    std::string type;
    for (const Variable& v : frames_.back().block->variables) {
      if (isName && v.name == actual.substr(1)) type = v.type;
    }
    const bool isNumbered = type == "TIMER" || type == "COUNTER" || actual[0] == 'T' || actual[0] == 'C';
    if (isNumbered) {  // of the ANY only: the type, one element, the number at the end
      const char letter = isName ? type[0] : actual[0];
      append(bytes, 0x10, 1);
      append(bytes, letter == 'T' ? 0x1D : 0x1C, 1);
      append(bytes, 1, 2);
      append(bytes, 0, 2);
      append(bytes, static_cast<std::uint32_t>(objectNumber(actual, letter)), 4);
      return bytes;
    }
    const Place p = place(actual);
    if (isName && p.width > 32) {  // a pointer of its own
      for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(p.width); i += 8) {
        Place one = p;
        one.bit += i;
        one.width = 8;
        bytes.push_back(static_cast<std::uint8_t>(read(one)));
      }
      return bytes;
    }
    const std::string areas = "PIQMD?LV";
    const char area = p.area == 'L' ? 'V' : p.area;
    any.block = p.area == 'D' ? p.number : 0;
    any.address = 0x80000000U | static_cast<std::uint32_t>(areas.find(area)) << 24 | p.bit;
    any.count = 1;
    any.type = isName ? codeOfType(type) : codeOfWidth(p.width);
  } else if (const std::uint32_t area = any.address >> 24; any.block == 0 && (area == 0x84 || area == 0x85)) {
    any.block = area == 0x84 ? db : di;  // in the block that is open
    any.address = 0x84000000U | (any.address & 0xFFFFFFU);
  }
  // Local data of this block is V for the one that is called.
  if ((any.address & 0x87000000U) == 0x86000000U) any.address |= 0x01000000U;
  if (isAny) {
    append(bytes, 0x10, 1);
    append(bytes, static_cast<std::uint32_t>(any.type), 1);
    append(bytes, static_cast<std::uint32_t>(any.count), 2);
  }
  append(bytes, static_cast<std::uint32_t>(any.block), 2);
  append(bytes, any.address, 4);
  return bytes;
}

/// P##name: where the pointer of a parameter stands, as the block itself may use it.
std::uint32_t Machine::addressOfParameter(const std::string& name) const {
  const Frame& f = frames_.back();
  if (const auto found = f.references.find(name); found != f.references.end()) return 0x87000000U | found->second.bit;
  for (const Variable& v : f.block->variables) {
    if (v.name == name) return (v.section == Section::Temp ? 0x86000000U : 0x85000000U) | v.bit;  // AR2 not counted
  }
  throw Stop{0xFF, "no local name: " + name};
}

namespace {

/// Bytes of memory that an ANY names, one by one.
struct Bytes {
  Place first;
  std::uint32_t count = 0;
  Place at(std::uint32_t i) const {
    Place p = first;
    p.bit += 8 * i;
    p.width = 8;
    return p;
  }
};

}  // namespace

/// SFC 20, SFC 21, FC 22, FC 25, FC 27, FC 36: false if it is none of them.
bool Machine::systemBlock(const std::string& target, const Statement& s) {
  static const std::string known[] = {"SFC20", "SFC21", "FC22", "FC25", "FC27", "FC36"};
  if (std::ranges::find(known, target) == std::end(known) || program_->blocks.contains(target)) return false;
  const auto actual = [&](const std::string& name) {
    for (const auto& [formal, text] : s.actuals) {
      if (formal == name) return text;
    }
    throw Stop{0xFF, "no parameter " + name};
  };
  int type = 0;
  const auto bytesOf = [&](const std::string& name) {
    AnyText any;
    Bytes bytes;
    if (readAny(actual(name), any)) {
      const int saved = db;
      db = any.block;
      bytes.first = crossing(any.address, 8);
      db = saved;
      bytes.count = static_cast<std::uint32_t>((bitsOfCode(any.type) * any.count + 7) / 8);
      type = any.type;
      return bytes;
    }
    bytes.first = place(actual(name));
    bytes.count = static_cast<std::uint32_t>(bytes.first.width + 7) / 8;
    type = codeOfWidth(bytes.first.width);
    return bytes;
  };
  const auto number = [&](const Bytes& bytes) {
    std::uint32_t value = 0;
    for (std::uint32_t i = 0; i < bytes.count; ++i) value = value << 8 | read(bytes.at(i));
    return value;
  };
  const auto less = [&](std::uint32_t a, std::uint32_t b) {
    if (type == 5) return static_cast<std::int16_t>(a) < static_cast<std::int16_t>(b);
    return static_cast<std::int32_t>(a) < static_cast<std::int32_t>(b);
  };
  const auto give = [&](const Bytes& bytes, std::uint32_t value) {
    for (std::uint32_t i = 0; i < bytes.count; ++i) write(bytes.at(i), value >> 8 * (bytes.count - 1 - i) & 0xFF);
  };
  if (target == "SFC20" || target == "SFC21") {
    const bool isFill = target == "SFC21";
    const Bytes from = bytesOf(isFill ? "BVAL" : "SRCBLK"), to = bytesOf(isFill ? "BLK" : "DSTBLK");
    const std::uint32_t count = isFill ? to.count : std::min(from.count, to.count);
    for (std::uint32_t i = 0; i < count; ++i) write(to.at(i), read(from.at(i % from.count)));
    write(place(actual("RET_VAL")), 0);
  } else if (target == "FC36") {
    const std::uint32_t zero = number(bytesOf("IN0")), one = number(bytesOf("IN1"));
    give(bytesOf("RET_VAL"), read(place(actual("G"))) != 0 ? one : zero);
  } else {
    const bool isLimit = target == "FC22";
    std::uint32_t a = number(bytesOf(isLimit ? "MN" : "IN1")), b = number(bytesOf(isLimit ? "IN" : "IN2")),
                  c = number(bytesOf(isLimit ? "MX" : "IN3")), value = 0;
    const auto least = [&](std::uint32_t x, std::uint32_t y) { return less(y, x) ? y : x; };
    const auto most = [&](std::uint32_t x, std::uint32_t y) { return less(x, y) ? y : x; };
    if (isLimit) {
      // Limits the wrong way round leave the result, and BR, open: 0.
      br = !less(c, a);
      value = br ? most(a, least(b, c)) : 0;
    } else {
      value = target == "FC25" ? most(most(a, b), c) : least(least(a, b), c);
    }
    give(bytesOf("RET_VAL"), value);
    if (isLimit && !br) return leaveSystemBlock(false), true;
  }
  return leaveSystemBlock(true), true;
}

void Machine::leaveSystemBlock(bool isGood) {
  br = isGood;
  cc1 = cc0 = ov = rlo = os = orBit = fc = false;
  sta = true;
  ar[0] = 0;
  for (std::uint32_t& a : accu) a = 0;
}

}  // namespace naive7
