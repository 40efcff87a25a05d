// Random programs of the S7-300/400 as the naive interpreter's campaigns make them, read by the project's own reader:
// for engines that are compared with the reference engine.
#pragma once

#include <string>

#include "frontend/input/project.hpp"
#include "tests/naive7/program_generator.hpp"

namespace rungproof::test {

struct RandomStep7 {
  std::string text;
  Program program;
};

/// `functions`: trigonometry, EXP and LN too (GeneratorChoices).
inline RandomStep7 randomStep7(std::uint64_t seed, bool is400, bool functions) {
  naive7::GeneratorChoices choices;
  choices.is400 = is400;
  choices.functions = functions;
  RandomStep7 random{naive7::ProgramGenerator(seed, choices).program(), {}};
  ReadOptions reading;
  reading.dialect = is400 ? "s7-400" : "s7-300";
  random.program = readText("random.awl", random.text, reading);
  // A statement whose operand nobody knows (DB9 and DB77 are missing on purpose) is never run.
  for (Pou& pou : random.program.pous) {
    for (Network& network : pou.networks)
      std::erase_if(network.instructions, [](const Instruction& each) {
        return !each.operands.empty() && each.operands[0].kind == OperandKind::Symbol;
      });
  }
  return random;
}

}  // namespace rungproof::test
