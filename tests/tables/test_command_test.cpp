// Tables as a user writes them: what passes, what fails and where, waits, ranges, families, mistakes, report forms.
#include "test_command.hpp"

namespace rungproof::test {
namespace {

TEST_F(TestCommand, PassesAndFails) {
  const std::string program = write("motor.awl", motorProgram);
  // After the start the motor holds itself; the stop ends it; with both pressed the stop wins (AN I0.1 comes last).
  const std::string good = write("good.csv",
                                 "test,step,wait,set I0.0,set I0.1,expect Q0.0\n"
                                 "start,press,1 scan,1,0,1\nstart,release,5 scans,0,,1\nstart,stop,,,1,0\n"
                                 "stop wins,both,2 scans,1,1,0\n");
  const nlohmann::json passed = json({program, "--table", good}, 0);
  EXPECT_EQ(passed["command"], "test");
  ASSERT_EQ(passed["tests"].size(), 2U);
  EXPECT_EQ(passed["tests"][0]["name"], "start");
  EXPECT_EQ(passed["tests"][0]["steps"], 3);
  EXPECT_EQ(passed["tests"][0]["passed"], true);
  EXPECT_TRUE(passed["tests"][0]["signal"].is_null());
  const std::string bad = write("bad.csv",
                                "test;step;wait;set I0.0;expect Q0.0\n"
                                "start;press;1 scan;1;1\nstart;release;1 scan;0;0\n");
  const nlohmann::json failed = json({program, "--table", bad}, 1);
  EXPECT_EQ(failed["tests"][0]["passed"], false);
  EXPECT_EQ(failed["tests"][0]["step"], 2);
  EXPECT_EQ(failed["tests"][0]["signal"], "Q0.0");
  EXPECT_EQ(failed["tests"][0]["expected"], "0");
  EXPECT_EQ(failed["tests"][0]["actual"], "1");
}

// A new name begins with power-on: the motor that one test has left running does not run in the next.
TEST_F(TestCommand, BeginsWithPowerOn) {
  const std::string program = write("motor.awl", motorProgram);
  const std::string table = write("t.csv", "test,set I0.0,expect Q0.0\na,1,1\n,0,1\nb,,0\n");
  EXPECT_EQ(run({program, "--table", table}), 0) << out_;
}

// T37 counts 100 ms: 300 ms behind the start the lamp is dark for sure in scan 29 (the first scan starts the timer),
// and lit after 40 scans of 10 ms. A wait of 400 ms is 40 scans of 10 ms, 4 of 100 ms, 6 of 70 ms (420 ms).
TEST_F(TestCommand, WaitsInScansAndTime) {
  const std::string program = write("motor.awl", motorProgram);
  const std::string table = write("t.csv", "test,wait,set I0.0,expect Q0.1\nt,20 scans,1,0\nt,25 scans,,1\n");
  EXPECT_EQ(run({program, "--table", table}), 0) << out_;
  const std::string timed = write("u.csv", "test,wait,set I0.0,expect Q0.1\nt,1 scan,1,0\nt,600 ms,,1\n");
  for (const char* scan : {"1ms", "10ms", "70ms", "100ms"})
    EXPECT_EQ(run({program, "--table", timed, "--scan-time", scan}), 0) << scan << out_;
}

TEST_F(TestCommand, ComparesWordsRangesAndReals) {
  const std::string program =
      write("sum.awl",
            "Network 1\nLD SM0.0\nMOVW IW2, VW10\n+I +5, VW10\nMOVR 1.5, VD20\n+R 0.1, VD20\nLDW>= IW2, 100\n= Q0.0\n");
  // VW10 = IW2 + 5; VD20 = 1.5 + 0.1 in single precision, which 1.6 in a cell means as well.
  const std::string table = write("t.csv",
                                  "test,set IW2,expect VW10,expect VD20,expect Q0.0\n"
                                  "w,95,100,1.6,0\nw,100,100..110,x,1\nw,-5,-5..0,,0\n");
  EXPECT_EQ(run({program, "--table", table}), 0) << out_;
  const std::string wrong = write("w.csv", "test,set IW2,expect VW10\nw,95,101..110\n");
  const nlohmann::json failed = json({program, "--table", wrong}, 1);
  EXPECT_EQ(failed["tests"][0]["expected"], "101..110");
  EXPECT_EQ(failed["tests"][0]["actual"], "100");
}

TEST_F(TestCommand, TestsOtherFamilies) {
  const std::string step7 = write("fb.awl",
                                  "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n      A(;\n      O I 0.0;\n      O Q 4.0;\n"
                                  "      );\n      AN I 0.1;\n      = Q 4.0;\nEND_ORGANIZATION_BLOCK\n");
  const std::string table7 = write("7.csv", "test,set I0.0,set I0.1,expect Q4.0\na,1,0,1\na,0,,1\na,,1,0\n");
  EXPECT_EQ(run({step7, "--dialect", "s7-300", "--table", table7}), 0) << out_ << err_;
  const std::string iec =
      write("p.st",
            "PROGRAM P\nVAR_INPUT Start, Stop : BOOL; Level : INT; END_VAR\nVAR_OUTPUT Motor : BOOL; "
            "END_VAR\nMotor := (Start OR Motor) AND NOT Stop AND Level > 10;\nEND_PROGRAM\n");
  const std::string tableI =
      write("i.csv", "test,set Start,set Stop,set Level,expect Motor\na,1,0,11,1\na,0,,,1\na,,,10,0\n");
  EXPECT_EQ(run({iec, "--table", tableI}), 0) << out_ << err_;
}

TEST_F(TestCommand, ShowsTheScansAround) {
  const std::string program = write("motor.awl", motorProgram);
  const std::string table = write("t.csv", "test,wait,set I0.0,expect Q0.1\nt,5 scans,1,1\n");
  EXPECT_EQ(run({program, "--table", table, "--show", "ladder"}), 1);
  for (const char* part : {"FAILED", "step 1 (line 2): Q0.1 expected 1, actual 0", "> 5", "T37", "1 test, 1 failed"})
    EXPECT_NE(out_.find(part), std::string::npos) << part << "\n" << out_;
}

TEST_F(TestCommand, WritesJunitAndHtml) {
  const std::string program = write("motor.awl", motorProgram);
  const std::string table = write("t.csv", "test,set I0.0,expect Q0.0\ngood,1,1\nbad,1,0\n");
  EXPECT_EQ(run({program, "--table", table, "--format", "junit=" + path("j.xml"), "--format", "html=" + path("p.html"),
                 "--coverage"}),
            1);
  const std::string junit = content("j.xml");
  // The program is no test: two in all.
  EXPECT_NE(junit.find("<testsuites name=\"rungproof\" tests=\"2\" failures=\"1\""), std::string::npos) << junit;
  EXPECT_NE(junit.find("Q0.0 expected 0, actual 1"), std::string::npos);
  const std::string page = content("p.html");
  for (const char* part : {"<td class=\"bad\">", "Not covered: contacts", "<svg", "decided by"})
    EXPECT_NE(page.find(part), std::string::npos) << part;
}

TEST_F(TestCommand, NamesMistakesWithTheirPlace) {
  const std::string program = write("motor.awl", motorProgram);
  struct Mistake {
    const char* table;
    const char* message;
  };
  const Mistake mistakes[] = {
      {"test,set Q0.0\nt,1\n", "Q0.0 is an output"},
      {"test,set I0.0,expect Nowhere\nt,1,1\n", "'Nowhere' is no address"},
      {"test,wait,set I0.0\nt,soon,1\n", "column 'wait': 'soon' is no wait"},
      {"test,wait,set I0.0\nt,0 scans,1\n", "'0 scans' is no wait"},
      {"test,set I0.0,expect Q0.0\nt,1,2\n", "column 'expect Q0.0': Q0.0 is a bit"},
      {"test,set I0.0,expect MB1\nt,1,9..3\n", "column 'expect MB1': the range 9..3 is empty"},
      {"step,set I0.0\nt,1\n", "has no column 'test'"},
      {"test,I0.0\nt,1\n", "'I0.0' is no column of a test table"},
      {"test,set I0.0,set i0.0\nt,1,1\n", "stands here twice"},
      {"test,set I0.0,set IB0\nt,1,0\n", "columns 'set I0.0' and 'set IB0' name the same place"},
      {"test,set VW0,set VB1\nt,1,0\n", "columns 'set VW0' and 'set VB1' name the same place"},
      {"test,set I0.0\n,1\n", "the first step has no test"},
      {"test,set I0.0\n", "the test table has no step"}};
  for (const Mistake& mistake : mistakes) {
    EXPECT_EQ(run({program, "--table", write("t.csv", mistake.table)}), 2) << mistake.table;
    EXPECT_NE(err_.find(mistake.message), std::string::npos) << mistake.message << "\n" << err_;
    EXPECT_NE(err_.find("t.csv"), std::string::npos) << err_;
  }
  run({program, "--table", write("t.csv", "test,wait,set I0.0\nt,soon,1\n")});
  EXPECT_NE(err_.find("t.csv:2:3"), std::string::npos) << err_;  // second line, third character
}

TEST_F(TestCommand, IsNeverCleanWithoutAComparison) {
  const std::string program = write("motor.awl", motorProgram);
  EXPECT_EQ(run({program, "--table", write("t.csv", "test,set I0.0,expect Q0.0\nt,1,x\n")}), 3);
  EXPECT_EQ(run({program}), 2);
  EXPECT_EQ(run({program, "--table", path("none.csv")}), 2);
  // What lint refuses is not run: T300 does not exist.
  const std::string refused = write("r.awl", "Network 1\nLD I0.0\nTON T300, 3\nLD I0.0\n= Q0.0\n");
  EXPECT_EQ(run({refused, "--table", write("u.csv", "test,set I0.0,expect Q0.0\nt,1,1\n")}), 2);
}

TEST_F(TestCommand, ReadsOtherEncodingsAndSeparators) {
  const std::string program = write("motor.awl", motorProgram);
  EXPECT_EQ(run({program, "--table",
                 write("t.csv",
                       "\xEF\xBB\xBFsep=;\r\ntest;step;set I0.0;expect Q0.0\r\nt;gedr\xFC"
                       "ckt;1;1\r\n")}),
            0)
      << err_ << out_;
  EXPECT_EQ(run({program, "--table", write("u.csv", "test\tset I0.0\texpect Q0.0\nt\ton\tTRUE\n")}), 0) << err_ << out_;
}

// Scans 1 to 3 with the start pressed, 4 and 5 released, 6 stopped: three stretches, as the motor runs from scan 1
// to 5.
TEST_F(TestCommand, RecordsATraceAsATable) {
  const std::string program = write("motor.awl", motorProgram);
  const std::string trace = write("run.csv",
                                  "scan,I0.0,I0.1,Q0.0,Q0.1\n1,1,0,1,0\n2,1,0,1,0\n3,1,0,1,0\n4,0,0,1,0\n5,0,0,1,0\n"
                                  "6,0,1,0,0\n");
  EXPECT_EQ(run({program, "--record", trace, "-o", path("t.csv")}), 0) << err_;
  EXPECT_EQ(content("t.csv"),
            "test,step,wait,set I0.0,set I0.1,expect Q0.0,expect Q0.1,note\n"
            "recorded,power on,3 scans,1,0,1,0,\nrecorded,change inputs,2 scans,0,0,1,0,\n"
            "recorded,change inputs,1 scan,0,1,0,0,\n");
  EXPECT_EQ(run({program, "--table", path("t.csv")}), 0) << out_;
  EXPECT_EQ(run({program, "--record", write("in.csv", "scan,I0.0\n1,1\n")}), 2);
}

TEST_F(TestCommand, TwoNamesOfOnePlaceAreRefused) {
  const std::string program = write("motor.awl", motorProgram);
  EXPECT_EQ(run({program, "--symbols", write("s.csv", "Start,I0.0,\n"), "--table",
                 write("t.csv", "test,set Start,set I0.0\nt,1,0\n")}),
            2);
  EXPECT_NE(err_.find("columns 'set Start' and 'set I0.0' name the same place"), std::string::npos) << err_;
}

// 200 ms after the start the lamp is dark, 400 ms after it lit: T37 takes 300 ms.
TEST_F(TestCommand, ReadsDecimalCommasOfWaits) {
  const std::string program = write("motor.awl", motorProgram);
  const std::string rows = "test;wait;set I0.0;expect Q0.1\nt;0,2s;1;0\nt;0,2 s;;1\n";
  EXPECT_EQ(run({program, "--table", write("t.csv", rows)}), 0) << err_ << out_;
  EXPECT_EQ(run({program, "--table", write("u.csv", "test,wait,set I0.0\nt,\"0,2s\",1\n")}), 2);
}

TEST_F(TestCommand, HelpsWithWhatATableNeeds) {
  const std::string program = write("motor.awl", motorProgram);
  EXPECT_EQ(run({program, "--table", write("t.csv", "")}), 2);
  EXPECT_NE(err_.find("begin with a heading: 'test'"), std::string::npos) << err_;
  EXPECT_EQ(run({program, "--table", write("u.csv", "test,set I9.9\nt,1\n")}), 2);
  EXPECT_NE(err_.find("mend the address"), std::string::npos) << err_;  // no CPU has a bit 9
  EXPECT_EQ(run({program, "--table", write("v.csv", "test,set I99.0\nt,1\n")}), 2);
  EXPECT_NE(err_.find("choose the CPU with --cpu"), std::string::npos) << err_;
}

// 31 scans of 20 ms are enough for T37, and more than the table grants; its author has said so.
TEST_F(TestCommand, SaysOfAFailingStepThatItIsMarked) {
  const std::string program = write("motor.awl", motorProgram);
  const std::string table =
      write("t.csv", "test,wait,set I0.0,expect Q0.1,note\nt,20 scans,1,0,timing: with scans of 10 ms\n");
  EXPECT_EQ(run({program, "--table", table}), 0) << out_;
  EXPECT_EQ(run({program, "--table", table, "--scan-time", "20ms", "--format", "junit=" + path("j.xml")}), 1);
  EXPECT_NE(content("j.xml").find("the step is marked 'timing: with scans of 10 ms'"), std::string::npos);
  EXPECT_EQ(run({program, "--table", table, "--scan-time", "20ms"}), 1);
  EXPECT_NE(out_.find("the step is marked 'timing: with scans of 10 ms'"), std::string::npos) << out_;
  const nlohmann::json failed = json({program, "--table", table, "--scan-time", "20ms"}, 1);
  EXPECT_NE(failed["tests"][0]["reason"].get<std::string>().find("timing"), std::string::npos) << failed.dump(1);
}

// The task runs every 300 ms, and the lamp comes in its fourth run: 900 ms are three scans.
TEST_F(TestCommand, TakesTheIntervalOfTheTask) {
  const std::string program =
      write("task.st",
            "PROGRAM Counts\nVAR_INPUT Go : BOOL; END_VAR\nVAR_OUTPUT Lamp : BOOL; END_VAR\nVAR n : INT; END_VAR\n"
            "IF Go THEN n := n + 1; END_IF;\nLamp := n >= 4;\nEND_PROGRAM\nCONFIGURATION C\nRESOURCE R ON PLC\n"
            "TASK T(INTERVAL := T#300ms, PRIORITY := 1);\nPROGRAM C1 WITH T : Counts;\nEND_RESOURCE\n"
            "END_CONFIGURATION\n");
  const std::string table = write("t.csv", "test,wait,set C1.Go,expect C1.Lamp\nt,900ms,1,0\nt,1 scan,,1\n");
  EXPECT_EQ(run({program, "--table", table}), 0) << out_ << err_;
  EXPECT_EQ(run({program, "--table", table, "--scan-time", "10ms"}), 1) << out_;  // 90 scans
  const ProgramRun trace =
      test::run({"sim", program, "--scans", "2", "--signals", "C1.Lamp", "--trace", "-", "--isolated"});
  EXPECT_NE(trace.out.find("\n2,600,"), std::string::npos) << trace.out << trace.err;
}

}  // namespace
}  // namespace rungproof::test
