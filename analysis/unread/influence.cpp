// Spreads influence over networks until nothing is added.
#include "analysis/unread/influence.hpp"

#include <algorithm>

#include "ir/s7200/cpu.hpp"

namespace rungproof {

namespace {

constexpr std::uint32_t longestRow = 255;
constexpr std::int64_t shortestLimit = 64;  ///< of all counts: that of SHRB (001:6024)

/// Whether an operand that is written is a place of the CPU.
bool isKnownTarget(const Facts& facts, const OperandDesc& desc, const Operand& operand) {
  if (operand.kind != OperandKind::Direct) return false;
  const bool isNumber = addressedByNumber(operand.area);
  const Width width =
      hasBitAndWord(operand.area) ? (desc.type == Type::Bool ? Width::Bit : Width::Word) : operand.width;
  return addressExists(facts.target(), operand.area, width, operand.offset,
                       width == Width::Bit && !isNumber ? operand.bit : 0);
}

/// Whether its count is one that no instruction takes: then any count may be meant.
bool hasWrongCount(const Instruction& instruction) {
  for (std::size_t i = 0; i < std::min<std::size_t>(instruction.operands.size(), instruction.desc->operandCount); ++i) {
    const Operand& operand = instruction.operands[i];
    if (instruction.desc->operands[i].name != "N") continue;
    if (operand.kind != OperandKind::Direct && operand.kind != OperandKind::Indirect &&
        (operand.kind != OperandKind::Constant || operand.value < 1 || operand.value > shortestLimit))
      return true;
  }
  return false;
}

}  // namespace

bool actsOnDevices(const Desc& desc) {
  switch (desc.role) {
    case Role::Atch:
    case Role::Dtch:
    case Role::Cevnt:
    case Role::Eni:
    case Role::Disi:
    case Role::Hdef:
    case Role::Hsc:
    case Role::Pls:
    case Role::Netr:
    case Role::Netw:
    case Role::Get:
    case Role::Put:
    case Role::Xmt:
    case Role::Rcv:
    case Role::Spa:
    case Role::Todr:
    case Role::Todw: return true;
    default: return false;
  }
}

bool takesFromBelow(const Facts& facts, std::span<const std::uint32_t> instructions) {
  int level = 0;
  for (const std::uint32_t id : instructions) {
    const StackEffect& effect = facts.instruction(id).desc->stack;
    if (effect.needs > level) return true;
    level += effect.pushes - effect.pops;
  }
  return false;
}

Influence::Influence(const Facts& facts) : facts_(facts), places_(facts.target()) { collectParts(); }

void Influence::collectParts() {
  const Program& program = facts_.program();
  for (std::uint32_t block = 0; block < program.pous.size(); ++block) {
    firstPart_.push_back(static_cast<std::uint32_t>(parts_.size()));
    for (std::uint32_t n = 0; n < program.pous[block].networks.size(); ++n) {
      Part& part = parts_.emplace_back();
      part.place = {block, n};
      for (const Instruction& instruction : program.pous[block].networks[n].instructions)
        part.instructions.push_back(instruction.id);
      part.needsStack = takesFromBelow(facts_, part.instructions);
    }
  }
  firstPart_.push_back(static_cast<std::uint32_t>(parts_.size()));
}

const Influence::Part* Influence::part(NetworkPlace place) const {
  return &parts_[firstPart_[place.block] + place.network];
}

void Influence::addEverything(std::uint32_t cause) {
  if (everything_ == none) everything_ = cause;
}

void Influence::addPlace(const PlaceRow& row, std::uint32_t cause) {
  // The control bytes of devices and the interrupt times lie from SMB30 on.
  if (row.area == Area::SM && row.first + row.count > (smReadOnlyLast + 1) * 8) return addEverything(cause);
  isChanged_ = places_.set(row, cause) || isChanged_;
  if (some_ == none) some_ = cause;
  if (raisesEvents(row) && !facts_.calls().attachments().empty()) addEverything(cause);
}

/// Jumps to a label below in the same network, and labels to which such jumps alone lead: they decide nothing outside
/// of it. A label that nothing leads to may be one that the reader refused.
const std::unordered_set<std::uint32_t>& Influence::staysInside(std::uint32_t block) {
  const auto [known, isNew] = staysInside_.try_emplace(block);
  if (!isNew) return known->second;
  const std::vector<FlowStep>& steps = facts_.plan().flows[block].steps;
  std::unordered_set<std::uint32_t> reached, entered;  // labels, by step: from above in the network; in any other way
  for (std::uint32_t from = 0; from < steps.size(); ++from) {
    const std::uint32_t to = steps[from].partner;
    const Control control = steps[from].instruction->desc->control;
    if ((control != Control::Jump && control != Control::Branch) || to == noPartner) continue;
    const bool isInside = to > from && steps[to].network == steps[from].network;
    (isInside ? reached : entered).insert(to);
    if (isInside) known->second.insert(steps[from].id());
  }
  for (const std::uint32_t label : reached) {
    if (!entered.contains(label)) known->second.insert(steps[label].id());
  }
  return known->second;
}

void Influence::addChangedNetwork(NetworkPlace place, std::uint32_t cause) { add(place, cause, true); }
void Influence::addNetwork(NetworkPlace place, std::uint32_t cause) { add(place, cause, false); }

void Influence::add(NetworkPlace place, std::uint32_t cause, bool isWhole) {
  Part& part = parts_[firstPart_[place.block] + place.network];
  for (const std::uint32_t id : part.instructions) {
    const Instruction& instruction = facts_.instruction(id);
    const Desc& desc = *instruction.desc;
    const bool movesFlow = desc.control != Control::None && !(isWhole && staysInside(place.block).contains(id));
    if (movesFlow || actsOnDevices(desc)) return addEverything(cause);
    for (std::size_t i = 0; i < std::min<std::size_t>(instruction.operands.size(), desc.operandCount); ++i) {
      const OperandDesc& operand = desc.operands[i];
      if (operand.direction != Direction::In && !isKnownTarget(facts_, operand, instruction.operands[i]))
        return addEverything(cause);
    }
    for (const Access& access : facts_.accesses().of(id)) {
      if (access.write && hasWrongCount(instruction))
        addPlace(rowOf(access.area, access.width, access.offset, access.bit, longestRow), cause);
    }
  }
  influence(part, cause);
}

void Influence::influence(Part& part, std::uint32_t cause) {
  if (part.cause != none) return;
  part.cause = cause;
  isChanged_ = true;
  for (const std::uint32_t id : part.instructions) {
    writesOf(id, cause);
    controlOf(part, id, cause);
  }
}

void Influence::influenceBlock(std::uint32_t block, std::uint32_t cause) {
  for (std::uint32_t i = firstPart_[block]; i < firstPart_[block + 1]; ++i) influence(parts_[i], cause);
}

void Influence::writesOf(std::uint32_t instruction, std::uint32_t cause) {
  const Desc& desc = *facts_.instruction(instruction).desc;
  if (const CallContract* contract = facts_.contracts().of(facts_.instruction(instruction))) {
    if (contract->mayDoAnything) return addEverything(cause);
    for (const MemoryRow& row : contract->memory) addPlace({row.area, row.first, row.count}, cause);
    addPlace(resultBits, cause);
    addPlace({Area::AC, 0, 4}, cause);
  }
  if (actsOnDevices(desc)) return addEverything(cause);
  if (desc.affects != 0) addPlace(resultBits, cause);
  addPlace(errorBits, cause);
  for (const Access& access : facts_.accesses().of(instruction)) {
    if (!access.write) continue;
    if (access.viaPointer) return addEverything(cause);
    addPlace(rowOf(access), cause);
  }
}

/// What an influenced instruction lets run or leaves out.
void Influence::controlOf(const Part& part, std::uint32_t instruction, std::uint32_t cause) {
  switch (facts_.instruction(instruction).desc->control) {
    case Control::None:
    case Control::LabelMark:
    case Control::Return:
    case Control::InterruptReturn:
    case Control::MainEnd:
    case Control::SubroutineHead:
    case Control::InterruptHead: return;
    case Control::Stop: return addEverything(cause);
    case Control::Call:
      for (const std::uint32_t site : facts_.calls().callsIn(part.place.block)) {
        const CallSite& call = facts_.calls().sites()[site];
        if (call.instruction->id != instruction) continue;
        if (call.callee != noBlock) influenceBlock(call.callee, cause);
      }
      return;
    default: return influenceBlock(part.place.block, cause);
  }
}

std::uint32_t Influence::causeRead(const Part& part) const {
  if (part.needsStack) {
    for (std::uint32_t i = firstPart_[part.place.block]; i < firstPart_[part.place.block + 1]; ++i) {
      if (parts_[i].cause != none) return parts_[i].cause;
    }
  }
  for (const std::uint32_t id : part.instructions) {
    // What a block hands back comes out of its local memory.
    if (facts_.instruction(id).desc->control == Control::Call) {
      const std::uint32_t cause = causeAt(PlaceRow{Area::L, 0, areaSize(facts_.target(), Area::L) * 8});
      if (cause != none) return cause;
    }
    for (const Access& access : facts_.accesses().of(id)) {
      if (access.write) continue;
      if (access.viaPointer && some_ != none) return some_;
      const std::uint32_t cause = causeAt(rowOf(access));
      if (cause != none) return cause;
    }
  }
  return none;
}

void Influence::spread() {
  do {
    isChanged_ = false;
    for (Part& part : parts_) {
      if (everything_ != none) return;
      if (part.cause != none) continue;
      if (const std::uint32_t cause = causeRead(part); cause != none) influence(part, cause);
    }
  } while (isChanged_);
}

std::uint32_t Influence::causeAt(const PlaceRow& row) const {
  return everything_ != none ? everything_ : places_.first(row);
}

std::uint32_t Influence::causeAt(NetworkPlace place) const {
  return everything_ != none ? everything_ : part(place)->cause;
}

}  // namespace rungproof
