// Columns to signals, cells to numbers.
#include "frontend/stimulus_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <set>

#include "frontend/csv_table.hpp"
#include "frontend/operand_reader.hpp"
#include "ir/library_block.hpp"

namespace rungproof {

namespace {

constexpr double largestTimeMs = 1e12;

std::string lowered(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
  return result;
}

/// "1", "-20", "16#FF", "2#1010", "1.5", "true"; nothing if it is no number.
std::optional<double> numberIn(std::string_view text) {
  const std::string lower = lowered(text);
  if (lower == "true") return 1;
  if (lower == "false") return 0;
  const auto whole = [](std::string_view digits, int base) -> std::optional<double> {
    std::uint64_t value = 0;
    if (digits.empty() || digits.size() > 64) return std::nullopt;
    for (const char c : digits) {
      if (c == '_') continue;
      const int digit = c >= '0' && c <= '9' ? c - '0' : c >= 'a' && c <= 'f' ? c - 'a' + 10 : 99;
      if (digit >= base || value >> 32 != 0) return std::nullopt;
      value = value * static_cast<unsigned>(base) + static_cast<unsigned>(digit);
    }
    return static_cast<double>(value);
  };
  if (lower.starts_with("16#")) return whole(std::string_view(lower).substr(3), 16);
  if (lower.starts_with("2#")) return whole(std::string_view(lower).substr(2), 2);
  std::size_t used = 0;
  try {
    const double value = std::stod(std::string(text), &used);
    const bool isPlain = lower.find_first_of("xp") == std::string::npos;
    return used == text.size() && isPlain ? std::optional<double>(value) : std::nullopt;
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

/// The value of a cell in the form of its signal, or the reason why it has none.
std::optional<double> valueIn(std::string_view text, const TraceSignal& signal, std::string& reason) {
  const std::optional<double> number = numberIn(text);
  if (!number) {
    reason = fmt::format("'{}' is no value for {}", text, signal.name);
    return std::nullopt;
  }
  if (signal.isReal()) return number;
  if (*number != std::floor(*number)) {
    reason = fmt::format("{} takes whole numbers, not {}", signal.name, text);
    return std::nullopt;
  }
  const double range = std::exp2(signal.width());
  const double low = signal.type == SignalType::Signed ? -range / 2 : 0;
  if (*number < low || *number >= range) {
    reason = signal.type == SignalType::Bool ? fmt::format("{} is a bit: 0 or 1, not {}", signal.name, text)
                                             : fmt::format("{} does not hold {}: the range is {:.0f} to {:.0f}", signal.name, text, low, range - 1);
    return std::nullopt;
  }
  return numberOf(valueOf(*number, signal.type, signal.width()), signal.type, signal.width());
}

bool isOpen(const std::string& text) { return text.empty() || text == "x" || text == "X"; }

/// What the columns of a file mean beside the signals.
struct Frame {
  bool isByTime = false;
  bool isRecorded = false;
  int scanMs = -1;
  int event = -1;
  std::vector<std::size_t> signals;  ///< indices of the other columns
};

class TableReader {
 public:
  TableReader(const std::string& name, std::string_view text, std::vector<Failure>& failures) : failures_(failures), table_(readCsv(name, text, failures)) {}

  Frame frame() {
    Frame frame;
    if (table_.heading.empty()) return frame;
    const std::string key = lowered(table_.heading[0].text);
    frame.isByTime = key == "time_ms";
    if (key != "scan" && key != "time_ms") fail(table_.heading[0], fmt::format("the first column is '{}'", table_.heading[0].text), "name it 'scan' or 'time_ms'");
    std::set<std::string> seen;
    for (std::size_t i = 0; i < table_.heading.size(); ++i) {
      const CsvCell& cell = table_.heading[i];
      const std::string name = lowered(cell.text);
      if (!seen.insert(name).second) fail(cell, fmt::format("column '{}' stands here twice", cell.text));
      if (i == 0) continue;
      if (name.empty()) fail(cell, "this column has no heading");
      if (name == "scan_ms") {
        frame.scanMs = static_cast<int>(i);
      } else if (name == "event") {
        frame.event = static_cast<int>(i);
      } else if (name == "time_ms" && i == 1 && !frame.isByTime) {
        frame.isRecorded = true;
      } else if (name == "time_ms" || name == "scan") {
        fail(cell, fmt::format("'{}' stands in the wrong place", cell.text), "it must be the first column, or time_ms the second behind scan");
      } else {
        frame.signals.push_back(i);
      }
    }
    return frame;
  }

  /// Key of a row; `last` is the key before. Scans count from 1, times in us.
  std::optional<std::uint64_t> key(const Frame& frame, const std::vector<CsvCell>& row, std::optional<std::uint64_t>& last) {
    const std::optional<double> number = numberIn(row[0].text);
    const bool isTime = frame.isByTime;
    if (!number || *number < (isTime ? 0 : 1) || *number > largestTimeMs || (!isTime && *number != std::floor(*number))) {
      fail(row[0], fmt::format("'{}' is no {}", row[0].text, isTime ? "time in ms" : "scan number"), isTime ? "" : "scans are counted from 1");
      return std::nullopt;
    }
    const auto value = static_cast<std::uint64_t>(std::llround(isTime ? *number * 1000 : *number));
    if (last && value <= *last) {
      fail(row[0], fmt::format("{} {} comes after {}", isTime ? "time" : "scan", row[0].text, isTime ? fmt::format("{:g} ms", static_cast<double>(*last) / 1000) : fmt::format("scan {}", *last)),
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

  std::vector<int> events(const CsvCell& cell, const Target& target) {
    std::vector<int> list;
    std::string text = cell.text;
    for (char& c : text) {
      if (c == ';' || c == '+') c = ' ';
    }
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t end = std::min(text.find(' ', at), text.size());
      const std::string word = text.substr(at, end - at);
      at = end + 1;
      if (isOpen(word)) continue;
      const std::optional<double> number = numberIn(word);
      if (number && *number == std::floor(*number) && *number >= 0 && *number < eventCount && eventExists(target, static_cast<int>(*number))) {
        list.push_back(static_cast<int>(*number));
      } else {
        fail(cell, fmt::format("'{}' is no interrupt event of CPU {}", word, cpuName(target.cpu)), "events are numbers from 0 to 33; several are separated by blanks");
      }
    }
    return list;
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
        fail(cell, fmt::format("'{}' is no character", word), "write codes from 0 to 255, texts in single quotes, or break, with blanks between them");
      }
    }
    return list;
  }

  std::optional<double> value(const CsvCell& cell, const TraceSignal& signal) {
    if (isOpen(cell.text)) return std::nullopt;
    std::string reason;
    const std::optional<double> result = valueIn(cell.text, signal, reason);
    if (!result) fail(cell, reason, signal.type == SignalType::Bool ? "write 0 or 1; leave the cell empty or write x where it does not matter" : "");
    return result;
  }

  void fail(const CsvCell& cell, std::string message, std::string help = {}) { failures_.push_back(table_.at(cell, std::move(message), std::move(help))); }
  const CsvTable& table() const { return table_; }

 private:
  std::vector<Failure>& failures_;
  CsvTable table_;
};

bool overlaps(const Operand& a, const Operand& b) {
  if (a.area != b.area) return false;
  if (a.area == Area::T || a.area == Area::C) return a.offset == b.offset;
  const auto range = [](const Operand& o) {
    const std::uint32_t first = o.offset * 8 + (o.width == Width::Bit ? o.bit : 0);
    return std::pair(first, first + static_cast<std::uint32_t>(bits(o.width)));
  };
  return range(a).first < range(b).second && range(b).first < range(a).second;
}

/// Whether some instruction writes the operand by its direct address.
bool isWritten(const Program& program, const Operand& operand) {
  for (const Pou& pou : program.pous) {
    for (const Network& network : pou.networks) {
      for (const Instruction& instruction : network.instructions) {
        for (std::size_t i = 0; i < instruction.operands.size(); ++i) {
          const bool writes = i >= instruction.desc->operandCount || instruction.desc->operands[i].direction != Direction::In;
          if (writes && instruction.operands[i].kind == OperandKind::Direct && overlaps(instruction.operands[i], operand)) return true;
        }
      }
    }
  }
  return false;
}

/// What a column of a recorded trace may set.
bool isSurrounding(const Program& program, const Operand& operand) {
  switch (operand.area) {
    case Area::I:
    case Area::AI: return true;
    case Area::V:
    case Area::M:
    case Area::S: return !isWritten(program, operand);
    case Area::SM: return operand.offset == 28 || operand.offset == 29;  // potentiometers (001:14162)
    default: return false;
  }
}

/// Type of the values of a column that stands for `type`.
SignalType signalTypeOf(DataType type) {
  switch (type) {
    case DataType::Bool: return SignalType::Bool;
    case DataType::Real: return SignalType::Real;
    case DataType::Byte: return SignalType::Unsigned;
    default: return SignalType::Signed;
  }
}

/// "BLOCK.Done" or "BLOCK.3" if the program calls a library block of that name.
std::optional<StimulusColumn> libraryColumn(const Program& program, const std::string& name) {
  const std::size_t dot = name.rfind('.');
  if (dot == std::string::npos) return std::nullopt;
  const std::string blockName = name.substr(0, dot);
  const LibraryBlock* block = libraryBlockNamed(blockName);
  if (block == nullptr) return std::nullopt;
  std::uint32_t position = libraryOutputNamed(*block, name.substr(dot + 1));
  const std::optional<double> number = numberIn(std::string_view(name).substr(dot + 1));
  if (number && *number >= block->first && *number < block->first + block->outputs.size()) position = static_cast<std::uint32_t>(*number);
  if (position == 0 || block->outputs[position - block->first].name.empty()) return std::nullopt;
  for (const Pou& pou : program.pous) {
    for (const Network& network : pou.networks) {
      for (const Instruction& instruction : network.instructions) {
        const bool isCall = instruction.desc->control == Control::Call && !instruction.operands.empty();
        if (!isCall || instruction.operands[0].kind != OperandKind::Symbol || lowered(instruction.operands[0].text) != lowered(blockName)) continue;
        StimulusColumn column;
        column.target = StimulusTarget::LibraryOutput;
        column.block = instruction.operands[0].text;
        column.position = position;
        const DataType type = block->outputs[position - block->first].type;
        column.signal.name = name;
        column.signal.operand = direct(Area::V, widthOf(type), 0);  // only its width counts
        column.signal.type = signalTypeOf(type);
        return column;
      }
    }
  }
  return std::nullopt;
}

/// "HSC0.pulses", "HSC0.down", "PORT0.receive", "NET.error", "NET.hold".
std::optional<StimulusColumn> deviceColumn(const std::string& name) {
  struct DeviceName {
    std::string_view before, after;
    StimulusTarget target;
    std::uint32_t count;  ///< how many there are; 0: no number in the name
  };
  static constexpr std::array<DeviceName, 5> names = {{{"hsc", ".pulses", StimulusTarget::Pulses, HighSpeedCounters::count},
                                                       {"hsc", ".down", StimulusTarget::DownPulses, HighSpeedCounters::count},
                                                       {"port", ".receive", StimulusTarget::Characters, 2},
                                                       {"net.error", "", StimulusTarget::NetworkError, 0},
                                                       {"net.hold", "", StimulusTarget::NetworkHold, 0}}};
  const std::string lower = lowered(name);
  for (const DeviceName& device : names) {
    if (!lower.starts_with(device.before) || !lower.ends_with(device.after)) continue;
    const std::string middle = lower.size() < device.before.size() + device.after.size()
                                   ? "?"
                                   : lower.substr(device.before.size(), lower.size() - device.before.size() - device.after.size());
    const bool isNumber = middle.size() == 1 && middle[0] >= '0' && static_cast<std::uint32_t>(middle[0] - '0') < device.count;
    if (device.count == 0 ? !middle.empty() : !isNumber) continue;
    StimulusColumn column;
    column.target = device.target;
    column.position = device.count == 0 ? 0 : static_cast<std::uint32_t>(middle[0] - '0');
    column.signal.name = name;
    column.signal.operand = direct(Area::V, Width::DWord, 0);  // only its width counts
    column.signal.type = SignalType::Unsigned;
    return column;
  }
  return std::nullopt;
}

}  // namespace

std::optional<TraceSignal> signalNamed(const Program& program, std::string_view name, Failure& failure) {
  std::string_view bare = name;
  const bool asValue = lowered(name).ends_with(".value");
  if (asValue) bare.remove_suffix(6);
  Operand operand;
  std::string symbolName;
  bool isKnown = readAddress(bare, Spelling::International, operand);
  if (!isKnown) {
    for (const Symbol& symbol : program.symbols) {
      if (lowered(symbol.name) != lowered(bare) || symbol.address.kind != OperandKind::Direct) continue;
      operand = symbol.address;
      symbolName = symbol.name;
      isKnown = true;
    }
  }
  isKnown = isKnown || readAddress(bare, Spelling::German, operand);
  if (!isKnown) {
    std::vector<std::string> names;
    for (const Symbol& symbol : program.symbols) names.push_back(symbol.name);
    const std::string_view meant = closest(bare, names);
    failure = {fmt::format("'{}' is no address and no symbol of the program", name), {}, meant.empty() ? "give the symbol table with --symbols, or write the address" : fmt::format("did you mean '{}'?", meant)};
    return std::nullopt;
  }
  const bool byNumber = operand.area == Area::T || operand.area == Area::C;
  if (asValue && !byNumber) {
    failure = {fmt::format("'.value' belongs to timers and counters, not to {}", bare)};
    return std::nullopt;
  }
  if (byNumber) operand.width = asValue ? Width::Word : Width::Bit;
  if (operand.area == Area::AI || operand.area == Area::AQ) operand.width = Width::Word;
  if (operand.area == Area::HC) operand.width = Width::DWord;
  if (operand.area == Area::L) {
    failure = {fmt::format("{} has no value between scans: local memory belongs to one call (001:1367)", name)};
    return std::nullopt;
  }
  if (!addressExists(program.target, operand.area, operand.width, operand.offset, operand.bit)) {
    failure = {fmt::format("{} does not exist on CPU {}", name, cpuName(program.target.cpu)), {}, "choose the CPU with --cpu"};
    return std::nullopt;
  }
  TraceSignal signal = signalOf(program, operand);
  signal.name = std::string(name);
  if (!symbolName.empty()) signal.symbol = symbolName;
  return signal;
}

Stimulus readStimulus(const std::string& name, std::string_view text, const Program& program, std::vector<Failure>& failures) {
  TableReader reader(name, text, failures);
  const Frame frame = reader.frame();
  Stimulus stimulus;
  stimulus.isByTime = frame.isByTime;
  for (const std::size_t i : frame.signals) {
    const CsvCell& cell = reader.table().heading[i];
    StimulusColumn column;
    if (auto library = libraryColumn(program, cell.text)) {
      column = *library;
    } else if (auto device = deviceColumn(cell.text)) {
      column = *device;
    } else {
      Failure failure;
      const std::optional<TraceSignal> signal = signalNamed(program, cell.text, failure);
      if (!signal) {
        reader.fail(cell, failure.message, failure.help);
        continue;
      }
      column.signal = *signal;
      const bool applies = !frame.isRecorded || isSurrounding(program, signal->operand);
      column.target = applies ? StimulusTarget::Memory : StimulusTarget::None;
    }
    stimulus.columns.push_back(column);
  }
  if (!failures.empty()) return stimulus;
  std::optional<std::uint64_t> last;
  for (const std::vector<CsvCell>& cells : reader.table().rows) {
    const std::optional<std::uint64_t> key = reader.key(frame, cells, last);
    StimulusRow row;
    (frame.isByTime ? row.timeUs : row.scan) = key.value_or(0);
    if (frame.scanMs >= 0) {
      const std::uint32_t us = reader.duration(cells[static_cast<std::size_t>(frame.scanMs)]);
      if (us != 0) row.scanUs = us;
    }
    if (frame.event >= 0) row.events = reader.events(cells[static_cast<std::size_t>(frame.event)], program.target);
    for (std::size_t k = 0; k < frame.signals.size(); ++k) {
      const StimulusColumn& column = stimulus.columns[k];
      const CsvCell& cell = cells[frame.signals[k]];
      const bool isText = column.target == StimulusTarget::Characters;
      row.values.push_back(isText ? std::nullopt : reader.value(cell, column.signal));
      if (!isText) continue;
      for (const int character : reader.characters(cell)) row.characters.emplace_back(column.position, character);
    }
    stimulus.rows.push_back(std::move(row));
  }
  return stimulus;
}

namespace {

Trace readTraceWith(const std::string& name, std::string_view text, std::vector<Failure>& failures,
                    const std::function<std::optional<TraceSignal>(const std::string&, Failure&)>& signalOfColumn) {
  TableReader reader(name, text, failures);
  const Frame frame = reader.frame();
  Trace trace;
  trace.isByTime = frame.isByTime;
  trace.hasTimes = frame.isByTime || frame.isRecorded;
  for (const std::size_t i : frame.signals) {
    Failure failure;
    const std::optional<TraceSignal> signal = signalOfColumn(reader.table().heading[i].text, failure);
    if (signal) {
      trace.signals.push_back(*signal);
    } else {
      reader.fail(reader.table().heading[i], failure.message, failure.help);
    }
  }
  if (!failures.empty()) return trace;
  std::optional<std::uint64_t> last;
  for (const std::vector<CsvCell>& cells : reader.table().rows) {
    const std::uint64_t key = reader.key(frame, cells, last).value_or(0);
    TraceRow row;
    (frame.isByTime ? row.timeUs : row.scan) = key;
    if (frame.isRecorded) {
      const std::optional<double> time = numberIn(cells[1].text);
      if (time && *time >= 0 && *time < largestTimeMs) row.timeUs = static_cast<std::uint64_t>(std::llround(*time * 1000));
    }
    if (frame.scanMs >= 0) row.scanUs = reader.duration(cells[static_cast<std::size_t>(frame.scanMs)]);
    for (std::size_t k = 0; k < frame.signals.size(); ++k) row.values.push_back(reader.value(cells[frame.signals[k]], trace.signals[k]));
    trace.rows.push_back(std::move(row));
  }
  return trace;
}

}  // namespace

Trace readTrace(const std::string& name, std::string_view text, const Program& program, std::vector<Failure>& failures) {
  return readTraceWith(name, text, failures, [&](const std::string& column, Failure& failure) { return signalNamed(program, column, failure); });
}

Trace readTrace(const std::string& name, std::string_view text, std::vector<Failure>& failures) {
  return readTraceWith(name, text, failures, [](const std::string& column, Failure&) {
    TraceSignal signal;
    signal.name = column;
    signal.type = SignalType::Number;
    return std::optional<TraceSignal>(signal);
  });
}

}  // namespace rungproof
