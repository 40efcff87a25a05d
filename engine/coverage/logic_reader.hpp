// LogicReader: reads the instructions of a block in their order and keeps, instead of truth values, the trees that the
// logic stack, the RLO or the evaluation stack stand for. One reader for each family. Part of coverage_map.cpp.
#pragma once

#include <memory>

#include "engine/coverage/coverage_map.hpp"

namespace rungproof {

class LogicReader {
 public:
  explicit LogicReader(CoverageMap& map) : map_(map) {}
  virtual ~LogicReader() = default;
  virtual void beginBlock(const Pou& pou) = 0;
  virtual void read(const Instruction& instruction, CoveragePlace place) = 0;

 protected:
  LogicTrees& trees() { return map_.trees_; }
  const Program& program() const { return map_.program_; }
  const Choices& choices() const { return map_.choices_; }
  /// A leaf of the instruction; a contact that is `negated` counts by its own bit.
  LogicNode leafOf(LeafKind kind, const Instruction& instruction, CoveragePlace place, bool isNegated = false);
  LogicNode hidden() {
    map_.leaves_.push_back({LeafKind::Hidden, nullptr, {}});
    return trees().leaf(static_cast<std::uint32_t>(map_.leaves_.size() - 1));
  }
  bool isContactLeaf(std::uint32_t leaf) const { return map_.leaves_[leaf].kind == LeafKind::Contact; }
  void decide(const Instruction& instruction, std::uint8_t level, LogicNode condition, CoveragePlace place);
  /// The instruction is a coil or a box of its network; `needsPower`: only power flow reaches it.
  void output(const Instruction& instruction, bool needsPower, CoveragePlace place);
  void transition(StepTransition made);

 private:
  CoverageMap& map_;
};

std::unique_ptr<LogicReader> stackReader(CoverageMap& map);       ///< S7-200
std::unique_ptr<LogicReader> rloReader(CoverageMap& map);         ///< S7-300/400
std::unique_ptr<LogicReader> expressionReader(CoverageMap& map);  ///< IEC 61131-3

}  // namespace rungproof
