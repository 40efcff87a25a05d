// The run that `prove --traces` writes is repeated by `sim --stimulus`, scan by scan, whatever the surroundings did.
#include "frontend/simulation/given_columns.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <set>

#include "frontend/simulation/stimulus_reader.hpp"
#include "frontend/simulation/witness_report.hpp"
#include "tests/engine/rig.hpp"
#include "tests/program_run.hpp"

namespace rungproof {
namespace {

namespace fs = std::filesystem;

test::ProgramRun runCommand(std::vector<std::string> arguments) {
  arguments.push_back("--isolated");
  return test::run(arguments);
}

struct Case {
  const char* name;
  const char* text;
};

// What an address at the end of a scan cannot tell, one in each program; each property is violated.
const Case cases[] = {
    // Two immediate reads of one scan may differ (001:2843).
    {"immediate", "//@ prove p: never M0.0 and M0.1\nLDI I0.0\n= M0.0\nLDNI I0.0\n= M0.1\n"},
    // The level that a pop shifts in has any value (001:2868).
    {"stack", "//@ prove p: never Q0.0\nLD I0.0\nLPS\nLPP\nALD\n= Q0.0\n"},
    // What stands in the input image is overwritten by the program: the column shows the value at the end.
    {"image", "//@ prove p: never Q0.0\nLD I0.0\n= Q0.0\nLD SM0.0\nR I0.0, 1\n"},
    // An area that another station writes, and the program as well: the value of the beginning counts.
    {"external", "//@ external VB10\n//@ prove p: never Q0.0\nLDB= VB10, 7\n= Q0.0\nLD SM0.0\nMOVB 0, VB10\n"},
    // Retentive counters start with any value.
    {"counter",
     "//@ initial retentive\n//@ prove p: never Q0.0\nLD I0.0\nLD I0.1\nCTU C0, 500\nLDW>= C0, 400\n= Q0.0\n"},
    // T32 may tick between two instructions of a scan (001:3990).
    {"tick",
     "//@ prove p: never Q0.0 and M0.1\nLD T32\n= M0.0\nLD SM0.0\nTON T32, 5\nLDN M0.0\nA T32\n= Q0.0\nLD SM0.0\n= "
     "M0.1\n"},
    // The clock shows any time.
    {"clock", "//@ prove p: never Q0.0\nLD SM0.0\nTODR VB20\nLDB= VB20, 16#05\n= Q0.0\n"},
    // An analog input is read anew at each read, if it is not filtered.
    {"analog", "//@ prove p: never Q0.0 and Q0.1\nLDW= AIW0, 5\n= Q0.0\nLDW= AIW0, 6\n= Q0.1\n"},
    // Only the property names this input.
    {"named", "//@ prove p: Q0.0 implies not I1.3\nLD I0.0\n= Q0.0\n"},
};

TEST(GivenColumns, EveryWitnessIsRepeatedByThePublicCommand) {
  const test::TemporaryFolder folder;
  int repeated = 0;
  for (const Case& c : cases) {
    SCOPED_TRACE(c.name);
    const std::string program = folder.file(std::string(c.name) + ".awl", c.text);
    std::vector<std::string> proof = {"prove", program, "--traces", folder.path(c.name)};
    if (std::string(c.name) == "analog") proof.insert(proof.end(), {"--choice", "analog-sampling=each-read"});
    const test::ProgramRun proved = runCommand(proof);
    ASSERT_EQ(proved.exit, 1) << proved.out << proved.err;
    const std::string witness = (fs::path(folder.path(c.name)) / "p.csv").string();
    std::vector<std::string> repeat = {"sim", program, "--stimulus", witness, "--expect", witness};
    if (std::string(c.name) == "analog") repeat.insert(repeat.end(), {"--choice", "analog-sampling=each-read"});
    const test::ProgramRun simulated = runCommand(repeat);
    EXPECT_EQ(simulated.exit, 0) << simulated.out << simulated.err;
    EXPECT_EQ(simulated.err, "");
    ++repeated;
  }
  EXPECT_EQ(repeated, static_cast<int>(std::size(cases)));
}

struct Case7 {
  const char *name, *properties, *statements;
  const char* declarations = "";
};

// The same of an S7-300/400.
const Case7 cases7[] = {
    // Registers and temporary data hold any value when an organization block begins.
    {"accumulator", "prove p: MW4 <> 77", "+ 0;\nT MW 4;\n"},
    {"temporary", "prove p: MW4 <> 77", "L LW 20;\nT MW 4;\n", "VAR_TEMP\nh : ARRAY [0..21] OF BYTE;\nEND_VAR\n"},
    // A module may answer each read with another value.
    {"module", "prove p: not Q0.0", "L PIW 256;\nT MW 4;\nL PIW 256;\nL MW 4;\n<>I;\n= Q 0.0;\n"},
    // Outputs of blocks of the system; MW4 is named by the property and by a call whose interface nobody knows.
    {"contract", "prove p: MW4 <> 77", "CALL SFC 41 (RET_VAL := MW 4);\n"},
    {"undescribed", "prove p: MW4 <> 77", "CALL SFC 51 (REQ := M 0.0, RET_VAL := MW 4);\n"},
    {"clock", "prove p: MD4 <> 77", "CALL SFC 64 (RET_VAL := MD 4);\n"},
    // Start information: OB1_SCAN_1 is 1 in the first scan (002:2000).
    {"start", "prove p: MB4 = 3", "L LB 1;\nT MB 4;\n", "VAR_TEMP\nh : ARRAY [0..19] OF BYTE;\nEND_VAR\n"},
    {"counter", "initial retentive\n//@ prove p: MW4 <> 77", "A I 0.0;\nCU C 1;\nL C 1;\nT MW 4;\n"},
    {"timer", "prove p: not Q0.0", "A I 0.0;\nL S5T#1S;\nSD T 1;\nA T 1;\n= Q 0.0;\n"},
};

TEST(GivenColumns, WitnessesOfAnS7300AreRepeated) {
  const test::TemporaryFolder folder;
  for (const Case7& c : cases7) {
    SCOPED_TRACE(c.name);
    const std::string program =
        folder.file(std::string(c.name) + ".awl", std::string("//@ ") + c.properties + "\nORGANIZATION_BLOCK OB 1\n" +
                                                      c.declarations + "BEGIN\nNETWORK\n" + c.statements +
                                                      "END_ORGANIZATION_BLOCK\n");
    const test::ProgramRun proved =
        runCommand({"prove", program, "--dialect", "s7-300", "--traces", folder.path(c.name)});
    ASSERT_EQ(proved.exit, 1) << proved.out << proved.err;
    const std::string witness = (fs::path(folder.path(c.name)) / "p.csv").string();
    const test::ProgramRun run =
        runCommand({"sim", program, "--dialect", "s7-300", "--stimulus", witness, "--expect", witness});
    EXPECT_EQ(run.exit, 0) << run.out << run.err;
    EXPECT_EQ(run.err, "");
  }
}

// A scan that ends in STOP: properties see the image as the program left it, `sim` shows outputs that are off. Of an
// S7-300/400 nothing is asked of such a scan.
TEST(GivenColumns, RunsThatEndInStopAreRepeated) {
  const test::TemporaryFolder folder;
  const std::pair<std::string, std::vector<std::string>> programs[] = {
      {"LD I0.0\nSTOP\nLD I0.1\n= Q0.0\n", {"--choice", "stop-in-main=end-of-scan"}},
      {"LD I0.1\n= Q0.0\nLD I0.0\nSTOP\n", {"--choice", "stop-in-main=at-once"}},
      {"LD SM0.1\nATCH 0, 0\nENI\nLD I0.1\n= Q0.0\nMEND\nINT 0\nLD SM0.0\nSTOP\nRETI\n", {}}};
  for (const auto& [text, options] : programs) {
    SCOPED_TRACE(text);
    const std::string program = folder.file("stops.awl", "//@ prove p: not (I0.0 and Q0.0)\n" + text);
    std::vector<std::string> proof = {"prove", program, "--traces", folder.path("stops")};
    proof.insert(proof.end(), options.begin(), options.end());
    const test::ProgramRun proved = runCommand(proof);
    ASSERT_EQ(proved.exit, 1) << proved.out << proved.err;
    EXPECT_NE(proved.out.find("VIOLATED  p"), std::string::npos) << proved.out;
    const std::string witness = (fs::path(folder.path("stops")) / "p.csv").string();
    std::vector<std::string> repeat = {"sim", program, "--stimulus", witness, "--expect", witness};
    repeat.insert(repeat.end(), options.begin(), options.end());
    const test::ProgramRun simulated = runCommand(repeat);
    EXPECT_EQ(simulated.exit, 0) << simulated.out << simulated.err;
  }
}

// Variables of IEC 61131-3 may have the names of columns.
TEST(GivenColumns, VariablesMayBeCalledLikeColumns) {
  const test::TemporaryFolder folder;
  const std::string program =
      folder.file("names.st",
                  "//@ prove p: not q\nPROGRAM main\nVAR_INPUT Start, Event, Given, Device, Scan_ms : BOOL; "
                  "END_VAR\nVAR q : BOOL; END_VAR\nq := Start AND NOT Event AND Given AND Device AND "
                  "Scan_ms;\nEND_PROGRAM\n");
  ASSERT_EQ(runCommand({"prove", program, "--traces", folder.path("names")}).exit, 1);
  const std::string witness = (fs::path(folder.path("names")) / "p.csv").string();
  const test::ProgramRun run = runCommand({"sim", program, "--stimulus", witness, "--expect", witness});
  EXPECT_EQ(run.exit, 0) << run.out << run.err;
}

/// Programs of the corpus with a property, in order of their names.
std::vector<std::string> corpusPrograms() {
  std::vector<std::string> programs;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(RUNGPROOF_SOURCE_DIR) / "corpus")) {
    const fs::path extension = entry.path().extension();
    if (extension != ".awl" && extension != ".st" && extension != ".xml") continue;
    if (test::contentOf(entry.path()).find("//@") != std::string::npos) programs.push_back(entry.path().string());
  }
  std::ranges::sort(programs);
  return programs;
}

// The corpus finds what the cases above forget. RUNGPROOF_WITNESSES=all takes every program in place of each eighth,
// and asks the built-in checks too, of which some runs end with the error that they ask for.
TEST(GivenColumns, WitnessesOfTheCorpusAreRepeated) {
  const char* const wish = std::getenv("RUNGPROOF_WITNESSES");
  const bool isLong = wish != nullptr && std::string_view(wish) == "all";
  const std::size_t stride = isLong ? 1 : 8;
  const test::TemporaryFolder folder;
  const std::vector<std::string> programs = corpusPrograms();
  std::size_t repeated = 0;
  for (std::size_t i = 0; i < programs.size(); i += stride) {
    const std::string traces = folder.path(std::to_string(i));
    std::vector<std::string> proof = {"prove", programs[i], "--timeout", "2s", "--traces", traces};
    if (isLong) proof.emplace_back("--builtin");
    const test::ProgramRun proved = runCommand(proof);
    if (!fs::exists(traces) || proved.exit == 2) continue;  // 2: a part is refused, and sim runs no rest
    for (const auto& entry : fs::directory_iterator(traces)) {
      if (entry.path().extension() != ".csv") continue;
      const std::string witness = entry.path().string();
      const test::ProgramRun run = runCommand({"sim", programs[i], "--stimulus", witness, "--expect", witness});
      const bool endsWithError = isLong && run.out.find("error[RUN002]") != std::string::npos &&
                                 run.out.find("first difference") == std::string::npos;
      EXPECT_TRUE(run.exit == 0 || endsWithError) << programs[i] << ' ' << witness << '\n' << run.out << run.err;
      EXPECT_EQ(run.err.find("did not ask for"), std::string::npos) << programs[i] << ' ' << witness << run.err;
      ++repeated;
    }
  }
  EXPECT_GE(repeated, programs.size() / stride / 2);
}

// A byte behind the last one that has an address is read by a word at the edge: IB32 of an S7-200 SMART.
TEST(GivenColumns, BytesWithoutAddressAreGivenByTheirNumber) {
  const test::TemporaryFolder folder;
  const std::string program = folder.file("p.awl", "LD I0.0\n= Q0.0\n");
  const std::string witness =
      folder.file("s.csv", "scan,given,start,I0.0\n1,set.I[32]=5,,1\n2,set.I[0]=0 set.VB3=4,,\n");
  const std::string expected = folder.file("e.csv", "scan,Q0.0,VB3\n1,1,0\n2,0,4\n");
  const test::ProgramRun run =
      runCommand({"sim", program, "--cpu", "ST60", "--stimulus", witness, "--expect", expected});
  EXPECT_EQ(run.exit, 0) << run.out << run.err;
  for (const char* wrong : {"set.I[32]=256", "set.II[3]=1", "set.I[x]=1"}) {
    const std::string refused = folder.file("w.csv", std::string("scan,given,start\n1,") + wrong + ",\n");
    EXPECT_EQ(runCommand({"sim", program, "--stimulus", refused}).exit, 2) << wrong;
  }
}

// A counter that counts down to the end of its range and back needs 131,072 scans: the trace has them all.
TEST(GivenColumns, ALongRunIsWhole) {
  const Rig rig("LD I0.1\n= Q0.0\n");
  constexpr std::uint64_t scans = 131'072;
  const TraceSignal input = signalOf(rig.program, direct(Area::I, Width::Bit, 0, 1));
  ReplayScan scan;
  scan.lengthMs = 10;
  scan.inputs.push_back({input.operand, 1});
  scan.repeats = scans;
  Witness witness;
  witness.scans.push_back(scan);
  witness.scanCount = scans;
  Trace trace = traceOf(rig.program, Choices(), witness, {input});
  addGiven(rig.program, Choices(), witness, trace);
  EXPECT_EQ(trace.rows.size(), scans);
  EXPECT_TRUE(trace.isWhole);
}

// Every kind of value that the engine asks for has a word of its own, and the reader gives the same site back.
TEST(GivenColumns, EveryKindIsReadBack) {
  const Rig rig("LD I0.0\n= Q0.0\n");
  const Program& program = rig.program;
  const std::uint32_t last = program.pous[0].networks[0].instructions[1].id;
  GivenReader reader(program);
  std::set<std::string_view> names;
  for (int kind = 0; kind <= static_cast<int>(External::TimerPhase); ++kind) {
    const std::string_view name = externalName(static_cast<External>(kind));
    EXPECT_TRUE(names.insert(name).second) << name;
    StimulusRow row;
    Failure failure;
    ASSERT_TRUE(reader.readGiven(std::string(name) + "[3]@#" + std::to_string(last) + "*1=4000000000", row, failure));
    ASSERT_EQ(row.externals.size(), 1U);
    EXPECT_EQ(static_cast<int>(row.externals[0].site.kind), kind);
    EXPECT_EQ(row.externals[0].site.index, 3U);
    EXPECT_EQ(row.externals[0].site.instruction, last);
    EXPECT_EQ(row.externals[0].value, 4000000000U);
  }
}

TEST(GivenColumns, WhatIsNotKnownIsAnError) {
  const test::TemporaryFolder folder;
  const std::string program = folder.file("p.awl", "LD I0.0\n= Q0.0\n");
  for (const char* text :
       {"scan,given,start\n1,imediate[0]@1=1,\n", "scan,given,start\n1,immediate[0]@99=1,\n",
        "scan,given,start\n1,tick=1,\n", "scan,start\n1,AC[0]=1\n", "scan,given,start\n1,,ACX[0]=1\n",
        "scan,given,start\n1,,\n2,,AC[0]=1\n", "scan,gven\n1,x\n"}) {
    EXPECT_EQ(runCommand({"sim", program, "--stimulus", folder.file("s.csv", text)}).exit, 2) << text;
  }
  const test::ProgramRun unasked =
      runCommand({"sim", program, "--stimulus", folder.file("s.csv", "scan,given,start\n1,clock[0]@1=1,\n")});
  EXPECT_NE(unasked.err.find("did not ask for 1 values"), std::string::npos) << unasked.err;
}

// 16#3F000000 is the pattern of 0.5 (sign 0, exponent 126, mantissa 0).
TEST(GivenColumns, HexadecimalCellsOfAREALAreItsBits) {
  const test::TemporaryFolder folder;
  const std::string program = folder.file("r.awl", "LDR= VD0, 0.5\n= Q0.0\nLD SM0.0\nMOVR VD0, VD8\n");
  const std::string expected = folder.file("e.csv", "scan,Q0.0,VD8\n1,1,16#3F000000\n");
  const std::string stimulus = folder.file("s.csv", "scan,VD0\n1,16#3F000000\n");
  EXPECT_EQ(runCommand({"sim", program, "--stimulus", stimulus, "--expect", expected}).exit, 0);
  EXPECT_EQ(runCommand({"sim", program, "--set", "VD0=16#3F000000", "--expect", expected}).exit, 0);
  EXPECT_EQ(runCommand({"sim", program, "--set", "VD0=0.5", "--expect", expected}).exit, 0);
  const std::string wrong = folder.file("w.csv", "scan,VD8\n1,16#3F800000\n");
  EXPECT_EQ(runCommand({"sim", program, "--stimulus", stimulus, "--expect", wrong}).exit, 1);
}

}  // namespace
}  // namespace rungproof
