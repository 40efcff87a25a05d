// ManyTraces: many runs of one program side by side, each with inputs of its own and all with the same scan lengths, in
// vector registers: for random simulation, falsification and whatever else needs scans by the million. Every trace is
// scan by scan what the reference engine makes of its inputs: one in which something happens that the vector code does
// not do - STOP, interrupts, devices, fatal errors - is set apart and goes on in a simulator of its own; so do all of
// them where the program or the processor is not fit for it. Covered by tests/lanes.
#pragma once

#include <memory>
#include <string>
#include <unordered_map>

#include "engine/lanes/lane_groups.hpp"
#include "engine/simulator.hpp"

namespace rungproof {

class ManyTraces {
 public:
  using TraceSet = lanes::TraceSet;

  /// Powers up into RUN, as Simulator does. The program must outlive it. `most`: no other instructions are used.
  ManyTraces(const Program& program, const SimulatorOptions& options, std::size_t count,
             lanes::Vectors most = lanes::Vectors::Bits512);
  ~ManyTraces();
  ManyTraces(const ManyTraces&) = delete;
  ManyTraces& operator=(const ManyTraces&) = delete;

  std::size_t count() const { return count_; }
  /// Input bit `bit` of byte `byte`: on in the traces of a set (bit i of word i / 64), off in the others.
  void setInput(std::uint32_t byte, std::uint32_t bit, const TraceSet& traces);
  /// State of the surroundings of one trace before the next scan, as Simulator::write.
  void write(std::size_t trace, const Operand& operand, std::uint64_t value);

  /// One scan of all traces; 0: of the length that the options give.
  void scan(std::uint32_t lengthUs = 0);
  std::uint64_t scanCount() const { return moment_.scanCount; }

  /// State of a trace between two scans.
  Concrete::Store store(std::size_t trace) const;
  std::uint64_t read(std::size_t trace, const Operand& operand) const;
  /// Traces in which a bit is on.
  TraceSet whereOn(const Operand& bit) const;
  /// Whether whereOn() of that bit reads one row; otherwise it looks into the state of every trace.
  bool hasRow(const Operand& bit) const {
    return groups_ != nullptr && groups_->whereOn(bit.area, bit.offset, bit.bit).has_value();
  }
  /// Run-time errors that have happened in a trace: which, and where.
  std::vector<std::pair<Hazard, const Instruction*>> errors(std::size_t trace) const;

  /// Traces that still run side by side.
  std::size_t sideBySide() const { return sideBySide_; }
  /// How many at once: 256, or 64 or 32 where the program computes with words; 0: none.
  std::size_t lanes() const { return code_ == nullptr ? 0 : code_->layout.lanes; }
  /// Why none ever did; empty where they did.
  const std::string& hindrance() const { return hindrance_; }

 private:
  struct Entry {  ///< of the time since the checkpoint
    struct Write {
      std::size_t trace;
      Operand operand;
      std::uint64_t value;
    };
    struct Input {
      std::uint32_t byte, bit;
      std::size_t firstWord;  ///< of its traces
    };
    std::vector<Write> writes;
    std::vector<Input> inputs;
    TraceSet traces;             ///< of all inputs, one behind the other
    std::uint32_t lengthUs = 0;  ///< of the scan that follows
    void clear() {
      writes.clear();
      inputs.clear();
      traces.clear();
    }
  };

  std::string hindranceOf(lanes::Vectors most) const;
  void setApart(std::size_t trace);
  void setAllApart();
  void checkpoint();
  Concrete::Store withOutputs(Concrete::Store store) const;
  void giveInput(Simulator& simulator, std::uint32_t byte, std::uint32_t bit, bool isOn) const;
  void beginEntry();

  const Program& program_;
  SimulatorOptions options_;
  Simulator lead_;  ///< stays where power-up has left it
  std::size_t count_, sideBySide_;
  compiled::Code recorded_;  ///< without its steps
  std::unique_ptr<lanes::LaneCode> code_;
  std::unique_ptr<lanes::LaneGroups> groups_;
  std::string hindrance_;

  Simulator::Moment moment_;
  Concrete::Store common_;  ///< what all traces have in common
  Concrete domain_;
  Machine<Concrete> cpu_;  ///< does to `common_` what the CPU does around the program
  TraceSet running_;       ///< side by side
  std::vector<std::unique_ptr<Simulator>> apart_;
  std::unordered_map<std::size_t, TraceSet> errorsBefore_;  ///< of traces apart, by site, up to their checkpoint

  lanes::LaneGroups::Image image_;  ///< of the checkpoint
  Concrete::Store commonThen_;
  Simulator::Moment momentThen_;
  std::vector<Entry> since_;  ///< the first `entries_` of them
  std::size_t entries_ = 0;
  std::size_t scansBetween_ = 0;  ///< two checkpoints
};

}  // namespace rungproof
