// The commands sim and compare as a user runs them: files, exit codes, JSON, traces, mistakes.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "frontend/cli.hpp"

namespace rungproof {
namespace {

namespace fs = std::filesystem;

class SimCommand : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("rungproof_sim_" + std::to_string(::getpid()));
    fs::create_directories(folder_);
    write("start.awl", "LD I0.0\nO Q0.0\nAN I0.1\n= Q0.0\nLD Q0.0\nTON T37, +3\nLD T37\n= Q0.1\n");
    write("start.csv", "scan,I0.0,I0.1\n1,1,0\n2,0,\n50,,1\n");
    write("good.csv", "scan,Q0.0,Q0.1\n1,1,0\n30,1,0\n31,1,1\n50,0,\n");
    write("bad.csv", "scan,Q0.0,Q0.1\n1,1,0\n30,1,1\n");
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  void write(const std::string& name, const std::string& text) const { std::ofstream(path(name), std::ios::binary) << text; }
  std::string content(const std::string& name) const {
    std::ifstream stream(path(name), std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
  }
  int run(std::vector<std::string> arguments) {
    std::istringstream in;
    std::ostringstream out, err;
    arguments.push_back("--isolated");
    const int code = runProgram(arguments, {in, out, err});
    out_ = out.str();
    err_ = err.str();
    return code;
  }

  fs::path folder_;
  std::string out_, err_;
};

TEST_F(SimCommand, AgreesWithTheExpectedTrace) {
  EXPECT_EQ(run({"sim", path("start.awl"), "--stimulus", path("start.csv"), "--expect", path("good.csv"), "--format", "json"}), 0) << err_;
  const nlohmann::json json = nlohmann::json::parse(out_);
  EXPECT_EQ(json["command"], "sim");
  EXPECT_EQ(json["comparison"]["equal"], true);
  EXPECT_EQ(json["coverage"]["instructions"], 8);
}

TEST_F(SimCommand, PrintsTheFirstDifference) {
  EXPECT_EQ(run({"sim", path("start.awl"), "--stimulus", path("start.csv"), "--expect", path("bad.csv"), "--format", "json"}), 1);
  const nlohmann::json expected = {{"equal", false}, {"scan", 30}, {"time_ms", 300}, {"signal", "Q0.1"}, {"expected", 1}, {"actual", 0}};
  EXPECT_EQ(nlohmann::json::parse(out_)["comparison"], expected);
  EXPECT_EQ(run({"sim", path("start.awl"), "--stimulus", path("start.csv"), "--expect", path("bad.csv"), "--slack", "1"}), 0);
}

TEST_F(SimCommand, AWrittenTraceReproducesTheRun) {
  ASSERT_EQ(run({"sim", path("start.awl"), "--stimulus", path("start.csv"), "--scan-time", "3ms..25ms", "--seed", "7", "--scans", "80", "--trace", path("t.csv"),
                 "--trace", path("t.vcd"), "--trace", path("t.html"), "--trace", path("t.svg"), "--trace", path("t.json")}),
            0)
      << err_;
  for (const std::string name : {"t.vcd", "t.html", "t.svg", "t.json"}) EXPECT_GT(fs::file_size(path(name)), 100U) << name;
  EXPECT_EQ(run({"sim", path("start.awl"), "--stimulus", path("t.csv"), "--expect", path("t.csv"), "--trace", path("u.csv")}), 0) << out_;
  EXPECT_EQ(content("t.csv"), content("u.csv"));
  EXPECT_EQ(run({"compare", path("t.csv"), path("u.csv")}), 0);
}

TEST_F(SimCommand, WithoutOtherWishesTheTraceIsTheOutput) {
  EXPECT_EQ(run({"sim", path("start.awl"), "--stimulus", path("start.csv"), "--signals", "Q0.0,T37.value"}), 0);
  EXPECT_TRUE(out_.starts_with("scan,time_ms,scan_ms,Q0.0,T37.value\n1,10,10,1,0\n")) << out_;
  EXPECT_EQ(std::count(out_.begin(), out_.end(), '\n'), 51);
}

TEST_F(SimCommand, RunTimeErrorsAreFindings) {
  write("bad.awl", "LD SM0.0\nMOVD 16#FF000000, VD0\nLD I0.0\nMOVB *VD0, VB10\nLD I0.1\nLBL 1\nLD SM0.0\nJMP 1\n");
  write("bad_stimulus.csv", "scan,I0.0\n5,1\n");
  EXPECT_EQ(run({"sim", path("bad.awl"), "--format", "json", "--scans", "3"}), 1);
  const nlohmann::json json = nlohmann::json::parse(out_);
  ASSERT_EQ(json["findings"].size(), 1U);
  EXPECT_EQ(json["findings"][0]["rule"], "RUN002");
  EXPECT_EQ(json["findings"][0]["severity"], "error");
}

TEST_F(SimCommand, BlocksWithoutTextAreNamed) {
  write("call.awl", "LD SM0.0\nCALL MBUS_SLAVE, Q0.1, VB10\n");
  EXPECT_EQ(run({"sim", path("call.awl"), "--format", "json"}), 0) << out_ << err_;
  const nlohmann::json approximated = nlohmann::json::parse(out_)["coverage"]["approximated"];
  ASSERT_EQ(approximated.size(), 1U);
  EXPECT_NE(approximated[0].get<std::string>().find("MBUS_SLAVE at"), std::string::npos);
}

TEST_F(SimCommand, CompareCommand) {
  write("e.csv", "scan,Q0.0,VW10\n1,1,100\n2,1,100\n");
  write("a.csv", "scan,Q0.0,VW10,M0.0\n1,1,100,0\n2,1,104,0\n");
  EXPECT_EQ(run({"compare", path("e.csv"), path("a.csv")}), 1);
  EXPECT_NE(out_.find("scan 2"), std::string::npos) << out_;
  EXPECT_NE(out_.find("VW10"), std::string::npos);
  EXPECT_EQ(run({"compare", path("e.csv"), path("a.csv"), "--tolerance", "VW10=4"}), 0);
  EXPECT_EQ(run({"compare", path("a.csv"), path("e.csv")}), 2);  // M0.0 is missing
  EXPECT_NE(err_.find("no column 'M0.0'"), std::string::npos) << err_;
}

TEST_F(SimCommand, MistakesEndWithTwoAndAReason) {
  struct Case {
    std::vector<std::string> arguments;
    std::string reason;
  };
  write("wrong.csv", "scan,I9.9\n1,1\n");
  write("syntax.awl", "LD I0.0\nFOO\n");
  write("library.awl", "SUBROUTINE_BLOCK SBR_0:SBR0\nBEGIN\nNetwork 1\nLD SM0.0\n= Q0.0\nEND_SUBROUTINE_BLOCK\n");
  const std::string program = path("start.awl");
  for (const Case& c : {Case{{"sim", program, "--stimulus", path("none.csv")}, "cannot be read"}, Case{{"sim", program, "--stimulus", path("wrong.csv")}, "wrong.csv:1:6"},
                        Case{{"sim", program, "--trace", path("t.txt")}, "no ending that names a trace form"}, Case{{"sim", program, "--slack", "1"}, "belong to --expect"},
                        Case{{"sim", program, "--duration", "soon"}, "'soon' is no duration"}, Case{{"sim", program, "--signals", "Q99.0"}, "does not exist"},
                        Case{{"sim", program, "--expect", path("good.csv"), "--tolerance", "Q5.0=1"}, "no column of the expected trace"},
                        Case{{"sim", path("library.awl")}, "no main program"}, Case{{"compare", path("good.csv"), path("none.csv")}, "cannot be read"}}) {
    EXPECT_EQ(run(c.arguments), 2) << c.reason;
    EXPECT_NE(err_.find(c.reason), std::string::npos) << err_;
  }
  EXPECT_EQ(run({"sim", path("syntax.awl")}), 2);
  EXPECT_NE(out_.find("FOO"), std::string::npos);
}

}  // namespace
}  // namespace rungproof
