// Budgets: wall time for whoever waits, the processor's time of one thread for what is worth a moment.
#include <gtest/gtest.h>

#include <thread>

#include "analysis/bits/engine_contract.hpp"

namespace rungproof {
namespace {

/// Takes that much of the processor's time.
void work(double seconds) {
  const Budget own = Budget::ofThread(seconds, Budget::seconds(60));
  while (!own.isExhausted()) continue;
}

TEST(Budgets, WaitingTakesNothingOfAThreadsTime) {
  const Budget budget = Budget::ofThread(0.05, Budget::seconds(60)), slice = budget.slice(30);
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  EXPECT_FALSE(budget.isExhausted());
  work(0.06);
  EXPECT_TRUE(budget.isExhausted());
  EXPECT_TRUE(slice.isExhausted()) << "a slice is no longer than the whole";
}

TEST(Budgets, TheDeadlineEndsAThreadsTimeToo) {
  const Budget budget = Budget::ofThread(60, Budget::seconds(0.02));
  EXPECT_FALSE(budget.isExhausted());
  std::this_thread::sleep_for(std::chrono::milliseconds(40));
  EXPECT_TRUE(budget.isExhausted());
}

TEST(Budgets, CancellingEndsSlices) {
  std::atomic<bool> cancel{false};
  const Budget slice = Budget::seconds(60, &cancel).slice(30);
  EXPECT_FALSE(slice.isExhausted());
  cancel = true;
  EXPECT_TRUE(slice.isExhausted());
}

}  // namespace
}  // namespace rungproof
