// The map of --map: which addresses of OLD and NEW stand for each other, one pair a line:
//     I0.0..I0.7 = I1.0..I1.7     # ranges of equal length
//     "Start"    = I0.4           # symbols of either program
//     event 8    = event 25       # interrupt events
// Mistakes are failures with place. Tested by tests/equivalence/pairs_test.cpp.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/equivalence/address_pairs.hpp"
#include "frontend/files/failure.hpp"
#include "ir/program.hpp"

namespace rungproof {

/// A line of the map.
struct MapLine {
  std::uint32_t line = 0;
  Address before, after;
  std::uint32_t count = 1;
  std::optional<std::pair<int, int>> events{};  ///< in place of addresses
};

/// Reads the text; `name` is that of the file in messages.
std::vector<MapLine> readMap(const std::string& name, std::string_view text, const Program& before,
                             const Program& after, std::vector<Failure>& failures);

}  // namespace rungproof
