// Builds the lists in two passes (count, fill from the last access to the first) and the coverage marks.
#include "analysis/flow/access_index.hpp"

#include <algorithm>

#include "ir/s7200/cpu.hpp"

namespace rungproof {

namespace {

/// Bytes of local memory that a block of the program can have.
std::uint32_t localLength(const Program& program) {
  if (!dialectOf(program.target).memory.declaresLocals) return areaSize(program.target, Area::L);
  std::uint32_t longest = 0;
  for (const Pou& pou : program.pous) longest = std::max(longest, pou.localBytes);
  return longest;
}

}  // namespace

CellMap::CellMap(const Program& program)
    : blocks_(std::max<std::size_t>(program.pous.size(), 1)), dataBlocks_(program) {
  for (std::size_t a = 0; a < areaCount; ++a) {
    const Area area = static_cast<Area>(a);
    base_[a] = size_;
    length_[a] = area == Area::L    ? localLength(program)
                 : area == Area::DB ? dataBlocks_.size()
                                    : areaSize(program.target, area);
    size_ += length_[a] * static_cast<std::uint32_t>(area == Area::L ? blocks_ : 1);
  }
}

Area CellMap::areaOf(std::uint32_t cell) const {
  std::size_t a = areaCount - 1;
  while (a > 0 && (base_[a] > cell || length_[a] == 0)) --a;
  return static_cast<Area>(a);
}

std::uint32_t CellMap::offsetOf(std::uint32_t cell) const {
  const Area area = areaOf(cell);
  const std::uint32_t offset = cell - base_[static_cast<std::size_t>(area)];
  if (area == Area::DB) return dataBlocks_.dataByteAt(offset);
  return area == Area::L ? offset % length(area) : offset;
}

namespace {

/// Calls `visit(cell)` for `length` cells from the start of an access, as far as they exist.
template <class Visit>
void eachCell(const CellMap& cells, const Access& access, std::uint32_t block, std::uint32_t length, Visit visit) {
  for (std::uint32_t k = 0; k < length; ++k) {
    const std::uint32_t cell = cells.cell(access.area, access.offset + k, block);
    if (cell == cells.size()) return;
    visit(cell);
  }
}

}  // namespace

AccessIndex::AccessIndex(const Program& program, const AccessTable& table, const BlockRow& blockOf) : cells_(program) {
  first_.assign(cells_.size() + 1, 0);
  const auto isNarrow = [](const Access& a) { return !a.viaPointer && a.certainLength() <= longest; };
  const std::span<const Access> all = table.all();
  for (const Access& a : all) {
    if (isNarrow(a))
      eachCell(cells_, a, blockOf[a.instruction], a.certainLength(), [&](std::uint32_t cell) { ++first_[cell]; });
  }
  for (std::uint32_t c = 0; c < cells_.size(); ++c) first_[c + 1] += first_[c];
  entries_.resize(first_.back());
  for (std::uint32_t i = static_cast<std::uint32_t>(all.size()); i-- > 0;) {
    const Access& a = all[i];
    if (isNarrow(a)) {
      eachCell(cells_, a, blockOf[a.instruction], a.certainLength(),
               [&](std::uint32_t cell) { entries_[--first_[cell]] = i; });
    } else {
      wide_.push_back(i);
    }
  }
  std::ranges::reverse(wide_);
  for (std::vector<std::uint8_t>* marks : {&written_, &read_, &writtenAtLarge_, &readAtLarge_, &pointed_})
    marks->assign(cells_.size(), 0);
  cover(table, blockOf, true, {&written_, &writtenAtLarge_});
  cover(table, blockOf, false, {&read_, &readAtLarge_});
  coverPointers(program, table);
  for (const DataInit& init : program.data) {
    for (std::uint32_t k = 0; k < init.bytes.size(); ++k) {
      const std::uint32_t cell = cells_.cell(Area::V, init.offset + k, 0);
      if (cell != cells_.size()) written_[cell] = writtenAtLarge_[cell] = 1;
    }
  }
}

/// Accesses are collected as the farthest end per start cell and spread in one sweep.
void AccessIndex::cover(const AccessTable& table, const BlockRow& blockOf, bool writes, Cover marks) {
  std::vector<std::uint32_t> end(cells_.size(), 0), endAtLarge(cells_.size(), 0);
  for (const Access& a : table.all()) {
    if (a.viaPointer || (a.write != writes && !a.maybe)) continue;
    const std::uint32_t start = cells_.cell(a.area, a.offset, blockOf[a.instruction]);
    if (start == cells_.size()) continue;
    const std::uint32_t last = start + std::min(a.possibleLength(), cells_.left(start, a.area));
    end[start] = std::max(end[start], last);
    const bool isAtLarge = a.most > a.count || a.maybe || a.certainLength() > longest;
    if (isAtLarge) endAtLarge[start] = std::max(endAtLarge[start], last);
  }
  std::uint32_t until = 0, untilAtLarge = 0;
  for (std::uint32_t c = 0; c < cells_.size(); ++c) {
    until = std::max(until, end[c]);
    untilAtLarge = std::max(untilAtLarge, endAtLarge[c]);
    (*marks.any)[c] = c < until;
    (*marks.atLarge)[c] = c < untilAtLarge;
  }
}

/// A pointer made with & walks upwards from its address, so cells from there to the end of the area may be reached.
/// Pointers that no & explains may reach everything that a pointer can name (001:1461), those of an S7-300/400 data
/// blocks too.
void AccessIndex::coverPointers(const Program& program, const AccessTable& table) {
  struct Reach {
    bool reads = false, writes = false;
    void add(const Access& a) { (a.write ? writes : reads) = true; }
  };
  Reach anywhere;
  std::array<Reach, areaCount> within{};
  for (const std::uint32_t i : wide_) {
    const Access& a = table.all()[i];
    if (!a.viaPointer || a.pointed == Pointed::OfCall) continue;
    (a.pointed == Pointed::Anywhere ? anywhere : within[static_cast<std::size_t>(a.area)]).add(a);
  }
  const bool areNumbers = dialectOf(program.target).memory.numbersArePointers;
  std::array<std::uint32_t, areaCount> from{};
  from.fill(~0U);
  bool anyAddress = false, anyUnknownCall = false;
  const auto note = [&](const Instruction& instruction) {
    for (const Operand& o : instruction.operands) {
      if (o.kind != OperandKind::Address) continue;
      anyAddress = true;
      std::uint32_t& start = from[static_cast<std::size_t>(o.area)];
      start = std::min(start, o.offset);
      if (instruction.desc->control == Control::Call) anyUnknownCall = true;
    }
  };
  for (const Pou& pou : program.pous) {
    for (const Network& network : pou.networks) {
      for (const Instruction& instruction : network.instructions) note(instruction);
    }
  }
  if (anyUnknownCall) anywhere = {true, true};
  const auto isAny = [](const Reach& reach) { return reach.reads || reach.writes; };
  if (!isAny(anywhere) && std::ranges::none_of(within, isAny)) return;
  for (std::uint32_t c = 0; c < cells_.size(); ++c) {
    const Area area = cells_.areaOf(c);
    Reach reach = within[static_cast<std::size_t>(area)];
    const bool isPointable = rungproof::mayBePointedTo(area) || (areNumbers && area == Area::DB);
    const bool isExplained = anyAddress && !areNumbers;
    if (isPointable && (!isExplained || cells_.offsetOf(c) >= from[static_cast<std::size_t>(area)])) {
      reach.reads |= anywhere.reads;
      reach.writes |= anywhere.writes;
    }
    pointed_[c] = isAny(reach);
    if (reach.reads) read_[c] = readAtLarge_[c] = 1;
    if (reach.writes) written_[c] = writtenAtLarge_[c] = 1;
  }
}

}  // namespace rungproof
