// What an interrupt routine keeps, any number of its runs keeps: bounds with both ends, lists of values, cells that
// are alike, what a bit implies, what the property itself says. Each number of runs is possible at each place; in the
// programs a routine leaves the bounds for a moment, comes back before it ends, and is never seen in between
// (001:5480: a routine runs to its end).
#include "interrupt_program.hpp"

namespace rungproof::test {
namespace {

const std::string edge = "LD SM0.1;ATCH INT_0,2;ENI";

TEST(RoutineInvariant, AWrappingCountHasBothEnds) {
  // 9 becomes 10 and then 0: 0..9 at the end of each run.
  EXPECT_EQ(verdict("prove a: VW10 >= 0 and VW10 <= 9", edge, {"LD SM0.0;INCW VW10;LDW>= VW10,10;MOVW 0,VW10"}),
            Outcome::Proved);
  EXPECT_EQ(verdict("prove a: VB10 <= 9", edge, {"LD SM0.0;INCB VB10;LDB>= VB10,10;MOVB 0,VB10"}), Outcome::Proved);
  EXPECT_EQ(verdict("prove a: VD10 >= 0 and VD10 <= 9", edge, {"LD SM0.0;INCD VD10;LDD>= VD10,10;MOVD 0,VD10"}),
            Outcome::Proved);
  // The lower end alone rests on the upper one: 32767 would become -32768.
  EXPECT_EQ(verdict("prove a: VW10 >= 0", edge, {"LD SM0.0;INCW VW10;LDW> VW10,9;MOVW 0,VW10"}), Outcome::Proved);
  // Downwards: below 0 it begins at 9 again.
  EXPECT_EQ(verdict("prove a: VW10 >= 0 and VW10 <= 9", edge, {"LD SM0.0;DECW VW10;LDW< VW10,0;MOVW 9,VW10"}),
            Outcome::Proved);
  // With the limit at 11 it stands at 10 after ten runs, which may come at ten places.
  EXPECT_NE(verdict("prove a: VW10 <= 9", edge, {"LD SM0.0;INCW VW10;LDW>= VW10,11;MOVW 0,VW10"}), Outcome::Proved);
  EXPECT_EQ(verdict("prove a: VW10 <= 1", edge, {"LD SM0.0;INCW VW10;LDW>= VW10,3;MOVW 0,VW10"}), Outcome::Violated);
  // The main program leaves the bounds, and the routine does not bring it back.
  EXPECT_EQ(verdict("prove a: VW10 <= 9", edge + ";LD I0.0;MOVW 20,VW10", {"LDW< VW10,9;INCW VW10"}),
            Outcome::Violated);
}

TEST(RoutineInvariant, CopiesAreBoundedAsWhatTheyCopy) {
  EXPECT_EQ(verdict("prove a: VW4 >= 0 and VW4 <= 9", edge, {"LDW< VW10,9;INCW VW10;LD SM0.0;MOVW VW10,VW4"}),
            Outcome::Proved);
  // Two routines: one counts, the other takes the count over.
  EXPECT_EQ(verdict("prove a: VW4 >= 0 and VW4 <= 100", "LD SM0.1;ATCH INT_0,2;ATCH INT_1,0;ENI",
                    {"LDW< VW0,100;INCW VW0", "LD SM0.0;MOVW VW0,VW4;MOVW 0,VW0"}),
            Outcome::Proved);
  EXPECT_EQ(verdict("prove a: VW4 = 0", edge, {"LDW< VW10,9;INCW VW10;LD SM0.0;MOVW VW10,VW4"}), Outcome::Violated);
}

TEST(RoutineInvariant, ValuesOfAList) {
  EXPECT_EQ(
      verdict("prove a: VW4 = 0 or VW4 = 1000 or VW4 = 2000", edge, {"LDW= VW4,1000;MOVW 2000,VW4;NOT;MOVW 1000,VW4"}),
      Outcome::Proved);
  EXPECT_EQ(verdict("prove a: VW4 = 0 or VW4 = 1000", edge, {"LDW= VW4,1000;MOVW 2000,VW4;NOT;MOVW 1000,VW4"}),
            Outcome::Violated);
  // A bit that toggles says which of two values stands there.
  const std::vector<std::string> toggle = {
      "LD M0.0;= L0.0;LD L0.0;MOVW 1000,VW4;R M0.0,1;LDN L0.0;MOVW 2000,VW4;S M0.0,1"};
  EXPECT_EQ(verdict("prove a: M0.0 implies VW4 = 2000", edge, toggle), Outcome::Proved);
  EXPECT_EQ(verdict("prove a: M0.0 implies VW4 = 1000", edge, toggle), Outcome::Violated);
}

TEST(RoutineInvariant, CellsThatAreAlikeStayAlike) {
  // Whether INCW wraps at 32767 or stays there, both do the same as long as they are alike.
  EXPECT_EQ(verdict("prove a: VW4 = VW6", edge, {"LD SM0.0;INCW VW4;INCW VW6"}), Outcome::Proved);
  EXPECT_EQ(verdict("prove a: VW4 = VW6", edge + ";LD I0.0;INCW VW4", {"LD SM0.0;INCW VW4;INCW VW6"}),
            Outcome::Violated);
  EXPECT_EQ(verdict("prove a: VW4 = VW6", edge, {"LD SM0.0;INCW VW4;LDW< VW6,2;INCW VW6"}), Outcome::Violated);
}

// A timed event comes as often as its period passes: once at most in a scan of less than 10 ms, in one of 20 ms twice.
TEST(RoutineInvariant, TimedEventsComeNoOftenerThanTheyAreDue) {
  ProverOptions options = usualOptions();
  options.time = {1, 9};
  const std::string timed = "LD SM0.1;MOVB 10,SMB34;ATCH INT_0,10;ENI";
  EXPECT_EQ(verdict("prove a: VW0 <= prev(VW0) + 1", timed, {"LDW< VW0,1000;INCW VW0"}, 0, options), Outcome::Proved);
  options.time = {1, 20};
  EXPECT_EQ(verdict("prove a: VW0 <= prev(VW0) + 1", timed, {"LDW< VW0,1000;INCW VW0"}, 0, options), Outcome::Violated);
}

}  // namespace
}  // namespace rungproof::test
