// One place by all its names - absolute, symbolic, by the parts of an instance, in either set of mnemonics - in traces,
// stimuli, properties and xref.
#include "tests/step7/run7.hpp"

namespace rungproof {
namespace {

using test7::block, test7::lastRow, test7::Output, test7::proofOf, test7::run;

const std::string project =
    "FUNCTION_BLOCK FB 1\nVAR_INPUT\n  x : BOOL;\nEND_VAR\nVAR\n  n : INT;\nEND_VAR\nBEGIN\nNETWORK\nA #x;\n= #x;\n"
    "END_FUNCTION_BLOCK\n"
    "DATA_BLOCK \"Motor\"\nSTRUCT\n  On : BOOL;\n  Speed : INT;\n  list : ARRAY [1..3] OF INT;\nEND_STRUCT;\nBEGIN\n"
    "END_DATA_BLOCK\nDATA_BLOCK \"InstDb\"\nFB 1\nBEGIN\nEND_DATA_BLOCK\n" +
    block(1,
          "A I 0.0;= \"Motor\".On;L PIW 256;T \"Motor\".Speed;T \"Motor\".list[2];T PQW 260;CALL FB 1, \"InstDb\" (x "
          ":= I "
          "0.0);A I 0.0;L S5T#100MS;SE T 5;CU C 3");

struct Written {
  const char* name;
  int value;
};
// "Motor" is DB1, "InstDb" DB2: numbers in the order of the file. Speed is at 2.0, list[2] at 6.0, x at 0.0. I0.0 is on
// and PIW256 is 77 in the second scan; T5 was started there with 100 ms of which the scan of 10 ms has passed in part,
// C3 has counted one edge.
const Written places[] = {{"\"Motor\".On", 1},     {"Motor.On", 1},     {"DB1.DBX0.0", 1},   {"DB1.DBX 0.0", 1},
                          {"\"Motor\".Speed", 77}, {"Motor.Speed", 77}, {"DB1.DBW2", 77},    {"\"Motor\".list[2]", 77},
                          {"Motor.list[2]", 77},   {"DB1.DBW6", 77},    {"\"InstDb\".x", 1}, {"InstDb.x", 1},
                          {"DB2.DBX0.0", 1},       {"I0.0", 1},         {"E0.0", 1},         {"T5", 1},
                          {"C3.value", 1},         {"Z3.value", 1},     {"C3", 1},           {"PIW256", 77},
                          {"PEW256", 77},          {"PQW260", 77},      {"PAW260", 77}};

TEST(Address7, NamesOfTraces) {
  for (const Written& place : places) {
    const std::string row = lastRow(project, place.name, {"--scans", "2"}, "scan,I0.0,PIW256\n1,0,0\n2,1,77\n");
    EXPECT_TRUE(row.ends_with("," + std::to_string(place.value))) << place.name << ": " << row;
  }
}

// The names of inputs in a stimulus; a panel may write a data block.
TEST(Address7, NamesOfStimuli) {
  for (const char* heading : {"scan,I0.0,PIW256", "scan,E0.0,PEW256"}) {
    const std::string row = lastRow(project, "DB1.DBW2", {"--scans", "1"}, std::string(heading) + "\n1,1,77\n");
    EXPECT_TRUE(row.ends_with(",77")) << heading << ": " << row;
  }
  const std::string blocks = "DATA_BLOCK \"Panel\"\nSTRUCT\n  a : INT;\nEND_STRUCT;\nBEGIN\nEND_DATA_BLOCK\n" +
                             block(1, "L \"Panel\".a;T MW 0");
  for (const char* name : {"DB1.DBW0", "Panel.a", "\"\"\"Panel\"\".a\""}) {
    const std::string row = lastRow(blocks, "MW0", {"--scans", "1"}, std::string("scan,") + name + "\n1,12\n");
    EXPECT_TRUE(row.ends_with(",12")) << name << ": " << row;
  }
}

// Each is reached with its value. A blank ends a word of a property.
TEST(Address7, NamesOfProperties) {
  std::string properties;
  for (const Written& place : places) {
    if (std::string(place.name).find(' ') != std::string::npos) continue;
    const bool isBit = place.value == 1 && std::string(place.name).find("value") == std::string::npos;
    properties += std::string("reach ") + std::to_string(&place - places) + ": " + place.name +
                  (isBit ? "" : " = " + std::to_string(place.value)) + "\n";
  }
  const Output output = proofOf(properties, project);
  EXPECT_FALSE(output.has("UNREACHABLE") || output.has("error")) << output.text;
  for (std::size_t i = 0; i < std::size(places); ++i)
    EXPECT_TRUE(std::string(places[i].name).find(' ') != std::string::npos ||
                output.has("REACHABLE  " + std::to_string(i)))
        << places[i].name << output.text;
}

// T5.value is what is left in ms: all 100 ms of its start can be left.
TEST(Address7, TimeThatIsLeft) {
  const Output output = proofOf("reach all: T5.value = 100\n", project);
  EXPECT_TRUE(output.has("REACHABLE  all") && !output.has("UNREACHABLE")) << output.text;
}

TEST(Address7, NamesOfCrossReferences) {
  const test::TemporaryFolder folder;
  folder.file("main.awl", project);
  const auto xref = [&](const char* name) { return run({"xref", folder.path("main.awl"), name}).text; };
  for (const auto& [first, second] : {std::pair{"DB1.DBW2", "\"Motor\".Speed"},
                                      {"DB1.DBX0.0", "Motor.On"},
                                      {"DB2.DBX0.0", "\"InstDb\".x"},
                                      {"I0.0", "E0.0"},
                                      {"C3", "Z3"},
                                      {"PIW256", "PEW256"},
                                      {"PQW260", "PAW260"}}) {
    EXPECT_NE(xref(first).find("1, network 1"), std::string::npos) << first << xref(first);
    EXPECT_EQ(xref(first), xref(second)) << first << second;
  }
}

}  // namespace
}  // namespace rungproof
