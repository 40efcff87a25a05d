// Statements from descriptors, declarations from structures.
#include "frontend/step7/source_writer.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "frontend/step7/constant_spelling.hpp"
#include "frontend/step7/cursor.hpp"
#include "ir/block_map.hpp"
#include "ir/dialect.hpp"
#include "ir/s7300/block.hpp"
#include "ir/s7300/declarations.hpp"
#include "ir/s7300/isa.hpp"
#include "ir/s7300/library.hpp"

namespace rungproof::step7 {

using s7300::Field;
using s7300::Section;
using s7300::Structure;
using s7300::TypeKind;

namespace {

std::string quotedIfNeeded(std::string_view name) {
  const bool isWord = !name.empty() && std::ranges::all_of(name, isWordByte) && !isDecimal(name[0]);
  return isWord ? std::string(name) : fmt::format("\"{}\"", name);
}

/// #list[2].x with quotation marks where a part is no word.
std::string localText(std::string_view text) {
  std::string result;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find('.', at), text.size());
    const std::string_view part = text.substr(at, end - at);
    const std::size_t bracket = std::min(part.find('['), part.size());
    result += (at == 0 ? "" : ".") + quotedIfNeeded(part.substr(0, bracket)) + std::string(part.substr(bracket));
    at = end + 1;
  }
  return "#" + result;
}

class OperandWriter {
 public:
  explicit OperandWriter(MnemonicSet set) : isGerman_(set == MnemonicSet::German) {}

  std::string text(const rungproof::Operand& operand, bool isBlock) const {
    if (isBlock && operand.kind == OperandKind::Direct) {
      const bool inDi = operand.reach != nullptr;
      return fmt::format("{} {}", inDi ? "DI" : "DB", blockOfByte(operand.offset));
    }
    if (operand.reach != nullptr) return found(operand, isBlock);
    switch (operand.kind) {
      case OperandKind::Direct:
        return operand.text.starts_with('#') ? localText(operand.text.substr(1)) : place(operand);
      case OperandKind::Address:
        return operand.text.starts_with("P##") ? "P#" + localText(operand.text.substr(3)) : pointer(operand.text);
      case OperandKind::Constant: return constantOf(operand);
      case OperandKind::Text: return pointer(operand.text);
      default: return toString(operand);
    }
  }

 private:
  std::string letters(Area area) const {
    switch (area) {
      case Area::I: return isGerman_ ? "E" : "I";
      case Area::Q: return isGerman_ ? "A" : "Q";
      case Area::PI: return isGerman_ ? "PE" : "PI";
      case Area::PQ: return isGerman_ ? "PA" : "PQ";
      case Area::C: return isGerman_ ? "Z" : "C";
      default: return std::string(areaName(area));
    }
  }
  static std::string_view widthLetter(Width width) {
    static constexpr std::string_view names[] = {"", "B", "W", "D"};
    return names[static_cast<int>(width)];
  }
  static std::string dataLetters(Width width, bool inDi) {
    return fmt::format("D{}{}", inDi ? "I" : "B", width == Width::Bit ? "X" : widthLetter(width));
  }
  static std::string at(std::string letters, std::uint32_t byte, const rungproof::Operand& operand) {
    letters += fmt::format("{}", byte);
    return operand.width == Width::Bit ? fmt::format("{}.{}", letters, operand.bit) : letters;
  }

  std::string place(const rungproof::Operand& operand) const {
    if (operand.area == Area::T || operand.area == Area::C)
      return fmt::format("{}{}", letters(operand.area), operand.offset);
    if (operand.area != Area::DB)
      return at(fmt::format("{}{}", letters(operand.area), widthLetter(operand.width)), operand.offset, operand);
    return fmt::format("DB{}.{}", blockOfByte(operand.offset),
                       at(dataLetters(operand.width, false), byteInBlock(operand.offset), operand));
  }

  /// What Operand::reach describes.
  std::string found(const rungproof::Operand& operand, bool isBlock) const {
    const Reach& reach = *operand.reach;
    if (reach.way == Way::PointerTo) return pointed(operand);
    if (operand.kind == OperandKind::Address) return "P#" + localText(std::string_view(operand.text).substr(3));
    if (operand.text.starts_with('#')) return localText(std::string_view(operand.text).substr(1));
    const std::string offset = fmt::format("P#{}.{}", operand.offset, operand.bit);
    const std::string_view ar = reach.byAr2 ? "AR2" : "AR1";
    const std::string area = operand.area == Area::DB ? dataLetters(operand.width, reach.inDi)
                             : operand.area == Area::T || operand.area == Area::C
                                 ? letters(operand.area)
                                 : fmt::format("{}{}", letters(operand.area), widthLetter(operand.width));
    switch (reach.way) {
      case Way::Pointer: {
        const std::string block =
            operand.value != 0 ? blockName(static_cast<int>(operand.value)).substr(0, 2) : (reach.inDi ? "DI" : "DB");
        return fmt::format("{} [{}]", isBlock ? block : area, text(reach.pointer, false));
      }
      case Way::Register: return fmt::format("{} [{},{}]", area, ar, offset);
      case Way::Crossing: return fmt::format("{} [{},{}]", widthLetter(operand.width), ar, offset);
      default: return at(area, operand.offset, operand);
    }
  }

  /// A pointer constant as it was written, or the place whose pointer it is.
  std::string pointed(const rungproof::Operand& operand) const {
    const rungproof::Operand& place = operand.reach->pointer;
    return operand.text.starts_with("P#") ? pointer(operand.text) : text(place, false);
  }

  std::string constantOf(const rungproof::Operand& operand) const {
    if (isGerman_ && operand.width == Width::Bit && operand.text == "BR") return "BIE";
    if (operand.text.empty()) return toString(operand);
    return pointer(operand.text);
  }

  /// P#I 0.0 is P#E 0.0 in the other set.
  std::string pointer(std::string text) const {
    if (isGerman_ && text.starts_with("P#I ")) return "P#E " + text.substr(4);
    if (isGerman_ && text.starts_with("P#Q ")) return "P#A " + text.substr(4);
    return text;
  }

  bool isGerman_;
};

/// Fields that a call supplies, in the order of its operands; nothing: the block is not known.
std::shared_ptr<const Structure> parametersOf(const Program& program, int block) {
  if (program.declarations != nullptr) {
    const auto own = program.declarations->parameters.find(block);
    if (own != program.declarations->parameters.end()) return own->second;
  }
  const s7300::LibraryBlock* library =
      s7300::libraryBlock(blockTypeOf(block), static_cast<std::uint32_t>(numberOfBlock(block)));
  return library == nullptr ? nullptr : interfaceOf(*library);
}

std::string callText(const Program& program, const Instruction& call, const OperandWriter& operands) {
  const int block = static_cast<int>(call.operands[0].value);
  const BlockType type = blockTypeOf(block);
  const std::shared_ptr<const Structure> parameters = parametersOf(program, block);
  std::string text = fmt::format("{} {}", blockName(block).substr(0, blockName(block).find_first_of("0123456789")),
                                 numberOfBlock(block));
  std::size_t next = 1;
  const bool givesInstance = hasInstance(type) && call.operands.size() > 1;
  if (givesInstance) {
    const rungproof::Operand& instance = call.operands[next++];
    const bool isPart = instance.text.starts_with('#') && instance.kind != OperandKind::Direct;
    text = isPart ? operands.text(instance, false) : fmt::format("{}, {}", text, operands.text(instance, true));
  }
  std::string list;
  for (std::size_t i = 0; parameters != nullptr && i < parameters->fields.size() && next < call.operands.size(); ++i) {
    const Field& field = parameters->fields[i];
    if (field.section > Section::InOut) continue;
    const rungproof::Operand& actual = call.operands[next++];
    if (actual.kind == OperandKind::Missing) continue;
    const bool isBlock = field.type.kind == TypeKind::BlockDb || field.type.kind == TypeKind::BlockFc ||
                         field.type.kind == TypeKind::BlockFb;
    list += fmt::format("{}{} := {}", list.empty() ? "" : ", ", quotedIfNeeded(field.name),
                        isBlock ? operands.text(actual, true) : operands.text(actual, false));
  }
  return list.empty() ? text : fmt::format("{} ({})", text, list);
}

std::string declaredType(const s7300::Type& type, const std::string& indent);

std::string fieldLine(const Field& field, const std::string& indent) {
  std::string line = fmt::format("{}{} : {}", indent, quotedIfNeeded(field.name), declaredType(field.type, indent));
  for (std::size_t i = 0; i < field.initial.size(); ++i)
    line += fmt::format("{}{}", i == 0 ? " := " : ", ", spellingOf(field.initial[i]));
  return line + " ;";
}

std::string declaredType(const s7300::Type& type, const std::string& indent) {
  if (type.kind == TypeKind::Array) {
    std::string bounds;
    for (const s7300::Bounds& each : type.bounds)
      bounds += fmt::format("{}{} .. {}", bounds.empty() ? "" : ", ", each.first, each.last);
    return fmt::format("ARRAY [{}] OF {}", bounds, declaredType(*type.element, indent));
  }
  if (type.kind != TypeKind::Struct || type.structure == nullptr) return s7300::toString(type);
  if (type.name.starts_with("FB ") || type.name.starts_with("SFB ")) return type.name;
  std::string text = "STRUCT\n";
  for (const Field& field : type.structure->fields) text += fieldLine(field, indent + "  ") + "\n";
  return text + indent + "END_STRUCT";
}

class SourceWriter {
 public:
  SourceWriter(const Program& program, MnemonicSet set) : program_(program), set_(set) {}

  std::string run() {
    for (const Pou& pou : program_.pous) {
      if (!isLibraryBlock(program_, pou)) block(pou);
    }
    for (const DataBlock& data : program_.dataBlocks) dataBlock(data);
    return std::move(out_);
  }

 private:
  void line(std::string_view text) { out_.append(text).append("\n"); }

  void block(const Pou& pou) {
    static constexpr std::string_view keywords[] = {"", "ORGANIZATION_BLOCK", "FUNCTION", "FUNCTION_BLOCK"};
    const std::string_view keyword = keywords[static_cast<std::size_t>(pou.type)];
    const auto returned = [&]() -> std::string {
      const auto parameters = program_.declarations->parameters.at(pou.number);
      const Field* value = parameters->field("RET_VAL");
      return value == nullptr || value->section > Section::InOut ? "VOID" : declaredType(value->type, "");
    };
    line(fmt::format("{} {}{}", keyword, blockName(pou.number),
                     pou.type == BlockType::Fc ? fmt::format(" : {}", returned()) : ""));
    line(fmt::format("TITLE = {}", pou.title));
    for (const std::string& each : declarationLines(program_, pou)) line(each);
    if (!pou.protectedBlock) line("BEGIN");
    for (const Network& network : pou.networks) {
      line("NETWORK");
      line(fmt::format("TITLE = {}", network.title));
      for (const Instruction& instruction : network.instructions) {
        const std::string text = writeStatement(program_, instruction, set_);
        line(text.ends_with(':') ? text : "      " + text + " ;");
      }
    }
    line(fmt::format("END_{}\n", keyword));
  }

  void dataBlock(const DataBlock& data) {
    line(fmt::format("DATA_BLOCK DB {}", data.number));
    if (data.readOnly) line("READ_ONLY");
    if (data.unlinked) line("UNLINKED");
    if (data.nonRetain) line("NON_RETAIN");
    if (data.instanceOf != 0) {
      line(fmt::format("{} {}", blockTypeOf(data.instanceOf) == BlockType::Sfb ? "SFB" : "FB",
                       numberOfBlock(data.instanceOf)));
    } else {
      line("STRUCT");
      for (const Field& field : program_.declarations->dataBlocks.at(data.number)->fields) line(fieldLine(field, "  "));
      line("END_STRUCT ;");
    }
    line("BEGIN\nEND_DATA_BLOCK\n");
  }

  const Program& program_;
  MnemonicSet set_;
  std::string out_;
};

}  // namespace

std::string writeStatement(const Program& program, const Instruction& instruction, MnemonicSet set) {
  const Desc& desc = *instruction.desc;
  const OperandWriter operands(set);
  if (desc.control == Control::LabelMark) return instruction.operands[0].text + ":";
  std::string mnemonic(writtenMnemonic(desc, set == MnemonicSet::German));
  if (instruction.operands.empty()) return mnemonic;
  // L T, S C: the operand says the rest.
  mnemonic = mnemonic.substr(0, mnemonic.find(' '));
  const bool isCall = desc.control == Control::BlockCall;
  const bool isKnownBlock = isCall && instruction.operands[0].kind == OperandKind::Constant;
  const std::string operand =
      isKnownBlock ? callText(program, instruction, operands)
                   : operands.text(instruction.operands[0], isCall || desc.operands[0].type == rungproof::Type::Block);
  return fmt::format("{:<6} {}", mnemonic, operand);
}

std::vector<std::string> declarationLines(const Program& program, const Pou& pou) {
  std::vector<std::string> lines;
  if (program.declarations == nullptr) return lines;
  const auto parameters = program.declarations->parameters.find(pou.number);
  const auto temporary = program.declarations->temporary.find(pou.number);
  static constexpr std::pair<Section, std::string_view> sections[] = {{Section::Input, "VAR_INPUT"},
                                                                      {Section::Output, "VAR_OUTPUT"},
                                                                      {Section::InOut, "VAR_IN_OUT"},
                                                                      {Section::Static, "VAR"},
                                                                      {Section::Temp, "VAR_TEMP"}};
  for (const auto& [section, keyword] : sections) {
    const auto& structures =
        section == Section::Temp ? program.declarations->temporary : program.declarations->parameters;
    const auto found = section == Section::Temp ? temporary : parameters;
    if (found == structures.end()) continue;
    bool isOpen = false;
    for (const Field& field : found->second->fields) {
      const bool isReturned = pou.type == BlockType::Fc && s7300::isSameName(field.name, "RET_VAL");
      if (field.section != section || isReturned) continue;
      if (!isOpen) lines.emplace_back(keyword);
      isOpen = true;
      std::string text = fieldLine(field, "  ");
      for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n')) {
        lines.push_back(text.substr(0, end));
        text.erase(0, end + 1);
      }
      lines.push_back(std::move(text));
    }
    if (isOpen) lines.emplace_back("END_VAR");
  }
  return lines;
}

std::string writeSource(const Program& program, MnemonicSet set) { return SourceWriter(program, set).run(); }

bool isLibraryBlock(const Program& program, const Pou& pou) {
  if (formOf(program.target) == StatementForm::Expressions) return pou.isBuiltIn;
  return pou.type != BlockType::None && program.sources->file(pou.span.file).name() == pou.name;
}

std::string blockTitle(const Pou& pou) {
  const std::string block = blockName(pou.number);
  return s7300::isSameName(pou.name, block) ? block : fmt::format("{} \"{}\"", block, pou.name);
}

}  // namespace rungproof::step7
