// What a family of controllers is asked by those who do not know it by name. Each member is a question that any family
// can answer; the answers stand in the dialect object of the family (ir/s7200/dialect.cpp, ir/s7300/dialect.cpp,
// ir/iec/dialect.cpp), so that a further family is a further folder.
// Tested by tests/ir/dialect_test.cpp; tests/layout holds that nobody compares a family by its name.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "ir/address_limit.hpp"
#include "ir/cpu_features.hpp"
#include "ir/hazard.hpp"
#include "ir/retentive_range.hpp"
#include "ir/target.hpp"

namespace rungproof {

struct Choices;
struct Pou;
struct Program;

/// What the instructions of a program work on, which decides how its text is followed.
enum class StatementForm : std::uint8_t {
  Rungs,         ///< contacts and boxes on a stack of bits, the logic stack; each network begins with an empty one
  Accumulators,  ///< statements on a result of logic operation and accumulators, which networks hand on
  Expressions    ///< values on a stack that is empty between statements; an instruction is no line of the source
};

/// What counts time and events.
enum class Counting : std::uint8_t {
  Boxes,     ///< boxes that count up in ticks of 1, 10 or 100 ms, when the CPU or the box itself refreshes them
  Elements,  ///< numbered timers that run down in ms once a statement has started them, counters from 0 to 999
  Instances  ///< instances of function blocks, whose data are variables; they look at the clock when they are called
};

struct MemoryModel {
  bool isOfVariables;       ///< data are variables with names; where one lies is known to the tool only
  bool hasDataBlocks;       ///< data lie in numbered blocks too; those of a function block in its instance
  bool hasSpecialMemory;    ///< the CPU tells the program about itself in bits and bytes of SM
  bool hasTerminals;        ///< PI and PQ are the terminals of the CPU; otherwise areas that statements can name
  bool declaresLocals;      ///< each block says how many bytes of local memory it needs; otherwise the CPU gives L
  bool numbersArePointers;  ///< any number can be used as an address; otherwise addresses come from & only
  bool pointersMayMiss;     ///< behind a pointer may be a module that does not answer or a block that is read only
  int numberBits;           ///< longest numbers that instructions compute with
  bool (*samplesAtRead)(const Target&);  ///< each read of an analog input finds a new value; otherwise the CPU filters
  Area analogInputs;                     ///< whose words are the values at the analog inputs
  std::optional<AddressLimit> (*addressLimit)(const Target&, Area, Width);
  bool (*addressExists)(const Target&, Area, Width, std::uint32_t offset, unsigned bit);
  std::uint32_t (*gapBehind)(const Target&, Area, std::uint32_t offset);  ///< the first byte of the next one; 0: none
  /// What keeps its value where the project says nothing.
  std::vector<RetentiveRange> (*usuallyRetentive)(const Target&);
  /// What of the program keeps its value, where the CPU is set to keep these ranges.
  std::vector<RetentiveRange> (*retentive)(const Program&, std::vector<RetentiveRange>);
};

struct RunModel {
  Counting counting;
  bool startsBlocks;  ///< the system starts blocks by their number, organization blocks; otherwise ATCH attaches them
  bool ranksEvents;   ///< an event of higher priority interrupts the routine that runs
  bool runsWithoutMain;  ///< what the system starts runs even if there is no main program
  bool keepsLastScan;    ///< a program can ask how long the last scan took, whatever its memory holds
  bool restartsWarm;     ///< a change to RUN begins anew: what is not retentive is as after a download
  bool hasWatchdog;      ///< a scan that lasts too long is an error; otherwise only one that can never end
  Hazard endlessScan;    ///< the error of a scan that lasts too long or never ends
  bool listsTimes;       ///< the manual lists how long each instruction runs (Desc::time)
  CpuFeatures (*features)(const Target&);
  std::uint32_t usualTime;  ///< 10 ns, of an instruction whose time is not listed
  /// ms after which the watchdog ends a scan.
  int (*watchdogMs)(const Program&, const Choices&);
  /// ms that no scan exceeds, whatever restarts the watchdog.
  int (*longestScanMs)(const Target&, const Choices&);
  /// ms that the scans of proofs may last, where nobody has said how long they last.
  std::uint32_t (*scanLimitMs)(const Program&, const Choices&);
  /// How deep calls may nest below a block that something beside the program starts; nothing: none starts this one.
  std::optional<int> (*nesting)(const Target&, const Pou&);
  std::string_view tooDeep;   ///< what comes of a deeper call, as the end of a sentence
  std::string_view notAsked;  ///< of which scans proofs ask nothing where an error can cut one off, as a sentence
};

/// What people see of a program.
struct TextModel {
  bool hasProducts;      ///< its CPUs are products, so that people name the one they have
  bool quotesSymbols;    ///< statements set symbols in quotation marks; otherwise a name must not look like an address
  bool labelsAreNames;   ///< a label is a name in front of a statement; otherwise a number that an instruction has
  bool keepsFaults;      ///< the editor keeps networks that it cannot compile
  bool hasSystemBlocks;  ///< CPU and library bring blocks of their own, of which some are known by contract only
  /// Whether the text of a block is not the program's own: a library's, or what the reader has added.
  bool (*isForeign)(const Program&, const Pou&);
};

}  // namespace rungproof
