// What a drawn program does is what its text in STL does, scan by scan: for every drawing of the corpus and for 300
// random PLCopen files. The random ones are also run by a direct evaluator of the drawing, so that the reader and the
// lowering cannot agree on the same mistake.
#include <gtest/gtest.h>

#include <random>

#include "engine/simulator.hpp"
#include "frontend/stl/stl_writer.hpp"
#include "tests/graphical/drawn_program.hpp"
#include "tests/graphical/plcopen_text.hpp"

namespace rungproof {
namespace {

constexpr std::uint32_t scanUs = 100'000;

std::string errorsOf(const Program& program) {
  std::string text;
  for (const Finding& finding : program.findings) {
    if (finding.severity == Severity::Error)
      text += fmt::format("{} {}: {}\n", finding.rule, finding.network, finding.message);
  }
  return text;
}

SimulatorOptions optionsOf() {
  SimulatorOptions options;
  options.scanUs = scanUs;
  return options;
}

/// Everything outside L memory that two programs could leave different.
std::string memoryOf(const Simulator& simulator) {
  std::string text;
  const auto bytesOf = [&](Area area, std::uint32_t count) {
    for (std::uint32_t i = 0; i < count; ++i) text += static_cast<char>(simulator.read(direct(area, Width::Byte, i)));
  };
  bytesOf(Area::Q, 16);
  bytesOf(Area::M, 32);
  bytesOf(Area::V, 192);
  for (std::uint32_t i = 0; i < 72; ++i) {  // timers of 100 ms begin at T37, counters at C0
    text += static_cast<char>(simulator.read(direct(Area::T, Width::Bit, i)) +
                              2 * simulator.read(direct(Area::C, Width::Bit, i)));
    text += std::to_string(simulator.read(direct(Area::T, Width::Word, i)) +
                           65536 * simulator.read(direct(Area::C, Width::Word, i)));
  }
  return text;
}

/// Reads the program again from its STL text. The caller compares what both do.
Program throughStl(const Program& drawn) {
  const std::string text = writeStl(drawn);
  Program again = readText("again.awl", text);
  EXPECT_EQ(errorsOf(again), "") << text;
  EXPECT_EQ(again.instructionCount(), drawn.instructionCount());
  return again;
}

TEST(DrawingAgreement, CorpusDoesWhatItsStlDoes) {
  std::mt19937 random(4711);
  std::size_t networks = 0;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(std::filesystem::path(RUNGPROOF_SOURCE_DIR) / "corpus")) {
    if (entry.path().extension() != ".xml" || entry.path().parent_path().filename() != "plcopen") continue;
    const Program drawn = readAsS7200(entry.path());
    const bool hasStl = dialectOf(drawn.target).set == dialect::S7200;
    if (hasReadErrors(drawn) || !hasStl) continue;  // the faulty ones, and one with a body in ST
    const Program again = throughStl(drawn);
    for (const Pou& pou : drawn.pous) networks += pou.networks.size();
    Simulator a(drawn, optionsOf()), b(again, optionsOf());
    for (int scan = 0; scan < 200; ++scan) {
      for (std::uint32_t byte = 0; byte < 3; ++byte) {
        // Inputs change now and then, so that timers can run out.
        if (random() % 12 != 0) continue;
        const auto value = static_cast<std::uint8_t>(random());
        a.write(direct(Area::I, Width::Byte, byte), value);
        b.write(direct(Area::I, Width::Byte, byte), value);
      }
      a.scan();
      b.scan();
      ASSERT_EQ(memoryOf(a), memoryOf(b)) << entry.path() << " in scan " << scan + 1;
    }
  }
  EXPECT_GE(networks, 80U);
}

TEST(DrawingAgreement, RandomDrawingsDoWhatTheyShow) {
  constexpr unsigned seed = 20240501;
  std::mt19937 random(seed);
  std::size_t networks = 0;
  for (int round = 0; round < 300; ++round) {
    const DrawnProgram program = randomDrawing(random);
    const std::string text = program.text(random);
    const Program drawn = readText("drawing.xml", text);
    ASSERT_EQ(errorsOf(drawn), "") << "seed " << seed << ", file " << round << "\n" << text;
    const Program again = throughStl(drawn);
    for (const Pou& pou : drawn.pous) networks += pou.networks.size();
    Simulator a(drawn, optionsOf()), b(again, optionsOf());
    DrawnEvaluator evaluator(program);
    for (int scan = 0; scan < 60; ++scan) {
      std::map<std::string, bool> inputs;
      for (unsigned i = 0; i < 6; ++i) {
        if (scan > 0 && random() % 4 != 0) continue;
        const bool value = random() % 2 != 0;
        inputs[fmt::format("i{}", i)] = value;
        a.write(direct(Area::I, Width::Bit, 0, i), value ? 1 : 0);
        b.write(direct(Area::I, Width::Bit, 0, i), value ? 1 : 0);
      }
      a.scan();
      b.scan();
      evaluator.scan(inputs);
      ASSERT_EQ(memoryOf(a), memoryOf(b)) << "seed " << seed << ", file " << round << ", scan " << scan + 1;
      for (const Symbol& symbol : drawn.symbols) {
        const std::uint64_t value = a.read(symbol.address);
        const std::string where = fmt::format("{} ({}), seed {}, file {}, scan {}", symbol.name,
                                              toString(symbol.address), seed, round, scan + 1);
        if (symbol.name[0] == 'n') {
          ASSERT_EQ(static_cast<int>(value), evaluator.number(symbol.name)) << where << "\n" << text << writeStl(drawn);
        } else if (symbol.name[0] != 'i') {
          ASSERT_EQ(value != 0, evaluator.bit(symbol.name)) << where << "\n" << text << writeStl(drawn);
        }
      }
    }
  }
  EXPECT_GE(networks, 1500U);
}

}  // namespace
}  // namespace rungproof
