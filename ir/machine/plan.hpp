// What is known about a program before it runs: the flow of each block, a number for each EU and ED, and which
// timers are of which kind. Engine and encoder build it once per program.
#pragma once

#include <map>
#include <string_view>
#include <vector>

#include "ir/block_map.hpp"
#include "ir/dialect.hpp"
#include "ir/flow.hpp"
#include "ir/machine/register.hpp"

namespace rungproof {

/// What a timer box does with time (tables 6-73 and 6-76, 001:6551-6586, 001:6693-6706).
/// S5: of an S7-300/400, where the instruction that starts it decides.
enum class TimerKind : std::uint8_t { OnDelay, Retentive, OffDelay, IecOnDelay, IecPulse, S5 };
/// IEC TOF behaves as TOF. CHECKs that the instruction is a timer.
TimerKind timerKind(const Desc& desc);

/// A timer box that occurs in the program. A number used by boxes of two kinds has two entries (TIM002).
struct TimerUse {
  std::uint32_t number;
  const Desc* desc;  ///< TON, TOF, TONR or an IEC box
  int resolution;    ///< ms
  TimerKind kind;
  bool decides = true;  ///< first use of its number: it says how the number counts
};

struct Plan {
  /// `isLeftOut`, by Instruction::id (may be empty): instructions that do not run. Numbers of edges and texts are those
  /// of the whole program all the same.
  explicit Plan(const Program& program, const std::vector<bool>& isLeftOut = {});

  const Program* program;
  std::vector<Flow> flows;          ///< parallel to Program::pous
  std::vector<std::uint32_t> edge;  ///< by Instruction::id: number of the EU or ED, else noPartner
  std::uint32_t edgeCount = 0;
  std::vector<TimerUse> timers;                        ///< in the order of first use
  std::uint32_t timerCount = 256, counterCount = 256;  ///< numbers of timers and counters that have registers
  std::shared_ptr<const BlockMap> blocks;              ///< S7-300/400: data blocks; never nullptr
  std::uint32_t localBytes = 0;                        ///< of L memory of all levels of calls
  std::vector<std::uint32_t> iecTimers;  ///< S7-300/400: instances of SFB 3, 4 and 5 by their first byte (dataByte)
  /// Timed events that can come (ir/s7200/event.hpp): 10 and 11, of an S7-300/400 the cyclic blocks that it has.
  std::vector<std::uint32_t> timedEvents;
  bool masksErrors = false;           ///< S7-300/400: a block is called that masks synchronous errors
  std::vector<const Operand*> texts;  ///< string constants given to subroutines; pointers name them by their index

  /// First use of a timer number, or nullptr. It decides how the number counts.
  const TimerUse* timer(std::uint32_t number) const;

  const Flow* main() const { return find(PouKind::Main, -1); }
  const Flow* subroutine(int number) const { return find(PouKind::Subroutine, number); }
  const Flow* interrupt(int number) const { return find(PouKind::Interrupt, number); }
  /// S7-300/400: the block of that number (ir/s7300/block.hpp), or nullptr.
  const Flow* block(int number) const;
  const Dialect& dialect() const { return *dialect_; }
  StatementForm form() const { return form_; }
  Counting counting() const { return dialect_->run.counting; }

 private:
  const Dialect* dialect_;
  StatementForm form_;                     ///< of the dialect, asked for at each instruction
  std::map<int, std::size_t> codeBlocks_;  ///< index in flows by Pou::number
  void planBoxes();                        ///< ir/s7200/plan_boxes.cpp
  void planBlocks();                       ///< ir/s7300/plan_blocks.cpp
  void number(const Instruction& instruction);
  const Flow* find(PouKind kind, int number) const;
};

/// How many registers of a kind a run of the program has.
std::uint32_t registerCount(const RegInfo& info, const Plan& plan);

}  // namespace rungproof
