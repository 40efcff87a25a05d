// Trace forms that other programs read: VCD by a strict reader of our own, WaveDrom and the page's data as JSON, SVG as
// XML.
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <set>

#include "frontend/picture/timing_diagram.hpp"
#include "tests/trace/traces.hpp"

namespace rungproof {
namespace {

/// Reads a VCD as IEEE 1364 defines it and refuses everything else.
struct Vcd {
  std::map<std::string, std::string> names;                             ///< identifier to reference
  std::map<std::string, int> widths;                                    ///< by identifier; 0: real
  std::map<std::uint64_t, std::map<std::string, std::string>> changes;  ///< by time, then by reference

  explicit Vcd(const std::string& text) {
    std::istringstream in(text);
    std::string token;
    bool hasTimescale = false, defined = false, dumping = false;
    std::int64_t now = -1;
    while (in >> token) {
      if (token == "$comment" || token == "$version" || token == "$date") {
        while (in >> token && token != "$end") {
        }
      } else if (token == "$timescale") {
        std::string unit;
        in >> token >> unit;
        hasTimescale = token == "1" && (unit == "ms" || unit == "us");
        expectEnd(in);
      } else if (token == "$scope") {
        in >> token;
        EXPECT_EQ(token, "module");
        in >> token;
        EXPECT_EQ(token.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_"),
                  std::string::npos)
            << token;
        expectEnd(in);
      } else if (token == "$upscope" || token == "$enddefinitions") {
        defined = defined || token == "$enddefinitions";
        expectEnd(in);
      } else if (token == "$var") {
        std::string type, id, name;
        int width = 0;
        in >> type >> width >> id >> name;
        EXPECT_TRUE(type == "wire" || type == "real") << type;
        EXPECT_EQ(type == "real", width == 64);
        EXPECT_TRUE(names.emplace(id, name).second) << "identifier twice: " << id;
        EXPECT_EQ(name.find('.'), std::string::npos);
        widths[id] = type == "real" ? 0 : width;
        expectEnd(in);
      } else if (token[0] == '#') {
        EXPECT_TRUE(defined && hasTimescale);
        const auto time = static_cast<std::int64_t>(std::stoull(token.substr(1)));
        EXPECT_GT(time, now) << "times must grow";
        now = time;
        changes[static_cast<std::uint64_t>(now)];
      } else if (token == "$dumpvars") {
        dumping = true;
      } else if (token == "$end") {
        EXPECT_TRUE(dumping);
        dumping = false;
      } else {
        change(token, in, now);
      }
    }
    EXPECT_TRUE(defined);
  }

 private:
  static void expectEnd(std::istream& in) {
    std::string token;
    in >> token;
    EXPECT_EQ(token, "$end");
  }
  void change(const std::string& token, std::istream& in, std::int64_t now) {
    EXPECT_GE(now, 0);
    std::string id, value;
    if (token[0] == 'b' || token[0] == 'r') {
      value = token;
      in >> id;
      ASSERT_TRUE(widths.contains(id)) << id;
      EXPECT_EQ(token[0] == 'r', widths[id] == 0);
      EXPECT_TRUE(token[0] == 'r' || static_cast<int>(token.size()) - 1 <= widths[id]) << token;
    } else {
      EXPECT_NE(std::string("01xz").find(token[0]), std::string::npos) << token;
      value = token.substr(0, 1);
      id = token.substr(1);
      ASSERT_TRUE(widths.contains(id)) << token;
      EXPECT_EQ(widths[id], 1);
    }
    changes[static_cast<std::uint64_t>(now)][names[id]] = value;
  }
};

TEST(VcdTrace, IsReadByAStrictReader) {
  const Vcd vcd(written(sampleTrace(), ".vcd"));
  EXPECT_EQ(vcd.names.size(), 6U);  // five signals and the count of scans
  // The values of scan 1 are shown from power-up on, those of scan 2 from its beginning at 10 ms, those of scan 3 from
  // 20.5 ms to the last time, 30.5 ms.
  ASSERT_TRUE(vcd.changes.contains(0));
  EXPECT_EQ(vcd.changes.at(0).at("Q0_0"), "0");
  EXPECT_EQ(vcd.changes.at(0).size(), 6U);  // $dumpvars names all
  EXPECT_EQ(vcd.changes.at(0).at("scan"), "b1");
  EXPECT_EQ(vcd.changes.at(0).at("VW10"), "b1111111111111011");
  EXPECT_EQ(vcd.changes.at(0).at("VD20"), "r1.5");
  EXPECT_EQ(vcd.changes.at(0).at("T37_value"), "bx");
  ASSERT_TRUE(vcd.changes.contains(10000));  // 20.5 ms make it a file in us
  EXPECT_EQ(vcd.changes.at(10000).at("T37_value"), "b11");
  EXPECT_EQ(vcd.changes.at(10000).at("I0_0"), "1");
  EXPECT_EQ(vcd.changes.at(20500).at("Q0_0"), "1");
  EXPECT_FALSE(vcd.changes.at(20500).contains("I0_0"));
  ASSERT_TRUE(vcd.changes.contains(30500));
  EXPECT_TRUE(vcd.changes.at(30500).empty());
}

TEST(VcdTrace, WholeMillisecondsAndALastTime) {
  Trace trace = sampleTrace();
  for (std::size_t i = 0; i < 3; ++i) trace.rows[i].timeUs = (i + 1) * 10000;
  trace.rows[2].values = trace.rows[1].values;
  const std::string text = written(trace, ".vcd");
  EXPECT_NE(text.find("$timescale 1 ms $end"), std::string::npos);
  const Vcd vcd(text);
  EXPECT_EQ(vcd.changes.rbegin()->first, 30U);  // the end shows although nothing changes there
}

TEST(VcdTrace, NamesBecomePlainAndStayDifferent) {
  Trace trace = sampleTrace();
  trace.signals[0].name = "Нажим.1";
  trace.signals[1].name = "a.b";
  trace.signals[2].name = "a_b";
  const Vcd vcd(written(trace, ".vcd", "ряд 1.awl"));
  std::set<std::string> names;
  for (const auto& [id, name] : vcd.names) EXPECT_TRUE(names.insert(name).second) << name;
}

TEST(VcdTrace, IdentifiersForManySignals) {
  Trace trace;
  const Program program;
  for (std::uint32_t i = 0; i < 300; ++i) trace.signals.push_back(signalOf(program, direct(Area::V, Width::Bit, i, 0)));
  trace.rows.push_back({1, 10000, 10000, std::vector<std::optional<TraceNumber>>(300, 1.0)});
  EXPECT_EQ(Vcd(written(trace, ".vcd")).names.size(), 301U);  // with the count of scans
}

TEST(WavedromTrace, LanesInGroups) {
  const nlohmann::json json = nlohmann::json::parse(written(sampleTrace(), ".json"));
  ASSERT_EQ(json["signal"].size(), 4U);
  EXPECT_EQ(json["signal"][0][0], "inputs");
  EXPECT_EQ(json["signal"][0][1]["wave"], "01.");
  EXPECT_EQ(json["signal"][1][1]["name"], "Q0.0 Motor");
  EXPECT_EQ(json["signal"][1][1]["wave"], "0.1");
  EXPECT_EQ(json["signal"][2][0], "memory");
  EXPECT_EQ(json["signal"][2][1]["wave"], "=.=");
  EXPECT_EQ(json["signal"][2][1]["data"], nlohmann::json({"-5", "12"}));
  EXPECT_EQ(json["signal"][3][1]["wave"], "x=.");
  EXPECT_EQ(json["head"]["tick"], 1);
}

TEST(SvgTrace, IsXmlWithALaneForEachSignal) {
  pugi::xml_document document;
  ASSERT_TRUE(document.load_string(written(sampleTrace(), ".svg", "a < b & \"c\"").c_str()));
  std::string texts;
  for (const pugi::xpath_node& node : document.select_nodes("//*[local-name()='text']"))
    texts += std::string(node.node().text().get()) + "|";
  for (const char* label : {"I0.0", "Q0.0 Motor", "VW10", "T37.value", "-5", "12", "a < b"})
    EXPECT_NE(texts.find(label), std::string::npos) << label << " in " << texts;
}

/// Below the numbers of the scans stands when they begin, and at the end when the last one ends: the first takes 10 ms,
/// the second 10.5 ms, the third 10 ms. A recording by time has its own times only.
TEST(SvgTrace, HasAnAxisOfTime) {
  const auto axisOf = [](const Trace& trace) {
    pugi::xml_document document;
    EXPECT_TRUE(document.load_string(timingDiagram(trace, "").c_str()));
    std::string texts;
    for (const pugi::xpath_node& node : document.select_nodes("//*[@class='a']"))
      texts += std::string(node.node().text().get()) + " ";
    return texts;
  };
  Trace trace = sampleTrace();
  EXPECT_EQ(axisOf(trace), "1 0 2 10 3 20.5 30.5 ");
  trace.isByTime = true;
  EXPECT_EQ(axisOf(trace), "10 20.5 30.5 ");
}

TEST(SvgTrace, LongTracesKeepToALimit) {
  Trace trace = sampleTrace();
  const TraceRow last = trace.rows.back();
  for (std::uint64_t scan = 4; scan <= 5000; ++scan) {
    trace.rows.push_back(last);
    trace.rows.back().scan = scan;
    trace.rows.back().values[0] = scan / 1000 % 2;  // changes a few times only: stretches are drawn short
  }
  EXPECT_LT(timingDiagram(trace, "long").size(), 20000U);
  for (TraceRow& row : trace.rows) row.values[0] = static_cast<double>(row.scan % 2);
  EXPECT_NE(timingDiagram(trace, "busy").find("first 400 of 5000"), std::string::npos);
}

TEST(HtmlTrace, OnePageWithDataAndNoOutsideReferences) {
  Trace trace = sampleTrace();
  trace.signals[1].symbol = "</script><b>";
  const std::string page = written(trace, ".html");
  EXPECT_EQ(page.find("src="), std::string::npos);
  EXPECT_EQ(page.find("href="), std::string::npos);
  const std::string open = "<script type=\"application/json\" id=\"data\">";
  const std::size_t begin = page.find(open) + open.size();
  const nlohmann::json json = nlohmann::json::parse(page.substr(begin, page.find("</script>", begin) - begin));
  EXPECT_EQ(json["signals"][1]["name"], "Q0.0 </script><b>");
  EXPECT_EQ(json["rows"].size(), 3U);
  EXPECT_TRUE(json["rows"][0]["values"][4].is_null());
  EXPECT_EQ(json["rows"][1]["time_ms"], 20.5);
}

TEST(TraceFormats, EmptyTracesAreWritten) {
  for (const TraceFormat* format : allTraceFormats()) {
    std::ostringstream out;
    format->write(Trace{}, "", out);
    EXPECT_FALSE(out.str().empty()) << format->ending;
  }
}

}  // namespace
}  // namespace rungproof
