// Trace: the values of chosen signals at the end of every scan, recorded by a run, read from a file, or expected.
// Values are numbers as people write them: 0 and 1, unsigned bytes, signed words and double words (001:3371-3374),
// REAL. Covered by tests/trace/*.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/concrete.hpp"
#include "engine/trace_number.hpp"
#include "ir/program.hpp"

namespace rungproof {

class Simulator;

/// LongReal: LREAL. Number: any number, of a column that no program explains.
enum class SignalType : std::uint8_t { Bool, Unsigned, Signed, Real, LongReal, Number };
/// REAL or LREAL, by its width in bits.
constexpr SignalType realOf(int width) { return width == 64 ? SignalType::LongReal : SignalType::Real; }

/// One column of a trace.
struct TraceSignal {
  std::string name;    ///< column heading: address, or what the file calls it
  std::string symbol;  ///< name that the program has for the address, or empty
  Operand
      operand{};  ///< Direct; Missing in a trace that was read without a program. T and C: Bit, or Word for the value
  SignalType type = SignalType::Bool;

  int width() const { return operand.isMemory() ? bits(operand.width) : type == SignalType::Bool ? 1 : 32; }
  bool isReal() const { return type == SignalType::Real || type == SignalType::LongReal || type == SignalType::Number; }
};

struct TraceRow {
  std::uint64_t scan = 0;    ///< from 1; 0 in a trace that is keyed by time
  std::uint64_t timeUs = 0;  ///< end of the scan, since power-up; keyed by time: the moment as written
  std::uint32_t scanUs = 0;  ///< length of the scan, 0 if not known
  std::vector<std::optional<TraceNumber>> values;  ///< by signal; nothing: any value
  std::string events{};   ///< interrupts of the scan at their places, as a stimulus writes them
  std::string devices{};  ///< what devices wrote, as a stimulus writes it
  std::string given{};    ///< Trace::isWhole: what else the surroundings did, as a stimulus writes it
  /// Trace::hasTwoSides: the same of the second program; those above are the first one's.
  std::string newEvents{}, newDevices{}, newGiven{};
};

struct Trace {
  std::vector<TraceSignal> signals;
  std::vector<TraceRow> rows;
  bool isByTime = false;      ///< rows are keyed by time, not by scan
  bool isSampled = false;     ///< isByTime: of a logger; what it saw at a time holds from then on, until the next row
  bool hasTimes = true;       ///< TraceRow::timeUs is known
  bool hasTwoSides = false;   ///< of two programs
  bool hasDevices = false;    ///< devices did what TraceRow::devices says, and nothing else
  bool isWhole = false;       ///< TraceRow::given and startValues are known: a stimulus that repeats the run exactly
  std::string startValues{};  ///< isWhole: what memory and registers hold at the start beside what power-up leaves
  std::string newStartValues{};  ///< isWhole, hasTwoSides: of the second program
  /// Columns of the first row that only a stimulus needs: where clocks start ("CLOCK.tick", ms).
  std::vector<std::pair<std::string, std::uint64_t>> start{};
  bool hasEvents() const {
    return std::any_of(rows.begin(), rows.end(),
                       [](const TraceRow& row) { return !row.events.empty() || !row.newEvents.empty(); });
  }

  /// Interrupts that come at different places of two programs.
  bool hasTwoEvents() const {
    return hasTwoSides &&
           std::any_of(rows.begin(), rows.end(), [](const TraceRow& row) { return row.events != row.newEvents; });
  }

  /// Index of the signal of that name or symbol (case does not matter), or -1.
  int signalNamed(std::string_view name) const;
  /// Index of the signal with the same operand, else of the same name or symbol, or -1.
  int indexOf(const TraceSignal& signal) const;
};

/// The signal of a direct operand, named by its address ("T37.value" for a current value). Its type follows from the
/// width, or is REAL where the program uses it so.
TraceSignal signalOf(const Program& program, const Operand& operand);
/// All signals that the program touches by direct addresses: inputs first, then outputs, timers, counters, memory; each
/// group in order of address. L and AC are left out, they have no value between scans.
std::vector<TraceSignal> touchedSignals(const Program& program);

/// The number that `width` bits mean, and back; numbers outside the range are reduced to the width.
TraceNumber numberOf(std::uint64_t value, SignalType type, int width);
std::uint64_t valueOf(TraceNumber number, SignalType type, int width);
/// "1", "-20", "1.5": shortest text that reads back as the same number.
std::string numberText(TraceNumber number, SignalType type);
void appendNumber(TraceNumber number, SignalType type, std::string& text);

/// Values of the signals in a state at the end of a scan. In STOP, Q shows the physical outputs.
std::vector<std::optional<TraceNumber>> sampleValues(const Concrete::Store& store,
                                                     const std::vector<TraceSignal>& signals);
/// The same with number, time and length of the simulator's last scan.
TraceRow sampleRow(const Simulator& simulator, const std::vector<TraceSignal>& signals);
/// The same into a row that is there.
void sampleRow(const Simulator& simulator, const std::vector<TraceSignal>& signals, TraceRow& row);

}  // namespace rungproof
