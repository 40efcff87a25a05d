// The blocks and symbols of a project: what is called by number, what by name, and which number a block without one
// gets. Blocks and symbols that are there twice are reported with both places. Tested by tests/step7/project_test.cpp.
#pragma once

#include <compare>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "frontend/step7/reports.hpp"
#include "frontend/step7/syntax.hpp"

namespace rungproof::step7 {

struct BlockKey {
  BlockKind kind = BlockKind::Ob;
  std::uint32_t number = 0;
  auto operator<=>(const BlockKey&) const = default;
};
/// "FC5", "DB10".
std::string toString(BlockKey key);

struct CatalogueEntry {
  BlockKey key;
  const BlockSyntax* syntax = nullptr;
  std::string name;  ///< symbol, or "FC5"
};

class BlockCatalogue {
 public:
  /// The sources and symbols must outlive the catalogue.
  BlockCatalogue(const std::vector<SourceSyntax>& sources, const std::vector<SymbolRow>& symbols, Reports& reports);

  /// All blocks with their numbers, in the order of the files; of blocks that are there twice the first one.
  const std::vector<CatalogueEntry>& entries() const { return entries_; }
  const CatalogueEntry* entry(BlockKey key) const;
  /// What a name stands for: a number, a symbol of the tables, a block declared by name, a system block by its usual
  /// name (TON). Nothing: nobody defines it, or it is no block.
  std::optional<BlockKey> keyOf(const BlockName& name) const;
  /// The row of a symbol, or nullptr.
  const SymbolRow* symbol(std::string_view name) const;
  /// The symbol of a block, or "FC5".
  std::string nameOf(BlockKey key) const;
  /// The name of a block of that kind whose number is an invention, or nullptr. Nobody knows which number such a block
  /// has in the CPU, so one that is computed may be its number.
  const std::string* withoutNumber(BlockKind kind) const;

 private:
  void addSymbols(const std::vector<SymbolRow>& symbols, Reports& reports);
  void noteWritten(const std::vector<SourceSyntax>& sources);
  void noteWritten(const Operand& operand);
  void addNumbered(const std::vector<SourceSyntax>& sources, Reports& reports);
  void addNamed(const std::vector<SourceSyntax>& sources, Reports& reports);
  bool isFree(BlockKey key) const;
  void noteInvention(const BlockSyntax& block);
  void add(BlockKey key, const BlockSyntax& block, Reports& reports);
  std::optional<BlockKey> organizationBlockNamed(std::string_view name) const;

  std::vector<CatalogueEntry> entries_;
  std::map<BlockKey, std::size_t> byKey_;
  std::map<std::string, const SymbolRow*> symbols_;  ///< by folded name
  std::map<std::string, BlockKey> byName_;           ///< blocks declared by name, by folded name
  std::map<BlockKey, std::string> names_;
  std::set<BlockKey> written_;                      ///< numbers that the text says: no invention has one of these
  std::map<BlockKind, std::string> withoutNumber_;  ///< first in the order of the names
};

}  // namespace rungproof::step7
