// The pages of the guide: well-formed, every link leads to a page and a place, nothing of the tables is missing.
#include "frontend/guide/site.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <pugixml.hpp>
#include <set>

#include "analysis/rule.hpp"
#include "frontend/cli/cli.hpp"
#include "frontend/explain/idea_page.hpp"
#include "frontend/settings/code_list.hpp"
#include "frontend/settings/options.hpp"
#include "ir/machine/choices.hpp"

namespace rungproof {
namespace {

const std::vector<GuideFile>& pages() {
  static const std::vector<GuideFile> all = guidePages();
  return all;
}

const std::string& page(const std::string& name) {
  for (const GuideFile& file : pages()) {
    if (file.name == name) return file.text;
  }
  static const std::string none;
  return none;
}

void forEachElement(const pugi::xml_node& node, const std::function<void(const pugi::xml_node&)>& visit) {
  for (const pugi::xml_node& child : node.children()) {
    if (child.type() == pugi::node_element) visit(child);
    forEachElement(child, visit);
  }
}

TEST(Guide, EveryPageIsWellFormedAndEveryLinkLeadsSomewhere) {
  std::map<std::string, std::set<std::string>> places;
  std::vector<std::pair<std::string, std::string>> links;
  for (const GuideFile& file : pages()) {
    pugi::xml_document document;
    const pugi::xml_parse_result parsed = document.load_buffer(file.text.data(), file.text.size());
    EXPECT_TRUE(parsed) << file.name << ": " << parsed.description();
    std::set<std::string>& own = places[file.name];
    forEachElement(document, [&](const pugi::xml_node& node) {
      if (const auto id = node.attribute("id")) {
        EXPECT_TRUE(own.insert(id.value()).second) << file.name << " " << id.value();
      }
      if (const auto link = node.attribute("href")) links.emplace_back(file.name, link.value());
      EXPECT_FALSE(node.attribute("src")) << file.name;
    });
  }
  for (const auto& [from, link] : links) {
    const std::size_t sign = std::min(link.find('#'), link.size());
    const std::string target = sign == 0 ? from : link.substr(0, sign);
    ASSERT_TRUE(places.contains(target)) << from << " leads to " << link;
    if (sign < link.size()) {
      EXPECT_TRUE(places[target].contains(link.substr(sign + 1))) << from << " leads to " << link;
    }
  }
  EXPECT_EQ(pages().front().name, "index.html");
  EXPECT_GT(links.size(), 100u);
}

TEST(Guide, HoldsEveryRowOfTheTables) {
  for (const Rule* rule : allRules())
    EXPECT_NE(page("rules.html").find("id=\"" + std::string(rule->id) + "\""), std::string::npos) << rule->id;
  for (const Code& code : allCodes()) EXPECT_NE(page("rules.html").find(code.id), std::string::npos) << code.id;
  for (const Command* command : allCommands())
    EXPECT_NE(page("commands.html").find("<h2 id=\"" + std::string(command->name) + "\""), std::string::npos);
  for (const CpuRow& row : cpu_rows::rows)
    EXPECT_NE(page("cpus.html").find("id=\"" + std::string(row.name) + "\""), std::string::npos) << row.name;
  for (const ChoiceInfo& choice : choiceTable)
    EXPECT_NE(page("choices.html").find("id=\"" + std::string(choice.key) + "\""), std::string::npos) << choice.key;
  for (const OptionInfo& info : optionTable()) {
    if (!info.inConfig || info.group == option_group::Hidden) continue;
    EXPECT_NE(page("configuration.html").find("<code>" + std::string(info.name) + "</code>"), std::string::npos);
  }
  for (const Idea& idea : ideas())
    EXPECT_NE(page("words.html").find("<b>" + std::string(idea.name) + "</b>"), std::string::npos) << idea.name;
}

TEST(Guide, EveryPatternHasAPicture) {
  const std::string html = patternSection();
  const auto count = [&](std::string_view part) {
    std::size_t n = 0;
    for (std::size_t at = html.find(part); at != std::string::npos; at = html.find(part, at + 1)) ++n;
    return n;
  };
  EXPECT_EQ(count("<h3>"), 12u);
  EXPECT_EQ(count("<figure class=\"wave\">"), count("<h3>")) << "a property that the sample does not break";
  EXPECT_EQ(count("A run that comes there"), 1u);
}

}  // namespace
}  // namespace rungproof
