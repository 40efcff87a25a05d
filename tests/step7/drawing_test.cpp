// Ladder and FBD networks of an S7-300/400 in SimaticML: each part becomes the statements of its box, circuits mean
// what they show, what is not known is named and nothing rests on it.
#include <gtest/gtest.h>

#include <random>

#include "engine/simulator.hpp"
#include "frontend/flgnet/part_table.hpp"
#include "frontend/step7/name_lookup.hpp"
#include "ir/s7300/fbd_box.hpp"
#include "tests/step7/flgnet_text.hpp"
#include "tests/step7/read7.hpp"
#include "tests/step7/run7.hpp"

namespace rungproof {
namespace {

using s7300::BoxFrame;
using s7300::FbdBox;
using test7::DrawnNet, test7::drawnBlock, test7::drawnDocument, test7::instanceText, test7::member, test7::negated,
    test7::section, test7::typed, test7::unit;

ReadOptions drawnOptions() {
  ReadOptions options;
  options.dialect = "s7-300";
  return options;
}
Program readDrawn(const std::string& blocks) { return readText("drawn.xml", drawnDocument(blocks), drawnOptions()); }
Program drawnOb1(const DrawnNet& net) { return readDrawn(drawnBlock("OB", "Main", 1, "", unit(net.text()))); }
/// The statements of OB1, or what was found wrong.
std::string statementsOf(const Program& program) {
  return program.findings.empty() && !program.pous.empty() ? show7(program.pous[0]) : findings7(program);
}
std::string written(const std::string& statements) { return statementsOf(readOb1(statements)); }

std::string withPins(const std::string& text, const std::map<std::string, std::string>& pins) {
  std::string result;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] != '$') {
      result += text[at];
      continue;
    }
    std::size_t end = at + 1;
    while (end < text.size() && (std::isalnum(static_cast<unsigned char>(text[end])) != 0 || text[end] == '_')) ++end;
    result += pins.at(text.substr(at + 1, end - at - 1));
    at = end - 1;
  }
  return result + ";";
}

std::string small(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

// Every row of the table of boxes that has EN, and those of S5 timers and counters: with all pins wired, the network is
// the expansion of its row, statement by statement.
TEST(Drawing7, BoxesAreTheStatementsOfTheirRow) {
  const std::map<std::string, std::string> pins = {
      {"EN", "M0.0"}, {"ENO", "Q4.0"}, {"Q", "Q4.1"},      {"S", "M0.2"},   {"R", "M0.3"},   {"CU", "M0.4"},
      {"CD", "M0.5"}, {"TV", "MW60"},  {"PV", "MW62"},     {"BI", "MW40"},  {"BCD", "MW44"}, {"CV", "MW40"},
      {"N", "MW64"},  {"IN", "MD10"},  {"CV_BCD", "MW44"}, {"IN1", "MD10"}, {"IN2", "MD20"}, {"OUT", "MD30"}};
  std::size_t rows = 0;
  for (const flgnet::BoxPart& row : flgnet::boxParts()) {
    const FbdBox* box = flgnet::boxOf(row.part, row.type);
    ASSERT_NE(box, nullptr) << row.part << row.type;
    const bool isTimer = box->frame == BoxFrame::Timer, isCounter = box->frame == BoxFrame::Counter;
    const std::string type(row.type), from = type.substr(0, type.find('>'));
    std::string inner = from.empty() ? "" : typed("SrcType", from);
    if (from != type) inner += typed("DestType", type.substr(type.find('>') + 1));
    std::map<std::string, std::string> all = pins;
    all["BOX"] = isCounter ? "C1" : "T1";
    DrawnNet net;
    if (isTimer || isCounter) inner += instanceText(all["BOX"]);
    const int part = net.part(std::string(row.part), inner);
    const auto wire = [&](const std::string& pin) {
      const bool isOutput = pin == "OUT" || pin == "Q" || pin == "BI" || pin == "BCD" || pin.starts_with("CV");
      if (isOutput)
        net.out(part, row.part == "Move" ? "out1" : small(pin), all.at(pin));
      else if (pin != "BOX")
        net.in(all.at(pin), part, small(pin));
    };
    for (const std::string& pin : pinsOf(*box)) wire(pin);
    if (!isTimer && !isCounter) {
      net.in("M0.0", part, "en");
      net.out(part, "eno", "Q4.0");
    }
    EXPECT_EQ(statementsOf(drawnOb1(net)), written(withPins(expansionOf(*box), all))) << row.part << " " << row.type;
    ++rows;
  }
  EXPECT_EQ(rows, 62U);
}

struct ElementCase {
  std::string_view part;
  std::string pins;  ///< "in:M0.0 operand:M2.0"; with > instead of : an output
  std::string statements;
};

// The elements of bit logic, by the rows 003:20-109: what stands at their pins, and the statements.
TEST(Drawing7, ElementsAreTheStatementsOfTheirRow) {
  const ElementCase cases[] = {
      {"Contact", "in:M0.0 operand:M2.0 out>Q4.1", "A M0.0; A M2.0; = Q4.1"},
      {"PContact", "in:M0.0 operand:M2.0 bit:M1.0 out>Q4.1", "A M0.0; A(; A M2.0; FP M1.0; ); = Q4.1"},
      {"NContact", "in:M0.0 operand:M2.0 bit:M1.0 out>Q4.1", "A M0.0; A(; A M2.0; FN M1.0; ); = Q4.1"},
      {"Not", "in:M0.0 out>Q4.1", "A M0.0; NOT; = Q4.1"},
      {"PBox", "in:M0.0 bit:M1.0 out>Q4.1", "A M0.0; FP M1.0; = Q4.1"},
      {"NBox", "in:M0.0 bit:M1.0 out>Q4.1", "A M0.0; FN M1.0; = Q4.1"},
      {"A", "in1:M0.0 in2:M0.1 out>Q4.1", "A M0.0; A M0.1; = Q4.1"},
      {"O", "in1:M0.0 in2:M0.1 out>Q4.1", "O M0.0; O M0.1; = Q4.1"},
      {"X", "in1:M0.0 in2:M0.1 out>Q4.1", "X M0.0; X M0.1; = Q4.1"},
      {"Coil", "in:M0.0 operand:Q4.1", "A M0.0; = Q4.1"},
      {"SCoil", "in:M0.0 operand:Q4.1", "A M0.0; S Q4.1"},
      {"RCoil", "in:M0.0 operand:Q4.1", "A M0.0; R Q4.1"},
      {"PCoil", "in:M0.0 operand:Q4.1 bit:M1.0", "A M0.0; FP M1.0; = Q4.1"},
      {"NCoil", "in:M0.0 operand:Q4.1 bit:M1.0", "A M0.0; FN M1.0; = Q4.1"},
      {"Sr", "s:M0.0 r1:M0.1 operand:M2.0 q>Q4.1", "A M0.0; S M2.0; A M0.1; R M2.0; A M2.0; = Q4.1"},
      {"Rs", "r:M0.0 s1:M0.1 operand:M2.0 q>Q4.1", "A M0.0; R M2.0; A M0.1; S M2.0; A M2.0; = Q4.1"},
      {"Jump", "in:M0.0 label:label:end", "end: A M0.0; JC end"},
      {"JumpNot", "in:M0.0 label:label:end", "end: A M0.0; JCN end"},
      {"Return", "in:M0.0", "A M0.0; SAVE; BEC"},
  };
  std::size_t rows = 0;
  for (const ElementCase& c : cases) {
    EXPECT_EQ(c.part, flgnet::elementParts()[rows++].part) << "a case for each, in their order";
    DrawnNet net;
    if (c.pins.find("label:label") != std::string::npos) net.label("end");
    const int part = net.part(std::string(c.part));
    std::istringstream pins(c.pins);
    for (std::string pin; pins >> pin;) {
      const std::size_t sign = pin.find_first_of(":>");
      const std::string operand = pin.substr(sign + 1);
      if (pin[sign] == '>')
        net.out(part, pin.substr(0, sign), operand);
      else
        net.in(operand, part, pin.substr(0, sign));
    }
    EXPECT_EQ(statementsOf(drawnOb1(net)), written(c.statements + ";")) << c.part;
  }
  EXPECT_EQ(rows, flgnet::elementParts().size());
}

// The six relations of three types (003:33-35).
TEST(Drawing7, ComparisonsOfAllTypes) {
  const std::pair<const char*, const char*> relations[] = {{"Eq", "=="}, {"Ne", "<>"}, {"Gt", ">"},
                                                           {"Ge", ">="}, {"Lt", "<"},  {"Le", "<="}};
  const std::pair<const char*, const char*> types[] = {{"Int", "I"}, {"DInt", "D"}, {"Real", "R"}};
  for (const auto& [part, relation] : relations) {
    for (const auto& [type, suffix] : types) {
      DrawnNet net;
      const int compare = net.part(part, typed("SrcType", type)), coil = net.part("Coil");
      net.in("MD10", compare, "in1");
      net.in("MD20", compare, "in2");
      net.flow({compare, "out"}, {{coil, "in"}});
      net.in("Q4.1", coil, "operand");
      EXPECT_EQ(statementsOf(drawnOb1(net)), written(fmt::format("L MD10; L MD20; {}{}; = Q4.1;", relation, suffix)));
    }
  }
}

/// Q4.0 and Q4.1 after one scan with M0.0 to M0.4 as the bits of a number.
int outputsFor(const Program& program, int inputs) {
  Simulator simulator(program);
  simulator.write(direct(Area::M, Width::Byte, 0), static_cast<std::uint64_t>(inputs));
  simulator.scan();
  EXPECT_TRUE(simulator.isRunning());
  return static_cast<int>(simulator.read(direct(Area::Q, Width::Byte, 4)) & 3);
}

// Ladder: a and not b, beside c, feeds two rungs: with d to Q4.0; exclusively or'd with e to Q4.1. All 32 inputs.
TEST(Drawing7, LadderWithBranches) {
  DrawnNet net;
  const int a = net.part("Contact"), b = net.part("Contact", negated("operand")), c = net.part("Contact"),
            join = net.part("O", typed("Card", "2")), d = net.part("Contact"), q0 = net.part("Coil"),
            exclusive = net.part("X", typed("Card", "2")), q1 = net.part("Coil");
  net.rail({{a, "in"}, {c, "in"}});
  net.flow({a, "out"}, {{b, "in"}});
  net.flow({b, "out"}, {{join, "in1"}});
  net.flow({c, "out"}, {{join, "in2"}});
  net.flow({join, "out"}, {{d, "in"}, {exclusive, "in1"}});
  net.flow({d, "out"}, {{q0, "in"}});
  net.in("M0.4", exclusive, "in2");
  net.flow({exclusive, "out"}, {{q1, "in"}});
  const std::pair<int, const char*> operands[] = {{a, "M0.0"}, {b, "M0.1"},  {c, "M0.2"},
                                                  {d, "M0.3"}, {q0, "Q4.0"}, {q1, "Q4.1"}};
  for (const auto& [part, operand] : operands) net.in(operand, part, "operand");
  const Program program = drawnOb1(net);
  ASSERT_EQ(findings7(program), "");
  for (int inputs = 0; inputs < 32; ++inputs) {
    const auto bit = [&](int i) { return (inputs >> i & 1) != 0; };
    const bool joined = (bit(0) && !bit(1)) || bit(2);
    EXPECT_EQ(outputsFor(program, inputs), (joined && bit(3) ? 1 : 0) | (joined != bit(4) ? 2 : 0)) << inputs;
  }
}

// Gates in gates, more levels than the CPU nests (7), negations at inputs: the parity-like chain g1 = a & b,
// g2 = not g1 or c, g3 = not g2 & d, ... in each gate the next of five inputs.
TEST(Drawing7, GatesNestDeeperThanTheCpu) {
  DrawnNet net;
  int before = -1;
  constexpr int gates = 12;
  for (int i = 0; i < gates; ++i) {
    const int gate = net.part(i % 2 == 0 ? "A" : "O", typed("Card", "2") + (before < 0 ? "" : negated("in2")));
    net.in(fmt::format("M0.{}", i % 5), gate, "in1");
    if (before < 0)
      net.in("M0.1", gate, "in2");
    else
      net.flow({before, "out"}, {{gate, "in2"}});
    before = gate;
  }
  const int coil = net.part("Coil");
  net.flow({before, "out"}, {{coil, "in"}});
  net.in("Q4.0", coil, "operand");
  const Program program = drawnOb1(net);
  ASSERT_EQ(findings7(program), "");
  for (int inputs = 0; inputs < 32; ++inputs) {
    const auto bit = [&](int i) { return (inputs >> i & 1) != 0; };
    bool value = bit(0) && bit(1);
    for (int i = 1; i < gates; ++i) value = i % 2 == 0 ? bit(i % 5) && !value : bit(i % 5) || !value;
    EXPECT_EQ(outputsFor(program, inputs) & 1, value ? 1 : 0) << inputs;
  }
}

// A drawing is as long as it likes: contacts in series are a string that bits of local memory cut.
TEST(Drawing7, AnyNumberOfContactsInSeries) {
  DrawnNet net;
  int before = -1;
  for (int i = 0; i < 20'000; ++i) {
    const int contact = net.part("Contact");
    net.in(i == 7 ? "M0.1" : "M0.0", contact, "operand");
    if (before >= 0) net.flow({before, "out"}, {{contact, "in"}});
    before = contact;
  }
  const int coil = net.part("Coil");
  net.flow({before, "out"}, {{coil, "in"}});
  net.in("Q4.0", coil, "operand");
  const Program program = drawnOb1(net);
  ASSERT_EQ(findings7(program), "");
  for (int inputs = 0; inputs < 4; ++inputs) EXPECT_EQ(outputsFor(program, inputs) & 1, inputs == 3 ? 1 : 0) << inputs;
}

// The number of pins is that of the wires, whatever the part says.
TEST(Drawing7, AGateSaysMorePinsThanItHas) {
  DrawnNet net;
  const int gate = net.part("O", typed("Card", "4000000000")), coil = net.part("Coil");
  net.in("M0.0", gate, "in1");
  net.flow({gate, "out"}, {{coil, "in"}});
  net.in("Q4.0", coil, "operand");
  EXPECT_NE(findings7(drawnOb1(net)).find("pin in2 is open"), std::string::npos);
}

// Random circuits of gates, contacts and negations whose results are read in several places, against their own values.
TEST(Drawing7, RandomCircuits) {
  constexpr int circuits = 200, trials = 16, coils = 3;
  for (unsigned seed = 1; seed <= circuits; ++seed) {
    std::mt19937 random(seed);
    const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
    struct Source {
      int node = -1;  ///< -1: the input bit
      int bit = 0;
      bool isNegated = false;
    };
    struct Gate {
      char kind = 'A';  ///< A, O, X; N: Not; C: a contact behind
      std::vector<Source> from;
      bool isNegated = false;  ///< of a contact's operand
      int id = 0;
    };
    std::vector<Gate> gates(static_cast<std::size_t>(4 + below(10)));
    DrawnNet net;
    std::map<int, std::vector<DrawnNet::End>> readers;  // by node
    for (std::size_t g = 0; g < gates.size(); ++g) {
      Gate& gate = gates[g];
      gate.kind = "AOXNC"[below(5)];
      const bool isGate = gate.kind == 'A' || gate.kind == 'O' || gate.kind == 'X';
      for (int i = isGate ? 2 + below(3) : 1; i > 0; --i) {
        Source source;
        source.node = g > 0 && below(3) > 0 ? below(static_cast<int>(g)) : -1;
        source.bit = below(8);
        source.isNegated = gate.kind != 'C' && below(3) == 0;
        gate.from.push_back(source);
      }
      gate.isNegated = gate.kind == 'C' && below(2) == 0;
      std::string inner = isGate ? typed("Card", std::to_string(gate.from.size())) : "";
      const auto pinOf = [&](std::size_t i) { return isGate ? fmt::format("in{}", i + 1) : std::string("in"); };
      for (std::size_t i = 0; i < gate.from.size(); ++i) inner += gate.from[i].isNegated ? negated(pinOf(i)) : "";
      if (gate.isNegated) inner += negated("operand");
      gate.id = net.part(gate.kind == 'N' ? "Not" : gate.kind == 'C' ? "Contact" : std::string(1, gate.kind), inner);
      for (std::size_t i = 0; i < gate.from.size(); ++i) {
        if (gate.from[i].node >= 0)
          readers[gate.from[i].node].emplace_back(gate.id, pinOf(i));
        else
          net.in(fmt::format("M0.{}", gate.from[i].bit), gate.id, pinOf(i));
      }
      if (gate.kind == 'C') net.in(fmt::format("M0.{}", gate.from[0].bit), gate.id, "operand");
    }
    std::vector<int> shown;
    for (int c = 0; c < coils; ++c) {
      shown.push_back(below(static_cast<int>(gates.size())));
      const int coil = net.part("Coil");
      net.in(fmt::format("Q4.{}", c), coil, "operand");
      readers[shown.back()].emplace_back(coil, "in");
    }
    for (const auto& [node, ends] : readers) net.flow({gates[static_cast<std::size_t>(node)].id, "out"}, ends);
    const Program program = drawnOb1(net);
    ASSERT_EQ(findings7(program), "") << "seed " << seed;
    for (int trial = 0; trial < trials; ++trial) {
      const int inputs = below(256);
      const auto bit = [&](int i) { return (inputs >> i & 1) != 0; };
      std::vector<bool> values;
      for (const Gate& gate : gates) {
        std::vector<bool> in;
        for (const Source& from : gate.from)
          in.push_back((from.node < 0 ? bit(from.bit) : values[static_cast<std::size_t>(from.node)]) != from.isNegated);
        const auto ones = std::count(in.begin(), in.end(), true);
        const bool value = gate.kind == 'A'   ? ones == static_cast<std::ptrdiff_t>(in.size())
                           : gate.kind == 'O' ? ones > 0
                           : gate.kind == 'X' ? ones % 2 == 1
                           : gate.kind == 'N' ? !in[0]
                                              : in[0] && bit(gate.from[0].bit) != gate.isNegated;
        values.push_back(value);
      }
      Simulator simulator(program);
      simulator.write(direct(Area::M, Width::Byte, 0), static_cast<std::uint64_t>(inputs));
      simulator.scan();
      ASSERT_TRUE(simulator.isRunning()) << "seed " << seed;
      for (int c = 0; c < coils; ++c)
        EXPECT_EQ(simulator.read(direct(Area::Q, Width::Bit, 4, static_cast<unsigned>(c))) != 0,
                  values[static_cast<std::size_t>(shown[static_cast<std::size_t>(c)])])
            << "seed " << seed << " inputs " << inputs << " coil " << c;
    }
  }
}

// While each result is in range ENO hands 1 to the next box (003:799): the second is not executed after an overflow.
TEST(Drawing7, BoxesHandTheFlowOn) {
  DrawnNet net;
  const int add = net.part("Add", typed("SrcType", "Int")), move = net.part("Move"), coil = net.part("Coil");
  net.in("M0.0", add, "en");
  net.in("MW10", add, "in1");
  net.in("20000:Int", add, "in2");
  net.out(add, "out", "MW12");
  net.flow({add, "eno"}, {{move, "en"}});
  net.in("7:Int", move, "in");
  net.out(move, "out1", "MW14");
  net.flow({move, "eno"}, {{coil, "in"}});
  net.in("Q4.0", coil, "operand");
  const Program program = drawnOb1(net);
  ASSERT_EQ(findings7(program), "");
  const auto run = [&](int enabled, int first) {
    Simulator simulator(program);
    simulator.write(direct(Area::M, Width::Bit, 0), static_cast<std::uint64_t>(enabled));
    simulator.write(direct(Area::M, Width::Word, 10), static_cast<std::uint64_t>(first));
    simulator.scan();
    return fmt::format("{} {} {}", simulator.read(direct(Area::M, Width::Word, 12)),
                       simulator.read(direct(Area::M, Width::Word, 14)),
                       simulator.read(direct(Area::Q, Width::Bit, 4)));
  };
  EXPECT_EQ(run(0, 1), "0 0 0");
  EXPECT_EQ(run(1, 1), "20001 7 1");
  EXPECT_EQ(run(1, 20000), "40000 0 0");  // the wrapped sum is written
}

const std::string addOne =
    drawnBlock("FC", "AddOne", 5,
               section("Input", member("on", "Bool") + member("x", "Int")) + section("Output", member("y", "Int")), [] {
                 DrawnNet net;
                 const int add = net.part("Add", typed("SrcType", "Int"));
                 net.in("#on", add, "en");
                 net.in("#x", add, "in1");
                 net.in("1:Int", add, "in2");
                 net.out(add, "out", "#y");
                 return unit(net.text());
               }());

// A call whose BOOL parameter comes from a gate, and a call of a block that a source defines; its number is that of the
// drawing.
TEST(Drawing7, CallsWithParameters) {
  DrawnNet net;
  const int gate = net.part("A", typed("Card", "2"));
  const int call = net.call("<CallInfo Name=\"AddOne\" BlockType=\"FC\"/>");
  net.in("M0.0", gate, "in1");
  net.in("M0.1", gate, "in2");
  net.flow({gate, "out"}, {{call, "on"}});
  net.in("MW10", call, "x");
  net.out(call, "y", "MW12");
  const Program program = readDrawn(addOne + drawnBlock("OB", "Main", 1, "", unit(net.text())));
  ASSERT_EQ(findings7(program), "");
  for (int inputs = 0; inputs < 4; ++inputs) {
    Simulator simulator(program);
    simulator.write(direct(Area::M, Width::Byte, 0), static_cast<std::uint64_t>(inputs));
    simulator.write(direct(Area::M, Width::Word, 10), 41);
    simulator.scan();
    EXPECT_EQ(simulator.read(direct(Area::M, Width::Word, 12)), inputs == 3 ? 42U : 0U) << inputs;
  }
}

// An FB with a static value and an IEC timer as a multi-instance; its instance is a data block of the project, whose
// start value counts. 10 ms a scan: TON of 30 ms is on three scans after the one in which it starts.
TEST(Drawing7, InstancesAndIecTimers) {
  DrawnNet body;
  const int timer = body.part("TON", typed("time_type", "Time") + instanceText("#delay"));
  const int coil = body.part("Coil");
  body.in("#on", timer, "IN");
  body.in("T#30ms:Time", timer, "PT");
  body.flow({timer, "Q"}, {{coil, "in"}});
  body.in("#late", coil, "operand");
  const std::string fb =
      drawnBlock("FB", "Late", 2,
                 section("Input", member("on", "Bool")) + section("Output", member("late", "Bool")) +
                     section("Static", member("delay", "TON") + member("limit", "Int", "<StartValue>5</StartValue>")),
                 unit(body.text()));
  const std::string instance =
      drawnBlock("InstanceDB", "LateDb", 20, section("Static", member("limit", "Int", "<StartValue>9</StartValue>")),
                 "", "<InstanceOfName>Late</InstanceOfName>");
  DrawnNet net;
  const int call = net.call("<CallInfo Name=\"Late\" BlockType=\"FB\">" + instanceText("\"LateDb\"") + "</CallInfo>");
  net.in("I0.0", call, "on");
  net.out(call, "late", "Q4.0");
  const Program program = readDrawn(fb + instance + drawnBlock("OB", "Main", 1, "", unit(net.text())));
  ASSERT_EQ(findings7(program), "");
  Simulator simulator(program);
  EXPECT_EQ(simulator.read(*step7::placeNamed(program, "\"LateDb\".limit")), 9U);
  simulator.write(*step7::placeNamed(program, "I0.0"), 1);
  std::string seen;
  for (int scan = 0; scan < 5; ++scan) {
    simulator.scan();
    seen += simulator.read(direct(Area::Q, Width::Bit, 4)) != 0 ? '1' : '0';
  }
  EXPECT_EQ(seen, "00011");
}

// Sections, arrays, structures, types of their own and start values give the layout of the machine's rules: bits
// packed, words at even bytes.
TEST(Drawing7, DataBlocksAndTypes) {
  const std::string udt = "<SW.Types.PlcStruct ID=\"1\"><AttributeList><Interface><Sections>" +
                          section("None", member("speed", "Int", "<StartValue>3</StartValue>") + member("on", "Bool")) +
                          "</Sections></Interface><Name>Drive</Name></AttributeList></SW.Types.PlcStruct>";
  const std::string data = drawnBlock(
      "GlobalDB", "Data", 10,
      section("Static",
              member("first", "Bool") + member("list", "Array[1..3] of Int") + member("drive", "&quot;Drive&quot;") +
                  member("inner", "Struct", member("a", "Bool") + member("b", "Real", "<StartValue>1.5</StartValue>"))),
      "");
  DrawnNet net;
  const int move = net.part("Move");
  net.in("\"Data.drive.speed\"", move, "in");
  net.out(move, "out1", "MW0");
  const Program program = readDrawn(udt + data + drawnBlock("OB", "Main", 1, "", unit(net.text())));
  ASSERT_EQ(findings7(program), "");
  const std::pair<const char*, const char*> places[] = {
      {"Data.first", "DB10.DBX0.0"},     {"Data.list[1]", "DB10.DBW2"},     {"Data.list[3]", "DB10.DBW6"},
      {"Data.drive.speed", "DB10.DBW8"}, {"Data.drive.on", "DB10.DBX10.0"}, {"Data.inner.a", "DB10.DBX12.0"},
      {"Data.inner.b", "DB10.DBD14"}};
  for (const auto& [name, address] : places) {
    ASSERT_TRUE(step7::placeNamed(program, name)) << name;
    EXPECT_EQ(show7(*step7::placeNamed(program, name)), show7(*step7::placeNamed(program, address))) << name;
  }
  Simulator simulator(program);
  EXPECT_EQ(simulator.read(*step7::placeNamed(program, "Data.inner.b")), 0x3FC00000U);
  simulator.scan();
  EXPECT_EQ(simulator.read(direct(Area::M, Width::Word, 0)), 3U);
}

// A block is NON_RETAIN where all its members are marked so; one that is not keeps the whole. Write protection and
// blocks that stay in the load memory are attributes of the block.
TEST(Drawing7, AttributesOfDataBlocks) {
  const std::string lost = "<Member Name=\"a\" Datatype=\"Int\" Remanence=\"NonRetain\"/>";
  const std::string kept = "<Member Name=\"b\" Datatype=\"Int\" Remanence=\"Retain\"/>", plain = member("c", "Int");
  const auto blockOf = [](const std::string& members, const std::string& more = "") {
    return readDrawn(drawnBlock("GlobalDB", "Data", 10, section("Static", members), "", more)).dataBlocks.at(0);
  };
  EXPECT_TRUE(blockOf(lost).nonRetain);
  for (const std::string& members : {kept, plain, lost + kept, lost + plain}) EXPECT_FALSE(blockOf(members).nonRetain);
  EXPECT_FALSE(blockOf(plain).readOnly || blockOf(plain).unlinked);
  EXPECT_TRUE(blockOf(plain, "<IsWriteProtectedInAS>true</IsWriteProtectedInAS>").readOnly);
  EXPECT_TRUE(blockOf(plain, "<IsOnlyStoredInLoadMemory>true</IsOnlyStoredInLoadMemory>").unlinked);
}

// What several wires leave and a flip-flop inside a gate: the compiler's order of evaluation. M2.0 is read in front of
// the flip-flop that sets it, as it stands in the first input.
TEST(Drawing7, FlipFlopsInsideGates) {
  DrawnNet net;
  const int gate = net.part("A", typed("Card", "2") + negated("in1")), flipFlop = net.part("Sr"),
            coil = net.part("Coil");
  net.in("M2.0", gate, "in1");
  net.in("M0.0", flipFlop, "s");
  net.in("M0.1", flipFlop, "r1");
  net.in("M2.0", flipFlop, "operand");
  net.flow({flipFlop, "q"}, {{gate, "in2"}});
  net.flow({gate, "out"}, {{coil, "in"}});
  net.in("Q4.0", coil, "operand");
  const Program program = drawnOb1(net);
  EXPECT_EQ(statementsOf(program), written("AN M2.0; A(; A M0.0; S M2.0; A M0.1; R M2.0; A M2.0; ); = Q4.0;"));
}

struct WrongNet {
  std::string parts, wires, message;
};

TEST(Drawing7, WhatIsNotKnownIsNamed) {
  const auto broken = [](const std::string& net) {
    return findings7(readDrawn(drawnBlock("OB", "Main", 1, "", unit(net))));
  };
  const auto partNet = [](const std::string& name, const std::string& inner, const std::vector<std::string>& pins) {
    DrawnNet net;
    const int part = net.part(name, inner);
    for (const std::string& pin : pins) net.in("M0.0", part, pin);
    return net.text();
  };
  EXPECT_NE(broken(partNet("Peek", "", {})).find("part Peek is not covered"), std::string::npos);
  EXPECT_NE(broken(partNet("Add", typed("SrcType", "LReal"), {})).find("type LReal is not covered"), std::string::npos);
  EXPECT_NE(broken(partNet("Add", typed("SrcType", "Int") + typed("Card", "3"), {"in1", "in2"})).find("more than two"),
            std::string::npos);
  EXPECT_NE(broken(partNet("Add", typed("SrcType", "Int"), {"in1"})).find("pin in2 is open"), std::string::npos);
  EXPECT_NE(broken(partNet("Coil", "", {"in", "operand", "speed"})).find("pin speed is not covered"),
            std::string::npos);
  EXPECT_NE(broken(partNet("Coil", negated("bit"), {"in", "operand"})).find("negation stands at bit"),
            std::string::npos);
  EXPECT_NE(broken(partNet("S_ODT", "", {"s", "tv"})).find("no instance"), std::string::npos);
  DrawnNet second;
  const int move = second.part("Move");
  second.in("MW0", move, "in");
  second.out(move, "out2", "MW2");
  EXPECT_NE(broken(second.text()).find("output out2 is not covered"), std::string::npos);
  EXPECT_NE(broken("<FlgNet><Parts/><Wires><Wire Color=\"red\"/></Wires></FlgNet>").find("Color"), std::string::npos);
  EXPECT_NE(broken("<FlgNet><Parts/><Wires><Wire><Powerrail/><NameCon UId=\"7\" Name=\"in\"/></Wire></Wires></FlgNet>")
                .find("does not exist"),
            std::string::npos);
  DrawnNet loop;
  const int one = loop.part("A", typed("Card", "2")), two = loop.part("A", typed("Card", "2"));
  loop.flow({one, "out"}, {{two, "in1"}});
  loop.flow({two, "out"}, {{one, "in1"}});
  loop.in("M0.0", one, "in2");
  loop.in("M0.0", two, "in2");
  EXPECT_NE(broken(loop.text()).find("comes from itself"), std::string::npos);
  EXPECT_NE(broken("<StructuredText/>").find("is not covered"), std::string::npos);
}

// Q4.0 is written in a network that cannot be read, Q4.1 in one that can.
TEST(Drawing7, NothingRestsOnWhatIsNotRead) {
  DrawnNet unknown, plain;
  const int odd = unknown.part("Peek"), coil = plain.part("Coil");
  unknown.in("M0.0", odd, "in");
  unknown.out(odd, "out", "Q4.0");
  plain.in("I0.0", coil, "in");
  plain.in("Q4.1", coil, "operand");
  const test::TemporaryFolder folder;
  folder.file("main.xml", drawnDocument(drawnBlock("OB", "Main", 1, "", unit(unknown.text()) + unit(plain.text()))));
  folder.file("main.prop", "prove odd: not Q4.0\nprove plain: Q4.1 = I0.0\n");
  const test7::Output output = test7::run({"prove", folder.path("main.xml"), "--props", folder.path("main.prop")});
  EXPECT_TRUE(output.has("NOT COVERED  odd") && !output.has("PROVED  odd")) << output.text;
}

// A drawing beside a source of the family belongs to it, whatever the order; an interlock over both is proved, and the
// drawing is shown as one.
TEST(Drawing7, SourcesAndDrawingsAreOneProject) {
  DrawnNet net;
  const int gate = net.part("A", typed("Card", "2") + negated("in2")), coil = net.part("Coil");
  net.in("I0.0", gate, "in1");
  net.in("I0.1", gate, "in2");
  net.flow({gate, "out"}, {{coil, "in"}});
  net.in("Q0.0", coil, "operand");
  const test::TemporaryFolder folder;
  folder.file("drawn.xml", drawnDocument(drawnBlock("FC", "Forward", 7, "", unit(net.text()))));
  folder.file("main.awl",
              "ORGANIZATION_BLOCK OB 1\n//@ prove apart: never Q0.0 and Q0.1\nBEGIN\nNETWORK\nCALL FC 7;\nA I 0.1;\n"
              "AN I 0.0;\n= Q 0.1;\nEND_ORGANIZATION_BLOCK\n");
  for (const auto& files : {std::vector{"drawn.xml", "main.awl"}, std::vector{"main.awl", "drawn.xml"}}) {
    std::istringstream in;
    std::ostringstream out, err;
    runProgram({"prove", folder.path(files[0]), folder.path(files[1]), "--isolated"}, {in, out, err});
    EXPECT_NE(out.str().find("PROVED  apart"), std::string::npos) << out.str() << err.str();
  }
  const test7::Output shown = test7::run({"show", folder.path("drawn.xml"), "--as", "fbd"});
  EXPECT_TRUE(shown.has("AND") && shown.has("I0.1 ───o│") && shown.has("Q0.0")) << shown.text;
}

}  // namespace
}  // namespace rungproof
