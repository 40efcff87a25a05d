// What the types of a project are: UDTs, instances of FBs and system blocks, data blocks, parameters and local data of
// blocks, each resolved once, with places and values. Reports types that nothing defines or that contain themselves,
// and values that do not fit. Tested by tests/step7/layout_test.cpp.
#pragma once

#include <map>
#include <memory>
#include <set>
#include <utility>

#include "frontend/step7/block_catalogue.hpp"
#include "ir/s7300/declaration.hpp"

namespace rungproof::step7 {

class TypeTable {
 public:
  TypeTable(const BlockCatalogue& catalogue, Reports& reports) : catalogue_(catalogue), reports_(reports) {}

  /// The structure of a UDT, of the instance of an FB or SFB, or of a data block; nullptr if nothing defines it.
  std::shared_ptr<const s7300::Structure> structure(BlockKey key);
  /// Parameters of an FC in the order IN, OUT, IN_OUT, RET_VAL as the first output; without places.
  std::shared_ptr<const s7300::Structure> parameters(const BlockSyntax& block);
  /// Names of values, without places.
  std::shared_ptr<const s7300::Structure> constants(const BlockSyntax& block);
  /// Temporary data, laid out in L memory.
  std::shared_ptr<const s7300::Structure> temporary(const BlockSyntax& block);
  /// The FB or SFB of an instance data block.
  std::optional<BlockKey> instanceOf(const BlockSyntax& block) const;
  /// Whether a data block is the instance of an SFB that no table describes: what stands in it is not known.
  bool isOpaque(BlockKey key) const;
  /// Whether all types of the structure of that block are known.
  bool isKnown(BlockKey key) const { return !doubtOf(key).type; }
  /// What is not known of a structure, and the finding that says so.
  struct Doubt {
    bool type = false;   ///< a type: what stands where
    bool value = false;  ///< an initial value
    Span cause;

    void add(const Doubt& other);
  };
  Doubt doubtOf(BlockKey key) const;
  /// What is not known of the parameters, constants and temporary data of a block that have been asked for.
  Doubt doubtOf(const BlockSyntax& block) const;

 private:
  s7300::Type resolve(const TypeSyntax& syntax);
  s7300::Type named(const TypeSyntax& syntax);
  std::optional<s7300::Field> field(const DeclarationSyntax& declaration);
  bool isView(const DeclarationSyntax& declaration, const s7300::Field& view, const s7300::Field* seen, bool hasPlaces);
  void append(const std::vector<DeclarationSyntax>& declarations, std::initializer_list<Section> sections,
              s7300::Structure& structure);
  std::shared_ptr<const s7300::Structure> make(BlockKey key);
  void checkSize(const s7300::Structure& structure, const BlockSyntax& block);

  const BlockCatalogue& catalogue_;
  Reports& reports_;
  std::map<BlockKey, std::shared_ptr<const s7300::Structure>> made_;
  std::set<BlockKey> inProgress_;
  void doubtType(Span cause) { doubt_.add({true, false, cause}); }

  /// Asks for a part of the block, and keeps what is in doubt of it.
  template <class Make>
  std::shared_ptr<const s7300::Structure> partOf(const BlockSyntax& block, Make&& make);

  std::map<const BlockSyntax*, std::shared_ptr<const s7300::Structure>> parameters_;
  std::map<const BlockSyntax*, Doubt> partDoubts_;
  std::map<BlockKey, Doubt> doubts_;
  Doubt doubt_;  ///< since it was last cleared
};

}  // namespace rungproof::step7
