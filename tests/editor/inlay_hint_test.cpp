// Symbols beside addresses, addresses beside symbols, seconds beside presets.
#include "tests/editor/editor_session.hpp"

namespace rungproof::test {
namespace {

std::vector<std::string> hints(EditorSession& session, int first, int last) {
  const Json hints =
      at(session.request("textDocument/inlayHint", {{"textDocument", Json{{"uri", untitled}}},
                                                    {"range", Json{{"start", Json{{"line", first}, {"character", 0}}},
                                                                   {"end", Json{{"line", last}, {"character", 0}}}}}}),
         "result");
  std::vector<std::string> rows;
  for (const Json& hint : hints.items())
    rows.push_back(numberAt(hint, "position/line") + ":" + numberAt(hint, "position/character") + " " +
                   textAt(hint, "label"));
  return rows;
}

// T37 counts 100 ms (001:1440), T33 10 ms, T32 1 ms: 100 of each are 10 s, 1 s and 0.1 s.
TEST(InlayHint, SaysWhatAReaderLooksUp) {
  EditorSession session;
  session.open(
      "SYMBOL_TABLE\nStart,I0.0,\nEND_SYMBOL_TABLE\nORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD I0.0\nA Start\n"
      "TON T37, +100\nTON T33, +100\nTON T32, VW2\nNetwork 2\nLD T37\n= Q0.0\nEND_ORGANIZATION_BLOCK\n");
  using Rows = std::vector<std::string>;
  EXPECT_EQ(hints(session, 0, 15), (Rows{"6:7 Start", "7:7 I0.0", "8:13 = 10 s", "9:13 = 1 s"}));
  EXPECT_EQ(hints(session, 9, 10), (Rows{"9:13 = 1 s"}));
}

}  // namespace
}  // namespace rungproof::test
