// RealPlaces: the double words that a program uses as REAL numbers: an instruction takes one for a REAL, a call gives
// it for a REAL parameter, a data block declares it so, or the accumulators of an S7-300/400 bring it to REAL
// arithmetic. Traces show such a place as a number, and properties compare it as one. Covered by
// tests/trace/stimulus_test.cpp and tests/property/real_place_test.cpp.
#pragma once

#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "ir/program.hpp"

namespace rungproof {

class RealPlaces {
 public:
  explicit RealPlaces(const Program& program);
  /// Whether the operand is such a double word.
  bool contains(const Operand& operand) const;

 private:
  struct Row {
    Area area;
    std::uint32_t first, count;
  };
  void add(const Operand& operand);
  void addRow(const Operand& given);
  void followAccumulators(const Network& network);

  const Program& program_;
  std::set<std::pair<Area, std::uint32_t>> places_;
  std::vector<Row> rows_;  ///< of REAL numbers, behind pointers that calls hand over
};

}  // namespace rungproof
