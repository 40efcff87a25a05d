// Printing.
#include "frontend/mc7/code_text.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>

#include "frontend/step7/constant_spelling.hpp"

namespace rungproof::mc7 {

using s7300::Constant;
using s7300::ConstantKind;

namespace {

std::string constantText(ConstantKind kind, std::int64_t value) {
  Constant constant;
  constant.kind = kind;
  constant.value = value;
  return step7::spellingOf(constant);
}

std::string hexText(const CodeItem& item) {
  return item.opcode->bytes == 6 ? constantText(ConstantKind::DWord, item.dword())
                                 : constantText(ConstantKind::Word, item.word());
}

bool isDecimalCoded(std::uint16_t digits) {
  return (digits & 15U) < 10 && (digits >> 4 & 15U) < 10 && (digits >> 8 & 15U) < 10;
}

/// A pointer as constants are written; a word of other bits as a number.
std::string pointerWordText(std::uint32_t bits) {
  const std::uint32_t head = bits >> 24;
  const bool isPointer = (bits & 0x00F80000U) == 0 && (head == 0 || (head & 0xF8U) == 0x80U);
  return constantText(isPointer ? ConstantKind::Pointer : ConstantKind::DWord, bits);
}

/// Up to four characters, each by its number where it is no plain one.
std::string charactersText(const CodeItem& item) {
  std::string text = "'";
  bool isBegun = false;
  for (std::size_t i = 2; i < item.opcode->bytes; ++i) {
    const std::uint8_t c = item.bytes[i];
    if (!isBegun && c == 0) continue;
    isBegun = true;
    const bool isPlain = c >= 0x20 && c < 0x7F && c != '$' && c != '\'';
    text += isPlain ? std::string(1, static_cast<char>(c)) : fmt::format("${:02X}", c);
  }
  return isBegun ? text + "'" : hexText(item);
}

std::string realConstantText(std::uint32_t bits) {
  return std::isfinite(std::bit_cast<float>(bits)) ? constantText(ConstantKind::Real, bits)
                                                   : constantText(ConstantKind::DWord, bits);
}

/// A time whose base is not the finest one would be read as the finest: it stays a number.
std::string s5TimeConstantText(std::uint16_t bits) {
  const unsigned base = bits >> 12, count = (bits >> 8 & 15U) * 100 + (bits >> 4 & 15U) * 10 + (bits & 15U);
  const bool isFinest = base < 4 && isDecimalCoded(bits) && (base == 0 || count >= 100);
  return constantText(isFinest ? ConstantKind::S5Time : ConstantKind::Word, bits);
}

std::string valueText(const CodeItem& item) {
  const std::uint16_t word = item.word();
  const std::uint32_t dword = item.dword();
  constexpr std::uint32_t millisecondsOfDay = 86'400'000, lastDay = 65378;  // 2168-12-31
  switch (item.opcode->form) {
    case Form::HexByte: return constantText(ConstantKind::Byte, item.b1());
    case Form::HexWord:
    case Form::HexDWord: return hexText(item);
    case Form::BinaryWord: return constantText(ConstantKind::Binary, word);
    case Form::BinaryDWord: return constantText(ConstantKind::Binary, dword);
    case Form::Integer: return constantText(ConstantKind::Integer, static_cast<std::int16_t>(word));
    case Form::Long: return constantText(ConstantKind::Long, static_cast<std::int32_t>(dword));
    case Form::Real: return realConstantText(dword);
    case Form::TwoBytes: return constantText(ConstantKind::TwoBytes, word);
    case Form::FourBytes: return constantText(ConstantKind::FourBytes, dword);
    case Form::TwoCharacters:
    case Form::FourCharacters: return charactersText(item);
    case Form::CountValue:
      return word < 0x1000 && isDecimalCoded(word) ? constantText(ConstantKind::Count, word) : hexText(item);
    case Form::Date: return word <= lastDay ? constantText(ConstantKind::Date, word) : hexText(item);
    case Form::S5Time: return s5TimeConstantText(word);
    case Form::Time: return constantText(ConstantKind::Time, static_cast<std::int32_t>(dword));
    case Form::TimeOfDay:
      return dword < millisecondsOfDay ? constantText(ConstantKind::TimeOfDay, dword) : hexText(item);
    case Form::Pointer: return pointerWordText(dword);
    case Form::Offset: return pointerWordText(word);
    default: return {};
  }
}

std::string letteredNumber(const Opcode& opcode, unsigned number) {
  return opcode.operand.empty() ? fmt::format("{}", number) : fmt::format("{} {}", opcode.operand, number);
}

class OperandPrinter {
 public:
  OperandPrinter(const CodeItem& item, const CodeNames& names)
      : item_(item), opcode_(*item.opcode), names_(names), isLoad_(opcode_.mnemonic == "L") {}

  std::string text() const {
    const unsigned high = item_.b1() >> 4 & 7U, low = item_.b1() & 7U;
    switch (opcode_.form) {
      case Form::None: return std::string(opcode_.operand);
      case Form::Bit: return address(high, Size::Bit, item_.word(), low);
      case Form::MarkerBit: return address(3, Size::Bit, item_.b1(), item_.bytes[0] & 7U);
      case Form::ImageBit:
        return address(opcode_.operand == "I" ? 1 : 2, Size::Bit, item_.b1() & 127U, item_.bytes[0] & 7U);
      case Form::Sized: return address(high, opcode_.size, item_.word(), 0);
      case Form::Holder: return address(high, Size::DWord, item_.word(), 0);
      case Form::Number8: return letteredNumber(opcode_, item_.b1());
      case Form::Number7: return letteredNumber(opcode_, item_.b1() & 127U);
      case Form::Number16: return letteredNumber(opcode_, item_.word());
      case Form::Count4: return letteredNumber(opcode_, item_.b1() >> 4);
      case Form::Count6: return letteredNumber(opcode_, item_.b1() & 63U);
      case Form::BitByMemory: return byMemory(areaLetters(low, Size::Bit, isLoad_), Size::DWord);
      case Form::SizedByMemory: return byMemory(areaLetters(low, opcode_.size, isLoad_), Size::DWord);
      case Form::NumberByMemory: return byMemory(opcode_.operand, Size::Word);
      case Form::BitByRegister:
      case Form::SizedByRegister: return byRegister(high);
      case Form::AnyByRegister: return anyByRegister();
      case Form::Parameter: return parameter();
      case Form::Jump:
        return names_.label ? names_.label(static_cast<std::uint32_t>(item_.target()))
                            : fmt::format("M{:03}", item_.target());
      default: return valueText(item_);
    }
  }

 private:
  std::string address(unsigned area, Size size, std::uint32_t byte, unsigned bit) const {
    if (area == 6 && names_.local) {
      if (const auto name = names_.local(step7::Place::L, size, byte, bit)) return *name;
    }
    return size == Size::Bit ? fmt::format("{} {}.{}", areaLetters(area, size, isLoad_), byte, bit)
                             : fmt::format("{} {}", areaLetters(area, size, isLoad_), byte);
  }

  std::string byMemory(std::string_view letters, Size holder) const {
    return fmt::format("{} [{}]", letters, address(item_.b1() >> 4 & 7U, holder, item_.word(), 0));
  }

  unsigned addressRegister() const { return 1 + (item_.b1() >> 3 & 1U); }

  std::string registerText() const {
    return fmt::format("[AR{},P#{}.{}]", addressRegister(), item_.word() >> 3, item_.word() & 7U);
  }

  std::string byRegister(unsigned area) const {
    const Size size = opcode_.size;
    const bool isWholeByte = size == Size::Bit || (item_.word() & 7U) == 0;
    if (area == 5 && addressRegister() == 2 && names_.local && isWholeByte) {
      if (const auto name = names_.local(step7::Place::DI, size, item_.word() >> 3, item_.word() & 7U)) return *name;
    }
    return fmt::format("{} {}", areaLetters(area, size, isLoad_), registerText());
  }

  std::string anyByRegister() const {
    constexpr std::string_view sizes[] = {"", "B ", "W ", "D "};
    return fmt::format("{}{}", sizes[static_cast<std::size_t>(opcode_.size)], registerText());
  }

  std::string parameter() const {
    const unsigned number = item_.word() / 2U;
    const std::string name = names_.parameter ? names_.parameter(number) : fmt::format("P{}", number);
    if (opcode_.operand == "P#") return "P##" + name;
    return opcode_.operand == "DI" ? fmt::format("DI [#{}]", name) : "#" + name;
  }

  const CodeItem& item_;
  const Opcode& opcode_;
  const CodeNames& names_;
  bool isLoad_;
};

}  // namespace

std::string listEntryText(std::uint32_t entry) { return pointerWordText(entry); }

std::string operandText(const CodeItem& item, const CodeNames& names) { return OperandPrinter(item, names).text(); }

std::string textOf(const CodeItem& item, const CodeNames& names) {
  const std::string operand = operandText(item, names);
  std::string text =
      operand.empty() ? std::string(item.opcode->mnemonic) : fmt::format("{:<5} {}", item.opcode->mnemonic, operand);
  if (!item.hasList || item.list.empty()) return text;
  text += " {";
  for (std::size_t i = 0; i < item.list.size(); ++i) text += (i > 0 ? ", " : "") + listEntryText(item.list[i]);
  return text + "}";
}

}  // namespace rungproof::mc7
