// The property language: binding, types, statements, mistakes.
#include <gtest/gtest.h>

#include "frontend/property/property_reader.hpp"

namespace rungproof {
namespace {

/// A lookup for the few spellings that these tests use.
std::optional<Operand> lookUp(std::string_view name) {
  if (name == "start") return direct(Area::I, Width::Bit, 0, 0);
  const auto number = [](std::string_view text) { return static_cast<std::uint32_t>(std::stoul(std::string(text))); };
  if (name == "I15.7") return direct(Area::I, Width::Bit, 15, 7);
  if (name.size() == 4 && (name[0] == 'I' || name[0] == 'Q' || name[0] == 'M') && name[2] == '.') {
    return direct(name[0] == 'I'   ? Area::I
                  : name[0] == 'Q' ? Area::Q
                                   : Area::M,
                  Width::Bit, number(name.substr(1, 1)), number(name.substr(3)));
  }
  if (name == "L0.0") return direct(Area::L, Width::Bit, 0, 0);
  if (name.substr(0, 2) == "VB") return direct(Area::V, Width::Byte, number(name.substr(2)));
  if (name.substr(0, 2) == "VW") return direct(Area::V, Width::Word, number(name.substr(2)));
  if (name.substr(0, 2) == "VD") return direct(Area::V, Width::DWord, number(name.substr(2)));
  if (name[0] == 'T' && name.size() > 1) return direct(Area::T, Width::Bit, number(name.substr(1)));
  return std::nullopt;
}

struct Reading {
  PropertySet set;
  std::vector<Finding> findings;
  explicit Reading(std::string_view text) { readPropertyText(0, text, 0, lookUp, set, findings); }
};

/// The tree in prefix form.
std::string shape(const Expr& e, std::uint32_t i) {
  static const char* const names[] = {"c",   "a",     "not",   "and",  "or",   "xor",   "implies", "=",
                                      "<>",  "<",     "<=",    ">",    ">=",   "+",     "-",       "*",
                                      "neg", "rises", "falls", "prev", "once", "since", "held",    "first"};
  const ExprNode& n = e.nodes[i];
  if (n.op == ExprOp::Address)
    return toString(n.operand) + (n.type != ExprType::Truth && n.operand.area == Area::T ? ".value" : "");
  if (n.op == ExprOp::Constant) return std::to_string(n.value);
  std::string text = std::string("(") + names[static_cast<int>(n.op)];
  for (const std::uint32_t arg : n.args) text += " " + shape(e, arg);
  return text + ")";
}
std::string shapeOf(std::string_view expression) {
  Reading reading("prove p: " + std::string(expression));
  if (!reading.findings.empty()) return reading.findings[0].message;
  const Expr& e = reading.set.properties[0].first;
  return shape(e, static_cast<std::uint32_t>(e.nodes.size() - 1));
}

// The order of binding: unary minus; *; + -; comparisons; not; and; xor; or; implies.
TEST(PropertyLanguage, BindsInTheOrderThatHelpSays) {
  EXPECT_EQ(shapeOf("not I0.0 and I0.1"), "(and (not I0.0) I0.1)");
  EXPECT_EQ(shapeOf("I0.0 or I0.1 and I0.2"), "(or I0.0 (and I0.1 I0.2))");
  EXPECT_EQ(shapeOf("I0.0 xor I0.1 or I0.2"), "(or (xor I0.0 I0.1) I0.2)");
  EXPECT_EQ(shapeOf("I0.0 xor I0.1 and I0.2"), "(xor I0.0 (and I0.1 I0.2))");
  EXPECT_EQ(shapeOf("I0.0 implies I0.1 implies I0.2"), "(implies I0.0 (implies I0.1 I0.2))");
  EXPECT_EQ(shapeOf("not VW0 = 3"), "(not (= VW0 3))");
  EXPECT_EQ(shapeOf("VW0 + 2 * VW2 < -VW4"), "(< (+ VW0 (* 2 VW2)) (neg VW4))");
  EXPECT_EQ(shapeOf("Q0.2 = not (I0.0 or I0.1) and I0.2"), "(and (= Q0.2 (not (or I0.0 I0.1))) I0.2)");
  EXPECT_EQ(shapeOf("(I0.0 or I0.1) and I0.2"), "(and (or I0.0 I0.1) I0.2)");
  EXPECT_EQ(shapeOf("since(I0.0, rises(I0.1)) and held(start, 2s)"), "(and (since I0.0 (rises I0.1)) (held I0.0))");
}

TEST(PropertyLanguage, TimersAreBitsOrValues) {
  EXPECT_EQ(shapeOf("T37 and not T38"), "(and T37 (not T38))");
  EXPECT_EQ(shapeOf("T37.value >= 50"), "(>= T37.value 50)");
  EXPECT_EQ(shapeOf("T37 >= 50"), "(>= T37.value 50)");
  EXPECT_EQ(shapeOf("T37 = 1"), "(= T37 1)") << "T37 is the bit";
  EXPECT_EQ(shapeOf("T37 <> true"), "(<> T37 1)");
  EXPECT_EQ(shapeOf("T37 >= 1"), "(>= T37.value 1)");
}

TEST(PropertyLanguage, ConstantsFitWhatStandsBesideThem) {
  Reading reading(
      "prove a: prev(VW0) = 16#FFFF\nprove b: VW0 > 40000\nprove c: VB0 = 256 or VB0 = 255\n"
      "prove d: VD0 = 16#80000000\nprove e: prev(VD0) > 1.5\nprove f: VD0 - VD4 < 0.5\nprove g: VD0 = 99999999999\n");
  ASSERT_EQ(reading.findings.size(), 1U) << "no number of the S7-200 has 37 bits";
  EXPECT_EQ(reading.findings[0].rule, "PRP001");
  const std::vector<Property>& p = reading.set.properties;
  EXPECT_EQ(p[0].first.nodes[2].value, -1) << "the bit pattern of a word a scan ago";
  ASSERT_EQ(p[1].remarks.size(), 1U) << "words are signed: 40000 is beyond 32767";
  EXPECT_NE(p[1].remarks[0].find("VW0 is never 40000"), std::string::npos) << p[1].remarks[0];
  EXPECT_EQ(p[2].remarks.size(), 1U) << "bytes go to 255";
  EXPECT_TRUE(p[3].remarks.empty());
  EXPECT_EQ(p[3].first.nodes[1].value, -2147483648LL);
  EXPECT_EQ(p[4].first.nodes[1].type, ExprType::Real);
  EXPECT_EQ(p[4].first.nodes[0].type, ExprType::Real);
  EXPECT_EQ(p[5].first.nodes[2].type, ExprType::Real) << "a difference of double words beside a REAL";
}

TEST(PropertyTypes, APatternBesideASumIsANumberAndThatIsSaid) {
  Reading reading("prove a: VW0 + 0 = 16#8000\nprove b: VW0 + 0 = 16#7FFF\nprove c: VW0 = 16#8000\n");
  ASSERT_EQ(reading.set.properties.size(), 3U);
  ASSERT_EQ(reading.set.properties[0].remarks.size(), 1U);
  EXPECT_EQ(reading.set.properties[0].remarks[0], "beside a sum or product a pattern is a number: 16#8000 is 32768");
  EXPECT_TRUE(reading.set.properties[1].remarks.empty());
  EXPECT_TRUE(reading.set.properties[2].remarks.empty());
}

TEST(PropertyLanguage, AddressesMustExistOnTheCpu) {
  PropertySet set;
  std::vector<Finding> findings;
  const Target target;  // CPU 226: VB0-VB10239, I0.0-I15.7, T0-T255
  readPropertyText(0,
                   "prove a: T300\nprove b: VW10239 = 0\nprove c: VB10239 = 0\nprove d: T255\nprove e: Q0.8\n"
                   "external VB10200..VB10300\nreach f: I15.7\n",
                   0, lookUp, set, findings, &target);
  ASSERT_EQ(findings.size(), 4U);
  for (const Finding& finding : findings) EXPECT_EQ(finding.rule, "PRP002") << finding.message;
  EXPECT_EQ(findings[0].message, "the CPU 226 has no T300: the last one is T255");
  EXPECT_EQ(findings[1].message, "the CPU 226 has no VW10239: the last one is VW10238");
  EXPECT_EQ(findings[2].message, "Q0.8 has bit number 8; a byte has bits 0 to 7");
  ASSERT_EQ(set.properties.size(), 3U);
}

/// Statement lists of an S7-300 have "Q 4.0": who writes it so in a property is told how it is written there.
TEST(PropertyLanguage, ABlankInAnAddressIsNamed) {
  PropertySet set;
  std::vector<Finding> findings;
  readPropertyText(0, "prove a: Q 0.1\nprove b: not M 1.0\nprove c: motor 10\n", 0, lookUp, set, findings, nullptr);
  ASSERT_EQ(findings.size(), 3U);
  EXPECT_EQ(findings[0].help, "write Q0.1, without a blank");
  EXPECT_EQ(findings[1].help, "write M1.0, without a blank");
  EXPECT_EQ(findings[2].help, "give the symbol table with --symbols, or write the address");
}

TEST(PropertyLanguage, MistakesSayWhatIsMissing) {
  const auto messageOf = [](std::string_view expression) {
    Reading reading("prove p: " + std::string(expression));
    return reading.findings.empty() ? "" : std::string(reading.findings[0].message);
  };
  EXPECT_EQ(messageOf("VW0 / 2 > 5"), "'/' does not belong here");
  EXPECT_EQ(messageOf("Q0.0 or or Q0.1"), "'or' does not belong here");
  EXPECT_EQ(messageOf("always never Q0.0"), "'never' does not belong here");
  EXPECT_EQ(messageOf("Q0.0 implies L0.0"),
            "'L0.0' has no value between scans: local memory belongs to one call (001:1367)");
  EXPECT_EQ(messageOf("Q0.0 held 500MS implies Q0.1"), "") << "units in capitals";
}

TEST(PropertyLanguage, NumbersAreSignedForWordsAndUnsignedForBytes) {
  Reading reading("prove a: VB0 = 255\nprove b: VW0 = 16#FFFF\nprove c: VD0 > 1.5\n");
  ASSERT_TRUE(reading.findings.empty()) << reading.findings[0].message;
  const Expr& a = reading.set.properties[0].first;
  EXPECT_EQ(a.nodes[0].width, 9) << "a byte as a signed number needs nine bits";
  EXPECT_EQ(reading.set.properties[1].first.nodes[1].value, -1) << "16#FFFF beside a word is its bit pattern";
  EXPECT_EQ(reading.set.properties[2].first.nodes[0].type, ExprType::Real) << "VD0 beside a REAL constant is a REAL";
}

TEST(PropertyLanguage, ReadsEveryStatement) {
  Reading reading(R"(# a comment line
assume healthy: not (I0.0 and I0.1)
prove a: always Q0.0 implies I0.0
prove b: never Q0.0 and Q0.1        # trailing comment
prove c: I0.0 leads to Q0.0 within 3 scans
prove d: I0.0 leads to Q0.0 within 500ms
prove e: Q0.1 only after Q0.0
prove f: Q0.0 unless I0.1
prove g: I0.0 held 2s implies Q0.0
at every instruction prove h: never Q0.0 and Q0.1
reach r: Q0.2
external VB100..VB199
initial retentive
pulse I0.0 at most every 50ms
)");
  ASSERT_TRUE(reading.findings.empty()) << reading.findings[0].message;
  const auto& p = reading.set.properties;
  ASSERT_EQ(p.size(), 11U);
  const PropertyKind kinds[] = {PropertyKind::Assume,       PropertyKind::Always,      PropertyKind::Never,
                                PropertyKind::LeadsToScans, PropertyKind::LeadsToTime, PropertyKind::OnlyAfter,
                                PropertyKind::Unless,       PropertyKind::HeldImplies, PropertyKind::Never,
                                PropertyKind::Reach,        PropertyKind::Pulse};
  for (std::size_t i = 0; i < p.size(); ++i) EXPECT_EQ(p[i].kind, kinds[i]) << p[i].text;
  EXPECT_EQ(p[3].bound, 3);
  EXPECT_EQ(p[4].bound, 500);
  EXPECT_EQ(p[7].bound, 2000);
  EXPECT_TRUE(p[8].atEveryInstruction);
  EXPECT_EQ(p[2].first.text, "Q0.0 and Q0.1");
  ASSERT_EQ(reading.set.externals.size(), 1U);
  EXPECT_EQ(reading.set.externals[0].last.offset, 199U);
  EXPECT_TRUE(reading.set.initialRetentive);
}

TEST(PropertyLanguage, BitsAreStatedToBeResetDominant) {
  Reading reading("reset dominant Q0.0, M1.2\n");
  ASSERT_TRUE(reading.findings.empty()) << reading.findings[0].message;
  ASSERT_EQ(reading.set.resetDominant.size(), 2U);
  EXPECT_EQ(toString(reading.set.resetDominant[1]), "M1.2");
  for (const char* wrong : {"reset dominant VW10", "reset dominant I0.0", "reset dominant T37", "reset dominant",
                            "reset Q0.0", "reset dominant Q0.0 Q0.1"}) {
    Reading mistaken(wrong);
    EXPECT_EQ(mistaken.findings.size(), 1U) << wrong;
    EXPECT_TRUE(mistaken.set.unread.empty()) << "it says nothing of the world: " << wrong;
  }
}

TEST(PropertyLanguage, MistakesHaveAPlaceAndTheRestIsRead) {
  Reading reading(
      "prove a: Q0.0 and\nprove b: Zork implies Q0.0\nprove c: VW0 and Q0.0\nprove d: Q0.0\nprove d: "
      "Q0.1\nnonsense\nprove e: Q0.2");
  ASSERT_EQ(reading.findings.size(), 5U);
  const char* const rules[] = {"PRP001", "PRP002", "PRP003", "PRP004", "PRP001"};
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(reading.findings[i].rule, rules[i]) << reading.findings[i].message;
  EXPECT_EQ(reading.findings[1].span.offset, 27U) << "the place is the unknown name";
  EXPECT_EQ(reading.findings[1].span.length, 4U);
  ASSERT_EQ(reading.set.properties.size(), 2U);
  EXPECT_EQ(reading.set.properties[1].name, "e");
}

TEST(PropertyLanguage, DeepNestingIsAMistakeNotACrash) {
  const std::string deep = "prove p: " + std::string(100000, '(') + "Q0.0" + std::string(100000, ')');
  Reading reading(deep);
  ASSERT_EQ(reading.findings.size(), 1U);
  EXPECT_EQ(reading.findings[0].rule, "PRP001");
}

// Chains are no nesting: each link stands beside the one before it.
TEST(PropertyLanguage, ChainsHaveAnyLength) {
  for (const std::string word : {" implies ", " and ", " or ", " xor "}) {
    std::string text = "prove p: Q0.0";
    for (int i = 0; i < 100'000; ++i) text += word + "I0.0";
    const Reading reading(text);
    EXPECT_TRUE(reading.findings.empty()) << word;
    ASSERT_EQ(reading.set.properties.size(), 1U) << word;
    EXPECT_EQ(reading.set.properties[0].first.nodes.size(), 200'001U) << word;
  }
  Reading reading("prove p: I0.0 implies (I0.1 implies I0.2) implies Q0.0");
  ASSERT_EQ(reading.set.properties.size(), 1U);
  EXPECT_EQ(reading.set.properties[0].first.premise, "I0.0") << "of the outermost implication";
}

TEST(PropertyLanguage, TimesHaveALimit) {
  EXPECT_TRUE(Reading("prove p: held(I0.0, 1000000h)").findings.empty());
  for (const std::string text : {"prove p: held(I0.0, 10000000000000000s)", "prove p: held(I0.0, 1000001h)",
                                 "prove p: I0.0 leads to Q0.0 within 9999999999999999999999999s"}) {
    const Reading reading(text);
    ASSERT_EQ(reading.findings.size(), 1U) << text;
    EXPECT_EQ(reading.findings[0].rule, "PRP001");
    EXPECT_EQ(reading.findings[0].help, "times go up to 1000000h");
  }
}

}  // namespace
}  // namespace rungproof
