// A walk backwards from what is read to who writes it. Within a network the logic stack ties everything together, so a
// network is followed as a whole. Of an S7-300/400 the registers tie networks together too: the open data block,
// address registers, relays, and what a network takes over from the one before.
#include "analysis/proof/proof_networks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <unordered_map>

#include "analysis/proof/written_places.hpp"
#include "analysis/unread/influence.hpp"
#include "ir/s7300/pointer_parameter.hpp"
#include "ir/s7300/statement_role.hpp"

namespace rungproof {

namespace {

/// Whether a network may begin with it whatever stands in front: it uses neither the RLO nor accumulators.
bool beginsAnew(StatementRole role) {
  switch (role) {
    case StatementRole::AndScan:
    case StatementRole::OrScan:
    case StatementRole::XorScan:
    case StatementRole::Open:
    case StatementRole::SetRlo:
    case StatementRole::ClearRlo:
    case StatementRole::JumpAlways:
    case StatementRole::Call:
    case StatementRole::Load:
    case StatementRole::LoadAr1:
    case StatementRole::LoadAr2:
    case StatementRole::OpenBlock:
    case StatementRole::End:
    case StatementRole::CloseRelay:
    case StatementRole::Relay:
    case StatementRole::Nothing: return true;
    default: return false;
  }
}

/// What earlier statements of its block hand on to a network, beside memory.
enum class Tie : std::uint8_t { None, OpenBlock, AddressRegister, Relay };

Tie tieOf(StatementRole role) {
  switch (role) {
    case StatementRole::OpenBlock:
    case StatementRole::ExchangeBlocks: return Tie::OpenBlock;
    case StatementRole::LoadAr1:
    case StatementRole::LoadAr2:
    case StatementRole::Ar2ToAr1:
    case StatementRole::Ar1ToAr2:
    case StatementRole::ExchangeAr:
    case StatementRole::MoveAr1:
    case StatementRole::MoveAr2: return Tie::AddressRegister;
    case StatementRole::OpenRelay:
    case StatementRole::CloseRelay:
    case StatementRole::Relay: return Tie::Relay;
    default: return Tie::None;
  }
}

}  // namespace

class NetworksBehind::Walk {
 public:
  Walk(const Facts& facts, const EncodedScan& encoding)
      : facts_(facts), writes_(facts), hasDataBlocks_(facts.dialect().memory.hasDataBlocks) {
    for (const Cell& cell : encoding.cells()) {
      if (cell.kind == CellKind::State) stateOf_.emplace(indexOf(cell.start), cell.place);
    }
    for (const InstructionPlace& place : facts.instructions()) {
      if (parts_.empty() || parts_.back().block != place.block || parts_.back().network != place.network)
        parts_.push_back({place.block, place.network});
      parts_.back().instructions.push_back(place.instruction->id);
      partOf_.push_back(parts_.size() - 1);
      const Tie tie = tieOf(statementRole(*place.instruction));
      if (tie != Tie::None) ties_.insert({place.block, static_cast<std::uint8_t>(tie), parts_.size() - 1});
    }
  }

  std::vector<NetworkName> run(const Operands& read, const std::unordered_set<std::uint32_t>& variables) {
    kept_.clear();
    inherited_.clear();
    for (const std::uint32_t variable : variables) {
      const auto state = stateOf_.find(variable);
      if (state != stateOf_.end()) kept_.push_back(state->second);
    }
    for (const Operand& operand : read) {
      Access access;
      access.area = operand.area;
      access.offset = operand.offset;
      access.width = operand.width;
      access.bit = operand.bit;
      followWriters(access, noReader, 0);
    }
    while (!open_.empty()) {
      const std::size_t part = open_.back();
      open_.pop_back();
      enter(part);
    }
    std::ranges::sort(seen_);
    std::vector<NetworkName> names;
    for (const std::size_t at : seen_) {
      Part& part = parts_[at];
      part.isSeen = false;
      const Pou& pou = facts_.program().pous[part.block];
      names.emplace_back(pou.name, pou.networks[part.network].number);
    }
    seen_.clear();
    return names;
  }

 private:
  /// A network.
  struct Part {
    std::uint32_t block = 0, network = 0;
    std::vector<std::uint32_t> instructions{};  ///< Instruction::id
    bool isSeen = false;
  };
  static constexpr std::uint32_t noReader = 0xFFFFFFFF;

  void addPart(std::size_t part) {
    if (parts_[part].isSeen) return;
    parts_[part].isSeen = true;
    seen_.push_back(part);
    open_.push_back(part);
  }
  void add(std::uint32_t instruction) { addPart(partOf_[instruction]); }

  void enter(std::size_t at) {
    const Part& part = parts_[at];
    for (const std::uint32_t id : part.instructions) {
      for (const Access& access : facts_.accesses().of(id)) {
        if (!access.write || access.maybe) followWriters(access, id, part.block);
      }
      if (facts_.execution().at(id).isSkipped) add(facts_.execution().skipper(id));
    }
    // A subroutine runs because it is called, and what a call hands back its routine has made.
    for (const std::uint32_t site : facts_.calls().callsOf(part.block))
      add(facts_.calls().sites()[site].instruction->id);
    for (const Attachment& attachment : facts_.calls().attachments()) {
      if (attachment.routine == part.block) add(attachment.instruction->id);
    }
    for (const std::uint32_t site : facts_.calls().callsIn(part.block)) {
      const CallSite& call = facts_.calls().sites()[site];
      if (call.callee != noBlock && partOf_[call.instruction->id] == at) addHandedBack(call.callee);
    }
    followRegisters(at);
  }

  /// Networks of a block that write what it gives its caller.
  void addHandedBack(std::uint32_t block) {
    const Pou& pou = facts_.program().pous[block];
    const auto isGiven = [&](const Access& access) {
      if (!access.write) return false;
      if (access.viaPointer && access.pointed == Pointed::OfCall) return true;
      const bool isOwn = hasDataBlocks_ ? hasInstance(pou) && access.viaPointer && access.area == Area::DB
                                        : !access.viaPointer && access.area == Area::L;
      return isOwn && std::ranges::any_of(pou.locals, [&](const LocalVariable& local) {
               const bool isBack = local.section == VarSection::Output || local.section == VarSection::InOut;
               const std::uint32_t size = std::max<std::uint32_t>(
                   hasDataBlocks_ ? local.size : static_cast<std::uint32_t>(bytes(widthOf(local.type))), 1);
               return isBack && access.offset < local.address.offset + size &&
                      local.address.offset < access.offset + std::max<std::uint32_t>(access.possibleLength(), 1);
             });
    };
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      if (parts_[i].block != block || parts_[i].isSeen) continue;
      for (const std::uint32_t id : parts_[i].instructions) {
        if (std::ranges::any_of(facts_.accesses().of(id), isGiven)) addPart(i);
      }
    }
  }

  /// Networks of the same block that leave something in registers which this one uses.
  void followRegisters(std::size_t at) {
    const Part& part = parts_[at];
    const bool hasOneBefore = at > 0 && parts_[at - 1].block == part.block;
    if (hasOneBefore && takesFromBelow(facts_, part.instructions)) addPart(at - 1);
    if (facts_.form() != StatementForm::Accumulators) return;
    if (hasOneBefore && !beginsAnew(statementRole(facts_.instruction(part.instructions.front())))) addPart(at - 1);
    addTied(part.block, Tie::Relay);
    for (const std::uint32_t id : part.instructions) {
      for (const Operand& operand : facts_.instruction(id).operands) {
        if (operand.reach == nullptr) continue;
        const Way way = operand.reach->way;
        if (way == Way::OpenBlock) addTied(part.block, Tie::OpenBlock);
        if (way == Way::Register || way == Way::Crossing) addTied(part.block, Tie::AddressRegister);
      }
    }
  }
  void addTied(std::uint32_t block, Tie tie) {
    const auto kind = static_cast<std::uint8_t>(tie);
    for (auto i = ties_.lower_bound({block, kind, 0}); i != ties_.end() && i->block == block && i->tie == kind; ++i)
      addPart(i->part);
    // A block that opens no data block works in that of its caller, which its calls stand for.
    if (tie != Tie::OpenBlock || !inherited_.insert(block).second) return;
    for (const std::uint32_t site : facts_.calls().callsOf(block)) addTied(facts_.calls().sites()[site].caller, tie);
  }

  void followWriters(const Access& read, std::uint32_t reader, std::uint32_t block) {
    std::vector<std::uint32_t> writers;
    writes_.eachWriter(read, block, [&](const Access& write) { writers.push_back(write.instruction); });
    const bool isEarlier =
        reader == noReader || read.viaPointer || std::any_of(writers.begin(), writers.end(), [&](std::uint32_t w) {
          return w < reader || facts_.blockOf(w) != facts_.blockOf(reader);
        });
    if (!isEarlier && !isKept(read)) return;
    for (const std::uint32_t writer : writers) add(writer);
  }

  /// Whether the verdict depends on the value that the place brings from the scan before.
  bool isKept(const Access& read) const {
    return std::any_of(kept_.begin(), kept_.end(), [&](const Place& place) {
      if (place.isRegister) {
        const bool isTimer = place.reg == Reg::TimerBit || place.reg == Reg::TimerCurrent ||
                             place.reg == Reg::TimerRunning || place.reg == Reg::TimerInput || place.reg == Reg::S5Rest;
        const bool isCounter = place.reg == Reg::CounterBit || place.reg == Reg::CounterCurrent ||
                               place.reg == Reg::CounterUp || place.reg == Reg::CounterDown;
        const bool isOther = place.reg == Reg::Accumulator;
        return place.at == read.offset && ((isTimer && read.area == Area::T) || (isCounter && read.area == Area::C) ||
                                           (isOther && read.area == Area::AC));
      }
      if (place.area != read.area) return false;
      const std::uint32_t first = place.at / 8, last = (place.at + place.width - 1) / 8;
      return first < read.offset + std::max<std::uint32_t>(read.possibleLength(), 1) && read.offset <= last;
    });
  }

  /// A network of a block that hands something on in registers.
  struct Tied {
    std::uint32_t block;
    std::uint8_t tie;  ///< Tie
    std::size_t part;
    friend auto operator<=>(const Tied&, const Tied&) = default;
  };

  const Facts& facts_;
  const WrittenPlaces writes_;
  bool hasDataBlocks_;
  std::unordered_map<std::uint32_t, Place> stateOf_;  ///< by node index of its start
  std::vector<Place> kept_;
  std::vector<std::size_t> seen_;    ///< parts, by the question at hand
  std::vector<Part> parts_;          ///< in program order
  std::vector<std::size_t> partOf_;  ///< by Instruction::id
  std::set<Tied> ties_;
  std::set<std::uint32_t> inherited_;  ///< blocks whose callers have been asked for the data block they leave open
  std::vector<std::size_t> open_;
};

NetworksBehind::NetworksBehind(const Facts& facts, const EncodedScan& encoding)
    : walk_(std::make_unique<Walk>(facts, encoding)) {}
NetworksBehind::~NetworksBehind() = default;

std::vector<NetworkName> NetworksBehind::of(const Operands& read, const std::unordered_set<std::uint32_t>& variables) {
  return walk_->run(read, variables);
}

std::string networkList(const std::vector<NetworkName>& networks) {
  std::string text;
  for (std::size_t i = 0; i < networks.size();) {
    std::size_t end = i + 1;
    while (end < networks.size() && networks[end].first == networks[i].first &&
           networks[end].second == networks[end - 1].second + 1)
      ++end;
    const bool isNewBlock = i == 0 || networks[i].first != networks[i - 1].first;
    text += i == 0 ? "" : isNewBlock ? "; " : ", ";
    if (isNewBlock) text += networks[i].first + " ";
    text += end - i > 2 ? fmt::format("{}-{}", networks[i].second, networks[end - 1].second)
                        : fmt::format("{}", networks[i].second);
    i = end - i > 2 ? end : i + 1;
  }
  return text;
}

}  // namespace rungproof
