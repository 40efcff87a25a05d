// LaneGroups: the state of many traces in rows, group by group, and the way between rows and single states of the
// machine. What the CPU does to all traces alike in a scan, its owner does once on a state of its own: the clocks, the
// bits of SM0 and the scan times of SM come from there.
#pragma once

#include <span>

#include "engine/lanes/lane_code.hpp"
#include "ir/program.hpp"

namespace rungproof::lanes {

/// A set of traces, or of other things with numbers: bit i of word i / 64.
using TraceSet = std::vector<std::uint64_t>;
inline bool contains(const TraceSet& set, std::size_t trace) { return (set[trace / 64] >> (trace % 64) & 1) != 0; }

/// What all traces have in common and no trace may change for itself, or 0: it has a value by trace.
bool isCommon(Area area, std::uint32_t byte);
bool isCommon(const Concrete::Store& model, std::size_t reg);

class LaneGroups {
 public:
  /// All traces begin in the state `start`. `terminals`: inputs that a scan reads.
  LaneGroups(const Code& code, const LaneCode& laneCode, const Concrete::Store& start, std::uint32_t terminals,
             std::size_t count);

  /// Rows of the state at some time.
  struct Image {
    std::vector<std::uint8_t> rows;
    TraceSet inputs;
    std::vector<std::vector<std::pair<Operand, std::uint64_t>>> others;
  };
  /// Brings the state as it is now to `image`.
  void take(Image& image) const;

  /// Input `bit` of the traces of a set is on, of all others off.
  void setInput(std::uint32_t bit, std::span<const std::uint64_t> traces);
  /// What the surroundings write into a cell of one trace (engine/cell_value.hpp). `now`: its state.
  void write(std::size_t trace, const Operand& operand, std::uint64_t value, const Concrete::Store& common);

  /// One scan of the traces of `running`; gives those of them that have left the code, whose state is lost. `common`:
  /// as the scan begins.
  TraceSet scan(const LaneLayout::Head& head, const Concrete::Store& common, const TraceSet& running);

  /// The state of a trace after a scan but for its outputs, over what is common.
  Concrete::Store store(std::size_t trace, const Concrete::Store& common) const;
  Concrete::Store store(std::size_t trace, const Concrete::Store& common, const Image& image) const;
  /// Traces of which that bit is on; nothing: it has no row of truth values.
  std::optional<TraceSet> whereOn(Area area, std::uint32_t byte, std::uint32_t bit) const;
  /// Error sites of a trace at which something has happened so far.
  TraceSet errorsOf(std::size_t trace) const { return errorsIn(rows(trace / layout_.lanes), trace); }
  TraceSet errorsOf(std::size_t trace, const Image& image) const {
    return errorsIn(image.rows.data() + trace / layout_.lanes * layout_.stateEnd, trace);
  }

 private:
  struct alignas(wideBytes) Block {
    std::array<std::uint8_t, wideBytes> bytes;
  };
  struct View {
    const std::uint8_t* rows;
    const TraceSet& inputs;
    const std::vector<std::vector<std::pair<Operand, std::uint64_t>>>& others;
  };
  std::uint8_t* rows(std::size_t group) { return memory_[group * blocks_].bytes.data(); }
  const std::uint8_t* rows(std::size_t group) const { return memory_[group * blocks_].bytes.data(); }
  Concrete::Store storeOf(std::size_t trace, const Concrete::Store& common, const View& view) const;
  template <class Take>
  void eachRow(Take&& take) const;
  void importFrom(const Concrete::Store& store, std::size_t trace);
  void showCommon(const Concrete::Store& common);
  void readInputs();
  void findInputPlaces();
  void putInputs(std::uint32_t byte);
  TraceSet errorsIn(const std::uint8_t* rows, std::size_t trace) const;
  /// Number of a trace's bit in inputs_.
  std::size_t inputAt(std::uint32_t bit, std::size_t trace) const { return bit * count_ + trace; }
  std::uint32_t inputCount() const { return static_cast<std::uint32_t>(8 * isInputNew_.size()); }
  std::size_t groupCount() const { return memory_.size() / blocks_; }

  const LaneLayout& layout_;
  const LaneCode& laneCode_;
  const std::vector<compiled::SlotByte> slots_;
  const std::size_t sites_;
  const bool hasTerminals_;
  const std::uint32_t terminals_;
  const std::size_t count_;
  const std::size_t blocks_;  ///< of a group
  std::vector<Block> memory_;
  TraceSet inputs_;               ///< of all terminals, one behind the other, as they are now
  TraceSet inputsOfScan_;         ///< as the last scan has read them
  std::vector<bool> isInputNew_;  ///< by byte
  struct InputPlaces {
    std::vector<std::size_t> slots, cells;  ///< indexes of a byte in slots_, and in the cells of the layout
  };
  std::vector<InputPlaces> inputPlaces_;                                ///< by byte
  std::vector<bool> isImageWritten_;                                    ///< by byte of I: the program writes it
  std::vector<std::vector<std::pair<Operand, std::uint64_t>>> others_;  ///< by trace: cells without rows
  struct Shown {                                                        ///< a row of what all traces have in common
    Row row;
    Area area;
    std::uint32_t byte;  ///< or number of a register
    int bytes, bit;
    bool isRegister;
    std::uint64_t value;
  };
  std::vector<Shown> shown_;
  std::vector<std::uint8_t*> scanned_;  ///< groups of which traces still run
  bool hasRun_ = false;
};

}  // namespace rungproof::lanes
