// A run of the bench: on plain numbers, then on the blurred domain; both must leave the same machine behind.
#include "bench_run.hpp"

#include "blurred.hpp"

namespace rungproof::manual {

Bench& Bench::run(bool asInterrupt, const Start& start) {
  const auto nothing = [](auto&) {};
  world.errors.begin(store);
  setReadings(store, choices);
  Concrete::Store copy = store;
  Concrete domain(world);
  const Outcome outcome = BenchRun::on(*plan_, domain, store, asInterrupt, start, nothing);

  World otherWorld;
  otherWorld.values = world.values;
  Blurred blurred(otherWorld);
  Blurred::Store blurredStore(copy);
  EXPECT_EQ(BenchRun::on(*plan_, blurred, blurredStore, asInterrupt, start, nothing) == outcome, true)
      << "the blurred run leaves another stack";
  EXPECT_EQ(copy == store, true) << "the blurred run leaves another state";
  EXPECT_EQ(otherWorld.errors == world.errors, true) << "the blurred run meets other hazards";

  BenchRun::finish(*this, outcome, asInterrupt);
  return *this;
}

}  // namespace rungproof::manual
