// Bytes to UTF-8: marks, detection, damaged sequences, control characters, line ends.
#include "frontend/files/encoding.hpp"

#include <gtest/gtest.h>

#include "tests/reader/read.hpp"

namespace rungproof {
namespace {

// The same words in each code page.
const std::string russianUtf8 =
    "\xD0\xBD\xD0\xB0\xD1\x81\xD0\xBE\xD1\x81 \xD0\xB2\xD0\xBA\xD0\xBB\xD1\x8E\xD1\x87\xD0\xB5\xD0\xBD";  // nasos
                                                                                                          // vklyuchen
const std::string russianCp1251 = "\xED\xE0\xF1\xEE\xF1 \xE2\xEA\xEB\xFE\xF7\xE5\xED";
const std::string chineseUtf8 = "\xE7\xA8\x8B\xE5\xBA\x8F\xE6\xB3\xA8\xE9\x87\x8A";  // program comments
const std::string chineseGbk = "\xB3\xCC\xD0\xF2\xD7\xA2\xCA\xCD";
const std::string spanishUtf8 = "Direcci\xC3\xB3n de la m\xC3\xA1quina";
const std::string spanishCp1252 = "Direcci\xF3n de la m\xE1quina";

TEST(EncodingTest, NamesAndBack) {
  for (const char* name : {"auto", "utf-8", "cp1252", "cp1251", "gb18030"}) {
    const auto encoding = encodingNamed(name);
    ASSERT_TRUE(encoding.has_value()) << name;
    EXPECT_EQ(encodingName(*encoding), name);
  }
  EXPECT_FALSE(encodingNamed("latin9").has_value());
}

TEST(EncodingTest, ConvertsWhatIsNamed) {
  EXPECT_EQ(decode(russianCp1251, TextEncoding::Cp1251).text, russianUtf8);
  EXPECT_EQ(decode(chineseGbk, TextEncoding::Gb18030).text, chineseUtf8);
  EXPECT_EQ(decode(spanishCp1252, TextEncoding::Cp1252).text, spanishUtf8);
  EXPECT_EQ(decode(chineseUtf8, TextEncoding::Utf8).text, chineseUtf8);
}

TEST(EncodingTest, Detects) {
  EXPECT_EQ(decode("LD I0.0", TextEncoding::Auto).encoding, TextEncoding::Utf8);
  EXPECT_EQ(decode("// " + russianUtf8, TextEncoding::Auto).encoding, TextEncoding::Utf8);
  const DecodedText russian = decode("LD I0.0 // " + russianCp1251 + "\n", TextEncoding::Auto);
  EXPECT_EQ(russian.encoding, TextEncoding::Cp1251);
  EXPECT_EQ(russian.text, "LD I0.0 // " + russianUtf8 + "\n");
  const DecodedText chinese = decode("LD I0.0 // " + chineseGbk + "\n", TextEncoding::Auto);
  EXPECT_EQ(chinese.encoding, TextEncoding::Gb18030);
  EXPECT_EQ(chinese.text, "LD I0.0 // " + chineseUtf8 + "\n");
  const DecodedText spanish = decode("LD I0.0 // " + spanishCp1252 + "\n", TextEncoding::Auto);
  EXPECT_EQ(spanish.encoding, TextEncoding::Cp1252);
  EXPECT_EQ(spanish.text, "LD I0.0 // " + spanishUtf8 + "\n");
}

TEST(EncodingTest, MarksAreDropped) {
  EXPECT_EQ(decode("\xEF\xBB\xBFLD I0.0", TextEncoding::Auto).text, "LD I0.0");
  EXPECT_EQ(decode("\xEF\xBB\xBFLD I0.0", TextEncoding::Cp1251).text, "LD I0.0");
  const DecodedText little = decode(std::string("\xFF\xFEL\0D\0\n\0", 8), TextEncoding::Auto);
  EXPECT_EQ(little.text, "LD\n");
  EXPECT_TRUE(little.wasUtf16);
  EXPECT_EQ(decode(std::string("\xFE\xFF\0L\0D", 6), TextEncoding::Auto).text, "LD");
  const std::string unmarked(
      "L\0D\0 \0I\0"
      "0\0.\0"
      "0\0\n\0",
      16);
  EXPECT_EQ(decode(unmarked, TextEncoding::Auto).text, "LD I0.0\n");
}

TEST(EncodingTest, DamagedSequencesBecomeReplacementCharacters) {
  const DecodedText result = decode("a\xC3(b\xFF", TextEncoding::Utf8);
  EXPECT_EQ(result.text, "a\xEF\xBF\xBD(b\xEF\xBF\xBD");
  EXPECT_EQ(result.badBytes, 2U);
  EXPECT_EQ(result.firstBad, 1U);
  EXPECT_TRUE(isValidUtf8(decode(std::string("\x81\x81\x00\xFF", 4), TextEncoding::Cp1252).text));
}

TEST(EncodingTest, ValidityOfUtf8) {
  EXPECT_TRUE(isValidUtf8("abcdefghijk\xC3\xA9"));
  EXPECT_FALSE(isValidUtf8("abcdefgh\xC3"));
  EXPECT_FALSE(isValidUtf8("\xC0\x80"));          // overlong
  EXPECT_FALSE(isValidUtf8("\xED\xA0\x80"));      // surrogate
  EXPECT_FALSE(isValidUtf8("\xF4\x90\x80\x80"));  // above U+10FFFF
  EXPECT_TRUE(isValidUtf8("\xF0\x9F\x98\x80"));
}

TEST(EncodingTest, LineEndsAndControlCharacters) {
  EXPECT_EQ(decode("a\rb\r\nc", TextEncoding::Auto).text, "a\nb\r\nc");
  const DecodedText nul = decode(std::string("LD\0I0.0\n\x01", 9), TextEncoding::Auto);
  EXPECT_EQ(nul.text, "LD I0.0\n ");
  EXPECT_EQ(nul.controls, 2U);
  EXPECT_EQ(nul.firstControl, 2U);
  EXPECT_EQ(decode("LD I0.0\n\x1A", TextEncoding::Auto).controls, 0U);  // end mark of DOS editors
}

TEST(EncodingTest, ProgramsOfEveryCodePageReadTheSame) {
  const std::string head = "ORGANIZATION_BLOCK MAIN:OB1\r\nTITLE=",
                    tail = "\r\nBEGIN\r\nNetwork 1\r\nLD I0.0\r\n= Q0.0\r\nEND_ORGANIZATION_BLOCK\r\n";
  EXPECT_EQ(readText("a", head + chineseGbk + tail).pous[0].title, chineseUtf8);
  EXPECT_EQ(readText("a", head + russianCp1251 + tail).pous[0].title, russianUtf8);
  EXPECT_EQ(readText("a", head + spanishCp1252 + tail).pous[0].title, spanishUtf8);
  EXPECT_EQ(readText("a", "\xEF\xBB\xBF" + head + chineseUtf8 + tail).pous[0].title, chineseUtf8);
  const Program oldMac = readText("a", "LD I0.0\r= Q0.0\r");
  EXPECT_EQ(show(oldMac.pous[0]), "LD I0.0; = Q0.0");
  EXPECT_EQ(oldMac.sources->position(oldMac.pous[0].networks[0].instructions[1].span).line, 2U);
}

TEST(EncodingTest, TextsKeepTheBytesOfTheController) {
  EXPECT_EQ(encodeForController(russianUtf8, TextEncoding::Cp1251), russianCp1251);
  EXPECT_EQ(encodeForController(chineseUtf8, TextEncoding::Gb18030), chineseGbk);
  EXPECT_EQ(encodeForController("\xC3\xA9", TextEncoding::Utf8), "\xE9");
  EXPECT_EQ(encodeForController(chineseUtf8, TextEncoding::Cp1252), chineseUtf8);  // not in that code page
}

TEST(EncodingTest, QuotedNamesAreFoundInEveryCodePage) {
  const std::string block = "ORGANIZATION_BLOCK MAIN:OB1\r\nBEGIN\r\nNetwork 1\r\nLD \"";
  const auto programOf = [&](const std::string& name) {
    return block + name + "\"\r\n= Q0.0\r\nCALL \"" + name + "2\"\r\nEND_ORGANIZATION_BLOCK\r\nSUBROUTINE_BLOCK " +
           name + "2:SBR3\r\nBEGIN\r\nNetwork 1\r\nLD SM0.0\r\n= Q0.1\r\nEND_SUBROUTINE_BLOCK\r\nSYMBOL_TABLE\r\n" +
           name + "\tI0.0\r\nEND_SYMBOL_TABLE\r\n";
  };
  // Letters of one byte for the controller: a text in quotation marks has them, a name does not.
  for (const std::string& name : {std::string("\xEF\xF3\xF1\xEA"),
                                  std::string("\xC3\xBC"
                                              "ber"),
                                  std::string("\xB1\xC3")}) {
    const Program program = readText("a.awl", programOf(name));
    EXPECT_EQ(show(program.pous[0]), "LD I0.0; = Q0.0; CALL 3") << name;
  }
}

TEST(EncodingTest, ProblemsBecomeFindings) {
  EXPECT_EQ(
      readText(
          "a.awl",
          std::string(
              "LD\0I0.0\n= Q0.0\n// a long enough comment for the rest of the text, so that one character is little\n",
              86))
          .findings[0]
          .rule,
      "SYN004");
  ReadOptions utf8;
  utf8.encoding = TextEncoding::Utf8;
  const Program bad = readText("a.awl", "LD I0.0 // \xFF\n= Q0.0\n", utf8);
  ASSERT_EQ(bad.findings.size(), 1U);
  EXPECT_EQ(bad.findings[0].rule, "SYN003");
  EXPECT_FALSE(hasReadErrors(bad));
  const Program utf16 = readText("a.awl", std::string("\xFF\xFEN\0O\0T\0\n\0", 10));
  EXPECT_EQ(utf16.findings[0].rule, "SYN005");
  EXPECT_EQ(show(utf16.pous[0]), "NOT");
}

}  // namespace
}  // namespace rungproof
