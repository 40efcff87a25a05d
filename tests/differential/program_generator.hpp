// Random programs for the comparison of encoder and engine. Instructions come from the descriptor table, operands
// from the forms each descriptor allows, over a small part of memory so that they meet. Programs are built as lines
// that can be taken out one by one, so a failing one can be shrunk.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ir/program.hpp"
#include "tests/differential/random_source.hpp"

namespace rungproof {

struct GeneratorOptions {
  int rungs = 12;
  bool jumps = true;
  bool loops = true;
  bool subroutines = true;
  bool interrupts = false;
  bool pointers = false;
  Target target{};
};

/// A program as blocks of instructions; block 0 is the main program.
struct RandomProgram {
  struct Block {
    PouKind kind = PouKind::Main;
    int number = 0;
    std::vector<LocalVariable> locals{};
    std::vector<Instruction> instructions{};
  };
  std::vector<Block> blocks;
  Target target{};

  Program program() const;
  std::string text() const;
  std::size_t size() const;
  /// Without the instruction that stands at `index` over all blocks.
  RandomProgram without(std::size_t index) const;
};

RandomProgram randomProgram(RandomSource& random, const GeneratorOptions& options);

}  // namespace rungproof
