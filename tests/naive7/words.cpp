// The naive interpreter's statements on accumulators: integer and REAL math, word logic, comparisons, shifts,
// conversions.
#include <cmath>
#include <cstring>

#include "tests/naive7/machine.hpp"

namespace naive7 {
namespace {

std::int64_t word(std::uint32_t accu) { return static_cast<std::int16_t>(accu & 0xFFFF); }
std::int64_t dword(std::uint32_t accu) { return static_cast<std::int32_t>(accu); }
std::uint32_t lowWord(std::uint32_t accu, std::int64_t value) {
  return (accu & 0xFFFF0000U) | static_cast<std::uint32_t>(value & 0xFFFF);
}
float real(std::uint32_t bits) {
  float value = 0;
  std::memcpy(&value, &bits, 4);
  return value;
}
std::uint32_t bitsOf(float value) {
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, 4);
  return bits;
}
bool isDenormal(std::uint32_t bits) { return (bits & 0x7F800000U) == 0 && (bits & 0x007FFFFFU) != 0; }
float withoutDenormal(std::uint32_t bits) { return real(isDenormal(bits) ? bits & 0x80000000U : bits); }
constexpr float smallestNormal = 1.17549435e-38F;

}  // namespace

void Machine::popMath() {
  if (!is400_) return;
  accu[1] = accu[2];
  accu[2] = accu[3];
}

/// CC1 and CC0 tell the sign of `sign`.
void Machine::setMath(std::int64_t sign, std::uint32_t stored, bool overflow) {
  cc1 = sign > 0;
  cc0 = sign < 0;
  ov = overflow;
  os = os || overflow;
  accu[0] = stored;
}

bool Machine::wordStatement(const Statement& s) {
  const std::string& op = s.op;
  const std::uint32_t a1 = accu[0], a2 = accu[1];
  if (op == "+I" || op == "-I") {
    const std::int64_t exact = op == "+I" ? word(a2) + word(a1) : word(a2) - word(a1);
    const std::int64_t wrapped = static_cast<std::int16_t>(exact & 0xFFFF);
    setMath(wrapped, lowWord(a1, wrapped), wrapped != exact);
    return popMath(), true;
  }
  if (op == "*I") {
    const std::int64_t exact = word(a2) * word(a1);
    setMath(exact, static_cast<std::uint32_t>(exact), exact < -32768 || exact > 32767);
    return popMath(), true;
  }
  if (op == "/I" || op == "/D" || op == "MOD") {
    const bool isWord = op == "/I";
    const std::int64_t dividend = isWord ? word(a2) : dword(a2), divisor = isWord ? word(a1) : dword(a1);
    if (divisor == 0) {
      accu[0] = 0;
      cc1 = cc0 = ov = os = true;
      return popMath(), true;
    }
    const std::int64_t quotient = dividend / divisor, remainder = dividend % divisor;
    const bool overflow = quotient > (isWord ? 32767 : 2147483647LL);
    if (isWord) {
      setMath(quotient, lowWord(static_cast<std::uint32_t>(remainder) << 16, quotient), overflow);
    } else if (op == "/D") {
      setMath(quotient, static_cast<std::uint32_t>(quotient), overflow);
    } else {
      setMath(overflow ? 1 : remainder, static_cast<std::uint32_t>(remainder), overflow);
    }
    return popMath(), true;
  }
  if (op == "+D" || op == "-D") {
    const std::int64_t exact = op == "+D" ? dword(a2) + dword(a1) : dword(a2) - dword(a1);
    const std::int64_t wrapped = dword(static_cast<std::uint32_t>(exact));
    setMath(wrapped, static_cast<std::uint32_t>(exact), wrapped != exact);
    return popMath(), true;
  }
  if (op == "*D") {
    const std::int64_t exact = dword(a2) * dword(a1);
    setMath(exact, static_cast<std::uint32_t>(exact), exact != dword(static_cast<std::uint32_t>(exact)));
    return popMath(), true;
  }
  if (op == "+") {
    const std::uint32_t constant = constantValue(s.operand);
    accu[0] = s.operand.starts_with("L#") ? a1 + constant : lowWord(a1, word(a1) + word(constant));
    return true;
  }
  if (op == "AW" || op == "OW" || op == "XOW" || op == "AD" || op == "OD" || op == "XOD") {
    const std::uint32_t other = s.operand.empty() ? a2 : constantValue(s.operand);
    const std::uint32_t result = op[0] == 'A' ? a1 & other : op[0] == 'O' ? a1 | other : a1 ^ other;
    const bool isWord = op.back() == 'W';
    accu[0] = isWord ? lowWord(a1, result) : result;
    cc1 = (isWord ? result & 0xFFFF : result) != 0;
    cc0 = ov = false;
    return true;
  }
  if (op.size() >= 2 && (op[0] == '=' || op[0] == '<' || op[0] == '>')) {
    const std::string relation = op.substr(0, op.size() - 1);
    bool isLess = false, isEqual = false, isUnordered = false;
    if (op.back() == 'R') {
      const float left = real(a2), right = real(a1);  // only results and operands of math know no denormal numbers
      isUnordered = std::isnan(left) || std::isnan(right);
      isLess = left < right;
      isEqual = left == right;
    } else {
      const std::int64_t left = op.back() == 'I' ? word(a2) : dword(a2),
                         right = op.back() == 'I' ? word(a1) : dword(a1);
      isLess = left < right;
      isEqual = left == right;
    }
    const bool isGreater = !isLess && !isEqual;
    rlo = !isUnordered &&
          ((relation == "==" && isEqual) || (relation == "<>" && !isEqual) || (relation == "<" && isLess) ||
           (relation == ">" && isGreater) || (relation == "<=" && !isGreater) || (relation == ">=" && !isLess));
    cc1 = isUnordered || isGreater;
    cc0 = isUnordered || isLess;
    ov = isUnordered;
    os = os || isUnordered;
    orBit = false;
    sta = rlo;
    fc = true;
    return true;
  }
  if (op == "INC" || op == "DEC") {
    const auto n = static_cast<std::uint32_t>(std::atoi(s.operand.c_str()));
    accu[0] = (a1 & 0xFFFFFF00U) | ((op == "INC" ? a1 + n : a1 - n) & 0xFF);
    return true;
  }
  return shift(s) || conversion(s) || realStatement(s);
}

bool Machine::shift(const Statement& s) {
  const std::string& op = s.op;
  if (op == "RLDA" || op == "RRDA") {
    const bool out = op == "RLDA" ? accu[0] >> 31 : (accu[0] & 1U) != 0;
    const std::uint32_t in = cc1 ? 1 : 0;
    accu[0] = op == "RLDA" ? accu[0] << 1 | in : accu[0] >> 1 | in << 31;
    cc1 = out;
    cc0 = ov = false;
    return true;
  }
  if (op != "SSI" && op != "SSD" && op != "SLW" && op != "SRW" && op != "SLD" && op != "SRD" && op != "RLD" &&
      op != "RRD")
    return false;
  const std::uint32_t count =
      s.operand.empty() ? accu[1] & 0xFF : static_cast<std::uint32_t>(std::atoi(s.operand.c_str()));
  if (count == 0) return true;
  const bool isWord = op == "SSI" || op == "SLW" || op == "SRW";
  const std::uint32_t top = isWord ? 0x8000U : 0x80000000U;
  std::uint32_t value = isWord ? accu[0] & 0xFFFF : accu[0];
  bool last = false;
  for (std::uint32_t i = 0; i < count; ++i) {  // one place after the other
    const bool high = (value & top) != 0, low = (value & 1U) != 0;
    if (op[1] == 'L') {
      last = high;
      value = value << 1 | (op[0] == 'R' && high ? 1U : 0U);
      if (isWord) value &= 0xFFFF;
    } else {
      last = low;
      value >>= 1;
      if ((op[1] == 'S' && high) || (op[0] == 'R' && low)) value |= top;
    }
  }
  accu[0] = isWord ? (accu[0] & 0xFFFF0000U) | value : value;
  cc1 = last;
  cc0 = ov = false;
  return true;
}

bool Machine::conversion(const Statement& s) {
  const std::string& op = s.op;
  const std::uint32_t a = accu[0];
  if (op == "BTI" || op == "BTD") {
    const int digits = op == "BTI" ? 3 : 7;
    std::int64_t value = 0;
    for (int i = digits - 1; i >= 0; --i) {
      const std::uint32_t digit = a >> 4 * i & 15;
      if (digit > 9) throw Stop{0x21, "BCD digit"};
      value = value * 10 + digit;
    }
    if ((a >> (op == "BTI" ? 15 : 31) & 1U) != 0) value = -value;
    accu[0] = op == "BTI" ? lowWord(a, value) : static_cast<std::uint32_t>(value);
    return true;
  }
  if (op == "ITB" || op == "DTB") {
    const bool isWord = op == "ITB";
    const std::int64_t value = isWord ? word(a) : dword(a), limit = isWord ? 999 : 9999999;
    ov = value > limit || value < -limit;
    os = os || ov;
    if (ov) return true;
    std::uint32_t bcd = value < 0 ? (isWord ? 0xF000U : 0xF0000000U) : 0;
    std::uint32_t rest = static_cast<std::uint32_t>(value < 0 ? -value : value);
    for (int i = 0; rest != 0; ++i, rest /= 10) bcd |= rest % 10 << 4 * i;
    accu[0] = isWord ? lowWord(a, bcd) : bcd;
    return true;
  }
  if (op == "ITD") return accu[0] = static_cast<std::uint32_t>(word(a)), true;
  if (op == "DTR") return accu[0] = bitsOf(static_cast<float>(dword(a))), true;
  if (op == "INVI") return accu[0] = a ^ 0xFFFFU, true;
  if (op == "INVD") return accu[0] = ~a, true;
  if (op == "NEGI") {
    const std::int64_t wrapped = static_cast<std::int16_t>(-word(a) & 0xFFFF);
    return setMath(wrapped, lowWord(a, wrapped), word(a) == -32768), true;
  }
  if (op == "NEGD") return setMath(dword(0 - a), 0 - a, a == 0x80000000U), true;
  if (op == "CAW") return accu[0] = lowWord(a, static_cast<std::int64_t>((a & 0xFF) << 8 | (a >> 8 & 0xFF))), true;
  if (op == "CAD") {
    accu[0] = a << 24 | (a & 0xFF00U) << 8 | (a >> 8 & 0xFF00U) | a >> 24;
    return true;
  }
  if (op == "RND" || op == "TRUNC" || op == "RND+" || op == "RND-") {
    const double value = static_cast<double>(withoutDenormal(a));
    double result = std::floor(value);
    if (op == "TRUNC" && value < 0) result = std::ceil(value);
    if (op == "RND+") result = std::ceil(value);
    if (op == "RND") {
      const double part = value - std::floor(value);
      const bool isOdd = std::fmod(std::floor(value), 2) != 0;
      if (part > 0.5 || (part == 0.5 && isOdd)) result += 1;
    }
    ov = !(result >= -2147483648.0 && result <= 2147483647.0);
    os = os || ov;
    if (!ov) accu[0] = static_cast<std::uint32_t>(static_cast<std::int64_t>(result));
    return true;
  }
  return false;
}

/// The flags of a REAL result; `invalid` is stored where it is no number. An operand that counts as 0 gives the flags
/// of an underflow to whatever number comes out.
void Machine::setReal(float result, bool isSmall, bool hasDenormal, std::uint32_t invalid) {
  std::uint32_t& target = accu[0];
  ov = true;
  if (std::isnan(result)) {
    cc1 = cc0 = true;
    target = invalid;
  } else if (isSmall || hasDenormal) {
    cc1 = cc0 = false;
    target = isSmall ? 0 : bitsOf(result);
  } else {
    cc1 = result > 0;
    cc0 = result < 0;
    ov = std::isinf(result);
    target = bitsOf(result);
  }
  os = os || ov;
}

bool Machine::realStatement(const Statement& s) {
  const std::string& op = s.op;
  const std::uint32_t a1 = accu[0], a2 = accu[1];
  if (op == "ABS") return accu[0] = a1 & 0x7FFFFFFFU, true;
  if (op == "NEGR") return accu[0] = a1 ^ 0x80000000U, true;
  if (op == "+R" || op == "-R" || op == "*R" || op == "/R") {
    const float x = withoutDenormal(a2), y = withoutDenormal(a1);
    const double wideX = static_cast<double>(x), wideY = static_cast<double>(y);
    const float result = op == "+R" ? x + y : op == "-R" ? x - y : op == "*R" ? x * y : x / y;
    const double wide = op == "+R"   ? wideX + wideY
                        : op == "-R" ? wideX - wideY
                        : op == "*R" ? wideX * wideY
                                     : wideX / wideY;
    const bool isSmall = wide != 0 && std::fabs(result) < smallestNormal;
    setReal(result, isSmall, isDenormal(a1) || isDenormal(a2), 0xFFFFFFFFU);
    return popMath(), true;
  }
  const float x = withoutDenormal(a1);
  const double wide = static_cast<double>(x);
  double result = 0;
  if (op == "SQR") {
    result = wide * wide;
  } else if (op == "SQRT") {
    result = std::sqrt(wide);
  } else if (op == "EXP") {
    result = std::exp(wide);
  } else if (op == "LN") {
    result = wide == 0 ? std::nan("") : std::log(wide);
  } else if (op == "SIN") {
    result = std::sin(wide);
  } else if (op == "COS") {
    result = std::cos(wide);
  } else if (op == "TAN") {
    result = std::tan(wide);
  } else if (op == "ASIN") {
    result = std::asin(wide);
  } else if (op == "ACOS") {
    result = std::acos(wide);
  } else if (op == "ATAN") {
    result = std::atan(wide);
  } else {
    return false;
  }
  const auto narrow = static_cast<float>(result);
  const bool isPositive = op == "EXP" && !std::isinf(wide);  // is never 0
  const bool isSmall = (result != 0 || isPositive) && std::fabs(narrow) < smallestNormal;
  setReal(narrow, isSmall, isDenormal(a1), 0x7FFFFFFFU);
  return true;
}

}  // namespace naive7
