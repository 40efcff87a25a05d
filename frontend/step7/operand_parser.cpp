// Operands: what stands next decides.
#include "frontend/step7/operand_parser.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "frontend/stl/stl_lexer.hpp"

namespace rungproof::step7 {

namespace {

struct PlaceRow {
  std::string_view international;
  std::string_view german;
  Place place;
  Size size;
};
constexpr std::array<PlaceRow, 36> placeRows = {{
    {"I", "E", Place::I, Size::Bit},        {"IB", "EB", Place::I, Size::Byte},
    {"IW", "EW", Place::I, Size::Word},     {"ID", "ED", Place::I, Size::DWord},
    {"Q", "A", Place::Q, Size::Bit},        {"QB", "AB", Place::Q, Size::Byte},
    {"QW", "AW", Place::Q, Size::Word},     {"QD", "AD", Place::Q, Size::DWord},
    {"M", "M", Place::M, Size::Bit},        {"MB", "MB", Place::M, Size::Byte},
    {"MW", "MW", Place::M, Size::Word},     {"MD", "MD", Place::M, Size::DWord},
    {"L", "L", Place::L, Size::Bit},        {"LB", "LB", Place::L, Size::Byte},
    {"LW", "LW", Place::L, Size::Word},     {"LD", "LD", Place::L, Size::DWord},
    {"PIB", "PEB", Place::PI, Size::Byte},  {"PIW", "PEW", Place::PI, Size::Word},
    {"PID", "PED", Place::PI, Size::DWord}, {"PQB", "PAB", Place::PQ, Size::Byte},
    {"PQW", "PAW", Place::PQ, Size::Word},  {"PQD", "PAD", Place::PQ, Size::DWord},
    {"DBX", "DBX", Place::DB, Size::Bit},   {"DBB", "DBB", Place::DB, Size::Byte},
    {"DBW", "DBW", Place::DB, Size::Word},  {"DBD", "DBD", Place::DB, Size::DWord},
    {"DIX", "DIX", Place::DI, Size::Bit},   {"DIB", "DIB", Place::DI, Size::Byte},
    {"DIW", "DIW", Place::DI, Size::Word},  {"DID", "DID", Place::DI, Size::DWord},
    {"T", "T", Place::T, Size::Bit},        {"C", "Z", Place::C, Size::Bit},
    {"IX", "EX", Place::I, Size::Bit},      {"QX", "AX", Place::Q, Size::Bit},
    {"MX", "MX", Place::M, Size::Bit},      {"LX", "LX", Place::L, Size::Bit},
}};

constexpr std::array<std::pair<std::string_view, BlockKind>, 10> blockKinds = {{
    {"OB", BlockKind::Ob},
    {"FC", BlockKind::Fc},
    {"FB", BlockKind::Fb},
    {"DB", BlockKind::Db},
    {"DI", BlockKind::Di},
    {"SFC", BlockKind::Sfc},
    {"SFB", BlockKind::Sfb},
    {"UDT", BlockKind::Udt},
    {"SDB", BlockKind::Sdb},
    {"VAT", BlockKind::Vat},
}};

const PlaceRow* placeOfOperand(std::string_view letters, MnemonicSet set) {
  const auto row = std::ranges::find_if(placeRows, [&](const PlaceRow& r) {
    return equalsWord(letters, set == MnemonicSet::German ? r.german : r.international);
  });
  return row == placeRows.end() ? nullptr : &*row;
}

std::optional<BlockKind> blockKindOf(std::string_view letters) {
  const auto row = std::ranges::find_if(blockKinds, [&](const auto& r) { return equalsWord(letters, r.first); });
  return row == blockKinds.end() ? std::nullopt : std::optional(row->second);
}

/// Letters at the cursor, nothing taken.
std::string_view lettersAt(const Cursor& cursor) {
  std::size_t count = 0;
  while (isLetter(cursor.peek(count))) ++count;
  return cursor.slice(cursor.at(), static_cast<std::uint32_t>(cursor.at() + count));
}

/// A decimal number at the cursor, at most nine digits.
std::optional<std::uint32_t> numberAt(Cursor& cursor) {
  std::uint32_t value = 0;
  int count = 0;
  while (isDecimal(cursor.peek()) && count < 9) {
    value = value * 10 + static_cast<std::uint32_t>(cursor.peek() - '0');
    cursor.skip(1);
    ++count;
  }
  return count == 0 || isDecimal(cursor.peek()) ? std::nullopt : std::optional(value);
}

class OperandParser {
 public:
  OperandParser(Cursor& cursor, const Spelling7& spelling) : cursor_(cursor), spelling_(spelling) {}

  OperandOutcome read(bool wantsLabel) {
    const std::uint32_t begin = cursor_.at();
    std::string fault = wantsLabel && !label() ? "a label is missing" : operand(wantsLabel);
    if (fault.empty() && !wantsLabel) namedAddress();
    operand_.span = cursor_.spanFrom(begin);
    return {std::move(operand_), std::move(fault)};
  }

 private:
  bool label() {
    const std::string_view word = cursor_.word();
    operand_.form = OperandForm::Word;
    operand_.name = word;
    return !word.empty();
  }

  std::string operand(bool isDone) {
    if (isDone) return {};
    const char c = cursor_.peek();
    if (c == '"') {
      std::string fault = symbol();
      return fault.empty() ? peripheral() : fault;
    }
    if (c == '#') return local();
    if (c == '[') {
      operand_.form = OperandForm::Indirect;
      return indirect(true);
    }
    if (c == '%') {
      cursor_.skip(1);
      std::string fault = wordOrAddress();
      if (fault.empty() && operand_.form == OperandForm::Address) return peripheral();
      if (!fault.empty() || operand_.form == OperandForm::Block) return fault;
      return "% stands before addresses only";
    }
    if (c == '=' || c == '<' || c == '>') return relation();
    if (cursor_.startsWithLetters("P##")) {
      cursor_.skip(2);
      std::string fault = local();
      operand_.form = OperandForm::Parameter;
      return fault;
    }
    ConstantOutcome outcome = readConstant(cursor_, spelling_.set, spelling_.encoding);
    if (!outcome.fault.empty()) return outcome.fault;
    if (outcome.constant) {
      operand_.form = OperandForm::Constant;
      operand_.constant = std::move(*outcome.constant);
      return {};
    }
    return wordOrAddress();
  }

  /// "Motor":Q4.0: a symbol and its address together. The address counts; the name is kept beside it.
  void namedAddress() {
    const bool isName = operand_.form == OperandForm::Word ||
                        (operand_.form == OperandForm::Symbol && operand_.path.empty() && !operand_.isPeripheral);
    if (!isName || cursor_.peek() != ':') return;
    const std::uint32_t back = cursor_.at();
    cursor_.skip(1);
    OperandOutcome outcome = OperandParser(cursor_, spelling_).read(false);
    if (!outcome.fault.empty() || outcome.operand.form != OperandForm::Address || outcome.operand.block)
      return cursor_.to(back);
    outcome.operand.name = std::move(operand_.name);
    operand_ = std::move(outcome.operand);
  }

  /// %IW64:P, "Level":P of TIA: the module and not its image.
  std::string peripheral() {
    if (cursor_.peek() != ':' || upper(cursor_.peek(1)) != 'P' || isWordByte(cursor_.peek(2))) return {};
    cursor_.skip(2);
    if (operand_.form == OperandForm::Symbol && operand_.path.empty()) {
      operand_.isPeripheral = true;
      return {};
    }
    const bool isImage = operand_.place == Place::I || operand_.place == Place::Q;
    if (operand_.form != OperandForm::Address || operand_.block || !isImage || operand_.size == Size::Bit)
      return std::string(peripheralRule);
    operand_.place = operand_.place == Place::I ? Place::PI : Place::PQ;
    return {};
  }

  /// ==0, <>0, ...: what the condition code bits say.
  std::string relation() {
    const std::uint32_t begin = cursor_.at();
    while (cursor_.peek() == '=' || cursor_.peek() == '<' || cursor_.peek() == '>') cursor_.skip(1);
    const std::string_view sign = cursor_.slice(begin, cursor_.at());
    static constexpr std::array<std::string_view, 6> signs = {"==", "<>", ">", "<", ">=", "<="};
    if (std::ranges::find(signs, sign) == signs.end() || !cursor_.take('0')) return "a status bit such as ==0 is meant";
    operand_.form = OperandForm::Word;
    operand_.name = std::string(sign) + "0";
    return {};
  }

  std::string symbol() {
    const std::uint32_t begin = cursor_.at(), end = cursor_.quotedEnd();
    if (end == 0) {
      cursor_.to(cursor_.lineEnd());
      return "the name has no second quotation mark";
    }
    operand_.form = OperandForm::Symbol;
    operand_.name = trimmed(cursor_.slice(begin + 1, end - 1));
    cursor_.to(end);
    if (operand_.name.empty()) return "the name is empty";
    if (cursor_.peek() != '.') return {};
    if (const std::uint32_t back = cursor_.at(); fullAddress()) {
      operand_.block = BlockName{std::nullopt, 0, operand_.name, cursor_.span(begin, end)};
      operand_.name.clear();
      return finishAddress();
    } else {
      cursor_.to(back);
    }
    return readParts(cursor_, operand_.path);
  }

  /// .DBX, .DBW behind a block, and a digit after it: the cursor stands at the digit.
  bool fullAddress() {
    cursor_.skip(1);
    if (cursor_.peek() == '%') cursor_.skip(1);
    const std::string_view letters = lettersAt(cursor_);
    const PlaceRow* row = placeOfOperand(letters, spelling_.set);
    if (row == nullptr || row->place != Place::DB) return false;
    cursor_.skip(letters.size());
    cursor_.skipBlanks();
    if (!isDecimal(cursor_.peek())) return false;
    operand_.place = row->place;
    operand_.size = row->size;
    return true;
  }

  std::string local() {
    cursor_.skip(1);  // #
    const std::optional<Name> name = readName(cursor_);
    operand_.form = OperandForm::Local;
    if (!name) return "a name is missing behind #";
    operand_.path.push_back({name->text, {}, name->span});
    std::string fault = readIndices(cursor_, operand_.path);
    return fault.empty() ? readParts(cursor_, operand_.path) : fault;
  }

  /// Number and bit behind the letters of an area.
  std::string finishAddress() {
    operand_.form = OperandForm::Address;
    const std::optional<std::uint32_t> number = numberAt(cursor_);
    if (!number || *number > 65535) return "the address is too large";
    operand_.number = *number;
    const bool hasBit = operand_.size == Size::Bit && operand_.place != Place::T && operand_.place != Place::C;
    if (cursor_.peek() != '.') return hasBit ? "the bit number is missing, as in M 10.0" : "";
    if (!hasBit) return "only bits have a bit number";
    cursor_.skip(1);
    const std::optional<std::uint32_t> bit = numberAt(cursor_);
    if (!bit) return "the bit number is missing, as in M 10.0";
    operand_.bit = static_cast<std::uint8_t>(std::min(*bit, 255U));
    return *bit > 7 ? "a byte has the bits 0 to 7" : "";
  }

  std::string wordOrAddress() {
    const std::uint32_t begin = cursor_.at();
    const std::string_view letters = lettersAt(cursor_);
    const char behind = cursor_.peek(letters.size());
    if (!letters.empty() && (!isWordByte(behind) || isDecimal(behind))) {
      const PlaceRow* row = placeOfOperand(letters, spelling_.set);
      const std::optional<BlockKind> kind = blockKindOf(letters);
      const bool isSize = letters.size() == 1 && std::string_view("BWD").find(upper(letters[0])) != std::string::npos;
      cursor_.skip(letters.size());
      cursor_.skipBlanks();
      if (isDecimal(cursor_.peek()) && (row != nullptr || kind)) {
        if (endsAsAddress()) return row != nullptr ? address(*row) : block(*kind, begin);
      } else if (cursor_.peek() == '[' && (row != nullptr || kind || isSize)) {
        return indirectOf(row, kind, letters);
      }
      cursor_.to(begin);
    }
    const std::string_view word = cursor_.word();
    if (word.empty()) return cursor_.atLineEnd() || cursor_.peek() == ';' ? "" : "no operand begins like this";
    operand_.form = OperandForm::Word;
    operand_.name = word;
    if (cursor_.peek() != '.' && cursor_.peek() != '[') return {};
    // A local name without its sign.
    operand_.form = OperandForm::Local;
    operand_.path.push_back({std::string(word), {}, cursor_.spanFrom(begin)});
    std::string fault = readIndices(cursor_, operand_.path);
    return fault.empty() ? readParts(cursor_, operand_.path) : fault;
  }

  /// Whether the digits here are followed by no letter: T5 is an address, T5_old a name.
  bool endsAsAddress() const {
    std::size_t ahead = 0;
    while (isDecimal(cursor_.peek(ahead))) ++ahead;
    return !isWordByte(cursor_.peek(ahead)) || blankLength(cursor_.text(), cursor_.at() + ahead) > 0;
  }

  std::string address(const PlaceRow& row) {
    operand_.place = row.place;
    operand_.size = row.size;
    return finishAddress();
  }

  std::string block(BlockKind kind, std::uint32_t begin) {
    const std::optional<std::uint32_t> number = numberAt(cursor_);
    if (!number || *number > 65535) return "the number of the block is too large";
    operand_.block = BlockName{kind, *number, {}, cursor_.spanFrom(begin)};
    if (kind == BlockKind::Db && cursor_.peek() == '.') {
      const std::uint32_t point = cursor_.at();
      if (fullAddress()) return finishAddress();
      cursor_.to(point);
      cursor_.skip(1);
      const PlaceRow* row = placeOfOperand(lettersAt(cursor_), spelling_.set);
      const bool isName = cursor_.peek() == '"' || (isWordByte(cursor_.peek()) && !isDecimal(cursor_.peek()));
      if ((row != nullptr && row->place == Place::DB) || !isName)
        return "DBX, DBB, DBW or DBD and a number follow the point, as in DB10.DBW 2, or the name of a part";
      cursor_.to(point);
      operand_.form = OperandForm::Symbol;
      operand_.name = "DB" + std::to_string(*number);
      return readParts(cursor_, operand_.path);
    }
    operand_.form = OperandForm::Block;
    return {};
  }

  std::string indirectOf(const PlaceRow* row, std::optional<BlockKind> kind, std::string_view letters) {
    operand_.form = OperandForm::Indirect;
    if (row != nullptr) {
      operand_.place = row->place;
      operand_.size = row->size;
      return indirect(false);
    }
    if (kind) {
      operand_.block = BlockName{*kind, 0, {}, {}};
      return indirect(false);
    }
    const char size = upper(letters[0]);
    operand_.size = size == 'B' ? Size::Byte : size == 'W' ? Size::Word : Size::DWord;
    return indirect(true);
  }

  /// [MD 4], [#pointer], [AR1,P#2.0].
  std::string indirect(bool crossesAreas) {
    cursor_.skip(1);
    cursor_.skipBlanks();
    const std::string_view word = cursor_.peekWord();
    std::string fault;
    if (equalsWord(word, "AR1") || equalsWord(word, "AR2")) {
      operand_.addressRegister = word.back() == '1' ? 1 : 2;
      operand_.crossesAreas = crossesAreas;
      cursor_.skip(3);
      fault = registerOffset();
    } else if (crossesAreas) {
      return "an address register stands in the brackets, as in [AR1,P#0.0]";
    } else {
      OperandOutcome inner = OperandParser(cursor_, spelling_).read(false);
      fault = std::move(inner.fault);
      const OperandForm form = inner.operand.form;
      if (fault.empty() && form != OperandForm::Address && form != OperandForm::Local && form != OperandForm::Symbol)
        fault = "a place that holds the address stands in the brackets, as in [MD 4]";
      operand_.pointer = std::make_shared<Operand>(std::move(inner.operand));
    }
    if (!fault.empty()) return fault;
    cursor_.skipBlanks();
    return cursor_.take(']') ? "" : "the closing bracket is missing";
  }

  std::string registerOffset() {
    cursor_.skipBlanks();
    if (!cursor_.take(',')) return "an offset such as P#0.0 is missing";
    cursor_.skipBlanks();
    const ConstantOutcome offset = readConstant(cursor_, spelling_.set, spelling_.encoding);
    if (!offset.fault.empty()) return offset.fault;
    if (!offset.constant || offset.constant->kind != s7300::ConstantKind::Pointer || offset.constant->value > 0x7FFFF ||
        offset.constant->block != 0)
      return "an offset such as P#0.0 is missing";
    operand_.offset = static_cast<std::uint32_t>(offset.constant->value);
    return {};
  }

  Cursor& cursor_;
  const Spelling7& spelling_;
  Operand operand_;
};

}  // namespace

std::string_view blockKindName(BlockKind kind) {
  return std::ranges::find(blockKinds, kind, &std::pair<std::string_view, BlockKind>::second)->first;
}

std::string toString(const BlockName& name) {
  return name.kind ? fmt::format("{} {}", blockKindName(*name.kind), name.number) : "\"" + name.symbol + "\"";
}

OperandOutcome readOperand7(Cursor& cursor, const Spelling7& spelling, bool wantsLabel) {
  return OperandParser(cursor, spelling).read(wantsLabel);
}

std::optional<BlockName> readBlockName(Cursor& cursor) {
  const std::uint32_t begin = cursor.at();
  if (cursor.peek() == '%') cursor.skip(1);
  const std::string_view letters = lettersAt(cursor);
  if (const std::optional<BlockKind> kind = blockKindOf(letters)) {
    cursor.skip(letters.size());
    cursor.skipBlanks();
    const std::optional<std::uint32_t> number = numberAt(cursor);
    if (number && !isWordByte(cursor.peek())) return BlockName{kind, *number, {}, cursor.spanFrom(begin)};
  }
  cursor.to(begin);
  return std::nullopt;
}

std::optional<Name> readName(Cursor& cursor) {
  const std::uint32_t begin = cursor.at();
  if (cursor.peek() == '"' || cursor.peek() == '\'') {
    const std::uint32_t end = cursor.quotedEnd();
    if (end <= begin + 2) return std::nullopt;
    cursor.to(end);
    return Name{std::string(trimmed(cursor.slice(begin + 1, end - 1))), cursor.spanFrom(begin)};
  }
  const std::string_view word = cursor.word();
  return word.empty() ? std::nullopt : std::optional(Name{std::string(word), cursor.spanFrom(begin)});
}

std::string readIndices(Cursor& cursor, std::vector<PathStep>& path) {
  const std::uint32_t back = cursor.at();
  cursor.skipBlanks();
  if (cursor.peek() != '[') {
    cursor.to(back);
    return {};
  }
  cursor.skip(1);
  do {
    cursor.skipBlanks();
    const bool isNegative = cursor.take('-');
    const std::optional<std::uint32_t> index = numberAt(cursor);
    if (!index) return "an index is a number";
    path.back().indices.push_back(isNegative ? -std::int64_t{*index} : std::int64_t{*index});
    cursor.skipBlanks();
  } while (cursor.take(','));
  return cursor.take(']') ? "" : "the closing bracket is missing";
}

std::string readParts(Cursor& cursor, std::vector<PathStep>& path) {
  while (cursor.peek() == '.') {
    cursor.skip(1);
    const std::optional<Name> name = readName(cursor);
    if (!name) return "a name is missing behind the point";
    path.push_back({name->text, {}, name->span});
    if (std::string fault = readIndices(cursor, path); !fault.empty()) return fault;
  }
  return {};
}

}  // namespace rungproof::step7
