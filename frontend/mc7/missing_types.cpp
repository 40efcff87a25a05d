// Declarations as text and as compiled, side by side.
#include "frontend/mc7/missing_types.hpp"

#include <fmt/format.h>

#include <set>

#include "frontend/mc7/block_head.hpp"
#include "frontend/mc7/compiled_declaration.hpp"
#include "frontend/step7/source_parser.hpp"
#include "ir/s7300/library.hpp"

namespace rungproof::mc7 {

namespace {

using step7::BlockKey;
using step7::BlockKind;
using step7::BlockSyntax;
using step7::DeclarationSyntax;
using step7::TypeSyntax;

/// A head as syntax, beside its text.
struct ReadHead {
  Program scratch;
  step7::SourceSyntax source;

  explicit ReadHead(const StoredBlock& block) {
    std::string text = headOf(block, false).text + fmt::format("BEGIN\n{}\n", endKeywordOf(block.key.kind));
    const std::uint32_t file = scratch.sources->add("", std::move(text));
    SyntaxSink sink(scratch, file);
    source = step7::readSource(scratch.sources->file(file).text(),
                               {step7::MnemonicSet::International, TextEncoding::Utf8}, sink);
  }
  const BlockSyntax* block() const { return source.blocks.empty() ? nullptr : &source.blocks.front(); }
};

/// A type as text, without start values: who has data of it has the values too.
std::string shapeText(const TypeSyntax& type) {
  if (type.named) return toString(*type.named);
  if (type.element != nullptr) {
    std::string bounds;
    for (const s7300::Bounds& each : type.bounds)
      bounds += fmt::format("{}{} .. {}", bounds.empty() ? "" : ", ", each.first, each.last);
    return fmt::format("ARRAY [{}] OF {}", bounds, shapeText(*type.element));
  }
  if (type.elementary.kind == s7300::TypeKind::Struct) {
    std::string text = "STRUCT\n";
    for (const DeclarationSyntax& field : type.fields)
      text += fmt::format("  {} : {} ;\n", field.name.text, shapeText(*field.type));
    return text + "END_STRUCT";
  }
  if (type.elementary.kind == s7300::TypeKind::String) return fmt::format("STRING [{}]", type.elementary.length);
  return s7300::toString(type.elementary);
}

class TypeFinder {
 public:
  explicit TypeFinder(const std::vector<StoredBlock>& blocks) : blocks_(blocks) {
    for (const StoredBlock& block : blocks) known_.insert(block.key);
  }

  std::vector<StoredBlock> find() {
    for (const StoredBlock& block : blocks_) {
      if (block.declaration.empty()) continue;
      user_ = &block;
      const CompiledDeclaration compiled = readCompiledDeclaration(block.declaration);
      for (const CompiledDeclaration::Instance& instance : compiled.instances) {
        const BlockKey key{instance.isSystem ? BlockKind::Sfb : BlockKind::Fb, instance.number};
        const bool isOfLibrary = instance.isSystem && s7300::libraryBlock(BlockType::Sfb, instance.number) != nullptr;
        if (!isOfLibrary) add(key, instance.text);
      }
      if (compiled.fault.empty() && usesUnknownType(block)) shapes(block);
    }
    return std::move(found_);
  }

 private:
  /// A look at the text before it is read: most blocks use none.
  bool usesUnknownType(const StoredBlock& block) const {
    if (!block.declarationText) return false;
    const std::string& text = *block.declarationText;
    for (std::size_t at = text.find("UDT"); at != std::string::npos; at = text.find("UDT", at + 3)) {
      std::uint32_t number = 0;
      std::size_t digit = text.find_first_not_of(' ', at + 3);
      for (; digit < text.size() && text[digit] >= '0' && text[digit] <= '9' && number < 65536; ++digit)
        number = number * 10 + static_cast<std::uint32_t>(text[digit] - '0');
      if (!known_.contains({BlockKind::Udt, number})) return true;
    }
    return false;
  }

  void shapes(const StoredBlock& block) {
    StoredBlock asCompiled = block;
    asCompiled.declarationText.reset();
    const ReadHead written(block), compiled(asCompiled);
    const BlockSyntax *a = written.block(), *b = compiled.block();
    if (a == nullptr || b == nullptr) return;
    if (a->type != nullptr && b->type != nullptr) return pair(*a->type, *b->type);
    fields(a->declarations, b->declarations);
  }

  void fields(const std::vector<DeclarationSyntax>& written, const std::vector<DeclarationSyntax>& compiled) {
    if (written.size() != compiled.size()) return;  // another version of one of them
    for (std::size_t i = 0; i < written.size(); ++i) {
      if (written[i].type != nullptr && compiled[i].type != nullptr) pair(*written[i].type, *compiled[i].type);
    }
  }

  void pair(const TypeSyntax& written, const TypeSyntax& compiled) {
    if (written.named) {
      const bool isShape = written.named->kind == BlockKind::Udt && !compiled.fields.empty();
      if (!isShape) return;
      return add({BlockKind::Udt, written.named->number}, fmt::format("{} ;\n", shapeText(compiled)));
    }
    if (written.element != nullptr && compiled.element != nullptr) return pair(*written.element, *compiled.element);
    fields(written.fields, compiled.fields);
  }

  void add(BlockKey key, std::string text) {
    if (!known_.insert(key).second) return;
    StoredBlock& block = found_.emplace_back();
    block.key = key;
    block.place = user_->place;
    block.declarationText = std::move(text);
    block.damage = fmt::format("it is missing, and taken in the shape that {} was compiled with", toString(user_->key));
  }

  const std::vector<StoredBlock>& blocks_;
  std::set<BlockKey> known_;
  const StoredBlock* user_ = nullptr;
  std::vector<StoredBlock> found_;
};

}  // namespace

std::vector<StoredBlock> missingTypesOf(const std::vector<StoredBlock>& blocks) { return TypeFinder(blocks).find(); }

}  // namespace rungproof::mc7
