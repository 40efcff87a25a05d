// Inputs of high-speed counters: tables 6-26 and G-5 (001:4216-4237, 001:14759-14801).
#include "ir/s7200/hsc_inputs.hpp"

#include <gtest/gtest.h>

namespace rungproof {

TEST(HscInputs, ModesOfEachCounter) {
  for (int mode = -1; mode <= 13; ++mode) {
    const bool anyOfTwelve = mode >= 0 && mode <= 11;
    const bool withoutStart = anyOfTwelve && mode % 3 != 2;
    EXPECT_EQ(hscHasMode(Target{}, 0, mode), withoutStart || mode == 12) << mode;
    EXPECT_EQ(hscHasMode(Target{}, 1, mode), anyOfTwelve) << mode;
    EXPECT_EQ(hscHasMode(Target{}, 2, mode), anyOfTwelve) << mode;
    EXPECT_EQ(hscHasMode(Target{}, 3, mode), mode == 0 || mode == 12) << mode;
    EXPECT_EQ(hscHasMode(Target{}, 4, mode), withoutStart) << mode;
    EXPECT_EQ(hscHasMode(Target{}, 5, mode), mode == 0) << mode;
    EXPECT_FALSE(hscHasMode(Target{}, 6, mode)) << mode;
  }
}

TEST(HscInputs, InputsOfEachMode) {
  // HSC1: I0.6 clock, I0.7 direction or second clock, I1.0 reset, I1.1 start.
  const bool second[] = {false, false, false, true, true, true, true, true, true, true, true, true};
  for (int mode = 0; mode <= 11; ++mode) {
    EXPECT_TRUE(hscUsesInput(Target{}, 1, mode, 6)) << mode;
    EXPECT_EQ(hscUsesInput(Target{}, 1, mode, 7), second[mode]) << mode;
    EXPECT_EQ(hscUsesInput(Target{}, 1, mode, 8), mode % 3 != 0) << mode;
    EXPECT_EQ(hscUsesInput(Target{}, 1, mode, 9), mode % 3 == 2) << mode;
    EXPECT_FALSE(hscUsesInput(Target{}, 1, mode, 0)) << mode;
  }
  EXPECT_TRUE(hscUsesInput(Target{}, 2, 11, 13));
  EXPECT_TRUE(hscUsesInput(Target{}, 0, 1, 2)) << "reset of HSC0";
  EXPECT_FALSE(hscUsesInput(Target{}, 0, 1, 1)) << "mode 1 leaves I0.1 free (001:4211)";
  EXPECT_TRUE(hscUsesInput(Target{}, 3, 0, 1));
  EXPECT_TRUE(hscUsesInput(Target{}, 4, 3, 4));
  EXPECT_TRUE(hscUsesInput(Target{}, 5, 0, 4));
  EXPECT_FALSE(hscUsesInput(Target{}, 0, 12, 0)) << "mode 12 counts pulses of the CPU";
  EXPECT_FALSE(hscUsesInput(Target{}, 0, 2, 0)) << "HSC0 has no mode 2";
}

}  // namespace rungproof
