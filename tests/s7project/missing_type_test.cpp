// Types that a project lacks: what uses them was compiled with their shape, which counts. All else is read as ever.
#include <gtest/gtest.h>

#include "tests/s7project/plant.hpp"

namespace rungproof {
namespace {

using step7::BlockKey;
using step7::BlockKind;
using test::TemporaryFolder;

void addItem(std::string& bytes, std::initializer_list<int> item) {
  for (const int byte : item) bytes += static_cast<char>(byte);
}

/// Head, items and start values.
std::string declaration(int kind, const std::string& items, const std::string& starts = "") {
  std::string bytes;
  addItem(bytes, {kind, 0, 0, static_cast<int>(items.size()), 0, static_cast<int>(starts.size()), 0});
  return bytes + items + starts;
}

/// DB 5 with `list : ARRAY [1 .. 2] OF UDT 7; n : INT`, and an OB 1 that reads n. UDT 7 is an INT and a REAL.
test::ProjectPart projectWithoutItsType() {
  test::ProjectPart part;
  part.blocks = test::compileSource(
                    "DATA_BLOCK DB 5\nSTRUCT\n x : ARRAY [1 .. 14] OF BYTE ;\nEND_STRUCT ;\nBEGIN\n"
                    "END_DATA_BLOCK\nORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n L DB5.DBW 12;\n T MW 20;\n"
                    "END_ORGANIZATION_BLOCK\n")
                    .blocks;
  mc7::StoredBlock& data = part.blocks.front();
  std::string items;
  addItem(items, {0x11, 4, 2, 0x10, 4, 1, 1, 0, 2, 0, 0x11, 4, 2, 5, 4, 8, 4, 5, 4});
  data.declaration = declaration(5, items);
  data.declarationText = "STRUCT\n list : ARRAY [1 .. 2] OF UDT 7 ;\n n : INT ;\nEND_STRUCT ;\n";
  data.code = std::string(13, '\0') + '\x2A';
  return part;
}

// Two elements of six bytes: n lies at 12, where the image has 42.
TEST(S7MissingTypes, ShapeOfAUdtIsThatOfItsUser) {
  const TemporaryFolder folder;
  const std::string project = writeFiles(folder, test::writeProject({projectWithoutItsType()}, 1252));
  const test::ProgramRun lint = test::run({"lint", "--isolated", project});
  EXPECT_TRUE(lint.says("UDT7 is not read: it is missing, and taken in the shape that DB5 was compiled with"))
      << lint.out;
  EXPECT_FALSE(lint.says("error")) << lint.out;
  const std::string properties = folder.file("p.prop", "prove value: MW20 == 42\n");
  const test::ProgramRun proof = test::run({"prove", "--isolated", "--props", properties, project});
  EXPECT_EQ(proof.exit, 0) << proof.out << proof.err;
}

// The instance of a missing FB: its interface is known, what it does is not, and what it does not concern is proved.
TEST(S7MissingTypes, InterfaceOfAnFbIsThatOfItsInstance) {
  test::ProjectPart part;
  part.blocks = test::compileSource(
                    "FUNCTION_BLOCK FB 6\nVAR\n a : ARRAY [1 .. 4] OF BYTE ;\n n : INT ;\nEND_VAR\nBEGIN\n"
                    "NETWORK\n A I 0.0;\n = Q 0.0;\nEND_FUNCTION_BLOCK\nDATA_BLOCK DB 6\nFB 6\nBEGIN\n"
                    "END_DATA_BLOCK\nORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n CALL FB 6, DB 6;\n"
                    "END_ORGANIZATION_BLOCK\n")
                    .blocks;
  for (mc7::StoredBlock& block : part.blocks) {
    if (block.key != BlockKey{BlockKind::Fb, 6}) continue;
    std::string items;
    addItem(items, {0x15, 77, 0, 0x11, 4, 2, 1, 1, 5, 2, 5, 4});  // FB 77: a BOOL in, an INT out; then an INT
    block.declaration = declaration(1, items);
    block.declarationText = "VAR\n pump : FB 77 ;\n n : INT ;\nEND_VAR\n";
  }
  const TemporaryFolder folder;
  const std::string project = writeFiles(folder, test::writeProject({part}, 1252));
  const test::ProgramRun lint = test::run({"lint", "--isolated", project});
  EXPECT_TRUE(lint.says("FB77 is not read: it is missing, and taken in the shape that FB6 was compiled with"))
      << lint.out;
  EXPECT_FALSE(lint.says("error")) << lint.out;
  const std::string properties = folder.file("p.prop", "prove same: Q0.0 = I0.0\n");
  const test::ProgramRun proof = test::run({"prove", "--isolated", "--props", properties, project});
  EXPECT_EQ(proof.exit, 0) << proof.out << proof.err;
}

}  // namespace
}  // namespace rungproof
