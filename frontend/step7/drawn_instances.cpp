// Types that say no more than timer or counter, and blocks that are not there.
#include "frontend/step7/drawn_instances.hpp"

#include <algorithm>
#include <map>

#include "ir/s7300/declaration.hpp"

namespace rungproof::step7 {

namespace {

using s7300::foldedName;
using s7300::isSameName;

bool isGeneric(const TypeSyntax& type) {
  return type.named && !type.named->kind &&
         (isSameName(type.named->symbol, "IEC_TIMER") || isSameName(type.named->symbol, "IEC_COUNTER"));
}

/// The type with what is generic at its leaf, or in its elements, made an instance of the block.
std::shared_ptr<const TypeSyntax> settled(const std::shared_ptr<const TypeSyntax>& type,
                                          std::span<const PathStep> below, const BlockName& of) {
  if (type == nullptr) return type;
  if (isGeneric(*type) && below.empty()) {
    auto made = std::make_shared<TypeSyntax>(*type);
    const Span written = made->named->span;
    made->named = of;
    made->named->span = written;
    return made;
  }
  if (type->element != nullptr) {
    auto made = std::make_shared<TypeSyntax>(*type);
    made->element = settled(type->element, below, of);
    return made;
  }
  if (below.empty() || type->fields.empty()) return type;
  auto made = std::make_shared<TypeSyntax>(*type);
  settleGeneric(made->fields, below, of);
  return made;
}

/// Data blocks by what calls write: their symbol, or the symbol of their number.
std::map<std::string, BlockSyntax*> dataBlocksByName(std::vector<SourceSyntax>& sources,
                                                     std::span<const SymbolRow> symbols) {
  std::map<std::uint32_t, std::string> nameOf;
  for (const SymbolRow& row : symbols) {
    const bool isData = row.address.form == OperandForm::Block && row.address.block->kind == BlockKind::Db;
    if (isData) nameOf.emplace(row.address.block->number, foldedName(row.name.text));
  }
  std::map<std::string, BlockSyntax*> blocks;
  for (SourceSyntax& source : sources) {
    for (BlockSyntax& block : source.blocks) {
      if (block.kind != BlockKind::Db) continue;
      if (!block.name.symbol.empty()) blocks.emplace(foldedName(block.name.symbol), &block);
      if (const auto named = nameOf.find(block.name.number); block.name.kind && named != nameOf.end())
        blocks.emplace(named->second, &block);
    }
  }
  return blocks;
}

BlockSyntax absentBlock(const DrawnInstance& use) {
  BlockSyntax block;
  block.kind = BlockKind::Db;
  block.name.symbol = use.instance.name;
  block.name.span = block.heading = block.span = use.span;
  auto type = std::make_shared<TypeSyntax>();
  type->named = use.of;
  type->span = use.span;
  block.type = std::move(type);
  return block;
}

}  // namespace

void settleGeneric(std::vector<DeclarationSyntax>& declarations, std::span<const PathStep> path, const BlockName& of) {
  if (path.empty()) return;
  for (DeclarationSyntax& declaration : declarations) {
    if (isSameName(declaration.name.text, path.front().name))
      declaration.type = settled(declaration.type, path.subspan(1), of);
  }
}

std::vector<std::string> settleInstances(std::vector<SourceSyntax>& sources, std::span<const SymbolRow> symbols,
                                         std::span<const DrawnInstance> instances) {
  std::map<std::string, BlockSyntax*> blocks = dataBlocksByName(sources, symbols);
  std::map<std::string, const DrawnInstance*> missing;
  std::vector<std::string> names;
  for (const DrawnInstance& use : instances) {
    const std::string name = foldedName(use.instance.name);
    if (const auto found = blocks.find(name); found != blocks.end()) {
      BlockSyntax& block = *found->second;
      block.type = settled(block.type, use.instance.path, use.of);
      settleGeneric(block.declarations, use.instance.path, use.of);
      continue;
    }
    const bool isNamed = std::ranges::any_of(
        symbols, [&](const SymbolRow& row) { return isSameName(row.name.text, use.instance.name); });
    if (!isNamed && use.instance.path.empty() && missing.emplace(name, &use).second) names.push_back(use.instance.name);
  }
  for (const auto& [name, use] : missing) {
    const auto source = std::ranges::find(sources, use->span.file, &SourceSyntax::file);
    if (source != sources.end()) source->blocks.push_back(absentBlock(*use));
  }
  return names;
}

}  // namespace rungproof::step7
