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

constexpr std::string_view memoryWord = "memory.", presetWord = "set.";

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

/// The inputs as the surroundings hold them: what columns of a stimulus have to come to.
class HeldInputs {
 public:
  void set(const PresetValue& input) {
    const Operand& o = input.operand;
    if (o.width == Width::Bit) {
      std::uint8_t& byte = bytes_[{o.area, o.offset}];
      const auto mask = static_cast<std::uint8_t>(1U << o.bit);
      byte = static_cast<std::uint8_t>(input.value != 0 ? byte | mask : byte & ~mask);
      return;
    }
    const auto count = static_cast<std::uint32_t>(bytes(o.width));
    for (std::uint32_t i = 0; i < count; ++i)
      bytes_[{o.area, o.offset + i}] = static_cast<std::uint8_t>(input.value >> (8 * (count - 1 - i)));
  }
  std::uint64_t get(const Operand& o) const {
    if (o.width == Width::Bit) return byteAt(o.area, o.offset) >> o.bit & 1U;
    std::uint64_t value = 0;
    for (int i = 0; i < bytes(o.width); ++i)
      value = value << 8 | byteAt(o.area, o.offset + static_cast<std::uint32_t>(i));
    return value;
  }

 private:
  std::uint8_t byteAt(Area area, std::uint32_t byte) const {
    const auto found = bytes_.find({area, byte});
    return found == bytes_.end() ? std::uint8_t{0} : found->second;
  }
  std::map<std::pair<Area, std::uint32_t>, std::uint8_t> bytes_;
};

/// Whether a column has all bits of an input.
bool isCovered(const std::vector<std::pair<std::size_t, TraceSignal>>& columns, const Operand& input) {
  return std::ranges::any_of(columns, [&](const auto& column) {
    const Operand& operand = column.second.operand;
    return isInputColumn(operand) && overlaps(operand, input) && bits(operand.width) >= bits(input.width) &&
           operand.offset <= input.offset;
  });
}

/// "set.I0.0=1"; "set.I[32]=1" where no address means the byte.
std::string presetItem(const Program& program, const Operand& operand, std::uint64_t value) {
  Failure failure;
  const std::string name = toString(operand);
  const auto signal = signalNamed(program, name, failure);
  if (signal && toString(signal->operand) == name) return fmt::format("{}{}={}", presetWord, name, value);
  return fmt::format("{}{}[{}]={}", presetWord, areaInfo(operand.area).name, operand.offset, value);
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

GivenCells givenOf(const GivenSide& side, const Trace& trace) {
  const auto& [program, choices, witness, columns] = side;
  PlaceTexts places(program);
  GivenCells cells;
  if (witness.initial) cells.start = startOf(program, choices, *witness.initial);
  Asked asked;
  HeldInputs held;
  std::optional<std::size_t> last;
  replay(
      program, choices, witness.scans, witness.initial ? &*witness.initial : nullptr,
      [&](const Concrete::Store&, std::size_t at) {
        const ReplayScan& scan = witness.scans[at];
        const TraceRow& row = trace.rows[cells.events.size()];
        cells.events.push_back(eventsText(program, scan.script.events, /*withQueue=*/true));
        std::string& cell = cells.given.emplace_back();
        // What is held needs no more than the columns of inputs; memory is written once where scans are alike.
        for (const PresetValue& input : scan.inputs) {
          const bool isHeld = isInputColumn(input.operand);
          if (isHeld ? held.get(input.operand) != input.value && !isCovered(columns, input.operand) : last != at)
            addItem(cell, presetItem(program, input.operand, input.value));
          if (isHeld) held.set(input);
        }
        for (const auto& [index, signal] : columns) {
          if (!isInputColumn(signal.operand) || !row.values[index]) continue;
          const std::uint64_t value = held.get(signal.operand);
          if (valueOf(*row.values[index], signal.type, signal.width()) != value)
            addItem(cell, presetItem(program, signal.operand, value));
        }
        last = at;
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
        return cells.events.size() < trace.rows.size();
      },
      &asked);
  cells.events.resize(trace.rows.size());
  cells.given.resize(trace.rows.size());
  return cells;
}

void addGiven(const Program& program, const Choices& choices, const Witness& witness, Trace& trace) {
  if (witness.scanCount != trace.rows.size()) return;  // a part of a run repeats nothing
  GivenSide side{program, choices, witness, {}};
  for (std::size_t i = 0; i < trace.signals.size(); ++i) side.columns.emplace_back(i, trace.signals[i]);
  GivenCells cells = givenOf(side, trace);
  trace.isWhole = true;
  trace.hasDevices = true;
  trace.startValues = std::move(cells.start);
  for (std::size_t i = 0; i < trace.rows.size(); ++i) {
    trace.rows[i].events = std::move(cells.events[i]);
    trace.rows[i].given = std::move(cells.given[i]);
  }
}

void addGivenOfTwo(const GivenSide& before, const GivenSide& after, Trace& trace) {
  if (before.witness.scanCount != trace.rows.size()) return;
  GivenCells left = givenOf(before, trace), right = givenOf(after, trace);
  trace.isWhole = true;
  trace.hasDevices = true;
  trace.startValues = std::move(left.start);
  trace.newStartValues = std::move(right.start);
  for (std::size_t i = 0; i < trace.rows.size(); ++i) {
    trace.rows[i].events = std::move(left.events[i]);
    trace.rows[i].newEvents = std::move(right.events[i]);
    trace.rows[i].given = std::move(left.given[i]);
    trace.rows[i].newGiven = std::move(right.given[i]);
  }
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
  if (name.starts_with(presetWord)) {
    name.remove_prefix(presetWord.size());
    Failure failure;
    if (const auto signal = signalNamed(program_, name, failure))
      return row.presets.push_back({signal->operand, *value}), true;
    const auto byte = indexedIn(name);
    const auto area = std::ranges::find(areaTable, byte ? byte->name : std::string_view(), &AreaInfo::name);
    if (!byte || area == areaTable.end() || *value > 255) return false;
    return row.presets.push_back({direct(area->area, Width::Byte, byte->index), *value}), true;
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
