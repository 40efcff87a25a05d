// Single blocks read out of a CPU: a header of 36 bytes, code, declaration, table of networks, a footer of 36 bytes.
// Tested by tests/mc7/upload_test.cpp.
#pragma once

#include "frontend/mc7/stored_block.hpp"

namespace rungproof::mc7 {

/// Whether the bytes begin like such a block.
bool isUpload(std::string_view bytes);
/// The block; StoredBlock::damage says what is wrong with it. `place`: the name of the file.
StoredBlock readUpload(std::string_view bytes, std::string place);
/// The bytes of a block as a CPU gives them.
std::string writeUpload(const StoredBlock& block);

}  // namespace rungproof::mc7
