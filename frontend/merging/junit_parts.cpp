// Parts in the JUnit form: the suites of files once, the properties of all parts in one suite.
#include <fmt/format.h>

#include <pugixml.hpp>
#include <set>
#include <sstream>

#include "frontend/merging/report_parts.hpp"
#include "frontend/text/text_stream.hpp"

namespace rungproof {

namespace {

std::optional<PartMark> markIn(const pugi::xml_document& document) {
  const pugi::xml_node mark = document.child("testsuites")
                                  .child("testsuite")
                                  .child("properties")
                                  .find_child_by_attribute("property", "name", "shard");
  const std::optional<Json> value = Json::read(mark.attribute("value").as_string());
  return value ? markOf(*value) : std::nullopt;
}

std::string printedNode(pugi::xml_node node) {
  TextStream text;
  node.print(text, "", pugi::format_raw);
  return text.str();
}

unsigned long long sumOf(pugi::xml_node root, const char* attribute) {
  unsigned long long sum = 0;
  for (const pugi::xml_node suite : root.children("testsuite")) sum += suite.attribute(attribute).as_ullong();
  return sum;
}

/// Cases that the suite does not have yet, and its counts anew.
void addCases(pugi::xml_node suite, pugi::xml_node more) {
  std::set<std::string> known;
  for (const pugi::xml_node test : suite.children("testcase")) known.insert(printedNode(test));
  for (const pugi::xml_node test : more.children("testcase")) {
    if (known.insert(printedNode(test)).second) suite.append_copy(test);
  }
  unsigned long long tests = 0, failures = 0, skipped = 0;
  for (const pugi::xml_node test : suite.children("testcase")) {
    ++tests;
    failures += test.child("failure").empty() ? 0 : 1;
    skipped += test.child("skipped").empty() ? 0 : 1;
  }
  suite.attribute("tests") = tests;
  suite.attribute("failures") = failures;
  suite.attribute("skipped") = skipped;
}

}  // namespace

JoinResult joinJunit(const std::vector<PartFile>& files) {
  std::vector<pugi::xml_document> documents(files.size());
  std::vector<std::optional<PartMark>> marks;
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (!documents[i].load_string(files[i].text.c_str()))
      return Failure{fmt::format("'{}' is no XML", files[i].name), {}, "join files of one form"};
    marks.push_back(markIn(documents[i]));
  }
  const auto order = orderOfParts(files, marks);
  if (const Failure* failure = std::get_if<Failure>(&order)) return *failure;
  pugi::xml_document whole;
  pugi::xml_node declaration = whole.append_child(pugi::node_declaration);
  declaration.append_attribute("version") = "1.0";
  declaration.append_attribute("encoding") = "UTF-8";
  pugi::xml_node root = whole.append_child("testsuites");
  root.append_attribute("name") = "rungproof";
  for (const std::size_t i : std::get<std::vector<std::size_t>>(order)) {
    for (pugi::xml_node suite : documents[i].child("testsuites").children("testsuite")) {
      suite.remove_child("properties");
      const pugi::xml_node same =
          root.find_child_by_attribute("testsuite", "name", suite.attribute("name").as_string());
      addCases(same ? same : root.append_copy(suite), same ? suite : pugi::xml_node());
    }
  }
  for (const char* count : {"tests", "failures", "errors"}) root.append_attribute(count) = sumOf(root, count);
  TextStream text;
  whole.save(text, "  ");
  return JoinedReport{text.str(), worstExit(marks)};
}

}  // namespace rungproof
