// Programs of the naive interpreter as programs of this tool: the statements that it reads become instructions and
// operands, without any of the tool's readers.
#pragma once

#include <string>

#include "ir/program.hpp"
#include "tests/naive7/machine.hpp"

namespace rungproof::agreement7 {

/// The program for the largest CPU of the family; `faults` gets a line for each statement that has no instruction.
Program irOf(const naive7::Program& program, bool is400, std::string& faults);

}  // namespace rungproof::agreement7
