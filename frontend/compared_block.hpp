// A block of two S7-300/400 programs in a comparison: part of a report, which the reporters of frontend/report print.
// Covered by tests/s7project/upload_comparison_test.cpp.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rungproof {

enum class BlockLikeness : std::uint8_t {
  Same,            ///< byte by byte
  SameStatements,  ///< of a block whose bytes one program does not have, or with other bytes for the same statements
  OtherValues,     ///< a data block with the same declaration
  Changed,
  OnlyOld,
  OnlyNew,
  NotRead  ///< the bytes of one are lost
};
/// "same", "other values", "changed", ...
std::string_view likenessName(BlockLikeness likeness);

struct ComparedBlock {
  std::string name;  ///< "FC2"
  BlockLikeness likeness = BlockLikeness::Same;
  std::string checksum{};               ///< "75F4", of machine code that is the same
  std::vector<std::string> networks{};  ///< of a changed one: "network 3", "network 4 only in OLD"
  std::vector<std::string> values{};    ///< "Count 12 / 17": OLD, NEW
  std::string why{};                    ///< what else is to be said: "its declaration differs"
};

/// One line for each likeness; blocks that differ have a line each. Empty without blocks.
std::string comparedBlocksText(const std::vector<ComparedBlock>& blocks);

}  // namespace rungproof
