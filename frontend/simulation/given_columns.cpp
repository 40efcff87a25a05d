// One table of kinds, one writer, one reader.
#include "frontend/simulation/given_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

#include "engine/instruction_observer.hpp"
#include "engine/start_up.hpp"
#include "frontend/simulation/event_place.hpp"
#include "frontend/simulation/stimulus_column.hpp"
#include "ir/overlap.hpp"

namespace rungproof {

namespace {

struct ExternalWord {
  External kind;
  std::string_view name;
};

constexpr std::size_t externalKinds = static_cast<std::size_t>(External::TimerPhase) + 1;
constexpr std::array<ExternalWord, externalKinds> externalWords = {{
    {External::ImmediateInput, "immediate"}, {External::AnalogInput, "analog"},
    {External::StackBottom, "stack"},        {External::LocalMemory, "local"},
    {External::ClockByte, "clock"},          {External::IntervalClock, "interval"},
    {External::NetworkStatus, "network"},    {External::ReceivedByte, "received"},
    {External::StationAddress, "station"},   {External::LibraryOutput, "block"},
    {External::AsyncTicks, "ticks"},         {External::EventFires, "fires"},
    {External::UnknownStatus, "status"},     {External::UnknownResult, "result"},
    {External::RegisterAtStart, "register"}, {External::AccessError, "silent"},
    {External::CalendarDay, "day"},          {External::TimeOfDay, "time"},
    {External::TimerPhase, "phase"},
}};
static_assert([] {
  for (std::size_t i = 0; i < externalKinds; ++i) {
    if (externalWords[i].kind != static_cast<External>(i) || externalWords[i].name.empty()) return false;
  }
  return true;
}());

constexpr std::string_view memoryWord = "memory.";

std::string registerName(const RegInfo& info) {
  std::string name(info.name);
  std::ranges::replace(name, ' ', '_');
  return name;
}

/// Texts behind '@' that are read back as the same place: line and order, or the number of the instruction where it
/// stands in no line.
class PlaceTexts {
 public:
  explicit PlaceTexts(const Program& program) : program_(program) {}
  std::string of(const ScanPlace& place) {
    const auto [known, isNew] = texts_.try_emplace({place.instruction, place.visit});
    if (!isNew) return known->second;
    std::string text = placeText(program_, place);
    const bool isRead = text.starts_with('@') && scanPlaceNamed(program_, std::string_view(text).substr(1)) == place &&
                        text.find_first_of(" =[\"") == std::string::npos;
    if (!isRead) text = fmt::format("@#{}*{}", place.instruction, place.visit + 1);
    return known->second = std::move(text);
  }

 private:
  const Program& program_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::string> texts_;
};

/// Counts what a scan of the engine asks for, by kind, index and instruction.
class Asked final : public InstructionObserver {
 public:
  void clear() { counts_.clear(); }
  void before(const Machine<Concrete>&, const Instruction&) override {}
  void external(const ExternalSite& site, std::uint64_t) override { ++counts_[keyOf(site)]; }
  void programEnded(const Machine<Concrete>&) override {}
  /// Whether one more value of that site is among those asked for; call once for each that is given.
  bool take(const ExternalSite& site) {
    const auto found = counts_.find(keyOf(site));
    return found != counts_.end() && found->second > 0 && found->second-- > 0;
  }

 private:
  using Key = std::array<std::uint32_t, 3>;
  static Key keyOf(const ExternalSite& site) {
    return {static_cast<std::uint32_t>(site.kind), site.index, site.instruction};
  }
  std::map<Key, std::uint32_t> counts_;
};

void addItem(std::string& cell, const std::string& item) { cell += (cell.empty() ? "" : " ") + item; }

/// Whether the columns of the trace set this input already.
bool isInColumns(const std::vector<TraceSignal>& signals, const Concrete::Store& state, const PresetValue& input) {
  if (!isInputColumn(input.operand) || valueIn(state, input.operand) != input.value) return false;
  return std::ranges::any_of(signals, [&](const TraceSignal& signal) {
    return overlaps(signal.operand, input.operand) && bits(signal.operand.width) >= bits(input.operand.width);
  });
}

std::string startOf(const Program& program, const Choices& choices, const Concrete::Store& initial) {
  const Concrete::Store powerUp = powerUpState(Plan(program), choices);
  std::string cell;
  for (const AreaInfo& info : areaTable) {
    const std::vector<std::uint8_t>& bytes = initial.area(info.area);
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      if (bytes[i] != powerUp.area(info.area)[i])
        addItem(cell, fmt::format("{}{}[{}]={}", memoryWord, info.name, i, bytes[i]));
    }
  }
  for (const RegInfo& info : regTable) {
    for (std::uint32_t i = 0; i < registerSize(initial, info.reg); ++i) {
      const std::uint64_t value = initial.get(info.reg, i);
      if (value != powerUp.get(info.reg, i)) addItem(cell, fmt::format("{}[{}]={}", registerName(info), i, value));
    }
  }
  return cell;
}

std::optional<std::uint64_t> givenNumber(std::string_view text) {
  std::uint64_t value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || error != std::errc() || stop != text.data() + text.size()) return std::nullopt;
  return value;
}

/// "NAME[3]" in its parts.
struct Indexed {
  std::string_view name;
  std::uint32_t index;
};
std::optional<Indexed> indexedIn(std::string_view text) {
  const std::size_t open = text.rfind('[');
  if (open == std::string_view::npos || !text.ends_with(']')) return std::nullopt;
  const auto index = givenNumber(text.substr(open + 1, text.size() - open - 2));
  if (!index || *index > 0xFFFFFFFFU) return std::nullopt;
  return Indexed{text.substr(0, open), static_cast<std::uint32_t>(*index)};
}

/// Calls visit(item) for each; stops at the first that it does not take, and gives that.
template <class Visit>
std::optional<std::string_view> firstRefused(std::string_view cell, Visit&& visit) {
  for (std::size_t at = 0; at < cell.size();) {
    const std::size_t end = std::min(cell.find(' ', at), cell.size());
    const std::string_view item = cell.substr(at, end - at);
    at = end + 1;
    if (!item.empty() && item != "x" && !visit(item)) return item;
  }
  return std::nullopt;
}

}  // namespace

std::string_view externalName(External kind) { return externalWords[static_cast<std::size_t>(kind)].name; }

void addGiven(const Program& program, const Choices& choices, const Witness& witness, Trace& trace) {
  PlaceTexts places(program);
  if (witness.scanCount != trace.rows.size()) return;  // a part of a run repeats nothing
  trace.isWhole = true;
  trace.hasDevices = true;
  if (witness.initial) trace.startValues = startOf(program, choices, *witness.initial);
  std::size_t row = 0;
  Asked asked;
  replay(
      program, choices, witness.scans, witness.initial ? &*witness.initial : nullptr,
      [&](const Concrete::Store& state, std::size_t at) {
        const ReplayScan& scan = witness.scans[at];
        TraceRow& written = trace.rows[row++];
        written.events = eventsText(program, scan.script.events, /*withQueue=*/true);
        std::string& cell = written.given;
        for (const PresetValue& input : scan.inputs) {
          if (!isInColumns(trace.signals, state, input))
            addItem(cell, fmt::format("set.{}={}", toString(input.operand), input.value));
        }
        if (scan.script.ticks10) addItem(cell, fmt::format("tick10={}", *scan.script.ticks10));
        if (scan.script.ticks100) addItem(cell, fmt::format("tick100={}", *scan.script.ticks100));
        for (const ScanScript::Tick& tick : scan.script.ticks1)
          addItem(cell, fmt::format("tick{}={}", places.of(tick.place), tick.ticks));
        for (const ExternalValue& value : scan.externals) {
          if (!asked.take(value.site)) continue;  // a branch that the encoding follows and the engine does not
          addItem(cell, fmt::format("{}[{}]{}={}", externalName(value.site.kind), value.site.index,
                                    places.of({value.site.instruction, 0}), value.value));
        }
        asked.clear();
        return row < trace.rows.size();
      },
      &asked);
}

std::optional<ScanPlace> GivenReader::place(std::string_view text) {
  if (const auto known = places_.find(text); known != places_.end()) return known->second;
  std::optional<ScanPlace> found;
  if (text.starts_with('#')) {
    const std::size_t star = text.find('*');
    const auto number = givenNumber(text.substr(1, star - 1));
    const auto visit =
        star == std::string_view::npos ? std::optional<std::uint64_t>(1) : givenNumber(text.substr(star + 1));
    if (number && *number <= 0xFFFFFFFFU && visit && *visit >= 1 && *visit <= 0xFFFFFFFFU)
      found = ScanPlace{static_cast<std::uint32_t>(*number), static_cast<std::uint32_t>(*visit - 1)};
  } else {
    found = scanPlaceNamed(program_, text);
  }
  places_.emplace(text, found);
  return found;
}

bool GivenReader::readItem(std::string_view item, StimulusRow& row) {
  const std::size_t equals = item.rfind('=');
  const auto value = equals == std::string_view::npos ? std::nullopt : givenNumber(item.substr(equals + 1));
  if (!value) return false;
  std::string_view name = item.substr(0, equals);
  if (name.starts_with("set.")) {
    Failure failure;
    const auto signal = signalNamed(program_, name.substr(4), failure);
    if (!signal) return false;
    row.presets.push_back({signal->operand, *value});
    return true;
  }
  const auto ticks = static_cast<std::uint32_t>(std::min<std::uint64_t>(*value, 0xFFFFFFFFU));
  if (name == "tick10") return row.ticks10 = ticks, true;
  if (name == "tick100") return row.ticks100 = ticks, true;
  const std::size_t mark = name.find('@');
  if (mark == std::string_view::npos) return false;
  const std::optional<ScanPlace> where = place(name.substr(mark + 1));
  name = name.substr(0, mark);
  if (!where) return false;
  if (name == "tick") return row.ticks.push_back({*where, ticks}), true;
  const auto indexed = indexedIn(name);
  if (!indexed) return false;
  const auto word = std::ranges::find(externalWords, indexed->name, &ExternalWord::name);
  if (word == externalWords.end()) return false;
  row.externals.push_back({{word->kind, indexed->index, where->instruction}, *value});
  return true;
}

bool GivenReader::readGiven(std::string_view cell, StimulusRow& row, Failure& failure) {
  const auto refused = firstRefused(cell, [&](std::string_view item) { return readItem(item, row); });
  if (!refused) return true;
  failure = {fmt::format("'{}' gives nothing", *refused),
             {},
             "write NAME[INDEX]@LINE=VALUE, tick@LINE=N or set.ADDRESS=VALUE, as prove --traces does"};
  return false;
}

bool GivenReader::readStart(std::string_view cell, std::vector<StartValue>& start, Failure& failure) const {
  const auto refused = firstRefused(cell, [&](std::string_view item) {
    const std::size_t equals = item.rfind('=');
    const auto value = equals == std::string_view::npos ? std::nullopt : givenNumber(item.substr(equals + 1));
    const auto indexed = value ? indexedIn(item.substr(0, equals)) : std::nullopt;
    if (!indexed) return false;
    if (indexed->name.starts_with(memoryWord)) {
      const auto area = std::ranges::find(areaTable, indexed->name.substr(memoryWord.size()), &AreaInfo::name);
      if (area == areaTable.end() || *value > 255) return false;
      start.push_back({std::nullopt, area->area, indexed->index, *value});
      return true;
    }
    const auto reg =
        std::ranges::find_if(regTable, [&](const RegInfo& info) { return registerName(info) == indexed->name; });
    if (reg == regTable.end()) return false;
    start.push_back({reg->reg, Area::V, indexed->index, *value});
    return true;
  });
  if (!refused) return true;
  failure = {fmt::format("'{}' is no value at the start", *refused),
             {},
             "write REGISTER[INDEX]=VALUE or memory.AREA[BYTE]=VALUE, as prove --traces does"};
  return false;
}

}  // namespace rungproof
