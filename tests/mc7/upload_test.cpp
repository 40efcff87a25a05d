// Blocks out of a CPU, checksums, compiled declarations.
#include "frontend/mc7/upload.hpp"

#include <gtest/gtest.h>

#include "frontend/mc7/block_source.hpp"
#include "frontend/mc7/compiled_declaration.hpp"
#include "tests/mc7/code_round.hpp"

namespace rungproof {
namespace {

using mc7::StoredBlock;
using step7::BlockKind;

// An OB of one BE has the checksum F475; the column of projects holds it with swapped bytes, 30196.
TEST(Mc7Checksum, IsThatOfStep7) {
  EXPECT_EQ(mc7::checksumOf(BlockKind::Ob, std::string("\x65\x00", 2)), 0xF475);
  EXPECT_EQ((0xF475 & 0xFF) << 8 | 0xF475 >> 8, 30196);
}

StoredBlock sample() {
  StoredBlock block;
  block.key = {BlockKind::Fc, 7};
  block.language = 1;
  block.author = "me";
  block.version = 0x10;
  block.code = std::string("\xC0\x00\xD8\x80\x65\x00", 6);  // A I 0.0; = Q 0.0; BE
  block.declaration = std::string("\x01\x07\x00\x04\x00\x00\x00\x05\x01\x01\x02", 11);
  block.table = std::string("\x01\x00\x04\x00\x00\x00", 6);
  block.localBytes = 2;
  block.interfaceTime = 86'400'000ULL * 9000 + 1234;
  return block;
}

TEST(Mc7Upload, ComesBackFromItsBytes) {
  const StoredBlock block = sample();
  const std::string bytes = mc7::writeUpload(block);
  EXPECT_EQ(bytes.size(), 36U + 6 + 11 + 6 + 36);
  ASSERT_TRUE(mc7::isUpload(bytes));
  const StoredBlock read = mc7::readUpload(bytes, "fc7.mc7");
  EXPECT_EQ(read.damage, "");
  EXPECT_EQ(read.key, block.key);
  EXPECT_EQ(read.code, block.code);
  EXPECT_EQ(read.declaration, block.declaration);
  EXPECT_EQ(read.table, block.table);
  EXPECT_EQ(read.author, "me");
  EXPECT_EQ(read.interfaceTime, block.interfaceTime);
  EXPECT_EQ(read.checksum, mc7::checksumOf(BlockKind::Fc, block.code));
  EXPECT_EQ(mc7::writeUpload(read), bytes);
}

TEST(Mc7Upload, BecomesASourceWithNamesByPosition) {
  const std::vector<mc7::BlockSource> sources =
      mc7::sourcesOf({mc7::readUpload(mc7::writeUpload(sample()), "x")}, false);
  ASSERT_EQ(sources.size(), 1U);
  EXPECT_EQ(sources[0].damage, "");
  EXPECT_NE(sources[0].text.find("IN0 : INT"), std::string::npos) << sources[0].text;
  EXPECT_NE(sources[0].text.find("OUT0 : BOOL"), std::string::npos) << sources[0].text;
  EXPECT_NE(sources[0].text.find("A     I 0.0"), std::string::npos) << sources[0].text;
  EXPECT_EQ(sources[0].instructions, 3U);
}

// Each byte cut off the end, and each byte of the code changed: said, and nothing crashes.
TEST(Mc7Upload, DamageIsFound) {
  const std::string bytes = mc7::writeUpload(sample());
  for (std::size_t length = 6; length < bytes.size(); ++length)
    EXPECT_NE(mc7::readUpload(bytes.substr(0, length), "x").damage, "") << length;
  for (std::size_t i = 36; i < 36 + 6; ++i) {
    std::string changed = bytes;
    changed[i] = static_cast<char>(changed[i] ^ 0x40);
    const std::vector<mc7::BlockSource> sources = mc7::sourcesOf({mc7::readUpload(changed, "x")}, false);
    EXPECT_NE(sources.at(0).damage, "") << i;
    EXPECT_EQ(sources.at(0).text.find("BEGIN"), std::string::npos) << i;
  }
}

// IN: INT with start value 5; STAT: STRUCT of BOOL and ARRAY[1..4] OF WORD; FB instance; TEMP: STRING[10].
// Behind the title: a text of the statement on line 2, one on a line of its own behind line 3, a blank line.
TEST(Mc7Upload, CommentsOfLinesAreRead) {
  const std::string section(
      "\x06\x07\x00\x08\x00\x06\x00\x00"
      "\x03\x00\x02\x00\x80\x28"
      "one"
      "\x03\x00\x01\x00\x00\x28"
      "two"
      "\x00\x00\x01\x00\x20\x28",
      8 + 9 + 9 + 6);
  const std::vector<mc7::StoredBlock::LineText> lines = mc7::readLineRecords(section);
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0].line, 2U);
  EXPECT_TRUE(lines[0].isOfStatement);
  EXPECT_EQ(lines[0].text, "one");
  EXPECT_EQ(lines[1].line, 3U);
  EXPECT_FALSE(lines[1].isOfStatement);
  EXPECT_EQ(lines[1].text, "two");
  EXPECT_TRUE(mc7::readLineRecords(section.substr(0, 12)).empty());
}

TEST(Mc7Declaration, IsTextOfAllTypes) {
  const std::string items(
      "\x05\x09"                              // INT, IN, with start value
      "\x11\x04\x02"                          // STRUCT of two
      "\x01\x04"                              // BOOL
      "\x10\x04\x01\x01\x00\x04\x00\x04\x04"  // ARRAY [1..4] OF WORD
      "\x15\x29\x00\x11\x04\x01\x01\x01"      // FB 41 with one BOOL
      "\x13\x05\x0A"                          // STRING [10] in TEMP
      "\x16\x06",                             // ANY as RET_VAL
      2 + 3 + 2 + 9 + 8 + 3 + 2);
  std::string bytes("\x01\x00\x00", 3);
  bytes += static_cast<char>(items.size());
  bytes += std::string("\0\2\0", 3) + items + std::string("\5\0", 2);
  const mc7::CompiledDeclaration read = mc7::readCompiledDeclaration(bytes);
  EXPECT_EQ(read.fault, "");
  for (const char* part : {"IN0 : INT := 5 ;", "STAT0 : STRUCT", "STAT0 : BOOL ;", "ARRAY  [1 .. 4 ] OF WORD",
                           "STAT1 : FB 41 ;", "TEMP0 : STRING [10 ] ;", "RET_VAL : ANY ;"})
    EXPECT_NE(read.text.find(part), std::string::npos) << part << "\n" << read.text;
}

// Values of an array in groups: three times 7, then 9; the INT behind it has its own. The items of a data block are one
// structure, which is the block itself.
TEST(Mc7Declaration, StartValuesOfArrays) {
  const std::string items("\x11\x04\x02\x10\x0C\x01\x01\x00\x05\x00\x02\x04\x05\x0C", 14);
  const std::string starts("\x02\x00\x00\x02\x03\x00\x07\x01\x00\x09\x0A\x00", 12);
  std::string bytes("\x05\x00\x00\x0E\x00\x0C\x00", 7);
  const mc7::CompiledDeclaration read = mc7::readCompiledDeclaration(bytes + items + starts);
  EXPECT_EQ(read.fault, "");
  EXPECT_NE(read.text.find("  STAT0 : ARRAY  [1 .. 5 ] OF BYTE := 3 (B#16#7), B#16#9 ;\n"), std::string::npos)
      << read.text;
  EXPECT_NE(read.text.find("  STAT1 : INT := 10 ;\n"), std::string::npos) << read.text;
  EXPECT_TRUE(read.text.starts_with("STRUCT\n  STAT0")) << read.text;
}

TEST(Mc7Declaration, KeepsTheInterfacesOfInstances) {
  const std::string items("\x15\x4D\x00\x11\x04\x02\x01\x01\x05\x02", 10);
  const mc7::CompiledDeclaration read =
      mc7::readCompiledDeclaration(std::string("\x01\x00\x00\x0A\x00\x00\x00", 7) + items);
  ASSERT_EQ(read.instances.size(), 1U);
  EXPECT_EQ(read.instances[0].number, 77);
  EXPECT_EQ(read.instances[0].text, "VAR_INPUT\n  IN0 : BOOL ;\nEND_VAR\nVAR_OUTPUT\n  OUT0 : INT ;\nEND_VAR\n");
}

TEST(Mc7Declaration, SaysWhereItIsDamaged) {
  const auto faultOf = [](const std::string& bytes) { return mc7::readCompiledDeclaration(bytes).fault; };
  EXPECT_NE(faultOf(std::string("\1\0\0", 3)), "");
  EXPECT_NE(faultOf(std::string("\7\0\0\0\0\0\0", 7)).find("kind 7"), std::string::npos);
  EXPECT_NE(faultOf(std::string("\1\0\0\x09\0\0\0", 7)).find("shorter"), std::string::npos);
  EXPECT_NE(faultOf(std::string("\1\0\0\2\0\0\0\x7F\1", 9)).find("type 7F"), std::string::npos);
  EXPECT_NE(faultOf(std::string("\1\0\0\3\0\0\0\x11\4\xFF", 10)).find("too early"), std::string::npos);
}

}  // namespace
}  // namespace rungproof
