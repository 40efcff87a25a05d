// Facts: everything that rules may ask about a program, built once and shared by all of them. Construction and every
// question are linear in the program or constant, so that linting on save stays free.
// Tested by tests/rules/facts_test.cpp; cost by tests/timing/lint_growth_test.cpp.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "analysis/flow/access.hpp"
#include "analysis/flow/access_bits.hpp"
#include "analysis/flow/access_index.hpp"
#include "analysis/flow/block_row.hpp"
#include "analysis/flow/call_graph.hpp"
#include "analysis/flow/execution.hpp"
#include "analysis/flow/stack_depth.hpp"
#include "analysis/property.hpp"
#include "analysis/surroundings.hpp"
#include "ir/program.hpp"
#include "ir/s7200/call_contract.hpp"

namespace rungproof {

class PointerTable;  // analysis/flow/dataflow_pointers.hpp
namespace iec {
class VariableUses;  // analysis/flow/variable_uses.hpp
}

/// Where an instruction stands.
struct InstructionPlace {
  const Instruction* instruction;
  std::uint32_t block;    ///< index in Program::pous and Plan::flows
  std::uint32_t step;     ///< index in Flow::steps
  std::uint32_t network;  ///< index in Pou::networks
};

/// The instructions of a program in its order, each with its place, which is made when it is asked for: a long program
/// has no room for a table of them.
class InstructionRow {
 public:
  class Iterator {
   public:
    using value_type = InstructionPlace;
    using difference_type = std::ptrdiff_t;
    using iterator_category = std::input_iterator_tag;

    Iterator() = default;
    Iterator(const std::vector<Flow>* flows, std::uint32_t block) : flows_(flows), block_(block) { passEmpty(); }
    InstructionPlace operator*() const {
      const FlowStep& step = (*flows_)[block_].steps[step_];
      return {step.instruction, block_, step_, step.network};
    }
    Iterator& operator++() {
      ++step_;
      passEmpty();
      return *this;
    }
    Iterator operator++(int) {
      const Iterator before = *this;
      ++*this;
      return before;
    }
    bool operator==(const Iterator& other) const { return block_ == other.block_ && step_ == other.step_; }

   private:
    void passEmpty() {
      for (; block_ < flows_->size() && step_ == (*flows_)[block_].steps.size(); step_ = 0) ++block_;
    }

    const std::vector<Flow>* flows_ = nullptr;
    std::uint32_t block_ = 0, step_ = 0;
  };

  explicit InstructionRow(const std::vector<Flow>& flows) : flows_(flows) {}
  Iterator begin() const { return {&flows_, 0}; }
  Iterator end() const { return {&flows_, static_cast<std::uint32_t>(flows_.size())}; }

 private:
  const std::vector<Flow>& flows_;
};

class Facts {
 public:
  explicit Facts(const Program& program, std::span<const ExternalRange> externals = {}, Surroundings around = {});
  ~Facts();
  Facts(const Facts&) = delete;
  Facts& operator=(const Facts&) = delete;

  const Program& program() const { return program_; }
  const Target& target() const { return program_.target; }
  const Plan& plan() const { return plan_; }
  const Dialect& dialect() const { return plan_.dialect(); }
  StatementForm form() const { return plan_.form(); }
  const Surroundings& surroundings() const { return surroundings_; }
  /// What a panel or a network writes, as it was declared; tags of a panel are part of it.
  std::span<const ExternalRange> externals() const { return externals_; }

  /// All instructions in program order, which is that of Instruction::id.
  InstructionRow instructions() const { return InstructionRow(plan_.flows); }
  std::uint32_t instructionCount() const { return blocks_.instructionCount(); }
  /// Those of the instructions whose descriptor fits, in program order, without a look at the others: for rules that
  /// speak of few.
  template <class Fits>
  std::vector<InstructionPlace> placesOf(Fits fits) const {
    return placesOfIds(idsOf(fits));
  }
  template <class Fits>
  std::vector<std::uint32_t> idsOf(Fits fits) const {
    std::vector<const std::vector<std::uint32_t>*> rows;
    for (const auto& [desc, users] : users_) {
      if (fits(*desc)) rows.push_back(&users);
    }
    return idsIn(rows);
  }
  std::vector<InstructionPlace> placesOf(Role role) const {
    return placesOf([role](const Desc& desc) { return desc.role == role; });
  }
  /// Ids of the instructions with an operand of that kind, in program order; not kept for direct ones, which most are.
  std::span<const std::uint32_t> withOperand(OperandKind kind) const {
    return withOperand_[static_cast<std::size_t>(kind)];
  }
  const Instruction& instruction(std::uint32_t id) const { return *stepOf(id).instruction; }
  /// Without a look at the instruction.
  Role roleAt(std::uint32_t id) const { return roles_[id]; }
  InstructionPlace place(std::uint32_t id) const {
    const std::uint32_t block = blocks_[id], at = id - blocks_.first(block);
    const FlowStep& step = plan_.flows[block].steps[at];
    return {step.instruction, block, at, step.network};
  }
  const Pou& pouOf(std::uint32_t id) const { return program_.pous[blocks_[id]]; }
  const Network& networkOf(std::uint32_t id) const { return pouOf(id).networks[stepOf(id).network]; }
  const Flow& flowOf(std::uint32_t id) const { return plan_.flows[blocks_[id]]; }
  std::uint32_t blockOf(std::uint32_t id) const { return blocks_[id]; }

  const AccessTable& accesses() const { return accesses_; }
  const AccessIndex& index() const { return index_; }
  const BitWrites& bits() const { return bits_; }
  const Access& access(std::uint32_t i) const { return accesses_.all()[i]; }
  const CallGraph& calls() const { return calls_; }
  /// What calls of blocks without text may do.
  const CallContracts& contracts() const { return contracts_; }
  const StackRun& stack() const { return stack_; }
  const ExecutionTable& execution() const { return execution_; }
  const PointerTable& pointers() const { return *pointers_; }
  /// IEC 61131-3: where its texts use their variables; of other programs nothing.
  const iec::VariableUses& variableUses() const { return *variableUses_; }
  /// What may leave the instruction out in a scan (ExecutionTable::skipper), or nullptr.
  const Instruction* skippedBy(std::uint32_t id) const {
    return execution_.at(id).isSkipped ? &instruction(execution_.skipper(id)) : nullptr;
  }

  /// Whether some code is not visible: protected blocks, networks that could not be read. Rules that speak of
  /// something missing are silent then.
  bool hasHiddenCode() const { return hasHiddenCode_; }
  /// Whether a line of some network could not be read; of one of this block; of the one that holds the instruction.
  /// Rules that need the instruction which that line may have been say nothing.
  /// Whether something that may run could not be read.
  bool hasUnreadCode() const { return hasUnreadCode_; }
  bool hasUnreadCode(const Pou& block) const;
  bool hasUnreadCode(std::uint32_t block) const { return hasUnreadCode(program_.pous[block]); }
  bool isUnread(std::uint32_t id) const { return hasUnreadFrame_ || !networkOf(id).complete; }
  /// Whether a heading, a declaration, a Network line or a whole file could not be read: only rules that stand alone
  /// speak then (Rule::standsAlone).
  bool hasUnreadFrame() const { return hasUnreadFrame_; }

  /// Whether an instruction names an accumulator of the S7-200.
  bool usesAccumulators() const;

  /// Ids of the boxes with that timer or counter number, in program order.
  std::span<const std::uint32_t> timerBoxes(std::uint32_t number) const {
    return number < 256 ? std::span<const std::uint32_t>(timers_[number]) : std::span<const std::uint32_t>();
  }
  std::span<const std::uint32_t> counterBoxes(std::uint32_t number) const {
    return number < 256 ? std::span<const std::uint32_t>(counters_[number]) : std::span<const std::uint32_t>();
  }

  /// What is known about the condition under which the instruction acts: its power flow and that of its block.
  Condition conditionOf(std::uint32_t id) const;
  /// Whether the cell is declared external: a panel, a network partner or a person may write and read it.
  bool isExternal(std::uint32_t cell) const { return external_[cell] != 0; }
  /// Accesses that write the bit directly, 0, 1 or 2 for "more"; accesses through pointers and long blocks are not
  /// counted.
  int writers(std::uint32_t cell, unsigned bit) const { return writers_[cell * 8 + bit]; }
  /// The same for reads, without those of an instruction that reads only to change the place itself.
  int readers(std::uint32_t cell, unsigned bit) const { return readers_[cell * 8 + bit]; }
  std::uint32_t cellOf(const Access& access) const {
    return index_.cells().cell(access.area, access.offset, blockOf(access.instruction));
  }

  /// "Q0.1" for a bit of a cell.
  std::string bitName(std::uint32_t key) const;
  /// First symbol of an address, or nullptr; constant time.
  const Symbol* symbolOf(const Operand& address) const;
  /// First symbol of that name, or nullptr; constant time.
  const Symbol* symbolNamed(std::string_view name) const;
  /// "Q0.1", with its symbol if there is one: "Q0.1 (Pump)".
  std::string name(const Operand& operand) const;
  /// Mnemonic and operands: "TON T37, +10".
  static std::string text(const Instruction& instruction);
  /// The same, but of a text whose statements are several instructions each (IEC 61131-3, SCL): the first line of the
  /// part of the statement that the instruction was made of.
  static std::string text(const Program& program, const Instruction& instruction);

 private:
  /// All the ids in ascending rows, in program order.
  static std::vector<std::uint32_t> idsIn(std::span<const std::vector<std::uint32_t>* const> rows);
  std::vector<InstructionPlace> placesOfIds(std::span<const std::uint32_t> ids) const;
  const FlowStep& stepOf(std::uint32_t id) const {
    const std::uint32_t block = blocks_[id];
    return plan_.flows[block].steps[id - blocks_.first(block)];
  }
  void findPulses();
  void collectBoxes();
  void noteOperand(std::uint32_t id, OperandKind kind);
  void collectSymbols();
  void collectExternals();
  void countUses();

  const Program& program_;
  Surroundings surroundings_;
  std::vector<ExternalRange> externals_;
  Plan plan_;
  std::unordered_map<const Desc*, std::vector<std::uint32_t>> users_;  ///< ids of the instructions of each descriptor
  std::array<std::vector<std::uint32_t>, 7> withOperand_;              ///< by OperandKind
  std::vector<Role> roles_;                                            ///< by Instruction::id
  AccessTable accesses_;
  BlockRow blocks_;
  AccessIndex index_;
  BitWrites bits_;
  std::vector<std::uint8_t> writers_, readers_;
  CallGraph calls_;
  CallContracts contracts_;
  StackRun stack_;
  ExecutionTable execution_;
  std::unique_ptr<const PointerTable> pointers_;
  std::unique_ptr<const iec::VariableUses> variableUses_;
  std::array<std::vector<std::uint32_t>, 256> timers_, counters_;
  std::vector<std::uint8_t> external_;
  bool hasHiddenCode_ = false, hasUnreadCode_ = false, hasUnreadFrame_ = false;
  std::unordered_map<std::uint64_t, const Symbol*> symbolByAddress_;
  std::unordered_map<std::string_view, const Symbol*> symbolByName_;
};

}  // namespace rungproof
