// Numbers and names of blocks.
#include "frontend/step7/block_catalogue.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "ir/s7300/library.hpp"

namespace rungproof::step7 {

namespace {

using s7300::foldedName;

bool isSameAddress(const Operand& a, const Operand& b) {
  if (a.form != b.form) return false;
  if (a.form == OperandForm::Block) return a.block->kind == b.block->kind && a.block->number == b.block->number;
  return a.place == b.place && a.size == b.size && a.number == b.number && a.bit == b.bit;
}

/// TIA Portal calls the data of IEC timers and counters TON_TIME and CTU_INT, after the block and its width. An
/// S7-300/400 has no other widths.
std::string_view blockOfData(std::string_view type) {
  for (const std::string_view block : {"TP", "TON", "TOF", "CTU", "CTD", "CTUD"}) {
    const std::string_view width = block.starts_with('T') ? "_TIME" : "_INT";
    const bool isData = type.size() == block.size() + width.size() &&
                        s7300::isSameName(type.substr(0, block.size()), block) &&
                        s7300::isSameName(type.substr(block.size()), width);
    if (isData) return block;
  }
  return type;
}

}  // namespace

std::string toString(BlockKey key) { return fmt::format("{}{}", blockKindName(key.kind), key.number); }

BlockCatalogue::BlockCatalogue(const std::vector<SourceSyntax>& sources, const std::vector<SymbolRow>& symbols,
                               Reports& reports) {
  addSymbols(symbols, reports);
  addNumbered(sources, reports);
  noteWritten(sources);
  addNamed(sources, reports);
  std::ranges::stable_sort(entries_, {}, [](const CatalogueEntry& entry) { return entry.syntax->heading.file; });
  for (std::size_t i = 0; i < entries_.size(); ++i) byKey_[entries_[i].key] = i;
}

void BlockCatalogue::addSymbols(const std::vector<SymbolRow>& symbols, Reports& reports) {
  for (const SymbolRow& row : symbols) {
    const auto [place, isNew] = symbols_.emplace(foldedName(row.name.text), &row);
    if (!isNew) {
      if (isSameAddress(place->second->address, row.address)) continue;
      reports.report(Syntax::SymbolRow, row.name.span,
                     fmt::format("\"{}\" already stands for another address", row.name.text));
      reports.relate(place->second->name.span, "the first row of that name");
      continue;
    }
    if (row.address.form == OperandForm::Block)
      names_.emplace(BlockKey{*row.address.block->kind, row.address.block->number}, row.name.text);
  }
}

void BlockCatalogue::add(BlockKey key, const BlockSyntax& block, Reports& reports) {
  const auto [place, isNew] = byKey_.emplace(key, entries_.size());
  if (isNew) {
    entries_.push_back({key, &block, nameOf(key)});
    return;
  }
  reports.report(Syntax::BlockTwice, block.heading,
                 fmt::format("{} is there twice: only the first one is read", toString(key)), nameOf(key), 0);
  reports.relate(entries_[place->second].syntax->heading, "the first one");
}

void BlockCatalogue::noteWritten(const Operand& operand) {
  for (const Operand* at = &operand; at != nullptr; at = at->pointer.get()) {
    if (at->constant.block != 0) written_.insert({BlockKind::Db, at->constant.block});  // P#DB10.DBX 0.0
    if (at->block && at->block->kind)
      written_.insert({*at->block->kind == BlockKind::Di ? BlockKind::Db : *at->block->kind, at->block->number});
  }
}

/// Calls, opened blocks, addresses of data and instances.
void BlockCatalogue::noteWritten(const std::vector<SourceSyntax>& sources) {
  for (const SourceSyntax& source : sources) {
    for (const BlockSyntax& block : source.blocks) {
      for (const NetworkSyntax& network : block.networks) {
        for (const Statement& statement : network.statements) {
          noteWritten(statement.operand);
          noteWritten(statement.instance);
          for (const Argument& argument : statement.arguments) noteWritten(argument.actual);
        }
      }
    }
  }
  for (const auto& [name, row] : symbols_) noteWritten(row->address);
}

void BlockCatalogue::addNumbered(const std::vector<SourceSyntax>& sources, Reports& reports) {
  for (const SourceSyntax& source : sources) {
    for (const BlockSyntax& block : source.blocks) {
      if (block.name.kind) add({*block.name.kind, block.name.number}, block, reports);
    }
  }
}

/// OBs that TIA Portal calls by these names where no table says more.
std::optional<BlockKey> BlockCatalogue::organizationBlockNamed(std::string_view name) const {
  constexpr std::array<std::pair<std::string_view, std::uint32_t>, 10> usual = {{{"Main", 1},
                                                                                 {"Startup", 100},
                                                                                 {"Complete Restart", 100},
                                                                                 {"COMPLETE RESTART", 100},
                                                                                 {"Cyclic interrupt", 35},
                                                                                 {"CYC_INT5", 35},
                                                                                 {"Cycle Execution", 1},
                                                                                 {"Program cycle", 1},
                                                                                 {"Hardware interrupt", 40},
                                                                                 {"Programming error", 121}}};
  const auto row = std::ranges::find_if(usual, [&](const auto& entry) { return s7300::isSameName(entry.first, name); });
  return row == usual.end() ? std::nullopt : std::optional(BlockKey{BlockKind::Ob, row->second});
}

/// Whether neither a block nor the text has the number.
bool BlockCatalogue::isFree(BlockKey key) const {
  return !byKey_.contains(key) && !names_.contains(key) && !written_.contains(key);
}

void BlockCatalogue::noteInvention(const BlockSyntax& block) {
  const auto [first, isNew] = withoutNumber_.emplace(block.kind, block.name.symbol);
  if (!isNew) first->second = std::min(first->second, block.name.symbol);
}

const std::string* BlockCatalogue::withoutNumber(BlockKind kind) const {
  const auto found = withoutNumber_.find(kind == BlockKind::Di ? BlockKind::Db : kind);
  return found == withoutNumber_.end() ? nullptr : &found->second;
}

/// Functions, function blocks and types without a number get one from the upper end, where no library and hardly an
/// address reaches, in the order of their names, so that the order of files changes nothing. Data blocks get the lowest
/// free number in the order of the files: their addresses name them in reports.
void BlockCatalogue::addNamed(const std::vector<SourceSyntax>& sources, Reports& reports) {
  std::map<std::pair<BlockKind, std::string>, std::uint32_t> fromTheEnd;
  std::map<BlockKind, std::uint32_t> next;
  for (const SourceSyntax& source : sources) {
    for (const BlockSyntax& block : source.blocks) {
      if (block.name.kind || block.name.symbol.empty() || block.kind == BlockKind::Db) continue;
      fromTheEnd.emplace(std::pair(block.kind, foldedName(block.name.symbol)), 0);
    }
  }
  for (auto& [block, number] : fromTheEnd) {
    do {
      number = 0xFFFF - next[block.first]++;
    } while (!isFree({block.first, number}));
  }
  for (const SourceSyntax& source : sources) {
    for (const BlockSyntax& block : source.blocks) {
      if (block.name.kind || block.name.symbol.empty()) continue;
      const std::string folded = foldedName(block.name.symbol);
      std::optional<BlockKey> key;
      if (const SymbolRow* row = symbol(block.name.symbol); row != nullptr && row->address.form == OperandForm::Block) {
        if (*row->address.block->kind == block.kind) key = BlockKey{block.kind, row->address.block->number};
      }
      if (const auto named = byName_.find(folded); !key && named != byName_.end() && named->second.kind == block.kind)
        key = named->second;
      if (!key && block.kind == BlockKind::Ob) key = organizationBlockNamed(block.name.symbol);
      if (!key && block.kind == BlockKind::Ob) {
        reports.report(
            Syntax::BlockHeading7, block.name.span,
            fmt::format("nothing says which OB \"{}\" is: add the symbol table, or write its number such as OB 100",
                        block.name.symbol));
        continue;
      }
      if (!key && block.kind != BlockKind::Db) {
        key = BlockKey{block.kind, fromTheEnd.at({block.kind, folded})};
        noteInvention(block);
      }
      while (!key) {
        const BlockKey candidate{block.kind, ++next[block.kind]};
        if (isFree(candidate)) key = candidate;
        if (key) noteInvention(block);
      }
      names_.emplace(*key, block.name.symbol);
      byName_.emplace(folded, *key);
      add(*key, block, reports);
    }
  }
}

const CatalogueEntry* BlockCatalogue::entry(BlockKey key) const {
  const auto found = byKey_.find(key);
  return found == byKey_.end() ? nullptr : &entries_[found->second];
}

const SymbolRow* BlockCatalogue::symbol(std::string_view name) const {
  const auto found = symbols_.find(foldedName(name));
  return found == symbols_.end() ? nullptr : found->second;
}

std::optional<BlockKey> BlockCatalogue::keyOf(const BlockName& name) const {
  if (name.kind) {
    const BlockKind kind = *name.kind == BlockKind::Di ? BlockKind::Db : *name.kind;
    return BlockKey{kind, name.number};
  }
  if (const SymbolRow* row = symbol(name.symbol)) {
    if (row->address.form != OperandForm::Block) return std::nullopt;
    return BlockKey{*row->address.block->kind, row->address.block->number};
  }
  if (const auto named = byName_.find(foldedName(name.symbol)); named != byName_.end()) return named->second;
  if (const s7300::LibraryBlock* block = s7300::libraryBlockNamed(blockOfData(name.symbol))) {
    const BlockKind kind = block->type == BlockType::Sfb   ? BlockKind::Sfb
                           : block->type == BlockType::Sfc ? BlockKind::Sfc
                                                           : BlockKind::Fc;
    return BlockKey{kind, block->number};
  }
  return std::nullopt;
}

std::string BlockCatalogue::nameOf(BlockKey key) const {
  const auto found = names_.find(key);
  return found == names_.end() ? toString(key) : found->second;
}

}  // namespace rungproof::step7
