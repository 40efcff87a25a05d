// Stored blocks as sources, one each, which the reader of STEP 7 sources reads like any other file: networks with
// titles and comments, labels, names of local data, calls with parameters. Tested by tests/mc7, tests/s7project.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "frontend/mc7/stored_block.hpp"
#include "ir/program.hpp"

namespace rungproof::mc7 {

struct BlockSource {
  step7::BlockKey key;
  std::string text;
  /// The same with blanks in place of all that stands in networks; empty: the text may be shown as it is.
  std::string shown;
  std::string image;  ///< of a data block: its actual values, byte by byte
  std::size_t networks = 0;
  std::size_t instructions = 0;  ///< machine instructions
  std::string damage;            ///< why no code of it is read, with the byte; empty: it is
};

/// Sources of code, data and types, in the order of the blocks. `asInterfaces`: protected blocks get no body.
std::vector<BlockSource> sourcesOf(const std::vector<StoredBlock>& blocks, bool asInterfaces);

}  // namespace rungproof::mc7
