// The declarations of a program by name: what "Motor".list[2].x and DB10.list are in its data blocks, and what blocks
// declare. Hung onto a program, so that properties, stimuli and reports can use the names.
// Tested by tests/step7/project_test.cpp.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ir/operand.hpp"
#include "ir/s7300/declaration.hpp"
#include "ir/source.hpp"

namespace rungproof::s7300 {

/// Bytes of a data block of which no file tells what they hold when it is loaded.
struct OpenValue {
  std::uint32_t dataBlock = 0;
  std::uint32_t first = 0;
  std::uint32_t count = 0;  ///< 0: all of them
  Span cause;               ///< place of the finding that says so
};

/// What the reader takes and the editor of STEP 7 refuses.
struct SourceFault {
  std::string block;
  int network = 0;  ///< 0: in the head or the declarations
  Span span;
  std::string reason;
};

struct Declarations {
  std::map<std::uint32_t, std::shared_ptr<const Structure>> dataBlocks;  ///< by number
  std::map<std::string, std::uint32_t> dataBlockNames;                   ///< by foldedName() of the symbol
  /// What symbol tables say of addresses outside of data blocks; Unknown where two rows differ.
  std::map<std::pair<Area, std::uint32_t>, TypeKind> symbolTypes;
  std::map<int, std::shared_ptr<const Structure>> parameters;  ///< by Pou::number; of an FB its instance
  std::map<int, std::shared_ptr<const Structure>> temporary;   ///< by Pou::number
  /// Data blocks of which no file tells what stands where, by number, each with the place of the finding that says so.
  std::map<std::uint32_t, Span> openBlocks;
  std::vector<OpenValue> openValues;
  /// Data blocks that calls name as their instance and no file holds: taken with the start values of the called block.
  std::vector<std::string> absentInstances;
  std::vector<SourceFault> sourceFaults;  ///< in the order of the texts
  /// Blocks that run and whose statements are shown to nobody, by Pou::number.
  std::set<int> protectedBlocks;
  /// Findings that leave open no more than that and the networks that are not complete: file and first byte.
  std::set<std::pair<std::uint32_t, std::uint32_t>> bounded;

  /// The place that parts of a data block's name mean; nothing if there is none that one access reaches.
  std::optional<Operand> place(std::uint32_t dataBlock, std::span<const PathStep> path) const;
};

/// Width of an access to a value of that type; nothing for types of other sizes than 1 to 4 bytes.
std::optional<Width> accessWidth(const Type& type);

}  // namespace rungproof::s7300
