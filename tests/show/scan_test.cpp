// Networks of programs with the power flow of a scan: what the picture lights must be what the engine did. On every
// program of the corpus, with random inputs, each coil and box of a drawn network gets power in the picture exactly
// when its instruction saw power on the stack.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include "analysis/drawing/raise.hpp"
#include "engine/instruction_recorder.hpp"
#include "engine/simulator.hpp"
#include "frontend/input/project.hpp"
#include "frontend/picture/network_view.hpp"
#include "frontend/picture/placement.hpp"
#include "frontend/picture/power_flow.hpp"
#include "frontend/stl/operand_reader.hpp"
#include "tests/show/drawings.hpp"

namespace rungproof::show_test {
namespace {

namespace fs = std::filesystem;

Program programOf(const std::string& text) { return readText("test.awl", text, {}); }
Program mainOf(const std::string& lines) {
  return programOf("ORGANIZATION_BLOCK MAIN:OB1\nTITLE=\nBEGIN\n" + lines + "\nEND_ORGANIZATION_BLOCK\n");
}

std::vector<fs::path> corpusPrograms() {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(fs::path(RUNGPROOF_SOURCE_DIR) / "corpus")) {
    if (entry.path().extension() == ".awl") files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

std::string wholeFile(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// Power at the first input of an element as the picture has it.
bool lightsInput(const std::vector<ElementFlow>& flows, const Element& element) {
  const Wire& wire = element.inputs.at(0);
  return (flows.at(wire.from).output == Flow3::On) != wire.negated;
}

/// Compares all drawn networks of the program after one recorded scan; gives how many coils and boxes were compared.
int compareScan(const Program& program, const InstructionRecorder& recorder, Form form) {
  int compared = 0;
  for (const Pou& pou : program.pous) {
    for (const Network& network : pou.networks) {
      const Raised raised = raise(network, form);
      if (!raised.drawing || !wasExecuted(network, recorder)) continue;
      const std::vector<ElementFlow> flows = elementFlows(program, *raised.drawing, network, recorder);
      for (const Element& element : raised.drawing->elements) {
        const bool isSink = element.shape == Shape::Coil || (element.shape == Shape::Box && element.inputs.size() == 1);
        if (!isSink || element.inputs.empty() || element.instruction >= network.instructions.size()) continue;
        const Instruction& instruction = network.instructions[element.instruction];
        const InstructionRecord& record = recorder.of(instruction);
        if (record.executions == 0 || instruction.desc->control == Control::Call) continue;
        EXPECT_EQ(lightsInput(flows, element) && record.scrActive, record.powerFlow())
            << pou.name << ", network " << network.number << ": " << instruction.desc->stl;
        ++compared;
      }
    }
  }
  return compared;
}

TEST(PowerFlow, PictureAgreesWithEngine) {
  int compared = 0;
  std::mt19937 random(7);
  for (const fs::path& path : corpusPrograms()) {
    SCOPED_TRACE(path.filename().string() + ", inputs of mt19937(7)");
    const Program program = readText(path.string(), wholeFile(path), {});
    if (program.main() == nullptr || program.olderDialect) continue;
    Simulator simulator(program);
    InstructionRecorder recorder(program.instructionCount());
    simulator.observe(&recorder);
    for (int scan = 0; scan < 20 && simulator.isRunning(); ++scan) {
      simulator.write(direct(Area::I, Width::DWord, 0), random());
      recorder.beginScan(true);
      simulator.scan();
      compared += compareScan(program, recorder, Form::Ladder);
      if (scan % 5 == 0) compared += compareScan(program, recorder, Form::Fbd);
    }
  }
  EXPECT_GT(compared, 2000);
}

/// The rung of the manual's latch: start pressed, then released. Values and wires of both scans follow from the rung.
TEST(PowerFlow, LatchStep) {
  const Program program = mainOf("Network 1 // latch\nLD I0.0\nO Q0.0\nAN I0.1\n= Q0.0");
  Simulator simulator(program);
  InstructionRecorder recorder(program.instructionCount());
  simulator.observe(&recorder);
  const auto flowsNow = [&](std::uint64_t inputs) {
    simulator.write(direct(Area::I, Width::Byte, 0), inputs);
    recorder.beginScan(true);
    simulator.scan();
    ViewOptions options;
    options.recorder = &recorder;
    std::string text;
    for (const std::string& line :
         contentLines(networkView(program, program.pous[0], program.pous[0].networks[0], options), {.ascii = true}))
      text += line + "\n";
    return text;
  };
  const std::string pressed = flowsNow(1);
  EXPECT_NE(pressed.find("+===[#]===+===[/]==="), std::string::npos) << pressed;
  EXPECT_NE(pressed.find("+===| |---+"), std::string::npos) << pressed;
  EXPECT_NE(pressed.find("Q0.0=1"), std::string::npos) << pressed;
  const std::string released = flowsNow(0);
  EXPECT_NE(released.find("+===| |---+===[/]==="), std::string::npos) << released;
  EXPECT_NE(released.find("+===[#]===+"), std::string::npos) << released;
}

/// Observing must not change the run: the same scans with and without an observer end in the same state.
TEST(PowerFlow, ObserverChangesNothing) {
  for (const fs::path& path : corpusPrograms()) {
    SCOPED_TRACE(path.filename().string() + ", inputs of mt19937(3)");
    const Program program = readText(path.string(), wholeFile(path), {});
    if (program.main() == nullptr) continue;
    Simulator plain(program), watched(program);
    InstructionRecorder recorder(program.instructionCount());
    watched.observe(&recorder);
    std::mt19937 random(3);
    for (int scan = 0; scan < 30; ++scan) {
      const std::uint64_t inputs = random();
      for (Simulator* simulator : {&plain, &watched}) {
        simulator->write(direct(Area::I, Width::DWord, 0), inputs);
        simulator->scan();
      }
    }
    EXPECT_TRUE(plain.store() == watched.store());
  }
}

TEST(NetworkView, HeadingCommentsSymbolsFindings) {
  const Program program = programOf(
      "ORGANIZATION_BLOCK MAIN:OB1\nTITLE=Pump\nBEGIN\nNetwork 4 // run\n// while the level is low\nLD Level_low\n= "
      "Pump\nEND_ORGANIZATION_BLOCK\n"
      "SYMBOL_TABLE\nLevel_low\tI0.3\t\nPump\tQ0.2\t\nEND_SYMBOL_TABLE\n");
  ASSERT_EQ(program.pous.size(), 1U);
  const Network& network = program.pous[0].networks[0];
  Finding finding;
  finding.rule = "OUT007";
  finding.severity = Severity::Warning;
  finding.message = "the coil may not run";
  finding.span = network.instructions[1].span;
  ViewOptions options;
  options.findings = {&finding};
  const NetworkView view = networkView(program, program.pous[0], network, options);
  EXPECT_EQ(view.heading, "Network 4  run");
  EXPECT_EQ(view.comments, std::vector<std::string>{"while the level is low"});
  EXPECT_EQ(blockHeading(program.pous[0]), "MAIN (OB1)  Pump");
  std::string text = "\n";
  for (const std::string& line : contentLines(view, {})) text += line + "\n";
  EXPECT_NE(text.find("Level_low"), std::string::npos);
  EXPECT_NE(text.find("^OUT007"), std::string::npos);
  EXPECT_NE(text.find("  warning OUT007: the coil may not run\n"), std::string::npos);
}

/// Rows of contacts, branches and outputs of any length have an answer: a picture, or all statements and the reason.
TEST(NetworkView, WhatIsTooLargeToDrawIsShownAsStlWithTheReason) {
  const auto many = [](const std::string& lines, int count) {
    std::string text;
    for (int i = 0; i < count; ++i) text += lines;
    return text;
  };
  struct Case {
    std::string text;
    std::size_t statements;
  };
  constexpr int count = 100'000;
  const Case cases[] = {
      {"LD I0.0\n" + many("A M0.0\n", count) + "= Q0.0", count + 2U},
      {"LD I0.0\n" + many("O M0.0\n", count) + "= Q0.0", count + 2U},
      {"LD I0.0\n" + many("= M0.0\n", count), count + 1U},
      {"LD I0.0\n" + many("A M0.0\nO M0.1\n", count / 2) + "= Q0.0", count + 2U},
      {"LD I0.0\n" + many("A M0.0\nO M0.1\n", 900) + "= Q0.0", 1802U},  // 1,800 elements, but 900 columns by 900 rows
      {"LD I0.0\nLPS\n" + many("A M0.0\n= Q0.0\nLRD\n", count) + "LPP\n= Q0.1", 3U * count + 4},
  };
  for (const Case& each : cases) {
    const Program program = mainOf("Network 1\n" + each.text);
    for (const Form form : {Form::Ladder, Form::Fbd}) {
      ViewOptions options;
      options.form = form;
      const NetworkView view = networkView(program, program.pous[0], program.pous[0].networks[0], options);
      EXPECT_EQ(view.picture.height, 0);
      EXPECT_TRUE(view.reason.starts_with("too large to draw: ")) << view.reason;
      EXPECT_EQ(view.statements.size(), each.statements);
    }
  }
}

/// What a page can show is drawn as before.
TEST(NetworkView, LongRowsAreDrawn) {
  std::string series = "Network 1\nLD I0.0\n", parallel = series;
  for (int i = 0; i < 500; ++i) series += "A M0.0\n", parallel += "O M0.0\n";
  for (const std::string& text : {series, parallel}) {
    const Program program = mainOf(text + "= Q0.0");
    const NetworkView view = networkView(program, program.pous[0], program.pous[0].networks[0], {});
    EXPECT_EQ(view.reason, "");
    EXPECT_EQ(view.picture.symbols.size(), 502U);
  }
}

TEST(NetworkView, WhatHasNoPictureIsShownAsStl) {
  const Program program = mainOf("Network 1\nLD I0.0\n= Q0.0\nLD I0.1\n= Q0.1");
  const NetworkView view = networkView(program, program.pous[0], program.pous[0].networks[0], {});
  EXPECT_EQ(view.picture.height, 0);
  EXPECT_NE(view.reason, "");
  EXPECT_EQ(view.statements, (std::vector<std::string>{"LD     I0.0", "=      Q0.0", "LD     I0.1", "=      Q0.1"}));
}

/// 1,000 networks to SVG in at most 1 s, reading the statements aside: raising, layout, rendering.
TEST(Size, ThousandNetworksToSvg) {
  std::string text;
  for (int i = 0; i < 1000; ++i) {
    const std::string b = std::to_string(i % 8), w = std::to_string(2 * (i % 500));
    text += "Network " + std::to_string(i + 1) + " // rung\nLD I0." + b + "\nO Q0." + b + "\nAN I1." + b +
            "\nLPS\nA M0." + b + "\n= Q0." + b + "\nLPP\nAW>= VW" + w + ", 100\nMOVW VW" + w + ", VW1000\n";
  }
  const Program program = mainOf(text);
  ASSERT_EQ(program.pous[0].networks.size(), 1000U);
  BlockView block;
  std::string svg;
  block = {blockHeading(program.pous[0]), {}};
  for (const Network& network : program.pous[0].networks)
    block.networks.push_back(networkView(program, program.pous[0], network, {}));
  svg = viewSvg({block});
  EXPECT_EQ(block.networks[999].reason, "");
  EXPECT_GT(svg.size(), 1000000U);
}

}  // namespace
}  // namespace rungproof::show_test
