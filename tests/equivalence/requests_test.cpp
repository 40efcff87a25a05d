// Devices do the same for two programs as long as these ask the same of them; and what PLS drives is compared by
// numbers.
#include <fmt/format.h>

#include "tests/equivalence/pair.hpp"

namespace rungproof::test {

namespace {

Equivalence compared(const std::string& before, const std::string& after, const char* observed = "") {
  const ProgramInput one = pairSide("old.awl", exportOf(before), ""), other = pairSide("new.awl", exportOf(after), "");
  EquivalenceOptions options;
  options.prover.timeout = 20;
  if (*observed != '\0') options.observed.push_back(*lookupIn(one.program)(observed));
  return compareBehaviour({&one.program, one.properties}, {&other.program, other.properties}, options);
}
std::string verdict(const std::string& before, const std::string& after, const char* observed = "") {
  const Equivalence found = compared(before, after, observed);
  for (const Disagreement& disagreement : found.disagreements) ADD_FAILURE() << disagreement.explanation;
  return equalityText(found.equality);
}
bool notes(const Equivalence& found, const std::string& part) {
  return std::ranges::any_of(found.notes,
                             [&](const std::string& note) { return note.find(part) != std::string::npos; });
}

/// The transmitter is idle: SM4.5 (001:14109). `control`: SMB30; `count`: characters.
std::string transmission(const std::string& control, const std::string& count, const std::string& lamp) {
  return "LD SM0.1;MOVB " + control + ",SMB30;MOVB " + count + ",VB100|LD I0.0;EU;XMT VB100,0|" + lamp;
}
const std::string idleLamp = "LD SM4.5;= Q0.0", idleLampTwice = "LDN SM4.5;NOT;= Q0.0";

std::string reception(const std::string& most) {
  return "LD SM0.1;MOVB 9,SMB30;MOVB 16#B0,SMB87;MOVB " + most + ",SMB94|LD I0.0;EU;RCV VB100,0|LDB= VB101,7;= Q0.0";
}
std::string request(const std::string& station, const std::string& lamp) {
  return "LD SM0.1;MOVB 2,SMB30;MOVB " + station + ",VB101;MOVD &VB1000,VD102;MOVB 4,VB106|LD I0.0;EU;NETR VB100,0|" +
         lamp;
}
std::string counter(const std::string& control, const std::string& mode, const std::string& preset = "100") {
  return "LD SM0.1;MOVB " + control + ",SMB37;MOVD " + preset + ",SMD42;HDEF 0," + mode + ";HSC 0";
}
std::string clock(const std::string& hour) {
  return "LD SM0.1;MOVB " + hour + ",VB3;MOVB 1,VB7;TODW VB0|LD SM0.0;TODR VB10|LDB= VB13,5;= Q0.0";
}
/// Characters that interrupts take (001:3324).
std::string characters(const std::string& control, const std::string& test) {
  return "LD SM0.1;MOVB " + control + ",SMB30;ATCH INT_0,8;ENI@INT0:LD SM0.0;MOVB SMB2,VB0|" + test;
}
/// PWM with a cycle of 1000 us.
std::string modulation(const std::string& width) {
  return "LD I0.0;= Q0.5|LD SM0.1;MOVW 1000,SMW68;MOVW " + width + ",SMW70;MOVB 16#D3,SMB67;PLS 0";
}
/// A train with a cycle of 1000 us.
std::string train(const std::string& count) {
  return "LD SM0.1;MOVW 1000,SMW68;MOVD " + count + ",SMD72;MOVB 16#85,SMB67;PLS 0|LD SM66.7;= Q0.5";
}

}  // namespace

TEST(Requests, TransmissionsThatTakeAnotherTime) {
  EXPECT_EQ(verdict(transmission("9", "10", idleLamp), transmission("9", "10", idleLampTwice)), "EQUAL");
  const Equivalence longer = compared(transmission("9", "10", idleLamp), transmission("9", "200", idleLamp));
  EXPECT_EQ(equalityText(longer.equality), "UNKNOWN") << "200 characters take longer than 10";
  EXPECT_TRUE(notes(longer, "XMT at new.awl:10"));
  EXPECT_EQ(verdict(transmission("9", "10", idleLamp), transmission("5", "10", idleLamp)), "UNKNOWN")
      << "bits 2 to 4 of SMB30 are the baud rate (001:14167)";
}

/// What is sent is no output; the assumptions of the verdict say so.
TEST(Requests, TransmissionsOfOtherCharacters) {
  const Equivalence found =
      compared(transmission("9", "10", idleLamp), "LD SM0.1;MOVB 65,VB101|" + transmission("9", "10", idleLamp));
  EXPECT_EQ(equalityText(found.equality), "EQUAL");
  EXPECT_TRUE(std::ranges::any_of(
      found.assumptions, [](const std::string& text) { return text.find("XMT and NETW") != std::string::npos; }));
}

TEST(Requests, OutputsThatDoNotDependOnThem) {
  EXPECT_EQ(verdict(transmission("9", "10", "LD I0.1;= Q0.0"), transmission("9", "200", "LD I0.1;= Q0.0")), "EQUAL");
}

TEST(Requests, ReceptionsThatEndOtherwise) {
  EXPECT_EQ(verdict(reception("10"), reception("10") + ";= M0.0"), "EQUAL");
  EXPECT_EQ(verdict(reception("10"), reception("50")), "UNKNOWN") << "SMB94: the maximum number of characters";
}

TEST(Requests, AnswersOfAnotherStation) {
  EXPECT_EQ(verdict(request("2", "LDB= VB107,7;= Q0.0"), request("2", "LDB<> VB107,7;NOT;= Q0.0")), "EQUAL");
  EXPECT_EQ(verdict(request("2", "LDB= VB107,7;= Q0.0"), request("3", "LDB= VB107,7;= Q0.0")), "UNKNOWN")
      << "VB101 of the table is the address of the remote station (000:1113)";
}

TEST(Requests, FastCountersThatCountOtherwise) {
  const std::string lamp = "|LDD>= HC0,100;= Q0.0";
  EXPECT_EQ(verdict(counter("16#F8", "0") + lamp, counter("16#F8", "0", "+100") + lamp + ";= M0.0"), "EQUAL");
  EXPECT_EQ(verdict(counter("16#F8", "0") + lamp, counter("16#F0", "0") + lamp), "UNKNOWN")
      << "bit 3 of SMB37: up or down";
  EXPECT_EQ(verdict(counter("16#F8", "0") + lamp, counter("16#F8", "9") + lamp), "UNKNOWN")
      << "mode 9 is a quadrature counter (001:4234)";
  EXPECT_NE(verdict(lamp.substr(1), counter("16#F8", "0") + lamp), "EQUAL") << "only one counts";
}

TEST(Requests, EventsOfFastCountersThatComeAtOtherCounts) {
  const std::string attach = ";ATCH INT_0,12;ENI@INT0:LD SM0.0;S Q0.5,1";
  EXPECT_EQ(verdict(counter("16#F8", "0") + attach, counter("16#F8", "0") + attach), "EQUAL");
  EXPECT_EQ(verdict(counter("16#F8", "0") + attach, counter("16#F8", "0", "200") + attach), "UNKNOWN");
}

TEST(Requests, ClocksThatAreSetOtherwise) {
  EXPECT_EQ(verdict(clock("16#10"), clock("16#10") + ";= M0.0"), "EQUAL");
  EXPECT_EQ(verdict(clock("16#10"), clock("16#12")), "UNKNOWN");
}

TEST(Requests, CharactersAreTheSameForBoth) {
  const std::string lamp = "LDB= VB0,5;= Q0.5", other = "LDB= VB0,6;= Q0.5";
  EXPECT_EQ(verdict(characters("9", lamp), characters("9", lamp)), "EQUAL") << "a program equals itself";
  EXPECT_EQ(verdict(characters("9", lamp), characters("9", other)), "DIFFERENT");
  EXPECT_NE(verdict(characters("9", lamp), characters("5", lamp)), "EQUAL") << "another baud rate";
}

TEST(Requests, MessagesThatInterruptsTell) {
  const auto told = [](const std::string& most) {
    return "LD SM0.1;MOVB 9,SMB30;MOVB 16#B0,SMB87;MOVB " + most +
           ",SMB94;ATCH INT_0,23;ENI|LD I0.0;EU;RCV VB100,0@INT0:LDB= SMB86,16#20;S Q0.5,1";
  };
  EXPECT_EQ(verdict(told("10"), told("10")), "EQUAL") << "a program equals itself";
  EXPECT_NE(verdict(told("10"), told("50")), "EQUAL");
}

TEST(Requests, TrainsThatEndAtOtherTimes) {
  EXPECT_EQ(verdict(train("10"), train("10000"), "Q0.5"), "UNKNOWN") << "SM66.7: the output is idle (001:14246)";
  EXPECT_EQ(verdict(train("10"), train("+10"), "Q0.5"), "EQUAL");
}

/// The equality rests on devices that do the same: that both ask the same of them has certificates of its own.
TEST(Requests, AreCertified) {
  const std::string source = counter("16#F8", "0") + "|LDD>= HC0,100;= Q0.0";
  const ProgramInput one = pairSide("old.awl", exportOf(source), "");
  const ProgramInput other =
      pairSide("new.awl", exportOf(counter("16#F8", "0", "+100") + "|LDD>= HC0,100;= Q0.0;= M0.0"), "");
  EquivalenceOptions options;
  options.prover.certificates = true;
  const Equivalence found = compareBehaviour({&one.program, {}}, {&other.program, {}}, options);
  EXPECT_EQ(equalityText(found.equality), "EQUAL");
  for (const std::string& name : found.uncertified) ADD_FAILURE() << name;
  const auto isOfRequest = [](const auto& certificate) { return certificate.first.starts_with("request"); };
  EXPECT_GE(std::ranges::count_if(found.certificates, isOfRequest), 2) << "HDEF and HSC";
}

TEST(Pulses, NumbersThatDiffer) {
  const auto signal = [](const Equivalence& found) { return found.run ? found.run->signal : "none"; };
  const Equivalence widths = compared(modulation("100"), modulation("200"));
  EXPECT_EQ(signal(widths), "PLS0.width");
  ASSERT_TRUE(widths.run.has_value());
  EXPECT_EQ(widths.run->scan, 1U);
  EXPECT_EQ(widths.run->valueBefore, 100U);
  EXPECT_EQ(widths.run->valueAfter, 200U);
  EXPECT_EQ(signal(compared(train("10"), train("20"))), "PLS0.count");
  EXPECT_EQ(signal(compared("LD I0.0;= Q0.5", modulation("200"))), "PLS0.mode") << "only NEW drives pulses";
  EXPECT_EQ(signal(compared(modulation("200"), train("10"))), "PLS0.mode");
}

TEST(Pulses, ADifferenceThatNeedsAnInput) {
  const auto onDemand = [](const std::string& input) {
    return "LD I0.0;= Q0.5|LD " + input + ";MOVW 1000,SMW68;MOVW 200,SMW70;MOVB 16#D3,SMB67;PLS 0";
  };
  const Equivalence found = compared(onDemand("I0.0"), onDemand("I0.1"));
  ASSERT_TRUE(found.run.has_value());
  EXPECT_EQ(found.run->signal, "PLS0.mode");
}

TEST(Pulses, TimeBasesAreNoDifference) {
  const auto of = [](const char* cycle, const char* width, const char* control) {
    return fmt::format("LD SM0.1;MOVW {},SMW68;MOVW {},SMW70;MOVB {},SMB67;PLS 0", cycle, width, control);
  };
  const std::string inUs = of("2000", "1000", "16#D3"), inMs = of("2", "1", "16#DB");  // bit 3: 1 ms (001:14250)
  EXPECT_NE(verdict(inUs, inMs), "DIFFERENT");
  EXPECT_EQ(verdict(of("2", "1", "16#D3"), inMs), "DIFFERENT");
}

/// The output of a generator with width 0 is off, and one with the width of its cycle is on (001:4622): that can be
/// what the process image gives.
TEST(Pulses, LevelsAreNoPulses) {
  for (const char* width : {"0", "1000", "2000"}) {
    EXPECT_EQ(verdict("LD I0.0;= Q0.5", modulation(width)), "UNKNOWN") << width;
    EXPECT_EQ(verdict(modulation("500"), modulation(width)), "DIFFERENT") << width;
  }
}

TEST(Pulses, AnotherOutputIsAnotherSignal) {
  const std::string other = "LD I0.0;= Q0.5|LD SM0.1;MOVW 1000,SMW78;MOVW 200,SMW80;MOVB 16#D3,SMB77;PLS 1";
  const Equivalence found = compared(modulation("200"), other);
  EXPECT_EQ(equalityText(found.equality), "DIFFERENT");
}

}  // namespace rungproof::test
