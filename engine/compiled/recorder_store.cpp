// Memory of recorded code. What was stored last is known, so that it is not read again; steps that store come at once,
// and those that nothing reads fall away later (engine/compiled/reduce.hpp).
#include "engine/compiled/recorder.hpp"

namespace rungproof::compiled {

namespace {

/// Registers that only the program's own instructions look at; what moves the others is for the reference engine.
bool isProgramsOwn(Reg reg) {
  switch (reg) {
    case Reg::Accumulator:
    case Reg::TimerCurrent:
    case Reg::TimerBit:
    case Reg::TimerRunning:
    case Reg::TimerPreset:
    case Reg::TimerInput:
    case Reg::CounterCurrent:
    case Reg::CounterBit:
    case Reg::CounterUp:
    case Reg::CounterDown:
    case Reg::EdgeMemory:
    case Reg::EdgeSeen:
    case Reg::PhysicalOutput:
    case Reg::PidHistory:
    case Reg::S5Rest:
    case Reg::S5Base:
    case Reg::S5AtEnd:
    case Reg::S5Free:
    case Reg::S7Set:
    case Reg::S7Free:
    case Reg::Eno: return true;
    default: return false;
  }
}

std::array<std::uint32_t, areaCount> sizesOf(const Concrete::Store& model) {
  std::array<std::uint32_t, areaCount> sizes;
  for (std::size_t a = 0; a < areaCount; ++a)
    sizes[a] = static_cast<std::uint32_t>(model.area(static_cast<Area>(a)).size());
  return sizes;
}

/// Terminals are bytes as areas are; an S7-200 has nothing else in those (Code::hasTerminals).
Area terminalArea(Reg reg) { return reg == Reg::PhysicalInput ? Area::PI : Area::PQ; }

}  // namespace

Recorder::Store::Store(Recorder& recorder, const Concrete::Store& model, const std::vector<SlotByte>& slots)
    : d_(recorder),
      model_(model),
      sizes_(sizesOf(model)),
      bits_(slots.size() * 8),
      registers_(model.registers().size()) {
  if (recorder.code.hasTerminals)
    sizes_[static_cast<std::size_t>(Area::PI)] = sizes_[static_cast<std::size_t>(Area::PQ)] =
        static_cast<std::uint32_t>(Concrete::Store::Terminals{}.size());
  accesses_.resize(areaCount);
  for (std::size_t a = 0; a < areaCount; ++a) {
    const std::size_t bytes = size(static_cast<Area>(a));
    slotOf_[a].assign(bytes, 0);
    parts_[a].assign(bytes, {});
    accesses_[a].assign(bytes, {});
    epochs_[a] = 1;
  }
  for (std::size_t i = 0; i < slots.size(); ++i)
    slotOf_[static_cast<std::size_t>(slots[i].area)][slots[i].byte] = static_cast<std::uint32_t>(8 * i + 1);
  recorder.code.slots = slots;
  recorder.store = this;
}

std::optional<std::uint32_t> Recorder::Store::slotOf(Area area, std::uint32_t byte) const {
  const std::uint32_t slot = slotOf_[static_cast<std::size_t>(area)][byte];
  return slot == 0 ? std::nullopt : std::optional(slot - 1);
}

void Recorder::Store::noteBit(Area area, std::uint32_t bitOffset) {
  AccessCount& count = accesses_[static_cast<std::size_t>(area)][bitOffset / 8];
  ++count.bits;
  count.isSingle = count.isSingle && bitOffset % 8 == 0;
}
void Recorder::Store::noteByte(Area area, std::uint32_t byte) {
  ++accesses_[static_cast<std::size_t>(area)][byte].words;
}

void Recorder::Store::forget() {
  ++epoch_;
  ++bitEpoch_;
  for (std::uint32_t& epoch : epochs_) ++epoch;
}
void Recorder::Store::forgetSince(std::size_t first) {
  ++epoch_;
  for (std::uint32_t& epoch : epochs_) ++epoch;
  loadedSince_ = static_cast<ValueId>(d_.code.steps.size());
  for (std::size_t i = first; i < loadedSince_; ++i) {
    const Step& s = d_.code.steps[i];
    if (s.op == CodeOp::LoadBit || s.op == CodeOp::StoreBit) bits_[s.value].epoch = 0;
    if (s.op == CodeOp::StoreSlots) forgetSlots(static_cast<std::uint32_t>(s.value));
  }
}
void Recorder::Store::forgetSlots(std::uint32_t first) {
  for (std::uint32_t bit = 0; bit < 8; ++bit) bits_[first + bit].epoch = 0;
}
void Recorder::Store::forget(Area area) { ++epochs_[static_cast<std::size_t>(area)]; }

Recorder::Bool Recorder::Store::loadSlot(std::uint32_t slot) {
  Known& known = bits_[slot];
  const bool isThere = known.value >= loadedSince_ || known.value <= 1 || d_.at(known.value).op == CodeOp::LoadBit;
  if (known.epoch != bitEpoch_ || !isThere)
    known = {bitEpoch_, d_.add({.op = CodeOp::LoadBit, .width = 1, .value = slot})};
  return {known.value};
}

void Recorder::Store::saveSlot(std::uint32_t slot, Bool value) {
  bits_[slot] = {bitEpoch_, value.id};
  d_.add({.op = CodeOp::StoreBit, .a = value.id, .value = slot});
}

Recorder::Bits Recorder::Store::loadByte(Area area, std::uint32_t byte) {
  const std::optional<std::uint32_t> slot = slotOf(area, byte);
  return slot ? Bits{d_.add({.op = CodeOp::LoadSlots, .width = 8, .value = *slot})} : loadWhole(area, byte, 1);
}

void Recorder::Store::saveByte(Area area, std::uint32_t byte, Bits value) {
  const std::optional<std::uint32_t> slot = slotOf(area, byte);
  if (!slot) return saveWhole(area, byte, 1, value);
  forgetSlots(*slot);
  d_.add({.op = CodeOp::StoreSlots, .a = value.id, .value = *slot});
}

/// `count` bytes, none of which has slots.
Recorder::Bits Recorder::Store::loadWhole(Area area, std::uint32_t byte, int count) {
  const Part first = part(area, byte);
  bool isOneValue = true;
  for (int i = 0; i < count; ++i) {
    const Part& p = part(area, byte + static_cast<std::uint32_t>(i));
    isOneValue = isOneValue && p.epoch == epoch(area) && p.value == first.value && p.low + 8 * i == first.low;
  }
  if (isOneValue) {
    const int low = first.low - 8 * (count - 1);
    return d_.extract({first.value}, low + 8 * count - 1, low);
  }
  const Bits loaded{
      d_.add({.op = CodeOp::LoadMemory, .width = static_cast<std::uint8_t>(8 * count), .area = area, .value = byte})};
  for (int i = 0; i < count; ++i)
    part(area, byte + static_cast<std::uint32_t>(i)) = {epoch(area), loaded.id,
                                                        static_cast<std::uint8_t>(8 * (count - 1 - i))};
  return loaded;
}

void Recorder::Store::saveWhole(Area area, std::uint32_t byte, int count, Bits value) {
  d_.add({.op = CodeOp::StoreMemory,
          .width = static_cast<std::uint8_t>(8 * count),
          .area = area,
          .a = value.id,
          .value = byte});
  for (int i = 0; i < count; ++i)
    part(area, byte + static_cast<std::uint32_t>(i)) = {epoch(area), value.id,
                                                        static_cast<std::uint8_t>(8 * (count - 1 - i))};
}

/// A bit of a byte that has no slots.
void Recorder::Store::saveBit(Area area, std::uint32_t byte, std::uint32_t bit, Bool value) {
  const Bits others = d_.band(loadWhole(area, byte, 1), d_.literal(~(1ULL << bit), 8), 8);
  const Bits own = d_.shl(d_.freshFromBool(value, 8), d_.literal(bit, 8), 8);
  saveWhole(area, byte, 1, d_.bor(others, own, 8));
}

Recorder::Bits Recorder::Store::load(Area area, std::uint32_t bitOffset, int width) {
  if (area == Area::DB) bitOffset = model_.blocks().bitPlace(bitOffset);
  const Bits value = loadPlace(area, bitOffset, width);
  return d_.code.isWholeScan && width > 1 ? d_.ofGuard(value) : value;
}

Recorder::Bits Recorder::Store::loadPlace(Area area, std::uint32_t bitOffset, int width) {
  if (width == 64) {  // memory is read and written by up to 32 bits
    const Bits high = loadPlace(area, bitOffset, 32);
    return d_.concat(high, 32, loadPlace(area, bitOffset + 32, 32), 32);
  }
  const std::uint32_t byte = bitOffset / 8;
  const int count = width == 1 ? 1 : width / 8;
  if (byte + static_cast<std::uint32_t>(count) > size(area)) return d_.cannotFollow(width);
  if (width == 1) {
    if (isFixed(area, bitOffset)) return d_.literal(1, 1);
    noteBit(area, bitOffset);
    if (const auto slot = slotOf(area, byte)) return d_.fromBool(loadSlot(*slot + bitOffset % 8), 1);
    return d_.fromBool(d_.bit(loadWhole(area, byte, 1), static_cast<int>(bitOffset % 8)), 1);
  }
  bool hasSlots = false;
  for (int i = 0; i < count; ++i) {
    noteByte(area, byte + static_cast<std::uint32_t>(i));
    hasSlots = hasSlots || slotOf(area, byte + static_cast<std::uint32_t>(i)).has_value();
  }
  if (!hasSlots) return loadWhole(area, byte, count);
  Bits value = loadByte(area, byte);
  for (int i = 1; i < count; ++i)
    value = d_.concat(value, 8 * i, loadByte(area, byte + static_cast<std::uint32_t>(i)), 8);
  return value;
}

void Recorder::Store::save(Area area, std::uint32_t bitOffset, int width, Bits value, Bool guard) {
  if (d_.truth(guard) == false) return;
  if (area == Area::DB) bitOffset = model_.blocks().bitPlace(bitOffset);
  if (width == 64) {
    save(area, bitOffset, 32, d_.extract(value, 63, 32), guard);
    return save(area, bitOffset + 32, 32, d_.extract(value, 31, 0), guard);
  }
  const std::uint32_t byte = bitOffset / 8;
  const int count = width == 1 ? 1 : width / 8;
  if (byte + static_cast<std::uint32_t>(count) > size(area)) {
    d_.leave(guard);
    return;
  }
  if (area == Area::L) guard = d_.guardOfLocal(guard, byte);
  if (d_.truth(guard) != true) {
    const Bits old = loadPlace(area, bitOffset, width);
    value = d_.select(guard, value, old, width);
    if (value.id == old.id) return;
  }
  if (width == 1) {
    noteBit(area, bitOffset);
    const Bool on = d_.bit(value, 0);
    if (const auto slot = slotOf(area, byte)) return saveSlot(*slot + bitOffset % 8, on);
    return saveBit(area, byte, bitOffset % 8, on);
  }
  bool hasSlots = false;
  for (int i = 0; i < count; ++i) {
    noteByte(area, byte + static_cast<std::uint32_t>(i));
    hasSlots = hasSlots || slotOf(area, byte + static_cast<std::uint32_t>(i)).has_value();
  }
  if (!hasSlots) return saveWhole(area, byte, count, value);
  for (int i = 0; i < count; ++i) {
    const int low = 8 * (count - 1 - i);
    saveByte(area, byte + static_cast<std::uint32_t>(i), d_.extract(value, low + 7, low));
  }
}

void Recorder::Store::clear(Area area, std::uint32_t byte, std::uint32_t count) {
  const Bits zero = d_.literal(0, 8);
  for (std::uint32_t i = 0; i < count;) {
    std::uint32_t run = 0;
    while (run < 8 && i + run < count && !slotOf(area, byte + i + run)) ++run;
    if (run == 8) {
      saveWhole(area, byte + i, 8, zero);
      i += 8;
    } else {
      saveByte(area, byte + i++, zero);
    }
  }
}

/// Terminals whose place an area takes are not.
bool Recorder::Store::isHere(Reg reg) const { return d_.code.hasTerminals || !Concrete::Store::isTerminal(reg); }

Recorder::Bits Recorder::Store::get(Reg reg, std::uint32_t index) {
  if (reg == Reg::Reading) return d_.literal(model_.get(reg, index), 1);
  if (reg == Reg::Running) return d_.literal(1, 1);  // STOP leaves the compiled code
  if (reg == Reg::FirstScan && !d_.code.isWholeScan) return d_.literal(0, 1);
  const int width = regInfo(reg).width;
  if (index >= model_.count(reg) || !isHere(reg)) return d_.cannotFollow(width);
  if (Concrete::Store::isTerminal(reg))
    return d_.fromBool(d_.bit(loadWhole(terminalArea(reg), index / 8, 1), static_cast<int>(index % 8)), 1);
  const std::size_t at = model_.indexOf(reg, index);
  Known& known = registers_[at];
  if (known.epoch != epoch_)
    known = {epoch_, d_.add({.op = CodeOp::LoadRegister, .width = static_cast<std::uint8_t>(width), .value = at})};
  return {known.value};
}

void Recorder::Store::set(Reg reg, std::uint32_t index, Bits value, Bool guard) {
  if (d_.truth(guard) == false) return;
  if (index >= model_.count(reg) || !(isProgramsOwn(reg) || d_.isAround) || !isHere(reg)) {
    d_.leave(guard);
    return;
  }
  if (d_.truth(guard) != true) {
    const Bits old = get(reg, index);
    value = d_.select(guard, value, old, regInfo(reg).width);
    if (value.id == old.id) return;
  }
  if (Concrete::Store::isTerminal(reg)) return saveBit(terminalArea(reg), index / 8, index % 8, d_.bit(value, 0));
  const std::size_t at = model_.indexOf(reg, index);
  registers_[at] = {epoch_, value.id};
  d_.add({.op = CodeOp::StoreRegister, .a = value.id, .value = at});
}

}  // namespace rungproof::compiled
