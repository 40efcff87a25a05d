// Collects pointers in two passes over the accesses, then follows their addresses block by block.
#include "analysis/flow/dataflow_pointers.hpp"

#include <algorithm>
#include <optional>

namespace rungproof {

namespace {

/// Adds to a double word in place, as one steps a pointer.
bool isStep(const Instruction& instruction) {
  const Role role = roleOf(instruction);
  const bool adds = role == Role::Increment || role == Role::Decrement || role == Role::Add || role == Role::Sub;
  return adds && instruction.desc->operands[0].type == Type::DInt;
}

/// Bytes that an instruction adds to its last operand, if it is a step by a constant.
std::optional<std::int64_t> stepOf(const Instruction& instruction) {
  if (!isStep(instruction)) return std::nullopt;
  const auto constantOf = [&]() -> std::optional<std::int64_t> {
    if (instruction.operands.empty() || instruction.operands[0].kind != OperandKind::Constant) return std::nullopt;
    return instruction.operands[0].value;
  };
  switch (roleOf(instruction)) {
    case Role::Increment: return 1;
    case Role::Decrement: return -1;
    case Role::Add: return constantOf();
    case Role::Sub: {
      const auto value = constantOf();
      return value ? std::optional(-*value) : std::nullopt;
    }
    default: return std::nullopt;
  }
}

}  // namespace

/// A pointer between two settings of it, along one block.
struct PointerTable::Life {
  const Instruction* set = nullptr;  ///< the MOVD & in force, if the address is known
  Area area = Area::V;
  std::int64_t offset = 0;      ///< bytes from the start of the area
  const Access* use = nullptr;  ///< narrowest use
  int narrowest = 0;
  std::uint32_t network = noPartner;  ///< of the running sum of steps
  std::int64_t total = 0;
  const Instruction* last = nullptr;
  bool isComputed = false;          ///< some step is not a constant
  std::vector<PointerStride> sums;  ///< of the networks before
};

PointerTable::PointerTable(const Facts& facts) {
  collectUses(facts);
  if (pointers_.empty()) return;
  collectWrites(facts);
  for (std::uint32_t block = 0; block < facts.plan().flows.size(); ++block)
    followBlock(facts, facts.plan().flows[block], block);
  std::sort(strides_.begin(), strides_.end(),
            [](const PointerStride& a, const PointerStride& b) { return a.last->id < b.last->id; });
}

std::uint64_t PointerTable::key(Area area, std::uint32_t offset, std::uint32_t block) const {
  const bool isShared = area == Area::V;
  return static_cast<std::uint64_t>(area) << 56 | static_cast<std::uint64_t>(isShared ? 0 : block) << 32 | offset;
}

Pointer* PointerTable::at(Area area, std::uint32_t offset, std::uint32_t block) {
  const auto found = byPlace_.find(key(area, offset, block));
  return found == byPlace_.end() ? nullptr : &pointers_[found->second];
}

const Pointer* PointerTable::find(const Access& access, std::uint32_t block) const {
  const auto found = byPlace_.find(key(access.area, access.offset, block));
  return found == byPlace_.end() ? nullptr : &pointers_[found->second];
}

void PointerTable::collectUses(const Facts& facts) {
  for (const Access& access : facts.accesses().all()) {
    if (!access.viaPointer) continue;
    const std::uint32_t block = facts.blockOf(access.instruction);
    const auto [place, isNew] = byPlace_.emplace(key(access.area, access.offset, block), pointers_.size());
    if (isNew) {
      Pointer& pointer = pointers_.emplace_back();
      pointer.area = access.area;
      pointer.offset = access.offset;
      pointer.block = block;
    }
    pointers_[place->second].uses.push_back(&access);
  }
  for (Pointer& pointer : pointers_) {
    const std::uint32_t cell = facts.index().cells().cell(pointer.area, pointer.offset, pointer.block);
    const bool isOutside = cell == facts.index().cells().size();
    if (isOutside || facts.index().isWrittenAtLarge(cell) || facts.isExternal(cell))
      pointer.isSet = pointer.isSetAgain = true;
    if (pointer.area != Area::L) continue;
    for (const LocalVariable& local : facts.program().pous[pointer.block].locals) {
      const bool isParameter = local.section == VarSection::Input || local.section == VarSection::InOut;
      if (isParameter && local.address.offset <= pointer.offset && pointer.offset < local.address.offset + 4)
        pointer.isSet = pointer.isSetAgain = true;
    }
  }
}

void PointerTable::collectWrites(const Facts& facts) {
  for (const Access& access : facts.accesses().all()) {
    if (access.viaPointer || !mayHoldPointer(access.area)) continue;
    const std::uint32_t block = facts.blockOf(access.instruction);
    const Instruction& instruction = facts.instruction(access.instruction);
    const auto length = static_cast<std::uint32_t>(access.area == Area::AC ? 1 : 4);
    for (std::uint32_t back = 0; back < length && back <= access.offset; ++back) {
      Pointer* pointer = at(access.area, access.offset - back, block);
      if (pointer == nullptr) continue;
      if (!access.write) {
        const bool isValue = access.operand < instruction.operands.size() &&
                             instruction.operands[access.operand].kind == OperandKind::Direct;
        if (instruction.desc->execution == Execution::Compare && back == 0 && isValue) pointer->isCompared = true;
        continue;
      }
      if (isStep(instruction) && back == 0) {
        pointer->steps.push_back(&instruction);
        continue;
      }
      pointer->isSet = true;
      const bool isFirstScan = (facts.conditionOf(instruction.id) & condition::FirstScan) != 0;
      if (!isFirstScan) pointer->isSetAgain = true;
    }
  }
  // An accumulator that its block only uses is set by the caller.
  for (Pointer& pointer : pointers_) {
    if (pointer.area != Area::AC || pointer.isSet) continue;
    const std::uint32_t cell = facts.index().cells().cell(Area::AC, pointer.offset, 0);
    for (const std::uint32_t i : facts.index().at(cell)) {
      if (facts.access(i).write && !isStep(facts.instruction(facts.access(i).instruction)))
        pointer.isSet = pointer.isSetAgain = true;
    }
  }
}

void PointerTable::closeStrides(Life& life) {
  if (life.last != nullptr && life.use != nullptr && !life.isComputed)
    life.sums.push_back({life.use, life.narrowest, life.total, life.last});
  for (PointerStride& sum : life.sums) {
    if (life.use == nullptr) continue;
    sum.use = life.use;
    sum.narrowest = life.narrowest;
    strides_.push_back(sum);
  }
  life = {};
}

void PointerTable::followBlock(const Facts& facts, const Flow& flow, std::uint32_t block) {
  std::unordered_map<const Pointer*, Life> lives;
  for (const FlowStep& step : flow.steps) {
    const Instruction& instruction = *step.instruction;
    const Control control = instruction.desc->control;
    if (control == Control::LabelMark || control == Control::For || control == Control::Next ||
        control == Control::Call) {
      for (auto& [pointer, life] : lives) life.set = nullptr;
    }
    const std::span<const Access> accesses = facts.accesses().of(instruction.id);
    for (const Access& access : accesses) {
      if (!access.viaPointer) continue;
      Life& life = lives[find(access, block)];
      const int width = bytes(access.width);
      if (life.use == nullptr || width < life.narrowest) {
        life.use = &access;
        life.narrowest = width;
      }
      if (life.set == nullptr) continue;
      const bool byNumber = hasBitAndWord(life.area);
      known_.push_back({&access, life.set, life.area, byNumber ? life.offset / 2 : life.offset});
    }
    for (const Access& access : accesses) {
      if (!access.write || access.viaPointer) continue;
      const Pointer* pointer = at(access.area, access.offset, block);
      if (pointer == nullptr) continue;
      Life& life = lives[pointer];
      if (isStep(instruction)) {
        const std::optional<std::int64_t> distance = stepOf(instruction);
        if (!distance) life.isComputed = true;
        if (life.network != step.network && life.last != nullptr)
          life.sums.push_back({life.use, life.narrowest, life.total, life.last});
        if (life.network != step.network) life.total = 0;
        life.network = step.network;
        life.total += distance.value_or(0);
        life.last = &instruction;
        life.offset += distance.value_or(0);
        if (!distance || access.conditional)
          life.set = (facts.stack().at(instruction.id).flow & condition::Always) != 0 && distance ? life.set : nullptr;
        continue;
      }
      closeStrides(life);
      const bool isAddress =
          isMoveOf(*instruction.desc, Type::DWord) && instruction.operands[0].kind == OperandKind::Address;
      if (!isAddress) continue;
      life.set = &instruction;
      life.area = instruction.operands[0].area;
      const bool byNumber = hasBitAndWord(life.area);
      life.offset = static_cast<std::int64_t>(instruction.operands[0].offset) * (byNumber ? 2 : 1);
    }
  }
  for (auto& [pointer, life] : lives) closeStrides(life);
}

}  // namespace rungproof
