// A client of `rungproof lsp` that has said hello, and short ways to its usual questions.
#pragma once

#include "tests/rpc_client.hpp"

namespace rungproof::test {

inline const std::string untitled = "untitled:Press";

class EditorSession : public RpcClient {
 public:
  explicit EditorSession(const std::vector<std::string>& options = {}, const std::string& folder = {})
      : RpcClient(Framing::Headers, withCommand(options), folder) {
    hello_ = request("initialize", {{"processId", nullptr}, {"rootUri", nullptr}, {"capabilities", Json::object()}});
    notify("initialized", Json::object());
  }

  const Json& hello() const { return hello_; }
  void open(const std::string& text, const std::string& uri = untitled) {
    notify("textDocument/didOpen",
           {{"textDocument", Json{{"uri", uri}, {"languageId", "s7stl"}, {"version", 1}, {"text", text}}}});
  }
  /// Opens the text and gives the diagnostics that follow.
  Json diagnosticsOf(const std::string& text, const std::string& uri = untitled) {
    open(text, uri);
    return nextDiagnostics();
  }
  Json nextDiagnostics() { return at(notification("textDocument/publishDiagnostics"), "params/diagnostics"); }
  Json place(int line, int character, const std::string& uri = untitled) const {
    return {{"textDocument", Json{{"uri", uri}}}, {"position", Json{{"line", line}, {"character", character}}}};
  }
  Json ask(const std::string& method, int line, int character, const std::string& uri = untitled) {
    return at(request(method, place(line, character, uri)), "result");
  }
  std::string hover(int line, int character) {
    return textAt(ask("textDocument/hover", line, character), "contents/value");
  }

 private:
  static std::vector<std::string> withCommand(std::vector<std::string> options) {
    options.insert(options.begin(), "lsp");
    return options;
  }
  Json hello_;
};

/// "3:5-3:9" of a range, lines and UTF-16 units from 0.
inline std::string rangeText(const Json& range) {
  return numberAt(range, "start/line") + ":" + numberAt(range, "start/character") + "-" + numberAt(range, "end/line") +
         ":" + numberAt(range, "end/character");
}
inline std::vector<std::string> rangesOf(const Json& locations) {
  std::vector<std::string> ranges;
  for (const Json& location : locations.items()) ranges.push_back(rangeText(at(location, "range")));
  return ranges;
}
inline std::vector<std::string> textsOf(const Json& list, const std::string& path) {
  std::vector<std::string> texts;
  for (const Json& item : list.items()) texts.push_back(textAt(item, path));
  return texts;
}
/// "ADR001 1" for each: code and severity.
inline std::vector<std::string> codesOf(const Json& diagnostics) {
  std::vector<std::string> codes;
  for (const Json& diagnostic : diagnostics.items())
    codes.push_back(textAt(diagnostic, "code") + " " + numberAt(diagnostic, "severity"));
  return codes;
}

}  // namespace rungproof::test
