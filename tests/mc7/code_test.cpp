// Machine code to statements and back: every row of the table, random code, what is no code.
#include <gtest/gtest.h>

#include <cstdlib>
#include <random>

#include "tests/mc7/code_round.hpp"

namespace rungproof {
namespace {

using mc7::Form;
using mc7::Opcode;

void addWord(std::string& bytes, unsigned word) {
  bytes += static_cast<char>(word >> 8);
  bytes += static_cast<char>(word);
}

/// An instruction of that row with operands that fit it. STEP 7 takes the short form where one holds the operand, so
/// numbers of long forms are large.
std::string instructionOf(const Opcode& row, std::mt19937& random) {
  const auto below = [&](unsigned limit) { return static_cast<unsigned>(random() % limit); };
  unsigned word = row.value, rest = 0, last = 0;
  const auto digits = [&] { return below(10) << 8 | below(10) << 4 | below(10); };
  switch (row.form) {
    case Form::Bit: {
      const unsigned area = 1 + below(6);
      word |= area << 4 | below(8);
      rest = area <= 3 ? 256 + below(1000) : below(65536);
      // FP, FN and X have no short form; a large byte is right for them too.
      break;
    }
    case Form::MarkerBit: word |= below(8) << 8 | below(256); break;
    case Form::ImageBit: word |= below(8) << 8 | below(128); break;
    case Form::Sized: {
      const unsigned area = below(7);
      word |= area << 4;
      rest = area >= 1 && area <= 3 ? 256 + below(1000) : below(65536);
      break;
    }
    case Form::Holder:
    case Form::NumberByMemory: word |= (3 + below(4)) << 4, rest = below(65536); break;
    case Form::Number8: word |= below(256); break;
    case Form::Number7: word |= below(128); break;
    case Form::Number16: rest = 256 + below(60000); break;
    case Form::Count4: word |= below(16) << 4; break;
    case Form::Count6: word |= below(64); break;
    case Form::BitByMemory: word |= (3 + below(4)) << 4 | (1 + below(6)), rest = below(65536); break;
    case Form::SizedByMemory: word |= (3 + below(4)) << 4 | below(7), rest = below(65536); break;
    case Form::BitByRegister: word |= (1 + below(6)) << 4 | below(2) << 3, rest = below(65536); break;
    case Form::SizedByRegister: word |= below(7) << 4 | below(2) << 3, rest = below(65536); break;
    case Form::AnyByRegister: word |= below(2) << 3, rest = below(65536); break;
    case Form::Parameter: rest = 2 * (1 + below(500)); break;
    case Form::Jump: rest = 2; break;  // to the instruction behind it; of JL: behind one entry, see below
    case Form::HexByte: word |= below(256); break;
    case Form::TwoCharacters: rest = (0x20 + below(0xE0)) << 8 | below(256); break;
    case Form::CountValue: rest = digits(); break;
    case Form::S5Time: rest = below(4) << 12 | digits(); break;
    case Form::Date: rest = below(65536); break;
    case Form::Pointer: {
      const unsigned address = below(0x80000), area = below(9);
      rest = (area == 8 ? 0 : 0x8000U | area << 8) | address >> 16;
      last = address & 0xFFFFU;
      break;
    }
    case Form::TimeOfDay: rest = below(1318), last = below(65536); break;
    case Form::BinaryDWord: rest = 1 + below(65535), last = below(65536); break;
    case Form::FourCharacters: rest = (1 + below(255)) << 8 | below(256), last = below(65536); break;
    default: rest = below(65536), last = below(65536); break;
  }
  std::string bytes;
  addWord(bytes, word);
  if (row.bytes >= 4) addWord(bytes, rest);
  if (row.bytes >= 6) addWord(bytes, last);
  if (hasParameterList(row)) {
    const unsigned count = below(4);
    addWord(bytes, 0x700B);
    addWord(bytes, 2 + 2 * count);
    for (unsigned i = 0; i < count; ++i) {
      const bool isNumber = below(3) == 0;
      addWord(bytes, isNumber ? below(256) : 0x8000U | (1 + below(7)) << 8 | below(8));
      addWord(bytes, isNumber ? 0 : below(65536));
    }
  }
  if (row.mnemonic == "JL") {
    bytes[3] = 1;
    addWord(bytes, 0x700B);
    addWord(bytes, 2);
  }
  return bytes;
}

// decode, print, read, encode gives the same bytes, whatever the row.
TEST(Mc7Code, EveryRowComesBack) {
  const unsigned seed = 20261129;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  for (const Opcode& row : mc7::opcodes()) {
    for (int i = 0; i < 20; ++i) {
      std::string code = instructionOf(row, random);
      addWord(code, 0x6500);
      const test::CodeRound round = test::roundOf(code);
      ASSERT_EQ(round.fault, "") << test::hexOf(code) << "\n" << round.text;
      ASSERT_EQ(test::hexOf(round.bytes), test::hexOf(code)) << round.text;
    }
  }
}

// The same without knowing the row: the text alone says which code is meant, but for what the table lists twice.
TEST(Mc7Code, TextAloneGivesTheShortForm) {
  struct Case {
    const char* text;
    const char* code;
  };
  // Codes of the opcode table; the short form wherever the operand fits it.
  const Case cases[] = {
      {"A M 10.3", "830A"},
      {"A M 256.3", "00330100"},
      {"= I 127.7", "DF7F"},
      {"= Q 128.0", "41200080"},
      {"L MW 255", "12FF"},
      {"L MW 256", "7E320100"},
      {"T QD 5", "5B85"},
      {"L PIW 256", "7E020100"},
      {"T PQW 256", "7E060100"},
      {"A DBX 0.1", "00410000"},
      {"A DIX [AR2,P#1.2]", "7958000A"},
      {"L W [AR1,P#0.0]", "FB020000"},
      {"L D [AR2,P#0.0]", "FB0B0000"},
      {"OPN DB 10", "200A"},
      {"OPN DB 300", "FB78012C"},
      {"OPN DI 5", "FB790005"},
      {"UC FB 5", "7505"},
      {"UC FB 300", "FB72012C"},
      {"L W#16#1002", "30071002"},
      {"L 5", "30030005"},
      {"L L#5", "380300000005"},
      {"L B#16#7F", "287F"},
      {"L 2#101", "30020005"},
      {"L 'ab'", "30056162"},
      {"L C#123", "30080123"},
      {"L S5T#2S", "300C0200"},
      {"L T#1S", "3809000003E8"},
      {"L 1.0", "38013F800000"},
      {"L P#M 10.0", "380483000050"},
      {"+ -1", "5800FFFF"},
      {"+ L#1", "600500000001"},
      {"LAR1 P#0.0", "FE0300000000"},
      {"LAR1 MD 20", "FE330014"},
      {"+AR2 P#2.0", "FE0A0010"},
      {"BTD", "680E"},
      {"+I", "7900"},
      {"-I", "5900"},
      {"A OV", "FF10"},
      {"A <=0", "FFC0"},
      {"SRD 3", "FEC3"},
      {"SSI 3", "6831"},
      {"UC FC 5", "3D05700B0002"},
      {"UC SFC 20 {P#V 20.0}", "FB740014700B0004870000A0"},
      {"A(", "BA00"},
      {")", "BF00"},
      {"NOP 0", "0000"},
      {"NOP 1", "FFFF"},
      {"BLD 103", "1067"},
      {"A T [MW 4]", "BF300004"},
      {"L T 5", "0205"},
      {"L LW [LD 4]", "BB660004"},
      {"A I [MD 4]", "51310004"},
      {"UC FC [MW 4]", "FB300004700B0002"},
  };
  for (const Case& each : cases) {
    const std::string text = std::string(each.text) + ";";
    step7::Cursor cursor(text, 0);
    std::vector<Span> remarks;
    const step7::Statement statement =
        step7::readStatement(cursor, {step7::MnemonicSet::International, TextEncoding::Utf8}, remarks);
    const mc7::EncodedStatement encoded = mc7::encode(statement, {});
    EXPECT_EQ(encoded.fault, "") << each.text;
    EXPECT_EQ(test::hexOf(encoded.bytes), each.code) << each.text;
  }
}

int programCount() {
  const char* wanted = std::getenv("RUNGPROOF_MC7_PROGRAMS");
  return wanted == nullptr ? 200 : std::atoi(wanted);
}

// Programs of up to 60 instructions, among them jumps that lead anywhere in them.
TEST(Mc7Code, RandomProgramsComeBack) {
  const unsigned seed = std::random_device()();
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  const std::span<const Opcode> rows = mc7::opcodes();
  for (int program = 0; program < programCount(); ++program) {
    std::string code;
    std::vector<std::uint32_t> starts, jumps;
    for (std::size_t left = 1 + random() % 60; left > 0; --left) {
      const Opcode& row = rows[random() % rows.size()];
      starts.push_back(static_cast<std::uint32_t>(code.size()));
      if (row.form == Form::Jump && row.mnemonic != "JL") jumps.push_back(starts.back());
      code += instructionOf(row, random);
    }
    starts.push_back(static_cast<std::uint32_t>(code.size()));
    addWord(code, 0x6500);
    for (const std::uint32_t jump : jumps) {
      const std::int64_t words = (std::int64_t{starts[random() % starts.size()]} - jump) / 2;
      code[jump + 2] = static_cast<char>(words >> 8);
      code[jump + 3] = static_cast<char>(words);
    }
    const test::CodeRound round = test::roundOf(code);
    ASSERT_EQ(round.fault, "") << test::hexOf(code) << "\n" << round.text;
    ASSERT_EQ(test::hexOf(round.bytes), test::hexOf(code)) << round.text;
  }
}

std::string bytesOf(std::string_view hex) {
  std::string bytes;
  for (std::size_t i = 0; i + 1 < hex.size(); i += 2)
    bytes += static_cast<char>(std::stoul(std::string(hex.substr(i, 2)), nullptr, 16));
  return bytes;
}

TEST(Mc7Code, NamesTheByteWhereItIsNoCode) {
  struct Case {
    const char* code;
    std::uint32_t at;
    const char* reason;
  };
  const Case cases[] = {
      {"80006BFF", 2, "6BFF is no instruction"},
      {"800000", 2, "half a word"},
      {"7E02", 0, "ends within an instruction"},
      {"3D056500", 2, "no list of parameters"},
      {"3D05700B0003", 2, "no possible length"},
      {"3D05700B0100", 2, "no possible length"},
      {"700B00106500", 0, "leads to byte 32"},
      {"700BFFF06500", 0, "leads to byte -32"},
      {"700B000330030005", 0, "where no instruction begins"},
  };
  for (const Case& each : cases) {
    const mc7::DecodedCode decoded = mc7::decodeCode(bytesOf(each.code));
    ASSERT_TRUE(decoded.fault) << each.code;
    EXPECT_EQ(decoded.fault->at, each.at) << each.code;
    EXPECT_NE(decoded.fault->reason.find(each.reason), std::string::npos) << each.code << decoded.fault->reason;
  }
}

// Points at which other decoders go wrong: 200A is OPN DB 10, FB0A W [AR2], FB72 UC FB without a list, JL counts its
// entries, distances count words from the jump.
TEST(Mc7Code, ReadsWhatOthersMistake) {
  const auto textsOf = [](std::string_view hex) { return test::roundOf(bytesOf(hex)).text; };
  EXPECT_NE(textsOf("200A").find("OPN   DB 10 ;"), std::string::npos);
  EXPECT_NE(textsOf("FB0A0008").find("L     W [AR2,P#1.0]"), std::string::npos);
  EXPECT_NE(textsOf("FB72012C6500").find("UC    FB 300 ;\nL004: BE"), std::string::npos);
  EXPECT_NE(textsOf("5B85").find("T     QD 5"), std::string::npos);
  // JL with two entries: the default lies behind them at 4 + 8.
  EXPECT_NE(textsOf("70090002700B0004700B0002"
                    "0000"
                    "6500")
                .find("JL    L012"),
            std::string::npos);
  // The jump over a list is an instruction of its own.
  EXPECT_EQ(mc7::decodeCode(bytesOf("3D05700B000487000000"
                                    "6500"))
                .instructionCount(),
            3U);
}

}  // namespace
}  // namespace rungproof
