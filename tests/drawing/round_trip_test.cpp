// STL to a drawing and back gives the same instructions.
#include <gtest/gtest.h>

#include "tests/drawing/networks.hpp"

namespace rungproof::testing {
namespace {

/// Networks as Micro/WIN writes them, of every shape; those marked FBD a ladder cannot show.
constexpr std::string_view bothForms[] = {
    "LD I0.0; = Q0.0",
    "LD I0.0; A I0.1; O I0.2; = Q0.0",
    "LD I0.2; ON I0.3; = Q0.2",
    "LDI I0.0; ANI I0.1; OI I0.2; =I Q0.0",
    "LDW>= VW0, +10; AB< VB4, 5; OD= VD8, +1; = Q0.0",
    "LD I0.0; LD I0.1; LD I2.0; A I2.1; OLD; ALD; = Q5.0",
    "LD I0.0; LPS; LD I0.5; O I0.6; ALD; = Q7.0; LRD; LD I2.1; O I1.3; ALD; = Q6.0; LPP; A I1.0; = Q3.0",
    "LD I0.4; LPS; EU; S Q0.3, 1; = Q0.4; LPP; ED; R Q0.3, 1; = Q0.5",
    "LD I0.0; A I0.1; = Q0.0; NOT; = Q0.1",
    "LD I0.1; MOVW -30000, VW0; MOVD -200000000, VD2; MOVR 1.5, VD6",
    "LD I0.1; MOVB 1, VB0; AENO; MOVB 2, VB1; AENO; = Q0.0",
    "LD I0.0; LPS; MOVB 1, VB0; AENO; = Q0.0; LPP; A I0.1; = Q0.1",
    "LD I0.0; LD I0.1; CTU C1, +5",
    "LD I0.0; LD I0.1; LD I0.2; O I0.3; CTUD C2, +5",
    "LD Q0.2; A Q0.4; TON T33, +200; AN T33; = Q0.3",
    "LD I0.0; EU; LD I0.1; ED; OLD; = Q0.0",
    "LD I0.0; = L60.0; LD I0.1; = L63.7; LD I0.2; EU; = L63.6; LD L60.0; CALL SBR0, L63.7, L63.6, Q0.0",
    "LD SM0.0; CALL SBR0, I0.1, I0.2, Q0.0",
    "LD M1.2; LPS; AB= VB940, 0; S Q0.4, 1; R T33, 1; SCRT S0.3; LPP; AB<> VB940, 0; SCRT S1.0",
    "LD I0.0; LPS; A I0.1; LPS; A I0.2; = Q0.0; LPP; A I0.3; = Q0.1; LPP; = Q0.2; A I0.4; = Q0.3",
    "LSCR S0.1",
    "SCRE",
    "LBL 4",
    "LD I0.0; JMP 4",
    "LD I0.0; SHRB I0.1, V0.0, +4",
    "LD SM0.1; HDEF 1, 11; HSC 1",
};
constexpr std::string_view fbdOnly[] = {
    "LD I0.0; LD I0.1; EU; ALD; = Q0.0",
    "LD I0.0; LD I0.1; O I0.2; NOT; ALD; = Q0.0",
    "LD I0.0; LD I0.1; = Q0.1; O I0.2; ALD; = Q0.0",
    "LD I0.0; = Q0.0; O I0.1; = Q0.1",
};

TEST(RoundTrip, LadderGivesTheSameInstructions) {
  for (const std::string_view statements : bothForms)
    EXPECT_EQ(roundTrip(statements, Form::Ladder), spelled(statements));
}

TEST(RoundTrip, FbdGivesTheSameInstructions) {
  for (const std::string_view statements : bothForms) EXPECT_EQ(roundTrip(statements, Form::Fbd), spelled(statements));
  for (const std::string_view statements : fbdOnly) {
    EXPECT_EQ(roundTrip(statements, Form::Fbd), spelled(statements));
    EXPECT_TRUE(roundTrip(statements, Form::Ladder).starts_with("refused: ")) << statements;
  }
}

}  // namespace
}  // namespace rungproof::testing
