// Adds networks to the cone until no network outside writes a place of it.
#include "analysis/cone_of_influence.hpp"

#include <algorithm>
#include <array>

#include "ir/special_memory.hpp"

namespace rungproof {

namespace {

constexpr std::uint32_t eventNumbers[] = {32, 96};  // timers that raise events 21 and 22 (001:5476)

/// Takes what it is to do from tables in memory that none of its operands covers.
bool readsTables(const Desc& desc) {
  const Role role = desc.role;
  return role == Role::Netr || role == Role::Netw || role == Role::Xmt || role == Role::Rcv || role == Role::Pls ||
         role == Role::Spa;
}

/// May meet an error that ends the program (001:13906-13937): a compare contact with a number, text or pointer that is
/// not legal.
bool canEndProgram(const Instruction& instruction) {
  if (instruction.desc->execution != Execution::Compare) return false;
  const Type type = instruction.desc->operands[0].type;
  return type == Type::Real || type == Type::String ||
         std::ranges::any_of(instruction.operands, [](const Operand& o) { return o.kind == OperandKind::Indirect; });
}

class Cone {
 public:
  explicit Cone(const Facts& facts) : facts_(facts) {
    for (std::size_t a = 0; a < areaCount; ++a) {
      const std::size_t bits = rowOf(static_cast<Area>(a), Width::Byte, 0, 0).count;
      places_[a].resize(static_cast<std::size_t>(areaSize(facts.target(), static_cast<Area>(a))) * bits);
    }
    collect();
  }

  void add(const PlaceRow& row) {
    std::vector<bool>& places = places_[static_cast<std::size_t>(row.area)];
    // A run-time error of any instruction sets SM4.3 (001:13945).
    if (row.area == Area::SM && row.first < 40 && row.first + row.count > 32) isWhole_ = true;
    const std::size_t end = std::min<std::size_t>(places.size(), std::size_t{row.first} + row.count);
    for (std::size_t i = row.first; i < end; ++i) {
      isChanged_ = isChanged_ || !places[i];
      places[i] = true;
    }
  }

  /// False if the whole program belongs to the cone.
  bool spread() {
    do {
      isChanged_ = false;
      for (Part& part : parts_) {
        if (!part.isInside && (part.isFixed || writesInside(part))) enter(part);
        if (isWhole_) return false;
      }
    } while (isChanged_);
    return true;
  }

  std::vector<bool> outside() const {
    std::vector<bool> result(facts_.instructions().size(), false);
    for (const Part& part : parts_) {
      for (const std::uint32_t id : part.instructions) result[id] = !part.isInside;
    }
    return result;
  }

 private:
  struct Part {
    std::vector<std::uint32_t> instructions;  ///< Instruction::id, of one network
    bool isFixed = false;                     ///< belongs to every cone
    bool isInside = false;
  };

  void collect() {
    const Program& program = facts_.program();
    const bool hasEvents = !facts_.calls().attachments().empty();
    for (const Pou& pou : program.pous) {
      const std::size_t first = parts_.size();
      bool sharesStack = false;
      for (const Network& network : pou.networks) {
        Part& part = parts_.emplace_back();
        for (const Instruction& instruction : network.instructions) {
          part.instructions.push_back(instruction.id);
          part.isFixed = part.isFixed || isFixed(instruction, hasEvents);
          isWhole_ = isWhole_ || readsTables(*instruction.desc);
        }
        sharesStack = sharesStack || takesFromBelow(facts_, part.instructions);
      }
      for (std::size_t i = first; sharesStack && i < parts_.size(); ++i) parts_[i].isFixed = true;
    }
    for (const CallSite& site : facts_.calls().sites()) isWhole_ = isWhole_ || site.callee == noBlock;
  }

  bool isFixed(const Instruction& instruction, bool hasEvents) const {
    if (instruction.desc->control != Control::None || actsOnDevices(*instruction.desc) || canEndProgram(instruction))
      return true;
    return std::ranges::any_of(facts_.accesses().of(instruction.id), [&](const Access& access) {
      const bool raisesEvents =
          hasEvents && access.area == Area::T && std::ranges::any_of(eventNumbers, [&](std::uint32_t n) {
            return access.offset <= n && n < access.offset + access.most;
          });
      // Control bytes of devices and the times of interrupts lie in SM.
      return (access.write || access.maybe) && (access.viaPointer || access.area == Area::SM || raisesEvents);
    });
  }

  bool writesInside(const Part& part) const {
    return std::ranges::any_of(part.instructions, [&](std::uint32_t id) {
      // Results of arithmetic: SM1.0 to SM1.7.
      if (facts_.instruction(id).desc->affects != 0 && isInside({Area::SM, 8, 8})) return true;
      return std::ranges::any_of(facts_.accesses().of(id), [&](const Access& access) {
        return (access.write || access.maybe) && isInside(rowOfAccess(access));
      });
    });
  }

  void enter(Part& part) {
    part.isInside = isChanged_ = true;
    for (const std::uint32_t id : part.instructions) {
      const bool isCall = facts_.instruction(id).desc->control == Control::Call;
      // What a block is given and hands back lies in its local memory.
      if (isCall) add({Area::L, 0, areaSize(facts_.target(), Area::L) * 8});
      for (const Access& access : facts_.accesses().of(id)) {
        if (access.write && !access.maybe) continue;
        if (access.viaPointer) isWhole_ = true;
        add(rowOfAccess(access));
      }
    }
  }

  static PlaceRow rowOfAccess(const Access& access) {
    return rowOf(access.area, access.width, access.offset, access.bit, access.most);
  }

  bool isInside(const PlaceRow& row) const {
    const std::vector<bool>& places = places_[static_cast<std::size_t>(row.area)];
    const std::size_t end = std::min<std::size_t>(places.size(), std::size_t{row.first} + row.count);
    for (std::size_t i = row.first; i < end; ++i) {
      if (places[i]) return true;
    }
    return false;
  }

  const Facts& facts_;
  std::vector<Part> parts_;
  std::array<std::vector<bool>, areaCount> places_;
  bool isWhole_ = false;
  bool isChanged_ = false;
};

}  // namespace

std::vector<bool> outsideCone(const Facts& facts, std::span<const PlaceRow> places) {
  Cone cone(facts);
  for (const PlaceRow& row : places) cone.add(row);
  return cone.spread() ? cone.outside() : std::vector<bool>{};
}

}  // namespace rungproof
