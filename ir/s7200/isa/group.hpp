// What the files of ir/s7200/isa share: groups of instructions, and the operands of the one that runs.
#pragma once

#include "ir/machine/instruction_group.hpp"
#include "ir/s7200/args.hpp"
