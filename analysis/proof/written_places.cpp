// Compares reads with writes.
#include "analysis/proof/written_places.hpp"

#include <algorithm>

#include "ir/s7300/pointer_parameter.hpp"
#include "ir/s7300/statement_role.hpp"

namespace rungproof {

namespace {

std::uint32_t firstBitOfAccess(const Access& access) {
  return access.byNumber() || access.width != Width::Bit ? access.offset * 8 : access.offset * 8 + access.bit;
}
std::uint32_t bitsOfAccess(const Access& access) {
  const std::uint32_t elements = std::max<std::uint32_t>(access.most, 1);
  if (access.byNumber()) return elements * 8;
  return access.width == Width::Bit ? elements : access.possibleLength() * 8;
}

}  // namespace

WrittenPlaces::WrittenPlaces(const Facts& facts)
    : facts_(facts), numbersArePointers_(facts.dialect().memory.numbersArePointers) {
  for (const std::uint32_t i : facts.index().wide()) {
    const Access& access = facts.access(i);
    if (!access.write && !access.maybe) continue;
    // What a call gives for a formal parameter is an access of that call.
    if (access.viaPointer && access.pointed == Pointed::OfCall) continue;
    (access.viaPointer ? pointed_ : long_).push_back(i);
  }
  if (!facts.dialect().memory.hasDataBlocks) return;
  findNesting();
  findMovedInstances();
}

void WrittenPlaces::findNesting() {
  const std::vector<Pou>& pous = facts_.program().pous;
  nested_.assign(pous.size(), std::vector<bool>(pous.size()));
  const auto blockOf = [&](int number) {
    return static_cast<std::size_t>(std::ranges::find(pous, number, &Pou::number) - pous.begin());
  };
  for (std::size_t outer = 0; outer < pous.size(); ++outer) {
    std::vector<std::size_t> open{outer};
    while (!open.empty()) {
      const Pou& pou = pous[open.back()];
      open.pop_back();
      for (const LocalVariable& local : pou.locals) {
        const std::size_t inner = local.type == DataType::Instance ? blockOf(local.instanceOf) : pous.size();
        if (inner == pous.size() || nested_[outer][inner]) continue;
        nested_[outer][inner] = true;
        open.push_back(inner);
      }
    }
  }
}

void WrittenPlaces::findMovedInstances() {
  for (const InstructionPlace& place : facts_.instructions()) {
    const Instruction& instruction = *place.instruction;
    switch (statementRole(instruction)) {
      case StatementRole::ExchangeBlocks:
      case StatementRole::LoadAr2:
      case StatementRole::MoveAr2:
      case StatementRole::ExchangeAr: movesInstances_ = true; break;
      case StatementRole::OpenBlock:
        for (const Operand& operand : instruction.operands)
          movesInstances_ = movesInstances_ || (operand.reach != nullptr && operand.reach->inDi);
        break;
      default: break;
    }
  }
  for (const CallSite& site : facts_.calls().sites()) {
    const bool isFb = site.callee != noBlock && hasInstance(facts_.program().pous[site.callee]);
    movesInstances_ = movesInstances_ || (isFb && site.instruction->operands.size() < 2);
  }
}

WrittenPlaces::DataPlace WrittenPlaces::dataPlaceOf(const Access& access) const {
  DataPlace place;
  place.firstBit = firstBitOfAccess(access);
  place.bits = bitsOfAccess(access);
  if (!access.viaPointer) {
    place.kind = DataPlace::Kind::Numbered;
    place.firstBit = byteInBlock(access.offset) * 8 + (access.width == Width::Bit ? access.bit : 0U);
    const auto& blocks = facts_.program().dataBlocks;
    const auto data = std::ranges::find(blocks, blockOfByte(access.offset), &DataBlock::number);
    if (data == blocks.end() || data->instanceOf == 0) return place;
    const std::vector<Pou>& pous = facts_.program().pous;
    const auto pou = std::ranges::find(pous, data->instanceOf, &Pou::number);
    if (pou != pous.end()) place.block = static_cast<std::uint32_t>(pou - pous.begin());
    return place;
  }
  const Operands& operands = facts_.instruction(access.instruction).operands;
  const bool isShown = access.operand < operands.size() && operands[access.operand].reach != nullptr;
  if (!isShown || operands[access.operand].reach->way != Way::Instance) return place;
  place.kind = DataPlace::Kind::Instance;
  place.block = facts_.blockOf(access.instruction);
  return place;
}

bool WrittenPlaces::mayMeetInData(const Access& read, const Access& write) const {
  if (movesInstances_) return true;
  const DataPlace a = dataPlaceOf(read), b = dataPlaceOf(write);
  if (a.kind == DataPlace::Kind::Any || b.kind == DataPlace::Kind::Any) return true;
  if (a.block == noBlock || b.block == noBlock) return false;
  if (a.block != b.block) return holds(a.block, b.block) || holds(b.block, a.block);
  return a.firstBit < b.firstBit + b.bits && b.firstBit < a.firstBit + a.bits;
}

bool WrittenPlaces::mayMeet(const Access& read, const Access& write) const {
  if (read.viaPointer && read.pointed == Pointed::OfCall) return false;
  const auto isAnywhere = [](const Access& access) { return access.viaPointer && access.pointed == Pointed::Anywhere; };
  if (isAnywhere(read) && isAnywhere(write)) return true;
  if (isAnywhere(read) || isAnywhere(write)) return mayBeReached(isAnywhere(read) ? write.area : read.area);
  if (read.area != write.area) return false;
  return read.area != Area::DB || mayMeetInData(read, write);
}

const std::vector<std::uint32_t>& WrittenPlaces::writesAt(std::uint32_t cell) const {
  const auto [known, isNew] = writesAt_.try_emplace(cell);
  if (isNew) {
    for (const std::uint32_t at : facts_.index().at(cell)) {
      const Access& access = facts_.access(at);
      if (access.write || access.maybe || access.isBox) known->second.push_back(at);
    }
  }
  return known->second;
}

bool WrittenPlaces::overlap(const Access& a, const Access& b) {
  return a.area == b.area && firstBitOfAccess(a) < firstBitOfAccess(b) + bitsOfAccess(b) &&
         firstBitOfAccess(b) < firstBitOfAccess(a) + bitsOfAccess(a);
}

}  // namespace rungproof
