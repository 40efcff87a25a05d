// The extension for Visual Studio Code: its word lists are those of the tool, and its files fit together.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "frontend/property/property_types.hpp"
#include "ir/s7200/isa.hpp"
#include "tests/rpc_client.hpp"

namespace rungproof::test {
namespace {

const std::filesystem::path extensionFolder = RUNGPROOF_SOURCE_DIR "/frontend/editor/vscode";

Json partOf(const std::string& name) {
  std::ifstream stream(extensionFolder / name);
  std::ostringstream text;
  text << stream.rdbuf();
  const std::optional<Json> json = Json::read(text.str());
  EXPECT_TRUE(json.has_value()) << name << " is not JSON";
  return json.value_or(nullptr);
}

/// "LDW>=|LDW>": longer words first, so that none hides behind its beginning; signs of regular expressions escaped.
std::string alternatives(const std::set<std::string>& words) {
  std::vector<std::string> sorted(words.begin(), words.end());
  std::ranges::stable_sort(sorted, [](const std::string& a, const std::string& b) { return a.size() > b.size(); });
  std::string text;
  for (const std::string& word : sorted) {
    if (!text.empty()) text += '|';
    for (const char c : word) {
      if (std::string_view("+*.?()[]{}^$|\\").find(c) != std::string_view::npos) text += '\\';
      text += c;
    }
  }
  return text;
}

TEST(Extension, TheGrammarKnowsEveryMnemonic) {
  std::set<std::string> words;
  for (const Desc& desc : s7200Instructions().all()) {
    if (desc.drawingOnly) continue;
    words.emplace(desc.stl);
    if (!desc.german.empty()) words.emplace(desc.german);
  }
  EXPECT_GT(words.size(), 250u);
  EXPECT_EQ(textAt(partOf("stl.tmLanguage.json"), "repository/instruction/match"),
            "(?i)^\\s*(" + alternatives(words) + ")(?=\\s|,|;|/|$)");
}

TEST(Extension, TheGrammarKnowsEveryPropertyWord) {
  std::set<std::string> words;
  for (const std::string_view word : propertyKeywords()) words.emplace(word);
  EXPECT_EQ(textAt(partOf("properties.tmLanguage.json"), "repository/statement/patterns/1/match"),
            "(?i)\\b(" + alternatives(words) + ")\\b");
}

TEST(Extension, EveryFileThatItNamesIsThere) {
  const Json package = partOf("package.json");
  std::vector<std::string> named = {textAt(package, "main")};
  for (const char* place :
       {"contributes/languages/0/configuration", "contributes/languages/1/configuration",
        "contributes/languages/2/configuration", "contributes/grammars/0/path", "contributes/grammars/1/path"})
    named.push_back(textAt(package, place));
  for (const std::string& name : named) {
    ASSERT_FALSE(name.empty());
    EXPECT_TRUE(std::filesystem::exists(extensionFolder / name)) << name;
    EXPECT_TRUE(!name.ends_with(".json") || partOf(name).kind() == Json::Kind::Object) << name;
  }
  EXPECT_FALSE(textAt(package, "license").empty());
  EXPECT_EQ(textAt(package, "contributes/grammars/0/scopeName"), textAt(partOf("stl.tmLanguage.json"), "scopeName"));
}

}  // namespace
}  // namespace rungproof::test
