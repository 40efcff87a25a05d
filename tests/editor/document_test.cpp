// Places in UTF-16 units, changes, URIs.
#include "frontend/editor/document.hpp"

#include <gtest/gtest.h>

namespace rungproof {
namespace {

// One unit each: л (2 bytes), 中 (3 bytes); two units: 😀 (4 bytes).
const std::string mixed = "aл中😀b\r\nüx\n";

TEST(ClientPlace, CountsUtf16Units) {
  const auto offset = [](std::uint32_t line, std::uint32_t character) { return offsetOf(mixed, {line, character}); };
  EXPECT_EQ(offset(0, 0), 0u);
  EXPECT_EQ(offset(0, 1), 1u);
  EXPECT_EQ(offset(0, 2), 3u);
  EXPECT_EQ(offset(0, 3), 6u);
  EXPECT_EQ(offset(0, 4), 6u);  // in the middle of the pair: its beginning
  EXPECT_EQ(offset(0, 5), 10u);
  EXPECT_EQ(offset(0, 99), 11u);  // the end of the line
  EXPECT_EQ(offset(1, 1), 15u);   // behind \r\n and ü
  EXPECT_EQ(offset(2, 0), mixed.size());
  EXPECT_EQ(offset(9, 9), mixed.size());
}

TEST(ClientPlace, GoesThereAndBack) {
  const SourceFile file("a", mixed);
  for (const std::uint32_t offset : {0U, 1U, 3U, 6U, 10U, 11U, 13U, 15U, 16U, 17U})
    EXPECT_EQ(offsetOf(mixed, placeOf(file, offset)), offset);
  EXPECT_EQ(placeOf(file, 10), (ClientPlace{0, 5}));
  EXPECT_EQ(placeOf(file, 15), (ClientPlace{1, 1}));
  EXPECT_EQ(placeOf(file, 1000), (ClientPlace{2, 0}));
}

TEST(ClientPlace, ALoneCarriageReturnEndsALine) { EXPECT_EQ(offsetOf("a\rb\nc", {2, 0}), 4u); }

Json changeOf(int fromLine, int from, int toLine, int to, const std::string& text) {
  return {{"range", Json{{"start", Json{{"line", fromLine}, {"character", from}}},
                         {"end", Json{{"line", toLine}, {"character", to}}}}},
          {"text", text}};
}

TEST(Document, TakesChanges) {
  Document document{"u", "p", 1, mixed};
  EXPECT_TRUE(applyChange(document, changeOf(0, 3, 0, 5, "!")));  // the pair
  EXPECT_EQ(document.text, "aл中!b\r\nüx\n");
  EXPECT_TRUE(applyChange(document, changeOf(0, 5, 1, 1, "")));  // from behind b to behind ü
  EXPECT_EQ(document.text, "aл中!bx\n");
  EXPECT_TRUE(applyChange(document, changeOf(1, 0, 1, 0, "end")));
  EXPECT_EQ(document.text, "aл中!bx\nend");
  EXPECT_TRUE(applyChange(document, changeOf(1, 3, 0, 0, "?")));  // ends before it begins: an insertion
  EXPECT_EQ(document.text, "aл中!bx\nend?");
  EXPECT_TRUE(applyChange(document, {{"text", "all new"}}));
  EXPECT_EQ(document.text, "all new");
  EXPECT_FALSE(applyChange(document, {{"range", nullptr}, {"text", "x"}}));
  EXPECT_FALSE(applyChange(document, {{"text", 7}}));
  EXPECT_EQ(document.text, "all new");
}

TEST(Uri, IsAPathAndBack) {
  EXPECT_EQ(pathOfUri("file:///tmp/a%20b/%D0%BB.awl", "."), "/tmp/a b/л.awl");
  EXPECT_EQ(uriOfPath("/tmp/a b/л.awl"), "file:///tmp/a%20b/%D0%BB.awl");
  EXPECT_EQ(pathOfUri("file://host/tmp/x", "."), "/tmp/x");
  EXPECT_EQ(pathOfUri("untitled:Press", "/w"), "/w/Press");
  EXPECT_EQ(pathOfUri("vscode-vfs://github/a/b.awl", "/w"), "/w/b.awl");
  EXPECT_EQ(pathOfUri("file:///a%2", "."), "/a%2");
  EXPECT_EQ(pathOfUri("", "/w"), "/w/untitled");
}

}  // namespace
}  // namespace rungproof
