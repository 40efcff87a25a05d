// What a run of the plant is in this program: the meanings on plain numbers.
#include "tests/manual/plant_run.hpp"

namespace rungproof::manual {

Plant& Plant::run(const Run& run) {
  PlantRun::begin(*this);
  Concrete domain(outside);
  const Outcome outcome = PlantRun::on(*this, *plan_, domain, store, run, [](auto&) {});
  PlantRun::finish(*this, run, outcome);
  return *this;
}

}  // namespace rungproof::manual
