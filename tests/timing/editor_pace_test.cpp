// How long the editor server takes from a keystroke to the diagnostics, over a real pipe, for 2,000 instructions.
#include <gtest/gtest.h>

#include "tests/machine_pace.hpp"
#include "tests/rpc_client.hpp"
#include "tests/timing/two_thousand.hpp"

namespace rungproof::test {
namespace {

constexpr double mostSeconds = 0.050;  ///< from a keystroke to the diagnostics, on a quiet machine
constexpr int keystrokes = 10;

Json textDocument(int version) { return {{"uri", "untitled:Long"}, {"languageId", "s7stl"}, {"version", version}}; }

TEST(EditorPace, DiagnosticsFollowAKeystroke) {
  RpcClient client(Framing::Headers, {"lsp"});
  client.request("initialize", {{"capabilities", Json::object()}});
  Json document = textDocument(1);
  document["text"] = twoThousandInstructions();
  client.notify("textDocument/didOpen", {{"textDocument", document}});
  EXPECT_FALSE(at(client.notification("textDocument/publishDiagnostics"), "params/diagnostics").empty());
  int version = 1;
  // One letter more in the first title, seen from the moment it is sent to the moment the answer is read.
  const auto type = [&] {
    const Json place{{"line", 2}, {"character", 12}};
    client.notify(
        "textDocument/didChange",
        {{"textDocument", textDocument(++version)},
         {"contentChanges", Json::array({Json{{"range", Json{{"start", place}, {"end", place}}}, {"text", "x"}}})}});
    EXPECT_EQ(numberAt(client.notification("textDocument/publishDiagnostics"), "params/version"),
              std::to_string(version));
  };
  const double seconds = quietSeconds(type, 0, keystrokes, wallSeconds);
  std::printf("%.1f ms of %.0f ms\n", seconds * 1000, mostSeconds * 1000);
  EXPECT_LE(seconds, mostSeconds);
}

}  // namespace
}  // namespace rungproof::test
