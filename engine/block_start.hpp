// What a run determines of the start information of an organization block of an S7-300/400 (002:2000-2015): lengths of
// the scans before for OB1, the delay for OB20 to OB23, the period for OB30 to OB38, the priority of blocks that
// interrupt, date and time for all. What every run determines alike is written by ir/s7300/control.hpp; proofs leave
// all of this open. Tested by tests/step7/block_start_test.cpp.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "engine/concrete.hpp"
#include "engine/real_time_clock.hpp"
#include "ir/block_event.hpp"
#include "ir/machine/plan.hpp"

namespace rungproof {

class BlockStart {
 public:
  /// The CPU enters RUN: no scan has ended.
  void reset() { *this = BlockStart(); }
  void scanEnded(std::uint32_t lengthMs);
  /// A delay of SFC 32 has passed; `delay`: 0 for OB20.
  void delayEnded(std::uint32_t delay, std::uint64_t ms) { delays_[delay] = static_cast<std::uint32_t>(ms); }

  /// Byte 0..19 for that organization block; nothing: a run does not determine it. `nowMs`: of the clock.
  std::optional<std::uint8_t> byteOf(int block, std::uint32_t byte, const Concrete::Store& store,
                                     const RealTimeClock& clock, std::uint64_t nowMs) const;

 private:
  bool hasScan_ = false;
  std::uint16_t previous_ = 0, shortest_ = 0, longest_ = 0;  ///< scans since the start, ms
  std::array<std::uint32_t, delayBlockCount> delays_{};
};

/// Whether the program may read what BlockStart gives OB1.
bool mayReadStartOfMain(const Plan& plan);

}  // namespace rungproof
