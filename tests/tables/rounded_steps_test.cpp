// REAL values that somebody can set at a machine.
#include "analysis/testing/rounded_steps.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace rungproof {
namespace {

TestSignals signalsWith(SignalType type) {
  TestSignals signals;
  TestInput& input = signals.inputs.emplace_back();
  input.signal.type = type;
  input.signal.operand.kind = OperandKind::Direct;
  input.signal.operand.width = Width::DWord;
  return signals;
}

/// The values that stand for one.
std::vector<float> roundedFrom(float value, SignalType type = SignalType::Real) {
  std::vector<float> values;
  const TestSignals signals = signalsWith(type);
  for (const BenchTest& steps : roundedSteps({{{{0, value}}, {1, 0}}}, signals))
    values.push_back(static_cast<float>(steps[0].changes[0].second));
  return values;
}

TEST(RoundedSteps, CountDigits) {
  const TraceSignal signal = signalsWith(SignalType::Real).inputs[0].signal;
  for (const auto& [value, digits] : {std::pair(0.0F, 0U), std::pair(50.0F, 1U), std::pair(12.5F, 3U),
                                      std::pair(0.25F, 2U), std::pair(16.666666F, 8U)})
    EXPECT_EQ(digitsOf(value, signal), digits) << value;
  EXPECT_GE(digitsOf(1e-45F, signal), 45U);
}

TEST(RoundedSteps, FromWholeNumbersToDecimals) {
  EXPECT_EQ(roundedFrom(16.666666F),
            (std::vector<float>{16.0F, 17.0F, 16.6F, 16.7F, 16.66F, 16.67F, 16.666F, 16.667F}));
  EXPECT_EQ(roundedFrom(-1e-45F), (std::vector<float>{-1.0F, 0.0F, -0.1F, 0.0F, -0.01F, 0.0F, -0.001F, 0.0F}));
  EXPECT_EQ(roundedFrom(1.7014118e38F)[1], 2e38F);
}

TEST(RoundedSteps, KnowWhatNobodySets) {
  const TestSignals signals = signalsWith(SignalType::Real);
  EXPECT_TRUE(canBeSet({{{{0, 16.666666F}}, {1, 0}}}, signals));
  EXPECT_FALSE(canBeSet({{{{0, 1e-45F}}, {1, 0}}}, signals));
}

TEST(RoundedSteps, LeaveWhatIsEasyToSet) {
  EXPECT_TRUE(roundedFrom(12.5F).empty());
  EXPECT_TRUE(roundedFrom(123456.0F, SignalType::Signed).empty());
}

}  // namespace
}  // namespace rungproof
