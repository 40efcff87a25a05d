// How drawn bodies of IEC 61131-3 are shown: the ladder that was drawn, lit by the values of a scan. What the picture
// says must be what the program does: power that reaches a coil over drawn contacts is the value that the coil stores.
#include <gtest/gtest.h>

#include <filesystem>
#include <random>

#include "engine/simulator.hpp"
#include "frontend/picture/network_view.hpp"
#include "frontend/picture/power_flow.hpp"
#include "ir/drawing.hpp"
#include "tests/graphical/plcopen_text.hpp"

namespace rungproof {
namespace {

Program drawnProgram(const std::vector<std::string>& variables, const std::string& language,
                     const std::string& elements) {
  return readText("t.xml",
                  projectText(pouText("Main", "program", "<localVars>" + declarations(variables) + "</localVars>",
                                      language, elements),
                              ""));
}

const Pou& pouNamed(const Program& program, std::string_view name) {
  const auto found = std::ranges::find(program.pous, name, &Pou::name);
  EXPECT_NE(found, program.pous.end()) << name;
  return *found;
}

std::vector<std::string> linesOf(const Program& program, const Network& network, Form form,
                                 const InstructionRecorder* recorder = nullptr) {
  ViewOptions options;
  options.form = form;
  options.recorder = recorder;
  TextStyle style;
  style.ascii = true;
  return contentLines(networkView(program, pouNamed(program, "Main"), network, options), style);
}

std::string textOf(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

/// Start, or the motor itself, while Stop is off; a lamp behind a timer.
const std::string starter =
    railElement(1) + contactElement(2, {"1"}, "Start", "", 10, 10) + contactElement(3, {"1"}, "Motor", "", 10, 30) +
    contactElement(4, {"2", "3"}, "Stop", "negated=\"true\"", 50, 10) + coilElement(5, {"4"}, "Motor", "", 90, 10) +
    contactElement(6, {"1"}, "Motor", "", 10, 100) + inElement(7, "T#1s", "", 10, 120) +
    blockElement(8, "TON", "Wait", {{"IN", {"6"}}, {"PT", {"7"}}}, {"Q", "ET"}, 50, 100) +
    coilElement(9, {"8.Q"}, "Lamp", "storage=\"set\"", 90, 100);

const std::vector<std::string> starterVariables = {"Start:BOOL@%IX0.0", "Stop:BOOL@%IX0.1", "Motor:BOOL@%QX0.0",
                                                   "Lamp:BOOL@%QX0.1", "Wait:TON"};

TEST(IecPictures, ALadderIsShownAsItWasDrawn) {
  const Program program = drawnProgram(starterVariables, "LD", starter);
  const Pou& main = pouNamed(program, "Main");
  ASSERT_EQ(main.networks.size(), 2U) << "two circuits";
  const std::string first = textOf(linesOf(program, main.networks[0], Form::Ladder));
  for (const std::string part : {"Start", "Motor", "Stop", "|/|", "( )"})
    EXPECT_NE(first.find(part), std::string::npos) << part << "\n" << first;
  EXPECT_EQ(first.find('<'), std::string::npos) << "no XML: " << first;
  const std::string second = textOf(linesOf(program, main.networks[1], Form::Ladder));
  for (const std::string part : {"Wait", "TON", "IN", "PT", "T#1s", "Q", "(S)", "Lamp"})
    EXPECT_NE(second.find(part), std::string::npos) << part << "\n" << second;
}

TEST(IecPictures, ALadderAsFbdHasGates) {
  const Program program = drawnProgram(starterVariables, "LD", starter);
  const std::string text = textOf(linesOf(program, pouNamed(program, "Main").networks[0], Form::Fbd));
  for (const std::string part : {"OR", "AND", "Stop"}) EXPECT_NE(text.find(part), std::string::npos) << text;
}

TEST(IecPictures, ALadderAsListIsStructuredText) {
  const Program program = drawnProgram(starterVariables, "LD", starter);
  const Pou& main = pouNamed(program, "Main");
  EXPECT_EQ(textOf(linesOf(program, main.networks[0], Form::Stl)), "  Motor := (Start OR Motor) AND NOT Stop;\n");
  EXPECT_EQ(textOf(linesOf(program, main.networks[1], Form::Stl)),
            "  Wait(IN := Motor, PT := T#1s);\n  IF Wait.Q THEN\n    Lamp := TRUE;\n  END_IF;\n");
}

/// An OR that is fed by the AND behind it: the wire carries the value of before, which is a wire of other gates in
/// each order. The drawing shows the first order, in words and without XML.
TEST(IecPictures, AWireOfBeforeIsSaidInWords) {
  const std::string loop = inElement(1, "a", "", 10, 10) + inElement(2, "b", "", 10, 60) +
                           blockElement(3, "OR", "", {{"IN1", {"1"}}, {"IN2", {"4"}}}, {"OUT"}, 60, 10) +
                           blockElement(4, "AND", "", {{"IN1", {"3"}}, {"IN2", {"2"}}}, {"OUT"}, 120, 40) +
                           outElement(5, {"4"}, "q", "", 200, 40);
  const Program program = drawnProgram({"a:BOOL", "b:BOOL", "q:BOOL"}, "FBD", loop);
  const Pou& main = pouNamed(program, "Main");
  for (const Form form : {Form::Fbd, Form::Ladder}) {
    const std::string text = textOf(linesOf(program, main.networks.at(0), form));
    EXPECT_NE(text.find("value before"), std::string::npos) << text;
    for (const std::string part : {"__", "condition", "<"}) EXPECT_EQ(text.find(part), std::string::npos) << text;
  }
}

/// A circuit in which one statement cannot be lowered falls apart: the other coil is still there.
TEST(IecPictures, OneLostStatementSparesTheOthersOfItsCircuit) {
  const std::string body = railElement(1) + contactElement(2, {"1"}, "Start", "", 10, 10) +
                           coilElement(3, {"2"}, "Motor", "", 50, 10) + coilElement(4, {"2"}, "Nobody", "", 50, 30) +
                           coilElement(5, {"2"}, "Lamp", "", 50, 50);
  const Program program = drawnProgram(starterVariables, "LD", body);
  const Pou& main = pouNamed(program, "Main");
  ASSERT_EQ(main.networks.size(), 3U);
  EXPECT_TRUE(main.networks[0].complete);
  EXPECT_FALSE(main.networks[1].complete) << "the coil of a variable that is not declared";
  EXPECT_TRUE(main.networks[2].complete);
  Simulator simulator(program);
  simulator.write(program.symbolNamed("Start")->address, 1);
  simulator.scan();
  EXPECT_EQ(simulator.read(program.symbolNamed("Motor")->address), 1U);
  EXPECT_EQ(simulator.read(program.symbolNamed("Lamp")->address), 1U);
}

TEST(IecPictures, ALitScanShowsValuesAndPower) {
  const Program program = drawnProgram(starterVariables, "LD", starter);
  InstructionRecorder recorder(program.instructionCount());
  SimulatorOptions options;
  options.scanUs = 250'000;
  Simulator simulator(program, options);
  simulator.observe(&recorder);
  simulator.write(program.symbolNamed("Start")->address, 1);
  for (int scan = 0; scan < 5; ++scan) {
    recorder.beginScan(true);
    simulator.scan();
  }
  // Started in scan 1, asked again each 250 ms: the timer of 1 s is over in scan 5.
  const Pou& main = pouNamed(program, "Main");
  const std::string second = textOf(linesOf(program, main.networks[1], Form::Ladder, &recorder));
  EXPECT_NE(second.find("Motor=1"), std::string::npos) << second;
  EXPECT_NE(second.find("Lamp=1"), std::string::npos) << second;
  const Network& network = main.networks[1];
  const std::vector<ElementFlow> flows = elementFlows(program, *network.drawing, network, recorder);
  for (std::size_t i = 0; i < flows.size(); ++i)
    EXPECT_EQ(flows[i].output, Flow3::On) << "element " << i << ": power everywhere";
}

/// Compares power and stored value at each plain coil of the drawn networks; gives how many were compared.
int compareCoils(const Program& program, const InstructionRecorder& recorder, const std::string& where) {
  int compared = 0;
  for (const Pou& pou : program.pous) {
    for (const Network& network : pou.networks) {
      if (network.drawing == nullptr || !wasExecuted(network, recorder)) continue;
      const std::vector<ElementFlow> flows = elementFlows(program, *network.drawing, network, recorder);
      for (const Element& element : network.drawing->elements) {
        const bool isCoil =
            element.shape == Shape::Coil && element.desc->role == Role::Assign && !element.inputs.empty();
        if (!isCoil || element.instruction >= network.instructions.size()) continue;
        const Flow3 before = flows[element.inputs[0].from].output;
        const InstructionRecord& record = recorder.of(network.instructions[element.instruction]);
        const bool isBool = network.instructions[element.instruction].operands[0].width == Width::Bit;
        if (before == Flow3::Unknown || !isBool || record.executions == 0 || !record.written[0]) continue;
        EXPECT_EQ(before == Flow3::On, *record.written[0] != 0)
            << where << ", " << pou.name << ", network " << network.number << ", " << element.operands[0].text;
        ++compared;
      }
    }
  }
  return compared;
}

TEST(IecPictures, PowerAtACoilIsWhatTheCoilStores) {
  constexpr unsigned seed = 61131;
  std::mt19937 random(seed);
  int compared = 0, drawn = 0;
  for (const char* folder : {"corpus/plcopen", "corpus/iec"}) {
    for (const auto& entry :
         std::filesystem::directory_iterator(std::filesystem::path(RUNGPROOF_SOURCE_DIR) / folder)) {
      if (entry.path().extension() != ".xml") continue;
      const Program program = readProgram({entry.path().string()});
      if (program.syntax == nullptr || program.main() == nullptr) continue;
      for (const Pou& pou : program.pous)
        for (const Network& network : pou.networks) drawn += network.drawing != nullptr ? 1 : 0;
      InstructionRecorder recorder(program.instructionCount());
      Simulator simulator(program);
      simulator.observe(&recorder);
      for (int scan = 1; scan <= 60 && simulator.isRunning(); ++scan) {
        recorder.beginScan(true);
        for (const Directive& directive : program.directives) {
          if (!directive.text.starts_with("external ") || random() % 4 != 0) continue;
          const Symbol* symbol = program.symbolNamed(directive.text.substr(9));
          if (symbol != nullptr && symbol->address.width == Width::Bit) simulator.write(symbol->address, random() % 2);
        }
        simulator.scan();
        compared += compareCoils(program, recorder,
                                 fmt::format("seed {}, {}, scan {}", seed, entry.path().filename().string(), scan));
      }
    }
  }
  EXPECT_GE(drawn, 60);
  EXPECT_GE(compared, 1500);
}

}  // namespace
}  // namespace rungproof
