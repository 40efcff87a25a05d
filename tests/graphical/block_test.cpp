// Function blocks, standard functions and instruction lists as instructions, and what they do in a few scans.
#include <gtest/gtest.h>

#include "engine/simulator.hpp"
#include "tests/graphical/plcopen_text.hpp"
#include "tests/reader/read.hpp"

namespace rungproof {
namespace {

Program fbd(const std::vector<std::string>& variables, const std::string& body) {
  return readText("t.xml", plcopen(variables, "FBD", body));
}

/// Value of a variable after one scan of a function box with two operands.
std::int64_t result(const std::string& type, const std::string& function, const std::vector<std::string>& inputs,
                    const std::string& resultType = "") {
  std::string body;
  std::vector<TestPin> pins;
  int id = 10;
  std::vector<std::string> variables = {"y:" + (resultType.empty() ? type : resultType)};
  for (const std::string& value : inputs) {
    // Half of the operands through variables, so that constants and places are both met.
    const bool isLiteral = pins.size() % 2 == 1;
    const std::string name = fmt::format("v{}", id);
    if (!isLiteral) variables.push_back(fmt::format("{}:{}={}", name, type, value));
    body += inElement(id, isLiteral ? value : name);
    pins.push_back({fmt::format("IN{}", pins.size() + 1), {fmt::format("{}", id++)}});
  }
  body += blockElement(1, function, "", pins, {"OUT"}) + outElement(2, {"1.OUT"}, "y");
  const Program program = fbd(variables, body);
  EXPECT_EQ(findings(program), "") << function;
  Simulator simulator(program);
  simulator.scan();
  const Symbol* y = program.symbolNamed("y");
  if (y == nullptr) return -999999;
  const std::uint64_t value = simulator.read(y->address);
  const int width = bits(y->address.width);
  const bool isSigned = y->address.width != Width::Bit &&
                        (resultType.empty() ? type : resultType).find('U') == std::string::npos && type != "BYTE" &&
                        type != "WORD";
  return isSigned && (value >> (width - 1) & 1) != 0 ? static_cast<std::int64_t>(value) - (1LL << width)
                                                     : static_cast<std::int64_t>(value);
}

TEST(DrawnFunctions, Arithmetic) {
  EXPECT_EQ(result("INT", "ADD", {"30", "12"}), 42);
  EXPECT_EQ(result("INT", "SUB", {"30", "42"}), -12);
  EXPECT_EQ(result("INT", "MUL", {"-6", "7"}), -42);
  EXPECT_EQ(result("INT", "DIV", {"43", "4"}), 10);
  EXPECT_EQ(result("INT", "MOD", {"43", "4"}), 3);
  EXPECT_EQ(result("DINT", "MOD", {"100003", "1000"}), 3);
  EXPECT_EQ(result("DINT", "ADD", {"70000", "1", "2"}), 70003);
  EXPECT_EQ(result("USINT", "ADD", {"200", "100"}), 44);  // modulo 256
  EXPECT_EQ(result("SINT", "SUB", {"-100", "20"}), -120);
  EXPECT_EQ(result("UINT", "ADD", {"65000", "600"}), 64);  // modulo 65536
}

// Two's complement: what does not fit loses its high bits. An S7-200 keeps the old value on overflow (001:4814).
TEST(DrawnFunctions, ResultsWrap) {
  EXPECT_EQ(result("INT", "ADD", {"32767", "1"}), -32768);
  EXPECT_EQ(result("INT", "ADD", {"-32768", "-1", "-1"}), 32766);
  EXPECT_EQ(result("INT", "ADD", {"30000", "30000", "30000"}), 24464);  // 90000 - 65536
  EXPECT_EQ(result("INT", "SUB", {"-32768", "1"}), 32767);
  EXPECT_EQ(result("INT", "SUB", {"0", "-32768"}), -32768);
  EXPECT_EQ(result("INT", "MUL", {"300", "300"}), 24464);        // 90000 - 65536
  EXPECT_EQ(result("INT", "MUL", {"300", "300", "2"}), -16608);  // 2 * 24464 - 65536
  EXPECT_EQ(result("UINT", "MUL", {"65535", "65535"}), 1);       // (-1) * (-1)
  EXPECT_EQ(result("UINT", "MUL", {"400", "200"}), 14464);       // 80000 - 65536
  EXPECT_EQ(result("USINT", "MUL", {"255", "255"}), 1);
  EXPECT_EQ(result("SINT", "MUL", {"-128", "-128"}), 0);  // 16384 is 64 * 256
  EXPECT_EQ(result("INT", "DIV", {"-32768", "-1"}), -32768);
  EXPECT_EQ(result("INT", "ABS", {"-32768"}), -32768);
  EXPECT_EQ(result("INT", "NEG", {"-32768"}), -32768);
  EXPECT_EQ(result("DINT", "ADD", {"2147483647", "1"}), -2147483648LL);
  EXPECT_EQ(result("DINT", "SUB", {"-2147483648", "1"}), 2147483647);
  EXPECT_EQ(result("DINT", "SUB", {"0", "-2147483648"}), -2147483648LL);
  EXPECT_EQ(result("DINT", "NEG", {"-2147483648"}), -2147483648LL);
  EXPECT_EQ(result("INT", "MOD", {"-7", "3"}), -1);  // the sign of the dividend
  EXPECT_EQ(result("INT", "MOD", {"7", "0"}), 0);
  EXPECT_EQ(result("DINT", "MOD", {"70000", "0"}), 0);
}

TEST(DrawnFunctions, ShiftsByMoreThanTheWidthLeaveNothing) {
  for (const int places : {3, 15, 16, 255, 256, 259, 32767}) {
    const Program program =
        fbd({"w:WORD=1", fmt::format("n:INT={}", places), "y:WORD"},
            inElement(1, "w") + inElement(2, "n") + blockElement(3, "SHL", "", {{"IN", {"1"}}, {"N", {"2"}}}, {"OUT"}) +
                outElement(4, {"3.OUT"}, "y"));
    EXPECT_EQ(findings(program), "");
    Simulator simulator(program);
    simulator.scan();
    EXPECT_EQ(simulator.read(program.symbolNamed("y")->address), places < 16 ? 1U << places : 0U) << places;
  }
}

// Pairs with every sign of the low words, against the product of 64 bits cut to 32.
TEST(DrawnFunctions, ProductsOfDoubleIntegersWrap) {
  const std::vector<std::int64_t> numbers = {0,      1,     -1,    7,       -40000,     40000,       65535,
                                             -65536, 98304, 32768, -100003, 2147483647, -2147483648, 1234567891};
  for (const std::int64_t a : numbers) {
    for (const std::int64_t b : numbers) {
      const auto wrapped = static_cast<std::int32_t>(static_cast<std::uint32_t>(a * b));
      EXPECT_EQ(result("DINT", "MUL", {fmt::format("{}", a), fmt::format("{}", b)}), wrapped) << a << " * " << b;
    }
  }
  EXPECT_EQ(result("DINT", "MUL", {"70000", "3", "2"}), 420000);
}

/// CV and Q at the ends of scans whose inputs are bits of I0.0 on, in the order of the pins.
std::string counted(const std::string& type, const std::vector<std::string>& pins, const std::string& preset,
                    const std::vector<int>& inputs, const std::string& output) {
  std::vector<std::string> variables = {"y:BOOL@%QX0.0", "v:INT", "c:" + type};
  std::vector<TestPin> given;
  std::string body;
  for (std::size_t i = 0; i < pins.size(); ++i) {
    variables.push_back(fmt::format("i{}:BOOL@%IX0.{}", i, i));
    body += inElement(static_cast<int>(i) + 10, fmt::format("i{}", i));
    given.push_back({pins[i], {fmt::format("{}", i + 10)}});
  }
  body += inElement(2, preset);
  given.push_back({"PV", {"2"}});
  body += blockElement(1, type, "c", given, {output, "CV"}) + outElement(3, {"1." + output}, "y") +
          outElement(4, {"1.CV"}, "v");
  const Program program = fbd(variables, body);
  EXPECT_EQ(findings(program), "");
  Simulator simulator(program);
  std::string text;
  for (const int input : inputs) {
    simulator.write(direct(Area::I, Width::Byte, 0), static_cast<std::uint64_t>(input));
    simulator.scan();
    text += fmt::format("{}{} ", simulator.read(program.symbolNamed("v")->address),
                        simulator.read(direct(Area::Q, Width::Bit, 0, 0)) != 0 ? "+" : "");
  }
  return text;
}

// "+": the output is on. Edges count in the first scan, are used up while the counter is reset, and cancel each other;
// Q compares in every scan, also with 0 and negative presets and while R or LD is on.
TEST(DrawnBlocks, CountersAreThoseOfTheStandard) {
  EXPECT_EQ(counted("CTU", {"CU", "R"}, "2", {1, 0, 1, 0, 1}, "Q"), "1 1 2+ 2+ 3+ ");
  EXPECT_EQ(counted("CTU", {"CU", "R"}, "2", {0, 3, 1, 0, 1}, "Q"), "0 0 0 0 1 ");
  EXPECT_EQ(counted("CTU", {"CU", "R"}, "0", {0, 2, 1}, "Q"), "0+ 0+ 1+ ");
  EXPECT_EQ(counted("CTD", {"CD", "LD"}, "2", {0, 2, 0, 1, 0, 1}, "Q"), "0+ 2 2 1 1 0+ ");
  EXPECT_EQ(counted("CTD", {"CD", "LD"}, "0", {2, 0, 1}, "Q"), "0+ 0+ 0+ ");
  EXPECT_EQ(counted("CTUD", {"CU", "CD", "R", "LD"}, "3", {0, 3, 0, 1}, "QU"), "0 0 0 1 ");
  EXPECT_EQ(counted("CTUD", {"CU", "CD", "R", "LD"}, "3", {1, 8, 12, 2, 0}, "QU"), "1 3+ 0 0 0 ");
  EXPECT_EQ(counted("CTUD", {"CU", "CD", "R", "LD"}, "3", {1, 2, 0, 8}, "QD"), "1 0+ 0+ 3 ");
}

TEST(DrawnFunctions, SelectionAndComparison) {
  EXPECT_EQ(result("INT", "MAX", {"3", "9", "5"}), 9);
  EXPECT_EQ(result("INT", "MIN", {"3", "-9", "5"}), -9);
  EXPECT_EQ(result("INT", "LIMIT", {"0", "150", "100"}), 100);
  EXPECT_EQ(result("INT", "LIMIT", {"0", "-5", "100"}), 0);
  EXPECT_EQ(result("INT", "MUX", {"2", "10", "11", "12"}), 12);
  EXPECT_EQ(result("INT", "GT", {"5", "4"}, "BOOL"), 1);
  EXPECT_EQ(result("INT", "LE", {"-5", "4"}, "BOOL"), 1);
  EXPECT_EQ(result("UINT", "GT", {"65000", "4"}, "BOOL"), 1);  // not as a negative number
  EXPECT_EQ(result("UDINT", "LT", {"5", "4000000000"}, "BOOL"), 1);
  EXPECT_EQ(result("SINT", "LT", {"-1", "1"}, "BOOL"), 1);
}

TEST(DrawnFunctions, BitsAndConversions) {
  EXPECT_EQ(result("WORD", "AND", {"16#FF0F", "16#0FFF"}), 0x0F0F);
  EXPECT_EQ(result("BYTE", "NOT", {"16#0F"}), 0xF0);
  EXPECT_EQ(result("WORD", "SHL", {"1", "4"}), 16);
  EXPECT_EQ(result("BYTE", "ROR", {"1", "1"}), 128);
  EXPECT_EQ(result("INT", "INT_TO_DINT", {"-7"}, "DINT"), -7);
  EXPECT_EQ(result("DINT", "DINT_TO_INT", {"65537"}, "INT"), 1);
  EXPECT_EQ(result("INT", "INT_TO_BOOL", {"-7"}, "BOOL"), 1);
  EXPECT_EQ(result("INT", "ABS", {"-7"}), 7);
  EXPECT_EQ(result("REAL", "REAL_TO_INT", {"2.6"}, "INT"), 3);
  EXPECT_EQ(result("REAL", "TRUNC", {"2.6"}, "DINT"), 2);
}

TEST(DrawnBlocks, TimerOutputsAndElapsedTime) {
  const std::string body = inElement(1, "a") + inElement(2, "T#300ms") +
                           blockElement(3, "TON", "t", {{"IN", {"1"}}, {"PT", {"2"}}}, {"Q", "ET"}) +
                           outElement(4, {"3.Q"}, "y") + outElement(5, {"3.ET"}, "e");
  const Program program = fbd({"a:BOOL@%IX0.0", "y:BOOL@%QX0.0", "t:TON", "e:TIME"}, body);
  EXPECT_EQ(findings(program), "");
  SimulatorOptions options;
  options.scanUs = 100'000;
  Simulator simulator(program, options);
  simulator.scan();
  simulator.write(direct(Area::I, Width::Bit, 0, 0), 1);
  // Scans of 100 ms: the first with the input enables the timer, each later one counts the scan before it.
  for (const auto& [time, on] :
       std::vector<std::pair<std::uint64_t, std::uint64_t>>{{0, 0}, {100, 0}, {200, 0}, {300, 1}, {300, 1}}) {
    simulator.scan();
    EXPECT_EQ(simulator.read(program.symbolNamed("e")->address), time);
    EXPECT_EQ(simulator.read(direct(Area::Q, Width::Bit, 0, 0)), on);
  }
}

TEST(DrawnBlocks, PresetsThatNoTimerCanCountAreFindings) {
  const auto rule = [](const std::string& preset) {
    const Program program =
        fbd({"a:BOOL@%IX0.0", "y:BOOL@%QX0.0", "t:TON", "v:TIME=T#1s"},
            inElement(1, "a") + inElement(2, preset) +
                blockElement(3, "TON", "t", {{"IN", {"1"}}, {"PT", {"2"}}}, {"Q"}) + outElement(4, {"3.Q"}, "y"));
    return program.findings.empty() ? "none" : std::string(program.findings[0].rule);
  };
  EXPECT_EQ(rule("T#50m"), "none");
  // No timer of an S7-200 counts so long, and a variable may change to what steps of 100 ms do not hit.
  EXPECT_EQ(rule("T#2h"), "GRF002");
  EXPECT_EQ(rule("v"), "GRF002");
}

TEST(DrawnBlocks, EnableJumpsOverTheBlock) {
  const std::string body = inElement(1, "en") + inElement(2, "a") +
                           blockElement(3, "SR", "s", {{"EN", {"1"}}, {"S1", {"2"}}, {"R", {}}}, {"Q1"}) +
                           outElement(4, {"3.Q1"}, "y");
  const Program program = fbd({"en:BOOL@%IX0.1", "a:BOOL@%IX0.0", "y:BOOL@%QX0.0", "s:SR"}, body);
  EXPECT_EQ(findings(program), "");
  Simulator simulator(program);
  simulator.write(direct(Area::I, Width::Byte, 0), 1);  // set, not enabled
  simulator.scan();
  EXPECT_EQ(simulator.read(direct(Area::Q, Width::Bit, 0, 0)), 0U);
  simulator.write(direct(Area::I, Width::Byte, 0), 3);
  simulator.scan();
  EXPECT_EQ(simulator.read(direct(Area::Q, Width::Bit, 0, 0)), 1U);
}

std::string list(const std::string& lines) {
  const std::string body = pouText(
      "Main", "program",
      "<localVars>" +
          declarations({"a:BOOL@%IX0.0", "b:BOOL@%IX0.1", "y:BOOL@%QX0.0", "z:BOOL@%QX0.1", "n:INT@%MW2", "t:TON"}) +
          "</localVars>",
      "IL", "<xhtml:p><![CDATA[" + lines + "]]></xhtml:p>");
  const Program program = readText("t.xml", projectText(body));
  return program.findings.empty() ? show(program.pous[0]) : findings(program);
}

TEST(InstructionList, LogicParenthesesAndStores) {
  EXPECT_EQ(list("LD a\nAND b\nST y\n"), "LD I0.0; A I0.1; = Q0.0");
  EXPECT_EQ(list("LD a\nANDN b\nSTN y\n"), "LD I0.0; AN I0.1; NOT; = Q0.0");
  EXPECT_EQ(list("LD a\nAND( b\nOR z\n)\nS y\n"), "LD I0.0; LD I0.1; O Q0.1; ALD; S Q0.0,1");
  EXPECT_EQ(list("LD n\nGT 5\nST y\n"), "LDW> MW2,5; = Q0.0");
  // As a double word, of which the low word goes back: 32767 + 1 is -32768. Each box begins a rung.
  EXPECT_EQ(list("LD n (* one more *)\nADD 1\nST n\n"),
            "LD SM0.0; ITD MW2,VD0; LD SM0.0; +D 1,VD0; LD SM0.0; MOVW VW2,MW2");
}

TEST(InstructionList, CallsJumpsAndMistakes) {
  EXPECT_EQ(list("CAL t(IN := a, PT := T#2s)\nLD t.Q\nST y\n"), "LD I0.0; TON T37,20 | LD T37; = Q0.0");
  EXPECT_EQ(list("LD a\nJMPC over\nLD b\nST y\nover:\nLD b\nST z\n"),
            "LD I0.0; JMP 0 | LD I0.1; = Q0.0 | LBL 0 | LD I0.1; = Q0.1");
  EXPECT_EQ(list("LD a\nFROB b\nST y\n"), "SYN036<FROB b>");
}

}  // namespace
}  // namespace rungproof
