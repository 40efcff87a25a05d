// RunSpace: what runs of the engine can vary and what tells their states apart: the inputs of a program and its memory.
// Taken from the encoding, or from the program's text alone, so that runs can start before there is an encoding.
// Covered by tests/prover/exploration_test.cpp.
#pragma once

#include <optional>
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
  std::optional<Choices> otherReadings;  ///< of the open points on which the program depends; nothing: there are none
  TimeRange time;
  std::uint32_t clockMs = 0;  ///< period of the slowest clock that the program reads; 0: it reads none
  std::vector<Input> inputs;
  std::vector<Place> state;
};

RunSpace runSpaceOf(const EncodedScan& encoding);
/// By the direct operands of the instructions and of the properties; what only pointers reach is left out.
RunSpace runSpaceOf(const Program& program, const PropertySet& set, const Choices& choices, const TimeRange& time);

}  // namespace rungproof
