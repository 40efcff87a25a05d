// Registers along the paths of each block, places over the whole program, until nothing is added.
#include "analysis/unread/statement_influence.hpp"

#include <algorithm>
#include <set>

#include "analysis/unread/register_use.hpp"
#include "ir/block_map.hpp"
#include "ir/s7300/block.hpp"
#include "ir/s7300/pointer_parameter.hpp"
#include "ir/s7300/statement_role.hpp"

namespace rungproof {

namespace {

/// Blocks of the CPU that do nothing but what their parameters say.
bool staysWithinParameters(const Pou& callee) {
  const int number = numberOfBlock(callee.number);
  if (callee.type == BlockType::Fc) return true;
  if (callee.type == BlockType::Sfb) return number <= 5;
  return callee.type == BlockType::Sfc && (number == 20 || number == 21 || number == 64);
}

std::uint32_t firstOf(const std::map<std::uint32_t, std::uint32_t>& bits, const PlaceRow& row) {
  const auto found = bits.lower_bound(row.first);
  return found != bits.end() && found->first < row.first + row.count ? found->second : Influence::none;
}

}  // namespace

bool StatementInfluence::Registers::join(const Registers& other) {
  const registers::Mask old = mask;
  mask |= other.mask;
  if (cause == none) cause = other.cause;
  return mask != old;
}

StatementInfluence::StatementInfluence(const Facts& facts) : facts_(facts) {
  const Program& program = facts.program();
  blocks_.resize(program.pous.size());
  for (std::uint32_t b = 0; b < blocks_.size(); ++b) {
    Block& block = blocks_[b];
    const Flow& flow = facts.plan().flows[b];
    block.parts.resize(program.pous[b].networks.size());
    for (std::uint32_t at = 0; at < flow.steps.size(); ++at) {
      Part& part = block.parts[flow.steps[at].network];
      if (part.end == 0) part.first = at;
      part.end = at + 1;
    }
    block.logic = logicStates(flow);
    block.open = openStates(program, flow);
  }
  findInstances();
}

/// The data of an FB: instances of its own, and instances of blocks that hold it as static data.
void StatementInfluence::findInstances() {
  const Program& program = facts_.program();
  std::set<std::uint32_t> anywhere;  // FBs that UC and CC call: on any data
  for (const CallSite& site : facts_.calls().sites()) {
    if (site.callee != noBlock && site.instruction->operands.size() < 2) anywhere.insert(site.callee);
  }
  for (std::uint32_t b = 0; b < blocks_.size(); ++b) {
    if (!hasInstance(program.pous[b])) continue;
    if (anywhere.contains(b)) {
      for (const DataBlock& block : program.dataBlocks) blocks_[b].instances.emplace_back(block.number, false);
      continue;
    }
    std::set<int> holders{program.pous[b].number};
    for (bool isNew = true; isNew;) {
      isNew = false;
      for (const Pou& pou : program.pous) {
        const bool holds = std::ranges::any_of(
            pou.locals, [&](const LocalVariable& local) { return holders.contains(local.instanceOf); });
        isNew = (holds && hasInstance(pou) && holders.insert(pou.number).second) || isNew;
      }
    }
    for (const DataBlock& block : program.dataBlocks) {
      if (holders.contains(block.instanceOf))
        blocks_[b].instances.emplace_back(block.number,
                                          block.instanceOf == program.pous[b].number && holders.size() == 1);
    }
  }
}

void StatementInfluence::addEverything(std::uint32_t cause) {
  if (everything_ == none) everything_ = cause;
}

void StatementInfluence::addNetwork(NetworkPlace place, std::uint32_t cause) {
  influence(place.block, place.network, cause);
}

void StatementInfluence::addPlace(const PlaceRow& row, std::uint32_t cause) {
  std::map<std::uint32_t, std::uint32_t>* bits = &places_[row.area];
  std::uint32_t first = row.first;
  if (row.area == Area::DB) {
    bits = &data_[blockOfByte(row.first / 8)].bits;
    first = byteInBlock(row.first / 8) * 8 + row.first % 8;
    if (someData_ == none) someData_ = cause;
  }
  for (std::uint32_t i = 0; i < row.count; ++i) isChanged_ = bits->emplace(first + i, cause).second || isChanged_;
  if (some_ == none) some_ = cause;
}

void StatementInfluence::addDataBlock(std::uint32_t number, std::uint32_t cause) {
  Data& data = data_[number];
  if (data.whole == none) {
    data.whole = cause;
    isChanged_ = true;
  }
  if (someData_ == none) someData_ = cause;
  if (some_ == none) some_ = cause;
}

void StatementInfluence::influence(std::uint32_t block, std::uint32_t network, std::uint32_t cause) {
  Part& part = blocks_[block].parts[network];
  if (part.cause != none) return;
  part.cause = cause;
  isChanged_ = true;
  const LogicStates& logic = blocks_[block].logic;
  for (const std::uint32_t edge : {part.first, part.end}) {
    if (part.end != 0 && logic[edge] && logic[edge]->depth != 0) return addEverything(cause);
  }
  for (std::uint32_t at = part.first; at < part.end; ++at) {
    write(block, at, cause);
    control(block, at, cause);
  }
}

void StatementInfluence::influenceBlock(std::uint32_t block, std::uint32_t cause) {
  for (std::uint32_t n = 0; n < blocks_[block].parts.size(); ++n) influence(block, n, cause);
}

/// What an influenced statement lets run or leaves out.
void StatementInfluence::control(std::uint32_t block, std::uint32_t at, std::uint32_t cause) {
  const FlowStep& here = step(block, at);
  const StatementRole role = statementRole(*here.instruction);
  switch (here.instruction->desc->control) {
    case Control::None:
      if (isOfRelay(role)) addEverything(cause);
      return;
    case Control::LabelMark: return;
    case Control::BlockCall: return call(block, *here.instruction, cause);
    case Control::BlockEnd: {
      const bool isLast = at + 1 == facts_.plan().flows[block].steps.size();
      if (role != StatementRole::End || !isLast) influenceBlock(block, cause);
      return;
    }
    default: {
      const bool staysHere = here.partner != noPartner && networkAt(block, here.partner) == here.network;
      if (!staysHere) influenceBlock(block, cause);
    }
  }
}

void StatementInfluence::call(std::uint32_t block, const Instruction& instruction, std::uint32_t cause) {
  bool isKnown = false;
  eachCallee(block, instruction, [&](std::uint32_t called) {
    const Pou& callee = facts_.program().pous[called];
    const bool isOfSystem = callee.isBuiltIn || callee.type == BlockType::Sfc || callee.type == BlockType::Sfb;
    if (callee.protectedBlock || (isOfSystem && !staysWithinParameters(callee))) return addEverything(cause);
    isKnown = true;
    influenceBlock(called, cause);
  });
  if (!isKnown) return addEverything(cause);
  // Its instance: what a call does not write itself, its block does, or the system.
  if (instruction.operands.size() < 2) return;
  const Operand& instance = instruction.operands[1];
  if (!hasInstance(blockTypeOf(static_cast<int>(instruction.operands[0].value)))) return;
  if (instance.reach == nullptr && instance.area == Area::DB)
    addDataBlock(blockOfByte(instance.offset), cause);
  else
    write(block, {Reached::Kind::AllData, {}, 0}, cause);
}

/// Where `bits` of an instance lie, from bit `first` of it on.
std::vector<Reached> StatementInfluence::inInstance(std::uint32_t block, const Operand& instance, std::uint32_t first,
                                                    std::uint32_t bits) const {
  if (instance.kind == OperandKind::Direct) {
    const std::uint32_t start = dataByte(blockOfByte(instance.offset), byteInBlock(instance.offset)) * 8;
    return {{Reached::Kind::Row, {Area::DB, start + first, bits}, 0}};
  }
  std::vector<Reached> places;
  for (const auto& [number, isWhole] : blocks_[block].instances) {
    const PlaceRow row{Area::DB, dataByte(number, instance.offset) * 8 + first, bits};
    places.push_back(isWhole ? Reached{Reached::Kind::Row, row, 0} : Reached{Reached::Kind::Data, {}, number});
  }
  return places;
}

/// What a call that runs as it is written copies from the instance of an FB to its actual parameters. The system's own
/// FBs work on the whole instance.
void StatementInfluence::copyOut(std::uint32_t block, std::uint32_t at) {
  const FlowStep& here = step(block, at);
  const Instruction& call = *here.instruction;
  if (someData_ == none || call.desc->control != Control::BlockCall || call.operands.size() < 2) return;
  eachCallee(block, call, [&](std::uint32_t called) {
    const Pou& callee = facts_.program().pous[called];
    if (!hasInstance(callee)) return;
    const auto causeIn = [&](std::uint32_t first, std::uint32_t bits) {
      for (const Reached& place : inInstance(block, call.operands[1], first, bits)) {
        if (const std::uint32_t cause = causeOf(block, place); cause != none) return cause;
      }
      return none;
    };
    std::size_t operand = 1;
    for (const LocalVariable& local : callee.locals) {
      if (local.section == VarSection::Temp) continue;
      const bool isGiven = isParameter(local) && ++operand < call.operands.size();
      const PlaceRow member = rowOf(local.address);
      const std::uint32_t cause = causeIn(member.first, std::max(local.size * 8, 1U));
      if (cause == none) continue;
      if (callee.networks.empty() || callee.protectedBlock) return influence(block, here.network, cause);
      if (!isGiven || local.section == VarSection::Input) continue;
      for (const Access& access : facts_.accesses().of(call.id)) {
        if (access.operand != operand || (!access.write && !access.maybe)) continue;
        for (const Reached& place : reached(block, at, access)) write(block, place, cause);
      }
    }
  });
}

/// Where the access may lie.
std::vector<Reached> StatementInfluence::reached(std::uint32_t block, std::uint32_t at, const Access& access) const {
  using enum Reached::Kind;
  const Instruction& instruction = *step(block, at).instruction;
  const PlaceRow row = rowOf(access);
  if (!access.viaPointer) return {{Row, row, 0}};
  if (access.pointed == Pointed::OfCall) return {{ByCall, {}, 0}};
  if (access.operand >= instruction.operands.size()) return {{Anywhere, {}, 0}};
  const Operand* operand = &instruction.operands[access.operand];
  if (operand->reach != nullptr && operand->reach->way == Way::PointerTo) operand = &operand->reach->pointer;
  if (operand->reach == nullptr || access.pointed == Pointed::Anywhere) return {{Anywhere, {}, 0}};
  const std::optional<OpenState>& open = blocks_[block].open[at];
  if (!open) return {};  // it never runs
  const auto inBlock = [&](std::uint32_t number) -> Reached {
    PlaceRow inside = row;
    inside.first += dataByte(number, 0) * 8;
    return {Row, inside, number};
  };
  const auto inInstance = [&]() -> std::vector<Reached> {
    std::vector<Reached> places;
    for (const auto& [number, isWhole] : blocks_[block].instances)
      places.push_back(isWhole ? inBlock(number) : Reached{Data, {}, number});
    return places;
  };
  const bool isMoved = open->isDiMoved || open->isAr2Moved;
  switch (operand->reach->way) {
    case Way::OpenBlock: {
      const OpenBlock& in = operand->reach->inDi ? open->di : open->db;
      if (in.number != 0) return {inBlock(in.number)};
      if (operand->reach->inDi && !isMoved && hasInstance(facts_.program().pous[block])) return inInstance();
      return {{AllData, {}, 0}};
    }
    case Way::Instance: return isMoved ? std::vector<Reached>{{AllData, {}, 0}} : inInstance();
    case Way::Pointer:
    case Way::Register:
      return {access.area == Area::DB ? Reached{AllData, {}, 0} : Reached{InArea, {access.area, 0, 0}, 0}};
    default: return {{Anywhere, {}, 0}};
  }
}

void StatementInfluence::write(std::uint32_t block, const Reached& place, std::uint32_t cause) {
  if (everything_ != none) return;
  switch (place.kind) {
    case Reached::Kind::Row:
      if (place.row.area != Area::L) return addPlace(place.row, cause);
      for (std::uint32_t i = 0; i < place.row.count; ++i)
        isChanged_ = blocks_[block].local.emplace(place.row.first + i, cause).second || isChanged_;
      if (some_ == none) some_ = cause;
      return;
    case Reached::Kind::Data: return addDataBlock(place.dataBlock, cause);
    case Reached::Kind::AllData:
      isChanged_ = isChanged_ || allData_ == none;
      if (allData_ == none) allData_ = cause;
      if (someData_ == none) someData_ = cause;
      if (some_ == none) some_ = cause;
      return;
    case Reached::Kind::InArea:
      isChanged_ = areas_.emplace(place.row.area, cause).second || isChanged_;
      if (some_ == none) some_ = cause;
      return;
    case Reached::Kind::ByCall:
      for (const std::uint32_t site : facts_.calls().callsOf(block)) {
        const CallSite& call = facts_.calls().sites()[site];
        if (!given_.insert(call.instruction->id).second) continue;
        const InstructionPlace at = facts_.place(call.instruction->id);
        write(at.block, at.step, cause);
      }
      return;
    case Reached::Kind::Anywhere: return addEverything(cause);
  }
}

/// What the statement may write.
void StatementInfluence::write(std::uint32_t block, std::uint32_t at, std::uint32_t cause) {
  const Instruction& instruction = *step(block, at).instruction;
  for (std::size_t i = 0; i < std::min<std::size_t>(instruction.operands.size(), instruction.desc->operandCount); ++i) {
    const Operand& operand = instruction.operands[i];
    if (operand.kind != OperandKind::Symbol || instruction.desc->operands[i].direction == Direction::In) continue;
    if (operand.area != Area::DB) return addEverything(cause);  // nobody knows which place that is
    addDataBlock(blockOfByte(operand.offset), cause);
  }
  for (const Access& access : facts_.accesses().of(instruction.id)) {
    if (!access.write && !access.maybe) continue;
    for (const Reached& place : reached(block, at, access)) write(block, place, cause);
  }
}

std::uint32_t StatementInfluence::causeAt(const PlaceRow& row) const {
  if (everything_ != none) return everything_;
  if (const auto area = areas_.find(row.area); area != areas_.end()) return area->second;
  if (row.area != Area::DB) {
    const auto bits = places_.find(row.area);
    return bits == places_.end() ? none : firstOf(bits->second, row);
  }
  if (allData_ != none) return allData_;
  const auto data = data_.find(blockOfByte(row.first / 8));
  if (data == data_.end()) return none;
  if (data->second.whole != none) return data->second.whole;
  const std::uint32_t first = byteInBlock(row.first / 8) * 8 + row.first % 8;
  return firstOf(data->second.bits, {Area::DB, first, row.count});
}

std::uint32_t StatementInfluence::causeAt(NetworkPlace place) const {
  return everything_ != none ? everything_ : blocks_[place.block].parts[place.network].cause;
}

std::uint32_t StatementInfluence::causeOf(std::uint32_t block, const Reached& place) const {
  switch (place.kind) {
    case Reached::Kind::Row:
      return place.row.area == Area::L ? firstOf(blocks_[block].local, place.row) : causeAt(place.row);
    case Reached::Kind::Data: {
      if (allData_ != none) return allData_;
      const auto data = data_.find(place.dataBlock);
      if (data == data_.end()) return none;
      if (data->second.whole != none || data->second.bits.empty()) return data->second.whole;
      return data->second.bits.begin()->second;
    }
    case Reached::Kind::AllData: return someData_;
    case Reached::Kind::InArea: {
      if (place.row.area == Area::L) return blocks_[block].local.empty() ? none : blocks_[block].local.begin()->second;
      if (const auto area = areas_.find(place.row.area); area != areas_.end()) return area->second;
      const auto bits = places_.find(place.row.area);
      return bits == places_.end() || bits->second.empty() ? none : bits->second.begin()->second;
    }
    // A call that gives an influenced place influences the whole block.
    case Reached::Kind::ByCall: return none;
    case Reached::Kind::Anywhere: return some_;
  }
  return none;
}

/// Whether the network has filled that place of L itself, in a statement that no jump passes by.
bool StatementInfluence::isOwnLocal(std::uint32_t block, std::uint32_t network, std::uint32_t at,
                                    const PlaceRow& row) const {
  const Part& part = blocks_[block].parts[network];
  for (std::uint32_t before = part.first; before < at; ++before) {
    const Instruction& instruction = *step(block, before).instruction;
    const StatementRole role = statementRole(instruction);
    if (instruction.desc->control != Control::None && instruction.desc->control != Control::BlockCall) return false;
    if (role != StatementRole::Assign && role != StatementRole::Transfer) continue;
    for (const Access& access : facts_.accesses().of(instruction.id)) {
      const PlaceRow filled = rowOf(access);
      if (access.write && !access.viaPointer && filled.area == Area::L && filled.first <= row.first &&
          filled.first + filled.count >= row.first + row.count)
        return true;
    }
  }
  return false;
}

std::uint32_t StatementInfluence::causeRead(std::uint32_t block, std::uint32_t network) const {
  const Part& part = blocks_[block].parts[network];
  for (std::uint32_t at = part.first; at < part.end; ++at) {
    for (const Access& access : facts_.accesses().of(step(block, at).id())) {
      if (access.write && !access.maybe) continue;
      for (const Reached& place : reached(block, at, access)) {
        const std::uint32_t cause = causeOf(block, place);
        if (cause == none) continue;
        const bool isLocal = place.kind == Reached::Kind::Row && place.row.area == Area::L;
        if (!isLocal || !isOwnLocal(block, network, at, place.row)) return cause;
      }
    }
  }
  return none;
}

/// The blocks that a call may run; by a number that is computed, any of its kind.
template <class Visit>
void StatementInfluence::eachCallee(std::uint32_t block, const Instruction& call, Visit&& visit) const {
  if (!call.operands.empty() && call.operands[0].kind == OperandKind::Indirect) {
    for (std::uint32_t b = 0; b < blocks_.size(); ++b) {
      if (facts_.program().pous[b].type == typeOfComputedCall(call.operands[0].value)) visit(b);
    }
    return;
  }
  if (const std::uint32_t callee = facts_.calls().calleeOf(block, call); callee != noBlock) visit(callee);
}

void StatementInfluence::apply(std::uint32_t block, std::uint32_t at, Registers& registers) const {
  using namespace rungproof::registers;
  const FlowStep& here = step(block, at);
  const std::uint32_t cause = blocks_[block].parts[here.network].cause;
  const std::optional<LogicState>& logic = blocks_[block].logic[at];
  const RegisterUse use = registerUse(*here.instruction, !logic || (logic->firstCheck & mayBe1) != 0);
  const bool isLoad = statementRole(*here.instruction) == StatementRole::Load || loadsElement(*here.instruction);
  const bool movesTaint = isLoad && (registers.mask & accu1) != 0;
  if (cause != none) {
    registers.join({use.writes, cause});
  } else {
    registers.mask &= static_cast<Mask>(~use.set);
  }
  if (movesTaint) registers.mask |= accu2;
  if (isLoad && !movesTaint && cause == none) registers.mask &= static_cast<Mask>(~accu2);
  if (here.instruction->desc->control != Control::BlockCall) return;
  eachCallee(block, *here.instruction, [&](std::uint32_t callee) {
    if (hasInstance(facts_.program().pous[callee]) && (registers.mask & di) != 0) registers.mask |= db;
    registers.join(blocks_[callee].exit);
  });
}

/// Follows influenced registers through a block: into networks that take them, into blocks that it calls.
void StatementInfluence::passRegisters(std::uint32_t block) {
  using namespace registers;
  const Flow& flow = facts_.plan().flows[block];
  const FlowStep* const first = flow.steps.data();
  const auto states = statesOf(flow, blocks_[block].entry, [&](Registers& registers, const FlowStep& here) {
    apply(block, static_cast<std::uint32_t>(&here - first), registers);
  });
  for (std::uint32_t at = 0; at < flow.steps.size(); ++at) {
    if (!states[at] || states[at]->mask == 0) continue;
    const FlowStep& here = flow.steps[at];
    const std::optional<LogicState>& logic = blocks_[block].logic[at];
    const RegisterUse use = registerUse(*here.instruction, !logic || (logic->firstCheck & mayBe1) != 0);
    if ((use.reads & states[at]->mask) != 0) influence(block, here.network, states[at]->cause);
    if (here.instruction->desc->control != Control::BlockCall) continue;
    eachCallee(block, *here.instruction, [&](std::uint32_t callee) {
      Registers handed = *states[at];
      // CALL opens the instance of an FB, may hand DI on in DB, and sets AR2; UC and CC hand on what they find.
      const bool opens = hasInstance(facts_.program().pous[callee]) && here.instruction->operands.size() > 1;
      if (opens && (handed.mask & di) != 0) handed.mask |= db;
      if (opens) handed.mask &= static_cast<Mask>(~(di | ar2));
      isChanged_ = blocks_[callee].entry.join(handed) || isChanged_;
    });
  }
  if (states.back()) isChanged_ = blocks_[block].exit.join(*states.back()) || isChanged_;
}

/// What is not run may start the blocks of errors.
void StatementInfluence::startErrorBlocks() {
  std::uint32_t cause = none;
  for (const Block& block : blocks_) {
    for (const Part& part : block.parts) cause = cause == none ? part.cause : cause;
  }
  if (cause == none) return;
  for (std::uint32_t b = 0; b < blocks_.size(); ++b) {
    const int number = facts_.program().pous[b].number;
    if (number == blockNumber(BlockType::Ob, 121) || number == blockNumber(BlockType::Ob, 122))
      influenceBlock(b, cause);
  }
}

void StatementInfluence::spread() {
  do {
    isChanged_ = false;
    startErrorBlocks();
    for (std::uint32_t b = 0; b < blocks_.size(); ++b) {
      for (std::uint32_t n = 0; n < blocks_[b].parts.size(); ++n) {
        if (everything_ != none) return;
        if (blocks_[b].parts[n].cause != none) continue;
        if (const std::uint32_t cause = causeRead(b, n); cause != none) influence(b, n, cause);
      }
      for (std::uint32_t at = 0; at < facts_.plan().flows[b].steps.size(); ++at) copyOut(b, at);
      passRegisters(b);
    }
  } while (isChanged_);
}

bool StatementInfluence::mayUse(NetworkPlace place, const std::map<std::uint32_t, Span>& dataBlocks,
                                std::uint32_t& number) const {
  const Part& part = blocks_[place.block].parts[place.network];
  const auto isThat = [&](std::uint32_t block) {
    if (!dataBlocks.contains(block)) return false;
    number = block;
    return true;
  };
  number = dataBlocks.empty() ? 0 : dataBlocks.begin()->first;
  for (std::uint32_t at = part.first; at < part.end; ++at) {
    const Instruction& instruction = *step(place.block, at).instruction;
    for (const Operand& operand : instruction.operands) {  // OPN, an instance, a BLOCK_DB
      if (operand.reach == nullptr && operand.area == Area::DB && operand.kind != OperandKind::Constant &&
          isThat(blockOfByte(operand.offset)))
        return true;
      if (statementRole(instruction) != StatementRole::OpenBlock || operand.reach == nullptr) continue;
      if (operand.kind == OperandKind::Indirect) return true;
      if (operand.area == Area::DB && isThat(blockOfByte(operand.offset))) return true;
    }
    for (const Access& access : facts_.accesses().of(instruction.id)) {
      for (const Reached& reach : reached(place.block, at, access)) {
        if (reach.kind == Reached::Kind::AllData || reach.kind == Reached::Kind::Anywhere) return true;
        if (reach.kind == Reached::Kind::Data && isThat(reach.dataBlock)) return true;
        if (reach.kind == Reached::Kind::Row && reach.row.area == Area::DB && isThat(blockOfByte(reach.row.first / 8)))
          return true;
      }
    }
  }
  return false;
}

}  // namespace rungproof
