// Cuts memory into words and bits by the accesses of the program.
#include "analysis/encoding/memory_layout.hpp"

#include "analysis/flow/access.hpp"
#include "ir/s7200/special_memory.hpp"
#include "ir/s7300/declarations.hpp"

namespace rungproof {

namespace {

/// Every value of one to four bytes in what is declared from `byte` on.
template <class Take>
void eachValue(const s7300::Type& type, std::uint32_t byte, Take&& take) {
  if (type.kind == s7300::TypeKind::Struct && type.structure) {
    for (const s7300::Field& field : type.structure->fields) {
      if (!field.byReference) eachValue(field.type, byte + field.byte, take);
    }
  } else if (type.kind == s7300::TypeKind::Array && type.element) {
    // Bits of an array lie side by side; of more dimensions each row begins anew, which nothing is said of.
    const auto size = static_cast<std::uint32_t>(s7300::sizeOf(*type.element));
    const bool isRow = type.bounds.size() == 1 && size > 1;
    for (std::uint32_t i = 0; isRow && i < type.bounds[0].count(); ++i)
      eachValue(*type.element, byte + i * (size + size % 2), take);
  } else if (const std::optional<Width> width = s7300::accessWidth(type)) {
    take(byte, *width);
  }
}

}  // namespace

MemoryLayout::MemoryLayout(const Plan& plan) : blocks_(plan.blocks) {
  const Target& target = plan.program->target;
  for (int a = 0; a < areaCount; ++a) {
    const Area area = static_cast<Area>(a);
    const bool inRegisters = addressedByNumber(area);
    cuts_[static_cast<std::size_t>(a)].resize(inRegisters        ? 0
                                              : area == Area::L  ? plan.localBytes
                                              : area == Area::DB ? blocks_->size()
                                                                 : areaSize(target, area));
  }
  std::vector<Cut>& special = cuts_[static_cast<std::size_t>(Area::SM)];
  for (const SmRow& row : smTable(target)) {
    if (row.first >= special.size()) break;
    special[row.first].startsHere = true;
    if (row.low != 0 || row.high != 7) special[row.first].isSingleBits = true;
  }
}

void MemoryLayout::add(const Program& program, const Plan& plan) {
  const AccessTable table(program, plan);
  for (const Access& access : table.all()) {
    if (access.viaPointer || access.byNumber() || access.area == Area::L) continue;
    if (access.width == Width::Bit) {
      for (std::uint32_t i = 0; i < access.possibleLength(); ++i) add(access.area, Width::Bit, access.offset + i);
    } else {
      for (std::uint32_t k = 0; k < access.most; ++k)
        add(access.area, access.width, access.offset + k * static_cast<std::uint32_t>(bytes(access.width)));
    }
  }
  // The statements of IEC timers reach their instances through registers: IN, Q and the bits of STATE; PT, ET and
  // ATIME.
  for (const std::uint32_t instance : plan.iecTimers) {
    for (const std::uint32_t bit : {0U, 6U, 12U}) add(Area::DB, Width::Bit, instance + bit);
    for (const std::uint32_t time : {2U, 8U, 18U}) add(Area::DB, Width::DWord, instance + time);
  }
  // An FB reaches the data of its instances through AR2: they are cut as they are declared.
  for (const DataBlock& block : program.dataBlocks) {
    if (block.instanceOf == 0 || program.declarations == nullptr) continue;
    const auto structure = program.declarations->dataBlocks.find(block.number);
    if (structure == program.declarations->dataBlocks.end()) continue;
    const s7300::Type type{.kind = s7300::TypeKind::Struct, .structure = structure->second};
    eachValue(type, 0, [&](std::uint32_t byte, Width width) { add(Area::DB, width, dataByte(block.number, byte)); });
  }
}

void MemoryLayout::add(Area area, Width width, std::uint32_t name) {
  const std::uint32_t byte = inRow(area, name);
  std::vector<Cut>& cuts = cuts_[static_cast<std::size_t>(area)];
  const std::uint32_t end = byte + static_cast<std::uint32_t>(bytes(width));
  if (end > cuts.size()) return;
  if (width == Width::Bit) cuts[byte].isSingleBits = true;
  cuts[byte].startsHere = true;
  if (end < cuts.size()) cuts[end].startsHere = true;
  for (std::uint32_t i = byte; i + 1 < end; ++i) cuts[i].joinsNext = true;
}

void MemoryLayout::beginAt(Area area, std::uint32_t name) {
  const std::uint32_t byte = inRow(area, name);
  std::vector<Cut>& cuts = cuts_[static_cast<std::size_t>(area)];
  if (byte < cuts.size()) cuts[byte].startsHere = true;
}

/// Whether the byte and the next belong to one word.
bool MemoryLayout::isJoined(Area area, std::uint32_t byte) const {
  if (byte + 1 >= size(area)) return false;
  const Cut& here = cut(area, byte);
  const Cut& next = cut(area, byte + 1);
  return here.joinsNext && !here.isSingleBits && !next.isSingleBits && !next.startsHere;
}

MemoryLayout::Word MemoryLayout::wordOf(Area area, std::uint32_t byte) const {
  std::uint32_t first = byte;
  while (first > 0 && isJoined(area, first - 1)) --first;
  std::uint32_t count = 1;
  while (isJoined(area, first + count - 1)) ++count;
  // Long rows of overlapping words are cut every four bytes from their start.
  const std::uint32_t start = first + (byte - first) / 4 * 4;
  return {start, std::min<std::uint32_t>(4, first + count - start)};
}

}  // namespace rungproof
