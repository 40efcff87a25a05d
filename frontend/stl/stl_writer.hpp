// A program as a Micro/WIN text export: classic form, mnemonic in seven columns, international spelling. What was
// read can be written and read again to the same program. Tested by tests/reader/stl_writer_test.cpp.
#pragma once

#include <string>

#include "ir/program.hpp"

namespace rungproof {

struct StlWriterOptions {
  bool symbolic =
      false;  ///< names instead of addresses, with a SYMBOL_TABLE block (which Micro/WIN itself does not read)
  bool comments = true;
};

/// The whole program: blocks, then data blocks.
std::string writeStl(const Program& program, const StlWriterOptions& options = {});
/// One instruction on one line without line end: "LDW>=  VW10, +100".
std::string writeInstruction(const Instruction& instruction, const StlWriterOptions& options = {});

}  // namespace rungproof
