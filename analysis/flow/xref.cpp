// The cross reference.
#include "analysis/flow/xref.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <tuple>

#include "analysis/flow/open_blocks.hpp"
#include "ir/block_map.hpp"
#include "ir/s7300/block.hpp"

namespace rungproof {

namespace {

/// Bit and value of a timer or counter are two things under one number, not an overlap.
bool shareStorage(const XrefEntry& a, const XrefEntry& b) {
  const bool isTimed = hasBitAndWord(a.area);
  return !isTimed || (a.width == Width::Bit) == (b.width == Width::Bit);
}

void findOverlaps(std::vector<XrefEntry>& entries) {
  std::vector<std::size_t> order(entries.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  const auto key = [&](std::size_t i) {
    return std::tuple(entries[i].area, entries[i].block, entries[i].firstBit(), i);
  };
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  std::vector<std::size_t> open;  // entries that reach beyond the current one's beginning
  for (const std::size_t current : order) {
    XrefEntry& entry = entries[current];
    std::erase_if(open, [&](std::size_t i) {
      return entries[i].area != entry.area || entries[i].block != entry.block ||
             entries[i].endBit() <= entry.firstBit();
    });
    for (const std::size_t other : open) {
      if (!shareStorage(entries[other], entry)) continue;
      entries[other].overlaps.push_back(current);
      entry.overlaps.push_back(other);
    }
    open.push_back(current);
  }
  for (XrefEntry& entry : entries) std::sort(entry.overlaps.begin(), entry.overlaps.end());
}

/// Marks what the program names and gives the rest of the areas a programmer assigns.
std::vector<FreeRange> freeRanges(const Facts& facts, const std::vector<XrefEntry>& entries) {
  const Program& program = facts.program();
  std::map<Area, std::vector<bool>> used;
  for (const Area area : {Area::I, Area::Q, Area::V, Area::M, Area::S, Area::T, Area::C})
    used[area].resize(areaSize(program.target, area));
  const auto mark = [&](Area area, std::uint32_t first, std::uint32_t length) {
    const auto row = used.find(area);
    if (row == used.end()) return;
    for (std::uint32_t i = first; i < first + length && i < row->second.size(); ++i) row->second[i] = true;
  };
  for (const XrefEntry& entry : entries) {
    for (const Access* access : entry.uses) mark(entry.area, access->offset, std::max(access->possibleLength(), 1U));
  }
  for (const DataInit& data : program.data) mark(Area::V, data.offset, static_cast<std::uint32_t>(data.bytes.size()));
  for (const InstructionPlace& place : facts.instructions()) {
    for (const Operand& operand : place.instruction->operands) {
      if (operand.kind == OperandKind::Address)
        mark(operand.area, operand.offset, static_cast<std::uint32_t>(bytes(operand.width)));
    }
  }
  std::vector<FreeRange> free;
  for (const auto& [area, marks] : used) {
    for (std::uint32_t i = 0; i < marks.size(); ++i) {
      if (marks[i]) continue;
      std::uint32_t last = i;
      while (last + 1 < marks.size() && !marks[last + 1]) ++last;
      free.push_back({area, i, last});
      i = last;
    }
  }
  return free;
}

/// S7-300/400: where the instances of function blocks lie, also those inside of others.
class Instances {
 public:
  struct Place {
    std::uint32_t dataBlock, first;
  };

  explicit Instances(const Facts& facts) : facts_(facts) {
    if (!facts.dialect().memory.hasDataBlocks) return;
    const Program& program = facts.program();
    for (const CallSite& site : facts.calls().sites()) {  // UC and CC call on whatever is open
      if (site.callee != noBlock && site.instruction->operands.size() < 2) isAnywhere_.insert(site.callee);
    }
    states_.resize(program.pous.size());
    for (std::uint32_t block = 0; block < program.pous.size(); ++block) {
      if (hasInstance(program.pous[block])) collect(block, program.pous[block].number, 0, 0);
    }
  }

  /// The places that the access to own data of a function block may mean; empty: they are not known.
  std::span<const Place> of(const Access& access) {
    const InstructionPlace& at = facts_.place(access.instruction);
    const Instruction& instruction = *at.instruction;
    const auto found = places_.find(at.block);
    if (found == places_.end() || isAnywhere_.contains(at.block) || access.operand >= instruction.operands.size() ||
        facts_.program().pous[at.block].isBuiltIn)
      return {};
    const Operand& operand = instruction.operands[access.operand];
    if (operand.reach == nullptr || operand.reach->way != Way::Instance) return {};
    OpenStates& states = states_[at.block];
    if (states.empty()) states = openStates(facts_.program(), facts_.plan().flows[at.block]);
    const std::optional<OpenState>& open = states[at.step];
    if (!open || open->isDiMoved || open->isAr2Moved) return {};
    return found->second;
  }

 private:
  void collect(std::uint32_t block, int number, std::uint32_t first, int depth) {
    constexpr int mostLevels = 8;  // that instances may be nested
    const Program& program = facts_.program();
    for (const DataBlock& data : program.dataBlocks) {
      if (data.instanceOf == number) places_[block].push_back({data.number, first});
    }
    for (const Pou& pou : program.pous) {
      for (const LocalVariable& local : pou.locals) {
        if (local.instanceOf == number && hasInstance(pou) && depth < mostLevels)
          collect(block, pou.number, first + local.address.offset, depth + 1);
      }
    }
  }

  const Facts& facts_;
  std::set<std::uint32_t> isAnywhere_;
  std::map<std::uint32_t, std::vector<Place>> places_;  ///< by block
  std::vector<OpenStates> states_;
};

}  // namespace

std::uint32_t XrefEntry::firstBit() const { return addressedByNumber(area) ? offset * 32 : offset * 8 + bit; }

std::uint32_t XrefEntry::endBit() const {
  if (addressedByNumber(area)) return (offset + count) * 32U;
  return firstBit() + count * static_cast<std::uint32_t>(bits(width));
}

Xref crossReference(const Facts& facts) {
  Xref xref;
  std::map<std::tuple<Area, std::uint32_t, std::uint32_t, std::uint8_t, Width, std::uint16_t>,
           std::vector<const Access*>>
      byPlace;
  Instances instances(facts);
  for (const Access& access : facts.accesses().all()) {
    if (access.viaPointer && access.pointed == Pointed::InArea) {
      const std::uint8_t bit = access.width == Width::Bit ? access.bit : 0;
      const std::span<const Instances::Place> places = instances.of(access);
      for (const auto& [dataBlock, first] : places)
        byPlace[{Area::DB, 0, dataByte(dataBlock, first + access.offset), bit, access.width, access.count}].push_back(
            &access);
      if (!places.empty()) continue;
    }
    if (access.viaPointer && access.pointed == Pointed::OfCall) continue;  // the call has it
    if (access.viaPointer) {
      xref.throughPointers.push_back(&access);
      continue;
    }
    const std::uint32_t block = access.area == Area::L ? facts.blockOf(access.instruction) : 0;
    const std::uint8_t bit = access.width == Width::Bit && !addressedByNumber(access.area) ? access.bit : 0;
    byPlace[{access.area, block, access.offset, bit, access.width, access.count}].push_back(&access);
  }
  for (auto& [place, uses] : byPlace) {
    XrefEntry& entry = xref.entries.emplace_back();
    std::tie(entry.area, entry.block, entry.offset, entry.bit, entry.width, entry.count) = place;
    entry.uses = std::move(uses);
  }
  findOverlaps(xref.entries);
  xref.free = freeRanges(facts, xref.entries);
  return xref;
}

std::vector<std::size_t> entriesTouching(const Xref& xref, const Operand& address) {
  XrefEntry wanted;
  wanted.area = address.area;
  wanted.width = address.width;
  wanted.offset = address.offset;
  wanted.bit = address.width == Width::Bit && !addressedByNumber(address.area) ? address.bit : 0;
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < xref.entries.size(); ++i) {
    const XrefEntry& entry = xref.entries[i];
    if (entry.area == wanted.area && entry.firstBit() < wanted.endBit() && wanted.firstBit() < entry.endBit())
      found.push_back(i);
  }
  return found;
}

std::string entryName(const XrefEntry& entry) {
  if (hasBitAndWord(entry.area)) {
    const std::string first = addressName(entry.area, Width::Bit, entry.offset);
    const std::string last =
        entry.count > 1 ? ".." + addressName(entry.area, Width::Bit, entry.offset + entry.count - 1U) : "";
    return fmt::format("{}{} ({})", first, last, entry.width == Width::Bit ? "bit" : "value");
  }
  const std::string first = addressName(entry.area, entry.width, entry.offset, entry.bit);
  if (entry.count <= 1) return first;
  if (entry.width == Width::Bit) {
    const std::uint32_t last = entry.firstBit() + entry.count - 1U;
    return first + ".." + addressName(entry.area, Width::Bit, last / 8, last % 8);
  }
  return first + ".." +
         addressName(entry.area, entry.width,
                     entry.offset + (entry.count - 1U) * static_cast<std::uint32_t>(bytes(entry.width)));
}

std::string rangeName(const FreeRange& range) {
  const Width width = addressedByNumber(range.area) ? Width::Bit : Width::Byte;
  const std::string first = addressName(range.area, width, range.first);
  return range.first == range.last ? first : first + ".." + addressName(range.area, width, range.last);
}

}  // namespace rungproof
