// The naive interpreter: boxes that work on bytes, words and double words.

#include <fmt/format.h>

#include <bit>
#include <cstdlib>

#include "naive.hpp"

namespace rungproof::naive {

namespace {
std::int64_t asSigned(std::uint32_t v, int bytes) {
  if (bytes == 2) return static_cast<std::int16_t>(v);
  if (bytes == 4) return static_cast<std::int32_t>(v);
  return v;
}
}  // namespace

/// A box: nothing of it happens with a pointer that leads nowhere (001:2347).
void Interpreter::box(const Instruction& i, const std::string& name) {
  const std::optional<std::string_view> signature = signatureOf(name);
  if (!signature) std::abort();
  if (!follow(i, *signature)) {
    fail("0006");
    return;
  }
  if (name == "S" || name == "R" || name == "SI" || name == "RI")
    setOrReset(i, name[0] == 'S', name.size() == 2);
  else if (name == "SHRB")
    shiftRegister(i);
  else if (!smartArithmetic(i, name) && !arithmetic(i, name) && !divide(i, name) && !realArithmetic(i, name) &&
           !realFunction(i, name) && !bitwise(i, name) && !shifts(i, name) && !moves(i, name) &&
           !immediateMove(i, name) && !conversions(i, name) && !digits(i, name) && !numberToText(i, name) &&
           !textToNumber(i, name) && !strings(i, name) && !tables(i, name) && !clockBox(i, name) &&
           !interrupts(i, name) && !ports(i, name))
    std::abort();
}

/// Of the S7-200 SMART: BCDDI and DIBCD in the place of their operand, absolute values.
bool Interpreter::smartArithmetic(const Instruction& i, const std::string& name) {
  if (name == "BCDDI" || name == "DIBCD") {
    const std::uint32_t v = read(i.operands[0], 4);
    const std::string base = name == "BCDDI" ? fmt::format("{:x}", v) : fmt::format("{}", v);
    const bool bad = name == "BCDDI" ? base.find_first_of("abcdef") != std::string::npos : v > 99999999;
    status(name == "BCDDI" ? 6 : 1, bad);
    if (bad) return fail(name == "BCDDI" ? "SM1.6" : "SM1.1");
    write(i.operands[0], 4, static_cast<std::uint32_t>(std::stoul(base, nullptr, name == "BCDDI" ? 10 : 16)));
    return true;
  }
  if (name.substr(0, 3) != "ABS") return false;
  const int bytes = name == "ABSI" ? 2 : 4;
  const std::uint32_t v = read(i.operands[0], bytes);
  const bool isNegative = (v >> (8 * bytes - 1) & 1) != 0;
  const std::uint32_t r = !isNegative ? v : name == "ABSR" ? v ^ 0x80000000U : ~v + 1;
  write(i.operands[1], bytes, r);
  status(0, (bytes == 2 ? r & 0xFFFF : r) == 0);
  return true;
}

bool Interpreter::arithmetic(const Instruction& i, const std::string& name) {
  static const std::string operators = "+-*/";
  const bool isBinary =
      name.size() == 2 && operators.find(name[0]) != std::string::npos && (name[1] == 'I' || name[1] == 'D');
  if (isBinary) {
    const int bytes = name[1] == 'I' ? 2 : 4;
    const std::int64_t a = asSigned(read(i.operands[1], bytes), bytes), b = asSigned(read(i.operands[0], bytes), bytes);
    if (name[0] == '/') {
      status(3, b == 0);
      if (b == 0) return fail("SM1.3");
    }
    const std::int64_t r = name[0] == '+' ? a + b : name[0] == '-' ? a - b : name[0] == '*' ? a * b : a / b;
    const std::int64_t most = bytes == 2 ? 32767 : 2147483647LL;
    const bool overflow = r > most || r < -most - 1;
    status(1, overflow);
    if (overflow) {
      status(0, false);
      status(2, false);
      return fail("SM1.1");
    }
    write(i.operands[1], bytes, static_cast<std::uint32_t>(r));
    status(0, r == 0);
    status(2, r < 0);
    return true;
  }
  if (name == "MUL") {
    const std::int32_t r =
        static_cast<std::int16_t>(read(i.operands[0], 2)) * static_cast<std::int16_t>(read(i.operands[1], 4) & 0xFFFF);
    write(i.operands[1], 4, static_cast<std::uint32_t>(r));
    status(1, false);
    status(3, false);
    status(0, r == 0);
    status(2, r < 0);
    return true;
  }
  if (name != "DECO" && name.size() == 4 && (name.substr(0, 3) == "INC" || name.substr(0, 3) == "DEC")) {
    const int bytes = name[3] == 'B' ? 1 : name[3] == 'W' ? 2 : 4;
    const std::int64_t a = asSigned(read(i.operands[0], bytes), bytes), r = a + (name[0] == 'I' ? 1 : -1);
    const std::int64_t most = bytes == 1 ? 255 : bytes == 2 ? 32767 : 2147483647LL, least = bytes == 1 ? 0 : -most - 1;
    const bool overflow = r > most || r < least;
    write(i.operands[0], bytes, static_cast<std::uint32_t>(r));
    status(1, overflow);
    if (overflow) fail("SM1.1");
    // After an overflow zero and negative mean nothing (001:4814); the engine's choice for such bits is 0.
    status(0, !overflow && r == 0);
    if (bytes > 1) status(2, !overflow && r < 0);
    return true;
  }
  return false;
}

/// DIV: the remainder to the high word, the quotient to the low word of OUT (001:4890-4894).
bool Interpreter::divide(const Instruction& i, const std::string& name) {
  if (name != "DIV") return false;
  const int a = static_cast<std::int16_t>(read(i.operands[1], 4) & 0xFFFF),
            b = static_cast<std::int16_t>(read(i.operands[0], 2));
  status(3, b == 0);
  if (b == 0) return fail("SM1.3");
  const int quotient = a / b, remainder = a % b;
  status(1, quotient > 32767);
  if (quotient > 32767) {
    status(0, false);
    status(2, false);
    return fail("SM1.1");
  }
  const std::uint32_t r = static_cast<std::uint32_t>(remainder) << 16 | (static_cast<std::uint32_t>(quotient) & 0xFFFF);
  write(i.operands[1], 4, r);
  status(0, r == 0);  // zero and sign are those of the double word: the default
  status(2, (r >> 31) != 0);
  return true;
}

bool Interpreter::bitwise(const Instruction& i, const std::string& name) {
  const int bytes = name.back() == 'B' ? 1 : name.back() == 'W' ? 2 : 4;
  const std::string operation = name.substr(0, name.size() - 1);
  std::uint32_t r = 0;
  std::size_t at = 1;
  if (operation == "INV") {
    at = 0;
    r = ~read(i.operands[0], bytes);
  } else if (operation == "AND")
    r = read(i.operands[0], bytes) & read(i.operands[1], bytes);
  else if (operation == "OR")
    r = read(i.operands[0], bytes) | read(i.operands[1], bytes);
  else if (operation == "XOR")
    r = read(i.operands[0], bytes) ^ read(i.operands[1], bytes);
  else if (operation == "NAND")
    r = ~(read(i.operands[0], bytes) & read(i.operands[1], bytes));
  else if (operation == "NOR")
    r = ~(read(i.operands[0], bytes) | read(i.operands[1], bytes));
  else if (operation == "NXOR")
    r = ~(read(i.operands[0], bytes) ^ read(i.operands[1], bytes));
  else
    return false;
  write(i.operands[at], bytes, r);
  status(0, read(i.operands[at], bytes) == 0);
  return true;
}

/// Bit by bit, as the manual tells it (001:5921-5957).
bool Interpreter::shifts(const Instruction& i, const std::string& name) {
  if (name.size() != 3 || (name[0] != 'S' && name[0] != 'R') || (name[1] != 'L' && name[1] != 'R')) return false;
  const int bytes = name[2] == 'B' ? 1 : name[2] == 'W' ? 2 : name[2] == 'D' ? 4 : 0;
  if (bytes == 0) return false;
  const int w = bytes * 8;
  int count = static_cast<int>(read(i.operands[1], 1));
  const bool rotate = name[0] == 'R', left = name[1] == 'L';
  count = rotate ? count % w : std::min(count, w);
  std::uint64_t v = read(i.operands[0], bytes);
  for (int k = 0; k < count; ++k) {
    const bool out = left ? (v >> (w - 1) & 1) != 0 : (v & 1) != 0;
    v = left ? v << 1 : v >> 1;
    if (rotate && out) v |= left ? 1ULL : 1ULL << (w - 1);
    v &= w == 32 ? 0xFFFFFFFFULL : (1ULL << w) - 1;
    status(1, out);
  }
  write(i.operands[0], bytes, static_cast<std::uint32_t>(v));
  status(0, v == 0);
  return true;
}

void Interpreter::shiftRegister(const Instruction& i) {
  const Operand& first = i.operands[1];
  const int n = static_cast<std::int8_t>(read(i.operands[2], 1)), length = std::abs(n);
  if (n == 0 || length > 64) {
    fail("0092");
    return;
  }
  const std::uint32_t size = first.area == Area::V                            ? 10240
                             : first.area == Area::M || first.area == Area::S ? 32
                             : first.area == Area::L                          ? 64
                                                                              : 16;
  if (first.offset * 8 + first.bit + static_cast<std::uint32_t>(length) > size * 8) {
    fail("0091");
    return;
  }
  const bool data = readBit(i.operands[0]);
  const auto get = [&](int k) {
    const std::uint32_t at = first.offset * 8 + first.bit + static_cast<std::uint32_t>(k);
    return bitAt(first.area, at / 8, at % 8);
  };
  const auto put = [&](int k, bool v) {
    const std::uint32_t at = first.offset * 8 + first.bit + static_cast<std::uint32_t>(k);
    putBit(first.area, at / 8, at % 8, v);
  };
  if (n > 0) {
    const bool out = get(length - 1);
    for (int k = length - 1; k > 0; --k) put(k, get(k - 1));
    put(0, data);
    status(1, out);
  } else {
    const bool out = get(0);
    for (int k = 0; k + 1 < length; ++k) put(k, get(k + 1));
    put(length - 1, data);
    status(1, out);
  }
}

bool Interpreter::moves(const Instruction& i, const std::string& name) {
  if (name == "MOVB" || name == "MOVW" || name == "MOVD" || name == "MOVR") {
    const int bytes = name[3] == 'B' ? 1 : name[3] == 'W' ? 2 : 4;
    write(i.operands[1], bytes, read(i.operands[0], bytes));
  } else if (name == "BMB" || name == "BMW" || name == "BMD") {
    const int bytes = name[2] == 'B' ? 1 : name[2] == 'W' ? 2 : 4;
    const int count = static_cast<int>(read(i.operands[2], 1));
    if (!fits(i.operands[0], count, bytes) || !fits(i.operands[1], count, bytes)) return fail("0091");
    for (int k = 0; k < count; ++k) write(i.operands[1], bytes, read(i.operands[0], bytes, k), k);
  } else if (name == "SWAP") {
    const std::uint32_t v = read(i.operands[0], 2);
    write(i.operands[0], 2, (v >> 8 | v << 8) & 0xFFFF);
  } else if (name == "FILL") {
    const int count = static_cast<int>(read(i.operands[2], 1));
    const std::uint32_t v = read(i.operands[0], 2);
    if (!fits(i.operands[1], count, 2)) return fail("0091");
    for (int k = 0; k < count; ++k) write(i.operands[1], 2, v, k);
  } else
    return false;
  return true;
}

bool Interpreter::conversions(const Instruction& i, const std::string& name) {
  const auto fails = [&](bool bad) {
    status(1, bad);
    return bad && fail("SM1.1");
  };
  if (name == "BTI")
    write(i.operands[1], 2, read(i.operands[0], 1));
  else if (name == "ITB") {
    const std::int64_t v = asSigned(read(i.operands[0], 2), 2);
    if (!fails(v < 0 || v > 255)) write(i.operands[1], 1, static_cast<std::uint32_t>(v));
  } else if (name == "ITD")
    write(i.operands[1], 4, static_cast<std::uint32_t>(asSigned(read(i.operands[0], 2), 2)));
  else if (name == "DTI") {
    const std::int64_t v = asSigned(read(i.operands[0], 4), 4);
    if (!fails(v < -32768 || v > 32767)) write(i.operands[1], 2, static_cast<std::uint32_t>(v));
  } else if (name == "DTR")
    write(i.operands[1], 4, std::bit_cast<std::uint32_t>(static_cast<float>(asSigned(read(i.operands[0], 4), 4))));
  else if (name == "BCDI" || name == "IBCD") {
    std::uint32_t v = read(i.operands[0], 2), r = 0;
    bool bad = name == "IBCD" && v > 9999;
    if (name == "BCDI") {
      for (int shift = 12; shift >= 0; shift -= 4) {
        bad = bad || (v >> shift & 15) > 9;
        r = r * 10 + (v >> shift & 15);
      }
    } else {
      r = (v / 1000 % 10) << 12 | (v / 100 % 10) << 8 | (v / 10 % 10) << 4 | v % 10;
    }
    status(6, bad);
    if (bad)
      fail("SM1.6");
    else
      write(i.operands[0], 2, r);
  } else if (name == "SEG") {
    static constexpr std::uint8_t segments[] = {0x3F, 6,    0x5B, 0x4F, 0x66, 0x6D, 0x7D, 7,
                                                0x7F, 0x67, 0x77, 0x7C, 0x39, 0x5E, 0x79, 0x71};
    write(i.operands[1], 1, segments[read(i.operands[0], 1) & 15]);
  } else if (name == "DECO") {
    write(i.operands[1], 2, 1U << (read(i.operands[0], 1) & 15));
  } else if (name == "ENCO") {  // no bit at all: 0, and the high half of the byte 0: the defaults
    const std::uint32_t v = read(i.operands[0], 2);
    std::uint32_t number = 0;
    while (v != 0 && (v >> number & 1) == 0) ++number;
    write(i.operands[1], 1, number);
  } else
    return false;
  return true;
}

/// Table: capacity, entries, data, at most 100 (001:6260-6330). FND starts one word later, at the entries (001:6441).
bool Interpreter::tables(const Instruction& i, const std::string& name) {
  if (name == "ATT") {
    const Operand& table = i.operands[1];
    const std::uint32_t capacity = read(table, 2), entries = read(table, 2, 1), data = read(i.operands[0], 2);
    status(4, entries >= capacity);
    if (entries >= capacity) return fail("SM1.4");
    if (entries >= 100 || !fits(table, static_cast<int>(entries) + 3, 2)) return fail("0091");
    write(table, 2, data, 2 + static_cast<int>(entries));
    write(table, 2, entries + 1, 1);
  } else if (name == "FIFO" || name == "LIFO") {
    const Operand& table = i.operands[0];
    const auto entries = static_cast<int>(read(table, 2, 1));
    status(5, entries == 0);
    if (entries == 0) return fail("SM1.5");
    if (entries > 100 || !fits(table, entries + 2, 2)) return fail("0091");
    const std::uint32_t data = read(table, 2, name == "FIFO" ? 2 : 1 + entries);
    for (int k = 0; name == "FIFO" && k + 1 < entries; ++k) write(table, 2, read(table, 2, 3 + k), 2 + k);
    write(table, 2, static_cast<std::uint32_t>(entries - 1), 1);
    write(i.operands[1], 2, data);
  } else if (name.starts_with("FND")) {
    const Operand& table = i.operands[0];
    const auto entries = static_cast<int>(read(table, 2)),
               pattern = static_cast<int>(static_cast<std::int16_t>(read(i.operands[1], 2)));
    if (entries > 100 || !fits(table, entries + 1, 2)) return fail("0091");
    auto index = static_cast<int>(read(i.operands[2], 2));
    const auto holds = [&](int entry) {
      const std::string relation = name.substr(3);
      return relation == "="    ? entry == pattern
             : relation == "<>" ? entry != pattern
             : relation == "<"  ? entry < pattern
                                : entry > pattern;
    };
    while (index < entries && !holds(static_cast<std::int16_t>(read(table, 2, 1 + index)))) ++index;
    write(i.operands[2], 2, static_cast<std::uint32_t>(index));
  } else
    return false;
  return true;
}

}  // namespace rungproof::naive
