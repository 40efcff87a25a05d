// Numbers that the manuals give for each CPU.
#pragma once

#include <cstdint>

namespace rungproof {

/// A set of small numbers, such as interrupt events or counters: bit n stands for number n.
using NumberSet = std::uint64_t;
constexpr NumberSet numbers(int low, int high) { return ((NumberSet{1} << (high - low + 1)) - 1) << low; }
constexpr bool contains(NumberSet set, int number) { return number >= 0 && number < 64 && (set >> number & 1) != 0; }

/// Numbers that the tables give per CPU. The initial values are those of most S7-200.
struct CpuFeatures {
  int subroutines = 64;         ///< count; numbers are 0..subroutines-1 (001:2666)
  int callable = 0;             ///< by table 6-78 (001:6751), where that is more
  int interruptRoutines = 128;  ///< 001:2667
  int labels = 256;             ///< 001:2665
  int edges = 256;              ///< EU plus ED (001:2668)
  int pidLoops = 8;             ///< 001:2669
  int ports = 1;                ///< 001:2670
  int queueCommunication = 4;   ///< 001:5487
  int queueIo = 16;             ///< 001:5488
  int queueTimed = 8;           ///< 001:5489
  int pulseOutputs = 2;
  bool clockBuiltIn = true;            ///< 001:565; without, TODR gives error 000C
  bool stopsInCompare = true;          ///< a compare contact that cannot compare is fatal (001:3384); else it is 0
  int stackLevels = 9;                 ///< levels of the logic stack (001:2753)
  int interruptNesting = 1;            ///< subroutine levels below an interrupt routine (001:5444)
  NumberSet counters = numbers(0, 5);  ///< high-speed counters (001:4166)
  NumberSet events = numbers(0, 33);   ///< interrupt events (001:5366)
  NumberSet unlistedEvents = 0;        ///< that stand in no list, and are refused in none
};

/// Of a family that has nothing of what is counted here but a stack.
inline constexpr CpuFeatures noFeatures = {.pulseOutputs = 0, .clockBuiltIn = false, .counters = 0, .events = 0};

}  // namespace rungproof
