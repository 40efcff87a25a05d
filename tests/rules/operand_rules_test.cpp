// Generated: every operand of every instruction with every way of writing an operand, and every limit of table 6-2 on
// every CPU of both editions. What is legal comes from tests/data/*.tsv, which were typed from the manual's tables, not
// from the descriptors that the rules use: each forbidden form must give ADR002 (or the rule that is more precise:
// ADR003, ADR004, PTR002), each address beyond a limit ADR001, and nothing legal may give any of them.
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "analysis/flow/operand_check.hpp"
#include "ir/s7200/cpu.hpp"
#include "ir/s7200/isa.hpp"
#include "tests/rules/lint.hpp"

namespace rungproof::testing {
namespace {

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::string part;
  int depth = 0;
  for (const char c : text) {
    if (c == '[') ++depth;
    if (c == ']') --depth;
    if (c == separator && depth == 0) {
      parts.push_back(part);
      part.clear();
    } else {
      part += c;
    }
  }
  parts.push_back(part);
  return parts;
}

std::vector<std::vector<std::string>> rowsOf(const std::string& file) {
  std::ifstream stream(std::string(RUNGPROOF_SOURCE_DIR) + "/tests/data/" + file);
  std::vector<std::vector<std::string>> rows;
  std::string line;
  while (std::getline(stream, line)) rows.push_back(split(line, '\t'));
  if (!rows.empty()) rows.erase(rows.begin());
  return rows;
}

/// The word of the operand tables for a way of writing: "VW", "T", "*AC", "&VB", "constant".
struct Form {
  std::string token;
  Operand operand;
};

std::vector<Form> allForms(const OperandDesc& desc) {
  static constexpr const char* letters[] = {"", "B", "W", "D"};
  std::vector<Form> forms;
  for (const Area area : {Area::I, Area::Q, Area::V, Area::M, Area::S, Area::SM, Area::L}) {
    for (const Width width : {Width::Bit, Width::Byte, Width::Word, Width::DWord}) {
      // SM from byte 30, so that no rule on read-only memory joins in.
      forms.push_back({std::string(areaName(area)) + letters[static_cast<int>(width)],
                       direct(area, width, area == Area::SM ? 30 : 0)});
    }
  }
  for (const Area area : {Area::T, Area::C})
    forms.push_back({std::string(areaName(area)), direct(area, Width::Bit, 40)});
  forms.push_back({"AC", direct(Area::AC, Width::DWord, 1)});
  forms.push_back({"HC", direct(Area::HC, Width::DWord, 0)});
  forms.push_back({"AIW", direct(Area::AI, Width::Word, 0)});
  forms.push_back({"AQW", direct(Area::AQ, Width::Word, 0)});
  for (const auto& [token, area, offset] :
       {std::tuple("*VD", Area::V, 0U), std::tuple("*LD", Area::L, 0U), std::tuple("*AC", Area::AC, 1U)}) {
    Operand pointer = direct(area, Width::DWord, offset);
    pointer.kind = OperandKind::Indirect;
    forms.push_back({token, pointer});
  }
  for (const auto& [token, area] : {std::pair("&VB", Area::V), std::pair("&T", Area::T), std::pair("&SMB", Area::SM),
                                    std::pair("&AIW", Area::AI)}) {
    Operand address = direct(area, Width::Byte, 0);
    address.kind = OperandKind::Address;
    forms.push_back({token, address});
  }
  Operand value = constant(1);
  if (desc.type == Type::Real) value = constant(0x3F800000, ConstantForm::Real);
  if (desc.type == Type::String) {
    value.kind = OperandKind::Text;
    value.text = "A";
  }
  forms.push_back({"constant", value});
  return forms;
}

/// "constant[T32..T63|...]" names timers, "constant[0..8]" numbers, "SMB[30..]" the area.
std::string tokenOf(const std::string& word) {
  const std::string base = word.substr(0, word.find('['));
  if (base == "constant" && word.find("[T") != std::string::npos) return "T";
  if (base == "constant" && word.find("[C") != std::string::npos && word.find("[CPU") == std::string::npos) return "C";
  return base;
}

/// A program of single instructions; the place of operand and finding is the number of the case.
class Cases {
 public:
  explicit Cases(Target target = {}) {
    program_.target = target;
    program_.sources->add("cases", "");
    program_.pous.push_back({});
    program_.pous[0].networks.push_back({});
  }
  std::uint32_t add(const Desc& desc, std::size_t position, Operand operand) {
    Instruction instruction;
    instruction.desc = &desc;
    instruction.operands.resize(desc.operandCount);
    operand.span = {0, next_, 1};
    instruction.operands[position] = std::move(operand);
    program_.pous[0].networks[0].instructions.push_back(std::move(instruction));
    return next_++;
  }
  /// Cases with a finding of one of the rules.
  std::set<std::uint32_t> run(std::initializer_list<const char*> rules) {
    program_.number();
    const Facts facts(program_);
    const RuleSettings settings;
    FindingSink sink(program_, settings);
    for (const char* id : rules) {
      const Rule* rule = ruleNamed(id);
      sink.begin(*rule);
      rule->check(facts, sink);
    }
    std::set<std::uint32_t> found;
    for (const Finding& finding : sink.take()) found.insert(finding.span.offset);
    return found;
  }

 private:
  Program program_;
  std::uint32_t next_ = 1;
};

TEST(OperandRules, EveryFormOfEveryOperandIsJudgedAsInTheTables) {
  // Instruction and operand to the words of all rows that speak of them.
  std::map<std::pair<std::string, std::string>, std::set<std::string>> allowed;
  for (const char* file : {"operands-a.tsv", "operands-b.tsv"}) {
    for (const std::vector<std::string>& row : rowsOf(file)) {
      ASSERT_GE(row.size(), 5U);
      for (const std::string& name : split(row[0], ',')) {
        for (const std::string& operand : split(row[1], ',')) {
          if (operand.find('@') != std::string::npos || name.find(':') != std::string::npos || name == "CALL" ||
              name == "*")
            continue;
          for (const std::string& word : split(row[4], ',')) allowed[{name, operand}].insert(tokenOf(word));
        }
      }
    }
  }
  struct Expected {
    std::string text;
    bool isLegal;
  };
  Cases cases;
  std::map<std::uint32_t, Expected> expected;
  int operands = 0;
  for (const auto& [key, words] : allowed) {
    const Desc* desc = s7200Instructions().named(key.first);
    ASSERT_NE(desc, nullptr) << key.first;
    for (std::size_t i = 0; i < desc->operandCount; ++i) {
      if (desc->operands[i].name != key.second) continue;
      ++operands;
      for (const Form& form : allForms(desc->operands[i])) {
        const std::uint32_t id = cases.add(*desc, i, form.operand);
        expected[id] = {key.first + " " + key.second + " = " + form.token, words.contains(form.token)};
      }
    }
  }
  EXPECT_GT(operands, 300);
  const std::set<std::uint32_t> found = cases.run({"ADR002", "ADR003", "ADR004", "PTR002"});
  for (const auto& [id, e] : expected)
    EXPECT_EQ(found.contains(id), !e.isLegal) << e.text << (e.isLegal ? " is legal" : " is not in the table");
}

/// An instruction and operand that take that area at that width.
std::pair<const Desc*, std::size_t> carrier(const std::string& area, Width width) {
  if (area == "AQ") return {s7200Instructions().named("MOVW"), 1};
  switch (width) {
    case Width::Bit: return {s7200Instructions().named("LD"), 0};
    case Width::Byte: return {s7200Instructions().named("MOVB"), 0};
    case Width::Word: return {s7200Instructions().named("MOVW"), 0};
    default: return {s7200Instructions().named("MOVD"), 0};
  }
}

TEST(OperandRules, EveryLimitOfTable62IsExact) {
  const std::map<std::string, Area> areas = {{"I", Area::I},   {"Q", Area::Q},   {"V", Area::V},   {"M", Area::M},
                                             {"SM", Area::SM}, {"S", Area::S},   {"T", Area::T},   {"C", Area::C},
                                             {"L", Area::L},   {"AC", Area::AC}, {"AI", Area::AI}, {"AQ", Area::AQ},
                                             {"HC", Area::HC}};
  const std::map<std::string, Width> widths = {
      {"bit", Width::Bit}, {"byte", Width::Byte}, {"word", Width::Word}, {"dword", Width::DWord}};
  int checked = 0;
  std::map<std::pair<std::string, std::string>, std::map<std::pair<std::string, std::string>, std::int64_t>> tables;
  for (const std::vector<std::string>& row : rowsOf("operand-ranges.tsv")) {
    if (row.size() < 9 || !areas.contains(row[3]) || !widths.contains(row[2])) continue;
    // Misprints are resolved in the last column; HC has two rows on CPUs with a gap, the higher one counts.
    std::int64_t& high = tables[{row[0], row[1]}][{row[3], row[2]}];
    high = std::max<std::int64_t>(high, std::stoll(row[8].substr(0, row[8].find('.'))));
  }
  for (const auto& [place, limits] : tables) {
    const std::optional<Cpu> cpu = cpuNamed(place.second.substr(3));
    ASSERT_TRUE(cpu) << place.second;
    const Target target{*cpu, place.first == "2003" ? Edition::Edition2003 : Edition::Edition2004};
    Cases cases(target);
    std::map<std::uint32_t, std::string> legal, illegal;
    for (const auto& [form, high] : limits) {
      const Area area = areas.at(form.first);
      const Width width = widths.at(form.second);
      const auto [desc, position] = carrier(form.first, width);
      const bool isNumber = area == Area::T || area == Area::C;
      const std::uint32_t step = area == Area::AI || area == Area::AQ ? 2 : 1;
      const Width written = isNumber ? Width::Bit : width;
      const std::string text =
          place.first + " " + place.second + " " + form.second + " " + form.first + std::to_string(high);
      legal[cases.add(
          *desc, position,
          direct(area, written, static_cast<std::uint32_t>(high), isNumber || width != Width::Bit ? 0 : 7))] = text;
      illegal[cases.add(*desc, position, direct(area, written, static_cast<std::uint32_t>(high) + step))] =
          text + " + " + std::to_string(step);
      if (width == Width::Bit && !isNumber)
        illegal[cases.add(*desc, position, direct(area, width, 0, 8))] = text + ", bit 8";
      ++checked;
    }
    const std::set<std::uint32_t> found = cases.run({"ADR001"});
    for (const auto& [id, text] : legal) EXPECT_FALSE(found.contains(id)) << text << " exists";
    for (const auto& [id, text] : illegal) EXPECT_TRUE(found.contains(id)) << text << " does not exist";
  }
  EXPECT_GT(checked, 300);
}

TEST(OperandRules, ConstantsHaveTheirLimits) {
  const auto lines = [](const char* text) { return Linted(text).lines("ADR006"); };

  EXPECT_EQ(lines("Network 1\nLD I0.0\nS Q0.0, 255\nS Q0.0, 1\nSHRB I0.1, V100.0, -64\nFILL +0, VW0, 255\nMOVB 255, "
                  "VB0\nMOVW 65535, VW0\nMOVD 16#FFFFFFFF, VD0\n"),
            Lines());
  EXPECT_EQ(lines("Network 1\nLD I0.0\nS Q0.0, 0\n"), Lines{3});               // 001:2789
  EXPECT_EQ(lines("Network 1\nLD I0.0\nSI Q0.0, 129\n"), Lines{3});            // 001:2800
  EXPECT_EQ(lines("Network 1\nLD I0.0\nSHRB I0.1, V100.0, +65\n"), Lines{3});  // 001:6024
  EXPECT_EQ(lines("Network 1\nLD I0.0\nMOVB 256, VB0\n"), Lines{3});           // a byte has 8 bits
  EXPECT_EQ(lines("Network 1\nLD I0.0\nPID VB100, 8\n"), Lines{3});            // 001:2669
  EXPECT_EQ(lines("Network 1\nLD I0.0\nJMP 256\n"), Lines{3});                 // 001:2665
}

TEST(OperandRules, FeaturesDependOnTheCpu) {
  const auto count = [](const char* text, Cpu cpu, Edition edition = Edition::Edition2004) {
    return Linted(text, {cpu, edition}).of("ADR009").size();
  };
  const char* hsc = "Network 1\nLD SM0.1\nHDEF 1, 0\n";  // 001:4166
  EXPECT_EQ(count(hsc, s7200Cpu("222")), 1U);
  EXPECT_EQ(count(hsc, s7200Cpu("224")), 0U);
  const char* port = "Network 1\nLD SM0.1\nXMT VB0, 1\n";  // 001:2670
  EXPECT_EQ(count(port, s7200Cpu("224")), 1U);
  EXPECT_EQ(count(port, s7200Cpu("226")), 0U);
  const char* newer = "Network 1\nLD SM0.1\nBITIM VD0\n";  // 001:130
  EXPECT_EQ(count(newer, s7200Cpu("226"), Edition::Edition2003), 1U);
  EXPECT_EQ(count(newer, s7200Cpu("226")), 0U);
  // The manual contradicts itself: 0-63 (001:2666) against 0-127 (001:6751), so the message names both lines.
  const Linted disputed("Network 1\nLD SM0.1\nCALL 100\n", {s7200Cpu("224XP"), Edition::Edition2004});
  ASSERT_EQ(disputed.of("ADR009").size(), 1U);
  EXPECT_NE(disputed.messages("ADR009")[0].find("001:2666"), std::string::npos);
  EXPECT_NE(disputed.messages("ADR009")[0].find("001:6751"), std::string::npos);
}

// CR20s to CR60s have serial ports only.
TEST(OperandRules, GetAndPutNeedEthernet) {
  const auto of = [](const char* cpu, const std::string& box) {
    const Cpu target = *cpuNamed(cpu);
    return Linted("Network 1\nLD I0.0\nEU\n" + box + "\n", {target, usualEdition(target)}).of("ADR009");
  };
  for (const char* cpu : {"CR20s", "CR30s", "CR40s", "CR60s"}) {
    EXPECT_EQ(of(cpu, "GET VB0").size(), 1U) << cpu;
    EXPECT_EQ(of(cpu, "PUT VB0").size(), 1U) << cpu;
  }
  EXPECT_EQ(of("CR40s", "TSEND VB0").size(), 1U);
  EXPECT_EQ(of("CR40s", "TRECV VB0").size(), 1U);
  for (const char* cpu : {"SR20", "ST20", "ST40", "SR60", "ST60"}) EXPECT_EQ(of(cpu, "GET VB0").size(), 0U) << cpu;
  EXPECT_EQ(of("CR40s", "XMT VB0, 0").size(), 0U) << "a serial port";
  EXPECT_EQ(of("CR40s", "GERR VW0").size(), 0U);
  const std::vector<Finding> disputed = of("CR40", "GET VB0");
  ASSERT_EQ(disputed.size(), 1U);
  EXPECT_EQ(disputed[0].severity, Severity::Note) << "the sources differ";
}

// 001:1414: a constant has at most 126 characters, a string in memory 254.
TEST(OperandRules, TextConstantsHave126Characters) {
  const auto of = [](const std::string& statement) {
    return Linted("Network 1\nLD I0.0\n" + statement + "\n").of("ADR006").size();
  };
  const auto text = [](std::size_t length) { return "\"" + std::string(length, 'a') + "\""; };
  EXPECT_EQ(of("SCPY " + text(127) + ", VB0"), 1U);
  EXPECT_EQ(of("SCPY " + text(254) + ", VB0"), 1U);
  EXPECT_EQ(of("SCAT " + text(130) + ", VB0"), 1U);
  EXPECT_EQ(of("SLEN " + text(127) + ", VB0"), 1U);
  EXPECT_EQ(of("SFND VB0, " + text(200) + ", AC0"), 1U);
  EXPECT_EQ(Linted("Network 1\nLDS= " + text(127) + ", VB0\n= Q0.0\n").of("ADR006").size(), 1U);
  EXPECT_EQ(of("SCPY " + text(126) + ", VB0"), 0U);
  EXPECT_EQ(of("SCPY " + text(1) + ", VB0"), 0U);
  EXPECT_EQ(of("SCAT " + text(126) + ", VB0"), 0U);
  EXPECT_EQ(of("SCPY VB300, VB0"), 0U);
  EXPECT_EQ(of("SLEN " + text(100) + ", VB0"), 0U);
  std::string umlauts;
  for (int i = 0; i < 126; ++i) umlauts += "ä";
  EXPECT_EQ(of("SCPY \"" + umlauts + "\", VB0"), 0U) << "126 characters in more bytes";
}

// Of a CPU without pulse outputs there is no number to name; the letters of a name are those of the source.
TEST(OperandRules, MessagesNameWhatIsThere) {
  const Cpu relay = *cpuNamed("CR40");
  const Linted pulses("Network 1\nLD I0.0\nPLS 0\n", {relay, usualEdition(relay)});
  ASSERT_EQ(pulses.of("ADR009").size(), 1U);
  EXPECT_NE(pulses.messages("ADR009")[0].find("the CPU CR40 has no Q0.X of PLS"), std::string::npos)
      << pulses.messages("ADR009")[0];
  const Linted name("Network 1\nLD \"\xD0\x9D\xD0\xB0\xD1\x81\xD0\xBE\xD1\x81 1\"\n= Q0.0\n");
  ASSERT_EQ(name.of("ADR002").size(), 1U);
  EXPECT_NE(name.messages("ADR002")[0].find("LD does not take \"\xD0\x9D\xD0\xB0\xD1\x81\xD0\xBE\xD1\x81 1\" as bit"),
            std::string::npos)
      << name.messages("ADR002")[0];
}

}  // namespace
}  // namespace rungproof::testing
