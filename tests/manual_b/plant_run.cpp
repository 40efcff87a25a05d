// A scan of the plant: on the blurred domain, then on plain numbers; both must leave the same machine behind.
#include "plant_run.hpp"

#include "tests/manual_a/blurred.hpp"

namespace rungproof::manual {

Plant& Plant::scan(int ten, int hundred) {
  const auto nothing = [](auto&) {};
  PlantRun::begin(*this);
  Surroundings otherOutside = outside;
  Concrete::Store copy = store;
  Blurred blurred(otherOutside);
  Blurred::Store blurredStore(copy);
  const Outcome other = PlantRun::on(*this, *plan_, blurred, blurredStore, ten, hundred, nothing);
  reached.clear();
  Concrete domain(outside);
  const Outcome outcome = PlantRun::on(*this, *plan_, domain, store, ten, hundred, nothing);
  EXPECT_TRUE(other == outcome) << "the blurred scan leaves another stack";
  EXPECT_TRUE(copy == store) << "the blurred scan leaves another state";
  EXPECT_TRUE(otherOutside.errors == outside.errors) << "the blurred scan meets other hazards";
  PlantRun::finish(*this, outcome);
  return *this;
}

void Plant::refresh(int resolution, int count) {
  Concrete domain(outside);
  Machine<Concrete> machine(domain, store, *plan_);
  PlantRun::refresh(*this, machine, resolution, count);
}

}  // namespace rungproof::manual
