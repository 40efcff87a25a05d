// Names.
#include "frontend/graphical/drawn_scope.hpp"

#include <algorithm>
#include <array>

#include "frontend/stl/stl_lexer.hpp"

namespace rungproof {

std::string foldedName(std::string_view name) {
  std::string result(name);
  std::transform(result.begin(), result.end(), result.begin(), upper);
  return result;
}

StandardBlock standardBlockNamed(std::string_view name) {
  static constexpr std::array<std::pair<std::string_view, StandardBlock>, 10> rows = {
      {{"TON", StandardBlock::Ton},
       {"TOF", StandardBlock::Tof},
       {"TP", StandardBlock::Tp},
       {"CTU", StandardBlock::Ctu},
       {"CTD", StandardBlock::Ctd},
       {"CTUD", StandardBlock::Ctud},
       {"SR", StandardBlock::Sr},
       {"RS", StandardBlock::Rs},
       {"R_TRIG", StandardBlock::RTrig},
       {"F_TRIG", StandardBlock::FTrig}}};
  for (const auto& [row, block] : rows) {
    if (equalsIgnoringCase(row, name)) return block;
  }
  return StandardBlock::None;
}

}  // namespace rungproof
