// Interrupt routines with pointers: where they lead follows from the values that cells have whenever a routine begins,
// however often it comes. A buffer is written within its bounds, a ring stays a ring, and what a pointer cannot reach
// stays as it is. Verdicts follow from the program texts below; each reason stands beside its verdict.
#include "tests/environment/asked.hpp"

namespace rungproof {
namespace {

using test::Asked;
using test::asked;
using test::verdict;

/// Each character goes to the place of VB20 in a ring of eight at VB100.
const std::string ring =
    "INTERRUPT_BLOCK INT_0:INT0;BEGIN;Network 1;LD SM0.0;MOVD &VB100,AC1;MOVD 0,AC2;MOVB VB20,AC2;+D AC2,AC1;"
    "MOVB SMB2,*AC1;INCB VB20;ANDB 7,VB20;END_INTERRUPT_BLOCK";
const std::string receiving = "LD SM0.1;MOVB 9,SMB30;ATCH INT_0,8;ENI";

Outcome ofRing(const std::string& property, const std::string& routine = ring) {
  return verdict(Asked{.program = receiving, .property = property, .lowMs = 10, .otherBlocks = routine});
}

TEST(RoutinePointer, ARingIsWrittenWithinItsBounds) {
  EXPECT_EQ(ofRing("VB20 <= 7"), Outcome::Proved) << "masked before the routine ends";
  EXPECT_EQ(ofRing("VB108 = 0"), Outcome::Proved) << "the ninth byte is beyond the ring";
  EXPECT_EQ(ofRing("VB99 = 0"), Outcome::Vacuous) << "in front of it: nothing in the program touches it";
  EXPECT_EQ(ofRing("reach VB107 = 65"), Outcome::Reachable) << "eight characters, the last of them an A";
  EXPECT_EQ(ofRing("VB20 <= 6"), Outcome::Violated) << "seven characters";
}

TEST(RoutinePointer, WithoutTheMaskTheRingIsLeft) {
  std::string unmasked = ring;
  unmasked.replace(unmasked.find(";ANDB 7,VB20"), 12, "");
  EXPECT_EQ(ofRing("VB108 = 0", unmasked), Outcome::Violated) << "nine characters";
}

/// Characters fill VB100 to VB103 and are dropped then; VB1 counts them.
const std::string buffer =
    "INTERRUPT_BLOCK INT_0:INT0;BEGIN;Network 1;LDB>= VB1,4;S M0.0,1;CRETI;Network 2;LD SM0.0;MOVD &VB100,AC1;"
    "MOVD 0,AC2;MOVB VB1,AC2;+D AC2,AC1;MOVB SMB2,*AC1;INCB VB1;END_INTERRUPT_BLOCK";

TEST(RoutinePointer, ABranchBoundsTheIndex) {
  EXPECT_EQ(ofRing("VB1 <= 4", buffer), Outcome::Proved) << "the fifth is dropped";
  EXPECT_EQ(ofRing("VB104 = 0", buffer), Outcome::Proved);
  EXPECT_EQ(ofRing("reach M0.0", buffer), Outcome::Reachable) << "five characters";
  EXPECT_EQ(ofRing("VB103 <> 66", buffer), Outcome::Violated) << "the fourth may be a B";
}

/// What the main program does with the index between two routines counts as well.
TEST(RoutinePointer, TheMainProgramMayMoveTheIndex) {
  const auto with = [](const std::string& line, const std::string& property) {
    return verdict(Asked{
        .program = receiving + ";Network 2;LD I0.0;" + line, .property = property, .lowMs = 10, .otherBlocks = buffer});
  };
  EXPECT_EQ(with("MOVB 0,VB1", "VB104 = 0"), Outcome::Proved) << "begins anew";
  EXPECT_EQ(with("MOVB 200,VB1", "VB104 = 0"), Outcome::Proved) << "200 is beyond the buffer: dropped";
  EXPECT_EQ(with("MOVB 200,VB1", "VB1 <= 4"), Outcome::Violated);
  EXPECT_EQ(with("MOVB 3,VB1", "VB1 <= 4"), Outcome::Proved) << "three at most are counted behind it";
}

}  // namespace
}  // namespace rungproof
