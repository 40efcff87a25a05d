// What a scan of the plant is in this program: the meanings on plain numbers.
#include "tests/manual_b/plant_run.hpp"

namespace rungproof::manual {

Plant& Plant::scan(int ten, int hundred) {
  PlantRun::begin(*this);
  Concrete domain(outside);
  const Outcome outcome = PlantRun::on(*this, *plan_, domain, store, ten, hundred, [](auto&) {});
  PlantRun::finish(*this, outcome);
  return *this;
}

}  // namespace rungproof::manual
