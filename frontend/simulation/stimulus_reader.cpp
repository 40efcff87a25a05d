// Tables to stimuli and traces.
#include "frontend/simulation/stimulus_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "frontend/logger/csv_table.hpp"
#include "frontend/logger/recording.hpp"
#include "frontend/logger/trace_cell.hpp"
#include "frontend/simulation/event_place.hpp"
#include "frontend/simulation/given_columns.hpp"
#include "frontend/simulation/run_limits.hpp"
#include "frontend/simulation/stimulus_column.hpp"
#include "ir/s7200/cpu.hpp"
#include "ir/s7300/organization_block.hpp"

namespace rungproof {

namespace {

constexpr double largestTimeMs = 1e12;
constexpr double mostAtOnce = 1000;        ///< events of one kind
constexpr double mostPulses = 12'000'000;  ///< of a counter in one scan: 200 kHz for 60 s, the longest scan

/// Columns that are no signals.
bool isOwnColumn(std::string_view name) {
  constexpr std::string_view names[] = {"scan", "time_ms", "scan_ms", "event", "device", "given", "start"};
  return std::ranges::find(names, name) != std::end(names);
}

bool isOpen(const std::string& text) { return text.empty() || text == "x" || text == "X"; }

/// What the columns of a file mean beside the signals.
struct Frame {
  bool isByTime = false;
  bool isRecorded = false;
  int scanMs = -1;
  int event = -1;
  int device = -1;
  int given = -1;  ///< all that the surroundings do: a witness
  int start = -1;
  std::vector<std::size_t> signals;  ///< indices of the other columns
};

class TableReader {
 public:
  TableReader(const std::string& name, std::string_view text, std::vector<Failure>& failures, std::string_view side,
              const TraceImport& import)
      : failures_(failures), table_(readRecording(name, text, import, failures)) {
    for (std::size_t i = 0; i < table_.heading.size(); ++i) {
      std::string& heading = table_.heading[i].text;
      const std::string prefix = lowered(heading.substr(0, heading.find('.') + 1));
      if (side.empty() || (prefix != "old." && prefix != "new.")) continue;
      if (prefix.starts_with(side))
        heading.erase(0, prefix.size());
      else
        others_.insert(i);
    }
  }

  Frame frame() {
    Frame frame;
    if (table_.heading.empty()) return frame;
    const std::string key = lowered(table_.heading[0].text);
    frame.isByTime = key == "time_ms";
    if (key != "scan" && key != "time_ms")
      fail(table_.heading[0], fmt::format("the first column is '{}'", table_.heading[0].text),
           "name it 'scan' or 'time_ms'");
    std::set<std::string> seen, signals;
    const auto hasHeading = [&](std::string_view name) {
      return std::ranges::any_of(table_.heading, [&](const CsvCell& cell) { return lowered(cell.text) == name; });
    };
    const bool isWitness = hasHeading("given") && hasHeading("start");  // one alone may be a symbol
    for (std::size_t i = 0; i < table_.heading.size(); ++i) {
      if (others_.contains(i)) continue;
      const CsvCell& cell = table_.heading[i];
      const std::string name = lowered(cell.text);
      if (!seen.insert(name).second) {
        // A variable of the program may be called like a column of witnesses, which stands in front of it.
        const bool isVariable = isWitness && isOwnColumn(name) && signals.insert(name).second;
        if (isVariable)
          frame.signals.push_back(i);
        else
          fail(cell, fmt::format("column '{}' stands here twice", cell.text), "take one of the two out");
        continue;
      }
      if (i == 0) continue;
      if (name.empty()) {
        fail(cell, "this column has no heading", "write the name of its signal in the first row");
      } else if (name == "scan_ms") {
        frame.scanMs = static_cast<int>(i);
      } else if (name == "event") {
        frame.event = static_cast<int>(i);
      } else if (name == "device") {
        frame.device = static_cast<int>(i);
      } else if (isWitness && name == "given") {
        frame.given = static_cast<int>(i);
      } else if (isWitness && name == "start") {
        frame.start = static_cast<int>(i);
      } else if (name == "time_ms" && i == 1 && !frame.isByTime) {
        frame.isRecorded = true;
      } else if (name == "time_ms" || name == "scan") {
        fail(cell, fmt::format("'{}' stands in the wrong place", cell.text),
             "it must be the first column, or time_ms the second behind scan");
      } else {
        frame.signals.push_back(i);
      }
    }
    return frame;
  }

  /// Key of a row; `last` is the key before. Scans count from 1, times in us.
  std::optional<std::uint64_t> key(const Frame& frame, const std::vector<CsvCell>& row,
                                   std::optional<std::uint64_t>& last) {
    const std::optional<double> number = numberIn(row[0].text);
    const bool isTime = frame.isByTime;
    if (!number || *number < (isTime ? 0 : 1) || *number > largestTimeMs ||
        (!isTime && *number != std::floor(*number))) {
      fail(row[0], fmt::format("'{}' is no {}", row[0].text, isTime ? "time in ms" : "scan number"),
           isTime ? "write milliseconds from 0 on" : "scans are counted from 1");
      return std::nullopt;
    }
    if (!isTime && *number > static_cast<double>(mostScans)) {
      fail(row[0], fmt::format("scan {} is beyond the longest run", row[0].text),
           fmt::format("a run has at most {} scans", mostScans));
      return std::nullopt;
    }
    const auto value = static_cast<std::uint64_t>(std::llround(isTime ? *number * 1000 : *number));
    if (last && value <= *last) {
      fail(row[0],
           fmt::format(
               "{} {} comes after {}", isTime ? "time" : "scan", row[0].text,
               isTime ? fmt::format("{:g} ms", static_cast<double>(*last) / 1000) : fmt::format("scan {}", *last)),
           "rows must stand in ascending order");
      return std::nullopt;
    }
    last = value;
    return value;
  }

  /// A duration in ms as us; 0: none.
  std::uint32_t duration(const CsvCell& cell) {
    if (isOpen(cell.text)) return 0;
    const std::optional<double> number = numberIn(cell.text);
    if (number && *number >= 0.001 && *number <= 60000) return static_cast<std::uint32_t>(std::llround(*number * 1000));
    fail(cell, fmt::format("'{}' is no length of a scan", cell.text), "give the length in ms, at most 60000");
    return 0;
  }

  /// An event by its number, of an S7-300/400 by that of the organization block that it starts.
  static std::optional<int> eventNamed(std::optional<double> number, const Target& target) {
    if (!number || *number != std::floor(*number) || *number < 0 || *number > 255) return std::nullopt;
    const int named = static_cast<int>(*number),
              event = dialectOf(target).run.startsBlocks ? eventOfBlock(named) : named;
    const bool exists = dialectOf(target).run.startsBlocks ? event >= 0 && s7300::startsOn(named, target.cpu)
                                                           : event < eventCount && eventExists(target, event);
    return exists ? std::optional(event) : std::nullopt;
  }

  /// Interrupts at the start of the scan, and those that stand at a place in it ("10@17").
  void events(const CsvCell& cell, const Program& program, StimulusRow& row) {
    std::string text = cell.text;
    for (char& c : text) {
      if (c == ';' || c == '+') c = ' ';
    }
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t end = std::min(text.find(' ', at), text.size());
      std::string word = text.substr(at, end - at);
      at = end + 1;
      if (isOpen(word)) continue;
      bool isFromQueue = false, isWithNext = false;
      std::size_t count = 1;  // "3x10": three at once
      if (const std::size_t times = word.find('x'); times != std::string::npos && times > 0) {
        const std::optional<double> many = numberIn(std::string_view(word).substr(0, times));
        if (many && *many == std::floor(*many) && *many >= 1 && *many <= mostAtOnce) {
          count = static_cast<std::size_t>(*many);
          word.erase(0, times + 1);
        }
      }
      if (word.starts_with('q')) isFromQueue = true, word.erase(0, 1);
      if (word.starts_with('&')) isWithNext = true, word.erase(0, 1);
      const std::size_t mark = word.find('@');
      const std::optional<double> number = numberIn(std::string_view(word).substr(0, mark));
      const std::optional<int> event = eventNamed(number, program.target);
      if (!event) {
        fail(cell, fmt::format("'{}' is no interrupt event of CPU {}", word, cpuName(program.target.cpu)),
             dialectOf(program.target).run.startsBlocks
                 ? "events are the numbers of organization blocks such as 40; several are "
                   "separated by blanks"
                 : fmt::format("events are numbers from 0 to {}; several are separated by blanks",
                               lastEvent(program.target)));
        continue;
      }
      if (mark == std::string::npos) {
        row.events.insert(row.events.end(), count, *event);
      } else if (const auto place = scanPlaceNamed(program, std::string_view(word).substr(mark + 1))) {
        row.placed.insert(row.placed.end(), count, {*place, *event, true, isFromQueue});
        row.placed.back().isWithNext = isWithNext;
      } else {
        fail(cell, fmt::format("no instruction stands at '{}'", word.substr(mark + 1)),
             "write EVENT@LINE for an event in front of the instruction in that line of the program, or EVENT@end");
      }
    }
  }

  /// What devices write: "VB101=83 SMB86=2" at the start of the scan, "SMB86=2@17" at a place in it.
  void writes(const CsvCell& cell, const Program& program, StimulusRow& row) {
    for (std::size_t at = 0; at < cell.text.size();) {
      const std::size_t end = std::min(cell.text.find(' ', at), cell.text.size());
      const std::string word = cell.text.substr(at, end - at);
      at = end + 1;
      if (isOpen(word)) continue;
      const std::size_t equals = word.find('='), mark = word.find('@');
      Failure failure;
      const std::optional<TraceSignal> signal = signalNamed(program, word.substr(0, equals), failure);
      const std::optional<double> number =
          equals == std::string::npos ? std::nullopt : numberIn(word.substr(equals + 1, mark - equals - 1));
      const std::optional<ScanPlace> place = mark == std::string::npos
                                                 ? ScanPlace{ScanPlace::startOfScan}
                                                 : scanPlaceNamed(program, std::string_view(word).substr(mark + 1));
      const bool fits = signal && number && *number >= 0 && *number == std::floor(*number) &&
                        bits(signal->operand.width) <= 8 && *number < std::exp2(bits(signal->operand.width));
      if (fits && place)
        row.writes.push_back({*place, signal->operand, static_cast<std::uint64_t>(*number)});
      else
        fail(cell, fmt::format("'{}' is no write of a device", word),
             "write ADDRESS=VALUE for a bit or byte at the start of the scan, or ADDRESS=VALUE@LINE");
    }
  }

  /// "65 'BC' 16#0A break": numbers, texts in quotes and breaks.
  std::vector<int> characters(const CsvCell& cell) {
    std::vector<int> list;
    const std::string& text = cell.text;
    for (std::size_t at = 0; at < text.size();) {
      if (text[at] == ' ') {
        ++at;
        continue;
      }
      const bool isQuoted = text[at] == '\'';
      const std::size_t end = std::min(isQuoted ? text.find('\'', at + 1) : text.find(' ', at), text.size());
      const std::string word = text.substr(at + (isQuoted ? 1 : 0), end - at - (isQuoted ? 1 : 0));
      at = end + 1;
      if (isQuoted) {
        for (const char c : word) list.push_back(static_cast<unsigned char>(c));
        continue;
      }
      const std::optional<double> number = numberIn(word);
      if (lowered(word) == "break") {
        list.push_back(SerialPorts::breakSignal);
      } else if (number && *number == std::floor(*number) && *number >= 0 && *number <= 255) {
        list.push_back(static_cast<int>(*number));
      } else {
        fail(cell, fmt::format("'{}' is no character", word),
             "write codes from 0 to 255, texts in single quotes, or break, with blanks between them");
      }
    }
    return list;
  }

  std::optional<TraceNumber> value(const CsvCell& cell, const TraceSignal& signal) {
    if (isOpen(cell.text)) return std::nullopt;
    std::string reason;
    const std::optional<TraceNumber> result = valueIn(cell.text, signal, reason);
    if (!result)
      fail(cell, reason,
           signal.type == SignalType::Bool
               ? "write 0 or 1; leave the cell empty or write x where it does not matter"
               : "write a number of its type; leave the cell empty or write x where it does not matter");
    return result;
  }

  /// What the engine asks for in the scan, and in the first row what it begins with.
  void given(const Frame& frame, const std::vector<CsvCell>& cells, GivenReader& reader, StimulusRow& row,
             Stimulus& stimulus) {
    Failure failure;
    const CsvCell& cell = cells[static_cast<std::size_t>(frame.given)];
    if (!reader.readGiven(cell.text, row, failure)) fail(cell, failure.message, failure.help);
    const CsvCell& start = cells[static_cast<std::size_t>(frame.start)];
    if (!isOpen(start.text) && (frame.isByTime || row.scan != 1))
      fail(start, "values at the start stand in scan 1", "leave the cell empty");
    else if (!reader.readStart(start.text, stimulus.start, failure))
      fail(start, failure.message, failure.help);
  }

  void fail(const CsvCell& cell, std::string message, std::string help = {}) {
    failures_.push_back(table_.at(cell, std::move(message), std::move(help)));
  }
  const CsvTable& table() const { return table_; }

 private:
  std::vector<Failure>& failures_;
  CsvTable table_;
  std::set<std::size_t> others_;  ///< columns of the other one of two programs
};

}  // namespace

Stimulus readStimulus(const std::string& name, std::string_view text, const Program& program,
                      std::vector<Failure>& failures, std::string_view side, const TraceImport& import) {
  Stimulus stimulus;
  TableReader reader(name, text, failures, side, import);
  if (!failures.empty()) return stimulus;
  Frame frame = reader.frame();
  stimulus.isByTime = frame.isByTime;
  stimulus.isWhole = frame.given >= 0;
  stimulus.isScripted = frame.device >= 0 || stimulus.isWhole;
  GivenReader given(program);
  std::vector<std::size_t> unknown;
  for (const std::size_t i : frame.signals) {
    const CsvCell& cell = reader.table().heading[i];
    Failure failure;
    const bool isTrace = frame.isRecorded || reader.table().isRecording;
    if (const auto column = stimulusColumn(program, cell.text, isTrace, failure)) {
      // A trace may show a place twice: what it says of it agrees.
      const StimulusColumn* const other = isTrace || stimulus.isWhole ? nullptr : sharedWith(stimulus.columns, *column);
      if (other != nullptr) reader.fail(cell, samePlaceText(other->signal.name, cell.text), "take one of the two out");
      stimulus.columns.push_back(*column);
      const bool sets = column->target == StimulusTarget::Memory && isInputColumn(column->signal.operand);
      if (stimulus.isWhole && !sets) stimulus.columns.back().target = StimulusTarget::None;  // `given` has it
    } else if (import.dropsUnknown) {
      unknown.push_back(i);
    } else {
      reader.fail(cell, failure.message, failure.help);
    }
  }
  if (!failures.empty()) return stimulus;
  std::erase_if(frame.signals, [&](std::size_t i) { return std::ranges::find(unknown, i) != unknown.end(); });
  std::optional<std::uint64_t> last;
  for (const std::vector<CsvCell>& cells : reader.table().rows) {
    const std::optional<std::uint64_t> key = reader.key(frame, cells, last);
    StimulusRow row;
    (frame.isByTime ? row.timeUs : row.scan) = key.value_or(0);
    if (frame.scanMs >= 0) {
      const std::uint32_t us = reader.duration(cells[static_cast<std::size_t>(frame.scanMs)]);
      if (us != 0) row.scanUs = us;
    }
    if (frame.device >= 0) reader.writes(cells[static_cast<std::size_t>(frame.device)], program, row);
    if (frame.given >= 0) reader.given(frame, cells, given, row, stimulus);
    if (frame.event >= 0) reader.events(cells[static_cast<std::size_t>(frame.event)], program, row);
    stimulus.isScripted = stimulus.isScripted || !row.placed.empty();
    for (std::size_t k = 0; k < frame.signals.size(); ++k) {
      const StimulusColumn& column = stimulus.columns[k];
      const CsvCell& cell = cells[frame.signals[k]];
      const bool isText = column.target == StimulusTarget::Characters;
      row.values.push_back(isText ? std::nullopt : reader.value(cell, column.signal));
      const bool isPulses = column.target == StimulusTarget::Pulses || column.target == StimulusTarget::DownPulses;
      if (isPulses && row.values.back().value_or(0) > mostPulses)
        reader.fail(cell, fmt::format("{} pulses are more than a counter can count in one scan", cell.text),
                    fmt::format("at most {:.0f}: 200 kHz for 60 s", mostPulses));
      if (!isText) continue;
      for (const int character : reader.characters(cell)) row.characters.emplace_back(column.position, character);
    }
    stimulus.rows.push_back(std::move(row));
  }
  return stimulus;
}

namespace {

/// Times of a trace that counts scans: each lasts as long as its row or the last row before it says, 10 ms without one.
class ScanClock {
 public:
  std::uint64_t endOf(const TraceRow& row) {
    if (row.scan > scan_) timeUs_ += (row.scan - scan_ - 1) * scanUs_;
    if (row.scanUs != 0) scanUs_ = row.scanUs;
    if (row.scan > scan_) timeUs_ += scanUs_;
    scan_ = std::max(scan_, row.scan);
    return timeUs_;
  }

 private:
  std::uint64_t scan_ = 0, timeUs_ = 0, scanUs_ = 10'000;
};

Trace readTraceWith(const std::string& name, std::string_view text, std::vector<Failure>& failures,
                    std::string_view side, const TraceImport& import,
                    const std::function<std::optional<TraceSignal>(const std::string&, Failure&)>& signalOfColumn) {
  const std::size_t before = failures.size();
  TableReader reader(name, text, failures, side, import);
  if (failures.size() > before) return {};
  Frame frame = reader.frame();
  // Where clocks start is for stimuli only.
  std::erase_if(frame.signals,
                [&](std::size_t i) { return lowered(reader.table().heading[i].text).starts_with("clock."); });
  std::vector<std::size_t> unknown;
  ScanClock clock;
  Trace trace;
  trace.isByTime = frame.isByTime;
  trace.isSampled = frame.isByTime && reader.table().isRecording;
  trace.hasTimes = frame.isByTime || frame.isRecorded;
  for (const std::size_t i : frame.signals) {
    Failure failure;
    const std::optional<TraceSignal> signal = signalOfColumn(reader.table().heading[i].text, failure);
    if (signal) {
      trace.signals.push_back(*signal);
    } else if (import.dropsUnknown) {
      unknown.push_back(i);
    } else {
      reader.fail(reader.table().heading[i], failure.message, failure.help);
    }
  }
  if (!failures.empty()) return trace;
  std::erase_if(frame.signals, [&](std::size_t i) { return std::ranges::find(unknown, i) != unknown.end(); });
  std::optional<std::uint64_t> last;
  for (const std::vector<CsvCell>& cells : reader.table().rows) {
    const std::uint64_t key = reader.key(frame, cells, last).value_or(0);
    TraceRow row;
    (frame.isByTime ? row.timeUs : row.scan) = key;
    if (frame.isRecorded) {
      const std::optional<double> time = numberIn(cells[1].text);
      if (time && *time >= 0 && *time < largestTimeMs)
        row.timeUs = static_cast<std::uint64_t>(std::llround(*time * 1000));
    }
    if (frame.scanMs >= 0) row.scanUs = reader.duration(cells[static_cast<std::size_t>(frame.scanMs)]);
    if (!trace.hasTimes) row.timeUs = clock.endOf(row);
    for (std::size_t k = 0; k < frame.signals.size(); ++k)
      row.values.push_back(reader.value(cells[frame.signals[k]], trace.signals[k]));
    trace.rows.push_back(std::move(row));
  }
  return trace;
}

}  // namespace

Trace readTrace(const std::string& name, std::string_view text, const Program& program, std::vector<Failure>& failures,
                std::string_view side, const TraceImport& import) {
  return readTraceWith(name, text, failures, side, import, [&](const std::string& column, Failure& failure) {
    return signalNamed(program, column, failure);
  });
}

Trace readTrace(const std::string& name, std::string_view text, std::vector<Failure>& failures,
                const TraceImport& import, std::span<const Symbol> symbols) {
  return readTraceWith(name, text, failures, {}, import, [&](const std::string& column, Failure&) {
    return std::optional<TraceSignal>(signalWithoutProgram(column, symbols));
  });
}

}  // namespace rungproof
