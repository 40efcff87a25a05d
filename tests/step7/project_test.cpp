// Whole projects: several files in any order, every form of symbol table, both mnemonic sets, code pages and UTF-8.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "frontend/input/program_input.hpp"
#include "ir/block_map.hpp"
#include "ir/s7300/block.hpp"
#include "ir/s7300/cpu.hpp"
#include "ir/s7300/isa.hpp"
#include "tests/step7/read7.hpp"
#include "tests/step7/run7.hpp"
#include "tests/temporary_folder.hpp"

namespace rungproof {
namespace {

namespace fs = std::filesystem;

const fs::path projects = fs::path(RUNGPROOF_SOURCE_DIR) / "tests/data/s7300_projects";

std::vector<std::string> filesOf(const std::string& project) {
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator(projects / project)) files.push_back(entry.path().string());
  std::ranges::sort(files);
  return files;
}

struct Project {
  const char* folder;
  std::size_t codeBlocks, dataBlocks, instructions;
};

// Blocks, data blocks and instructions as they stand in the sources, labels counted as instructions.
const Project all[] = {{"asc_press", 2, 0, 17}, {"conveyors", 3, 1, 19}, {"copy_area", 3, 2, 55},
                       {"dif_fan", 2, 0, 8},    {"iec_timers", 2, 1, 4}, {"mischer", 2, 0, 29},
                       {"recipes", 2, 2, 13},   {"seq_tanks", 2, 2, 6},  {"step_chain", 4, 1, 57},
                       {"tia_motor", 2, 1, 16}};

TEST(Projects, AreReadWithoutAFalseError) {
  for (const Project& project : all) {
    const Program program = readProgram(filesOf(project.folder));
    for (const Finding& finding : program.findings) {
      EXPECT_NE(finding.severity, Severity::Error) << project.folder << ": " << finding.message;
      EXPECT_EQ(finding.rule, "SYN052") << project.folder << ": " << finding.message;
    }
    const std::span own(program.pous.data(),
                        std::min(program.pous.size(), project.codeBlocks));  // the libraries' follow
    EXPECT_EQ(own.size(), project.codeBlocks) << project.folder;
    std::size_t instructions = 0;
    for (const Pou& pou : own) {
      for (const Network& network : pou.networks) instructions += network.instructions.size();
    }
    EXPECT_EQ(program.dataBlocks.size(), project.dataBlocks) << project.folder;
    EXPECT_EQ(instructions, project.instructions) << project.folder;
    EXPECT_TRUE(isStep7(program.target)) << project.folder;
    ASSERT_NE(program.main(), nullptr) << project.folder;
  }
}

TEST(Projects, TheOrderOfTheFilesDoesNotMatter) {
  for (const Project& project : all) {
    std::vector<std::string> files = filesOf(project.folder);
    const Program forwards = readProgram(files);
    std::ranges::reverse(files);
    const Program backwards = readProgram(files);
    // Blocks stand in the order of the files; each is the same.
    for (const Pou& pou : forwards.pous) {
      const auto twin = std::ranges::find(backwards.pous, pou.name, &Pou::name);
      ASSERT_NE(twin, backwards.pous.end()) << project.folder;
      EXPECT_EQ(show7(*twin), show7(pou)) << project.folder;
    }
    ASSERT_EQ(forwards.dataBlocks.size(), backwards.dataBlocks.size());
    for (std::size_t i = 0; i < forwards.dataBlocks.size(); ++i)
      EXPECT_EQ(forwards.dataBlocks[i].bytes, backwards.dataBlocks[i].bytes) << project.folder;
  }
}

TEST(Projects, AFolderIsAProjectWithItsTables) {
  const std::vector<std::string> files = expandFolders({(projects / "conveyors").string()});
  EXPECT_EQ(files.size(), 4u);
  const Program program = readProgram(files);
  EXPECT_EQ(findings7(program), "");
  EXPECT_EQ(show7(*program.main()),
            fmt::format("CALL Line={} DBB2:0 I0.0 I0.1 Q4.0 Q4.1", blockNumber(BlockType::Fb, 2)));
}

// Without a comment the last word of a row is its type, and INT alone on the end of a line is a heading of an S7-200.
// Blanks in addresses make of "I 0.0" two words of a statement.
TEST(Projects, TablesThatLookLikeAnotherFamily) {
  const test::TemporaryFolder folder;
  folder.file("main.awl", test7::block(1, "L \"Level\";T MW 0;A \"On\";= Q 0.0"));
  folder.file("short.csv", "Symbol;Operand;Datentyp;Kommentar\nOn;E 0.0;BOOL;\nLevel;EW 4;INT;\n");
  folder.file("long.csv", "Symbol;Adresse;Datentyp;Kommentar\nLevel;IW 4;INT;x\nOn;I 0.0;BOOL;x\nOut;Q 0.0;BOOL;x\n");
  folder.file("main.prop", "prove copy: MW0 = Level\nprove on: Q0.0 = On\n");
  for (const char* table : {"short.csv", "long.csv"}) {
    const test7::Output proof = test7::run({"prove", folder.path(table), folder.path("main.awl"), "--props",
                                            folder.path("main.prop"), "--dialect", "auto"});
    EXPECT_TRUE(proof.has("PROVED  copy") && proof.has("PROVED  on")) << table << "\n" << proof.text;
  }
}

// Nothing runs the block of a project without OB1: it writes no output, which is no proof about the machine.
TEST(Projects, WithoutAMainProgramNothingIsProved) {
  const std::string block = "FUNCTION FC 1 : VOID\nBEGIN\nNETWORK\nA I 0.0;\n= Q 0.0;\nEND_FUNCTION\n";
  const test7::Output proof = test7::proofOf("prove off: never Q0.0\n", block);
  EXPECT_EQ(proof.exit, 2);
  EXPECT_TRUE(proof.has("no main program")) << proof.text;
  EXPECT_FALSE(proof.has("PROVED")) << proof.text;
  EXPECT_TRUE(test7::proofOf("prove off: never Q0.0\n", block + test7::block(1, "NOP 0")).has("PROVED"));
}

// A rung that begins with a load is a rule of the S7-200.
TEST(Projects, TheEditorTakesStatementsOfEachForm) {
  const test::TemporaryFolder folder;
  folder.file("main.awl", test7::block(1, "A I 0.0;= Q 0.0;L MW 0;T MW 2;A I 0.1;= Q 0.1"));
  const test7::Output verdict = test7::run({"check", folder.path("main.awl")});
  EXPECT_EQ(verdict.exit, 0) << verdict.text;
  EXPECT_TRUE(verdict.has("1 network: 1 valid, 0 invalid")) << verdict.text;
}

TEST(Projects, NamesOfDataForProperties) {
  const Program program = readProgram(filesOf("recipes"));
  const OperandLookup lookup = lookupIn(program);
  const auto placeOf = [&](std::string_view name) {
    const std::optional<Operand> operand = lookup(name);
    return operand ? show7(*operand) : "nothing";
  };
  // A recipe: three INT, the oven of 6 bytes (INT, S5TIME, BOOL), a text of 16: 28 bytes. List begins at 2.
  EXPECT_EQ(placeOf("\"Book\".List[2].Eggs"), "DBW20:34");
  EXPECT_EQ(placeOf("Book.List[1].Oven.FromBelow"), "DB20:12.0");
  EXPECT_EQ(placeOf("\"Order\".Grams"), "DBD21:32");
  EXPECT_EQ(placeOf("DB20.DBW2"), "DBW20:2");
  EXPECT_EQ(placeOf("DB20.List[2].Eggs"), "DBW20:34");
  EXPECT_EQ(placeOf("DB20.Missing"), "nothing");
  EXPECT_EQ(placeOf("DB99.DBW0"), "nothing");      // no such block
  EXPECT_EQ(placeOf("DB20.DBW65000"), "nothing");  // the block ends before
  EXPECT_EQ(placeOf("\"Book\".Missing"), "nothing");
  EXPECT_EQ(placeOf("I0.0"), "I0.0");
  EXPECT_EQ(placeOf("A16.1"), "Q16.1");  // German: no data block is called A16
  EXPECT_EQ(placeOf("EW2"), "IW2");
  EXPECT_EQ(placeOf("T5"), "T5");
  EXPECT_EQ(placeOf("PIW256"), "PIW256");
}

TEST(Projects, ActualValuesStandOverInitialOnes) {
  const Program program = readProgram(filesOf("recipes"));
  ASSERT_EQ(program.dataBlocks.size(), 2u);
  const std::vector<std::uint8_t>& book = program.dataBlocks[0].bytes;
  const auto word = [&](std::size_t at) { return book.at(at) << 8 | book.at(at + 1); };
  EXPECT_EQ(word(0), 3);
  EXPECT_EQ(word(2), 250);   // List[1].Butter: of the type
  EXPECT_EQ(word(30), 300);  // List[2].Butter: assigned
  EXPECT_EQ(word(62), 6);    // List[3].Eggs
  EXPECT_EQ(word(86), 50);   // Factors[1]
  EXPECT_EQ(word(92), 150);  // Factors[4]: the second of 2 (150)
  EXPECT_TRUE(program.dataBlocks[0].readOnly);
  EXPECT_EQ(program.dataBlocks[0].name, "Book");
}

TEST(Projects, BlocksTwiceHaveBothPlaces) {
  const test::TemporaryFolder folder;
  const std::string block = "FUNCTION FC 1 : VOID\nBEGIN\nNETWORK\nSET;\nEND_FUNCTION\n";
  const std::string first = folder.file("a.awl", block), second = folder.file("b.awl", "// b\n" + block);
  const Program program = readProgram({first, second});
  EXPECT_EQ(findings7(program), "SYN022 2:1 FC1 is there twice: only the first one is read");
  ASSERT_EQ(program.findings[0].related.size(), 1u);
  EXPECT_EQ(program.sources->file(program.findings[0].related[0].span.file).name(), first);
}

TEST(Projects, BothFamiliesInOneProgramAreRefused) {
  const test::TemporaryFolder folder;
  const Program program =
      readProgram({folder.file("a.awl", "FUNCTION FC 1 : VOID\nBEGIN\nNETWORK\nSET;\nEND_FUNCTION\n"),
                   folder.file("b.awl", "Network 1\nLD I0.0\n= Q0.0\n")});
  ASSERT_FALSE(program.findings.empty());
  EXPECT_EQ(program.findings[0].rule, "SYN050");
}

TEST(Projects, EncodingsOfEachFile) {
  const test::TemporaryFolder folder;
  const std::string source = folder.file(
      "a.awl",
      "\xEF\xBB\xBF"
      "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nA \"T\xC3\xBCr\";\n= \"L\xC3\xA4mpchen\";\nEND_ORGANIZATION_BLOCK\n");
  const std::string table = folder.file("t.sdf",
                                        "\"T\xFCr                     \",\"I       0.0 \",\"BOOL      \",\"\"\r\n"
                                        "\"L\xE4mpchen                \",\"Q       0.0 \",\"BOOL      \",\"\"\r\n");
  const Program program = readProgram({source, table});
  EXPECT_EQ(findings7(program), "");
  EXPECT_EQ(show7(program.pous.at(0)), "A I0.0; = Q0.0");
}

TEST(Projects, TheDialectMayBeNamed) {
  ReadOptions options;
  options.dialect = "s7-300";
  const Program program = readText("x.awl", "A I 0.0\n= Q 0.0\n", options);
  EXPECT_EQ(findings7(program), "");
  EXPECT_EQ(show7(program.pous.at(0)), "A I0.0; = Q0.0");
  options.dialect = "s7-400";
  EXPECT_EQ(cpuName(readText("x.awl", "A I 0.0\n= Q 0.0\n", options).target.cpu), "417");
}

// A block without a number answers to no number that a program says: FC 1 is in no file here, so nothing is proved
// beside its call (the block of the same kind without a number may be another one). DT_DAY and its like are FC 1 to
// FC 40.
TEST(Projects, NumbersOfBlocksWithoutOneAreOutOfReach) {
  const std::string motor = "FUNCTION \"Motor\" : VOID\nBEGIN\nNETWORK\nA I 0.0;\n= Q 0.0;\nEND_FUNCTION\n";
  const std::string main = "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nUC FC 1;\nEND_ORGANIZATION_BLOCK\n";
  const Program program = readText("x.awl", motor + main);
  EXPECT_EQ(program.subroutine(blockNumber(BlockType::Fc, 1)), nullptr);
  EXPECT_EQ(program.pous.size(), 2u);
  const std::string functions =
      "FUNCTION \"A\" : VOID\nBEGIN\nEND_FUNCTION\n" + std::string("FUNCTION \"B\" : VOID\nBEGIN\nEND_FUNCTION\n");
  for (int number = 1; number <= 40; ++number)
    EXPECT_EQ(readText("x.awl", functions + main).subroutine(blockNumber(BlockType::Fc, number)), nullptr) << number;
}

// The siblings: whatever number a text says, and however high it is, no block without a number has it. A number that is
// computed may be that of any block, so its network is not covered; with a symbol table or a written number it is.
TEST(Projects, NoNumberOfTheTextMeansABlockWithoutOne) {
  const std::string blocks =
      "DATA_BLOCK \"Limits\"\nSTRUCT\na : INT := 7;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n"
      "FUNCTION \"Motor\" : VOID\nBEGIN\nNETWORK\nSET;\n= Q 0.0;\nEND_FUNCTION\n"
      "FUNCTION_BLOCK \"Drive\"\nBEGIN\nNETWORK\nSET;\n= Q 0.1;\nEND_FUNCTION_BLOCK\n";
  const auto rulesOf = [&](const std::string& statements, const std::string& more = "") {
    const std::string main = "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n" + statements + "\nEND_ORGANIZATION_BLOCK\n";
    std::string rules, other;
    for (const Finding& finding : readText("x.awl", blocks + more + main).findings) rules += finding.rule + " ";
    for (const Finding& finding : readText("x.awl", main + more + blocks).findings) other += finding.rule + " ";
    EXPECT_EQ(rules, other) << "the order of the blocks changes nothing: " << statements;
    return rules;
  };
  for (const std::string number : {"1", "2", "65534", "65535"}) {
    EXPECT_EQ(rulesOf("UC FC " + number + ";"), "SYN049 ") << number;
    EXPECT_EQ(rulesOf("UC FB " + number + ";").substr(0, 7), "SYN049 ") << number;
  }
  for (const std::string number : {"1", "2", "8191"}) {
    EXPECT_EQ(rulesOf("L DB" + number + ".DBW 0;\nT MW 0;"), "SYN049 ") << number;
    EXPECT_NE(rulesOf("OPN DB " + number + ";\nL DBW 0;\nT MW 0;").find("SYN049"), std::string::npos) << number;
  }
  EXPECT_EQ(rulesOf("OPN DB [MW 10];\nL DBW 0;\nT MW 0;"), "SYN049 ");
  EXPECT_EQ(rulesOf("OPN DI [MW 10];\nL DIW 0;\nT MW 0;"), "SYN049 ");
  EXPECT_EQ(rulesOf("UC FC [MW 10];"), "SYN049 ");
  EXPECT_EQ(rulesOf("OPN \"Limits\";\nL DBW 0;\nT MW 0;"), "");
  EXPECT_EQ(rulesOf("CALL \"Motor\";"), "");
}

// The order of the files decides no number: each name has the same one in both orders.
TEST(Projects, TheOrderOfFilesChangesNoNumber) {
  const test::TemporaryFolder folder;
  const std::string a = folder.file("a.awl", "FUNCTION \"Motor\" : VOID\nBEGIN\nNETWORK\nSET;\nEND_FUNCTION\n");
  const std::string b = folder.file("b.awl", "FUNCTION \"Pump\" : VOID\nBEGIN\nNETWORK\nCLR;\nEND_FUNCTION\n");
  const auto numbers = [](const Program& program) {
    std::map<std::string, int> result;
    for (const Pou& pou : program.pous) result[pou.name] = pou.number;
    return result;
  };
  EXPECT_EQ(numbers(readProgram({a, b})).size(), 2u);
  EXPECT_EQ(numbers(readProgram({a, b})), numbers(readProgram({b, a})));
}

TEST(Projects, APlainDirectiveKeepsItsPlace) {
  const Program program = readProgram(filesOf("dif_fan"));
  ASSERT_EQ(program.directives.size(), 1u);
  EXPECT_EQ(program.directives[0].text, "prove an open door stops the fan: never Q5.0 and not I1.0");
  EXPECT_EQ(program.directives[0].pou, 0);
  EXPECT_EQ(program.directives[0].network, 1);
}

// A drawing of an S7-200 read as one of the other family: its words are those of that family, and the timer that no
// data block holds there is told.
TEST(Project7, DrawingsOfTheFamilyAreNotTakenForThoseOfAnS7200) {
  const Program program = readProgram({RUNGPROOF_SOURCE_DIR "/corpus/defects/tank_levels_exchanged.xml"}, {});
  EXPECT_NE(program.declarations, nullptr);
  for (const Pou& pou : program.pous) {
    for (const Network& network : pou.networks) {
      for (const Instruction& instruction : network.instructions)
        EXPECT_EQ(s7300Instructions().named(instruction.desc->stl), instruction.desc) << instruction.desc->stl;
    }
  }
  EXPECT_EQ(findings7(program), "");
}

}  // namespace
}  // namespace rungproof
