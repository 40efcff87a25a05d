// LaneCode: recorded code of a whole scan (engine/compiled/code.hpp) as machine code for all traces of a group at once.
// Long code without branches has parts, each of which all groups go through before the next one.
#pragma once

#include <memory>
#include <span>

#include "engine/lanes/lane_layout.hpp"

namespace rungproof::lanes {

/// A step that is done trace by trace, by a function.
struct StepByTrace {
  Step step;
  ReachedRows rows{};  ///< LoadAt and StoreAt
};

class LaneCode {
 public:
  LaneCode(const Code& code, const std::vector<bool>& isNeeded, const Concrete::Store& model, bool isWide)
      : layout(code, isNeeded, model, isWide) {}
  virtual ~LaneCode() = default;
  /// One scan of groups whose rows begin there. Traces that leave the code are on in the row left(): what their rows
  /// hold then is of no use.
  virtual void run(std::span<std::uint8_t* const> groups) const = 0;

  LaneLayout layout;
};

/// Vector instructions that this processor has: none that are of use, AVX2, or those of AVX-512 for all widths.
enum class Vectors : std::uint8_t { None, Bits256, Bits512 };
Vectors vectorsHere();
/// nullptr: there is no machine code. `model`: a state of the program. `most`: no others are used.
std::unique_ptr<LaneCode> translatedForLanes(const Code& code, const std::vector<bool>& isNeeded,
                                             const Concrete::Store& model, Vectors most);

/// Does a step for all traces that the row active() names: operands and result stand in the scratch rows 0, 1 and 2 in
/// the form `rep`, of LoadAt and StoreAt the address as Rep::Double.
void doByTrace(const StepByTrace* step, const LaneLayout* layout, std::uint8_t* rows, std::uint64_t rep);

}  // namespace rungproof::lanes
