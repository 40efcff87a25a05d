// What runs differently on an S7-200 SMART: a deeper logic stack, compare contacts that do not stop the CPU, analog
// inputs that are read anew each time, pulse outputs whose mode bit is the other way round, nothing retentive, deeper
// calls below interrupt routines. Each program is asked on a CPU ST40 and on a CPU 226.
#include <gtest/gtest.h>

#include "analysis/unread/unread_code.hpp"
#include "ir/s7200/cpu.hpp"
#include "tests/environment/asked.hpp"

namespace rungproof::test {
namespace {

constexpr Target st40{s7200Cpu("ST40"), Edition::Smart28};

struct OnBoth {
  const char* name;
  Asked asked;
  Outcome smart;
  Outcome s7200;
};

std::string tenLevels() {
  std::string text;
  for (const char* input : {"I0.0", "I0.1", "I0.2", "I0.3", "I0.4", "I0.5", "I0.6", "I0.7", "I1.0", "I1.1"})
    text += std::string("LD ") + input + ";";
  for (int i = 0; i < 9; ++i) text += "ALD;";
  return text + "= Q0.0";
}

/// A train of four pulses; the routine of its end sets M0.0.
Asked train(const char* control) {
  return {
      .program = std::string("LD SM0.1;MOVB ") + control + ",SMB67;MOVW 500,SMW68;MOVD 4,SMD72;ATCH INT_0,19;ENI;PLS 0",
      .property = "reach M0.0",
      .otherBlocks = "INTERRUPT_BLOCK INT_0:INT0;BEGIN;Network 1;LD SM0.0;S M0.0,1;END_INTERRUPT_BLOCK"};
}

const OnBoth programs[] = {
    // The tenth load pushes I0.0 out of nine levels; ALD then finds an unknown value instead.
    {"ten_levels",
     {.program = tenLevels(), .property = "reach Q0.0 and not I0.0"},
     Outcome::Unreachable,
     Outcome::Reachable},
    // Two reads in one network: the filter of a 226 samples once a scan, a SMART reads a new value each time.
    {"analog_twice",
     {.program = "LDW= AIW16,5;AW<> AIW16,5;= Q0.0", .property = "reach Q0.0"},
     Outcome::Reachable,
     Outcome::Unreachable},
    // SM0.7 is the mode switch of a 226; on a SMART it tells for one scan that the clock was lost.
    {"sm0_7",
     {.program = "LD SM0.7;= Q0.0", .property = "reach Q0.0 and not first_scan"},
     Outcome::Unreachable,
     Outcome::Reachable},
    // The same control byte starts a train on one family and a pulse width on the other.
    {"train_16#85", train("16#85"), Outcome::Unreachable, Outcome::Reachable},
    {"train_16#C5", train("16#C5"), Outcome::Reachable, Outcome::Unreachable},
    {"retentive",
     {.program = "LD V0.0;= Q0.0;LD I0.0;S V0.0,1",
      .property = "reach first_scan and Q0.0",
      .declarations = "initial retentive"},
     Outcome::Unreachable,
     Outcome::Reachable},
    // SMB31 asks a 226 to save a value, and the system takes the bit back; on a SMART nothing does.
    {"save_bit",
     {.program = "LD I0.0;S SM31.7,1;LD SM31.7;S M0.0,1;LDN SM31.7;A M0.0;= Q0.0", .property = "reach Q0.0"},
     Outcome::Unreachable,
     Outcome::Reachable},
};

class SmartMachine : public testing::TestWithParam<OnBoth> {};

TEST_P(SmartMachine, DiffersFromTheS7200) {
  Asked a = GetParam().asked;
  EXPECT_EQ(verdict(a), GetParam().s7200) << "CPU 226";
  a.target = st40;
  EXPECT_EQ(verdict(a), GetParam().smart) << "CPU ST40";
}

INSTANTIATE_TEST_SUITE_P(Programs, SmartMachine, testing::ValuesIn(programs), [](const auto& info) {
  std::string name = info.param.name;
  std::replace(name.begin(), name.end(), '#', '_');
  return name;
});

// A contact that cannot compare is 0, "not equal" too, SM4.3 shows the error, and the program goes on.
TEST(SmartCompare, IsZeroAndGoesOn) {
  for (const char* contact : {"MOVD 99999,AC2;LDW= *AC2,0", "MOVD 99999,AC2;LDW<> *AC2,0",
                              "MOVD 16#7FC00000,VD0;LDR= VD0,1.0", "MOVD 16#7FC00000,VD0;LDR<> VD0,1.0"}) {
    const std::string program = std::string("LD SM0.0;") + contact + ";= M0.0;LD I0.1;= Q0.0";
    for (const char* property : {"never M0.0", "Q0.0 = I0.1", "SM4.3"})
      EXPECT_EQ(verdict({.program = program, .property = property, .target = st40}), Outcome::Proved)
          << contact << ": " << property;
  }
}

TEST(SmartCompare, JoinsAsAContactThatIsOpen) {
  const std::string bad = "LD SM0.0;MOVD 16#7FC00000,VD0;";
  EXPECT_EQ(verdict({.program = bad + "LD I0.0;OR= VD0,1.0;= Q0.0", .property = "Q0.0 = I0.0", .target = st40}),
            Outcome::Proved);
  EXPECT_EQ(verdict({.program = bad + "LD I0.0;AR<> VD0,1.0;= Q0.0", .property = "never Q0.0", .target = st40}),
            Outcome::Proved);
}

// Four levels of calls below an interrupt routine; a 226 has one.
TEST(SmartNesting, FourLevelsBelowAnInterruptRoutine) {
  std::string blocks = "INTERRUPT_BLOCK INT_0:INT0;BEGIN;Network 1;LD SM0.0;CALL SBR0;END_INTERRUPT_BLOCK";
  for (int i = 0; i < 5; ++i) {
    const std::string number = std::to_string(i), next = std::to_string(i + 1);
    blocks += ";SUBROUTINE_BLOCK S" + number + ":SBR" + number + ";BEGIN;Network 1;LD SM0.0;S M0." + number + ",1" +
              (i < 4 ? ";CALL SBR" + next : "") + ";END_SUBROUTINE_BLOCK";
  }
  const auto reaches = [&](const char* bit) {
    return verdict({.program = "LD SM0.1;ATCH INT_0,0;ENI",
                    .property = std::string("reach ") + bit,
                    .otherBlocks = blocks,
                    .target = st40});
  };
  EXPECT_EQ(reaches("M0.3"), Outcome::Reachable) << "the fourth level";
  EXPECT_EQ(reaches("M0.4"), Outcome::Unreachable) << "the fifth";
}

struct Box {
  const char* statements;
  const char* property;
};

// Results worked out by hand.
const Box boxes[] = {
    {"MOVB 16#F0,VB0;NANDB 16#3C,VB0", "VB0 = 16#CF"},        // 3C and F0 = 30
    {"MOVB 16#F0,VB0;NORB 16#3C,VB0", "VB0 = 16#03"},         // 3C or F0 = FC
    {"MOVB 16#F0,VB0;NXORB 16#3C,VB0", "VB0 = 16#33"},        // 3C xor F0 = CC
    {"MOVW 16#FF00,VW0;NANDW 16#F0F0,VW0", "VW0 = 16#0FFF"},  // F0F0 and FF00 = F000
    {"MOVW 16#FF00,VW0;NORW 16#F0F0,VW0", "VW0 = 16#000F"},
    {"MOVW 16#FF00,VW0;NXORW 16#F0F0,VW0", "VW0 = 16#F00F"},  // F0F0 xor FF00 = 0FF0
    {"MOVD 16#FFFF0000,VD0;NANDD 16#FF00FF00,VD0", "VD0 = 16#00FFFFFF"},
    {"MOVD 16#FFFF0000,VD0;NORD 16#FF00FF00,VD0", "VD0 = 16#000000FF"},
    {"MOVD 16#FFFF0000,VD0;NXORD 16#FF00FF00,VD0", "VD0 = 16#FF0000FF"},
    {"MOVB 16#FF,VB0;NANDB 16#FF,VB0", "VB0 = 0 and SM1.0"},
    {"MOVW -5,VW0;ABSI VW0,VW2", "VW2 = 5 and VW0 = -5"},
    {"MOVW 7,VW0;ABSI VW0,VW2", "VW2 = 7"},
    {"MOVW -32768,VW0;ABSI VW0,VW2", "VW2 = -32768"},
    {"MOVD -70000,VD0;ABSDI VD0,VD4", "VD4 = 70000"},
    {"MOVR -1.5,VD0;ABSR VD0,VD4", "VD4 = 1.5"},
    {"MOVD 16#12345678,VD0;BCDDI VD0", "VD0 = 12345678"},
    {"MOVD 16#1234567A,VD0;BCDDI VD0", "VD0 = 16#1234567A and SM1.6"},
    {"MOVD 12345678,VD0;DIBCD VD0", "VD0 = 16#12345678"},
    {"MOVD 100000000,VD0;DIBCD VD0", "VD0 = 100000000 and SM1.1"},
    {"ARCTAN 0.0,VD0", "VD0 = 0.0"},
    {"ARCSIN 2.0,VD0", "VD0 = 0.0 and SM1.1"},  // no legal number: OUT keeps its value
};

TEST(SmartBoxes, ComputeWhatTheManualSays) {
  for (const Box& box : boxes)
    EXPECT_EQ(verdict({.program = std::string("LD SM0.0;") + box.statements, .property = box.property, .target = st40}),
              Outcome::Proved)
        << box.statements << ": " << box.property;
}

// The order in which the scaling boxes round is not known: nothing is proved of their result.
TEST(SmartBoxes, ScalingGivesAnyValue) {
  const Asked scaled{.program = "LD SM0.0;S_ITR AIW16,27648,0,100.0,0.0,VD0;LDR> VD0,50.0;= Q0.0",
                     .property = "reach Q0.0",
                     .target = st40};
  EXPECT_EQ(verdict(scaled), Outcome::Reachable);
}

/// Verdict with what is not modelled left out, as the commands do it.
Outcome covered(const std::string& networks, const std::string& property) {
  ProgramInput input;
  input.program = readText("test.awl",
                           "ORGANIZATION_BLOCK MAIN:OB1\n//@ prove p: " + property + "\nBEGIN\n" + linesOf(networks) +
                               "END_ORGANIZATION_BLOCK\n",
                           {.target = st40});
  input.properties = readProperties(input.program, {}, lookupIn(input.program));
  const UnreadCode unread(input.program);
  const Program runs = unread.executable();
  ProverOptions options = usualOptions();
  options.unread = &unread;
  return resultNamed(prove(runs, input.properties, options), "p")->outcome;
}

// A request goes on after its instruction: TRECV writes a buffer that a pointer in its table names, TSEND its status
// byte. GET and PUT are followed: tests/environment/ethernet_test.cpp.
TEST(SmartEthernet, NothingIsProvedOverWhatARequestMayWrite) {
  const std::string rest = ";Network 2;LD V500.0;= Q0.0;Network 3;LD I0.1;= Q0.1;Network 4;LD V100.7;= Q0.2";
  EXPECT_EQ(covered("Network 1;LD I0.0;TRECV VB100" + rest, "never Q0.0"), Outcome::NotCovered);
  for (const char* request : {"TSEND VB100", "TCON VB100", "TDCON VB100"}) {
    const std::string program = std::string("Network 1;LD I0.0;") + request + rest;
    EXPECT_EQ(covered(program, "Q0.1 = I0.1"), Outcome::Proved) << request;
    EXPECT_EQ(covered(program, "never Q0.2"), Outcome::NotCovered) << request;
  }
}

}  // namespace
}  // namespace rungproof::test
