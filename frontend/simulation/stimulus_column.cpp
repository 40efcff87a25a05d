// Headings to columns.
#include "frontend/simulation/stimulus_column.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "frontend/files/closest_word.hpp"
#include "frontend/logger/trace_cell.hpp"
#include "frontend/simulation/library_columns.hpp"
#include "frontend/step7/name_lookup.hpp"
#include "frontend/stl/missing_address.hpp"
#include "frontend/stl/operand_reader.hpp"
#include "ir/iec/cpu.hpp"
#include "ir/overlap.hpp"
#include "ir/s7200/call_contract.hpp"
#include "ir/s7200/call_parameters.hpp"
#include "ir/s7200/special_memory.hpp"
#include "ir/written_operand.hpp"

namespace rungproof {

namespace {

/// What a column of a recorded trace may set.
bool isSurrounding(const Program& program, const Operand& operand) {
  switch (operand.area) {
    case Area::I:
    case Area::AI:
    case Area::PI: return true;
    case Area::V:
    case Area::M:
    case Area::DB:
    case Area::S: return !isWritten(program, operand, Actuals::Written);
    case Area::SM: {
      const SmSource source = smSource(program.target, operand.offset, operand.width == Width::Bit ? operand.bit : 0);
      return (source == SmSource::Free || source == SmSource::FirstScan) &&
             !isWritten(program, operand, Actuals::Written);
    }
    default: return false;
  }
}

/// "BLOCK.Done" or "BLOCK.3" if the program calls a block of that name whose text it does not have.
std::optional<StimulusColumn> libraryColumn(const Program& program, const std::string& name) {
  const std::size_t dot = name.rfind('.');
  if (dot == std::string::npos) return std::nullopt;
  const std::string blockName = name.substr(0, dot);
  const std::string outputName = name.substr(dot + 1);
  const std::optional<double> number = numberIn(outputName);
  const CallContracts contracts(program);
  for (const auto& [id, contract] : contracts.all()) {
    if (lowered(contract.name) != lowered(blockName)) continue;
    std::uint32_t position =
        number && *number >= 1 && *number <= maxParameters ? static_cast<std::uint32_t>(*number) : 0;
    const LibraryBlock* block = libraryBlockWith(contract.name, contract.given);
    if (position == 0 && block != nullptr) position = libraryOutputNamed(*block, outputName);
    const auto output = std::ranges::find(contract.outputs, position, &CallContract::Output::place);
    if (output == contract.outputs.end()) continue;
    StimulusColumn column;
    column.target = StimulusTarget::LibraryOutput;
    column.block = contract.name;
    column.position = position;
    column.signal.name = name;
    column.signal.operand = direct(Area::V, widthOf(output->type), 0);  // only its width counts
    column.signal.type = signalTypeOf(output->type);
    return column;
  }
  return std::nullopt;
}

/// "OB40_POINT_ADDR": a field of the start information of an organization block.
std::optional<StimulusColumn> startColumn(const std::string& name) {
  const std::optional<s7300::StartField> field = s7300::startFieldNamed(name);
  if (!field) return std::nullopt;
  StimulusColumn column;
  column.target = StimulusTarget::StartField;
  column.field = *field;
  column.signal.name = name;
  column.signal.operand = direct(Area::L, field->width, field->byte, field->bit);
  column.signal.type = field->width == Width::Bit ? SignalType::Bool : SignalType::Unsigned;
  return column;
}

/// "HSC0.pulses", "HSC0.down", "PORT0.receive", "NET.error", "NET.hold", "CLOCK.tick", "CLOCK.bit5".
std::optional<StimulusColumn> deviceColumn(const std::string& name) {
  struct DeviceName {
    std::string_view before, after;
    StimulusTarget target;
    std::uint32_t count;  ///< how many there are; 0: no number in the name
  };
  static constexpr std::array<DeviceName, 9> names = {
      {{"hsc", ".pulses", StimulusTarget::Pulses, HighSpeedCounters::count},
       {"hsc", ".down", StimulusTarget::DownPulses, HighSpeedCounters::count},
       {"port", ".receive", StimulusTarget::Characters, 2},
       {"net.error", "", StimulusTarget::NetworkError, 0},
       {"net.hold", "", StimulusTarget::NetworkHold, 0},
       {"clock.tick", "", StimulusTarget::TickPhase, 0},
       {"clock.second", "", StimulusTarget::SecondPhase, 0},
       {"clock.minute", "", StimulusTarget::MinutePhase, 0},
       {"clock.bit", "", StimulusTarget::ClockBitPhase, 8}}};
  const std::string lower = lowered(name);
  for (const DeviceName& device : names) {
    if (!lower.starts_with(device.before) || !lower.ends_with(device.after)) continue;
    const std::string middle =
        lower.size() < device.before.size() + device.after.size()
            ? "?"
            : lower.substr(device.before.size(), lower.size() - device.before.size() - device.after.size());
    const bool isNumber =
        middle.size() == 1 && middle[0] >= '0' && static_cast<std::uint32_t>(middle[0] - '0') < device.count;
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
  const bool hasOwnNames = dialectOf(program.target).memory.isOfVariables;  // there T1 and Valve.Value are variables
  const bool asValue = !hasOwnNames && lowered(name).ends_with(".value");
  if (asValue) bare.remove_suffix(6);
  Operand operand;
  std::string symbolName;
  bool isKnown = !hasOwnNames && readAddress(bare, Spelling::International, operand);
  if (!isKnown) {
    for (const Symbol& symbol : program.symbols) {
      if (lowered(symbol.name) != lowered(bare) || symbol.address.kind != OperandKind::Direct) continue;
      operand = symbol.address;
      symbolName = symbol.name;
      isKnown = true;
    }
  }
  isKnown =
      isKnown || readAddress(bare, Spelling::International, operand) || readAddress(bare, Spelling::German, operand);
  if (const std::size_t blank = bare.find(' '); !isKnown && blank != std::string_view::npos) {
    isKnown = readAddress(bare.substr(0, blank), Spelling::International, operand);  // "Q0.0 Motor"
  }
  if (!isKnown) {
    const std::optional<Operand> place = step7::placeNamed(program, bare);
    isKnown = place && place->kind == OperandKind::Direct;
    if (isKnown) operand = *place;
  }
  if (!isKnown) {
    std::vector<std::string> names;
    for (const Symbol& symbol : program.symbols) names.push_back(symbol.name);
    const std::string_view meant = closest(bare, names);
    failure = {fmt::format("'{}' is no address and no symbol of the program", name),
               {},
               meant.empty() ? "give the symbol table with --symbols, or write the address"
                             : fmt::format("did you mean '{}'?", meant)};
    return std::nullopt;
  }
  const bool byNumber = hasBitAndWord(operand.area);
  if (asValue && !byNumber) {
    failure = {fmt::format("'.value' belongs to timers and counters, not to {}", bare)};
    return std::nullopt;
  }
  operand.width = byNumber && !asValue ? Width::Bit : areaInfo(operand.area).width.value_or(operand.width);
  if (asValue && operand.area == Area::T && dialectOf(program.target).run.counting == Counting::Elements)
    operand.width = Width::DWord;  // ms that are left
  if (operand.area == Area::L) {
    failure = {fmt::format("{} has no value between scans: local memory belongs to one call (001:1367)", name)};
    return std::nullopt;
  }
  if (auto missing = missingFrom(program.target, operand)) {
    failure = {std::move(*missing), {}, operand.bit > 7 ? "mend the address" : "choose the CPU with --cpu"};
    return std::nullopt;
  }
  TraceSignal signal = signalOf(program, operand);
  signal.name = std::string(name);
  if (!symbolName.empty()) signal.symbol = symbolName;
  return signal;
}

TraceSignal signalWithoutProgram(std::string_view name, std::span<const Symbol> symbols) {
  TraceSignal signal;
  signal.name = std::string(name);
  signal.type = SignalType::Number;
  std::string_view bare = name;
  const bool asValue = lowered(name).ends_with(".value");
  if (asValue) bare.remove_suffix(6);
  std::string_view address = bare;
  if (const std::size_t blank = bare.find(' '); blank != std::string_view::npos) {
    address = bare.substr(0, blank);
    signal.symbol = bare.substr(blank + 1);
  }
  Operand operand;
  bool isKnown = readAddress(address, Spelling::International, operand);
  for (const Symbol& symbol : symbols) {
    if (isKnown || lowered(symbol.name) != lowered(bare) || symbol.address.kind != OperandKind::Direct) continue;
    operand = symbol.address;
    signal.symbol = symbol.name;
    isKnown = true;
  }
  isKnown = isKnown || readAddress(address, Spelling::German, operand);
  if (!isKnown || operand.kind != OperandKind::Direct || operand.area == Area::L) {
    signal.symbol.clear();
    return signal;
  }
  operand.width =
      hasBitAndWord(operand.area) && !asValue ? Width::Bit : areaInfo(operand.area).width.value_or(operand.width);
  signal.operand = operand;
  if (operand.width == Width::Bit) signal.type = SignalType::Bool;
  return signal;
}

bool isInputColumn(const Operand& operand) {
  return operand.area == Area::I || operand.area == Area::AI || operand.area == Area::PI;
}

bool isOutputColumn(const Operand& operand) { return operand.area == Area::Q || operand.area == Area::AQ; }

std::optional<StimulusColumn> stimulusColumn(const Program& program, const std::string& name, bool isRecorded,
                                             Failure& failure) {
  if (auto library = libraryColumn(program, name)) return library;
  if (auto device = deviceColumn(name)) return device;
  if (auto start = dialectOf(program.target).run.startsBlocks ? startColumn(name) : std::nullopt) return start;
  const std::optional<TraceSignal> signal = signalNamed(program, name, failure);
  if (!signal) return std::nullopt;
  StimulusColumn column;
  column.signal = *signal;
  if (!isRecorded && isOutputColumn(signal->operand)) {
    failure = {fmt::format("{} is an output: the program drives it, a stimulus does not", name),
               {},
               "remove the column, or give the file to --expect"};
    return std::nullopt;
  }
  const bool applies = !isRecorded || isSurrounding(program, signal->operand);
  column.target = applies ? StimulusTarget::Memory : StimulusTarget::None;
  return column;
}

const StimulusColumn* sharedWith(std::span<const StimulusColumn> columns, const StimulusColumn& column) {
  if (column.target != StimulusTarget::Memory) return nullptr;
  const Operand& operand = column.signal.operand;
  const auto found = std::ranges::find_if(columns, [&](const StimulusColumn& other) {
    // The bit of a timer or counter and its value are set apart.
    const bool isOther = hasBitAndWord(operand.area) && other.signal.operand.width != operand.width;
    return other.target == StimulusTarget::Memory && !isOther && overlaps(other.signal.operand, operand);
  });
  return found == columns.end() ? nullptr : &*found;
}

std::string samePlaceText(std::string_view first, std::string_view second) {
  return fmt::format("columns '{}' and '{}' name the same place", first, second);
}

}  // namespace rungproof
