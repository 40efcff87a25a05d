// Patterns, names in UTF-8 and UTF-16, URIs, the identity of the executable.
#include "engine/platform/names.hpp"

#include <fnmatch.h>
#include <gtest/gtest.h>

#include <random>

#include "engine/platform/windows/shell_pattern.hpp"
#include "engine/platform/windows/utf8_units.hpp"

namespace rungproof {
namespace {

TEST(ShellPattern, StarsQuestionMarksAndSets) {
  EXPECT_TRUE(fitsPortablePattern("plant/line/press.awl", "plant/*"));  // also across folders
  EXPECT_TRUE(fitsPortablePattern("press.awl", "pr?ss.*"));
  EXPECT_TRUE(fitsPortablePattern("b", "[a-c]"));
  EXPECT_FALSE(fitsPortablePattern("b", "[!a-c]"));
  EXPECT_TRUE(fitsPortablePattern("]", "[]]"));
  EXPECT_TRUE(fitsPortablePattern("*", "\\*"));
  EXPECT_FALSE(fitsPortablePattern("a", "\\*"));
  EXPECT_TRUE(fitsPortablePattern("[a", "[a"));  // no end: a sign
  EXPECT_TRUE(fitsPortablePattern("", "*"));
  EXPECT_FALSE(fitsPortablePattern("", "?"));
}

TEST(ShellPattern, IsWhatTheCLibraryReads) {
  const unsigned seed = std::random_device()();
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  std::mt19937 random(seed);
  const std::string nameSigns = "aabb-]!*\\/", patternSigns = "aabb-]!*\\/*?[[^";
  const auto text = [&](const std::string& signs, std::size_t most) {
    std::string made;
    for (std::size_t length = random() % (most + 1); made.size() < length;) made += signs[random() % signs.size()];
    return made;
  };
  int fitting = 0;
  for (int i = 0; i < 50'000; ++i) {
    const std::string name = text(nameSigns, 6), pattern = text(patternSigns, 8);
    const bool expected = ::fnmatch(pattern.c_str(), name.c_str(), 0) == 0;
    fitting += expected ? 1 : 0;
    ASSERT_EQ(fitsPortablePattern(name, pattern), expected) << "'" << name << "' and '" << pattern << "'";
  }
  EXPECT_GT(fitting, 500);
}

/// The units of a text, or nothing if a part is no UTF-8.
std::optional<std::u16string> unitsOf(const std::string& text) {
  std::u16string units;
  unsigned pending = 0;
  for (std::size_t at = 0; at < text.size();) {
    unsigned unit = 0;
    const std::size_t taken = utf8::takeUnit(text.data() + at, text.size() - at, unit, pending);
    if (taken == utf8::invalid || taken == utf8::unfinished) return std::nullopt;
    units += static_cast<char16_t>(unit);
    at += taken == 0 ? 1 : taken;
  }
  return units;
}

TEST(Utf8Units, CharactersOfEachLength) {
  EXPECT_EQ(unitsOf("a\xC3\xBC"), u"a\u00FC");
  EXPECT_EQ(unitsOf("\xE9\x98\x80"), u"\u9600");
  EXPECT_EQ(unitsOf("\xF0\x9F\x94\xA7!"), u"\U0001F527!");
}

TEST(Utf8Units, WhatIsNoUtf8IsRefused) {
  for (const char* text : {"\xFC", "\xC3", "\xC3\x28", "\xE9\x98", "\xC0\x80", "\xE0\x80\x80", "\xED\xA0\x80",
                           "\xF4\x90\x80\x80", "\xF0\x9F\x94", "\x80"})
    EXPECT_EQ(unitsOf(text), std::nullopt) << testing::PrintToString(std::string(text));
  char room[utf8::longestCharacter];
  unsigned pending = 0;
  EXPECT_EQ(utf8::putUnit(0xDC00, room, pending), utf8::invalid);  // the second of two alone
  EXPECT_EQ(utf8::putUnit(0xD83D, room, pending), 0U);
  EXPECT_EQ(utf8::putUnit('a', room, pending), utf8::invalid);  // the first of two alone
}

TEST(Utf8Units, EveryCharacterComesBack) {
  for (char32_t code = 1; code <= 0x10FFFF; code += code < 0x900 ? 1 : 37) {
    if (code >= utf8::highFirst && code <= utf8::lowLast) continue;
    std::u16string units;
    if (code < 0x10000) {
      units = static_cast<char16_t>(code);
    } else {
      units = {static_cast<char16_t>(0xD800 + ((code - 0x10000) >> 10)),
               static_cast<char16_t>(0xDC00 + ((code - 0x10000) & 0x3FF))};
    }
    std::string text;
    unsigned pending = 0;
    for (const char16_t unit : units) {
      char room[utf8::longestCharacter];
      const std::size_t count = utf8::putUnit(unit, room, pending);
      ASSERT_NE(count, utf8::invalid);
      text.append(room, count);
    }
    ASSERT_EQ(unitsOf(text), units) << std::hex << static_cast<unsigned>(code);
  }
}

TEST(PlatformNames, HereABackslashIsASign) {
  EXPECT_EQ(plainName("a\\b"), "a\\b");
  EXPECT_EQ(nameOfUriPath("/c:/x.awl"), "/c:/x.awl");
  EXPECT_EQ(uriPathOfName("c:/x.awl"), "c:/x.awl");
  EXPECT_TRUE(fitsShellPattern("a/b.awl", "a/*"));
}

TEST(PlatformNames, TheLinkerNamesTheExecutable) {
  const std::string id = buildId();
  EXPECT_GE(id.size(), 16u);
  EXPECT_EQ(id.find_first_not_of("0123456789abcdef"), std::string::npos) << id;
}

}  // namespace
}  // namespace rungproof
