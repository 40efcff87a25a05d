// What counts as covered, by measure and family. Figures follow from the programs, as written beside them.
#include <map>
#include <set>

#include "test_command.hpp"

namespace rungproof::test {
namespace {

class Coverage : public TestCommand {
 protected:
  nlohmann::json of(const std::string& program, const std::string& table, std::vector<std::string> more = {}) {
    std::vector<std::string> arguments{program, "--table", table, "--coverage"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return json(arguments, 0)["coverage"];
  }
  static std::pair<int, int> figures(const nlohmann::json& measure) {
    return {measure["covered"].get<int>(), measure["total"].get<int>()};
  }
};
using Figures = std::pair<int, int>;

// Q0.0 = (I0.0 or Q0.0) and not I0.1. Only I0.0 is pressed: I0.0 and Q0.0 were 1 and 0, I0.1 was 0 only.
// Conditions: I0.0 decided as 0 (scan 1: I0.0 = Q0.0 = 0) and as 1 (I0.0 = 1, Q0.0 = 0): covered. Q0.0 decided as 1
// (I0.0 = 0, Q0.0 = 1) and as 0 (scan 1): covered. I0.1 was never 1.
TEST_F(Coverage, CountsContactsAndPairsOfALatch) {
  const std::string program = write("l.awl", "Network 1\nLD I0.0\nO Q0.0\nAN I0.1\n= Q0.0\n");
  const nlohmann::json c = of(program, write("t.csv", "test,set I0.0,expect Q0.0\nt,0,0\nt,1,1\nt,0,1\n"));
  EXPECT_EQ(figures(c["networks"]), Figures(1, 1));
  EXPECT_EQ(figures(c["contacts"]), Figures(2, 3));
  EXPECT_EQ(c["contacts"]["missing"], nlohmann::json({"MAIN:1 AN I0.1"}));
  EXPECT_EQ(figures(c["mcdc"]), Figures(2, 3));
  EXPECT_EQ(c["mcdc"]["missing"], nlohmann::json({"MAIN:1 = Q0.0: AN I0.1"}));
  EXPECT_EQ(c["mcdc"]["unique_cause"], 2);
}

// (I0.0 and I0.1) or (I0.2 and I0.3). 1100 -> 1 and 0101 -> 0 differ in I0.0, which decides both times, and in I0.3,
// which decides neither time as I0.2 is 0: a pair by masking, as nothing is the same but what does not decide.
TEST_F(Coverage, TellsMaskingFromUniqueCause) {
  const std::string program = write("m.awl", "Network 1\nLD I0.0\nA I0.1\nLD I0.2\nA I0.3\nOLD\n= Q0.0\n");
  const nlohmann::json c =
      of(program, write("t.csv", "test,set I0.0,set I0.1,set I0.2,set I0.3,expect Q0.0\nt,1,1,0,0,1\nt,0,1,0,1,0\n"));
  // In 0101 also I0.2 decides (I0.3 = 1), as 0 only; in 1100 I0.1 decides, as 1 only.
  EXPECT_EQ(figures(c["mcdc"]), Figures(1, 4));
  EXPECT_EQ(c["mcdc"]["masking"], 1);
  EXPECT_EQ(c["mcdc"]["unique_cause"], 0);
}

// No power flow reaches network 2, which has a coil; network 3 has none and does not count.
TEST_F(Coverage, CountsNetworksByPowerFlow) {
  const std::string program =
      write("n.awl", "Network 1\nLD I0.0\n= Q0.0\nNetwork 2\nLD I0.1\nS Q0.1, 1\nNetwork 3\nNOP 0\n");
  const nlohmann::json c = of(program, write("t.csv", "test,set I0.0,expect Q0.0\nt,1,1\n"));
  EXPECT_EQ(figures(c["networks"]), Figures(1, 2));
  EXPECT_EQ(c["networks"]["missing"], nlohmann::json({"MAIN:2"}));
}

// MCR( ends the string: I0.1 alone is the condition of Q0.0, and decides as 1 and as 0 while the relay is on.
TEST_F(Coverage, AMasterControlRelayBeginsANewString) {
  const std::string program = write("r.awl",
                                    "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nMCRA;\nA I 0.0;\nMCR(;\nA I 0.1;\n"
                                    "= Q 0.0;\n)MCR;\nMCRD;\nEND_ORGANIZATION_BLOCK\n");
  const nlohmann::json c =
      of(program, write("t.csv", "test,set I0.0,set I0.1,expect Q0.0\nt,1,1,1\nt,1,0,0\nt,0,1,0\n"));
  EXPECT_EQ(figures(c["mcdc"]), Figures(1, 1));
  EXPECT_EQ(figures(c["contacts"]), Figures(2, 2));
}

// EU lets the change of I0.0 through once: I0.0 decides as 1 in that scan, as 0 in any scan whose scan before had 0.
TEST_F(Coverage, LooksThroughEdges) {
  const std::string program = write("e.awl", "Network 1\nLD I0.0\nEU\nS Q0.0, 1\n");
  const std::string early = write("a.csv", "test,set I0.0,expect Q0.0\nt,1,0\nt,1,0\n");
  EXPECT_EQ(figures(of(program, early)["mcdc"]), Figures(0, 1));  // no edge in the first scan, none later
  const std::string edge = write("b.csv", "test,set I0.0,expect Q0.0\nt,0,0\nt,0,0\nt,1,1\n");
  EXPECT_EQ(figures(of(program, edge)["mcdc"]), Figures(1, 1));
}

TEST_F(Coverage, CountsCompareContactsByTheirResult) {
  const std::string program = write("c.awl", "Network 1\nLD I0.0\nAW>= IW2, 100\n= Q0.0\n");
  const nlohmann::json c =
      of(program, write("t.csv", "test,set I0.0,set IW2,expect Q0.0\nt,1,99,0\nt,1,100,1\nt,0,100,0\n"));
  EXPECT_EQ(figures(c["contacts"]), Figures(2, 2));
  EXPECT_EQ(figures(c["mcdc"]), Figures(2, 2));
}

TEST_F(Coverage, CountsTransitionsOfScrSteps) {
  const std::string program = write("s.awl",
                                    "Network 1\nLD SM0.1\nS S0.1, 1\nNetwork 2\nLSCR S0.1\nNetwork 3\nLD I0.0\nSCRT "
                                    "S0.2\nNetwork 4\nSCRE\nNetwork 5\nLSCR S0.2\nNetwork 6\nLD I0.1\nSCRT S0.1\n"
                                    "Network 7\nSCRE\nNetwork 8\nLD S0.2\n= Q0.0\n");
  const nlohmann::json c = of(program, write("t.csv", "test,wait,set I0.0,expect Q0.0\nt,2 scans,1,1\n"));
  // Taken: the set of S0.1 and S0.1 -> S0.2; not S0.2 -> S0.1.
  EXPECT_EQ(figures(c["transitions"]), Figures(2, 3));
  EXPECT_EQ(c["transitions"]["missing"], nlohmann::json({"MAIN:6 S0.2 -> S0.1"}));
}

TEST_F(Coverage, CountsMovesToStepWords) {
  const std::string program = write("w.awl",
                                    "Network 1\nLDW= VW0, 0\nA I0.0\nMOVW 10, VW0\nNetwork 2\nLDW= VW0, 10\nA I0.1\n"
                                    "MOVW 0, VW0\nNetwork 3\nLDW= VW0, 10\n= Q0.0\n");
  const nlohmann::json c = of(program, write("t.csv", "test,wait,set I0.0,expect Q0.0\nt,2 scans,1,1\n"));
  EXPECT_EQ(figures(c["transitions"]), Figures(1, 2));
  EXPECT_EQ(c["transitions"]["missing"], nlohmann::json({"MAIN:2 VW0 -> 0"}));
}

// (I0.0 or Q4.0) and not I0.1 in the RLO, with a nesting level: the same figures as the latch above.
TEST_F(Coverage, ReadsTheRlo) {
  const std::string program =
      write("r.awl",
            "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n      A(;\n      O I 0.0;\n      O Q 4.0;\n"
            "      );\n      AN I 0.1;\n      = Q 4.0;\nEND_ORGANIZATION_BLOCK\n");
  const nlohmann::json c =
      of(program, write("t.csv", "test,set I0.0,expect Q4.0\nt,0,0\nt,1,1\nt,0,1\n"), {"--dialect", "s7-300"});
  EXPECT_EQ(figures(c["contacts"]), Figures(2, 3));
  EXPECT_EQ(figures(c["mcdc"]), Figures(2, 3));
  EXPECT_EQ(figures(c["networks"]), Figures(1, 1));
}

// O joins AND groups: I0.0 and I0.1, or I0.2. With 110, 010, 100 the first two decide as 1 and 0; I0.2 as 0 only.
TEST_F(Coverage, ReadsAndGroups) {
  const std::string program =
      write("g.awl",
            "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n      A I 0.0;\n      A I 0.1;\n      O;\n"
            "      A I 0.2;\n      = Q 4.0;\nEND_ORGANIZATION_BLOCK\n");
  const nlohmann::json c =
      of(program, write("t.csv", "test,set I0.0,set I0.1,expect Q4.0\nt,1,1,1\nt,0,1,0\nt,1,0,0\n"),
         {"--dialect", "s7-300"});
  EXPECT_EQ(figures(c["mcdc"]), Figures(2, 3));
  EXPECT_EQ(c["mcdc"]["missing"], nlohmann::json({"OB1:1 = Q4.0: A I0.2"}));
}

TEST_F(Coverage, ReadsExpressionsAndBranches) {
  const std::string program =
      write("p.st",
            "PROGRAM P\nVAR_INPUT Start, Stop : BOOL; Level : INT; END_VAR\nVAR_OUTPUT Motor, "
            "Lamp : BOOL; END_VAR\nMotor := (Start OR Motor) AND NOT Stop;\nIF Level > 10 THEN\n"
            "  Lamp := TRUE;\nEND_IF;\nEND_PROGRAM\n");
  const nlohmann::json c = of(program, write("t.csv", "test,set Start,expect Motor\nt,0,0\nt,1,1\nt,0,1\n"));
  // Contacts: Start, Motor (covered), Stop, the comparison. Decisions: three conditions of Motor, one of IF.
  EXPECT_EQ(figures(c["contacts"]), Figures(2, 4));
  EXPECT_EQ(figures(c["mcdc"]), Figures(2, 4));
  EXPECT_EQ(figures(c["networks"]), Figures(1, 2));
}

// A decided as 1 with B = 0 and as 0 with B = 1; both times Q was 1. A pair needs both outcomes.
TEST_F(Coverage, AsksForBothOutcomesOfAPair) {
  const std::string program = write(
      "x.st", "PROGRAM P\nVAR_INPUT A, B : BOOL; END_VAR\nVAR_OUTPUT Q : BOOL; END_VAR\nQ := A XOR B;\nEND_PROGRAM\n");
  const nlohmann::json c = of(program, write("t.csv", "test,set A,set B,expect Q\nt,1,0,1\nt,0,1,1\n"));
  EXPECT_EQ(figures(c["contacts"]), Figures(2, 2));
  EXPECT_EQ(figures(c["mcdc"]), Figures(0, 2));
  EXPECT_EQ(c["mcdc"]["goals"][0]["reason"], "as 0 and as 1 it decided the outcome, which was never 0");
  const nlohmann::json more = of(program, write("u.csv", "test,set A,set B,expect Q\nt,1,0,1\nt,0,1,1\nt,1,1,0\n"));
  EXPECT_EQ(figures(more["mcdc"]), Figures(2, 2));
}

TEST_F(Coverage, CountsTransitionsOfCharts) {
  const std::string program = write("c.st",
                                    "PROGRAM C\nVAR_INPUT Go, Back : BOOL; END_VAR\nVAR_OUTPUT Run : BOOL; END_VAR\n"
                                    "INITIAL_STEP Idle: END_STEP\nSTEP Work: Run(N); END_STEP\n"
                                    "TRANSITION FROM Idle TO Work := Go; END_TRANSITION\n"
                                    "TRANSITION FROM Work TO Idle := Back; END_TRANSITION\nEND_PROGRAM\n");
  const nlohmann::json c = of(program, write("t.csv", "test,wait,set Go,expect Run\nt,3 scans,1,1\n"));
  EXPECT_EQ(figures(c["transitions"]), Figures(1, 2));
}

// Where power flow decides whether a statement runs, FALSE is stored like TRUE: what counts is that it ran. The guard
// closed keeps network 2 from running, the guard open runs it, the start runs network 1.
TEST_F(Coverage, ReachesAStatementBehindItsCondition) {
  const std::string variables = "PROGRAM P\nVAR_INPUT Start, Door : BOOL; END_VAR\nVAR_OUTPUT On : BOOL; END_VAR\n";
  for (const std::string body :
       {"IF Start THEN On := TRUE; END_IF;\nIF NOT Door THEN On := FALSE; END_IF;\n",
        "IF Start THEN On := TRUE; END_IF;\nIF Door THEN ; ELSE On := Start AND Door; END_IF;\n",
        "LD Start\nS On\nLDN Door\nR On\n"}) {
    const std::string program = write("p.st", variables + body + "END_PROGRAM\n");
    const std::string heading = "test,set Start,set Door,expect On\n";
    EXPECT_EQ(figures(of(program, write("a.csv", heading + "t,0,1,0\n"))["networks"]), Figures(0, 2)) << body;
    EXPECT_EQ(figures(of(program, write("b.csv", heading + "t,0,0,0\n"))["networks"]), Figures(1, 2)) << body;
    EXPECT_EQ(figures(of(program, write("c.csv", heading + "t,0,0,0\nt,1,1,1\n"))["networks"]), Figures(2, 2)) << body;
  }
}

// The step goes 0, 1, 2, 0. Where its word lies does not matter: in a data block that is named, or in one that is open.
TEST_F(Coverage, CountsMovesToStepWordsOfAnS7300) {
  const std::string data = "DATA_BLOCK DB 1\nSTRUCT\n  step : INT;\nEND_STRUCT\nBEGIN\nEND_DATA_BLOCK\n";
  const auto listWith = [&](const std::string& opens, const std::string& word) {
    std::string text = data + "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n  " + opens + "\n";
    const char* const next[] = {"1", "2", "0"};
    for (int step = 0; step < 3; ++step) {
      const std::string label = std::string(1, static_cast<char>('a' + step));
      text += "  L " + word + "; L " + std::to_string(step) + "; ==I; A I 0." + std::to_string(step) + "; JCN " +
              label + ";\n  L " + next[step] + "; T " + word + ";\n" + label + ": NOP 0;\n";
    }
    return text + "NETWORK\n  L " + word + "; L 1; ==I; = Q 4.0;\nEND_ORGANIZATION_BLOCK\n";
  };
  const std::string heading = "test,set I0.0,set I0.1,set I0.2,expect Q4.0\n";
  const std::string one = write("one.csv", heading + "t,1,0,0,1\n");
  const std::string all = write("all.csv", heading + "t,1,0,0,1\nt,0,1,0,0\nt,0,0,1,0\n");
  for (const std::string& program :
       {write("named.awl", listWith("NOP 0;", "DB1.DBW 0")), write("marker.awl", listWith("NOP 0;", "MW 10")),
        write("open.awl", listWith("OPN DB 1;", "DBW 0"))}) {
    EXPECT_EQ(figures(of(program, one, {"--dialect", "s7-300"})["transitions"]), Figures(1, 3)) << program;
    EXPECT_EQ(figures(of(program, all, {"--dialect", "s7-300"})["transitions"]), Figures(3, 3)) << program;
  }
}

// CASE compares a copy of its selector. The step is a variable of a function block, and lies in its instance.
TEST_F(Coverage, CountsTransitionsOfCaseInScl) {
  const auto block = [](const std::string& kind) {
    return "FUNCTION_BLOCK FB10\nVAR_INPUT a, b : BOOL; END_VAR\nVAR\n  step : " + kind +
           ";\nEND_VAR\nBEGIN\nCASE step OF\n0: IF a THEN step := 1; END_IF;\n1: IF b THEN step := 2; END_IF;\n"
           "2: step := 0;\nEND_CASE;\nEND_FUNCTION_BLOCK\nDATA_BLOCK DB10 FB10\nBEGIN\nEND_DATA_BLOCK\n"
           "ORGANIZATION_BLOCK OB1\nVAR_TEMP info : ARRAY[0..19] OF BYTE; END_VAR\nBEGIN\n"
           "FB10.DB10(a := I0.0, b := I0.1);\nQ0.0 := I0.0;\nEND_ORGANIZATION_BLOCK\n";
  };
  const std::string one = write("one.csv", "test,set I0.0,set I0.1,expect Q0.0\nt,1,0,1\n");
  const std::string all = write("all.csv", "test,wait,set I0.0,set I0.1,expect Q0.0\nt,3 scans,1,1,1\n");
  for (const char* kind : {"INT", "DINT"}) {
    const std::string program = write("c.scl", block(kind));
    EXPECT_EQ(figures(of(program, one)["transitions"]), Figures(1, 3)) << kind;
    EXPECT_EQ(figures(of(program, all)["transitions"]), Figures(3, 3)) << kind;
  }
  // What is computed is no step.
  std::string text = block("INT");
  text.replace(text.find("step := 2"), 9, "step := step + 1");
  EXPECT_EQ(figures(of(write("d.scl", text), all)["transitions"]), Figures(0, 0));
}

// The drawing has ten contacts. Its blocks run in the order of their numbers or of their places.
TEST_F(Coverage, CountsTheOrderOfADrawingThatIsInForce) {
  const std::string program = RUNGPROOF_SOURCE_DIR "/corpus/iec/boiler.xml";
  const std::string table = write("t.csv", "test,set Enable,expect Alarm\nt,1,x\n");
  for (const char* order : {"execution-id", "position"}) {
    const nlohmann::json c = json(
        {program, "--table", table, "--coverage", "--choice", std::string("iec-fbd-order=") + order}, 3)["coverage"];
    EXPECT_EQ(c["contacts"]["total"], 10) << order;
    EXPECT_EQ(c["mcdc"]["total"], 10) << order;
    EXPECT_EQ(c["networks"]["total"], 1) << order;
    for (const nlohmann::json& goal : c["contacts"]["goals"])
      EXPECT_NE(goal["reason"], "it was never executed") << order << goal.dump();
  }
}

// FN lets the fall of I0.0 through where its bit in the data block was 1: in scan 2 I0.0 = 1 decides that nothing
// comes, in scan 3 I0.0 = 0 decides that the output comes.
TEST_F(Coverage, ReadsTheMemoryOfAnEdgeInADataBlock) {
  for (const std::string edge : {"FN DB1.DBX 0.0;", "OPN DB 1; A I 0.0; FN DBX 0.0;"}) {
    const std::string program = write(
        "e.awl",
        "DATA_BLOCK DB 1\nSTRUCT\n  edge : BOOL;\nEND_STRUCT\nBEGIN\nEND_DATA_BLOCK\nORGANIZATION_BLOCK OB 1\n"
        "BEGIN\nNETWORK\n  " +
            std::string(edge.starts_with("FN") ? "A I 0.0; " : "") + edge + " = Q 4.0;\nEND_ORGANIZATION_BLOCK\n");
    const nlohmann::json c =
        of(program, write("t.csv", "test,set I0.0,expect Q4.0\nt,1,0\nt,1,0\nt,0,1\n"), {"--dialect", "s7-300"});
    EXPECT_EQ(figures(c["mcdc"]), Figures(1, 1)) << edge << c["mcdc"].dump(1);
  }
}

// Of inputs and outputs a trace alone tells which contacts were 1 and 0: each contact of an input saw the input, and
// one of an output that is read above its coil saw the value of the scan before.
TEST_F(Coverage, AgreesWithTheTrace) {
  const std::string program = write("a.awl",
                                    "Network 1\nLD I0.0\nA I0.1\nO I0.2\nAN I0.3\n= Q0.0\nNetwork 2\nLD I0.4\nAN I0.5\n"
                                    "LD I0.1\nO I0.6\nALD\n= Q0.1\nNetwork 3\nLDN I0.0\nA I0.7\n= Q0.2\n");
  // Inputs by name, in the order of the contacts.
  const std::vector<int> contacts{0, 1, 2, 3, 4, 5, 1, 6, 0, 7};
  for (unsigned seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    unsigned state = seed * 2654435761U;
    std::string stimulus = "scan,I0.0,I0.1,I0.2,I0.3,I0.4,I0.5,I0.6,I0.7\n";
    std::vector<std::set<int>> seen(8);
    for (int scan = 1; scan <= 6; ++scan) {
      stimulus += std::to_string(scan);
      for (int input = 0; input < 8; ++input) {
        state = state * 1664525U + 1013904223U;
        const int value = static_cast<int>(state >> 30 & 1);
        stimulus += "," + std::to_string(value);
        seen[static_cast<std::size_t>(input)].insert(value);
      }
      stimulus += "\n";
    }
    int covered = 0;
    for (const int input : contacts) covered += seen[static_cast<std::size_t>(input)].size() == 2 ? 1 : 0;
    const nlohmann::json c = json({program, "--stimulus", write("s.csv", stimulus), "--coverage"}, 0)["coverage"];
    EXPECT_EQ(figures(c["contacts"]), Figures(covered, 10));
  }
}

}  // namespace
}  // namespace rungproof::test
