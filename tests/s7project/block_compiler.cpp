// Compiling.
#include "tests/s7project/block_compiler.hpp"

#include <fmt/format.h>

#include <map>

#include "frontend/input/project.hpp"
#include "frontend/mc7/encoder.hpp"
#include "frontend/step7/source_parser.hpp"
#include "frontend/step7/type_table.hpp"
#include "ir/s7300/declarations.hpp"

namespace rungproof::test {

namespace {

using mc7::Size;
using mc7::StoredBlock;
using step7::BlockKey;
using step7::BlockKind;
using step7::BlockSyntax;
using step7::Operand;
using step7::OperandForm;
using step7::Statement;

Size sizeOf7(const s7300::Type& type) {
  const std::uint64_t bytes = s7300::sizeOf(type);
  if (type.kind == s7300::TypeKind::Bool) return Size::Bit;
  return bytes == 1 ? Size::Byte : bytes == 2 ? Size::Word : Size::DWord;
}

void addLittle(std::string& bytes, std::size_t value) {
  bytes += static_cast<char>(value);
  bytes += static_cast<char>(value >> 8);
}

std::string placeName(std::string_view bit, std::string_view other, Size size, std::uint32_t byte, unsigned at) {
  constexpr std::string_view letters = " BWD";
  return size == Size::Bit ? fmt::format("{} {}.{}", bit, byte, at)
                           : fmt::format("{}{} {}", other, letters[static_cast<std::size_t>(size)], byte);
}

class BlockCompiler {
 public:
  explicit BlockCompiler(const std::string& text) : text_(text), reports_(scratch_) {
    const std::uint32_t file = scratch_.sources->add("source", text_);
    SyntaxSink sink(scratch_, file);
    sources_.push_back(step7::readSource(text_, {step7::MnemonicSet::International, TextEncoding::Utf8}, sink));
    catalogue_.emplace(sources_, noSymbols_, reports_);
    types_.emplace(*catalogue_, reports_);
    program_ = readText("source.awl", text_);
  }

  CompiledSource run() {
    for (const step7::CatalogueEntry& entry : catalogue_->entries()) {
      StoredBlock block;
      block.key = entry.key;
      block.language = entry.key.kind == BlockKind::Db ? 5 : 1;
      block.version = 0x10;
      block.title = entry.syntax->title;
      block.isProtected = entry.syntax->knowHowProtected;
      block.declarationText = declarationOf(*entry.syntax);
      if (block.isCode())
        code(entry, block);
      else if (entry.key.kind == BlockKind::Db)
        data(entry, block);
      result_.blocks.push_back(std::move(block));
    }
    return std::move(result_);
  }

 private:
  std::string slice(Span span) const { return text_.substr(span.offset, span.length); }

  /// From the first section, or the type of a data block, up to the body.
  std::string declarationOf(const BlockSyntax& block) const {
    const std::string whole = slice(block.span);
    std::size_t from = std::string::npos;
    for (const std::string_view word : {"\nVAR", "\nSTRUCT"}) from = std::min(from, whole.find(word));
    const std::size_t to = std::min(whole.find("\nBEGIN"), whole.find("\nEND_TYPE"));
    return from == std::string::npos || to <= from ? "" : whole.substr(from + 1, to - from);
  }

  void data(const step7::CatalogueEntry& entry, StoredBlock& block) {
    const std::optional<BlockKey> instance = types_->instanceOf(*entry.syntax);
    block.declaration = instance ? (instance->kind == BlockKind::Sfb ? "\x0B" : "\x0A") : "\x05";
    const auto structure = types_->structure(instance ? *instance : entry.key);
    std::string items;
    if (structure != nullptr && !instance) structureItem(*structure, 4, items);
    if (structure != nullptr && instance) fieldItems(*structure, items);
    head(instance ? instance->number : entry.key.number, items, block.declaration);
    for (const DataBlock& data : program_.dataBlocks) {
      if (data.number == entry.key.number) block.code.assign(data.bytes.begin(), data.bytes.end());
    }
  }

  // Compiled declarations: the items alone, for start values stand in the text and in the image ---------------------

  static void head(std::uint32_t number, const std::string& items, std::string& bytes) {
    addLittle(bytes, number);
    addLittle(bytes, static_cast<std::uint32_t>(items.size()));
    addLittle(bytes, 0);
    bytes += items;
  }

  static int sectionOf(const s7300::Field& field) {
    if (field.name == "RET_VAL") return 6;
    switch (field.section) {
      case step7::Section::Input: return 1;
      case step7::Section::Output: return 2;
      case step7::Section::InOut: return 3;
      case step7::Section::Temp: return 5;
      default: return 4;
    }
  }

  static void fieldItems(const s7300::Structure& structure, std::string& items) {
    for (const s7300::Field& field : structure.fields) typeItem(field.type, sectionOf(field), items);
  }

  static void structureItem(const s7300::Structure& structure, int section, std::string& items) {
    items += '\x11';
    items += static_cast<char>(section);
    items += static_cast<char>(structure.fields.size());  // fewer than 255 here
    for (const s7300::Field& field : structure.fields) typeItem(field.type, 4, items);
  }

  static void typeItem(const s7300::Type& type, int section, std::string& items) {
    using enum s7300::TypeKind;
    static const std::map<s7300::TypeKind, int> codes = {
        {Bool, 1},     {Byte, 2},         {Char, 3},       {Word, 4},     {Int, 5},      {DWord, 6},    {DInt, 7},
        {Real, 8},     {Date, 9},         {TimeOfDay, 10}, {Time, 11},    {S5Time, 12},  {Pointer, 20}, {Any, 22},
        {BlockFb, 23}, {DateAndTime, 14}, {BlockFc, 24},   {BlockDb, 25}, {Counter, 28}, {Timer, 29},   {BlockSdb, 26}};
    if (type.kind == Struct && type.structure != nullptr) {
      const bool isInstance = type.name.starts_with("FB ") || type.name.starts_with("SFB ");
      if (!isInstance) return structureItem(*type.structure, section, items);
      items += type.name.starts_with('S') ? '\x1B' : '\x15';
      addLittle(items, static_cast<std::uint32_t>(std::stoul(type.name.substr(type.name.find(' ')))));
      items += "\x11\x04";
      items += static_cast<char>(type.structure->fields.size());
      return fieldItems(*type.structure, items);
    }
    if (type.kind == Array && type.element != nullptr) {
      items += '\x10';
      items += static_cast<char>(section);
      items += static_cast<char>(type.bounds.size());
      for (const s7300::Bounds& bounds : type.bounds) {
        addLittle(items, static_cast<std::uint16_t>(bounds.first));
        addLittle(items, static_cast<std::uint16_t>(bounds.last));
      }
      return typeItem(*type.element, section, items);
    }
    items += type.kind == String ? '\x13' : static_cast<char>(codes.at(type.kind));
    items += static_cast<char>(section);
    if (type.kind == String) items += static_cast<char>(type.length);
  }

  void declare(StoredBlock& block) const {
    std::string items;
    if (parameters_ != nullptr) fieldItems(*parameters_, items);
    if (temporary_ != nullptr) fieldItems(*temporary_, items);
    block.declaration = '\x01';
    head(key_.number, items, block.declaration);
  }

  void code(const step7::CatalogueEntry& entry, StoredBlock& block) {
    block_ = entry.syntax;
    key_ = entry.key;
    temporary_ = types_->temporary(*block_);
    parameters_ = key_.kind == BlockKind::Fb   ? types_->structure(key_)
                  : key_.kind == BlockKind::Fc ? types_->parameters(*block_)
                                               : nullptr;
    scratch7_ = static_cast<std::uint32_t>(temporary_->size + 1) & ~1U;
    if (key_.kind == BlockKind::Ob) scratch7_ = std::max(scratch7_, 20U);
    statements_.clear();
    std::vector<std::size_t> ends;
    for (const step7::NetworkSyntax& network : block_->networks) {
      for (const Statement& statement : network.statements) expand(statement);
      ends.push_back(statements_.size());
      block.networkTexts.push_back({network.title, ""});
    }
    add("BE");
    const mc7::EncodeNames names{[this](const Operand& local) { return meaningOf(local); }};
    const mc7::AssembledCode assembled = mc7::assemble(statements_, names);
    if (!assembled.fault.empty() && result_.fault.empty())
      result_.fault = fmt::format("{}: {}", toString(key_), assembled.fault);
    block.code = assembled.bytes;
    declare(block);
    if (assembled.starts.size() == statements_.size()) table(assembled, ends, block);
    block.localBytes = static_cast<std::uint16_t>(scratch7_);
    block.checksum = mc7::checksumOf(key_.kind, block.code);
  }

  void table(const mc7::AssembledCode& assembled, const std::vector<std::size_t>& ends, StoredBlock& block) {
    addLittle(block.table, ends.size());
    std::uint32_t at = 0;
    for (const std::size_t end : ends) {
      addLittle(block.table, assembled.starts[end] - at);
      at = assembled.starts[end];
    }
    std::vector<std::size_t> jumps;
    for (std::size_t i = 0; i < statements_.size(); ++i) {
      const Statement& one = statements_[i];
      const bool isJump =
          one.operand.form == OperandForm::Word && (one.mnemonic.text == "LOOP" || one.mnemonic.text.starts_with("J"));
      if (isJump) jumps.push_back(i);
    }
    addLittle(block.table, jumps.size());
    for (const std::size_t i : jumps) {
      addLittle(block.table, assembled.starts[i] / 2);
      block.labels.push_back(statements_[i].operand.name);
    }
  }

  // Statements ------------------------------------------------------------------------------------------------------

  void add(const std::string& text, const step7::Name& label = {}) {
    const std::string& kept = kept_.emplace_back(std::make_unique<std::string>(text + ";")).operator*();
    step7::Cursor cursor(kept, 0);
    std::vector<Span> remarks;
    statements_.push_back(
        step7::readStatement(cursor, {step7::MnemonicSet::International, TextEncoding::Utf8}, remarks));
    statements_.back().label = label;
  }

  void expand(const Statement& statement) {
    if (statement.mnemonic.text.empty()) {
      statements_.push_back(statement);
      return;
    }
    if (statement.mnemonic.text == "CALL") {
      const std::size_t first = statements_.size();
      statement.instance.form == OperandForm::None ? callFunction(statement) : callBlock(statement);
      if (first < statements_.size()) statements_[first].label = statement.label;
      return;
    }
    const Operand& operand = statement.operand;
    if (operand.form == OperandForm::Address && operand.block) {
      add(fmt::format("OPN DB {}", operand.block->number), statement.label);
      add(fmt::format("{} {}", statement.mnemonic.text, placeInBlock(operand, "DB")));
      return;
    }
    statements_.push_back(statement);
  }

  static std::string placeInBlock(const Operand& operand, const std::string& letters) {
    return placeName(letters + "X", letters, operand.size, operand.number, operand.bit);
  }

  std::optional<mc7::LocalMeaning> meaningOf(const Operand& local) {
    mc7::LocalMeaning meaning;
    s7300::PathResult found = s7300::lookUp(*temporary_, local.path);
    meaning.place.form = OperandForm::Address;
    meaning.place.place = step7::Place::L;
    if (found.fault != s7300::PathFault::None) {
      if (parameters_ == nullptr) return std::nullopt;
      found = s7300::lookUp(*parameters_, local.path);
      if (found.fault != s7300::PathFault::None) return std::nullopt;
      if (key_.kind == BlockKind::Fc) {
        meaning.parameter = static_cast<unsigned>(found.field - parameters_->fields.data()) + 1;
        meaning.size = sizeOf7(*found.type);
        if (found.type->kind == s7300::TypeKind::Timer) meaning.kind = "T";
        if (found.type->kind == s7300::TypeKind::Counter) meaning.kind = "C";
        if (found.type->kind == s7300::TypeKind::BlockDb) meaning.kind = "DB";
        return meaning;
      }
      meaning.place.form = OperandForm::Indirect;
      meaning.place.place = step7::Place::DI;
      meaning.place.addressRegister = 2;
      meaning.place.offset = found.byte * 8 + found.bit;
    }
    meaning.place.size = sizeOf7(*found.type);
    meaning.place.number = found.byte;
    meaning.place.bit = found.bit;
    return meaning;
  }

  // Calls -----------------------------------------------------------------------------------------------------------

  std::uint32_t takeScratch(std::uint32_t bytes) {
    const std::uint32_t at = scratch7_;
    scratch7_ += bytes;
    return at;
  }

  const step7::Argument* argumentOf(const Statement& statement, const std::string& formal) const {
    for (const step7::Argument& argument : statement.arguments) {
      if (s7300::isSameName(argument.formal.text, formal)) return &argument;
    }
    return nullptr;
  }

  std::string sourceText(const step7::Argument& argument) const {
    const std::string text = slice(argument.span);
    std::string actual = text.substr(text.find(":=") + 2);
    while (actual.starts_with(' ')) actual.erase(0, 1);
    return actual;
  }

  void load(const Operand& actual, const std::string& text, Size size, const std::string& openBy) {
    if (actual.form == OperandForm::Constant && actual.constant.kind == s7300::ConstantKind::Boolean)
      return add(actual.constant.value != 0 ? "SET" : "CLR");
    const bool isInBlock = actual.form == OperandForm::Address && actual.block;
    if (isInBlock) add(fmt::format("OPN {} {}", openBy, actual.block->number));
    add(fmt::format("{} {}", size == Size::Bit ? "A" : "L", isInBlock ? placeInBlock(actual, openBy) : text));
  }

  void callFunction(const Statement& statement) {
    const std::uint32_t number = statement.operand.block->number;
    const bool isSystem = statement.operand.block->kind == BlockKind::Sfc;
    const BlockSyntax* callee = isSystem ? nullptr : catalogue_->entry({BlockKind::Fc, number})->syntax;
    const auto interface = callee == nullptr ? std::make_shared<const s7300::Structure>() : types_->parameters(*callee);
    add(isSystem ? "BLD 7" : "BLD 1");
    add(fmt::format("= L {}.0", takeScratch(2)));
    std::string list;
    std::vector<std::string> after;
    for (const s7300::Field& formal : interface->fields) {
      const step7::Argument* argument = argumentOf(statement, formal.name);
      const Operand& actual = argument->actual;
      const Size size = sizeOf7(formal.type);
      const std::string text = sourceText(*argument);
      std::string pointer;
      if (formal.type.kind == s7300::TypeKind::Timer || formal.type.kind == s7300::TypeKind::Counter) {
        pointer = fmt::format("DW#16#{:X}", actual.number << 16);
      } else if (actual.form == OperandForm::Address && !actual.block && actual.place <= step7::Place::M) {
        constexpr std::string_view areas[] = {"I", "Q", "M"};
        pointer = fmt::format("P#{} {}.{}", areas[static_cast<std::size_t>(actual.place)], actual.number, actual.bit);
      } else {
        const std::uint32_t at = takeScratch(4);
        pointer = fmt::format("P#V {}.0", at);
        const std::string slot = placeName("L", "L", size, at, 0);
        if (formal.section == s7300::Section::Input || formal.section == s7300::Section::InOut) {
          load(actual, text, size, "DB");
          add(fmt::format("{} {}", size == Size::Bit ? "=" : "T", slot));
        }
        if (formal.section != s7300::Section::Input) {
          after.push_back(fmt::format("{} {}", size == Size::Bit ? "A" : "L", slot));
          const bool isInBlock = actual.form == OperandForm::Address && actual.block;
          if (isInBlock) after.push_back(fmt::format("OPN DB {}", actual.block->number));
          after.push_back(
              fmt::format("{} {}", size == Size::Bit ? "=" : "T", isInBlock ? placeInBlock(actual, "DB") : text));
        }
      }
      list += (list.empty() ? "" : ", ") + pointer;
    }
    add(fmt::format("UC {} {}{}", isSystem ? "SFC" : "FC", number, list.empty() ? "" : " {" + list + "}"));
    for (const std::string& text : after) add(text);
    add(isSystem ? "BLD 8" : "BLD 2");
  }

  void callBlock(const Statement& statement) {
    const std::uint32_t number = statement.operand.block->number, instance = statement.instance.block->number;
    const auto interface = types_->structure({BlockKind::Fb, number});
    add("BLD 3");
    add(fmt::format("= L {}.0", takeScratch(2)));
    add("CDB");
    add(fmt::format("OPN DI {}", instance));
    const std::uint32_t saved = takeScratch(4);
    add(fmt::format("TAR2 LD {}", saved));
    std::vector<std::string> after;
    for (const s7300::Field& formal : interface->fields) {
      const step7::Argument* argument = argumentOf(statement, formal.name);
      if (argument == nullptr) continue;
      const Size size = sizeOf7(formal.type);
      const std::string slot = placeName("DIX", "DI", size, formal.byte, formal.bit);
      const bool isInBlock = argument->actual.form == OperandForm::Address && argument->actual.block;
      if (formal.section == s7300::Section::Input || formal.section == s7300::Section::InOut) {
        load(argument->actual, sourceText(*argument), size, "DI");
        if (isInBlock) add(fmt::format("OPN DI {}", instance));
        add(fmt::format("{} {}", size == Size::Bit ? "=" : "T", slot));
      }
      if (formal.section != s7300::Section::Input) {
        after.push_back(fmt::format("{} {}", size == Size::Bit ? "A" : "L", slot));
        after.push_back(fmt::format("{} {}", size == Size::Bit ? "=" : "T", sourceText(*argument)));
      }
    }
    add("LAR2 P#DBX 0.0");
    add(fmt::format("UC FB {}", number));
    add(fmt::format("LAR2 LD {}", saved));
    for (const std::string& text : after) add(text);
    add("CDB");
    add("BLD 4");
  }

  std::string text_;
  Program scratch_, program_;
  step7::Reports reports_;
  const std::vector<step7::SymbolRow> noSymbols_;
  std::vector<step7::SourceSyntax> sources_;
  std::optional<step7::BlockCatalogue> catalogue_;
  std::optional<step7::TypeTable> types_;
  const BlockSyntax* block_ = nullptr;
  BlockKey key_;
  std::shared_ptr<const s7300::Structure> temporary_, parameters_;
  std::uint32_t scratch7_ = 0;
  std::vector<Statement> statements_;
  std::vector<std::unique_ptr<std::string>> kept_;
  CompiledSource result_;
};

}  // namespace

CompiledSource compileSource(const std::string& text) { return BlockCompiler(text).run(); }

}  // namespace rungproof::test
