// Variables of IEC 61131-3 by their place: the whole of a byte, the outputs of a program.
#include "ir/iec/variables.hpp"

#include "tests/iec/iec_run.hpp"

namespace rungproof {
namespace {

Operand placeOf(const Program& program, std::string_view name) {
  const Symbol* const symbol = program.symbolNamed(name);
  EXPECT_NE(symbol, nullptr) << name;
  return symbol == nullptr ? Operand() : symbol->address;
}

TEST(VariablesByPlace, AByteBelongsToItsVariable) {
  const Program program = readIecText("PROGRAM P\nVAR_OUTPUT Level : DINT; END_VAR\nLevel := 1;\nEND_PROGRAM\n");
  const Operand whole = placeOf(program, "Level");
  Operand third = whole;
  third.offset += 2;
  third.width = Width::Byte;
  EXPECT_EQ(toString(wholeVariable(program, third)), toString(whole));
  third.offset = whole.offset + 4;  // a DINT has four bytes
  EXPECT_FALSE(coversByte(whole, third));
}

TEST(VariablesByPlace, OutputsArePartsToo) {
  const Program program = readIecText(
      "TYPE Drive : STRUCT Run : BOOL; Speed : INT; END_STRUCT; END_TYPE\n"
      "PROGRAM P\nVAR_INPUT Go : BOOL; END_VAR\nVAR_OUTPUT Fan : Drive; Lamps : ARRAY[1..2] OF BOOL; END_VAR\n"
      "VAR Fanning, Kept : BOOL; Valve AT %QX0.1 : BOOL; END_VAR\n"
      "Fan.Run := Go; Fanning := Go; Kept := Fanning; Valve := Kept; Lamps[2] := Go;\nEND_PROGRAM\n");
  const ProgramOutputs outputs(program);
  for (const std::string_view name : {"Fan.Run", "Fan.Speed", "Lamps[1]", "Lamps[2]", "Valve"})
    EXPECT_TRUE(outputs.contains(placeOf(program, name))) << name;
  for (const std::string_view name : {"Go", "Fanning", "Kept"})
    EXPECT_FALSE(outputs.contains(placeOf(program, name))) << name;
}

TEST(VariablesByPlace, OutputsOfABlockAreNotThoseOfTheProgram) {
  const Program program = readIecText(
      "FUNCTION_BLOCK Pump\nVAR_OUTPUT Runs : BOOL; END_VAR\nRuns := TRUE;\nEND_FUNCTION_BLOCK\n"
      "PROGRAM P\nVAR_OUTPUT Lamp : BOOL; END_VAR\nVAR First : Pump; END_VAR\nFirst(); Lamp := First.Runs;\n"
      "END_PROGRAM\n");
  const ProgramOutputs outputs(program);
  EXPECT_TRUE(outputs.contains(placeOf(program, "Lamp")));
  EXPECT_FALSE(outputs.contains(placeOf(program, "First.Runs")));
}

// The program has the name of its output: its other variables are no parts of that.
TEST(VariablesByPlace, AProgramMayBeNamedLikeItsOutput) {
  const std::string body =
      "PROGRAM Pump\nVAR_INPUT Go : BOOL; END_VAR\nVAR_OUTPUT pump : BOOL; END_VAR\n"
      "VAR Kept : BOOL; END_VAR\nKept := Go; pump := Kept;\nEND_PROGRAM\n";
  const std::string run = "CONFIGURATION c RESOURCE r ON PLC PROGRAM pump : Pump; END_RESOURCE END_CONFIGURATION\n";
  for (const std::string& text : {body, body + run}) {
    const Program program = readIecText(text);
    const Operands outputs = outputVariables(program);
    ASSERT_EQ(outputs.size(), 1U);
    EXPECT_EQ(outputs[0].offset, placeOf(program, "pump").offset);
  }
}

TEST(VariablesByPlace, AnAddressIsANameWithItsSignOrWithout) {
  const Program program = readIecText("PROGRAM P\nVAR Valve AT %QX0.1 : BOOL; END_VAR\nValve := TRUE;\nEND_PROGRAM\n");
  const OperandLookup lookup = lookupIn(program);
  for (const std::string_view name : {"%QX0.1", "QX0.1", "%Q0.1", "%qx0.1", "valve"}) {
    const std::optional<Operand> found = lookup(name);
    ASSERT_TRUE(found.has_value()) << name;
    EXPECT_EQ(toString(*found), toString(placeOf(program, "Valve"))) << name;
  }
  EXPECT_FALSE(lookup("%QX0.2").has_value());
}

TEST(VariablesByPlace, EachOutputIsListedOnce) {  // under its name and under its address it is one place
  const Program program = readIecText(
      "PROGRAM P\nVAR_OUTPUT Lamp : BOOL; END_VAR\nVAR Valve AT %QX0.1 : BOOL; Kept : BOOL; END_VAR\n"
      "Valve := Kept; Lamp := Kept;\nEND_PROGRAM\n");
  EXPECT_EQ(outputVariables(program).size(), 2U);
}

}  // namespace
}  // namespace rungproof
