// Encoding.
#include "frontend/mc7/encoder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <unordered_map>

#include "frontend/mc7/code.hpp"

namespace rungproof::mc7 {

namespace {

using s7300::Constant;
using s7300::ConstantKind;
using step7::Operand;
using step7::OperandForm;
using step7::Place;
using step7::Statement;

std::optional<unsigned> areaOf(Place place) {
  switch (place) {
    case Place::PI:
    case Place::PQ: return 0;
    case Place::I: return 1;
    case Place::Q: return 2;
    case Place::M: return 3;
    case Place::DB: return 4;
    case Place::DI: return 5;
    case Place::L: return 6;
    default: return std::nullopt;
  }
}

/// Letters of what has a number: "MB", "T", "DB"; empty of a plain number.
std::string_view numberLetters(const Operand& operand) {
  if (operand.form == OperandForm::Block || (operand.form == OperandForm::Indirect && operand.block))
    return operand.block->kind ? step7::blockKindName(*operand.block->kind) : "?";
  if (operand.form == OperandForm::Constant) return "";
  if (operand.place == Place::T) return "T";
  if (operand.place == Place::C) return "C";
  return areaLetters(areaOf(operand.place).value_or(7), operand.size, operand.place != Place::PQ);
}

/// The bits of a constant whose kind the form takes.
std::optional<std::uint32_t> bitsFor(Form form, const Constant& c) {
  const auto bits = static_cast<std::uint32_t>(c.value);
  const auto when = [bits](bool fits) { return fits ? std::optional(bits) : std::nullopt; };
  const auto characters = [&c] {
    std::uint32_t value = 0;
    for (const char letter : c.text) value = value << 8 | static_cast<std::uint8_t>(letter);
    return value;
  };
  switch (form) {
    case Form::HexByte: return when(c.kind == ConstantKind::Byte);
    case Form::HexWord: return when(c.kind == ConstantKind::Word || (c.kind == ConstantKind::Hex && c.value <= 0xFFFF));
    case Form::HexDWord:
      return when(c.kind == ConstantKind::DWord || (c.kind == ConstantKind::Hex && c.value > 0xFFFF));
    case Form::BinaryWord: return when(c.kind == ConstantKind::Binary && c.value <= 0xFFFF);
    case Form::BinaryDWord: return when(c.kind == ConstantKind::Binary && c.value > 0xFFFF);
    case Form::Integer: return when(c.kind == ConstantKind::Integer && c.value >= -32768 && c.value <= 32767);
    case Form::Long:
      return when(c.kind == ConstantKind::Long ||
                  (c.kind == ConstantKind::Integer && (c.value < -32768 || c.value > 32767)));
    case Form::Real: return when(c.kind == ConstantKind::Real);
    case Form::TwoBytes: return when(c.kind == ConstantKind::TwoBytes);
    case Form::FourBytes: return when(c.kind == ConstantKind::FourBytes);
    case Form::TwoCharacters:
      return c.kind == ConstantKind::Text && c.text.size() <= 2 ? std::optional(characters()) : std::nullopt;
    case Form::FourCharacters:
      return c.kind == ConstantKind::Text && c.text.size() > 2 && c.text.size() <= 4 ? std::optional(characters())
                                                                                     : std::nullopt;
    case Form::CountValue: return when(c.kind == ConstantKind::Count);
    case Form::Date: return when(c.kind == ConstantKind::Date);
    case Form::S5Time: return when(c.kind == ConstantKind::S5Time);
    case Form::Time: return when(c.kind == ConstantKind::Time);
    case Form::TimeOfDay: return when(c.kind == ConstantKind::TimeOfDay);
    case Form::Pointer: return when(c.kind == ConstantKind::Pointer && c.block == 0);
    case Form::Offset: return when(c.kind == ConstantKind::Pointer && c.block == 0 && c.value <= 0xFFFF);
    default: return std::nullopt;
  }
}

constexpr std::uint16_t shortPointerOfParameter = 0xFBCA;  ///< which no compiler was seen to write

/// Whether one text stands for several rows.
bool isOneOfSeveral(const Opcode& row) { return row.form >= Form::Offset || row.value == shortPointerOfParameter; }

/// The same for the row that is known to be meant: whatever the text calls the bits.
std::optional<std::uint32_t> bitsOfAny(const Constant& c) {
  if (c.kind != ConstantKind::Text) return static_cast<std::uint32_t>(c.value);
  return bitsFor(c.text.size() <= 2 ? Form::TwoCharacters : Form::FourCharacters, c);
}

void appendNumber(std::string& bytes, std::uint32_t value, std::size_t count) {
  while (count-- > 0) bytes += static_cast<char>(value >> (8 * count));
}

/// Codes a statement by one row, or says that the row does not hold it.
class RowEncoder {
 public:
  RowEncoder(const Opcode& row, const Operand& operand, const std::optional<LocalMeaning>& parameter)
      : row_(row), operand_(operand), parameter_(parameter) {}

  std::optional<std::string> bytes(bool isPreferred) {
    std::uint16_t word = row_.value;
    std::uint32_t rest = 0;
    if (!fill(word, rest, isPreferred)) return std::nullopt;
    std::string bytes;
    appendNumber(bytes, word, 2);
    appendNumber(bytes, rest, row_.bytes - 2U);
    return bytes;
  }

 private:
  bool fill(std::uint16_t& word, std::uint32_t& rest, bool isPreferred) {
    switch (row_.form) {
      case Form::None: return hasImpliedOperand();
      case Form::Jump: return operand_.form == OperandForm::Word;
      case Form::Parameter: return parameterNumber(rest);
      case Form::MarkerBit:
      case Form::ImageBit: return shortBit(word);
      case Form::Bit: return longBit(word, rest);
      case Form::Sized:
      case Form::Holder: return sized(word, rest);
      case Form::Number8: return number(255, 0, word);
      case Form::Number7: return number(127, 0, word);
      case Form::Count4: return number(15, 4, word);
      case Form::Count6: return number(63, 0, word);
      case Form::Number16: return isNumber() && (rest = numberValue(), numberValue() <= 0xFFFF);
      case Form::BitByMemory:
      case Form::SizedByMemory:
      case Form::NumberByMemory: return byMemory(word, rest);
      case Form::BitByRegister:
      case Form::SizedByRegister:
      case Form::AnyByRegister: return byRegister(word, rest);
      default: return constant(word, rest, isPreferred);
    }
  }

  bool hasImpliedOperand() const {
    if (row_.operand.empty()) return operand_.form == OperandForm::None;
    if (operand_.form == OperandForm::Word) return operand_.name == row_.operand;
    return operand_.form == OperandForm::Constant && operand_.constant.kind == ConstantKind::Integer &&
           std::to_string(operand_.constant.value) == row_.operand;  // NOP 0
  }

  bool parameterNumber(std::uint32_t& rest) const {
    if (!parameter_) return false;
    rest = parameter_->parameter * 2;
    if (row_.operand == "DI")
      return operand_.form == OperandForm::Indirect && operand_.block && operand_.block->kind == step7::BlockKind::Di;
    if (operand_.form == OperandForm::Indirect) return false;
    if (operand_.form == OperandForm::Parameter) return row_.operand == "P#";
    if (!row_.operand.empty() || !parameter_->kind.empty()) return row_.operand == parameter_->kind;
    return row_.size == parameter_->size;
  }

  bool isAddress(Size size) const {
    return operand_.form == OperandForm::Address && !operand_.block && operand_.size == size &&
           areaOf(operand_.place).has_value();
  }

  bool shortBit(std::uint16_t& word) const {
    const bool isMarker = row_.form == Form::MarkerBit;
    const Place place = isMarker ? Place::M : row_.operand == "I" ? Place::I : Place::Q;
    if (!isAddress(Size::Bit) || operand_.place != place || operand_.number > (isMarker ? 255U : 127U)) return false;
    word = static_cast<std::uint16_t>(word | operand_.bit << 8 | operand_.number);
    return true;
  }

  bool longBit(std::uint16_t& word, std::uint32_t& rest) const {
    if (!isAddress(Size::Bit) || *areaOf(operand_.place) == 0) return false;
    word = static_cast<std::uint16_t>(word | *areaOf(operand_.place) << 4 | operand_.bit);
    rest = operand_.number;
    return true;
  }

  bool sized(std::uint16_t& word, std::uint32_t& rest) const {
    if (!isAddress(row_.size)) return false;
    const unsigned area = *areaOf(operand_.place);
    if (row_.form == Form::Holder && area < 3) return false;
    word = static_cast<std::uint16_t>(word | area << 4);
    rest = operand_.number;
    return true;
  }

  bool isNumber() const {
    const bool isPlain = operand_.form == OperandForm::Constant && operand_.constant.kind == ConstantKind::Integer;
    const bool isAddressed = operand_.form == OperandForm::Address && !operand_.block;
    return (isPlain || isAddressed || operand_.form == OperandForm::Block) && numberLetters(operand_) == row_.operand;
  }
  std::uint32_t numberValue() const {
    if (operand_.form == OperandForm::Constant) return static_cast<std::uint32_t>(operand_.constant.value);
    return operand_.form == OperandForm::Block ? operand_.block->number : operand_.number;
  }
  bool number(std::uint32_t largest, unsigned shift, std::uint16_t& word) const {
    if (!isNumber() || numberValue() > largest) return false;
    word = static_cast<std::uint16_t>(word | numberValue() << shift);
    return true;
  }

  bool byMemory(std::uint16_t& word, std::uint32_t& rest) const {
    if (operand_.form != OperandForm::Indirect || operand_.pointer == nullptr) return false;
    const Operand& holder = *operand_.pointer;
    const Size size = row_.form == Form::NumberByMemory ? Size::Word : Size::DWord;
    if (holder.form != OperandForm::Address || holder.block || holder.size != size) return false;
    const std::optional<unsigned> area = areaOf(holder.place);
    if (!area || *area < 3) return false;
    word = static_cast<std::uint16_t>(word | *area << 4);
    rest = holder.number;
    if (row_.form == Form::NumberByMemory) return numberLetters(operand_) == row_.operand;
    const std::optional<unsigned> meant = areaOf(operand_.place);
    if (operand_.block || !meant || operand_.size != row_.size || (*meant == 0 && row_.size == Size::Bit)) return false;
    word = static_cast<std::uint16_t>(word | *meant);
    return true;
  }

  bool byRegister(std::uint16_t& word, std::uint32_t& rest) const {
    if (operand_.form != OperandForm::Indirect || operand_.addressRegister == 0 || operand_.offset > 0xFFFF ||
        operand_.size != row_.size || operand_.crossesAreas != (row_.form == Form::AnyByRegister))
      return false;
    word = static_cast<std::uint16_t>(word | (operand_.addressRegister - 1) << 3);
    rest = operand_.offset;
    if (operand_.crossesAreas) return true;
    const std::optional<unsigned> area = areaOf(operand_.place);
    if (!area || (*area == 0 && row_.size == Size::Bit)) return false;
    word = static_cast<std::uint16_t>(word | *area << 4);
    return true;
  }

  bool constant(std::uint16_t& word, std::uint32_t& rest, bool isPreferred) const {
    constexpr std::uint16_t wordOfCalls = 0x3000;
    if (operand_.form != OperandForm::Constant || (row_.value == wordOfCalls && !isPreferred)) return false;
    const std::optional<std::uint32_t> bits =
        isPreferred ? bitsOfAny(operand_.constant) : bitsFor(row_.form, operand_.constant);
    if (!bits) return false;
    if (row_.form == Form::HexByte)
      word = static_cast<std::uint16_t>(word | (*bits & 0xFFU));
    else
      rest = *bits;
    return true;
  }

  const Opcode& row_;
  const Operand& operand_;
  const std::optional<LocalMeaning>& parameter_;
};

const std::vector<const Opcode*>& rowsOfMnemonic(const std::string& mnemonic) {
  static const auto table = [] {
    std::unordered_map<std::string, std::vector<const Opcode*>> rows;
    for (const Opcode& row : opcodes()) rows[std::string(row.mnemonic)].push_back(&row);
    for (auto& [name, list] : rows) std::ranges::stable_sort(list, {}, &Opcode::bytes);
    return rows;
  }();
  static const std::vector<const Opcode*> none;
  const auto found = table.find(mnemonic);
  return found == table.end() ? none : found->second;
}

}  // namespace

EncodedStatement encode(const Statement& statement, const EncodeNames& names, const Opcode* preferred) {
  EncodedStatement result;
  if (!statement.fault.empty()) {
    result.fault = statement.fault;
    return result;
  }
  Operand operand = statement.operand;
  std::optional<LocalMeaning> parameter;
  const auto isLocal = [](const Operand& one) {
    return one.form == OperandForm::Local || one.form == OperandForm::Parameter;
  };
  const auto meaningOf = [&](const Operand& one) { return names.local ? names.local(one) : std::nullopt; };
  if (isLocal(operand)) {
    const std::optional<LocalMeaning> meaning = meaningOf(operand);
    if (!meaning) {
      result.fault = "the name is not declared";
      return result;
    }
    if (meaning->parameter != 0)
      parameter = meaning;
    else
      operand = meaning->place;
  } else if (operand.form == OperandForm::Indirect && operand.pointer != nullptr && isLocal(*operand.pointer)) {
    const std::optional<LocalMeaning> meaning = meaningOf(*operand.pointer);
    if (meaning && meaning->parameter != 0)
      parameter = meaning;
    else if (meaning)
      operand.pointer = std::make_shared<Operand>(meaning->place);
  }
  const Opcode* meant = nullptr;
  const bool isChosen = preferred != nullptr && isOneOfSeveral(*preferred);
  for (const Opcode* row : rowsOfMnemonic(statement.mnemonic.text)) {
    if (isChosen ? row != preferred : row->value == shortPointerOfParameter) continue;
    std::optional<std::string> bytes = RowEncoder(*row, operand, parameter).bytes(isChosen);
    if (!bytes) continue;
    result.bytes = std::move(*bytes);
    meant = row;
    break;
  }
  if (meant == nullptr) {
    result.fault = fmt::format("{} has no code with this operand", statement.mnemonic.text);
    return result;
  }
  if (meant->form == Form::Jump) result.label = operand.name;
  if (!hasParameterList(*meant)) return result;
  appendNumber(result.bytes, 0x700B, 2);
  appendNumber(result.bytes, static_cast<std::uint32_t>(2 + 2 * statement.pointers.size()), 2);
  for (const Operand& pointer : statement.pointers)
    appendNumber(result.bytes, static_cast<std::uint32_t>(pointer.constant.value), 4);
  return result;
}

AssembledCode assemble(std::span<const Statement> statements, const EncodeNames& names,
                       std::span<const Opcode* const> preferred) {
  AssembledCode code;
  std::map<std::string, std::uint32_t> labels;
  struct Jump {
    std::uint32_t at;
    std::string label;
    bool isList;
  };
  std::vector<Jump> jumps;
  for (std::size_t i = 0; i < statements.size(); ++i) {
    const auto at = static_cast<std::uint32_t>(code.bytes.size());
    code.starts.push_back(at);
    if (!statements[i].label.text.empty()) labels[statements[i].label.text] = at;
    if (statements[i].mnemonic.text.empty()) continue;
    EncodedStatement encoded = encode(statements[i], names, i < preferred.size() ? preferred[i] : nullptr);
    if (!encoded.fault.empty()) {
      code.fault = fmt::format("statement {}: {}", i + 1, encoded.fault);
      return code;
    }
    if (!encoded.label.empty()) jumps.push_back({at, std::move(encoded.label), statements[i].mnemonic.text == "JL"});
    code.bytes += encoded.bytes;
  }
  for (const Jump& jump : jumps) {
    const auto target = labels.find(jump.label);
    if (target == labels.end()) {
      code.fault = fmt::format("no statement has the label {}", jump.label);
      return code;
    }
    const std::int64_t bytes = std::int64_t{target->second} - jump.at;
    const std::int64_t distance = jump.isList ? (bytes - 4) / 4 : bytes / 2;
    if (distance < -32768 || distance > 32767) {
      code.fault = fmt::format("{} is too far away", jump.label);
      return code;
    }
    code.bytes[jump.at + 2] = static_cast<char>(distance >> 8);
    code.bytes[jump.at + 3] = static_cast<char>(distance);
  }
  return code;
}

}  // namespace rungproof::mc7
