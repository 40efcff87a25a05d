// What a CALL leaves in the registers of its caller (spec of the B stack, 002:222, and general knowledge).
#include "proved_text.hpp"

namespace rungproof::test {
namespace {

/// `call`: behind OPN DB 1 in OB1; DB1.DBX0.0 is 0 and DB2.DBX0.0 is 1.
Outcome outcomeBehind(const std::string& call) {
  const std::string data = " STRUCT a : BOOL := %; w : WORD; END_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n";
  const auto block = [&](const std::string& number, const std::string& bit) {
    return "DATA_BLOCK DB " + number + data.substr(0, data.find('%')) + bit + data.substr(data.find('%') + 1);
  };
  ProgramInput input;
  input.program = readText(
      "test.awl", block("1", "FALSE") + block("2", "TRUE") +
                      "FUNCTION FC 1 : VOID\nVAR_INPUT x : WORD; END_VAR\nBEGIN\nNETWORK\nNOP 0;\nEND_FUNCTION\n"
                      "FUNCTION_BLOCK FB 1\nVAR_OUTPUT y : WORD; END_VAR\nBEGIN\nNETWORK\nNOP 0;\nEND_FUNCTION_BLOCK\n"
                      "DATA_BLOCK DB 3 FB 1\nBEGIN\nEND_DATA_BLOCK\n"
                      "ORGANIZATION_BLOCK OB 1\n//@ prove first: not Q0.0\nBEGIN\nNETWORK\nOPN DB 1;\n" +
                      call + "\nA DBX 0.0;\n= Q 0.0;\nEND_ORGANIZATION_BLOCK\n");
  input.properties = readProperties(input.program, {}, lookupIn(input.program));
  for (const Finding& finding : input.program.findings) EXPECT_NE(finding.severity, Severity::Error) << finding.message;
  return outcomeOf(prove(input.program, input.properties, usualOptions()), "first");
}

// A full address as actual parameter may leave its block open: nothing is proved by the block that was open before.
TEST(Step7Call, FullAddressesMayOpenTheirBlockInTheCaller) {
  EXPECT_EQ(outcomeBehind("CALL FC 1 (x := MW 10);"), Outcome::Proved);
  EXPECT_EQ(outcomeBehind("CALL FC 1 (x := DB1.DBW 2);"), Outcome::Proved);
  EXPECT_EQ(outcomeBehind("CALL FC 1 (x := DB2.DBW 2);"), Outcome::Violated);
  EXPECT_EQ(outcomeBehind("CALL FB 1, DB 3 (y := MW 10);"), Outcome::Proved);
  EXPECT_EQ(outcomeBehind("CALL FB 1, DB 3 (y := DB2.DBW 2);"), Outcome::Violated);
}

}  // namespace
}  // namespace rungproof::test
