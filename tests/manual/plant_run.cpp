// A run of the plant: on the blurred domain, then on plain numbers; both must leave the same machine behind.
#include "plant_run.hpp"

#include "blurred.hpp"

namespace rungproof::manual {

Plant& Plant::run(const Run& run) {
  const auto nothing = [](auto&) {};
  PlantRun::begin(*this);
  Surroundings otherOutside = outside;
  Concrete::Store copy = store;
  Blurred blurred(otherOutside);
  Blurred::Store blurredStore(copy);
  const Outcome other = PlantRun::on(*this, *plan_, blurred, blurredStore, run, nothing);
  reached.clear();
  Concrete domain(outside);
  const Outcome outcome = PlantRun::on(*this, *plan_, domain, store, run, nothing);
  EXPECT_TRUE(other == outcome) << "the blurred run leaves another stack";
  EXPECT_TRUE(copy == store) << "the blurred run leaves another state";
  EXPECT_TRUE(otherOutside.errors == outside.errors) << "the blurred run meets other hazards";
  PlantRun::finish(*this, run, outcome);
  return *this;
}

void Plant::refresh(int resolution, int count) {
  Concrete domain(outside);
  Machine<Concrete> machine(domain, store, *plan_);
  PlantRun::refresh(*this, machine, resolution, count);
}

}  // namespace rungproof::manual
