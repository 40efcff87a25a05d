// Follows rungs and calls backwards and collects what they demand.
#include "analysis/flow/exclusion.hpp"

#include <algorithm>
#include <limits>
#include <set>

namespace rungproof {

namespace {

constexpr int mostCoils = 3;          ///< coils between a condition and the contact that names it
constexpr int mostCalls = 8;          ///< blocks that call each other
constexpr std::size_t mostWays = 16;  ///< to one block
constexpr std::int64_t lowest = std::numeric_limits<std::int64_t>::min();
constexpr std::int64_t highest = std::numeric_limits<std::int64_t>::max();

std::uint32_t placeOf(Area area, std::uint32_t offset, unsigned bit, Width width) {
  return static_cast<std::uint32_t>(area) << 26 | static_cast<std::uint32_t>(width) << 24 | offset << 3 | bit;
}

/// The constant as the comparison takes it.
std::int64_t valueOf(const Operand& constant, Type type) {
  const std::int64_t value = constant.value;
  if (type == Type::Int && value > 32767) return value - 65536;
  if (type == Type::DInt && value > 2147483647LL) return value - 4294967296LL;
  return value;
}

Relation mirrored(Relation relation) {
  switch (relation) {
    case Relation::Less: return Relation::Greater;
    case Relation::LessEqual: return Relation::GreaterEqual;
    case Relation::GreaterEqual: return Relation::LessEqual;
    case Relation::Greater: return Relation::Less;
    default: return relation;
  }
}

}  // namespace

Exclusion::Exclusion(const Facts& facts) : facts_(facts) { findSteps(); }

Exclusion::Demand Exclusion::bitDemand(const Operand& bit, bool on) {
  return {placeOf(bit.area, bit.offset, bit.bit, Width::Bit), on ? 1 : 0, on ? 1 : 0};
}

/// Steps of a block follow each other where SCRT alone passes on, to one step at a time, and one step at most is set
/// otherwise: the first.
void Exclusion::findSteps() {
  if (facts_.placesOf([](const Desc& desc) { return desc.control == Control::Lscr; }).empty()) return;
  std::set<std::uint32_t> set;
  bool isOneAtATime = true;
  for (std::uint32_t block = 0; block < facts_.program().pous.size(); ++block) {
    std::optional<Operand> step;
    for (const Network& network : facts_.program().pous[block].networks) {
      std::size_t transitions = 0;
      for (const Instruction& instruction : network.instructions) {
        const Control control = instruction.desc->control;
        const Operand* first = instruction.operands.empty() ? nullptr : &instruction.operands[0];
        const bool isStep = first != nullptr && first->kind == OperandKind::Direct && first->area == Area::S;
        if (control == Control::ScrEnd) step.reset();
        if (control == Control::Lscr && isStep) {
          step = *first;
          stepBlock_.emplace(bitDemand(*first, true).place, block);
        } else if (step) {
          segments_.emplace(instruction.id, bitDemand(*step, true));
        }
        if (control == Control::Scrt) ++transitions;
        if (isSet(roleOf(instruction)) && isStep) {
          isOneAtATime =
              isOneAtATime && instruction.operands.size() == 2 && constantCount(instruction.operands[1]) == 1;
          set.insert(bitDemand(*first, true).place);
        }
        isOneAtATime = isOneAtATime && !(isCoil(roleOf(instruction)) && isStep);
      }
      isOneAtATime = isOneAtATime && transitions < 2;
    }
  }
  if (!isOneAtATime || set.size() > 1) stepBlock_.clear();
}

/// A contact that must be closed. A bit that one plain coil makes demands what its rung does.
void Exclusion::addContact(const Instruction& contact, Way& way, int depth) {
  if (contact.desc->relation != Relation::None) {
    if (const auto demand = comparison(contact)) way.push_back(*demand);
    return;
  }
  const Operand& bit = contact.operands[0];
  if (contact.operands.size() != 1 || bit.kind != OperandKind::Direct || contact.desc->immediate ||
      hasBitAndWord(bit.area))
    return;
  way.push_back(bitDemand(bit, !contact.desc->negated));
  const std::uint32_t cell = facts_.index().cells().cell(bit.area, bit.offset, facts_.blockOf(contact.id));
  if (contact.desc->negated || depth >= mostCoils || cell == facts_.index().cells().size() || bit.bit > 7) return;
  if (facts_.writers(cell, bit.bit) != 1 || facts_.index().isWrittenAtLarge(cell) || facts_.isExternal(cell)) return;
  for (const std::uint32_t i : facts_.index().at(cell)) {
    const Access& access = facts_.access(i);
    const Instruction& writer = facts_.instruction(access.instruction);
    if (!access.write || !isPlainCoil(*writer.desc) || access.bit != bit.bit) continue;
    const Network& network = facts_.networkOf(writer.id);
    const auto place = static_cast<std::size_t>(&writer - network.instructions.data());
    for (const Demand& demand : behind(network, place, depth + 1)) way.push_back(demand);
  }
}

std::optional<Exclusion::Demand> Exclusion::comparison(const Instruction& contact) const {
  if (contact.operands.size() != 2) return std::nullopt;
  const Type type = contact.desc->operands[0].type;
  if (type != Type::Byte && type != Type::Int && type != Type::DInt) return std::nullopt;
  const bool isTurned = contact.operands[0].kind == OperandKind::Constant;
  const Operand& word = contact.operands[isTurned ? 1 : 0];
  const Operand& constant = contact.operands[isTurned ? 0 : 1];
  if (word.kind != OperandKind::Direct || constant.kind != OperandKind::Constant) return std::nullopt;
  Demand demand{placeOf(word.area, word.offset, 0, hasBitAndWord(word.area) ? Width::Word : widthOf(type)), lowest,
                highest};
  const std::int64_t value = valueOf(constant, type);
  switch (isTurned ? mirrored(contact.desc->relation) : contact.desc->relation) {
    case Relation::Less: demand.high = value - 1; break;
    case Relation::LessEqual: demand.high = value; break;
    case Relation::Equal: demand.low = demand.high = value; break;
    case Relation::GreaterEqual: demand.low = value; break;
    case Relation::Greater: demand.low = value + 1; break;
    default: return std::nullopt;
  }
  return demand;
}

/// What the top of the stack demands in front of an instruction of the network, if it is to be 1.
Exclusion::Way Exclusion::behind(const Network& network, std::size_t at, int depth) {
  if (facts_.form() == StatementForm::Accumulators) return {};  // its statements have no rungs
  std::vector<Way> levels;
  const auto top = [&]() -> Way& {
    if (levels.empty()) levels.emplace_back();
    return levels.back();
  };
  const auto popped = [&] {
    Way way = top();
    levels.pop_back();
    return way;
  };
  for (std::size_t i = 0; i < at; ++i) {
    const Instruction& instruction = network.instructions[i];
    switch (roleOf(instruction)) {
      case Role::Load:
        levels.emplace_back();
        addContact(instruction, levels.back(), depth);
        break;
      case Role::And: addContact(instruction, top(), depth); break;
      case Role::Or:
      case Role::Not:
      case Role::Ed: top().clear(); break;
      case Role::Ald: {
        const Way other = popped();
        top().insert(top().end(), other.begin(), other.end());
        break;
      }
      case Role::Old: {
        const Way other = popped();
        std::erase_if(top(), [&](const Demand& demand) { return std::ranges::find(other, demand) == other.end(); });
        break;
      }
      case Role::Lps: levels.push_back(top()); break;
      case Role::Lrd:
        if (levels.size() > 1) levels.back() = levels[levels.size() - 2];
        break;
      case Role::Lpp: popped(); break;
      case Role::Lds: return {};
      default: break;
    }
  }
  return top();
}

/// What the instruction itself demands: its rung, and the step that it stands in.
Exclusion::Way Exclusion::at(std::uint32_t instruction) {
  const Network& network = facts_.networkOf(instruction);
  const auto place = static_cast<std::size_t>(&facts_.instruction(instruction) - network.instructions.data());
  Way way = behind(network, place, 0);
  if (const auto step = segments_.find(instruction); step != segments_.end()) way.push_back(step->second);
  return way;
}

const Exclusion::Ways& Exclusion::toBlock(std::uint32_t block, int depth) {
  const auto [known, isNew] = blocks_.try_emplace(block, Ways{Way{}});
  if (!isNew) return known->second;
  const std::span<const std::uint32_t> calls = facts_.calls().callsOf(block);
  const bool isAttached = facts_.calls().reachedFromInterrupt(block);
  if (facts_.program().pous[block].kind != PouKind::Subroutine || calls.empty() || isAttached || depth > mostCalls)
    return known->second;
  Ways ways;
  for (const std::uint32_t s : calls) {
    const CallSite& site = facts_.calls().sites()[s];
    const Way own = at(site.instruction->id);
    for (const Way& before : Ways(toBlock(site.caller, depth + 1))) {
      Way way = own;
      way.insert(way.end(), before.begin(), before.end());
      ways.push_back(std::move(way));
    }
    if (ways.size() > mostWays) return known->second;
  }
  return blocks_.at(block) = std::move(ways);
}

/// A coil writes whether its rung is closed or not; what runs with power flow only demands its rung as well.
std::uint32_t Exclusion::waysTo(std::uint32_t instruction) {
  const std::uint32_t block = facts_.blockOf(instruction);
  const Desc& desc = *facts_.instruction(instruction).desc;
  if (desc.execution != Execution::Conditional && desc.control != Control::Call) {
    const auto known = toAllOf_.find(block);
    return known != toAllOf_.end() ? known->second : toAllOf_[block] = numberOf(toBlock(block, 0));
  }
  Ways ways = toBlock(block, 0);
  const Way own = at(instruction);
  for (Way& way : ways) way.insert(way.end(), own.begin(), own.end());
  return numberOf(std::move(ways));
}

std::uint32_t Exclusion::numberOf(Ways ways) {
  for (Way& way : ways) {
    std::ranges::sort(way);
    way.erase(std::ranges::unique(way).begin(), way.end());
  }
  std::ranges::sort(ways);
  const auto [found, isNew] = numbers_.try_emplace(std::move(ways), static_cast<std::uint32_t>(ways_.size()));
  if (isNew) ways_.push_back(&found->first);
  return found->second;
}

bool Exclusion::contradict(const Demand& a, const Demand& b) const {
  if (a.place == b.place) return a.high < b.low || b.high < a.low;
  const auto first = stepBlock_.find(a.place), second = stepBlock_.find(b.place);
  return first != stepBlock_.end() && second != stepBlock_.end() && first->second == second->second && a.low == 1 &&
         b.low == 1;
}

bool Exclusion::contradict(const Way& a, const Way& b) const {
  return std::ranges::any_of(a, [&](const Demand& one) {
    return std::ranges::any_of(b, [&](const Demand& other) { return contradict(one, other); });
  });
}

bool Exclusion::exclude(std::uint32_t a, std::uint32_t b) const {
  return std::ranges::all_of(*ways_[a], [&](const Way& one) {
    return std::ranges::all_of(*ways_[b], [&](const Way& other) { return contradict(one, other); });
  });
}

}  // namespace rungproof
