// What the reader of IEC 61131-3 says against texts that are wrong, and that it reads on behind them.
#include "tests/iec/iec_output.hpp"
#include "tests/iec/iec_run.hpp"

namespace rungproof {
namespace {

struct Wrong {
  const char* declarations;
  const char* statements;
  const char* message;
};

constexpr Wrong wrongTexts[] = {
    {"a : INT; b : REAL;", "a := b;", "REAL does not fit into INT"},
    {"a : INT;", "a = 3;", "':=' is needed here, not '='"},
    {"a : INT;", "c := 1;", "there is no variable c"},
    {"t : TON;", "t(IN := TRUE, PX := T#1s);", "block TON has no input PX"},
    {"a : INT;", "IF a THEN a := 1; END_IF;", "INT does not fit into BOOL"},
    {"a : INT;", "a := 100000;", "100000 does not fit into INT"},
    {"b : REAL; a : INT;", "FOR b := 1 TO 3 DO a := 1; END_FOR;", "FOR counts in a variable of whole numbers"},
    {"a : INT;", "a := foo(3);", "there is no function and no instance foo"},
    {"a : INT;", "a := T#5s;", "TIME does not fit into INT"},
    {"u : UNKNOWN;", "", "there is no type UNKNOWN"},
    {"a : ARRAY [3..1] OF INT;", "", "the bounds of the array are no constants in ascending order"},
    {"a : ARRAY [0..3] OF INT;", "a[4] := 1;", "index 4 is outside of 0..3"},
    {"a : ARRAY [0..3] OF INT;", "a[1, 2] := 1;", "the array has 1 dimension"},
    {"a : INT;", "a[1] := 1;", "INT is no array"},
    {"a : INT;", "a.x := 1;", "INT has no parts"},
    {"w : WORD;", "w.16 := TRUE;", "WORD has no bit 16"},
    {"a : INT;", "EXIT;", "EXIT and CONTINUE belong into a loop"},
    {"a : INT; b : BOOL;", "a := a + b;", "INT and BOOL do not go together"},
    {"a : BOOL;", "a := a + a;", "+ of BOOL"},
    {"t : TIME;", "t := 5;", "a duration is written T#5s"},
    {"t : TIME := T#5x;", "", "T#5x is no duration of whole milliseconds"},
    {"a : INT;", "CASE a OF b: a := 1; END_CASE;", "a label of CASE is a constant"},
    {"a : INT;", "a := (1 + ;", "a value is needed here, not ';'"},
    {"a : INT;", "IF TRUE THEN a := 1;", "'END_IF' is needed here"},
    {"a : INT;", "a := 1 END_IF;", "'END_IF' does not belong here"},
    {"a : INT", "a := 1;", "';' is needed here"},
    {"a : INT; a : BOOL;", "", "two variables are named a"},
    {"t : TON;", "t := 1;", "an instance cannot be assigned"},
    {"s : WSTRING; r : WSTRING;", "s := r;", "values of type WSTRING are not modelled"},
    {"a : INT;", "a := SEL(TRUE, 1);", "the arguments of SEL do not fit"},
    {"a : INT;", "(* open", "the comment has no end"},
    {"a : INT;", "a := 'open;", "the text has no closing mark"},
    {"a : UDINT; b : DINT;", "b := b + a;", "DINT and UDINT do not go together"},
    {"p AT %ZX0.0 : BOOL;", "", "%ZX0.0 is no address"},
};

TEST(IecReading, WrongTextsAreNamed) {
  for (const Wrong& wrong : wrongTexts) {
    const Program program =
        readIecText(iecProgram(std::string("VAR ") + wrong.declarations + " END_VAR", wrong.statements));
    EXPECT_NE(findingsIec(program).find(wrong.message), std::string::npos)
        << wrong.declarations << " / " << wrong.statements << "\n"
        << findingsIec(program);
    for (const Finding& finding : program.findings) EXPECT_EQ(finding.severity, Severity::Error);
  }
}

// Comments stand in comments (third edition). Where one would then have no end, the text was written for MatIEC, which
// ends a comment at the first mark: only one of the two readings leaves a program.
TEST(IecReading, CommentsInComments) {
  const std::string variables = "VAR a : INT; b : INT; END_VAR";
  IecRun nested(iecProgram(variables, "a := 1; (* off: (* old *) a := 2; *) b := 3;"));
  nested.scan();
  EXPECT_EQ(nested.get("a"), 1);
  EXPECT_EQ(nested.get("b"), 3);
  IecRun flat(iecProgram(variables, "a := 1; (* off: (* old *) a := 2; (* again (* twice *) b := 3; (* plain *)"));
  flat.scan();
  EXPECT_EQ(flat.get("a"), 2);
  EXPECT_EQ(flat.get("b"), 3);
}

// Beremiz writes the initial value of a STRING without quotes, CODESYS with them. 'LEN' counts what stands there.
TEST(IecReading, InitialTextsOfXml) {
  for (const auto& [value, length] : {std::pair{"blup", 4}, {"'blup'", 4}, {"it's", 4}, {"", 0}, {"a$b", 3}}) {
    const std::string xml =
        "<project xmlns=\"http://www.plcopen.org/xml/tc6_0201\"><types><dataTypes/><pous><pou name=\"main\" "
        "pouType=\"program\"><interface><localVars><variable name=\"s\"><type><string/></type><initialValue>"
        "<simpleValue value=\"" +
        std::string(value) +
        "\"/></initialValue></variable><variable "
        "name=\"n\"><type><INT/></type></variable></localVars></interface><body>"
        "<ST><xhtml:p xmlns:xhtml=\"http://www.w3.org/1999/xhtml\">n := LEN(s);</xhtml:p></ST></body></pou></pous>"
        "</types><instances><configurations/></instances></project>";
    const Program program = readText("test.xml", xml);
    EXPECT_EQ(findingsIec(program), "") << value;
    Simulator simulator(program, {});
    simulator.scan({10000});
    const std::optional<Operand> count = lookupIn(program)("n");
    ASSERT_TRUE(count.has_value()) << value;
    EXPECT_EQ(simulator.read(*count), length) << value;
  }
}

TEST(IecReading, AllErrorsAreToldInOneRun) {
  const Program program =
      readIecText(iecProgram("VAR a : INT; b : REAL; END_VAR", "a := b;\nc := 1;\na := 1;\nd := 2;"));
  ASSERT_EQ(program.findings.size(), 3U);
  EXPECT_EQ(program.sources->position(program.findings[0].span).line, 3U);
  EXPECT_EQ(program.sources->position(program.findings[1].span).line, 4U);
  EXPECT_EQ(program.sources->position(program.findings[2].span).line, 6U);
}

TEST(IecReading, NestingIsLimited) {  // and no stack is exhausted
  const std::string deep = std::string(100'000, '(') + "1" + std::string(100'000, ')');
  EXPECT_NE(
      findingsIec(readIecText(iecProgram("VAR a : INT; END_VAR", "a := " + deep + ";"))).find("nested too deeply"),
      std::string::npos);
  std::string loops;
  for (int i = 0; i < 100'000; ++i) loops += "IF TRUE THEN ";
  EXPECT_NE(findingsIec(readIecText(iecProgram("VAR a : INT; END_VAR", loops))).find("nested too deeply"),
            std::string::npos);
  std::string minus(100'000, '-');
  EXPECT_NE(
      findingsIec(readIecText(iecProgram("VAR a : INT; END_VAR", "a := " + minus + "1;"))).find("nested too deeply"),
      std::string::npos);
}

TEST(IecReading, DamagedTextsEndInMessages) {  // each prefix of a text, and each text without one character
  const std::string whole =
      iecProgram("VAR a : ARRAY [0..3] OF INT; t : TON; x : BOOL; END_VAR",
                 "IF x AND a[1] > 3 THEN t(IN := x, PT := T#5s); CASE a[0] OF 1, 2..3: a[0] := 5; END_CASE; END_IF;");
  for (std::size_t i = 0; i < whole.size(); ++i) {
    static_cast<void>(readIecText(whole.substr(0, i)));
    const Program program = readIecText(whole.substr(0, i) + whole.substr(i + 1));
    EXPECT_GT(program.sources->size(), 0U);
  }
}

TEST(IecReading, DamagedConfigurationsEndInMessages) {  // the same of tasks, paths from outside, edges, texts, __TRY
  const std::string whole =
      "FUNCTION_BLOCK f VAR_INPUT x : BOOL R_EDGE; y : BOOL F_EDGE; END_VAR VAR p : POINTER TO INT; END_VAR ; "
      "END_FUNCTION_BLOCK\nPROGRAM a VAR s : STRING[5] := 'a$N'; g : f; n : INT; l AT %QX* : BOOL; END_VAR\n"
      "__TRY n := 1 / n; __CATCH(e) s := INT_TO_STRING(n); __FINALLY g(x := l, y := l); __ENDTRY;\nEND_PROGRAM\n"
      "CONFIGURATION c VAR_GLOBAL k AT %IX0.0 : BOOL; END_VAR\nRESOURCE r ON q TASK t(SINGLE := k, PRIORITY := 1);\n"
      "PROGRAM i WITH t : a; END_RESOURCE\nVAR_ACCESS v : r.i.n : INT READ_WRITE; END_VAR\n"
      "VAR_CONFIG r.i.l AT %QX0.1 : BOOL := TRUE; END_VAR\nEND_CONFIGURATION\n";
  for (std::size_t i = 0; i < whole.size(); ++i) {
    static_cast<void>(readIecText(whole.substr(0, i)));
    const Program program = readIecText(whole.substr(0, i) + whole.substr(i + 1));
    EXPECT_GT(program.sources->size(), 0U);
  }
}

// What is not modelled is an error with its place; what depends on it is not covered.
TEST(IecReading, PlacesAndValuesOutOfVarConfigAreNotCovered) {
  const std::string text =
      "//@ prove first: n <> 5\nPROGRAM a VAR_OUTPUT n : INT; END_VAR n := n; END_PROGRAM\n"
      "CONFIGURATION c RESOURCE r ON q TASK t(INTERVAL := T#10ms, PRIORITY := 1); PROGRAM i WITH t : a; END_RESOURCE\n"
      "VAR_CONFIG r.i.n : INT := 5; END_VAR\nEND_CONFIGURATION\n";
  const IecOutput output = runIec({"prove"}, text);
  EXPECT_TRUE(output.has("NOT COVERED  first") && output.has("'VAR_CONFIG' is not read in a configuration"))
      << output.text;
}

TEST(IecReading, KeywordsAndNamesInAnyCase) {
  IecRun run("program Main var Counter : int; end_var COUNTER := counter + 1; end_program\n");
  run.scan();
  EXPECT_EQ(run.get("counter"), 1);
}

TEST(IecReading, PlcopenWithStatements) {
  const std::string body = "<![CDATA[IF x AND n < 3 THEN n := n + 1; END_IF;\nq := n >= 3;]]>";
  const auto project = [](const std::string& text) {
    return R"(<?xml version="1.0" encoding="utf-8"?>
<project xmlns="http://www.plcopen.org/xml/tc6_0201" xmlns:xhtml="http://www.w3.org/1999/xhtml"><types><dataTypes/><pous>
<pou name="light" pouType="program"><interface><inputVars><variable name="x"><type><BOOL/></type></variable></inputVars>
<localVars><variable name="n"><type><INT/></type></variable><variable name="q" address="%QX0.0"><type><BOOL/></type></variable></localVars></interface>
<body><ST><xhtml:p>)" +
           text + "</xhtml:p></ST></body></pou></pous></types></project>";
  };
  const IecOutput output =
      runIec({"sim", "--scans", "4", "--trace", "-", "--signals", "n,q"}, project(body), "light.xml");
  EXPECT_EQ(output.exit, 0) << output.text;
  // Entities keep the places of what follows them: the error is told in the line in which it stands.
  const IecOutput wrong = runIec({"lint"}, project("IF x &amp; (n &lt; 3) THEN\nn := y; END_IF;"), "light.xml");
  EXPECT_TRUE(wrong.has("there is no variable y") && wrong.has("light.xml:6:6")) << wrong.text;
}

/// A ladder program with these elements; its variables are BOOL, `inputs` free.
std::string ladder(const std::string& inputs, const std::string& outputs, const std::string& elements) {
  std::string text =
      R"(<project xmlns="http://www.plcopen.org/xml/tc6_0201"><types><dataTypes/><pous><pou name="p" pouType="program"><interface>)";
  const auto list = [&](const char* section, const std::string& names) {
    text += std::string("<") + section + ">";
    std::istringstream in(names);
    for (std::string name; in >> name;) text += "<variable name=\"" + name + "\"><type><BOOL/></type></variable>";
    text += std::string("</") + section + ">";
  };
  list("inputVars", inputs);
  list("outputVars", outputs);
  return text +
         "</interface><body><LD><leftPowerRail localId=\"1\"><connectionPointOut "
         "formalParameter=\"\"/></leftPowerRail>" +
         elements + "</LD></body></pou></pous></types></project>";
}
std::string contact(int id, int from, const std::string& name, const std::string& more = "") {
  return fmt::format(
      "<contact localId=\"{}\" {}><position x=\"{}\" y=\"{}\"/><connectionPointIn><connection "
      "refLocalId=\"{}\"/></connectionPointIn>"
      "<connectionPointOut/><variable>{}</variable></contact>",
      id, more, id * 10, id, from, name);
}
std::string coil(int id, int from, const std::string& name, const std::string& more = "") {
  return fmt::format(
      "<coil localId=\"{}\" {}><position x=\"{}\" y=\"{}\"/><connectionPointIn><connection "
      "refLocalId=\"{}\"/></connectionPointIn>"
      "<connectionPointOut/><variable>{}</variable></coil>",
      id, more, id * 10, id, from, name);
}

IecOutput proofOfLadder(const std::string& xml, const std::string& properties,
                        const std::vector<std::string>& options = {}) {
  const test::TemporaryFolder folder;
  folder.file("p.xml", xml);
  folder.file("p.prop", properties);
  std::istringstream in;
  std::ostringstream out, err;
  std::vector<std::string> arguments{"prove", folder.path("p.xml"), "--props", folder.path("p.prop"), "--dialect",
                                     "iec",   "--isolated"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const int exit = runProgram(arguments, {in, out, err});
  return {exit, out.str() + err.str()};
}

TEST(IecDrawing, ContactsAndCoils) {
  const std::string xml = ladder("a b", "q s",
                                 contact(2, 1, "a") + contact(3, 2, "b", "negated=\"true\"") + coil(4, 3, "q") +
                                     coil(5, 2, "s", "storage=\"set\""));
  const IecOutput output = proofOfLadder(xml, "prove q: q = (a and not b)\nprove s: s = once(a)\n");
  EXPECT_TRUE(output.has("PROVED  q") && output.has("PROVED  s")) << output.text;
}

// A comparison whose EN is a contact. While EN is FALSE its output gives what it gave last, or FALSE by the other
// reading, which is taken on request; the standard forbids to use it.
TEST(IecDrawing, ComparisonWithEnableKeepsItsResult) {
  const auto pin = [](const char* name, int from) {
    return fmt::format(
        "<variable formalParameter=\"{}\"><connectionPointIn><connection refLocalId=\"{}\"/>"
        "</connectionPointIn></variable>",
        name, from);
  };
  const auto value = [](int id, const char* name) {
    return fmt::format(
        "<inVariable localId=\"{}\"><position x=\"1\" y=\"{}\"/><connectionPointOut/><expression>{}"
        "</expression></inVariable>",
        id, id, name);
  };
  const std::string block =
      "<block localId=\"3\" typeName=\"EQ\"><position x=\"30\" y=\"3\"/><inputVariables>" + pin("EN", 2) +
      pin("IN1", 6) + pin("IN2", 7) +
      "</inputVariables><inOutVariables/><outputVariables><variable "
      "formalParameter=\"ENO\"><connectionPointOut/></variable>"
      "<variable formalParameter=\"OUT\"><connectionPointOut/></variable></outputVariables></block>";
  const std::string out =
      "<coil localId=\"8\"><position x=\"80\" y=\"3\"/><connectionPointIn><connection refLocalId=\"3\" "
      "formalParameter=\"OUT\"/></connectionPointIn><connectionPointOut/><variable>q</variable></coil>";
  const std::string xml = ladder("e a b", "q", contact(2, 1, "e") + value(6, "a") + value(7, "b") + block + out);
  const std::string asked =
      "prove on: e implies q = (a = b)\nprove kept: not e implies q = prev(q)\nprove off: not e implies not q\n";
  const IecOutput output = proofOfLadder(xml, asked);
  EXPECT_TRUE(output.has("PROVED  on") && output.has("PROVED  kept") && output.has("VIOLATED  off")) << output.text;
  EXPECT_TRUE(output.has("iec-en-false-result = kept")) << output.text;
}

TEST(IecDrawing, EdgesFireInTheFirstScan) {
  const std::string xml = ladder("a", "q f",
                                 contact(2, 1, "a", "edge=\"rising\"") + coil(3, 2, "q") + contact(4, 1, "a") +
                                     coil(5, 4, "f", "edge=\"rising\""));
  const IecOutput output =
      proofOfLadder(xml, "prove contact: q = (a and (first_scan or not prev(a)))\nprove coil: f = q\n");
  EXPECT_TRUE(output.has("PROVED  contact") && output.has("PROVED  coil")) << output.text;
}

TEST(IecDrawing, AFlowIsComputedOnce) {  // the second coil takes the flow of before the first one's write
  const std::string xml =
      ladder("a", "x s", contact(2, 1, "x", "negated=\"true\"") + coil(3, 2, "x") + coil(4, 3, "s"));
  EXPECT_TRUE(proofOfLadder(xml, "prove same: s = x\n", {"--choice", "iec-ld-flow=once"}).has("PROVED  same"));
}

// A contact of q behind the coil that writes q: it sees what was written, or the value of before the network.
TEST(IecDrawing, FeedbackWithinANetworkIsAReading) {
  const std::string xml =
      ladder("a b", "q m", contact(2, 1, "a") + coil(3, 2, "q") + contact(4, 2, "q") + coil(5, 4, "m"));
  const IecOutput output = proofOfLadder(xml,
                                         "prove follows: m implies a\nprove at once: m = q\nprove later: m = q or q "
                                         "and not prev(q) or q and first_scan\n");
  EXPECT_TRUE(output.has("PROVED  follows") && output.has("PROVED  later")) << output.text;
  EXPECT_TRUE(output.has("VIOLATED  at once") && output.has("iec-network-feedback")) << output.text;
}

TEST(IecDrawing, BlocksTheirInstancesAndFunctions) {
  const std::string block =
      R"(<inVariable localId="7"><position x="1" y="40"/><connectionPointOut/><expression>2</expression></inVariable>
<block localId="5" typeName="CTD" instanceName="c"><position x="60" y="10"/><inputVariables><variable formalParameter="CD"><connectionPointIn>
<connection refLocalId="2"/></connectionPointIn></variable><variable formalParameter="PV"><connectionPointIn><connection refLocalId="7"/>
</connectionPointIn></variable><variable formalParameter="LD"><connectionPointIn><connection refLocalId="3"/></connectionPointIn></variable>
</inputVariables><inOutVariables/><outputVariables><variable formalParameter="Q"><connectionPointOut/></variable></outputVariables></block>)";
  const std::string coilOfBlock =
      R"(<coil localId="6"><position x="90" y="10"/><connectionPointIn><connection refLocalId="5" formalParameter="Q"/></connectionPointIn>
<connectionPointOut/><variable>q</variable></coil>)";
  const IecOutput output =
      proofOfLadder(ladder("a l", "q", contact(2, 1, "a") + contact(3, 1, "l") + block + coilOfBlock),
                    "prove loaded: l implies not q\nprove empty at the start: first_scan and not l implies q\nreach "
                    "again: once(l) and q\n");
  EXPECT_TRUE(output.has("PROVED  loaded") && output.has("PROVED  empty at the start") &&
              output.has("REACHABLE  again"))
      << output.text;
}

TEST(IecTasks, IntervalsAndPriorities) {  // slow runs in every second scan, and before fast by its priority
  const auto text = [](const std::string& fast) {
    return "CONFIGURATION c VAR_GLOBAL g : INT; END_VAR RESOURCE r ON PLC TASK s(INTERVAL := T#20ms, PRIORITY := 0); "
           "TASK f(INTERVAL := T#10ms, PRIORITY := 1);\n"
           "PROGRAM fast WITH f : fastOne" +
           fast +
           "; PROGRAM slow WITH s : slowOne; END_RESOURCE END_CONFIGURATION\n"
           "PROGRAM fastOne VAR_EXTERNAL g : INT; END_VAR VAR_INPUT k : INT; END_VAR VAR n, seen : INT; END_VAR n := n "
           "+ 1; seen := g; END_PROGRAM\n"
           "PROGRAM slowOne VAR_EXTERNAL g : INT; END_VAR VAR n : INT; END_VAR n := n + 1; g := n; END_PROGRAM\n";
  };
  IecRun run(text(""));
  std::vector<double> slow, fast, seen;
  for (int scan = 0; scan < 4; ++scan) {
    run.scan();
    slow.push_back(run.get("slow.n"));
    fast.push_back(run.get("fast.n"));
    seen.push_back(run.get("seen"));
  }
  EXPECT_EQ(slow, (Row{1, 1, 2, 2}));
  EXPECT_EQ(fast, (Row{1, 2, 3, 4}));
  EXPECT_EQ(seen, (Row{1, 1, 2, 2}));
  // The other order is a reading that proofs cover; PHASE is the scan in which slow runs first.
  const IecOutput output = proofOfIec(text("") +
                                      "//@ prove fresh: first_scan and slow.PHASE = 1 implies seen = 1\n"
                                      "//@ prove inputs: k = 3\n");
  EXPECT_TRUE(output.has("VIOLATED  fresh") && output.has("iec-task-order") && output.has("VIOLATED  inputs"))
      << output.text;
  EXPECT_TRUE(output.has("every scan lasts 10 ms")) << output.text;
  // A connected input is what it is connected with.
  EXPECT_TRUE(proofOfIec(text("(k := 3)") + "//@ prove inputs: k = 3\n").has("PROVED  inputs"));
}

TEST(IecTasks, DurationsAsNumbers) {  // milliseconds or seconds
  const std::string text =
      iecProgram("VAR t : TIME := T#2500ms; n : DINT; r : REAL; u : TIME; END_VAR",
                 "n := TIME_TO_DINT(t); r := TIME_TO_REAL(t); u := DINT_TO_TIME(n);\n//@ prove ms: n = 2500\n//@ prove "
                 "s: n = 2 or n = 2500\n//@ prove real: r = 2.5 or r = 2500.0\n//@ prove back: u = 2500 or u = 2000\n");
  const IecOutput output = proofOfIec(text);
  EXPECT_TRUE(output.has("VIOLATED  ms") && output.has("PROVED  s") && output.has("PROVED  real") &&
              output.has("PROVED  back"))
      << output.text;
  EXPECT_TRUE(proofOfIec(text, {"--choice", "iec-time-number=milliseconds"}).has("PROVED  ms"));
}

TEST(IecBuiltin, ErrorsAtRunTimeAreAsked) {
  const IecOutput output =
      proofOfIec(iecProgram("VAR_INPUT x, i : INT; END_VAR VAR y, n : INT; a : ARRAY [0..3] OF INT; END_VAR",
                            "y := 10 / x;\ny := 10 / 3;\na[i] := 1;\na[n] := 2;\nn := (n + 1) MOD 4;"),
                 {"--builtin"});
  EXPECT_TRUE(output.has("VIOLATED  y := 10 / x: never 'division by zero'")) << output.text;
  EXPECT_TRUE(output.has("VIOLATED  a[i] := 1: never 'index outside its array'")) << output.text;
  EXPECT_TRUE(output.has("PROVED  a[n] := 2: never 'index outside its array'")) << output.text;
  EXPECT_FALSE(output.has("10 / 3")) << output.text;
}

// Only the whole words are keywords.
TEST(IecReading, NamesMayBeginLikeKeywords) {
  const std::string declarations =
      "VAR_INPUT var1, var_in : BOOL; END_VAR VAR end_pos, var_out, VARIABLE, End_If_2, vary : BOOL; END_VAR";
  for (const std::string first : {"var_out := var_in;", "vary := var1;", "VARIABLE := var1;", "end_pos := FALSE;"})
    EXPECT_EQ(findingsIec(readIecText(iecProgram(declarations, first))), "") << first;
  EXPECT_EQ(verdictOf(iecProgram(declarations,
                                 "IF var_in THEN\nend_pos := TRUE;\nEnd_If_2 := var1;\nELSE\nend_pos := FALSE;\n"
                                 "END_IF;\nvar_out := end_pos;"),
                      "var_out = var_in"),
            "PROVED");
  // In a list, where they are labels too.
  EXPECT_EQ(findingsIec(readIecText(iecProgram(declarations,
                                               "LD var_in\nJMPC var_end\nLD var1\nST end_pos\n"
                                               "var_end:\nLD var1\nST var_out"))),
            "");
}

}  // namespace
}  // namespace rungproof
