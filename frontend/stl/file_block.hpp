// A file without a block head holds one block, whose kind, number and name come from the name of the file, as programs
// are handed around: MAIN.stl, FC0_SysInit.stl, SBR3_Valves.stl, INT1.stl, Pump.stl. Tested by
// tests/reader/file_block_test.cpp.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "ir/program.hpp"

namespace rungproof {

struct FileBlock {
  std::string name;             ///< the file's, without folder and ending
  std::optional<PouKind> kind;  ///< nothing: the name does not say
  std::optional<int> number;    ///< of SBRn, FCn, INTn
};
FileBlock fileBlock(std::string_view path);

/// What follows the underscore in SBR3_Valves, by which the block may be called as well; empty: nothing does.
std::string_view shortName(std::string_view name);

/// A block that was read without a head, and the file it came from.
struct HeadlessBlock {
  std::size_t pou;
  std::string file;
};
/// Gives such blocks their kind, number and name where the project has another main program, or where the name of the
/// file says what they are.
void nameFromFiles(Program& program, const std::vector<HeadlessBlock>& blocks);

}  // namespace rungproof
