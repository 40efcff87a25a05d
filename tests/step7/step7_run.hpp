// Shorthand of these tests: one scan of a project on the engine, and what stands in memory then.
#pragma once

#include <gtest/gtest.h>

#include "engine/simulator.hpp"
#include "ir/block_map.hpp"
#include "tests/step7/read7.hpp"

namespace rungproof {

struct Step7Run {
  /// Blocks, and the statements of OB 1; `locals`: its temporary data behind the start information.
  Step7Run(const std::string& blocks, const std::string& statements, const std::string& locals = {})
      : program(read7(blocks + "ORGANIZATION_BLOCK OB 1\nVAR_TEMP\n  start : ARRAY [0 .. 19] OF BYTE;\n" + locals +
                      "END_VAR\nBEGIN\nNETWORK\n" + statements + "\nEND_ORGANIZATION_BLOCK\n")),
        simulator(program) {
    EXPECT_EQ(findings7(program), "");
    scan();
  }
  void scan() {
    simulator.scan();
    EXPECT_TRUE(simulator.isRunning());
  }
  std::uint64_t at(Area area, Width width, std::uint32_t byte, unsigned bit = 0) const {
    return simulator.read(direct(area, width, byte, bit));
  }
  std::string bytes(Area area, std::uint32_t first, std::uint32_t count) const {
    std::string text;
    for (std::uint32_t i = 0; i < count; ++i)
      text += fmt::format("{}{:02X}", i == 0 ? "" : " ", at(area, Width::Byte, first + i));
    return text;
  }
  /// M memory.
  std::string bytes(std::uint32_t first, std::uint32_t count) const { return bytes(Area::M, first, count); }
  std::uint64_t word(std::uint32_t byte) const { return at(Area::M, Width::Word, byte); }
  bool bit(std::uint32_t byte, unsigned bit) const { return at(Area::M, Width::Bit, byte, bit) != 0; }

  Program program;
  Simulator simulator;
};

}  // namespace rungproof
