// A worklist of networks.
#include "analysis/equivalence/influence.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace rungproof {

namespace {

class Spread {
 public:
  explicit Spread(const Facts& facts) : facts_(facts) {
    result_.cells.assign(facts.index().cells().size(), false);
    for (const InstructionPlace& place : facts.instructions()) byNetwork_[{place.block, place.network}].push_back(place.instruction->id);
  }

  Influence run(const std::vector<NetworkRef>& networks) {
    for (const NetworkRef& network : networks) reach({static_cast<std::uint32_t>(network.pou), static_cast<std::uint32_t>(network.network)});
    while (!open_.empty()) {
      const Where where = open_.back();
      open_.pop_back();
      for (const std::uint32_t id : byNetwork_[where]) take(where, id);
    }
    collect();
    return std::move(result_);
  }

 private:
  using Where = std::pair<std::uint32_t, std::uint32_t>;  ///< block and network

  void reach(const Where& where) {
    if (reached_.insert(where).second) open_.push_back(where);
  }
  void reachBlock(std::uint32_t block) {
    for (std::uint32_t n = 0; n < facts_.program().pous[block].networks.size(); ++n) reach({block, n});
  }

  void take(const Where& where, std::uint32_t id) {
    for (const Access& access : facts_.accesses().of(id)) {
      if (!access.write) continue;
      if (access.viaPointer) result_.isEverything = true;
      mark(access);
    }
    const Instruction& instruction = facts_.instruction(id);
    switch (instruction.desc->control) {
      case Control::None: break;
      case Control::Call:
        for (const std::uint32_t site : facts_.calls().callsIn(where.first)) {
          const CallSite& call = facts_.calls().sites()[site];
          if (call.instruction == &instruction && call.callee != noBlock) reachBlock(call.callee);
        }
        break;
      case Control::Stop: result_.isEverything = true; break;
      default: reachBlock(where.first); break;
    }
  }

  void mark(const Access& access) {
    const CellMap& cells = facts_.index().cells();
    const std::uint32_t first = facts_.cellOf(access);
    for (std::uint32_t i = 0; i < std::max<std::uint32_t>(access.possibleLength(), 1) && first + i < cells.size(); ++i) {
      if (result_.cells[first + i]) continue;
      result_.cells[first + i] = true;
      for (const std::uint32_t reader : facts_.index().at(first + i)) readBy(facts_.access(reader));
    }
    for (const std::uint32_t wide : facts_.index().wide()) readBy(facts_.access(wide));
  }
  void readBy(const Access& access) {
    if (access.write && !access.maybe) return;
    const InstructionPlace& place = facts_.place(access.instruction);
    reach({place.block, place.network});
  }

  void collect() {
    std::set<std::pair<Area, std::uint32_t>> bits;
    std::set<std::string> named;
    for (const Where& where : reached_) {
      for (const std::uint32_t id : byNetwork_[where]) {
        for (const Access& access : facts_.accesses().of(id)) {
          if (!access.write || access.viaPointer) continue;
          const bool isOutput = access.area == Area::Q || access.area == Area::AQ;
          if (isOutput) addBits(access, bits);
          const bool isMemory = access.area == Area::V || access.area == Area::M || access.area == Area::S || access.area == Area::T ||
                                access.area == Area::C;
          if (isMemory && named.insert(accessName(access)).second)
            result_.memory.push_back(direct(access.area, access.width, access.offset, access.bit));
        }
      }
    }
    for (const auto& [area, index] : bits) result_.outputs.push_back({area, index});
  }
  static void addBits(const Access& access, std::set<std::pair<Area, std::uint32_t>>& bits) {
    const std::uint32_t first = access.offset * 8 + (access.width == Width::Bit ? access.bit : 0U);
    const std::uint32_t count = access.width == Width::Bit ? access.most : access.possibleLength() * 8;
    for (std::uint32_t i = 0; i < count; ++i) bits.emplace(access.area, first + i);
  }

  const Facts& facts_;
  std::map<Where, std::vector<std::uint32_t>> byNetwork_;
  std::set<Where> reached_;
  std::vector<Where> open_;
  Influence result_;
};

}  // namespace

Influence influenceOf(const Facts& facts, const std::vector<NetworkRef>& networks) { return Spread(facts).run(networks); }

}  // namespace rungproof
