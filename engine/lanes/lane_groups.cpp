// From states to rows and back.
#include "engine/lanes/lane_groups.hpp"

#include <algorithm>
#include <bit>
#include <cstring>

#include "engine/cell_value.hpp"
#include "ir/check.hpp"

namespace rungproof::lanes {

namespace {

constexpr std::uint64_t lowBits = 0x0101010101010101;

/// Eight bits as bytes of 0 or 255, the lowest first.
std::uint64_t spread(std::uint64_t byte) {
  const std::uint64_t own = byte * lowBits & 0x8040201008040201;
  const std::uint64_t isOn = (((own & 0x7F7F7F7F7F7F7F7F) + 0x7F7F7F7F7F7F7F7F) | own) >> 7 & lowBits;
  return isOn * 0xFF;
}
/// The other way.
std::uint64_t gathered(std::uint64_t bytes) { return (bytes & lowBits) * 0x0102040810204080 >> 56; }

void putTruth(std::uint8_t* row, const LaneLayout& layout, const std::uint64_t* traces, std::size_t firstLane) {
  if (layout.form == Form::Wide) return void(std::memcpy(row, traces + firstLane / 64, wideTruthBytes));
  if (layout.form == Form::Bits) {
    std::memcpy(row, traces + firstLane / 64, layout.truthBytes);
    return;
  }
  for (std::size_t k = 0; k < rowBytes / 8; ++k) {
    const std::size_t lane = firstLane + 8 * k;
    const std::uint64_t bytes = spread(traces[lane / 64] >> (lane % 64) & 0xFF);
    std::memcpy(row + 8 * k, &bytes, 8);
  }
}
void takeTruth(const std::uint8_t* row, const LaneLayout& layout, std::uint64_t* traces, std::size_t firstLane) {
  if (layout.form != Form::Bytes) {
    std::memcpy(traces + firstLane / 64, row, layout.truthBytes);
    return;
  }
  for (std::size_t k = 0; k < rowBytes / 8; ++k) {
    std::uint64_t bytes = 0;
    std::memcpy(&bytes, row + 8 * k, 8);
    const std::size_t lane = firstLane + 8 * k;
    traces[lane / 64] |= gathered(bytes) << (lane % 64);
  }
}

std::uint64_t bytesAt(const std::vector<std::uint8_t>& bytes, std::uint32_t at, int count) {
  std::uint64_t value = 0;
  for (int k = 0; k < count; ++k) value = value << 8 | bytes[at + static_cast<std::uint32_t>(k)];
  return value;
}

}  // namespace

bool isCommon(Area area, std::uint32_t byte) { return area == Area::SM && (byte == 0 || (byte >= 22 && byte <= 27)); }
bool isCommon(const Concrete::Store& model, std::size_t reg) {
  constexpr Reg common[] = {Reg::FirstScan,   Reg::LastScan,    Reg::PhaseTen, Reg::PhaseHundred,
                            Reg::PhaseSecond, Reg::PhaseMinute, Reg::Running,  Reg::Fault};
  return std::ranges::any_of(common, [&](Reg r) { return model.count(r) > 0 && model.indexOf(r, 0) == reg; });
}

LaneGroups::LaneGroups(const Code& code, const LaneCode& laneCode, const Concrete::Store& start,
                       std::uint32_t terminals, std::size_t count)
    : layout_(laneCode.layout),
      laneCode_(laneCode),
      slots_(code.slots),
      sites_(code.sites.size()),
      hasTerminals_(code.hasTerminals),
      terminals_(terminals),
      count_((count + 255) / 256 * 256),
      blocks_((layout_.size + sizeof(Block) - 1) / sizeof(Block)),
      memory_(count_ / layout_.lanes * blocks_),
      inputs_(regInfo(Reg::PhysicalInput).count * (count_ / 64)),
      isInputNew_(regInfo(Reg::PhysicalInput).count / 8, true),
      isImageWritten_(start.area(Area::I).size(), false),
      others_(count_) {
  for (std::uint32_t bit = 0; bit < inputCount(); ++bit) {
    if (start.get(Reg::PhysicalInput, bit) != 0)
      std::fill_n(inputs_.begin() + static_cast<std::ptrdiff_t>(inputAt(bit, 0) / 64), count_ / 64, ~std::uint64_t{0});
  }
  inputsOfScan_ = inputs_;
  findInputPlaces();
  for (const Step& s : code.steps) {
    const bool isSlot = s.op == CodeOp::StoreBit || s.op == CodeOp::StoreSlots;
    if (isSlot && code.slots[s.value / 8].area == Area::I) isImageWritten_[code.slots[s.value / 8].byte] = true;
    if (s.op == CodeOp::StoreMemory && s.area == Area::I)
      std::fill_n(isImageWritten_.begin() + static_cast<std::ptrdiff_t>(s.value), s.width / 8, true);
    if (s.op == CodeOp::StoreAt && s.area == Area::I) isImageWritten_.assign(isImageWritten_.size(), true);
  }
  for (std::size_t trace = 0; trace < count_; ++trace) importFrom(start, trace);
  constexpr std::uint64_t unseen = ~std::uint64_t{0};
  eachRow([&](Row row, Area area, std::uint32_t byte, int bytes, int bit) {
    if (isCommon(area, byte)) shown_.push_back({row, area, byte, bytes, bit, false, unseen});
  });
  for (std::size_t reg = 0; reg < layout_.registerCount(); ++reg) {
    if (layout_.reg(reg) && isCommon(start, reg))
      shown_.push_back({*layout_.reg(reg), Area::V, static_cast<std::uint32_t>(reg), 0, 0, true, unseen});
  }
}

/// The rows of memory: take(row, area, byte, bytes, bit), of single bits 0 bytes.
template <class Take>
void LaneGroups::eachRow(Take&& take) const {
  for (std::size_t i = 0; i < 8 * slots_.size(); ++i)
    take(Row{layout_.slot(i), Rep::Truth}, slots_[i / 8].area, slots_[i / 8].byte, 0, static_cast<int>(i % 8));
  for (const LaneLayout::Cell& cell : layout_.cells())
    take(Row{cell.at, repFor(8 * cell.bytes)}, cell.area, cell.byte, cell.bytes, 0);
}

void LaneGroups::importFrom(const Concrete::Store& store, std::size_t trace) {
  std::uint8_t* const to = rows(trace / layout_.lanes);
  const std::size_t lane = trace % layout_.lanes;
  const auto terminalsOf = [&](Area area) {
    const auto& terminals = store.terminals(area == Area::PI ? Reg::PhysicalInput : Reg::PhysicalOutput);
    return std::vector<std::uint8_t>(terminals.begin(), terminals.end());
  };
  const std::vector<std::uint8_t> pi = terminalsOf(Area::PI), pq = terminalsOf(Area::PQ);
  eachRow([&](Row row, Area area, std::uint32_t byte, int bytes, int bit) {
    const std::vector<std::uint8_t>& of = hasTerminals_ && area == Area::PI   ? pi
                                          : hasTerminals_ && area == Area::PQ ? pq
                                                                              : store.area(area);
    const std::uint64_t value = bytes == 0 ? of[byte] >> bit & 1U : bytesAt(of, byte, bytes);
    setNumberIn(to, row, lane, layout_.form, value);
  });
  for (std::size_t reg = 0; reg < layout_.registerCount(); ++reg) {
    if (const auto row = layout_.reg(reg)) setNumberIn(to, *row, lane, layout_.form, store.registers()[reg]);
  }
}

void LaneGroups::take(Image& image) const {
  image.rows.resize(groupCount() * layout_.stateEnd);
  for (std::size_t g = 0; g < groupCount(); ++g)
    std::memcpy(image.rows.data() + g * layout_.stateEnd, rows(g), layout_.stateEnd);
  image.inputs = inputsOfScan_;
  image.others = others_;
}

Concrete::Store LaneGroups::storeOf(std::size_t trace, const Concrete::Store& common, const View& view) const {
  Concrete::Store store = common;
  const std::size_t lane = trace % layout_.lanes;
  for (std::uint32_t bit = 0; bit < inputCount(); ++bit) {
    const bool isOn = contains(view.inputs, inputAt(bit, trace));
    store.set(Reg::PhysicalInput, bit, isOn ? 1 : 0, true);
    if (hasRun_ && bit < terminals_) store.save(Area::I, bit, 1, isOn ? 1 : 0, true);
  }
  for (const auto& [operand, value] : view.others[trace]) setCell(store, operand, value);
  eachRow([&](Row row, Area area, std::uint32_t byte, int bytes, int bit) {
    if (isCommon(area, byte) || area == Area::L || (hasTerminals_ && (area == Area::PI || area == Area::PQ))) return;
    const std::uint64_t value = numberIn(view.rows, row, lane, layout_.form);
    if (bytes == 0) {
      std::uint8_t& to = store.area(area)[byte];
      to = static_cast<std::uint8_t>((to & ~(1U << bit)) | static_cast<unsigned>(value) << bit);
    }
    for (int k = 0; k < bytes; ++k)
      store.area(area)[byte + static_cast<std::uint32_t>(k)] = static_cast<std::uint8_t>(value >> 8 * (bytes - 1 - k));
  });
  for (std::size_t reg = 0; reg < layout_.registerCount(); ++reg) {
    const auto row = layout_.reg(reg);
    if (row && !isCommon(common, reg))
      store.registers()[reg] = static_cast<std::uint32_t>(numberIn(view.rows, *row, lane, layout_.form));
  }
  return store;
}
Concrete::Store LaneGroups::store(std::size_t trace, const Concrete::Store& common) const {
  Concrete::Store store = storeOf(trace, common, {rows(trace / layout_.lanes), inputsOfScan_, others_});
  for (std::uint32_t bit = 0; bit < inputCount(); ++bit)
    store.set(Reg::PhysicalInput, bit, contains(inputs_, inputAt(bit, trace)) ? 1 : 0, true);
  return store;
}
Concrete::Store LaneGroups::store(std::size_t trace, const Concrete::Store& common, const Image& image) const {
  return storeOf(trace, common,
                 {image.rows.data() + trace / layout_.lanes * layout_.stateEnd, image.inputs, image.others});
}

void LaneGroups::setInput(std::uint32_t bit, std::span<const std::uint64_t> traces) {
  CHECK(bit < inputCount() && traces.size() <= count_ / 64, "an input that the CPU does not have");
  std::ranges::copy(traces, inputs_.begin() + static_cast<std::ptrdiff_t>(inputAt(bit, 0) / 64));
  isInputNew_[bit / 8] = true;
}

void LaneGroups::write(std::size_t trace, const Operand& operand, std::uint64_t value, const Concrete::Store& common) {
  Concrete::Store now = store(trace, common);
  if (operand.area == Area::HC && !takesCounts(now, operand)) return;
  setCell(now, operand, value);
  for (std::uint32_t bit = 0; bit < inputCount(); ++bit) {
    const bool isOn = now.get(Reg::PhysicalInput, bit) != 0;
    if (isOn == contains(inputs_, inputAt(bit, trace))) continue;
    inputs_[inputAt(bit, trace) / 64] ^= std::uint64_t{1} << (trace % 64);
    isInputNew_[bit / 8] = true;
  }
  if (operand.area == Area::I && operand.offset * 8 < inputCount()) return;
  importFrom(now, trace);
  auto& others = others_[trace];
  std::erase_if(others, [&](const auto& other) {
    const Operand& o = other.first;
    return o.area == operand.area && o.offset == operand.offset && o.width == operand.width && o.bit == operand.bit;
  });
  others.emplace_back(operand, value);
}

/// Bytes of the input image, and of the terminals that instructions read at once.
void LaneGroups::findInputPlaces() {
  inputPlaces_.resize(isInputNew_.size());
  const auto isInput = [&](Area area, std::uint32_t byte) {
    const bool isTerminal = area == Area::PI && hasTerminals_;
    return byte < inputPlaces_.size() && (isTerminal || (area == Area::I && 8 * byte < terminals_));
  };
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    if (isInput(slots_[i].area, slots_[i].byte)) inputPlaces_[slots_[i].byte].slots.push_back(i);
  }
  const auto& cells = layout_.cells();
  for (std::size_t i = 0; i < cells.size(); ++i) {
    for (std::uint32_t byte = cells[i].byte; byte < cells[i].byte + static_cast<std::uint32_t>(cells[i].bytes);
         ++byte) {
      if (isInput(cells[i].area, byte)) inputPlaces_[byte].cells.push_back(i);
    }
  }
}

void LaneGroups::putInputs(std::uint32_t byte) {
  for (const std::size_t slot : inputPlaces_[byte].slots) {
    for (std::size_t g = 0; g < groupCount(); ++g) {
      for (std::uint32_t bit = 0; bit < 8; ++bit)
        putTruth(rows(g) + layout_.slot(8 * slot + bit), layout_, inputs_.data(),
                 inputAt(8 * byte + bit, g * layout_.lanes));
    }
  }
  for (const std::size_t index : inputPlaces_[byte].cells) {
    const LaneLayout::Cell& cell = layout_.cells()[index];
    const Row row{cell.at, repFor(8 * cell.bytes)};
    const auto shift = 8 * (cell.byte + static_cast<std::uint32_t>(cell.bytes) - 1 - byte);
    for (std::size_t trace = 0; trace < count_; ++trace) {
      std::uint64_t own = 0;
      for (std::uint32_t bit = 0; bit < 8; ++bit)
        own |= static_cast<std::uint64_t>(contains(inputs_, inputAt(8 * byte + bit, trace))) << bit;
      std::uint8_t* const to = rows(trace / layout_.lanes);
      const std::size_t lane = trace % layout_.lanes;
      const std::uint64_t others = numberIn(to, row, lane, layout_.form) & ~(0xFFULL << shift);
      setNumberIn(to, row, lane, layout_.form, others | own << shift);
    }
  }
}

void LaneGroups::readInputs() {
  for (std::uint32_t byte = 0; byte < isInputNew_.size(); ++byte) {
    const bool isWritten = byte < isImageWritten_.size() && isImageWritten_[byte];
    if (!isInputNew_[byte] && !isWritten) continue;
    putInputs(byte);
    const auto first = static_cast<std::ptrdiff_t>(inputAt(8 * byte, 0) / 64);
    std::copy_n(inputs_.begin() + first, count_ / 8, inputsOfScan_.begin() + first);
    isInputNew_[byte] = false;
  }
}

/// Brings what is common to rows where it has changed.
void LaneGroups::showCommon(const Concrete::Store& common) {
  for (Shown& shown : shown_) {
    const std::uint64_t value = shown.isRegister   ? common.registers()[shown.byte]
                                : shown.bytes == 0 ? common.area(shown.area)[shown.byte] >> shown.bit & 1U
                                                   : bytesAt(common.area(shown.area), shown.byte, shown.bytes);
    if (std::exchange(shown.value, value) == value) continue;
    if (shown.row.rep == Rep::Truth) {
      for (std::size_t g = 0; g < groupCount(); ++g)
        std::memset(rows(g) + shown.row.at, value != 0 ? 0xFF : 0, layout_.truthBytes);
    } else {
      for (std::size_t trace = 0; trace < count_; ++trace)
        setNumberIn(rows(trace / layout_.lanes), shown.row, trace % layout_.lanes, layout_.form, value);
    }
  }
}

TraceSet LaneGroups::scan(const LaneLayout::Head& head, const Concrete::Store& common, const TraceSet& running) {
  showCommon(common);
  readInputs();
  hasRun_ = true;
  scanned_.clear();
  for (std::size_t g = 0; g < groupCount(); ++g) {
    const std::size_t first = g * layout_.lanes;
    if (std::all_of(running.begin() + static_cast<std::ptrdiff_t>(first / 64),
                    running.begin() + static_cast<std::ptrdiff_t>((first + layout_.lanes + 63) / 64),
                    [](std::uint64_t word) { return word == 0; }))
      continue;
    std::uint8_t* const own = rows(g);
    std::memcpy(own, &head, sizeof head);
    putTruth(own + layout_.active(), layout_, running.data(), first);
    scanned_.push_back(own);
  }
  laneCode_.run(scanned_);
  TraceSet left(count_ / 64);
  for (std::size_t g = 0; g < groupCount(); ++g)
    takeTruth(rows(g) + layout_.left(), layout_, left.data(), g * layout_.lanes);
  for (std::size_t i = 0; i < left.size(); ++i) left[i] &= running[i];
  return left;
}

std::optional<TraceSet> LaneGroups::whereOn(Area area, std::uint32_t byte, std::uint32_t bit) const {
  const auto slot = std::ranges::find(slots_, compiled::SlotByte{area, byte});
  if (slot == slots_.end() || isCommon(area, byte)) return std::nullopt;
  TraceSet on(count_ / 64);
  const std::size_t at = layout_.slot(static_cast<std::size_t>(slot - slots_.begin()) * 8 + bit);
  for (std::size_t g = 0; g < groupCount(); ++g) takeTruth(rows(g) + at, layout_, on.data(), g * layout_.lanes);
  return on;
}

TraceSet LaneGroups::errorsIn(const std::uint8_t* rows, std::size_t trace) const {
  TraceSet sites((sites_ + 63) / 64);
  for (std::size_t site = 0; site < sites_; ++site) {
    const Row row{layout_.error(site), Rep::Truth};
    sites[site / 64] |= numberIn(rows, row, trace % layout_.lanes, layout_.form) << (site % 64);
  }
  return sites;
}

}  // namespace rungproof::lanes
