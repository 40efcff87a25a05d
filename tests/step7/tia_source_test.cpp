// What external sources of TIA Portal have beside those of STEP 7 V5: constants of a block, the value of a function
// under the function's name, and :P for the module behind an address.
#include "tests/step7/run7.hpp"
#include "tests/step7/step7_run.hpp"

namespace rungproof {
namespace {

const std::string function =
    "FUNCTION \"Limit\" : Int\n{ S7_Optimized_Access := 'FALSE' }\nVERSION : 0.1\nVAR_INPUT\n  x : Int;\nEND_VAR\n"
    "VAR CONSTANT\n  MAX : Int := 100;\n  LOW : DInt := -5;\n  RATE : Real := 2;\n  SPAN : Time := T#1s;\nEND_VAR\n"
    "BEGIN\nNETWORK\n  L #x;\n  L #MAX;\n  T #Limit;\n  <=I;\n  JCN over;\n  L #x;\n  T #Limit;\nover: L #LOW;\n"
    "  T MD 20;\n  L #RATE;\n  T MD 24;\n  L #SPAN;\n  T MD 28;\nEND_FUNCTION\n";

// 70 is below the limit of 100, 700 above it. -5 of a DINT fills 32 bits, 2 of a REAL is 16#40000000, 1 s 1000 ms.
TEST(TiaSource, ConstantsAndTheValueOfAFunction) {
  const Step7Run run(function,
                     "CALL \"Limit\" (x := 70, RET_VAL := %MW10);\nCALL \"Limit\" (x := 700, RET_VAL := %MW12);");
  EXPECT_EQ(run.word(10), 70U);
  EXPECT_EQ(run.word(12), 100U);
  EXPECT_EQ(run.bytes(20, 12), "FF FF FF FB 40 00 00 00 00 00 03 E8");
}

// A constant takes no place in the instance: b lies behind a, at 2.0.
TEST(TiaSource, ConstantsTakeNoPlace) {
  const Step7Run run(
      "FUNCTION_BLOCK FB 1\nVAR\n  a : INT := 1;\nEND_VAR\nVAR CONSTANT\n  c : INT := 7;\nEND_VAR\nVAR\n  b : INT := "
      "2;\nEND_VAR\nBEGIN\nNETWORK\nL #c; T #b;\nEND_FUNCTION_BLOCK\nDATA_BLOCK DB 1\nFB 1\nBEGIN\nEND_DATA_BLOCK\n",
      "CALL FB 1, DB 1;\nL DB1.DBW 2;\nT MW 0;");
  EXPECT_EQ(run.word(0), 7U);
}

TEST(TiaSource, ConstantsAreNotWritten) {
  const Program program = read7(
      "FUNCTION FC 1 : VOID\nVAR CONSTANT\n  c : INT := 7;\n  d : INT;\nEND_VAR\nBEGIN\nNETWORK\nT #c;\nNETWORK\nL "
      "#d;\n"
      "END_FUNCTION\n");
  EXPECT_EQ(findings7(program), "SYN045 8:3 T takes no constant | SYN045 10:3 the constant d has no value of its type");
}

// %IW64:P is PIW64, "Level":P the module behind the tag's address; of bits there is none.
TEST(TiaSource, ModulesBehindAddresses) {
  const Program program = read7("L %IW64:P; T %QB4:P; L %ID0:P; A %I0.0;");
  EXPECT_EQ(findings7(program), "");
  EXPECT_EQ(show7(*program.main()), "L PIW64; T PQB4; L PID0; A I0.0");
  const test::TemporaryFolder folder;
  folder.file("main.awl", test7::block(1, "L \"Level\":P;T \"Valve\":P;L \"Level\";T MW 0"));
  folder.file("tags.sdf",
              "\"Level\",\"%IW64\",\"Int\",\"True\",\"True\",\"False\",\"\",\"\",\"True\"\n"
              "\"Valve\",\"%QW64\",\"Int\",\"True\",\"True\",\"False\",\"\",\"\",\"True\"\n");
  const test7::Output shown = test7::run({"show", folder.path(""), "--as", "stl"});
  EXPECT_TRUE(shown.has("PIW64") && shown.has("PQW64") && shown.has("IW64   // Level")) << shown.text;
  for (const char* wrong : {"A %I0.0:P;", "L %MW0:P;"})
    EXPECT_NE(findings7(read7(wrong)).find(":P stands behind bytes, words and double words"), std::string::npos)
        << wrong;
}

/// A table of tags with constants: each a name, a type and a value.
std::string tableOf(const std::vector<std::array<std::string, 3>>& constants) {
  std::string text = "<Document><SW.Tags.PlcTagTable ID=\"0\"><ObjectList>";
  for (const auto& [name, type, value] : constants)
    text += "<SW.Tags.PlcUserConstant ID=\"1\"><AttributeList><DataTypeName>" + type + "</DataTypeName><Name>" + name +
            "</Name><Value>" + value + "</Value></AttributeList></SW.Tags.PlcUserConstant>";
  return text + "</ObjectList></SW.Tags.PlcTagTable></Document>";
}

// User constants of a table of tags are values: 1200, -1 in the 32 bits of a DINT, 2.5 as 16#40200000.
TEST(TiaSource, ConstantsOfTagTables) {
  const test::TemporaryFolder folder;
  folder.file("main.awl", test7::block(1, "L \"MaxSpeed\";T MW 0;L \"Back\";T MD 2;L \"Ratio\";T MD 6"));
  folder.file(
      "tags.xml",
      tableOf({{"MaxSpeed", "Int", "1200"}, {"Back", "DInt", "-1"}, {"Ratio", "Real", "2.5"}, {"On", "Bool", "true"}}));
  const test7::Output run =
      test7::run({"sim", folder.path(""), "--scans", "1", "--signals", "MW0,MD2,MD6", "--trace", "-"});
  EXPECT_TRUE(run.has("1,10,10,1200,-1,2.5")) << run.text;
  folder.file("tags.xml", tableOf({{"MaxSpeed", "Int", "fast"}, {"Back", "DInt", "-1"}, {"Ratio", "Real", "2.5"}}));
  const test7::Output wrong = test7::run({"lint", folder.path("")});
  EXPECT_TRUE(wrong.has("constant MaxSpeed has the value fast, which no S7-300/400 has")) << wrong.text;
  folder.file("tags.xml", tableOf({{"MaxSpeed", "Int", "70000"}, {"Back", "DInt", "-1"}, {"Ratio", "Real", "2.5"}}));
  const test7::Output large = test7::run({"lint", folder.path("")});
  EXPECT_TRUE(large.has("the constant MaxSpeed has no value of its type")) << large.text;
}

// The same drawn: a constant of the block, 100, and one of the table go to MW10 and MW12.
TEST(TiaSource, ConstantsInDrawnNetworks) {
  const auto move = [](const std::string& constant, int bit) {
    return "<SW.Blocks.CompileUnit ID=\"" + std::to_string(bit) +
           "\"><AttributeList><NetworkSource><FlgNet><Parts><Access Scope=\"" + constant +
           "</Access><Access Scope=\"Address\" UId=\"22\"><Address Area=\"Memory\" Type=\"Int\" BitOffset=\"" +
           std::to_string(bit) +
           "\"/></Access><Part Name=\"Move\" UId=\"23\"><TemplateValue Name=\"Card\" "
           "Type=\"Cardinality\">1</TemplateValue></Part></Parts><Wires><Wire><OpenCon UId=\"24\"/><NameCon "
           "UId=\"23\" Name=\"en\"/></Wire><Wire><IdentCon UId=\"21\"/><NameCon UId=\"23\" Name=\"in\"/></Wire><Wire>"
           "<NameCon UId=\"23\" Name=\"out1\"/><IdentCon UId=\"22\"/></Wire></Wires></FlgNet></NetworkSource>"
           "<ProgrammingLanguage>FBD</ProgrammingLanguage></AttributeList></SW.Blocks.CompileUnit>";
  };
  const test::TemporaryFolder folder;
  folder.file("f.xml",
              "<Document><SW.Blocks.FC ID=\"0\"><AttributeList><Interface><Sections><Section Name=\"Constant\"><Member "
              "Name=\"MAX\" Datatype=\"Int\"><StartValue>100</StartValue></Member></Section></Sections></Interface>"
              "<Name>F</Name><Number>1</Number><ProgrammingLanguage>FBD</ProgrammingLanguage></AttributeList>"
              "<ObjectList>" +
                  move("LocalConstant\" UId=\"21\"><Constant Name=\"MAX\"/>", 80) +
                  move("GlobalConstant\" UId=\"21\"><Constant Name=\"MaxSpeed\"/>", 96) +
                  "</ObjectList></SW.Blocks.FC></Document>");
  folder.file("tags.xml", tableOf({{"MaxSpeed", "Int", "1200"}}));
  folder.file("main.awl", test7::block(1, "CALL \"F\""));
  const test7::Output run =
      test7::run({"sim", folder.path(""), "--scans", "1", "--signals", "MW10,MW12", "--trace", "-"});
  EXPECT_TRUE(run.has("1,10,10,100,1200")) << run.text;
}

}  // namespace
}  // namespace rungproof
