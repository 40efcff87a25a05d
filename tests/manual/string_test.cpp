// String instructions (001:6067-6254): the manual's examples, borders, overlap, and the open points.
#include "example.hpp"

namespace rungproof::manual {
namespace {

/// A plant with strings in V; statements run with power flow.
struct Text {
  explicit Text(const std::string& statements, Target target = {}) : plant("LD SM0.0; " + statements, target) {}
  Text& put(std::uint32_t byte, std::string_view characters) {
    auto& v = plant.store.area(Area::V);
    v[byte] = static_cast<std::uint8_t>(characters.size());
    std::copy(characters.begin(), characters.end(), v.begin() + byte + 1);
    return *this;
  }
  std::string at(std::uint32_t byte) {
    const auto* start = plant.store.area(Area::V).data() + byte;
    return {start + 1, start + 1 + *start};
  }
  Text& choose(std::string_view key, std::string_view name) {
    EXPECT_TRUE(plant.choices.set(key, name));
    return *this;
  }
  Text& run() {
    before = plant.store;
    setReadings(before, plant.choices);
    plant.scan();
    return *this;
  }
  /// Nothing but ENO and SM4.3 changed, and that error was met.
  bool refused(Hazard hazard) {
    plant.set("ENO[0]", before.get(Reg::Eno, 0));
    const bool logged = plant.value("SM4.3") == 1;
    plant.set("SM4.3", 0);
    return logged && plant.outside.hazards() == std::vector<Hazard>{hazard} && plant.store == before;
  }
  Plant plant;
  Concrete::Store before;
};

}  // namespace

TEST(Strings, ExampleOfAppendCopyLength) {
  Text text("SCAT \"WORLD\", VB0; SCPY VB0, VB100; SLEN VB100, AC0");
  text.put(0, "HELLO ").run();
  EXPECT_EQ(text.at(0), "HELLO WORLD");
  EXPECT_EQ(text.at(100), "HELLO WORLD");
  EXPECT_EQ(text.plant.value("AC0"), 11U);
  EXPECT_EQ(text.plant.value("ENO[0]"), 1U);
  EXPECT_TRUE(text.plant.outside.hazards().empty());
  EXPECT_EQ(text.plant.value("VB12"), 0U) << "nothing behind the string";
}

TEST(Strings, LengthOfConstantsAndOddLengths) {
  check({
      {"SLEN \"ABC\", VB0", "", "VB0=3"},
      {"SLEN VB10, VB0", "VB10=254 VB0=1", "VB0=254"},
      {"SLEN VB10, VB0", "VB10=255 VB0=1", "", "0091"},
      {"SLEN VB10239, VB0", "VB0=9", "VB0=0"},
      {"SLEN VB10239, VB0", "VB10239=1 VB0=9", "", "0091"},
      {"SLEN *VD0, VB8", "VD0=16#08000064 VB100=7", "VB8=7"},
      {"SLEN *VD0, VB8", "VD0=16#FF000064", "", "0006"},
      {"LDN SM0.0; SLEN \"ABC\", VB0", "", "ENO[0]=0"},
  });
}

TEST(Strings, CopyMovesLengthAndCharactersOnly) {
  check({
      {"SCPY \"AB\", VB0", "VB0=9 VB3=7", "VB0=2 VB1=65 VB2=66"},
      {"SCPY VB10, VB0", "VB0=9 VB1=1", "VB0=0"},
      {"SCPY VB10, VB10238", "VB10=1 VB11=65", "VB10238=1 VB10239=65"},
      {"SCPY VB10, VB10238", "VB10=2 VB11=65", "", "0091"},
      {"SCPY VB10, VB0", "VB10=255", "", "0091"},
      {"SCPY VB0, VB1", "VB0=2 VB1=65 VB2=66",
       "VB1=2 VB2=2 VB3=2"},  // each byte is read after the one before was written
      {"SCPY VB0, VB1", "VB0=2 VB1=65 VB2=66", "VB1=2 VB2=65 VB3=66", "", "block-move-overlap=buffered"},
      {"SCPY VB1, VB0", "VB1=2 VB2=65 VB3=66", "VB0=2 VB1=65 VB2=66"},
  });
}

TEST(Strings, AppendRespectsTheLongestString) {
  const std::string longest(254, 'x');
  for (const bool cut : {false, true}) {
    Text text("SCAT VB300, VB0");
    text.choose("string-overflow", cut ? "cut" : "unchanged").put(0, longest.substr(0, 252)).put(300, "abc").run();
    EXPECT_EQ(text.plant.outside.hazards(), std::vector<Hazard>{Hazard::OutOfRange});
    EXPECT_EQ(text.at(0), longest.substr(0, 252) + (cut ? "ab" : ""));
    EXPECT_EQ(text.plant.value("ENO[0]"), 0U);
  }
  Text full("SCAT VB300, VB0");
  full.put(0, longest.substr(0, 252)).put(300, "ab").run();
  EXPECT_EQ(full.at(0), longest.substr(0, 252) + "ab");
  EXPECT_TRUE(full.plant.outside.hazards().empty());
  Text border("SCAT \"ab\", VB10237");
  EXPECT_TRUE(border.put(10237, "x").run().refused(Hazard::OutOfRange));
  Text illegal("SCAT VB300, VB0");
  illegal.plant.set("VB0=255");
  EXPECT_TRUE(illegal.put(300, "a").run().refused(Hazard::OutOfRange));
  Text itself("SCAT VB0, VB0");
  EXPECT_EQ(itself.put(0, "ab").run().at(0), "abab");
}

TEST(Strings, SubstringOfTheManual) {
  Text text("SSCPY VB0, 7, 5, VB20");
  text.put(0, "HELLO WORLD").run();
  EXPECT_EQ(text.at(20), "WORLD");
  EXPECT_EQ(text.at(0), "HELLO WORLD");
  EXPECT_EQ(text.plant.value("ENO[0]"), 1U);
}

TEST(Strings, SubstringBorders) {
  const std::string source = "VB0=3 VB1=65 VB2=66 VB3=67 VB20=9 ";
  check({
      {"SSCPY VB0, 1, 1, VB20", source, "VB20=1 VB21=65"},
      {"SSCPY VB0, 3, 1, VB20", source, "VB20=1 VB21=67"},
      {"SSCPY VB0, 2, 0, VB20", source, "VB20=0"},
      {"SSCPY VB0, 2, 9, VB20", source, "VB20=2 VB21=66 VB22=67"},
      {"SSCPY VB0, 4, 1, VB20", source, "VB20=0"},
      {"SSCPY VB0, 2, 9, VB20", source, "", "0091", "substring-beyond-end=error"},
      {"SSCPY VB0, 2, 2, VB20", source, "VB20=2 VB21=66 VB22=67", "", "substring-beyond-end=error"},
      {"SSCPY VB0, 0, 1, VB20", source, "", "009B"},
      {"SSCPY VB0, VB30, VB31, VB20", source + "VB30=2 VB31=1", "VB20=1 VB21=66"},
      {"SSCPY \"XYZ\", 2, 2, VB20", "", "VB20=2 VB21=89 VB22=90"},
      {"SSCPY VB0, 1, 3, VB10237", source, "", "0091"},
  });
}

TEST(Strings, FindTextExample) {
  // 001:6204-6222: "Turn Pump On" holds "On" at 11; "Off" is not in it.
  Text text("MOVB 1, AC0; SFND VB0, VB20, AC0; MOVB 1, AC1; SFND VB0, VB30, AC1");
  text.put(0, "Turn Pump On").put(20, "On").put(30, "Off").run();
  EXPECT_EQ(text.plant.value("AC0"), 11U);
  EXPECT_EQ(text.plant.value("AC1"), 0U);
}

TEST(Strings, FindCharacterExample) {
  // 001:6230-6252: first digit or sign of "Temp  98.6F" is at 7.
  Text text("MOVB 1, AC0; CFND VB0, VB20, AC0");
  text.put(0, "Temp  98.6F").put(20, "1234567890+-").run();
  EXPECT_EQ(text.plant.value("AC0"), 7U);
}

TEST(Strings, FindStartsAtOut) {
  struct Row {
    const char *statement, *text, *pattern;
    int start, expected;
  };
  const Row rows[] = {
      {"SFND", "abcabc", "abc", 1, 1}, {"SFND", "abcabc", "abc", 2, 4}, {"SFND", "abcabc", "abc", 4, 4},
      {"SFND", "abcabc", "abc", 5, 0}, {"SFND", "aab", "ab", 1, 2},     {"SFND", "abc", "abcd", 1, 0},
      {"SFND", "abc", "c", 3, 3},      {"SFND", "abc", "", 2, 0},       {"SFND", "", "a", 1, 0},
      {"SFND", "abc", "b", 9, 0},      {"CFND", "abc", "cb", 1, 2},     {"CFND", "abc", "cb", 3, 3},
      {"CFND", "abc", "xyz", 1, 0},    {"CFND", "abc", "", 1, 0},       {"CFND", "abc", "a", 2, 0},
      {"CFND", "abca", "a", 2, 4},
  };
  for (const Row& row : rows) {
    Text text(std::string(row.statement) + " VB0, VB100, VB200");
    text.put(0, row.text).put(100, row.pattern);
    // Behind the strings lies what would match if it counted.
    text.plant.set("VB4=97 VB5=98 VB6=99 VB7=100");
    text.put(0, row.text);
    text.plant.set("VB200", static_cast<std::uint64_t>(row.start));
    text.run();
    EXPECT_EQ(text.plant.value("VB200"), static_cast<std::uint64_t>(row.expected))
        << row.statement << " " << row.text << " " << row.pattern << " " << row.start;
    EXPECT_TRUE(text.plant.outside.hazards().empty());
    EXPECT_EQ(text.plant.value("ENO[0]"), 1U);
  }
}

TEST(Strings, FindErrorsAndChoices) {
  Text zero("SFND VB0, VB100, VB200");
  EXPECT_TRUE(zero.put(0, "abc").put(100, "a").run().refused(Hazard::StringIndexZero));
  Text zeroCharacter("CFND VB0, VB100, VB200");
  EXPECT_TRUE(zeroCharacter.put(0, "abc").put(100, "a").run().refused(Hazard::StringIndexZero));
  Text beyond("SFND VB0, VB100, VB200");
  beyond.choose("find-start-beyond", "error").plant.set("VB200=4");
  EXPECT_TRUE(beyond.put(0, "abc").put(100, "a").run().refused(Hazard::OutOfRange));
  Text empty("SFND VB0, VB100, VB200");
  empty.choose("find-empty", "at-start").plant.set("VB200=2");
  EXPECT_EQ(empty.put(0, "abc").run().plant.value("VB200"), 2U);
  Text longText("CFND VB0, VB100, VB200");
  longText.plant.set("VB0=255 VB200=1");
  EXPECT_TRUE(longText.put(100, "a").run().refused(Hazard::OutOfRange));
  Text longPattern("CFND VB0, VB100, VB200");
  longPattern.plant.set("VB100=255 VB200=1");
  EXPECT_TRUE(longPattern.put(0, "a").run().refused(Hazard::OutOfRange));
}

}  // namespace rungproof::manual
