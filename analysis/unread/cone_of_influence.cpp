// Adds networks to the cone until no network outside writes a place of it.
#include "analysis/unread/cone_of_influence.hpp"

#include <algorithm>

namespace rungproof {

namespace {

/// Takes what it is to do from tables in memory that none of its operands covers.
bool readsTables(const Desc& desc) {
  const Role role = desc.role;
  return role == Role::Netr || role == Role::Netw || role == Role::Get || role == Role::Put || role == Role::Xmt ||
         role == Role::Rcv || role == Role::Pls;
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
  explicit Cone(const Facts& facts) : facts_(facts), places_(facts.target()) { collect(); }

  void add(const PlaceRow& row) {
    isWhole_ = isWhole_ || meet(row, errorBits);
    isChanged_ = places_.set(row, true) || isChanged_;
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
    std::vector<bool> result(facts_.instructionCount(), false);
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
    for (const auto& [id, contract] : facts_.contracts().all())
      isWhole_ = isWhole_ || contract.mayDoAnything || contract.fillsAnyV;
  }

  bool isFixed(const Instruction& instruction, bool hasEvents) const {
    if (instruction.desc->control != Control::None || actsOnDevices(*instruction.desc) || canEndProgram(instruction))
      return true;
    return std::ranges::any_of(facts_.accesses().of(instruction.id), [&](const Access& access) {
      // Control bytes of devices and the times of interrupts lie in SM.
      return (access.write || access.maybe) &&
             (access.viaPointer || access.area == Area::SM || (hasEvents && raisesEvents(rowOf(access))));
    });
  }

  bool writesInside(const Part& part) const {
    return std::ranges::any_of(part.instructions, [&](std::uint32_t id) {
      if (facts_.instruction(id).desc->affects != 0 && places_.first(resultBits)) return true;
      return std::ranges::any_of(facts_.accesses().of(id), [&](const Access& access) {
        return (access.write || access.maybe) && places_.first(rowOf(access));
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
        add(rowOf(access));
      }
    }
  }

  const Facts& facts_;
  std::vector<Part> parts_;
  PlaceMap<std::uint8_t> places_;  ///< 1: belongs to the cone
  bool isWhole_ = false;
  bool isChanged_ = false;
};

}  // namespace

std::vector<bool> outsideCone(const Facts& facts, std::span<const PlaceRow> places) {
  // Accumulators are handed on over networks, and jumps between expressions lead over them.
  if (facts.form() != StatementForm::Rungs) return {};
  Cone cone(facts);
  for (const PlaceRow& row : places) cone.add(row);
  return cone.spread() ? cone.outside() : std::vector<bool>{};
}

}  // namespace rungproof
