// Places that recorded code finds by computed addresses: pointers of an S7-200 into V memory, and of an S7-300/400 into
// the areas and data blocks whose bounds are checked as the access is made. Everything else is left to the reference
// engine.
#include "engine/compiled/recorder.hpp"
#include "ir/s7300/place.hpp"

namespace rungproof::compiled {

namespace {

/// So many data blocks at most are told apart by comparing the number of an open one.
constexpr std::size_t mostBlocks = 32;
/// Bytes of an area in which a bit has an address of 32 bits, and in which any access has a place.
constexpr std::uint32_t mostBytes = 1U << 28, leastBytes = 4;

bool isFollowed(std::optional<std::uint64_t> area) {
  constexpr Area followed[] = {Area::I, Area::Q, Area::M, Area::L, Area::DB};
  return area && *area < areaCount && std::ranges::find(followed, static_cast<Area>(*area)) != std::end(followed);
}

}  // namespace

void Recorder::reaches(Area area, std::uint32_t first, std::uint32_t count, bool isWritten) {
  const Reached reached{area, first, count, isWritten};
  if (std::ranges::find(code.reached, reached) == code.reached.end()) code.reached.push_back(reached);
}

/// What was stored or loaded there last is still there.
Recorder::Bits Recorder::loadPlace(Area area, Bits address, int width) {
  const bool isKnown = place_ && place_->area == area && place_->a == address.id && int{place_->width} == width;
  if (isKnown) return extract({place_->b}, width - 1, 0);
  const Step load{.op = CodeOp::LoadAt, .width = static_cast<std::uint8_t>(width), .area = area, .a = address.id};
  place_ = load;
  place_->b = add(load);
  return {place_->b};
}

void Recorder::savePlace(Area area, Bits address, int width, Bits value) {
  const Step step{
      .op = CodeOp::StoreAt, .width = static_cast<std::uint8_t>(width), .area = area, .a = address.id, .b = value.id};
  add(step);
  store->forget(area);
  place_ = step;
}

/// Pointers that name V are followed.
Recorder::Bool Recorder::targets(Machine<Recorder>& machine, Bits pointer, Width width, Ref<Recorder>& ref) {
  const std::uint32_t size = store->size(Area::V), wide = static_cast<std::uint32_t>(bytes(width));
  const std::uint32_t first = pointer::encode(Area::V, 0);
  if (size < wide || machine.areaSize(Area::V) != size) {
    cannotFollow(32);
    return constant(false);
  }
  const Bits offset = sub(pointer, literal(first, 32), 32);
  const Bool isOutside = ult(literal(size - wide, 32), offset, 32);
  reaches(Area::V, 0, size, false);
  ref.isComputed = true;
  ref.value = code.isStraight && !code.isWholeScan ? select(isOutside, literal(0, 32), offset, 32) : offset;
  leave(land(*guard, isOutside));
  return constant(true);
}

/// An address where runs that do not make the access have one too. Code of many traces bears any address, and takes
/// longer where they differ.
Recorder::Bits Recorder::safe(Bits address) {
  return code.isWholeScan ? address : select(*guard, address, literal(0, 32), 32);
}

Recorder::Bits Recorder::loadAt(const Ref<Recorder>& ref, int element, Width width) {
  if (element != 0) return cannotFollow(bits(width));
  return loadPlace(Area::V, safe(ref.value), bits(width));
}

void Recorder::saveAt(const Ref<Recorder>& ref, int element, Width width, Bits value) {
  if (element != 0) {
    cannotFollow(1);
    return;
  }
  const Bits written = truth(*guard) == true ? value : select(*guard, value, loadAt(ref, 0, width), bits(width));
  savePlace(Area::V, safe(ref.value), bits(width), written);
  reaches(Area::V, 0, store->size(Area::V), true);
}

/// The bytes of an area, or of the data block of that number; none where they cannot be told, or do not exist.
std::optional<Recorder::Row> Recorder::rowOf(Machine<Recorder>& machine, Area area, Bits block) {
  if (store->size(area) < leastBytes || store->size(area) >= mostBytes) return std::nullopt;
  if (area != Area::DB) {
    const std::uint32_t size = area == Area::L ? machine.plan.localBytes : machine.areaSize(area);
    if (size > store->size(area)) return std::nullopt;
    return Row{literal(0, 32), literal(size, 32)};
  }
  const std::vector<DataBlock>& blocks = machine.plan.program->dataBlocks;
  hasReadOnlyBlocks_ = std::ranges::any_of(blocks, [](const DataBlock& b) { return b.readOnly; });
  if (!known(block) && blocks.size() > mostBlocks) return std::nullopt;
  Row row{literal(0, 32), literal(0, 32)};
  for (const DataBlock& b : blocks) {
    const std::uint32_t length = store->blocks().length(b.number);
    if (length == 0 || store->blocks().isUnlinked(b.number)) continue;
    const Bool isThis = equal(block, literal(b.number, 16), 16);
    if (truth(isThis) == false) continue;
    row.first = select(isThis, literal(store->blocks().place(dataByte(b.number, 0)), 32), row.first, 32);
    row.count = select(isThis, literal(length, 32), row.count, 32);
  }
  return row;
}

bool Recorder::follows(Machine<Recorder>& machine, Bits location, Width width, Spot<Recorder>& spot) {
  const auto code8 = known(extract(location, 47, 40));
  if (!isFollowed(code8)) return false;
  const Area area = static_cast<Area>(*code8);
  const std::optional<Row> row = rowOf(machine, area, extract(location, 39, 24));
  if (!row) return false;
  const Bits address = extract(location, 23, 0);
  const Bits behind = add(extract(address, 23, 3), literal(static_cast<std::uint64_t>(bytes(width)), 32), 32);
  Bool isWrong = ult(row->count, behind, 32);
  if (width != Width::Bit) isWrong = lor(isWrong, lnot(equal(extract(address, 2, 0), literal(0, 3), 3)));
  const Bool isReal = code.isStraight ? land(*guard, lnot(isWrong)) : *guard;
  spot.isComputed = true;
  spot.area = area;
  const Bits first = shl(row->first, literal(3, 32), 32);
  const Bits place = add(first, address, 32);
  spot.value = code.isWholeScan ? place : select(isReal, place, literal(0, 32), 32);
  const auto start = known(row->first), count = known(row->count);
  if (start && count)
    reaches(area, static_cast<std::uint32_t>(*start), static_cast<std::uint32_t>(*count), false);
  else
    reaches(area, 0, store->size(area), false);
  leave(land(*guard, isWrong));
  return true;
}

Recorder::Bits Recorder::loadComputed(const Spot<Recorder>& spot, Width width) {
  const int w = width == Width::Bit ? 8 : bits(width);
  const Bits byte = extract(spot.value, 31, 3);
  const Bits loaded = loadPlace(spot.area, byte, w);
  if (width != Width::Bit) return loaded;
  return extract(lshr(loaded, extract(spot.value, 2, 0), 8), 0, 0);
}

void Recorder::saveComputed(const Spot<Recorder>& spot, Width width, Bits value) {
  if (truth(*guard) == false) return;
  if (spot.area == Area::DB && hasReadOnlyBlocks_) return leave(*guard);
  const int w = width == Width::Bit ? 8 : bits(width);
  const Bits byte = extract(spot.value, 31, 3);
  const bool isMixed = width == Width::Bit || truth(*guard) != true;
  const Bits old = isMixed ? loadComputed(spot, width == Width::Bit ? Width::Byte : width) : value;
  if (width == Width::Bit) {
    const Bits mask = shl(literal(1, 8), extract(spot.value, 2, 0), 8);
    value = select(bit(value, 0), bor(old, mask, 8), band(old, bnot(mask, 8), 8), 8);
  }
  const Bits written = select(*guard, value, old, w);
  savePlace(spot.area, byte, w, written);
  for (std::size_t i = code.reached.size(); i-- > 0;) {
    const Reached r = code.reached[i];
    if (r.area == spot.area) reaches(r.area, r.first, r.count, true);
  }
}

}  // namespace rungproof::compiled
