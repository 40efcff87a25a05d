// Outputs of an FC that the block does not write: the actual keeps its value, as it is given by reference (002:154), or
// gets any. Proofs cover both unless --choice unwritten-output names one; the engine keeps.
#include "tests/step7/run7.hpp"

namespace rungproof {
namespace {

using test7::block, test7::lastRow, test7::Output, test7::proofOf;

std::string outputFunction(const std::string& declarations, const std::string& statements) {
  std::string text = "FUNCTION FC 1 : VOID\n" + declarations + "BEGIN\nNETWORK\n";
  std::istringstream in(statements);
  for (std::string one; std::getline(in, one, ';');) text += one + ";\n";
  return text + "END_FUNCTION\n";
}
const std::string outputPins = "VAR_INPUT\n  go : BOOL;\nEND_VAR\nVAR_OUTPUT\n  run : BOOL;\n  n : INT;\nEND_VAR\n";
const std::string outputCall = "CALL FC 1 (go := I 0.0, run := M 2.0, n := MW 10)";
const std::string outputAsked = "assume still: not I0.0\nprove off: not M2.0\nprove zero: MW10 = 0\n";

// Set only, left by a jump, left by BEC: M2.0 and MW10 stay 0 while I0.0 is 0, or are any value.
TEST(UnwrittenOutput, KeepsOrGetsAny) {
  for (const char* statements : {"A #go;S #run;S #run;A #go;JCN e;L 5;T #n;e: NOP 0", "AN #go;BEC;SET;= #run;L 5;T #n",
                                 "AN #go;JC e;SET;= #run;L 5;T #n;e: NOP 0"}) {
    const std::string blocks = outputFunction(outputPins, statements) + block(1, outputCall);
    const Output open = proofOf(outputAsked, blocks);
    EXPECT_TRUE(open.has("VIOLATED  off") && open.has("VIOLATED  zero")) << statements << open.text;
    EXPECT_TRUE(open.has("under unwritten-output = any")) << statements << open.text;
    const Output kept = proofOf(outputAsked, blocks, {"--choice", "unwritten-output=kept"});
    EXPECT_TRUE(kept.has("PROVED  off") && kept.has("PROVED  zero")) << statements << kept.text;
    EXPECT_TRUE(kept.has("unwritten-output = kept")) << statements << kept.text;
    EXPECT_TRUE(lastRow(blocks, "M2.0,MW10", {"--scans", "5"}).ends_with(",0,0"));
  }
}

// Written on every path it hands out what is written, under both readings.
TEST(UnwrittenOutput, WrittenOnesAreThat) {
  for (const char* statements : {"A #go;= #run;L 0;T #n", "L 0;T #n;CLR;= #run;A #go;S #run"}) {
    const Output output = proofOf(outputAsked, outputFunction(outputPins, statements) + block(1, outputCall));
    EXPECT_TRUE(output.has("PROVED  off") && output.has("PROVED  zero")) << statements << output.text;
    EXPECT_FALSE(output.has("unwritten-output")) << statements << output.text;
  }
}

// The output has the place of the input: what the block writes on each of its ways comes of what stood there before the
// call, so that MW10 counts and M2.0 changes in every scan.
TEST(UnwrittenOutput, MayHaveThePlaceOfAnInput) {
  const std::string pins =
      "VAR_INPUT\n  go : BOOL;\n  k : INT;\nEND_VAR\nVAR_OUTPUT\n  run : BOOL;\n  n : INT;\nEND_VAR\n";
  const std::string asked =
      "prove counts: not first_scan implies MW10 = prev(MW10) + 1 or prev(MW10) = 32767\n"
      "prove changes: not first_scan implies M2.0 <> prev(M2.0)\n";
  for (const char* statements :
       {"AN #go;= #run;L #k;L 1;+I;T #n", "A #go;JC a;SET;= #run;JU b;a: CLR;= #run;b: L #k;+ 1;T #n"}) {
    const Output output = proofOf(asked, outputFunction(pins, statements) +
                                             block(1, "CALL FC 1 (go := M 2.0, k := MW 10, run := M 2.0, n := MW 10)"));
    EXPECT_TRUE(output.has("PROVED  counts") && output.has("PROVED  changes")) << statements << output.text;
    EXPECT_FALSE(output.has("unwritten-output")) << statements << output.text;
  }
}

// IN_OUT parameters keep what they are given, outputs of an FB stand in its instance.
TEST(UnwrittenOutput, OthersKeep) {
  const std::string inOut = "VAR_INPUT\n  go : BOOL;\nEND_VAR\nVAR_IN_OUT\n  run : BOOL;\n  n : INT;\nEND_VAR\n";
  const std::string sets = "A #go;S #run;A #go;JCN e;L 5;T #n;e: NOP 0";
  const Output byReference = proofOf(outputAsked, outputFunction(inOut, sets) + block(1, outputCall));
  EXPECT_TRUE(byReference.has("PROVED  off") && byReference.has("PROVED  zero")) << byReference.text;
  const std::string fb = "FUNCTION_BLOCK FB 1\n" + outputPins +
                         "BEGIN\nNETWORK\nA #go;\nS #run;\nA #go;\nJCN e;\nL 5;\nT #n;\ne: NOP 0;\nEND_FUNCTION_BLOCK\n"
                         "DATA_BLOCK DB 1\nFB 1\nBEGIN\nEND_DATA_BLOCK\n";
  const Output ofInstance =
      proofOf(outputAsked, fb + block(1, "CALL FB 1, DB 1 (go := I 0.0, run := M 2.0, n := MW 10)"));
  EXPECT_TRUE(ofInstance.has("PROVED  off") && ofInstance.has("PROVED  zero")) << ofInstance.text;
}

// Return values and actuals in data blocks are outputs as well; so are those that a block hands on.
TEST(UnwrittenOutput, ReturnValuesDataBlocksAndHandedOn) {
  const std::string returns =
      "FUNCTION FC 2 : INT\nVAR_INPUT\n  go : BOOL;\nEND_VAR\nBEGIN\nNETWORK\nA #go;\nJCN e;\nL 5;\nT #RET_VAL;\n"
      "e: NOP 0;\nEND_FUNCTION\n";
  const Output value = proofOf("assume still: not I0.0\nprove zero: MW10 = 0\n",
                               returns + block(1, "CALL FC 2 (go := I 0.0, RET_VAL := MW 10)"));
  EXPECT_TRUE(value.has("VIOLATED  zero")) << value.text;
  const std::string data = "DATA_BLOCK DB 4\nSTRUCT\n  run : BOOL;\n  n : INT;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n";
  const std::string sets = outputFunction(outputPins, "A #go;S #run;A #go;JCN e;L 5;T #n;e: NOP 0");
  const Output inData = proofOf("assume still: not I0.0\nprove zero: DB4.DBW2 = 0\n",
                                data + sets + block(1, "CALL FC 1 (go := I 0.0, run := DB4.DBX 0.0, n := DB4.DBW 2)"));
  EXPECT_TRUE(inData.has("VIOLATED  zero")) << inData.text;
  const std::string outer = "FUNCTION FC 3 : VOID\n" + outputPins +
                            "BEGIN\nNETWORK\nCALL FC 1 (go := #go, run := #run, n := #n);\nEND_FUNCTION\n";
  const Output handedOn =
      proofOf(outputAsked, sets + outer + block(1, "CALL FC 3 (go := I 0.0, run := M 2.0, n := MW 10)"));
  EXPECT_TRUE(handedOn.has("VIOLATED  off") && handedOn.has("VIOLATED  zero")) << handedOn.text;
}

}  // namespace
}  // namespace rungproof
