// Tables and traces of witnesses.
#include "frontend/simulation/witness_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <sstream>
#include <system_error>

#include "engine/device_end.hpp"
#include "engine/platform/names.hpp"
#include "frontend/command.hpp"
#include "frontend/simulation/event_place.hpp"
#include "frontend/simulation/given_columns.hpp"
#include "frontend/simulation/library_columns.hpp"
#include "frontend/text/text_stream.hpp"
#include "frontend/trace_format.hpp"
#include "ir/iec/cpu.hpp"
#include "ir/iec/variables.hpp"
#include "ir/s7300/clock_memory.hpp"

namespace rungproof {

namespace {

bool matters(const Witness& witness, std::size_t scan, std::size_t input) {
  return witness.matters.empty() ? witness.scans[scan].inputs[input].value != 0 : witness.matters[scan][input];
}

/// Whether the signal is an input of the scan that may have any value; of several bytes none may matter.
bool isIdle(const Witness& witness, std::size_t scan, const Operand& signal) {
  if (witness.matters.empty()) return false;
  const std::vector<PresetValue>& inputs = witness.scans[scan].inputs;
  bool isInput = false;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const bool isSame = toString(inputs[i].operand) == toString(signal);
    const bool isPart =
        signal.area == Area::V && inputs[i].operand.width == Width::Byte && coversByte(signal, inputs[i].operand);
    if (!isSame && !isPart) continue;
    if (witness.matters[scan][i]) return false;
    isInput = true;
  }
  return isInput;
}

/// The same texts for sure: the same events and the same bits of every number.
bool areSame(const TraceRow& a, const TraceRow& b) {
  const auto isEqual = [](const std::optional<TraceNumber>& x, const std::optional<TraceNumber>& y) {
    if (!x || !y) return x.has_value() == y.has_value();
    const bool isAlike = *x == *y || (std::isnan(*x) && std::isnan(*y));
    return isAlike && std::signbit(*x) == std::signbit(*y);
  };
  return a.events == b.events && a.newEvents == b.newEvents && a.devices == b.devices &&
         std::equal(a.values.begin(), a.values.end(), b.values.begin(), b.values.end(), isEqual);
}

}  // namespace

Trace traceOf(const Program& program, const Choices& choices, const Witness& witness,
              const std::vector<TraceSignal>& signals, std::size_t limit, bool hidesIdle) {
  Trace trace;
  trace.signals = signals;
  const LibraryColumns libraries(program, witness);
  trace.signals.insert(trace.signals.end(), libraries.signals().begin(), libraries.signals().end());
  trace.hasDevices = asksDevices(program);
  for (const auto& [reg, name] :
       {std::pair{Reg::PhaseHundred, "CLOCK.tick"}, std::pair{Reg::PhaseSecond, "CLOCK.second"},
        std::pair{Reg::PhaseMinute, "CLOCK.minute"}}) {
    const std::uint64_t phase = witness.initial ? witness.initial->get(reg, 0) : 0;
    if (phase != 0) trace.start.emplace_back(name, phase);
  }
  for (std::uint32_t bit = 0; witness.initial && bit < clockPeriods.size(); ++bit) {
    const std::uint64_t phase = witness.initial->get(Reg::ClockPhase, bit);
    if (phase != 0) trace.start.emplace_back(fmt::format("CLOCK.bit{}", bit), phase);
  }
  std::uint64_t scan = 0, timeUs = 0;
  const std::uint64_t skipped = witness.scanCount > limit ? witness.scanCount - limit : 0;
  replay(program, choices, witness.scans, witness.initial ? &*witness.initial : nullptr,
         [&](const Concrete::Store& state, std::size_t at) {
           const std::uint32_t scanUs = witness.scans[at].lengthMs * 1000;
           timeUs += scanUs;
           if (++scan <= skipped) return true;
           TraceRow row{scan, timeUs, scanUs, {}, {}};
           row.events = eventsText(program, witness.scans[at].script.events);
           for (const ScanScript::Write& write : witness.scans[at].script.writes)
             row.devices += (row.devices.empty() ? "" : " ") + writeText(program, write);
           // In STOP `sim` shows the terminals, which are off; the table shows the image that properties see.
           const bool isOff = !hidesIdle && state.get(Reg::Running, 0) == 0;
           for (const TraceSignal& signal : signals) {
             row.values.push_back(isOff && signal.operand.area == Area::Q
                                      ? sampleValues(state, {signal}).front()
                                      : numberOf(valueIn(state, signal.operand), signal.type, signal.width()));
             if (hidesIdle && isIdle(witness, at, signal.operand)) row.values.back().reset();
           }
           for (const std::optional<TraceNumber>& value : libraries.valuesIn(at)) row.values.push_back(value);
           trace.rows.push_back(std::move(row));
           return true;
         });
  return trace;
}

std::vector<TraceSignal> signalsThatMatter(const Program& program, const ProofResult& result) {
  std::vector<TraceSignal> signals;
  const auto add = [&](Operand operand) {
    if (operand.area == Area::L) return;
    operand = wholeVariable(program, operand);
    if (operand.area == Area::AC) operand.width = Width::DWord;
    TraceSignal signal = signalOf(program, operand);
    if (std::none_of(signals.begin(), signals.end(), [&](const TraceSignal& s) { return s.name == signal.name; }))
      signals.push_back(std::move(signal));
  };
  if (result.witness) {
    for (std::size_t s = 0; s < result.witness->scans.size(); ++s) {
      const std::vector<PresetValue>& inputs = result.witness->scans[s].inputs;
      for (std::size_t i = 0; i < inputs.size(); ++i) {
        if (matters(*result.witness, s, i)) add(inputs[i].operand);
      }
    }
  }
  for (const Expr* expr : {&result.property.first, &result.property.second}) {
    for (const ExprNode& node : expr->nodes) {
      if (node.op != ExprOp::Address) continue;
      Operand operand = node.operand;
      if (hasBitAndWord(operand.area) && node.type == ExprType::Number && operand.width == Width::Bit)
        operand.width = Width::Word;
      add(operand);
    }
  }
  if (result.builtin && result.builtin->place != nullptr) {
    for (const Operand& operand : result.builtin->place->operands) {
      if (operand.kind == OperandKind::Direct) add(operand);
    }
  }
  return signals;
}

std::string startText(const Program& program, const Choices& choices, const Witness& witness) {
  if (!witness.initial) return "";
  const std::vector<StartCell> cells = startCells(program, choices, *witness.initial);
  std::string text;
  for (const TraceSignal& signal : touchedSignals(program)) {
    const bool isCounted = hasBitAndWord(signal.operand.area);
    if (isCounted && signal.operand.width == Width::Bit) continue;
    const std::uint32_t last =
        signal.operand.offset + (isCounted ? 0 : static_cast<std::uint32_t>(bytes(signal.operand.width)) - 1);
    const std::uint64_t value = valueIn(*witness.initial, signal.operand);
    const bool isSet = signal.width() > 1 || value != 0;
    const bool isTouched = std::ranges::any_of(cells, [&](const StartCell& cell) {
      return cell.area == signal.operand.area && cell.index >= signal.operand.offset && cell.index <= last;
    });
    if (isSet && isTouched)
      text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", signal.name,
                          numberText(numberOf(value, signal.type, signal.width()), signal.type));
  }
  return text;
}

std::vector<std::string> tableOf(const Trace& trace, std::size_t rows) {
  struct Row {
    std::string scan, time;
    std::vector<std::string> values;
    std::uint64_t first = 0, last = 0, timeUs = 0;  ///< of the scans that the row stands for
  };
  std::vector<Row> table{{"scan", "ms", {}}};
  const bool hasEvents = trace.hasEvents(), hasTwoEvents = trace.hasTwoEvents();
  const bool hasDevices = std::ranges::any_of(trace.rows, [](const TraceRow& row) { return !row.devices.empty(); });
  if (hasEvents) table[0].values.push_back(hasTwoEvents ? "old.events" : "events");
  if (hasTwoEvents) table[0].values.push_back("new.events");
  if (hasDevices) table[0].values.push_back("devices");
  for (const TraceSignal& signal : trace.signals)
    table[0].values.push_back(signal.symbol.empty() ? signal.name : signal.symbol);
  for (std::size_t i = 0; i < trace.rows.size(); ++i) {
    const TraceRow& row = trace.rows[i];
    const bool isLast = i + 1 == trace.rows.size();
    bool isSame = i > 0 && !isLast && areSame(trace.rows[i - 1], row);  // thousands of scans need no text
    if (!isSame) {
      Row next{"", "", {}, row.scan};
      if (hasEvents) next.values.push_back(row.events);
      if (hasTwoEvents) next.values.push_back(row.newEvents);
      if (hasDevices) next.values.push_back(row.devices);
      for (std::size_t s = 0; s < trace.signals.size(); ++s)
        next.values.push_back(row.values[s] ? numberText(*row.values[s], trace.signals[s].type) : "-");
      isSame = i > 0 && !isLast && table.back().values == next.values;
      if (!isSame) table.push_back(std::move(next));
    }
    table.back().last = row.scan;
    table.back().timeUs = row.timeUs;
  }
  for (std::size_t i = 1; i < table.size(); ++i) {
    Row& row = table[i];
    row.scan = row.first == row.last ? fmt::format("{}", row.last) : fmt::format("{}-{}", row.first, row.last);
    row.time = fmt::format("{}", row.timeUs / 1000);
  }
  if (table.size() > rows + 1) {
    const std::size_t cut = table.size() - rows;
    table.erase(table.begin() + 1, table.begin() + static_cast<std::ptrdiff_t>(cut));
    table.insert(table.begin() + 1, Row{"...", "", std::vector<std::string>(table[0].values.size())});
  }
  std::vector<std::size_t> widths(table[0].values.size() + 2, 0);
  for (const Row& row : table) {
    widths[0] = std::max(widths[0], row.scan.size());
    widths[1] = std::max(widths[1], row.time.size());
    for (std::size_t s = 0; s < row.values.size(); ++s) widths[s + 2] = std::max(widths[s + 2], row.values[s].size());
  }
  std::vector<std::string> lines;
  for (const Row& row : table) {
    std::string line = fmt::format("{:>{}}  {:>{}}", row.scan, widths[0], row.time, widths[1]);
    for (std::size_t s = 0; s < row.values.size(); ++s) line += fmt::format("  {:>{}}", row.values[s], widths[s + 2]);
    lines.push_back(std::move(line));
  }
  return lines;
}

std::string EvidenceNames::of(std::string_view name) {
  std::string stem;
  for (const char c : name) stem += std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '.' ? c : '_';
  if (stem.empty()) stem = "property";
  const std::string plain = stem;
  for (int i = 2; !given_.insert(stem).second; ++i) stem = fmt::format("{}_{}", plain, i);
  return stem;
}

std::string evidenceFile(const std::string& folder, const std::string& name) {
  std::error_code error;  // a folder that cannot be made shows when the file is written
  std::filesystem::create_directories(folder, error);
  return pathName(std::filesystem::path(folder) / name);
}

std::string writeRun(const Context& context, const std::string& folder, const std::string& stem, const Program& program,
                     const Choices& choices, const ProofResult& result, std::vector<std::string>& notes) {
  std::vector<TraceSignal> signals = touchedSignals(program);
  for (TraceSignal& signal : signalsThatMatter(program, result)) {  // what only the property names
    if (std::ranges::find(signals, signal.name, &TraceSignal::name) == signals.end())
      signals.push_back(std::move(signal));
  }
  Trace trace = traceOf(program, choices, *result.witness, signals);
  addGiven(program, choices, *result.witness, trace);
  if (trace.rows.size() < result.witness->scanCount)
    notes.push_back(
        fmt::format("the trace holds the last {} of {} scans: 'rungproof sim' cannot repeat the run from it",
                    trace.rows.size(), result.witness->scanCount));
  std::string first;
  for (const char* ending : {".csv", ".vcd", ".svg"}) {
    const std::string name = evidenceFile(folder, stem + ending);
    TextStream text;
    traceFormatOf(name)->write(trace, result.property.name, text);
    if (!context.write({ending + 1, name}, text.str())) continue;
    if (first.empty()) first = name;
  }
  return first;
}

}  // namespace rungproof
