// The cross reference of an instance: what the function block does with its own data stands at the places of its
// instances, also inside of others.
#include "tests/step7/run7.hpp"

namespace rungproof {
namespace {

using test7::Output;

Output xrefOf(const std::string& text, const std::string& address) {
  const test::TemporaryFolder folder;
  folder.file("main.awl", text);
  return test7::run({"xref", folder.path("main.awl"), address});
}

const std::string countingMotor =
    "FUNCTION_BLOCK FB 1\nVAR_INPUT\n start : BOOL;\nEND_VAR\nVAR_OUTPUT\n run : BOOL;\nEND_VAR\nVAR\n n : "
    "INT;\nEND_VAR\n"
    "BEGIN\nNETWORK\n A #start;\n = #run;\nNETWORK\n L #n;\n L 1;\n +I;\n T #n;\nEND_FUNCTION_BLOCK\n";

// start lies at 0.0, run at 2.0, n at 4.
TEST(InstanceXref, OfAnInstance) {
  const std::string text = countingMotor + "DATA_BLOCK DB 30\nFB 1\nBEGIN\nEND_DATA_BLOCK\n" +
                           test7::block(1, "CALL FB 1, DB 30 (start := I 0.0);A DB30.DBX 2.0;= Q 0.0");
  const Output run = xrefOf(text, "DB30.DBX2.0");
  EXPECT_TRUE(run.has("FB1, network 1: = #run")) << run.text;
  EXPECT_TRUE(run.has("OB1, network 1: A DB30.DBX2.0")) << run.text;
  EXPECT_FALSE(run.has("Through pointers")) << run.text;
  const Output count = xrefOf(text, "DB30.DBW4");
  EXPECT_TRUE(count.has("FB1, network 2: L #n")) << count.text;
  EXPECT_TRUE(count.has("FB1, network 2: T #n")) << count.text;
}

// Two of them in FB 2, behind its own INT: the second begins at byte 8, its n lies at 12.
TEST(InstanceXref, OfAnInstanceInside) {
  const std::string text =
      countingMotor +
      "FUNCTION_BLOCK FB 2\nVAR\n own : INT;\n a : FB 1;\n b : FB 1;\nEND_VAR\nBEGIN\nNETWORK\n CALL #a;\n CALL #b;\n"
      "END_FUNCTION_BLOCK\nDATA_BLOCK DB 31\nFB 2\nBEGIN\nEND_DATA_BLOCK\n" +
      test7::block(1, "CALL FB 2, DB 31;L DB31.DBW 12;T QW 0");
  const Output count = xrefOf(text, "DB31.DBW12");
  EXPECT_TRUE(count.has("FB1, network 2: T #n")) << count.text;
  EXPECT_TRUE(count.has("OB1, network 1: L DB31.DBW12")) << count.text;
  EXPECT_FALSE(xrefOf(text, "DB31.DBW0").has("FB1")) << count.text;
}

// Where the block has opened another one in DI, own data may be anywhere.
TEST(InstanceXref, NotWhereTheBlockHasMoved) {
  std::string text = countingMotor + "DATA_BLOCK DB 30\nFB 1\nBEGIN\nEND_DATA_BLOCK\n" +
                     test7::block(1, "CALL FB 1, DB 30 (start := I 0.0);A DB30.DBX 2.0;= Q 0.0");
  text.replace(text.find(" L #n"), 5, " OPN DI 30;\n L #n");
  const Output count = xrefOf(text, "DB30.DBW4");
  EXPECT_TRUE(count.has("Through pointers")) << count.text;
}

}  // namespace
}  // namespace rungproof
