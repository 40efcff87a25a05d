// Every form of output with every character that may come out of a program, a table or a file name: what is written is
// well-formed for the parser that reads it, and holds no character that a terminal or a build server obeys.
#include "frontend/text/safe_text.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <sstream>

#include "frontend/picture/timing_diagram.hpp"
#include "frontend/report.hpp"
#include "frontend/text/excerpt.hpp"
#include "tests/program_run.hpp"
#include "tests/trace/traces.hpp"
#define TOML_EXCEPTIONS 0
#include <toml++/toml.h>

namespace rungproof {
namespace {

using test::run;
using test::TemporaryFolder;

std::string utf8(char32_t c) {
  const auto tail = [](char32_t bits) { return static_cast<char>(0x80U | (bits & 0x3FU)); };
  if (c < 0x80) return {static_cast<char>(c)};
  if (c < 0x800) return {static_cast<char>(0xC0U | c >> 6), tail(c)};
  return {static_cast<char>(0xE0U | c >> 12), tail(c >> 6), tail(c)};
}

/// All code points below U+0500, all that change the direction of text, separators, and what is no character.
std::vector<char32_t> codePoints() {
  std::vector<char32_t> all;
  for (char32_t c = 0; c < 0x500; ++c) all.push_back(c);
  for (char32_t c = 0x200B; c <= 0x206F; ++c) all.push_back(c);
  for (const char32_t c : {0x61CU, 0xFEFFU, 0xFFFDU, 0xFFFEU, 0xFFFFU}) all.push_back(c);
  return all;
}

/// Texts that hold all of them, eight in each, and some that mean something to a form of output.
std::vector<std::string> texts() {
  std::vector<std::string> all = {
      "a\n::error::owned",        "a\r\n::error file=b::x",    "]]>",   "-->",     "\\\"'`${}", "</script>",
      "\xFF\xC0\x80\xED\xA0\x80", "$end $var wire 1 ! x $end", "%0A::", "=1+1,2;3"};
  std::string text;
  for (const char32_t c : codePoints()) {
    text += 'x' + utf8(c);
    if (text.size() < 24) continue;
    all.push_back(text);
    text.clear();
  }
  all.push_back(text + "x");
  return all;
}

/// The first hazard of an output; 0: there is none. Where a line break belongs to the form it is none.
char32_t hazardIn(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const auto first = static_cast<unsigned char>(text[i]);
    const std::size_t length = first < 0x80 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
    char32_t c = length == 1 ? first : first & (0x7FU >> length);
    for (std::size_t k = 1; k < length && i + k < text.size(); ++k)
      c = c << 6 | (static_cast<unsigned char>(text[i + k]) & 0x3FU);
    if (isHazard(c)) return c;
    i += length;
  }
  return 0;
}

/// A report all of whose texts are that text.
Report reportOf(const std::string& text) {
  Report report;
  report.command = "prove";
  auto sources = std::make_shared<SourceSet>();
  sources->add("file " + text, text + "\nLD I0.0\n");
  report.sources = sources;
  Finding finding;
  finding.rule = "ADR001";
  finding.severity = Severity::Error;
  finding.message = "message " + text;
  finding.span = {0, 0, 1};
  finding.pou = "block " + text;
  finding.network = 1;
  finding.help = "help " + text;
  finding.related.push_back({{0, 0, 1}, "related " + text});
  report.findings = {finding};
  PropertyResult property;
  property.name = "name " + text;
  property.statement = "statement " + text;
  property.notes = {"note " + text};
  property.assumptions = {"assumption " + text};
  property.networks = "networks " + text;
  property.run = {"heading " + text, "row " + text};
  property.span = Span{0, 0, 1};
  property.verdict = Outcome::Violated;
  report.properties = {property};
  report.assumptions = {"of all " + text};
  report.coverage.approximated = {"approximated " + text};
  report.coverage.leftOut = {"left out " + text};
  report.files = {"file " + text};
  return report;
}

/// A report as Context::write() sends it: the forms for people pass VisiblePieces.
std::string sentReport(std::string_view form, const Report& report) {
  std::ostringstream out;
  reporterNamed(form)->write(report, {}, out);
  const bool isForPeople = form == "human" || form == "concise" || form == "github";
  if (!isForPeople) return out.str();
  VisiblePieces visible(VisiblePieces::Colors::Hidden);
  std::string text(visible.next(out.str()));
  return text.append(visible.rest());
}

std::string joinedText(const pugi::xml_node& node) {
  std::string text = node.value();
  for (const pugi::xml_attribute& attribute : node.attributes()) text += attribute.value();
  for (const pugi::xml_node& child : node.children()) text += joinedText(child);
  return text;
}

void expectWellFormedXml(const std::string& xml, const std::string& shown) {
  pugi::xml_document document;
  const pugi::xml_parse_result result = document.load_buffer(xml.data(), xml.size(), pugi::parse_default);
  EXPECT_TRUE(result) << result.description() << " at " << result.offset << " of\n" << xml;
  EXPECT_EQ(hazardIn(xml), 0U) << xml;
  // pugixml takes characters that XML 1.0 forbids, also by number.
  EXPECT_EQ(hazardIn(joinedText(document)), 0U) << xml;
  EXPECT_NE(joinedText(document).find(shown), std::string::npos) << shown << " in\n" << xml;
}

TEST(SafeText, NoFormOfAReportHoldsAHazard) {
  std::size_t forms = 0;
  for (const Reporter* reporter : allReporters()) {
    ++forms;
    for (const std::string& text : texts()) {
      const std::string output = sentReport(reporter->name, reportOf(text));
      EXPECT_EQ(hazardIn(output), 0U) << reporter->name << ":\n" << output;
    }
  }
  EXPECT_GE(forms, 7u);
}

TEST(SafeText, JunitIsWellFormed) {
  for (const std::string& text : texts()) {
    const std::string shown = lineText(text);
    expectWellFormedXml(sentReport("junit", reportOf(text)), "message " + shown);
  }
}

TEST(SafeText, JsonKeepsEveryCharacter) {
  for (const std::string& text : texts()) {
    for (const char* form : {"json", "sarif"}) {
      const nlohmann::json json = nlohmann::json::parse(sentReport(form, reportOf(text)), nullptr, false);
      ASSERT_FALSE(json.is_discarded()) << form;
      const std::string message = form == std::string("json") ? json["findings"][0]["message"]
                                                              : json["runs"][0]["results"][0]["message"]["text"];
      EXPECT_TRUE(message == "message " + text || text[0] == '\xFF') << message;
    }
  }
}

// Runners take a line that begins with :: as a command, also behind blanks.
TEST(SafeText, NoLineOfAReportIsACommandButTheReportersOwn) {
  for (const char* form : {"human", "concise", "github", "junit"}) {
    for (const std::string& text : texts()) {
      std::istringstream lines(sentReport(form, reportOf(text)));
      for (std::string line; std::getline(lines, line);) {
        const std::size_t first = line.find_first_not_of(" \t");
        if (first == std::string::npos || line.compare(first, 2, "::") != 0) continue;
        const bool isOwn = line.starts_with("::error file=") || line.starts_with("::notice title=what this rests on::");
        EXPECT_TRUE(form == std::string("github") && first == 0 && isOwn) << line;
      }
    }
  }
  const std::string commands = sentReport("github", reportOf("a\n::error::owned"));
  EXPECT_EQ(std::count(commands.begin(), commands.end(), '\n'), 3) << commands << "a finding, a property, their basis";
}

TEST(SafeText, ConciseIsOneLineForEachResult) {
  for (const std::string& text : texts()) {
    const std::string lines = sentReport("concise", reportOf(text));
    EXPECT_EQ(std::count(lines.begin(), lines.end(), '\n'), 3) << lines << "a finding, a property, what was left out";
  }
}

TEST(SafeText, TracesAreWellFormedInEveryForm) {
  for (const std::string& text : texts()) {
    Trace trace = sampleTrace();
    trace.signals[1].symbol = text;
    trace.signals[2].name = text;
    expectWellFormedXml(written(trace, ".svg", text), "");
    EXPECT_FALSE(nlohmann::json::parse(written(trace, ".json", text), nullptr, false).is_discarded());
    for (const char* ending : {".csv", ".vcd", ".json", ".svg", ".html"})
      EXPECT_EQ(hazardIn(written(trace, ending, text)), 0U) << ending << '\n' << written(trace, ending, text);
    const std::string table = written(trace, ".csv", text);
    EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 4) << table;
    const std::string dump = written(trace, ".vcd", text);
    EXPECT_EQ(dump.find("$end $var wire 1 ! x"), std::string::npos) << dump;
    const std::string page = written(trace, ".html", text);
    EXPECT_EQ(page.find("</script>", page.find("</script>") + 9), page.rfind("</script>")) << "two scripts";
  }
}

TEST(SafeText, TomlReadsBackWhatWasWritten) {
  for (const std::string& text : texts()) {
    const std::string toml = "key = " + tomlText(text) + "\n";
    const toml::parse_result result = toml::parse(toml);
    ASSERT_TRUE(static_cast<bool>(result)) << toml;
    EXPECT_EQ(hazardIn(toml), 0U);
    EXPECT_TRUE(result["key"].value<std::string>() == text || text[0] == '\xFF') << toml;
  }
}

TEST(SafeText, ConfigIsTomlForEveryValue) {
  const TemporaryFolder folder;
  for (const std::string& text : {std::string("a\"b"), std::string("a\\b"), std::string("\x1B[2J"), utf8(0x202E)}) {
    const test::ProgramRun result = run({"config", "--isolated", "--stdin-filename", text});
    ASSERT_EQ(result.exit, 0) << result.err;
    const toml::parse_result parsed = toml::parse(result.out);
    ASSERT_TRUE(static_cast<bool>(parsed)) << result.out;
    EXPECT_EQ(hazardIn(result.out), 0U);
  }
  const std::string file = folder.file("rungproof.toml", "inputs = [\"a\\\"b\\u001B.awl\"]\n");
  const test::ProgramRun result = run({"config", "--config", file});
  const toml::parse_result parsed = toml::parse(result.out);
  ASSERT_TRUE(static_cast<bool>(parsed)) << result.out;
  ASSERT_NE(parsed["inputs"].as_array(), nullptr) << result.out;
  EXPECT_TRUE(parsed["inputs"][0].value<std::string>()->ends_with("a\"b\x1B.awl")) << result.out;
}

TEST(SafeText, MessagesOfTheProgramAreVisible) {
  for (const char* name : {"\x1B[2J", "a\nb",
                           "\xC2\x9B"
                           "2J",
                           "a\rb", "\xE2\x80\xAE"}) {
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{"lint", name}, {name}, {"lint", "--cpu", name, "x"}, {"explain", name}}) {
      const test::ProgramRun result = run(arguments);
      EXPECT_NE(result.exit, 0);
      EXPECT_EQ(hazardIn(result.err + result.out), 0U) << result.err << result.out;
      EXPECT_EQ((result.err + result.out).find("\nb"), std::string::npos) << result.err;
    }
  }
}

// XML forbids &#27; and keeps &#10; in the value of an attribute: neither reaches a terminal or begins a line.
TEST(SafeText, NamesOfDrawingsAreOnOneLine) {
  const TemporaryFolder folder;
  const std::string plcopen = folder.file(
      "a.xml",
      "<project xmlns=\"http://www.plcopen.org/xml/tc6_0201\"><types><dataTypes/><pous><pou name=\"a&#10;::error::own"
      "ed&#27;[2J\" pouType=\"program\"><interface><localVars><variable name=\"b&#10;::error::owned\" address=\"%QX0.0"
      "\"><type><BOOL/></type></variable></localVars></interface><body><LD><coil localId=\"2\"><position x=\"1\" y=\"1"
      "\"/><variable>b&#10;::error::owned</variable></coil></LD></body></pou></pous></types></project>");
  const std::string simatic = folder.file(
      "b.xml",
      "<Document><SW.Blocks.OB ID=\"1\"><AttributeList><Name>Main</Name></AttributeList></SW.Blocks.OB>"
      "<SW.Tags.PlcTagTable ID=\"0\"><ObjectList><SW.Tags.PlcTag ID=\"1\"><AttributeList><DataTypeName>Odd"
      "</DataTypeName><Name>b&#10;::error::owned&#27;[2J</Name></AttributeList></SW.Tags.PlcTag></ObjectList></SW.Tags."
      "PlcTagTable></Document>");
  for (const std::string& file : {plcopen, simatic}) {
    for (const char* form : {"human", "concise", "github"}) {
      const test::ProgramRun result = run({"lint", "--isolated", "--format", form, file});
      EXPECT_EQ(result.out.find("\n::error::owned"), std::string::npos) << result.out;
      EXPECT_EQ(hazardIn(result.out + result.err), 0U) << result.out;
      EXPECT_NE(result.out.find("SYN004"), std::string::npos) << result.out;
    }
    for (const char* command : {"show", "xref"}) {
      const test::ProgramRun result = run({command, "--isolated", file});
      EXPECT_EQ((result.out + result.err).find("\n::error::owned"), std::string::npos) << result.out;
      EXPECT_EQ(hazardIn(result.out + result.err), 0U) << command << '\n' << result.out;
    }
  }
}

// A comment that shows another order than the one that runs ("Trojan source"), and C1 in it.
TEST(SafeText, CommentsOfProgramsAreVisible) {
  const TemporaryFolder folder;
  const std::string file = folder.file("a.awl", test::mainBlock("NETWORK 1 // \xE2\x80\xAEon\xE2\x81\xA6 \xC2\x9B"
                                                                "2J\nLD I0.0 // \xE2\x80\xAB\n= Q0.0\n= Q9.9\n"));
  for (const char* command : {"lint", "show", "xref", "check"}) {
    const test::ProgramRun result = run({command, "--isolated", file});
    EXPECT_EQ(hazardIn(result.out + result.err), 0U) << command << '\n' << result.out;
  }
  EXPECT_NE(run({"show", "--isolated", file}).out.find("<U+202E>on<U+2066>"), std::string::npos)
      << run({"show", "--isolated", file}).out;
  expectWellFormedXml(run({"show", "--isolated", "--svg", file}).out, "<U+202E>on<U+2066>");
}

TEST(SafeText, PiecesMayEndAnywhere) {
  const std::string text = "a\x1B[1;31mred\x1B[0m \xE2\x80\xAE \x1B[2Kb \xC3\xA9 \xF0\x9F\x98\x80 \x1B";
  const std::string shown = "a\x1B[1;31mred\x1B[0m <U+202E> \xE2\x90\x9B[2Kb \xC3\xA9 \xF0\x9F\x98\x80 \xE2\x90\x9B";
  for (std::size_t size = 1; size <= text.size(); ++size) {
    VisiblePieces pieces(VisiblePieces::Colors::Kept);
    std::string result;
    for (std::size_t at = 0; at < text.size(); at += size) result += pieces.next(text.substr(at, size));
    EXPECT_EQ(result.append(pieces.rest()), shown) << "in pieces of " << size;
  }
  EXPECT_EQ(displayWidth("\xE2\x80\xAE"), 8) << "as shown: <U+202E>";
}

}  // namespace
}  // namespace rungproof
