// Function blocks: those of the standard on timers, counters and edges of the S7-200, those of the project as calls.
//
// TON and TOF are the instructions of that name; TP is a TON with a latch. A preset is a number of steps of the
// timer's resolution: a constant gets a timer that counts it exactly or is refused; a variable one is refused, because
// no timer counts every duration. ET is the current value in ms.
// Counters are a word, CV, that a rising edge moves by one, in the first scan too; edges of CU and CD in one scan
// cancel each other. CTU counts on beyond PV, as the standard lets it; CTD and CTUD stop at 0, where it lets CV go
// below. Q is CV >= PV or CV <= 0 at every call. SR and RS are a seal-in circuit on one bit. A block whose EN is 0 is
// jumped over and keeps everything, though its timer goes on. Tested by tests/graphical/block_test.cpp.
#pragma once

#include <initializer_list>
#include <string_view>

#include "frontend/graphical/drawn_lowering.hpp"

namespace rungproof {

class DrawnBlocks {
 public:
  explicit DrawnBlocks(DrawnLowering& lowering) : l_(lowering) {}

  /// A function block, or a block of the project: it is executed whether somebody uses its outputs or not.
  static bool hasMemory(const DrawnBuild& build, const DrawnElement& element);
  /// Gives the instances that a drawing calls their timers, counters and bits, before anything reads them.
  static void prepare(DrawnBuild& build, DrawnCopy& copy, const DrawnNetwork& network);
  /// Executes a block with `enable` at EN; false if something was reported.
  bool call(int i, const DrawnElement& element, Wire& enable);

 private:
  bool standard(int i, const DrawnElement& element, DrawnCopy& instance, Wire& enable);
  bool timer(const DrawnElement& element, DrawnCopy& instance, Wire in);
  void pulse(DrawnCopy& instance, const Operand& preset, Wire in);
  bool elapsedTime(const DrawnElement& element, DrawnCopy& instance, const DrawnValue& preset);
  /// What a counter reads; an input that it has not is none.
  struct Counted {
    std::optional<Wire> up{}, down{}, reset{}, load{};
  };
  bool counter(const DrawnElement& element, DrawnCopy& instance, const Counted& in);
  bool project(int i, const DrawnElement& element, const DrawnBlock& block, DrawnCopy& instance, Wire enable);
  std::optional<Operand> presetOf(const DrawnElement& element, const DrawnCopy& instance, DrawnValue& value);
  std::optional<Wire> powerIn(const DrawnElement& element, std::initializer_list<std::string_view> names,
                              bool isRequired);
  const DrawnPin* pin(const DrawnElement& element, std::initializer_list<std::string_view> names) const;
  void deliver(int i, const DrawnElement& element, std::string_view name, const VariablePlace& place);
  bool isAsked(int i, const DrawnElement& element, std::string_view name) const;

  DrawnLowering& l_;
};

}  // namespace rungproof
