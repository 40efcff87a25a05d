// RunSpace: what runs of the engine can vary and what tells their states apart: the inputs of a program and its memory.
// Taken from the encoding, or from the program's text alone, so that runs can start before there is an encoding.
// Covered by tests/prover/exploration_test.cpp.
#pragma once

#include <vector>

#include "analysis/encoding/scan_inputs.hpp"
#include "analysis/property.hpp"

namespace rungproof {

struct RunSpace {
  /// An input and its operands: external words are written byte by byte.
  struct Input {
    int width = 1;
    std::vector<ScanInput> operands;
  };

  Choices choices;
  TimeRange time;
  std::vector<Input> inputs;
  std::vector<Place> state;
};

RunSpace runSpaceOf(const EncodedScan& encoding);
/// By the direct operands of the instructions and of the properties; what only pointers reach is left out.
RunSpace runSpaceOf(const Program& program, const PropertySet& set, const Choices& choices, const TimeRange& time);

}  // namespace rungproof
