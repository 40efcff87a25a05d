// Printing constants.
#include "frontend/step7/constant_spelling.hpp"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <chrono>

#include "ir/operand.hpp"

namespace rungproof::step7 {

using s7300::Constant;
using s7300::ConstantKind;

namespace {

/// 1D2H3M4S5MS without the parts that are 0.
std::string durationText(std::int64_t ms) {
  if (ms == 0) return "0MS";
  struct Part {
    std::int64_t size;
    const char* letters;
  };
  constexpr std::array<Part, 5> parts = {{{86400000, "D"}, {3600000, "H"}, {60000, "M"}, {1000, "S"}, {1, "MS"}}};
  std::string text = ms < 0 ? "-" : "";
  std::int64_t rest = ms < 0 ? -ms : ms;
  for (const Part& part : parts) {
    if (rest >= part.size) text += fmt::format("{}{}", rest / part.size, part.letters);
    rest %= part.size;
  }
  return text;
}

std::string s5TimeText(std::int64_t bits) {
  std::int64_t unit = 10;
  for (std::int64_t base = bits >> 12 & 3; base > 0; --base) unit *= 10;
  const std::int64_t count = (bits >> 8 & 15) * 100 + (bits >> 4 & 15) * 10 + (bits & 15);
  // Days are not written in an S5TIME; the largest value has none.
  return "S5T#" + durationText(count * unit);
}

std::string realText(std::int64_t bits) {
  const auto value = std::bit_cast<float>(static_cast<std::uint32_t>(bits));
  std::string text = fmt::format("{}", value);
  const std::size_t exponent = text.find('e');
  const std::string mantissa = text.substr(0, exponent);
  if (mantissa.find('.') != std::string::npos) return text;
  return mantissa + ".0" + (exponent == std::string::npos ? "" : text.substr(exponent));
}

std::string pointerText(const Constant& constant) {
  static constexpr std::array<std::string_view, 8> areas = {"P", "I", "Q", "M", "DBX", "DIX", "L", "V"};
  const auto bits = static_cast<std::uint32_t>(constant.value);
  std::string text = "P#";
  if (constant.block != 0) text += fmt::format("DB{}.", constant.block);
  if ((bits & 0x80000000U) != 0) text += fmt::format("{} ", areas[bits >> 24 & 7U]);
  text += fmt::format("{}.{}", (bits & 0x7FFFFU) >> 3, bits & 7U);
  if (constant.kind != ConstantKind::Any) return text;
  static constexpr std::array<std::string_view, 20> types = {"VOID", "BOOL", "BYTE", "CHAR", "WORD", "INT",    "DWORD",
                                                             "DINT", "REAL", "DATE", "TOD",  "TIME", "S5TIME", "",
                                                             "DT",   "",     "",     "",     "",     "STRING"};
  std::string_view type = constant.anyType < types.size() ? types[constant.anyType] : "";
  if (constant.anyType == 0x1C) type = "COUNTER";
  if (constant.anyType == 0x1D) type = "TIMER";
  if (constant.anyType >= 0x17 && constant.anyType <= 0x1A)
    type = std::array<std::string_view, 4>{"BLOCK_FB", "BLOCK_FC", "BLOCK_DB", "BLOCK_SDB"}[constant.anyType - 0x17U];
  return fmt::format("{} {} {}", text, type, constant.anyCount);
}

std::string dateText(std::int64_t days) {
  namespace ch = std::chrono;
  const ch::year_month_day date{ch::sys_days(ch::year(1990) / 1 / 1) + ch::days(days)};
  return fmt::format("{}-{}-{}", static_cast<int>(date.year()), static_cast<unsigned>(date.month()),
                     static_cast<unsigned>(date.day()));
}

std::string bytesText(std::int64_t bits, int count) {
  std::string text;
  for (int i = count - 1; i >= 0; --i) text += fmt::format("{}{}", text.empty() ? "" : ",", bits >> (8 * i) & 0xFF);
  return "B#(" + text + ")";
}

}  // namespace

std::string spellingOf(const Constant& c) {
  switch (c.kind) {
    case ConstantKind::Integer: return fmt::format("{}", c.value);
    case ConstantKind::Long: return fmt::format("L#{}", c.value);
    case ConstantKind::Hex: return fmt::format("16#{:X}", c.value);
    case ConstantKind::Byte: return fmt::format("B#16#{:X}", c.value);
    case ConstantKind::Word: return fmt::format("W#16#{:X}", c.value);
    case ConstantKind::DWord: return fmt::format("DW#16#{:X}", c.value);
    case ConstantKind::Binary: return fmt::format("2#{:b}", c.value);
    case ConstantKind::Real: return realText(c.value);
    case ConstantKind::S5Time: return s5TimeText(c.value);
    case ConstantKind::Time: return "T#" + durationText(static_cast<std::int32_t>(c.value));
    case ConstantKind::Date: return "D#" + dateText(c.value);
    case ConstantKind::TimeOfDay:
      return fmt::format("TOD#{}:{}:{}.{:03}", c.value / 3600000, c.value / 60000 % 60, c.value / 1000 % 60,
                         c.value % 1000);
    case ConstantKind::DateAndTime: {
      const auto bits = static_cast<std::uint64_t>(c.value);
      const auto part = [&](int byte) { return bits >> (8 * (7 - byte)) & 0xFFU; };
      return fmt::format("DT#{:02x}-{:x}-{:x}-{:x}:{:x}:{:x}.{:02x}{:x}", part(0), part(1), part(2), part(3), part(4),
                         part(5), part(6), part(7) >> 4);
    }
    case ConstantKind::Count: return fmt::format("C#{:x}", c.value);
    case ConstantKind::TwoBytes: return bytesText(c.value, 2);
    case ConstantKind::FourBytes: return bytesText(c.value, 4);
    case ConstantKind::Text: return quoted(c.text, '\'');
    case ConstantKind::Boolean: return c.value != 0 ? "TRUE" : "FALSE";
    case ConstantKind::Pointer:
    case ConstantKind::Any: return pointerText(c);
    case ConstantKind::Object: return fmt::format("{} {}", c.text, c.value);
  }
  return "";
}

Width widthOfConstant(const Constant& c) {
  switch (c.kind) {
    case ConstantKind::Boolean: return Width::Bit;
    case ConstantKind::Byte: return Width::Byte;
    case ConstantKind::Word:
    case ConstantKind::S5Time:
    case ConstantKind::Date:
    case ConstantKind::Count:
    case ConstantKind::TwoBytes: return Width::Word;
    case ConstantKind::Integer: return c.value >= -32768 && c.value <= 65535 ? Width::Word : Width::DWord;
    case ConstantKind::Hex:
    case ConstantKind::Binary: return c.value <= 0xFFFF ? Width::Word : Width::DWord;
    case ConstantKind::Text: return c.text.size() <= 1 ? Width::Byte : c.text.size() <= 2 ? Width::Word : Width::DWord;
    default: return Width::DWord;
  }
}

}  // namespace rungproof::step7
