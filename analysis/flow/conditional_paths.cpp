// What each kind of statement says of RLO, BR and bits.
#include "analysis/flow/conditional_paths.hpp"

#include <algorithm>

#include "ir/s7300/statement_detail.hpp"

namespace rungproof {

namespace {

constexpr std::uint64_t localKeys = 1ULL << 62, globalKeys = 2ULL << 62, parameterKeys = 3ULL << 62;
constexpr std::uint64_t keySorts = 3ULL << 62;

Known negatedKnown(Known value) {
  return value == Known::Unknown ? value : value == Known::Yes ? Known::No : Known::Yes;
}
Known joinedKnown(StatementRole role, Known a, Known b) {
  if (role == StatementRole::AndScan) {
    if (a == Known::No || b == Known::No) return Known::No;
    return a == Known::Yes && b == Known::Yes ? Known::Yes : Known::Unknown;
  }
  if (role == StatementRole::OrScan) {
    if (a == Known::Yes || b == Known::Yes) return Known::Yes;
    return a == Known::No && b == Known::No ? Known::No : Known::Unknown;
  }
  if (a == Known::Unknown || b == Known::Unknown) return Known::Unknown;
  return a == b ? Known::No : Known::Yes;
}

bool isParameterOf(const Operand& operand) { return operand.reach != nullptr && operand.reach->way == Way::Parameter; }
bool scansBr(const Instruction& instruction) {
  return !instruction.operands.empty() && instruction.operands[0].kind == OperandKind::Constant &&
         instruction.operands[0].text == "BR";
}

}  // namespace

PathKnowledge PathKnowledge::nothing() {
  PathKnowledge path;
  path.firstCheck_ = Known::Unknown;
  return path;
}

PathKnowledge::BitKey PathKnowledge::keyOf(const Facts& facts, const Instruction& instruction) {
  if (instruction.operands.empty()) return noKey;
  const Operand& operand = instruction.operands[0];
  if (isParameterOf(operand)) return parameterKeys | operand.reach->parameter << 20 | operand.offset << 3 | operand.bit;
  for (const Access& access : facts.accesses().of(instruction.id)) {
    if (access.operand != 0 || access.width != Width::Bit || access.viaPointer || access.byNumber()) continue;
    const std::uint64_t place = static_cast<std::uint64_t>(access.area) << 40 | access.offset << 3 | access.bit;
    return access.area == Area::L ? localKeys | place : globalKeys | place;
  }
  return noKey;
}

Known PathKnowledge::valueOf(BitKey key) const {
  if (key == noKey) return Known::Unknown;
  const auto found = std::ranges::lower_bound(bits_, key, {}, &std::pair<BitKey, Known>::first);
  return found != bits_.end() && found->first == key ? found->second : Known::Unknown;
}

void PathKnowledge::setBit(BitKey key, Known value) {
  if (key == noKey) return;
  const auto found = std::ranges::lower_bound(bits_, key, {}, &std::pair<BitKey, Known>::first);
  const bool isThere = found != bits_.end() && found->first == key;
  if (value == Known::Unknown) {
    if (isThere) bits_.erase(found);
  } else if (isThere) {
    found->second = value;
  } else {
    bits_.insert(found, {key, value});
  }
}

std::vector<PathKnowledge> PathKnowledge::byRlo() const {
  if (rlo_ != Known::Unknown) return {*this};
  std::vector<PathKnowledge> both(2, *this);
  both[0].rlo_ = Known::No;
  both[1].rlo_ = Known::Yes;
  for (PathKnowledge& path : both) {
    path.setBit(rloBit_, path.rlo_);
    path.rloBit_ = noKey;
  }
  return both;
}

void PathKnowledge::scan(ScanJoin join, Known value, BitKey key) {
  const Known scanned = join.negated ? negatedKnown(value) : value;
  const Known inString = joinedKnown(join.role, rlo_, scanned);
  const bool begins = firstCheck_ == Known::No;
  if (isOrOpen_ || (firstCheck_ == Known::Unknown && inString != scanned))
    rlo_ = Known::Unknown;
  else
    rlo_ = begins ? scanned : inString;
  rloBit_ = begins && !isOrOpen_ && !join.negated && rlo_ == Known::Unknown ? key : noKey;
  firstCheck_ = Known::Yes;
}

void PathKnowledge::close() {
  if (levels_.empty()) {
    rlo_ = Known::Unknown;
    rloBit_ = noKey;
    firstCheck_ = Known::Yes;
    return;
  }
  const Level level = levels_.back();
  levels_.pop_back();
  const Known inner = rlo_;
  const BitKey bit = rloBit_;
  rlo_ = level.rlo;
  firstCheck_ = level.firstCheck;
  isOrOpen_ = level.isOrOpen;
  scan(level.join, inner, bit);
}

void PathKnowledge::forgetGlobals() {
  std::erase_if(bits_, [](const auto& bit) { return (bit.first & keySorts) == globalKeys; });
  if ((rloBit_ & keySorts) == globalKeys) rloBit_ = noKey;
}

void PathKnowledge::forgetWritten(const Facts& facts, const Instruction& instruction) {
  for (const Access& access : facts.accesses().of(instruction.id)) {
    if (!access.write && !access.maybe) continue;
    const bool isOperand = access.operand < instruction.operands.size();
    if (isOperand && isParameterOf(instruction.operands[access.operand])) {
      const std::uint64_t parameter = instruction.operands[access.operand].reach->parameter;
      const auto isOfIt = [&](BitKey key) {
        return (key & keySorts) == parameterKeys && (key & ~keySorts) >> 20 == parameter;
      };
      std::erase_if(bits_, [&](const auto& bit) { return isOfIt(bit.first); });
      if (isOfIt(rloBit_)) rloBit_ = noKey;
    } else if (access.viaPointer) {
      forgetGlobals();
    } else {
      const std::uint64_t sort = access.area == Area::L ? localKeys : globalKeys;
      const std::uint64_t first = sort | static_cast<std::uint64_t>(access.area) << 40 | access.offset << 3;
      const std::uint64_t last = first + std::uint64_t{access.possibleLength()} * 8;
      const auto isIn = [&](BitKey key) { return first <= key && key < last; };
      std::erase_if(bits_, [&](const auto& bit) { return isIn(bit.first); });
      if (isIn(rloBit_)) rloBit_ = noKey;
    }
  }
}

void PathKnowledge::apply(const Facts& facts, const Instruction& instruction) {
  const auto makeUnknown = [&](Known firstCheck) {
    rlo_ = Known::Unknown;
    rloBit_ = noKey;
    firstCheck_ = firstCheck;
    if (firstCheck == Known::No) isOrOpen_ = false;
  };
  const StatementRole role = statementRole(instruction);
  switch (role) {
    case StatementRole::AndScan:
    case StatementRole::OrScan:
    case StatementRole::XorScan: {
      if (scansBr(instruction)) return scan(scanJoin(instruction), br_, noKey);
      const BitKey key = keyOf(facts, instruction);
      return scan(scanJoin(instruction), valueOf(key), key);
    }
    case StatementRole::OrOfAnds:
      isOrOpen_ = true;
      rlo_ = Known::Unknown;
      rloBit_ = noKey;
      return;
    case StatementRole::Open:
      levels_.push_back({rlo_, firstCheck_, isOrOpen_, scanJoin(instruction)});
      rlo_ = Known::Unknown;
      rloBit_ = noKey;
      return endString();
    case StatementRole::Close: return close();
    case StatementRole::Compare:
    case StatementRole::CompareRealEqual: return makeUnknown(Known::Yes);
    case StatementRole::Edge: forgetWritten(facts, instruction); return makeUnknown(Known::Yes);
    case StatementRole::Negate:
      rlo_ = negatedKnown(rlo_);
      rloBit_ = noKey;
      return;
    case StatementRole::SetRlo:
    case StatementRole::ClearRlo:
      rlo_ = role == StatementRole::SetRlo ? Known::Yes : Known::No;
      rloBit_ = noKey;
      return endString();
    case StatementRole::Assign: {
      const Known value = rlo_;
      const BitKey key = keyOf(facts, instruction);
      forgetWritten(facts, instruction);
      setBit(key, value);
      if (value == Known::Unknown) rloBit_ = key;
      return endString();
    }
    case StatementRole::Latch: {
      const BitKey key = keyOf(facts, instruction);
      if (rlo_ != Known::No) forgetWritten(facts, instruction);
      if (rlo_ == Known::Yes) setBit(key, setsBit(instruction) ? Known::Yes : Known::No);
      return endString();
    }
    case StatementRole::TransferStatus: br_ = Known::Unknown; return makeUnknown(Known::No);
    case StatementRole::Call:
    case StatementRole::CallByRlo:
      forgetWritten(facts, instruction);
      forgetGlobals();
      br_ = Known::Unknown;
      return makeUnknown(Known::No);
    case StatementRole::OpenRelay:
    case StatementRole::CloseRelay:
    case StatementRole::Relay: {
      // Inside a zone that is off, = and T write 0.
      const std::vector<Level> levels = levels_;
      *this = nothing();
      levels_ = levels;
      return endString();
    }
    default: return drivesElement(role) ? endString() : forgetWritten(facts, instruction);
  }
}

std::vector<PathKnowledge::Branch> PathKnowledge::branches(const Facts& facts, const Flow& flow,
                                                           std::uint32_t at) const {
  const FlowStep& step = flow.steps[at];
  const Instruction& instruction = *step.instruction;
  const StatementRole role = statementRole(instruction);
  const auto end = static_cast<std::uint32_t>(flow.steps.size());
  std::vector<Branch> result;
  switch (role) {
    case StatementRole::JumpByRlo:
    case StatementRole::JumpKeepingRlo:
    case StatementRole::EndByRlo:
      for (PathKnowledge& path : byRlo()) {
        const bool isOne = path.rlo_ == Known::Yes;
        const bool leaves = role == StatementRole::EndByRlo ? isOne : isOne == jumpsOnOne(instruction);
        if (role == StatementRole::JumpKeepingRlo) path.br_ = path.rlo_;
        path.rlo_ = Known::Yes;
        path.rloBit_ = noKey;
        path.endString();
        if (role == StatementRole::EndByRlo)
          result.push_back({path, leaves ? end : at + 1});
        else
          result.push_back({path, leaves && step.partner != noPartner ? step.partner : at + 1});
      }
      return result;
    case StatementRole::JumpByBr:
      for (const Known value : {Known::No, Known::Yes}) {
        if (br_ != Known::Unknown && br_ != value) continue;
        PathKnowledge path = *this;
        path.br_ = value;
        path.endString();
        const bool leaves = (value == Known::Yes) == jumpsOnOne(instruction);
        result.push_back({path, leaves && step.partner != noPartner ? step.partner : at + 1});
      }
      return result;
    case StatementRole::Save:
      for (PathKnowledge& path : byRlo()) {
        path.br_ = path.rlo_;
        result.push_back({path});
      }
      return result;
    default: break;
  }
  PathKnowledge path = *this;
  path.apply(facts, instruction);
  result.push_back({std::move(path)});
  return result;
}

}  // namespace rungproof
