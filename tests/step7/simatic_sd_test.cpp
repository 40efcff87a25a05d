// Documents of TIA Portal as text (.s7dcl): rungs, wires, boxes, calls, titles out of the texts beside them. Meanings
// are those of the ladder that they draw.
#include "tests/step7/run7.hpp"

namespace rungproof {
namespace {

using test7::Output;

/// An OB 1 as a document, with networks in that language.
std::string document(const std::string& networks, const std::string& language = "LAD") {
  return "\xEF\xBB\xBF{ S7_BlockNumber := \"1\"; S7_Optimized := \"TRUE\"; S7_PreferredLanguage := \"LAD\" }\n"
         "ORGANIZATION_BLOCK \"Main\"\n  VAR_TEMP\n    { S7_Setpoint := \"False\" }\n    n : Int;\n  END_VAR\n\n"
         "  { S7_Language := \"" +
         language + "\"; S7_NetworkTitle := \"MLC_3fA\" }\n  NETWORK\n" + networks +
         "\n  END_NETWORK\nEND_ORGANIZATION_BLOCK\n";
}

class SimaticSd : public ::testing::Test {
 protected:
  Output run(const std::string& text, std::vector<std::string> command, const std::string& properties = "") {
    folder_.file("Main.s7dcl", text);
    command.insert(command.begin() + 1, folder_.path("Main.s7dcl"));
    if (!properties.empty()) {
      folder_.file("p.prop", properties);
      command.insert(command.end(), {"--props", folder_.path("p.prop")});
    }
    return test7::run(command);
  }
  void proves(const std::string& networks, const std::string& properties, const std::string& language = "LAD") {
    const Output output = run(document(networks, language), {"prove"}, properties);
    EXPECT_EQ(output.exit, 0) << output.text;
  }
  void finds(const std::string& networks, const std::string& message, const std::string& language = "LAD") {
    const Output output = run(document(networks, language), {"lint"});
    EXPECT_TRUE(output.has(message)) << output.text;
  }
  test::TemporaryFolder folder_;
};

// m := (a OR m) AND NOT stop.
TEST_F(SimaticSd, WiresAreOred) {
  proves(
      "RUNG wire#powerrail Contact( %I0.0 ) wire#w1 I_Contact( %I0.1 ) Coil( %Q0.0 ) END_RUNG\n"
      "RUNG wire#powerrail Contact( %Q0.0 ) END_RUNG wire#w1",
      "prove stop: I0.1 implies not Q0.0\nprove set: I0.0 and not I0.1 implies Q0.0\n"
      "prove hold: prev(Q0.0) and not I0.1 implies Q0.0\nreach on: Q0.0 and not I0.0\n");
}

// Three rungs end in one wire, from which another one begins; a rung that begins at a wire runs behind what feeds it.
TEST_F(SimaticSd, RungsBeginAtWires) {
  proves(
      "RUNG wire#powerrail Contact( %I0.0 ) END_RUNG wire#a\nRUNG wire#a Coil( %Q0.0 ) END_RUNG\n"
      "RUNG wire#powerrail Contact( %I0.1 ) END_RUNG wire#a\nRUNG wire#powerrail Contact( %I0.2 ) END_RUNG wire#a\n"
      "RUNG wire#a I_Contact( %I0.3 ) Coil( %Q0.1 ) END_RUNG",
      "prove all: Q0.0 = (I0.0 or I0.1 or I0.2)\nprove rest: Q0.1 = ((I0.0 or I0.1 or I0.2) and not I0.3)\n");
}

TEST_F(SimaticSd, EdgesAndInversion) {
  proves(
      "RUNG wire#powerrail P_Contact( operand := %I0.0, bit := %M0.0 ) Coil( %Q0.0 ) END_RUNG\n"
      "RUNG wire#powerrail Contact( %I0.1 ) Not( ) Coil( %Q0.1 ) END_RUNG\n"
      "RUNG wire#powerrail Contact( %I0.2 ) S_Coil( %Q0.2 ) END_RUNG\n"
      "RUNG wire#powerrail Contact( %I0.3 ) R_Coil( %Q0.2 ) I_Coil( %Q0.3 ) END_RUNG",
      "prove edge: Q0.0 and not first_scan implies I0.0 and not prev(I0.0)\nprove inverse: Q0.1 = not I0.1\n"
      "prove reset: I0.3 implies not Q0.2\nprove set: I0.2 and not I0.3 implies Q0.2\nprove coil: Q0.3 = not I0.3\n");
}

// Statements of SCL beside drawn networks.
TEST_F(SimaticSd, StructuredText) {
  proves(
      "IF %I0.0 AND NOT %I0.1 THEN %Q0.0 := TRUE; ELSE %Q0.0 := FALSE; END_IF;\n#n := 3; %QB4 := INT_TO_BYTE(#n * 2);"
      "\n  END_NETWORK\n  { S7_Language := \"LAD\" }\n  NETWORK\n"
      "RUNG wire#powerrail Contact( %Q0.0 ) Coil( %Q0.1 ) END_RUNG",
      "prove value: Q0.0 = (I0.0 and not I0.1)\nprove next: Q0.1 = Q0.0\nprove six: QB4 = 6\n", "SCL");
}

// FBD: t := (a AND NOT b) OR c; q := t; IF t THEN r := TRUE.
TEST_F(SimaticSd, FunctionBlockDiagram) {
  proves(
      "RUNG %I0.0 A( in2 := NOT %I0.1 ) O( in2 := %I0.2 ) Coil( %Q0.0 ) S_Coil( %Q0.1 ) END_RUNG\n"
      "RUNG NOT %I0.3 NOT X( in2 := %I0.4 ) Coil( %Q0.2 ) END_RUNG",
      "prove value: Q0.0 = ((I0.0 and not I0.1) or I0.2)\nprove set: Q0.0 implies Q0.1\n"
      "prove x: Q0.2 = (not I0.3 = I0.4)\n",
      "FBD");
}

// Without S7_GenerateENO the flow passes a box as it came; with it, an overflow stops it.
TEST_F(SimaticSd, BoxesAndTheirFlow) {
  const std::string add = "Add( in1 := #n, in2 := 1, out => %MW10 )";
  proves("RUNG wire#powerrail Contact( %I0.0 ) Move( in := %IW2, out1 => #n ) " + add + " Coil( %Q0.0 ) END_RUNG\n",
         "prove flow: Q0.0 = I0.0\nprove sum: I0.0 and IW2 < 100 and IW2 >= 0 implies MW10 = IW2 + 1\n");
  proves("RUNG wire#powerrail Contact( %I0.0 ) Move( in := %IW2, out1 => #n ) { S7_GenerateENO := \"TRUE\" } " + add +
             " Coil( %Q0.0 ) END_RUNG\n",
         "prove overflow: IW2 == 32767 implies not Q0.0\nreach flow: Q0.0\n");
}

TEST_F(SimaticSd, ComparisonsTakeTheirType) {
  proves(
      "RUNG wire#powerrail Contact( %I0.0 ) Move( in := %IW2, out1 => #n ) END_RUNG\n"
      "RUNG wire#powerrail Contact( %I0.0 ) GT_Contact( in1 := #n, in2 := 5 ) Coil( %Q0.0 ) END_RUNG\n"
      "RUNG wire#powerrail { S7_Templates := \"SrcType := Int\" } LE_Contact( in1 := %IW2, in2 := 5 ) Coil( %Q0.1 ) "
      "END_RUNG",
      "prove greater: Q0.0 implies I0.0 and IW2 > 5\nprove less: Q0.1 = (IW2 <= 5)\n");
  finds("RUNG wire#powerrail EQ_Contact( in1 := %IW2, in2 := 5 ) Coil( %Q0.1 ) END_RUNG",
        "part EQ_Contact with type none is not covered");
}

// A block with a timer of its own: Q never within 2 s of its input, of which scan ends see up to two scans less, and a
// call of it by its data block.
TEST_F(SimaticSd, TimersAndCalls) {
  folder_.file("Delay.s7dcl",
               "{ S7_BlockNumber := \"5\"; S7_PreferredLanguage := \"LAD\" }\nFUNCTION_BLOCK \"Delay\"\n"
               "  VAR_INPUT\n    \"go\" : Bool;\n  END_VAR\n  VAR_OUTPUT\n    done : Bool;\n  END_VAR\n"
               "  VAR\n    t : TON_TIME;\n  END_VAR\n\n  { S7_Language := \"LAD\" }\n  NETWORK\n"
               "    RUNG wire#powerrail Contact( #\"go\" ) { S7_Templates := \"time_type := Time\" } "
               "#t.TON( pt := T#2s, et => ) Coil( #done ) END_RUNG\n  END_NETWORK\nEND_FUNCTION_BLOCK\n");
  folder_.file("Delay_1.db",
               "DATA_BLOCK \"Delay_1\"\n{ S7_Optimized_Access := 'FALSE' }\nVERSION : 0.1\n\"Delay\"\n"
               "BEGIN\nEND_DATA_BLOCK\n");
  folder_.file("Main.s7dcl", document("RUNG wire#powerrail \"Delay_1\"( \"go\" := %I0.0, done => %Q0.0 ) END_RUNG"));
  folder_.file("p.prop",
               "prove on: Q0.0 implies held(I0.0, 1700ms)\n"
               "reach done: Q0.0\n");
  const Output output = test7::run({"prove", folder_.path(""), "--props", folder_.path("p.prop")});
  EXPECT_TRUE(output.has("PROVED  on")) << output.text;
  EXPECT_TRUE(output.has("REACHABLE  done")) << output.text;
}

TEST_F(SimaticSd, TitlesComeFromTheTextsBeside) {
  folder_.file("Main.s7res", "MultiLingualTexts:\n  - id: MLC_3fA\n    de-DE: Halten\n    en-US: 'Operator''s hold'\n");
  const std::string text = document("RUNG wire#powerrail Contact( %I0.0 ) Coil( %Q0.0 ) END_RUNG");
  EXPECT_TRUE(run(text, {"show"}).has("Network 1  Operator's hold"));
  folder_.file("Main.s7res", "MultiLingualTexts:\n");
  EXPECT_TRUE(run(text, {"show"}).has("Network 1  MLC_3fA"));
}

// What is not read is said at its place, and the rest is read.
TEST_F(SimaticSd, WhatIsNotCoveredIsSaid) {
  finds("#n := 1.5;", "1.5 is REAL, and INT is needed here", "SCL");
  finds("RUNG wire#powerrail Contact( %I0.0 ) %M0.0.S_RS( wire#w ) END_RUNG", "S_RS");
  finds("RUNG wire#powerrail Calculate( in1 := #n, out => #n ) END_RUNG", "part Calculate is not covered");
  finds("RUNG wire#w1 Coil( %Q0.0 ) END_RUNG", "nothing flows into wire#w1");
  finds("RUNG wire#powerrail Contact( %I0.0 Coil( %Q0.0 ) END_RUNG", "the closing parenthesis is missing");
  finds("RUNG wire#powerrail Coil( %Q0.0 )", "END_RUNG is missing");
  finds("RUNG wire#powerrail Nobody( x := 1 ) END_RUNG", "Nobody");
  const Output output = run(document("RUNG wire#powerrail Calculate( in1 := #n, out => #n ) END_RUNG\n  END_NETWORK\n"
                                     "  { S7_Language := \"LAD\" }\n  NETWORK\n"
                                     "RUNG wire#powerrail Contact( %I0.0 ) Coil( %Q0.0 ) END_RUNG"),
                            {"show", "--as", "stl"});
  EXPECT_TRUE(output.has("Network 2")) << output.text;
}

}  // namespace
}  // namespace rungproof
