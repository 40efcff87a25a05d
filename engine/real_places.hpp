// RealPlaces: what double words hold, by what a program does with them: an instruction takes one for a REAL or for a
// whole number, a call gives it for a parameter of such a type, a data block or a symbol table declares it so, the
// accumulators of an S7-300/400 bring it to arithmetic, or it is a copy of another. Traces show a REAL as a number, and
// properties compare it as one. Covered by tests/trace/stimulus_test.cpp and tests/property/real_place_test.cpp.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "ir/program.hpp"

namespace rungproof {

enum class NumberUse : std::uint8_t {
  Unknown,  ///< it is moved and nothing else, or both
  Real,
  Whole
};

class RealPlaces {
 public:
  explicit RealPlaces(const Program& program);
  /// Of a double word; Unknown of everything else.
  NumberUse useOf(const Operand& operand) const;
  bool contains(const Operand& operand) const { return useOf(operand) == NumberUse::Real; }

 private:
  using Place = std::pair<Area, std::uint32_t>;
  struct Row {
    Area area;
    std::uint32_t first, count;
  };
  void add(const Operand& operand, NumberUse use);
  void addRow(const Operand& given);
  void addInstruction(const Instruction& instruction);
  void followAccumulators(const Network& network);
  void copy(const Operand& from, const Operand& to);
  void spread();

  const Program& program_;
  std::set<Place> reals_, wholes_;
  std::map<Place, std::set<Place>> copies_;  ///< both ways
  std::map<Place, NumberUse> ofCopies_;      ///< of places that nothing else tells about
  std::vector<Row> rows_;                    ///< of REAL numbers, behind pointers that calls hand over
};

}  // namespace rungproof
