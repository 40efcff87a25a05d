// `check` of S7-300/400 sources: what SIMATIC Manager refuses although it can be read. Each row is one fault in a
// source that is valid without it (general knowledge of STEP 7 V5).
#include "tests/step7/run7.hpp"

namespace rungproof::test7 {
namespace {

const std::string valid =
    "FUNCTION FC 1 : INT\nVAR_INPUT\n  speed : REAL := 5.0;\nEND_VAR\nVAR_TEMP\n  t : INT ;\nEND_VAR\nBEGIN\nNETWORK\n"
    "      L #speed; T MD 10 ;  // kept\n      JU end;\nend:  NOP 0;\nEND_FUNCTION\n"
    "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n      A I 0.0; = Q 0.0;\nNETWORK\n"
    "CALL FC 1 (speed := 1.0, RET_VAL := MW 4);\nEND_ORGANIZATION_BLOCK\n";

std::string with(const std::string& from, const std::string& to) {
  std::string text = valid;
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

Output checked(const std::string& text) {
  const test::TemporaryFolder folder;
  return run({"check", folder.file("source.awl", text)});
}

TEST(SourceCheck, ASourceThatIsTaken) {
  const Output taken = checked(valid);
  EXPECT_EQ(taken.exit, 0) << taken.text;
  EXPECT_TRUE(taken.has("3 networks: 3 valid, 0 invalid") && taken.has("2 blocks: 2 valid, 0 invalid")) << taken.text;
}

TEST(SourceCheck, EachFaultWithItsReason) {
  struct Row {
    std::string from, to, said;
  };
  const std::vector<Row> rows = {
      {"L #speed;", "L #speed\n", "FC1, network 1 is invalid: no semicolon ends L #speed"},
      {"JU end;\nend: ", "JU motor;\nmotor: ", "FC1, network 1 is invalid: the label motor has more than 4 characters"},
      {"5.0", "5", "FC1 is invalid: the start value of speed is a whole number"},
      {"t : INT ;", "t : INT := 3;", "FC1 is invalid: t in VAR_TEMP has a start value"},
      {"t : INT ;", "a_name_of_more_than_24_characters : INT ;", "characters has more than 24 characters"},
      {"A I 0.0; = Q 0.0;", "A I 0.0; = Q 0.0;\nCALL FC 3;\n", "OB1, network 1 is invalid: FC 3 stands below"},
      {"t : INT ;", "t : UDT 7 ;", "FC1 is invalid: UDT 7 stands below"},
  };
  const std::string behind =
      "FUNCTION FC 3 : VOID\nBEGIN\nNETWORK\nNOP 0;\nEND_FUNCTION\nTYPE UDT 7\nSTRUCT\n  x : INT ;\nEND_STRUCT ;\n"
      "END_TYPE\n";
  EXPECT_EQ(checked(valid + behind).exit, 0) << checked(valid + behind).text;
  for (const Row& row : rows) {
    const Output refused = checked(with(row.from, row.to) + behind);
    EXPECT_EQ(refused.exit, 1) << row.to << refused.text;
    EXPECT_TRUE(refused.has(row.said)) << row.to << refused.text;
    EXPECT_TRUE(refused.has("3 blocks: 2 valid, 1 invalid")) << row.to << refused.text;
  }
}

TEST(SourceCheck, OneRowForEachKindInANetwork) {
  const Output refused = checked(with("A I 0.0; = Q 0.0;", "A I 0.0\n= Q 0.0\nA I 0.1\n= Q 0.1\n"));
  EXPECT_TRUE(refused.has("no semicolon ends A I 0.0")) << refused.text;
  EXPECT_FALSE(refused.has("ends = Q 0.0")) << refused.text;
}

TEST(SourceCheck, BlocksInJson) {
  const test::TemporaryFolder folder;
  const std::string file = folder.file("source.awl", with("5.0", "5"));
  const Output json = run({"check", file, "--format", "json"});
  EXPECT_TRUE(json.has("\"blocks\"") && json.has("\"block\": \"FC1\"") && json.has("whole number")) << json.text;
}

// The rest of the tool reads such a source as before.
TEST(SourceCheck, OtherCommandsTakeIt) {
  const test::TemporaryFolder folder;
  const std::string file = folder.file("source.awl", with("L #speed;", "L #speed\n"));
  EXPECT_EQ(run({"sim", file, "--scans", "2"}).exit, 0);
}

}  // namespace
}  // namespace rungproof::test7
