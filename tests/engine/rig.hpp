// Rig: a program text on the simulator, with values addressed by name. Blocks are headed INT n and SBR n.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "engine/simulator.hpp"
#include "engine/trace.hpp"
#include "frontend/input/project.hpp"
#include "frontend/stl/operand_reader.hpp"

namespace rungproof {

/// "I0.0", "VW10", "T37", "T37.value".
inline Operand operandNamed(std::string name) {
  const bool asValue = name.ends_with(".value");
  if (asValue) name.resize(name.size() - 6);
  Operand operand;
  EXPECT_TRUE(readAddress(name, Spelling::International, operand)) << name;
  if (asValue) operand.width = Width::Word;
  return operand;
}

class Rig {
 public:
  explicit Rig(const std::string& text, SimulatorOptions options = {}, Target target = {}) {
    ReadOptions reading;
    reading.target = target;
    program = readText("test.awl", text, reading);
    for (const Finding& finding : program.findings) {
      if (finding.severity == Severity::Error) ADD_FAILURE() << finding.rule << ": " << finding.message;
    }
    simulator = std::make_unique<Simulator>(program, std::move(options));
  }

  void set(const std::string& name, std::int64_t value) {
    simulator->write(operandNamed(name), static_cast<std::uint64_t>(value));
  }
  std::int64_t get(const std::string& name) const {
    const TraceSignal signal = signalOf(program, operandNamed(name));
    return static_cast<std::int64_t>(numberOf(simulator->read(signal.operand), signal.type, signal.width()));
  }
  void scans(int count, std::uint32_t lengthUs = 0) {
    for (int i = 0; i < count; ++i) simulator->scan({.lengthUs = lengthUs});
  }
  /// Values of a signal at the ends of the next scans, as a string of digits.
  std::string wave(const std::string& name, int count, std::uint32_t lengthUs = 0) {
    std::string text;
    for (int i = 0; i < count; ++i) {
      scans(1, lengthUs);
      text += std::to_string(get(name));
    }
    return text;
  }

  Program program;
  std::unique_ptr<Simulator> simulator;
};

}  // namespace rungproof
