// A walk backwards from what is read to who writes it. Within a network the logic stack ties everything together, so a
// network is followed as a whole.
#include "analysis/proof/proof_networks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace rungproof {

namespace {

class UseWalk {
 public:
  UseWalk(const Facts& facts, const EncodedScan& encoding, const std::unordered_set<std::uint32_t>& variables)
      : facts_(facts) {
    for (const Cell& cell : encoding.cells()) {
      if (cell.kind == CellKind::State && variables.contains(indexOf(cell.start))) kept_.push_back(cell.place);
    }
  }

  std::vector<NetworkName> run(const std::vector<Operand>& read) {
    for (const Operand& operand : read) {
      Access access;
      access.area = operand.area;
      access.offset = operand.offset;
      access.width = operand.width;
      access.bit = operand.bit;
      followWriters(access, noReader, 0);
    }
    while (!open_.empty()) {
      const auto [block, network] = open_.back();
      open_.pop_back();
      enter(block, network);
    }
    std::vector<NetworkName> names;
    for (const auto& [block, network] : seen_)
      names.emplace_back(facts_.program().pous[block].name, facts_.program().pous[block].networks[network].number);
    return names;
  }

 private:
  using Key = std::pair<std::uint32_t, std::uint32_t>;  ///< block, network
  static constexpr std::uint32_t noReader = 0xFFFFFFFF;

  void add(std::uint32_t instruction) {
    const InstructionPlace& place = facts_.place(instruction);
    if (seen_.emplace(place.block, place.network).second) open_.emplace_back(place.block, place.network);
  }

  void enter(std::uint32_t block, std::uint32_t network) {
    for (const InstructionPlace& place : facts_.instructions()) {
      if (place.block != block) continue;
      const std::uint32_t id = place.instruction->id;
      if (place.network == network) {
        for (const Access& access : facts_.accesses().of(id)) {
          if (!access.write || access.maybe) followWriters(access, id, block);
        }
        if (const Instruction* skipper = facts_.execution().at(id).skippedBy) add(skipper->id);
      }
    }
    // A subroutine runs because it is called.
    if (facts_.program().pous[block].kind == PouKind::Main) return;
    for (const InstructionPlace& place : facts_.instructions()) {
      if (place.instruction->desc->control != Control::Call && roleOf(*place.instruction) != Role::Atch) continue;
      for (const Operand& operand : place.instruction->operands) {
        const bool isThis = facts_.program().pous[block].number ==
                            static_cast<int>(operand.kind == OperandKind::Constant ? operand.value : operand.offset);
        if (isThis) add(place.instruction->id);
      }
    }
  }

  void followWriters(const Access& read, std::uint32_t reader, std::uint32_t block) {
    std::vector<std::uint32_t> writers;
    for (std::uint32_t i = 0; i < std::max<std::uint32_t>(read.possibleLength(), 1); ++i) {
      const std::uint32_t cell = facts_.index().cells().cell(read.area, read.offset + i, block);
      if (cell >= facts_.index().cells().size()) continue;
      for (const std::uint32_t index : facts_.index().at(cell)) {
        const Access& access = facts_.access(index);
        if ((access.write || access.maybe || access.isBox) && overlaps(read, access))
          writers.push_back(access.instruction);
      }
    }
    for (const std::uint32_t index : facts_.index().wide()) {
      const Access& access = facts_.access(index);
      if (access.write && (access.viaPointer || overlaps(read, access))) writers.push_back(access.instruction);
    }
    const bool isEarlier = reader == noReader || std::any_of(writers.begin(), writers.end(), [&](std::uint32_t w) {
                             return w < reader || facts_.blockOf(w) != facts_.blockOf(reader);
                           });
    if (!isEarlier && !isKept(read)) return;
    for (const std::uint32_t writer : writers) add(writer);
  }

  static bool overlaps(const Access& a, const Access& b) {
    if (a.area != b.area) return false;
    const auto first = [](const Access& x) {
      return x.byNumber() ? x.offset * 8 : x.offset * 8 + (x.width == Width::Bit ? x.bit : 0U);
    };
    const auto last = [&](const Access& x) {
      if (x.byNumber()) return (x.offset + std::max<std::uint32_t>(x.most, 1)) * 8;
      return x.width == Width::Bit ? first(x) + std::max<std::uint32_t>(x.most, 1)
                                   : (x.offset + x.possibleLength()) * 8;
    };
    return first(a) < last(b) && first(b) < last(a);
  }

  /// Whether the verdict depends on the value that the place brings from the scan before.
  bool isKept(const Access& read) const {
    return std::any_of(kept_.begin(), kept_.end(), [&](const Place& place) {
      if (place.isRegister) {
        const bool isTimer = place.reg == Reg::TimerBit || place.reg == Reg::TimerCurrent ||
                             place.reg == Reg::TimerRunning || place.reg == Reg::TimerInput;
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

  const Facts& facts_;
  std::vector<Place> kept_;
  std::set<Key> seen_;
  std::vector<Key> open_;
};

}  // namespace

std::vector<NetworkName> networksBehind(const Facts& facts, const EncodedScan& encoding,
                                        const std::vector<Operand>& read,
                                        const std::unordered_set<std::uint32_t>& variables) {
  return UseWalk(facts, encoding, variables).run(read);
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
