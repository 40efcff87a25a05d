// The same program in C, as somebody who wants it fast would write it: a byte for each bit of I, Q, M and SM, words in
// the machine's own order of bytes, the logic stack as variables, subroutines as functions. Status bits and instruction
// times are not computed.
#pragma once

#include <string>

#include "ir/program.hpp"

namespace rungproof::bench {

/// void scan(unsigned char* I, unsigned char* Q, unsigned char* M, unsigned char* V, int* AC). CHECKs that it knows all
/// instructions.
std::string inC(const Program& program);

}  // namespace rungproof::bench
