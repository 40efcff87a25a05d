// What is known about a program before it runs: the flow of each block, a number for each EU and ED, and which
// timers are of which kind. Engine and encoder build it once per program.
#pragma once

#include <map>
#include <string_view>
#include <vector>

#include "ir/flow.hpp"

namespace rungproof {

/// What a timer box does with time (tables 6-73 and 6-76, 001:6551-6586, 001:6693-6706).
enum class TimerKind : std::uint8_t { OnDelay, Retentive, OffDelay, IecOnDelay, IecPulse };
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
  std::vector<TimerUse> timers;       ///< in the order of first use
  std::vector<const Operand*> texts;  ///< string constants given to subroutines; pointers name them by their index

  /// First use of a timer number, or nullptr. It decides how the number counts.
  const TimerUse* timer(std::uint32_t number) const;

  const Flow* main() const { return find(PouKind::Main, -1); }
  const Flow* subroutine(int number) const { return find(PouKind::Subroutine, number); }
  const Flow* interrupt(int number) const { return find(PouKind::Interrupt, number); }

 private:
  void number(const Instruction& instruction);
  const Flow* find(PouKind kind, int number) const;
};

}  // namespace rungproof
