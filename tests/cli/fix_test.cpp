// Fixes in every encoding that is read: the file keeps its encoding, its mark and its line ends, and outside of the fix
// every byte.
#include "frontend/linting/fix.hpp"

#include <gtest/gtest.h>

#include "tests/program_run.hpp"

namespace rungproof {
namespace {

int run(std::vector<std::string> arguments, std::string* out = nullptr, std::string* err = nullptr) {
  arguments.push_back("--isolated");
  test::ProgramRun result = test::run(arguments);
  if (out != nullptr) *out = std::move(result.out);
  if (err != nullptr) *err = std::move(result.err);
  return result.exit;
}

std::string utf16(const std::string& text, bool bigEndian) {
  std::string bytes = bigEndian ? "\xFE\xFF" : "\xFF\xFE";
  for (const char c : text) bytes += bigEndian ? std::string{'\0', c} : std::string{c, '\0'};
  return bytes;
}

/// A program with a comment and, at the letter O in IO.0, a fix; `fixed` says what stands there.
std::string program(const std::string& comment, const std::string& end, bool fixed) {
  return "ORGANIZATION_BLOCK MAIN:OB1" + end + "BEGIN" + end + "Network 1 // " + comment + end + "LD     I" +
         (fixed ? "0" : "O") + ".0" + end + "=      Q0.0 // " + comment + end + "END_ORGANIZATION_BLOCK" + end;
}

struct Encoded {
  const char* name;
  std::string before, after;
  std::string option{};
};

class FixEncoding : public ::testing::TestWithParam<Encoded> {};

TEST_P(FixEncoding, KeepsEveryOtherByte) {
  const test::TemporaryFolder folder;
  const std::string file = folder.file("old.awl", GetParam().before);
  std::vector<std::string> arguments = {"lint", "--fix", "--exit-zero", file};
  if (!GetParam().option.empty()) arguments.insert(arguments.end(), {"--encoding", GetParam().option});
  std::string err;
  EXPECT_EQ(run(arguments, nullptr, &err), 0) << err;
  EXPECT_EQ(test::contentOf(file), GetParam().after);
}

std::vector<Encoded> encodings() {
  const auto both = [](const char* name, const std::string& comment, const std::string& end, const std::string& mark,
                       const std::string& option = {}) {
    return Encoded{name, mark + program(comment, end, false), mark + program(comment, end, true), option};
  };
  return {
      both("Utf8", "K\xC3\xBChler", "\n", ""),
      both("Utf8Mark", "K\xC3\xBChler", "\r\n", "\xEF\xBB\xBF"),
      both("Cp1252", "K\xFChler \x80 5", "\r\n", "", "cp1252"),
      both("Cp1251", "\xCD\xE0\xF1\xEE\xF1 \xEF\xF3\xF1\xEA", "\r\n", "", "cp1251"),
      both("Cp1251Recognised", "\xCD\xE0\xF1\xEE\xF1 \xEF\xF3\xF1\xEA \xE4\xE2\xE8\xE3\xE0\xF2\xE5\xEB\xFF", "\n", ""),
      both("Gb18030", "\xB5\xE7\xBB\xFA\xC6\xF4\xB6\xAF", "\r\n", "", "gb18030"),
      both("LoneCarriageReturns", "old Macintosh", "\r", ""),
      both("MixedLineEnds", "a\r\n// b\n// c", "\r\n", ""),
      {"Utf16LittleEndian", utf16(program("pump", "\r\n", false), false), utf16(program("pump", "\r\n", true), false)},
      {"Utf16BigEndian", utf16(program("pump", "\n", false), true), utf16(program("pump", "\n", true), true)}};
}
INSTANTIATE_TEST_SUITE_P(All, FixEncoding, ::testing::ValuesIn(encodings()),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(Fix, BytesThatTheEncodingDoesNotKnowAreLeftAlone) {
  const test::TemporaryFolder folder;
  const std::string text = program("broken \xFF\xFE byte \xC3\xBC", "\n", false);
  const std::string file = folder.file("old.awl", text);
  std::string err;
  EXPECT_EQ(run({"lint", "--fix", "--encoding", "utf-8", file}, nullptr, &err), 2);
  EXPECT_NE(err.find("was not fixed: some of its bytes do not belong to its encoding"), std::string::npos) << err;
  EXPECT_EQ(test::contentOf(file), text);
}

TEST(Fix, DiffOfALastLineWithoutItsEnd) {
  const Fix fix{{0, 3, 1}, "X", true};
  EXPECT_EQ(unifiedDiff("a", "ab\nc", {&fix}),
            "--- a\n+++ a\n@@ -1,2 +1,2 @@\n ab\n-c\n\\ No newline at end of file\n+X\n\\ No newline at end of file\n");
}

TEST(Fix, DistantChangesHaveTheirOwnHunks) {
  std::string text;
  for (int i = 1; i <= 20; ++i) text += std::to_string(i) + "\n";
  const auto at = [&](const std::string& line) {
    return static_cast<std::uint32_t>(text.find("\n" + line + "\n") + 1);
  };
  const Fix three{{0, at("3"), 1}, "three", true}, nine{{0, at("9"), 1}, "nine\nand more", true},
      twenty{{0, at("20"), 2}, "twenty", true};
  EXPECT_EQ(unifiedDiff("a", text, {&three, &nine, &twenty}),
            "--- a\n+++ a\n"
            "@@ -1,12 +1,13 @@\n 1\n 2\n-3\n+three\n 4\n 5\n 6\n 7\n 8\n-9\n+nine\n+and more\n 10\n 11\n 12\n"
            "@@ -17,4 +18,4 @@\n 17\n 18\n 19\n-20\n+twenty\n");
}

}  // namespace
}  // namespace rungproof
