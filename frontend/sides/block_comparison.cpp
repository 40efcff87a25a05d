// Matching blocks, and what differs between two.
#include "frontend/sides/block_comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "analysis/equivalence/network_match.hpp"
#include "frontend/mc7/actual_values.hpp"
#include "frontend/mc7/compiled_declaration.hpp"
#include "ir/s7300/block.hpp"
#include "ir/s7300/declarations.hpp"

namespace rungproof {

namespace {

using mc7::StoredBlock;
using step7::BlockKey;
using step7::BlockKind;

/// What one program has of a block.
struct BlockSide {
  const StoredBlock* stored = nullptr;
  std::optional<std::size_t> pou;
  const DataBlock* data = nullptr;
  bool isThere() const { return stored != nullptr || pou || data != nullptr; }
};

std::optional<BlockKind> codeKindOf(const Pou& pou) {
  switch (pou.type) {
    case BlockType::Ob: return BlockKind::Ob;
    case BlockType::Fc: return BlockKind::Fc;
    case BlockType::Fb: return BlockKind::Fb;
    default: return std::nullopt;
  }
}

using BlockSides = std::map<BlockKey, std::pair<BlockSide, BlockSide>>;

void collect(const ProgramInput& input, const std::vector<StoredBlock>& stored,
             BlockSide std::pair<BlockSide, BlockSide>::*side, BlockSides& into) {
  for (const StoredBlock& block : stored) {
    if (block.isCode() || block.key.kind == BlockKind::Db) (into[block.key].*side).stored = &block;
  }
  for (std::size_t i = 0; i < input.program.pous.size(); ++i) {
    const Pou& pou = input.program.pous[i];
    const std::optional<BlockKind> kind = pou.isBuiltIn ? std::nullopt : codeKindOf(pou);
    if (kind) (into[{*kind, static_cast<std::uint32_t>(numberOfBlock(pou.number))}].*side).pou = i;
  }
  for (const DataBlock& block : input.program.dataBlocks) (into[{BlockKind::Db, block.number}].*side).data = &block;
}

class BlockComparer {
 public:
  explicit BlockComparer(const Sides& sides) : sides_(sides) {}

  ComparedBlock compare(BlockKey key, const BlockSide& before, const BlockSide& after) {
    row_ = {toString(key)};
    if (!before.isThere() || !after.isThere()) {
      row_.likeness = before.isThere() ? BlockLikeness::OnlyOld : BlockLikeness::OnlyNew;
    } else if (key.kind == BlockKind::Db) {
      data(before, after);
    } else {
      code(before, after);
    }
    return std::move(row_);
  }

 private:
  static bool isDamaged(const BlockSide& side) {
    return side.stored != nullptr && (!side.stored->damage.empty() || side.stored->code.empty());
  }
  static bool areStored(const BlockSide& before, const BlockSide& after) {
    return before.stored != nullptr && after.stored != nullptr;
  }
  static bool isSameDeclaration(const BlockSide& before, const BlockSide& after) {
    return mc7::declaredItems(before.stored->declaration) == mc7::declaredItems(after.stored->declaration);
  }

  void code(const BlockSide& before, const BlockSide& after) {
    if (isDamaged(before) || isDamaged(after)) return notRead(before, after);
    if (areStored(before, after)) {
      const StoredBlock &old = *before.stored, &now = *after.stored;
      const bool isSameCode = old.code == now.code;
      if (isSameCode && isSameDeclaration(before, after)) {
        row_.checksum = fmt::format("{:04X}", mc7::checksumOf(now.key.kind, now.code));
        return;
      }
      if (isSameCode) row_.why = "its declaration differs";
      if (!isSameCode && old.checksum && old.checksum == now.checksum)
        row_.why = fmt::format("both have the checksum {:04X}, and their code differs", *old.checksum);
    }
    networks(before, after);
  }

  void notRead(const BlockSide& before, const BlockSide& after) {
    row_.likeness = BlockLikeness::NotRead;
    const bool isOld = isDamaged(before);
    row_.why = fmt::format("its code in {} is lost", isOld && isDamaged(after) ? "both" : isOld ? "OLD" : "NEW");
    if (!areStored(before, after) || !before.stored->checksum || !after.stored->checksum) return;
    row_.why +=
        before.stored->checksum == after.stored->checksum
            ? fmt::format(", both have the checksum {:04X}", *before.stored->checksum)
            : fmt::format(", the checksums are {:04X} and {:04X}", *before.stored->checksum, *after.stored->checksum);
  }

  /// What is only in one program, or other statements.
  void networks(const BlockSide& before, const BlockSide& after) {
    if (!match_) match_ = matchPrograms(sides_.before.program, sides_.after.program, sides_.pairs);
    const auto isIn = [](const std::optional<NetworkRef>& where, const BlockSide& side) {
      return where && side.pou && where->pou == *side.pou;
    };
    bool isOpen = !before.pou || !after.pou;
    for (const NetworkPair& pair : match_->networks) {
      const bool isOfOld = isIn(pair.before, before), isOfNew = isIn(pair.after, after);
      if (!isOfOld && !isOfNew) continue;
      const Network* old = pair.before ? &networkOf(sides_.before.program, *pair.before) : nullptr;
      const Network* now = pair.after ? &networkOf(sides_.after.program, *pair.after) : nullptr;
      if (pair.isSame && isOfOld && isOfNew && old->complete && now->complete) continue;
      if (isOfOld && isOfNew) {
        const bool isUnread = pair.isSame;
        row_.networks.push_back(fmt::format("network {}{}", now->number, isUnread ? " (a line was not read)" : ""));
      } else {
        row_.networks.push_back(
            fmt::format("network {} only in {}", isOfOld ? old->number : now->number, isOfOld ? "OLD" : "NEW"));
      }
    }
    isOpen = isOpen || !row_.networks.empty() || !row_.why.empty();
    row_.likeness = isOpen ? BlockLikeness::Changed : BlockLikeness::SameStatements;
  }
  static const Network& networkOf(const Program& program, const NetworkRef& where) {
    return program.pous[where.pou].networks[where.network];
  }

  void data(const BlockSide& before, const BlockSide& after) {
    if (isDamaged(before) || isDamaged(after)) return notRead(before, after);
    const std::vector<std::uint8_t> old = bytesOf(before), now = bytesOf(after);
    const bool isSameLayout = areStored(before, after) ? isSameDeclaration(before, after) : old.size() == now.size();
    if (!isSameLayout) {
      row_.likeness = BlockLikeness::Changed;
      row_.why = "its declaration differs";
    } else if (old != now) {
      row_.likeness = BlockLikeness::OtherValues;
      values(old, now);
    } else if (!areStored(before, after)) {
      row_.likeness = BlockLikeness::SameStatements;
    }
  }
  static std::vector<std::uint8_t> bytesOf(const BlockSide& side) {
    if (side.stored != nullptr) return {side.stored->code.begin(), side.stored->code.end()};
    return side.data->bytes;
  }

  const s7300::Structure* structureOf(const ProgramInput& input) const {
    if (input.program.declarations == nullptr) return nullptr;
    const auto& blocks = input.program.declarations->dataBlocks;
    const auto found = blocks.find(static_cast<std::uint32_t>(std::stoul(row_.name.substr(2))));
    return found == blocks.end() ? nullptr : found->second.get();
  }

  void values(const std::vector<std::uint8_t>& old, const std::vector<std::uint8_t>& now) {
    const s7300::Structure* structure = structureOf(sides_.before);
    if (structure == nullptr) structure = structureOf(sides_.after);
    if (structure == nullptr) return;
    const auto unlike = [&](const std::vector<std::uint8_t>& image, const std::vector<std::uint8_t>& other) {
      return mc7::valuesUnlike(*structure, other, {reinterpret_cast<const char*>(image.data()), image.size()});
    };
    const std::vector<mc7::NamedValue> ofOld = unlike(old, now), ofNew = unlike(now, old);
    for (std::size_t i = 0; i < ofOld.size() && i < ofNew.size(); ++i)
      row_.values.push_back(fmt::format("{} {} / {}", ofOld[i].name, ofOld[i].value, ofNew[i].value));
    if (row_.values.empty()) row_.why = "bytes that no name has";
  }

  const Sides& sides_;
  std::optional<ProgramMatch> match_;
  ComparedBlock row_;
};

}  // namespace

std::vector<ComparedBlock> compareBlocks(const Sides& sides) {
  std::vector<ComparedBlock> rows;
  if (sides.storedBefore.empty() && sides.storedAfter.empty()) return rows;
  BlockSides blocks;
  collect(sides.before, sides.storedBefore, &std::pair<BlockSide, BlockSide>::first, blocks);
  collect(sides.after, sides.storedAfter, &std::pair<BlockSide, BlockSide>::second, blocks);
  BlockComparer comparer(sides);
  for (const auto& [key, both] : blocks) rows.push_back(comparer.compare(key, both.first, both.second));
  return rows;
}

bool areSameBlocks(const std::vector<ComparedBlock>& blocks, bool ignoresValues) {
  return !blocks.empty() && std::ranges::all_of(blocks, [&](const ComparedBlock& block) {
    return block.likeness == BlockLikeness::Same || (ignoresValues && block.likeness == BlockLikeness::OtherValues);
  });
}

}  // namespace rungproof
