// Programs of the S7-300/400 on both engines: random ones, those of the corpus, whole projects, and the smallest ones
// for what the compiled form does on its own: registers where ways meet, loops, places found by address.
// RUNGPROOF_SEED chooses other random programs, RUNGPROOF_PROGRAMS how many.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "frontend/input/project.hpp"
#include "ir/block_map.hpp"
#include "ir/s7300/cpu.hpp"
#include "tests/compiled/engine_pair.hpp"
#include "tests/compiled/random_step7.hpp"

namespace rungproof::test {
namespace {

namespace fs = std::filesystem;

PairOptions step7Options(bool anyTime) {
  PairOptions options;
  options.words = Area::M;
  options.firstByte = 10;
  if (anyTime) options.engine.choices.set("s5-time", "any");
  return options;
}

/// Both engines on a program without errors; gives the scans that machine code ran.
std::uint64_t compare(const Program& program, const std::string& name, PairOptions options, std::uint64_t seed = 1) {
  for (const Finding& finding : program.findings)
    EXPECT_NE(finding.severity, Severity::Error) << name << ": " << finding.message;
  RandomSource random(seed);
  const PairOutcome outcome = runBoth(program, random, options);
  EXPECT_EQ(outcome.difference, "") << name;
  return outcome.compiled;
}

void compareRandom(bool is400, bool anyTime, bool functions, bool isScripted = false) {
  const char* given = std::getenv("RUNGPROOF_PROGRAMS");
  const int count = given == nullptr ? (isScripted ? 30 : 60) : std::atoi(given);
  const std::uint64_t seed = testSeed();
  std::uint64_t scans = 0, compiled = 0;
  for (int i = 0; i < count; ++i) {
    const std::uint64_t own = seed + static_cast<std::uint64_t>(i);
    const auto [text, program] = randomStep7(own, is400, functions);
    for (const Finding& finding : program.findings) {  // DB9 and DB77 are missing on purpose
      const bool isMeant = finding.message.starts_with("DB9 ") || finding.message.starts_with("DB77 ");
      ASSERT_TRUE(finding.severity != Severity::Error || isMeant) << "seed " << own << ": " << finding.message;
    }
    PairOptions options = step7Options(anyTime);
    options.isScripted = isScripted;
    options.words = Area::DB;
    options.firstByte = dataByte(1, 0);
    RandomSource random(own);
    const PairOutcome outcome = runBoth(program, random, options);
    scans += static_cast<std::uint64_t>(outcome.scans);
    compiled += outcome.compiled;
    ASSERT_EQ(outcome.difference, "") << "seed " << own << "\n" << text;
  }
  std::printf("%d programs, %llu scans, %llu compiled\n", count, static_cast<unsigned long long>(scans),
              static_cast<unsigned long long>(compiled));
  EXPECT_GE(compiled * 100, scans * 20);
}

TEST(Step7Compiled, RandomProgramsAgree) { compareRandom(false, false, false); }
TEST(Step7Compiled, RandomProgramsOfAnS7400Agree) { compareRandom(true, false, true); }
TEST(Step7Compiled, RandomProgramsAgreeWhereTimePassesAnywhere) { compareRandom(false, true, false); }
TEST(Step7Compiled, RandomProgramsUnderScriptsThatNameNoPlaceAgree) { compareRandom(false, true, false, true); }
TEST(Step7Compiled, RandomProgramsOfAnS7400UnderSuchScriptsAgree) { compareRandom(true, false, true, true); }

TEST(Step7Compiled, TheCorpusAgrees) {
  std::size_t count = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(RUNGPROOF_SOURCE_DIR) / "corpus/s7300")) {
    if (entry.path().extension() != ".awl") continue;
    ++count;
    const Program program = readProgram({entry.path().string()});
    for (const bool anyTime : {false, true}) {
      PairOptions options = step7Options(anyTime);
      options.scans = 150;
      const std::uint64_t compiled = compare(program, entry.path().filename().string(), options);
      EXPECT_GE(compiled, anyTime ? 1U : 120U) << entry.path();
    }
  }
  EXPECT_EQ(count, 14U);
}

TEST(Step7Compiled, ProjectsAgree) {
  std::size_t count = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(RUNGPROOF_SOURCE_DIR) / "tests/data/s7300_projects")) {
    std::vector<std::string> files;
    for (const auto& file : fs::directory_iterator(entry.path())) files.push_back(file.path().string());
    std::ranges::sort(files);
    ++count;
    const std::uint64_t compiled = compare(readProgram(files), entry.path().filename().string(), step7Options(false));
    EXPECT_GT(compiled, 0U) << entry.path();
  }
  EXPECT_EQ(count, 10U);
}

struct Small {
  const char* name;
  const char* text;
  int leastCompiled;  ///< of 60 scans
};

// 59: the first scan is one for the reference engine.
const Small smallPrograms[] = {
    {"a register that the ways to a label leave different",
     "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nL MW 10;\nA I 0.0;\nJC m1;\nL MW 12;\nL 5;\n+I;\nm1: T MW 20;\n"
     "A OV;\n= M 1.0;\nEND_ORGANIZATION_BLOCK\n",
     59},
    {"nesting open over a label",
     "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nA I 0.0;\nA(;\nO I 0.1;\nJC m1;\nO I 0.2;\nm1: );\n= M 1.0;\n"
     "END_ORGANIZATION_BLOCK\n",
     59},
    {"a value from before a loop that is used in it and behind it",
     "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nL MW 14;\nT MW 30;\nL MW 10;\nL 7;\nTAK;\nT MW 34;\nL 5;\n"
     "m1: T MW 20;\nL MW 12;\nL MW 30;\n+I;\nT MW 30;\nL MW 20;\nLOOP m1;\nL MW 34;\nT MW "
     "32;\nEND_ORGANIZATION_BLOCK\n",
     55},
    {"a loop that moves a pointer through memory",
     "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nLAR1 P#40.0;\nL 0;\nT MW 22;\nL 10;\nm1: T MW 20;\n"
     "L MB [AR1,P#0.0];\nL MW 22;\n+I;\nT MW 22;\nT MW [AR1,P#30.0];\n+AR1 P#1.0;\nL MW 20;\nLOOP m1;\n"
     "END_ORGANIZATION_BLOCK\n",
     55},
    {"a pointer across areas that only moves",
     "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nLAR1 P#M 40.0;\nL 10;\nm1: T MW 20;\nA [AR1,P#1.3];\n= [AR1,P#20.5];\n"
     "L B [AR1,P#0.0];\nINC 1;\nT B [AR1,P#30.0];\n+AR1 P#1.0;\nL MW 20;\nLOOP m1;\nEND_ORGANIZATION_BLOCK\n",
     55},
    {"a pointer in memory that may leave its area",
     "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nL MW 10;\nL W#16#FFF8;\nAW;\nT MD 80;\nL 3;\nT MW [MD 80];\nA M [MD "
     "80];\n"
     "= M 1.1;\nL MW 10;\nT MD 84;\nA I [MD 84];\n= M 1.2;\nEND_ORGANIZATION_BLOCK\n",
     1},
    {"an open block of which the number comes from memory",
     "DATA_BLOCK DB 1\nSTRUCT\n a : ARRAY [0 .. 9] OF INT;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n"
     "DATA_BLOCK DB 2\nSTRUCT\n a : ARRAY [0 .. 19] OF INT;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n"
     "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nL 1;\nA I 0.0;\nJC m1;\nL 2;\nm1: T MW 80;\nOPN DB [MW 80];\n"
     "L DBW 2;\n+ 1;\nT DBW 4;\nL DBLG;\nT MW 82;\nA DBX 5.0;\n= DBX 6.1;\nEND_ORGANIZATION_BLOCK\n",
     55},
    {"calls in place, with instances within instances",
     "FUNCTION_BLOCK FB 1\nVAR_INPUT\n x : BOOL;\n n : INT;\nEND_VAR\nVAR_OUTPUT\n s : INT;\nEND_VAR\nVAR\n e : BOOL;\n"
     "END_VAR\nBEGIN\nNETWORK\nA #x;\nFP #e;\nJCN m1;\nL #s;\nL #n;\n+I;\nT #s;\nm1: NOP 0;\nEND_FUNCTION_BLOCK\n"
     "FUNCTION_BLOCK FB 2\nVAR\n a : FB 1;\n b : FB 1;\nEND_VAR\nBEGIN\nNETWORK\n"
     "CALL #a ( x := I 0.0 , n := MW 10 , s := MW 20 );\nA I 0.1;\nJC m1;\n"
     "CALL #b ( x := I 0.2 , n := 5 , s := MW 22 );\nm1: NOP 0;\nEND_FUNCTION_BLOCK\n"
     "DATA_BLOCK DB 1\nFB 2\nBEGIN\nEND_DATA_BLOCK\nDATA_BLOCK DB 2\nFB 2\nBEGIN\nEND_DATA_BLOCK\n"
     "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nCALL FB 2 , DB 1;\nCALL FB 2 , DB 2;\nEND_ORGANIZATION_BLOCK\n",
     59},
    {"a list of jumps, and a block that ends in its middle",
     "FUNCTION FC 1 : VOID\nVAR_IN_OUT\n v : INT;\nEND_VAR\nBEGIN\nNETWORK\nL #v;\nJL m3;\nJU m0;\nJU m1;\nJU m2;\n"
     "m3: L 77;\nT #v;\nBEU;\nm0: L #v;\n+ 1;\nT #v;\nBEU;\nm1: L #v;\n+ 2;\nT #v;\nA I 0.0;\nBEC;\nL 9;\nT #v;\n"
     "m2: L 0;\nT #v;\nEND_FUNCTION\n"
     "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nCALL FC 1 ( v := MW 10 );\nCALL FC 1 ( v := MW 12 );\nA M 10.0;\nCC FC "
     "2;\n"
     "END_ORGANIZATION_BLOCK\nFUNCTION FC 2 : VOID\nBEGIN\nNETWORK\nL MW 14;\nITD;\nT MD 16;\nEND_FUNCTION\n",
     59},
    {"a loop that is entered at its end",
     "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nL 3;\nJU m2;\nm1: T MW 20;\nL MW 22;\nL MW 10;\n+I;\nT MW 22;\n"
     "L MW 20;\nm2: LOOP m1;\nEND_ORGANIZATION_BLOCK\n",
     59},
    {"a loop within a loop, of an instance",
     "FUNCTION_BLOCK FB 1\nVAR_INPUT\n n : INT;\nEND_VAR\nVAR\n a : INT;\n b : INT;\n s : INT;\nEND_VAR\nBEGIN\n"
     "NETWORK\nA I 0.0;\nL 4;\nm1: T #a;\nL 3;\nm2: T #b;\nL #s;\nL #n;\n+I;\nT #s;\nL #b;\nLOOP m2;\nL #a;\n"
     "LOOP m1;\n= M 1.0;\nEND_FUNCTION_BLOCK\nDATA_BLOCK DB 1\nFB 1\nBEGIN\nEND_DATA_BLOCK\n"
     "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nCALL FB 1 , DB 1 ( n := MW 10 );\nEND_ORGANIZATION_BLOCK\n",
     59},
    {"a cyclic interrupt beside machine code",
     "ORGANIZATION_BLOCK OB 35\nBEGIN\nNETWORK\nL MW 40;\n+ 1;\nT MW 40;\nEND_ORGANIZATION_BLOCK\n"
     "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nL MW 40;\nT MW 42;\nEND_ORGANIZATION_BLOCK\n",
     30},
    {"an error that OB121 takes",
     "ORGANIZATION_BLOCK OB 121\nBEGIN\nNETWORK\nL MW 40;\n+ 1;\nT MW 40;\nEND_ORGANIZATION_BLOCK\n"
     "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nL MW 10;\nBTI;\nT MW 42;\nA I 0.0;\n= M 1.0;\nEND_ORGANIZATION_BLOCK\n",
     1},
};

TEST(Step7Compiled, SmallProgramsAgree) {
  for (const Small& small : smallPrograms) {
    ReadOptions reading;
    reading.dialect = "s7-300";
    const Program program = readText("small.awl", small.text, reading);
    for (std::uint64_t seed = 1; seed <= 3; ++seed)
      EXPECT_GE(compare(program, small.name, step7Options(false), seed),
                static_cast<std::uint64_t>(small.leastCompiled))
          << small.name;
  }
}

}  // namespace
}  // namespace rungproof::test
