// Sources to stored blocks, as the editor of STEP 7 compiles them: networks, jumps, calls framed by BLD, data blocks by
// OPN. Calls of FCs take operands of I, Q, M and L by the list and copy the rest; calls of FBs copy into the instance.
#pragma once

#include <string>
#include <vector>

#include "frontend/mc7/stored_block.hpp"

namespace rungproof::test {

struct CompiledSource {
  std::vector<mc7::StoredBlock> blocks;
  std::string fault;  ///< the first statement that has no code here; empty: all have
};

CompiledSource compileSource(const std::string& text);

}  // namespace rungproof::test
