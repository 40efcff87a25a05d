// Signals of a program, their types, and their values.
#include "engine/trace.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <iterator>
#include <set>
#include <tuple>

#include "engine/cell_value.hpp"
#include "engine/real_places.hpp"
#include "engine/simulator.hpp"
#include "ir/block_map.hpp"
#include "ir/desc.hpp"
#include "ir/s7300/block.hpp"
#include "ir/s7300/block_operand.hpp"
#include "ir/s7300/declarations.hpp"
#include "ir/s7300/pointer_code.hpp"

namespace rungproof {

namespace {

using Cell = std::tuple<Area, std::uint32_t, unsigned, Width>;

Cell cellOf(const Operand& o) { return {o.area, o.offset, o.bit, o.width}; }

/// Operands of T and C take the width of the instruction's operand; everything else its written width.
Operand accessed(const Operand& operand, Type type) {
  Operand result = operand;
  result.width = hasBitAndWord(operand.area) && type == Type::Bool
                     ? Width::Bit
                     : areaInfo(operand.area).width.value_or(operand.width);
  return result;
}

bool isTraced(const Operand& operand) { return operand.kind == OperandKind::Direct && lastsOverScans(operand.area); }

/// Calls visit(operand, type) for every direct memory operand of the program that has a value between scans.
template <class Visit>
void forEachOperand(const Program& program, Visit&& visit) {
  for (const Pou& pou : program.pous) {
    for (const Network& network : pou.networks) {
      for (const Instruction& instruction : network.instructions) {
        for (std::size_t i = 0; i < instruction.operands.size(); ++i) {
          const Operand& operand = instruction.operands[i];
          if (!isTraced(operand) || isBlockOperand(program, instruction, i)) continue;
          const bool listed = i < instruction.desc->operandCount;
          const Type type = listed ? instruction.desc->operands[i].type : Type::Parameter;
          if (type != Type::Block) visit(instruction, i, operand, type);
        }
      }
    }
  }
}

/// Order of the groups in a trace.
int groupOf(Area area) {
  switch (area) {
    case Area::I:
    case Area::AI:
    case Area::PI: return 0;
    case Area::Q:
    case Area::AQ:
    case Area::PQ: return 1;
    case Area::T: return 2;
    case Area::C: return 3;
    case Area::SM: return 5;
    default: return 4;
  }
}

/// Number of bits that S, R, SI, RI reach with a constant count; 1 for everything else.
unsigned bitCount(const Instruction& instruction, std::size_t operand) {
  const bool hasCount = operand == 0 && instruction.desc->operandCount == 2 &&
                        instruction.desc->operands[1].name == "N" && instruction.desc->operands[0].type == Type::Bool &&
                        instruction.operands.size() == 2;
  if (!hasCount || instruction.operands[1].kind != OperandKind::Constant) return 1;
  return static_cast<unsigned>(std::clamp<std::int64_t>(instruction.operands[1].value, 1, 255));
}

}  // namespace

int Trace::signalNamed(std::string_view name) const {
  const auto sameLetter = [](char a, char b) {
    return (a >= 'a' && a <= 'z' ? a - 32 : a) == (b >= 'a' && b <= 'z' ? b - 32 : b);
  };
  const auto isCalled = [&](const std::string& other) {
    return std::equal(name.begin(), name.end(), other.begin(), other.end(), sameLetter);
  };
  for (std::size_t i = 0; i < signals.size(); ++i) {
    if (isCalled(signals[i].name)) return static_cast<int>(i);
  }
  for (std::size_t i = 0; i < signals.size(); ++i) {
    if (!signals[i].symbol.empty() && isCalled(signals[i].symbol)) return static_cast<int>(i);
  }
  return -1;
}

int Trace::indexOf(const TraceSignal& signal) const {
  if (signal.operand.isMemory()) {
    for (std::size_t i = 0; i < signals.size(); ++i) {
      if (signals[i].operand.isMemory() && cellOf(signals[i].operand) == cellOf(signal.operand))
        return static_cast<int>(i);
    }
  }
  const int named = signalNamed(signal.name);
  return named >= 0 || signal.symbol.empty() ? named : signalNamed(signal.symbol);
}

namespace {

TraceSignal signalOf(const Program& program, const RealPlaces& reals, const Operand& operand, const Symbol* symbol) {
  TraceSignal signal;
  signal.operand = operand;
  const bool byNumber = hasBitAndWord(operand.area);
  const bool isVariable = symbol != nullptr && dialectOf(program.target).memory.isOfVariables;
  if (symbol != nullptr && !isVariable) signal.symbol = symbol->name;
  signal.name = isVariable ? symbol->name : toString(operand);
  if (byNumber && operand.width != Width::Bit) signal.name += ".value";
  if (operand.width == Width::Bit) signal.type = SignalType::Bool;
  if (operand.width == Width::Byte) signal.type = SignalType::Unsigned;
  if (operand.width == Width::Word || operand.width == Width::DWord) signal.type = SignalType::Signed;
  if (operand.width == Width::DWord && reals.contains(operand)) signal.type = SignalType::Real;
  if (const auto meant = program.valueTypes.find(operand.offset);
      meant != program.valueTypes.end() && operand.width != Width::Bit)
    signal.type = meant->second == ValueType::Real     ? realOf(bits(operand.width))
                  : meant->second == ValueType::Signed ? SignalType::Signed
                                                       : SignalType::Unsigned;
  return signal;
}

}  // namespace

TraceSignal signalOf(const Program& program, const Operand& operand) {
  return signalOf(program, RealPlaces(program), operand, program.symbolOf(operand));
}

std::vector<TraceSignal> touchedSignals(const Program& program) {
  Operands operands;
  std::set<Cell> seen;
  const RealPlaces reals(program);
  const bool isOfVariables = dialectOf(program.target).memory.isOfVariables;
  if (isOfVariables) {  // in the order of their declaration, by their first names
    std::vector<TraceSignal> variables;
    for (const Symbol& symbol : program.symbols) {
      if (seen.insert(cellOf(symbol.address)).second)
        variables.push_back(signalOf(program, reals, symbol.address, &symbol));
    }
    return variables;
  }
  const auto add = [&](const Operand& operand) {
    if (seen.insert(cellOf(operand)).second) operands.push_back(operand);
  };
  forEachOperand(program, [&](const Instruction& instruction, std::size_t i, const Operand& operand, Type type) {
    Operand first = accessed(operand, type);
    if (first.area == Area::T && first.width == Width::Word &&
        dialectOf(program.target).run.counting == Counting::Elements)
      first.width = Width::DWord;  // ms
    for (unsigned k = 0; k < bitCount(instruction, i); ++k) {
      Operand next = first;
      if (hasBitAndWord(operand.area)) {
        next.offset += k;
      } else {
        next.offset += (first.bit + k) / 8;
        next.bit = static_cast<std::uint8_t>((first.bit + k) % 8);
      }
      if (addressExists(program.target, next.area, next.width, next.offset, next.bit)) add(next);
    }
    const bool isTimer = type == Type::Timer || type == Type::Counter;
    if (!isTimer) return;
    Operand bit = first;
    bit.width = Width::Bit;
    add(bit);
  });
  std::sort(operands.begin(), operands.end(), [](const Operand& a, const Operand& b) {
    return std::tuple(groupOf(a.area), a.area, a.offset, a.width, a.bit) <
           std::tuple(groupOf(b.area), b.area, b.offset, b.width, b.bit);
  });
  std::vector<TraceSignal> signals;
  for (const Operand& operand : operands)
    signals.push_back(signalOf(program, reals, operand, program.symbolOf(operand)));
  return signals;
}

TraceNumber numberOf(std::uint64_t value, SignalType type, int width) {
  switch (type) {
    case SignalType::Bool: return static_cast<TraceNumber>(value & 1);
    case SignalType::Unsigned: return static_cast<TraceNumber>(value & Concrete::mask(width));
    case SignalType::Signed: return static_cast<TraceNumber>(Concrete::toSigned(value, width));
    case SignalType::Real:
    case SignalType::LongReal:
    case SignalType::Number: return width == 64 ? Concrete::longReal(value) : Concrete::real(value);
  }
  return 0;
}

std::uint64_t valueOf(TraceNumber number, SignalType type, int width) {
  if (type == SignalType::Real || type == SignalType::LongReal || type == SignalType::Number)
    return width == 64 ? Concrete::longPattern(static_cast<double>(number))
                       : Concrete::pattern(static_cast<float>(static_cast<double>(number)));
  if (type == SignalType::Bool) return number != 0 ? 1 : 0;
  if (number >= 0x1p63L && number < 0x1p64L) return static_cast<std::uint64_t>(number) & Concrete::mask(width);
  if (!(number >= -0x1p63L && number < 0x1p63L)) return 0;
  return static_cast<std::uint64_t>(static_cast<std::int64_t>(number)) & Concrete::mask(width);
}

std::string numberText(TraceNumber number, SignalType type) {
  std::string text;
  appendNumber(number, type, text);
  return text;
}

void appendNumber(TraceNumber number, SignalType type, std::string& text) {
  const bool isWholeType = type == SignalType::Bool || type == SignalType::Unsigned || type == SignalType::Signed;
  // Of others all integers up to here are exact, and written without an exponent.
  const TraceNumber mostDigits = isWholeType ? 0x1p64L : 1e15L;
  const bool isInteger = std::abs(number) < mostDigits && std::trunc(number) == number && !std::signbit(number);
  const auto real = static_cast<double>(number);
  const auto asReal = static_cast<float>(real);
  const bool isShort = std::isnan(real) || static_cast<double>(asReal) == real;  // else: what no REAL is
  if (type == SignalType::Real && isShort) {
    fmt::format_to(std::back_inserter(text), "{}", asReal);
  } else if (isInteger) {
    const fmt::format_int digits(static_cast<std::uint64_t>(number));
    text.append(digits.data(), digits.size());
  } else if (isWholeType && std::trunc(number) == number && number >= -0x1p63L && number < 0) {
    const fmt::format_int digits(static_cast<std::int64_t>(number));
    text.append(digits.data(), digits.size());
  } else {
    fmt::format_to(std::back_inserter(text), "{}", real);
  }
}

namespace {

void sampleInto(const Concrete::Store& store, const std::vector<TraceSignal>& signals,
                std::vector<std::optional<TraceNumber>>& values) {
  const bool isRunning = store.get(Reg::Running, 0) != 0;
  values.clear();
  values.reserve(signals.size());
  for (const TraceSignal& signal : signals) {
    const Operand& o = signal.operand;
    std::uint64_t value = cellValue(store, o);
    if (o.area == Area::Q && !isRunning) {
      value = 0;
      for (int i = 0; i < signal.width(); ++i) {  // the lowest address holds the most significant byte
        const auto byte = o.offset + static_cast<std::uint32_t>(i / 8);
        const auto bit = o.width == Width::Bit ? o.bit : static_cast<std::uint32_t>(i % 8);
        const int place = o.width == Width::Bit ? 0 : signal.width() - 8 * (i / 8 + 1) + i % 8;
        const std::uint32_t terminal = byte * 8 + bit;  // behind them: what a PROFINET device is told
        if (terminal < store.count(Reg::PhysicalOutput)) value |= store.get(Reg::PhysicalOutput, terminal) << place;
      }
    }
    values.emplace_back(numberOf(value, signal.type, signal.width()));
  }
}

}  // namespace

std::vector<std::optional<TraceNumber>> sampleValues(const Concrete::Store& store,
                                                     const std::vector<TraceSignal>& signals) {
  std::vector<std::optional<TraceNumber>> values;
  sampleInto(store, signals, values);
  return values;
}

TraceRow sampleRow(const Simulator& simulator, const std::vector<TraceSignal>& signals) {
  TraceRow row;
  sampleRow(simulator, signals, row);
  return row;
}

void sampleRow(const Simulator& simulator, const std::vector<TraceSignal>& signals, TraceRow& row) {
  row.scan = simulator.scanCount();
  row.timeUs = simulator.timeUs();
  row.scanUs = simulator.lastScanUs();
  sampleInto(simulator.store(), signals, row.values);
}

}  // namespace rungproof
