// Tag lists of panels: how they are read, what `xref --tags` says of them, and what they and `external` of the settings
// mean for the other commands.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "frontend/input/tag_list.hpp"
#include "frontend/property/external_range.hpp"
#include "tests/program_run.hpp"

namespace rungproof {
namespace {

/// "Dose VW100 INT" of each tag, joined by "; ". `!` behind it: the panel sets it; `-`: it only reads.
std::string read(const std::string& text) {
  Program program;
  const std::uint32_t file = program.sources->add("tags.csv", text);
  std::string result;
  for (const PanelTag& tag : readTagText(program, file)) {
    EXPECT_GT(tag.span.length, 0U);
    result += (result.empty() ? "" : "; ") + tag.name + " " + toString(tag.address) + " " + tag.typeText +
              (tag.access == TagAccess::Sets    ? "!"
               : tag.access == TagAccess::Reads ? "-"
                                                : "");
  }
  return result;
}

TEST(TagList, IsReadInTheWaysThatEditorsWriteIt) {
  EXPECT_EQ(read("Level,VW100,INT\nRunning,V10.0,BOOL\n"), "Level VW100 INT; Running V10.0 BOOL");
  EXPECT_EQ(read("name;address;type;access\nLevel;VW100;INT;read\nDose;VD4;REAL;read/write\n"),
            "Level VW100 INT-; Dose VD4 REAL!");
  EXPECT_EQ(read("Typ\tAdresse\tName\nInt\tVW 100\tMenge\nBool\tM0.3\tStart\n"), "Menge VW100 Int; Start M0.3 Bool");
  EXPECT_EQ(read("变量名,数据类型,地址\n速度,字,DB1.DBW100\n启动,位,DB1.DBX0.1\n"), "速度 VW100 字; 启动 V0.1 位");
  EXPECT_EQ(read("Имя;Тип;Адрес\nУровень;Int;%VW100\n"), "Уровень VW100 Int");
  EXPECT_EQ(read("\"Level, left\",\"VW100\",\"INT\"\r\n"), "Level, left VW100 INT");
  EXPECT_EQ(read("Speed_Set,VW100,INT\nSpeed,VW102,INT\n"), "Speed_Set VW100 INT!; Speed VW102 INT");
  EXPECT_EQ(read("name,address\nInternal,LW5:3\nEmpty,\nLevel,VW100\n"), "Level VW100 ") << "tags of the panel itself";
  EXPECT_EQ(read("Name,Address,Type,Comment\nDose,VD4,REAL,Sollwert\n"), "Dose VD4 REAL!");
  EXPECT_EQ(read("Name,Acquisition mode,Address\nLevel,Cyclic in operation,VW100\n"), "Level VW100 ")
      << "the mode says nothing about who writes";
  EXPECT_EQ(read("a,VW0,INT,R\nb,VW2,INT,R/W\nc,VW4,INT,Read-Only\nd,VW6,INT,motor speed\n"),
            "a VW0 INT-; b VW2 INT!; c VW4 INT-; d VW6 INT");
  EXPECT_EQ(read(""), "");
}

TEST(TagList, TypesHaveManyNames) {
  for (const auto& [name, type] :
       {std::pair{"BOOL", TagType::Bool}, std::pair{"Bit", TagType::Bool}, std::pair{"BYTE", TagType::Byte},
        std::pair{"WORD", TagType::Unsigned16}, std::pair{"UInt", TagType::Unsigned16},
        std::pair{"16-bit unsigned", TagType::Unsigned16}, std::pair{"INT", TagType::Signed16},
        std::pair{"Short", TagType::Signed16}, std::pair{"DINT", TagType::Signed32},
        std::pair{"DWord", TagType::Unsigned32}, std::pair{"32-bit signed", TagType::Signed32},
        std::pair{"REAL", TagType::Real}, std::pair{"32-bit float", TagType::Real},
        std::pair{"字", TagType::Unsigned16}, std::pair{"双字", TagType::Unsigned32},
        std::pair{"浮点数", TagType::Real}, std::pair{"STRING[20]", TagType::Text}, std::pair{"?", TagType::Unknown}})
    EXPECT_EQ(tagTypeNamed(name), type) << name;
}

TEST(ExternalSetting, NamesPlacesThatCanBeWrittenFromOutside) {
  const auto range = [](std::string_view text) {
    const auto found = externalRangeNamed(text);
    return found ? toString(found->first) + " " + toString(found->last) : std::string("none");
  };
  EXPECT_EQ(range("VB100..VB199"), "VB100 VB199");
  EXPECT_EQ(range("VW100 .. VW118"), "VW100 VW118");
  EXPECT_EQ(range("V10.0"), "V10.0 V10.0");
  for (const char* text : {"I0.0", "VB199..VB100", "VB0..VW4", "VB0..MB4", "T37", "", "hello"})
    EXPECT_EQ(range(text), "none") << text;
}

const std::string program = test::mainBlock(
    "Network 1\nLD SM0.0\nMOVW AIW0, VW100\n+I 5, VW100\nMOVW VW100, VW200\nNetwork 2\nLDW>= VW200, VW102\n= Q0.0\n"
    "Network 3\nLDR>= VD104, 1.5\n= Q0.1\nNetwork 4\nLDD>= VD108, 7\n= Q0.2\nNetwork 5\nLDD>= VD112, 7\n= Q0.3\n");

/// Problems of each tag by its name, of `xref --tags` on a CPU ST40, where nothing is retentive unless a setting says
/// so.
std::string problems(const std::string& tags, const std::vector<std::string>& options = {}) {
  const test::TemporaryFolder folder;
  std::vector<std::string> arguments{"xref",
                                     "--isolated",
                                     "--format",
                                     "json",
                                     "--cpu",
                                     "ST40",
                                     "--tags",
                                     folder.file("tags.csv", tags),
                                     folder.file("a.awl", program)};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const test::ProgramRun run = test::run(arguments);
  const auto json = nlohmann::json::parse(run.out);
  std::string result;
  for (const auto& tag : json["tags"]) {
    for (const auto& problem : tag["problems"])
      result +=
          (result.empty() ? "" : "; ") + tag["name"].get<std::string>() + ": " + problem["problem"].get<std::string>();
  }
  EXPECT_EQ(run.exit, result.empty() ? 0 : 1) << run.err;
  return result;
}

TEST(XrefTags, FindsWhatIsWrong) {
  EXPECT_EQ(problems("Spare,VW300,INT\n"), "Spare: unused");
  EXPECT_EQ(problems("Far,VW30000,INT\n"), "Far: missing");
  EXPECT_EQ(problems("Limit,VD102,INT,read\n"), "Limit: width") << "the type is a word, the address a double word";
  EXPECT_EQ(problems("Count,VW108,INT,read\n"), "Count: width") << "the upper half of the program's double word";
  EXPECT_EQ(problems("Ratio,VD104,DINT,read\n"), "Ratio: type");
  EXPECT_EQ(problems("Count,VD108,REAL,read\n"), "Count: type");
  EXPECT_EQ(problems("Level,VW100,INT,read/write\n"), "Level: two masters");
  EXPECT_EQ(problems("Limit,VW102,INT,read/write\n"), "Limit: not retentive");
}

TEST(XrefTags, IsSilentOfWhatIsRight) {
  const std::vector<std::string> kept{"--retentive", "VB0..VB199"};
  EXPECT_EQ(problems("Limit,VW102,INT,read/write\n", kept), "");
  EXPECT_EQ(problems("Limit,VW102,WORD,write\n", kept), "");
  EXPECT_EQ(problems("Level,VW100,INT,read\n"), "") << "it is only shown";
  EXPECT_EQ(problems("Ratio,VD104,REAL,read/write\n", kept), "");
  EXPECT_EQ(problems("Count,VD108,DINT,read\n"), "");
  EXPECT_EQ(problems("Count,VW110,INT,read\n"), "") << "the low word may be shown alone";
  EXPECT_EQ(problems("Running,Q0.0,BOOL\n"), "");
  EXPECT_EQ(problems("Three,V102.3,BOOL,read\n"), "") << "a bit of a word that is used";
}

TEST(XrefTags, ListsThemAsText) {
  const test::TemporaryFolder folder;
  const std::string tags = folder.file("tags.csv", "name,address,type\nSpare,VW300,INT\nCount,VD108,DINT\n");
  const test::ProgramRun run = test::run({"xref", "--isolated", folder.file("a.awl", program), "--tags", tags});
  EXPECT_EQ(run.exit, 1) << run.err;
  EXPECT_NE(run.out.find("Panel: 2 tags, one problem"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("tags.csv:2:7 Spare"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("no instruction uses VW300"), std::string::npos) << run.out;
  EXPECT_EQ(test::run({"xref", "--isolated", folder.file("a.awl", program), "--tags", folder.path("none.csv")}).exit,
            2);
}

TEST(TagsOfTheProject, CountAsExternalUnlessTheyAreOnlyShown) {
  const test::TemporaryFolder folder;
  const std::string awl =
      folder.file("a.awl", test::mainBlock("//@ prove off: never Q0.0\nNetwork 1\nLDW> VW100, 5\n= Q0.0\n"));
  const auto verdict = [&](const std::string& tags) {
    folder.file("panel/tags.csv", tags);
    folder.file("rungproof.toml", "tags = \"panel/tags.csv\"\n");
    return test::run({"prove", awl}).exit;
  };
  EXPECT_EQ(verdict("Level,VW100,INT,read\n"), 0) << "nothing writes it";
  EXPECT_EQ(verdict("Level,VW100,INT,read/write\n"), 1);
  EXPECT_EQ(verdict("Level,VW100,INT\n"), 1) << "nobody says that the panel does not write it";
  for (const char* text : {"external = [\"VB100..VB101\"]\n", "external = \"VW100\"\n",
                           "[external]\npanel = [\"VW100\"]\nscada = \"VW300\"\n"}) {
    folder.file("rungproof.toml", text);
    EXPECT_EQ(test::run({"prove", awl}).exit, 1) << text;
  }
  folder.file("rungproof.toml", "[external]\npanel = [\"I0.0\"]\n");
  EXPECT_EQ(test::run({"prove", awl}).exit, 2) << "inputs are free anyway";
  EXPECT_EQ(test::run({"prove", "--isolated", "--external", "VW100", awl}).exit, 1);
  EXPECT_EQ(test::run({"prove", "--isolated", "--external", "VW102", awl}).exit, 0);
  EXPECT_EQ(test::run({"prove", "--isolated", "--external", "I0.0", awl}).exit, 2);
}

TEST(TagsOfTheProject, FeedTheRulesAboutPanels) {
  const test::TemporaryFolder folder;
  const std::string awl = folder.file("a.awl", program);
  const std::string tags = folder.file("tags.csv", "Dose_Set,VW100,INT\n");
  const test::ProgramRun run =
      test::run({"lint", "--isolated", "--select", "ADR012", "--format", "concise", "--tags", tags, awl});
  EXPECT_EQ(run.exit, 1) << run.err;
  EXPECT_NE(run.out.find("ADR012"), std::string::npos) << run.out;
  // A word that the panel writes is no word that nothing writes.
  const std::vector<std::string> read{"lint", "--isolated", "--select", "ADR010", awl};
  std::vector<std::string> with = read;
  with.insert(with.end(),
              {"--tags", folder.file("all.csv", "a,VW102,INT\nb,VD104,REAL\nc,VD108,DINT\nd,VD112,DINT\n")});
  EXPECT_EQ(test::run(read).exit, 1);
  EXPECT_EQ(test::run(with).exit, 0);
}

TEST(PortTo, IsAnOptionAndAKey) {
  const test::TemporaryFolder folder;
  const std::string awl = folder.file("a.awl", test::mainBlock("Network 1\nLD SM0.1\nMOVB 16#85, SMB67\nPLS 0\n"));
  const auto finds = [&](const std::vector<std::string>& options) {
    std::vector<std::string> arguments{"lint", "--select", "PRT001", awl};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return test::run(arguments).exit;
  };
  EXPECT_EQ(finds({"--isolated"}), 0);
  EXPECT_EQ(finds({"--isolated", "--port-to", "ST40"}), 1);
  EXPECT_EQ(finds({"--isolated", "--port-to", "st40"}), 1) << "case does not matter, as for --cpu";
  EXPECT_EQ(finds({"--isolated", "--port-to", "ST400"}), 2);
  folder.file("rungproof.toml", "port-to = \"ST40\"\n");
  EXPECT_EQ(finds({}), 1);
}

}  // namespace
}  // namespace rungproof
