// A program of the S7-300/400 as a STEP 7 source in either set of mnemonics: addresses and block numbers in place of
// symbols, #names of local data. What was read can be written and read again to the same instructions.
// Tested by tests/step7/source_writer_test.cpp.
#pragma once

#include <string>
#include <vector>

#include "frontend/step7/constant_parser.hpp"
#include "ir/program.hpp"

namespace rungproof::step7 {

/// One statement on one line without semicolon: "A      I0.0", "CALL   FB2, DB3 (IN := M0.0, PT := T#5S)", "out:".
std::string writeStatement(const Program& program, const Instruction& instruction, MnemonicSet set);
/// The sections VAR_INPUT to VAR_TEMP of a block, one line each.
std::vector<std::string> declarationLines(const Program& program, const Pou& pou);
/// Blocks of the program and declarations of its data blocks with initial, not actual, values.
std::string writeSource(const Program& program, MnemonicSet set);
/// A block of the CPU or of a library whose statements the program does not have itself.
bool isLibraryBlock(const Program& program, const Pou& pou);
/// OB1, FB10 "Valve".
std::string blockTitle(const Pou& pou);

}  // namespace rungproof::step7
