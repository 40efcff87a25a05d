// The RLO of an S7-300/400: first check, AND groups joined by O, nesting levels (002:2697-2714), as trees.
#include <map>
#include <optional>
#include <utility>

#include "engine/coverage/logic_reader.hpp"
#include "engine/coverage/step_words.hpp"
#include "ir/s7300/statement_detail.hpp"

namespace rungproof {

namespace {

class RloReader final : public LogicReader {
 public:
  explicit RloReader(CoverageMap& map) : LogicReader(map) { findStepWords(); }

  void beginBlock(const Pou& pou) override {
    words_.beginBlock(pou);
    state_ = {hidden(), std::nullopt, false};
    levels_.clear();
    loaded_ = nullptr;
  }

  void read(const Instruction& instruction, CoveragePlace place) override {
    const StatementRole role = statementRole(instruction);
    const Instruction* const loaded = std::exchange(loaded_, nullptr);
    switch (role) {
      case StatementRole::AndScan:
      case StatementRole::OrScan:
      case StatementRole::XorScan: {
        const ScanJoin join = scanJoin(instruction);
        return scan(join.role, leafOf(LeafKind::Contact, instruction, place, join.negated));
      }
      case StatementRole::OrOfAnds:
        if (state_.firstCheck) state_.groups = rlo();
        state_.firstCheck = false;
        return;
      case StatementRole::Open:
        levels_.push_back({state_, scanJoin(instruction)});
        state_ = {trees().constant(false), std::nullopt, false};
        return;
      case StatementRole::Close: {
        if (levels_.empty()) return forget();
        const LogicNode inner = rlo();
        const auto [outer, join] = levels_.back();
        levels_.pop_back();
        state_ = outer;
        return scan(join.role, join.negated ? trees().lnot(inner) : inner);
      }
      case StatementRole::Edge: {
        const bool isRising = findsRise(instruction);
        const LogicNode input = isRising ? rlo() : trees().lnot(rlo());
        state_ = {trees().join(LogicOp::And, input, leafOf(LeafKind::Edge, instruction, place)), std::nullopt, true};
        return;
      }
      case StatementRole::Compare:
      case StatementRole::CompareRealEqual:
        state_ = {leafOf(LeafKind::Contact, instruction, place), std::nullopt, true};
        return;
      case StatementRole::Negate:
        state_.group = trees().lnot(rlo());
        state_.groups.reset();
        return;
      case StatementRole::SetRlo:
      case StatementRole::ClearRlo:
        state_ = {trees().constant(role == StatementRole::SetRlo), std::nullopt, false};
        return;
      case StatementRole::OpenRelay:
      case StatementRole::CloseRelay:  // a new string begins; until then the RLO is 1
        state_ = {trees().constant(true), std::nullopt, false};
        return;
      case StatementRole::JumpByRlo:
      case StatementRole::JumpKeepingRlo:
      case StatementRole::EndByRlo:
      case StatementRole::CallByRlo: use(instruction, place); return forget();
      case StatementRole::Transfer:
        output(instruction, false, place);
        if (const Operand* to = namedBy(instruction, role); loaded != nullptr && to != nullptr && words_.contains(*to))
          transition({TransitionKind::StepWord, &instruction, toString(*to) + " -> " + toString(loaded->operands[0]),
                      static_cast<std::uint64_t>(loaded->operands[0].value), place});
        return;
      case StatementRole::Load: loaded_ = isConstantLoad(instruction) ? &instruction : nullptr; return;
      case StatementRole::Call: output(instruction, false, place); return forget();
      case StatementRole::JumpAlways:
      case StatementRole::JumpByBr:
      case StatementRole::JumpByResult:
      case StatementRole::Loop:
      case StatementRole::Distributor:
      case StatementRole::End: return forget();
      default:
        if (drivesBit(role) || drivesElement(role)) {
          use(instruction, place);
          return end();
        }
        if (instruction.desc->control == Control::LabelMark) forget();
        return;
    }
  }

 private:
  struct State {
    LogicNode group = 0;
    std::optional<LogicNode> groups{};  ///< AND groups that stand before this one
    bool firstCheck = false;            ///< /FC: the string has begun
  };

  LogicNode rlo() {
    if (!state_.groups) return state_.group;
    return state_.firstCheck ? trees().join(LogicOp::Or, state_.group, *state_.groups) : *state_.groups;
  }
  void scan(StatementRole role, LogicNode value) {
    if (role == StatementRole::AndScan) {
      state_.group = state_.firstCheck ? trees().join(LogicOp::And, state_.group, value) : value;
      state_.firstCheck = true;
      return;
    }
    const bool joins = state_.firstCheck || state_.groups;
    const LogicOp op = role == StatementRole::OrScan ? LogicOp::Or : LogicOp::Xor;
    state_.group = joins ? trees().join(op, rlo(), value) : value;
    state_.groups.reset();
    state_.firstCheck = true;
  }
  void use(const Instruction& instruction, CoveragePlace place) {
    output(instruction, true, place);
    decide(instruction, 0, rlo(), place);
  }
  /// The string ends; its RLO stays for who uses it next.
  void end() {
    state_.group = rlo();
    state_.groups.reset();
    state_.firstCheck = false;
  }
  void forget() { state_ = {hidden(), std::nullopt, false}; }

  static bool isConstantLoad(const Instruction& instruction) {
    return statementRole(instruction) == StatementRole::Load && !instruction.operands.empty() &&
           instruction.operands[0].kind == OperandKind::Constant;
  }

  /// The place that a statement of the role names, in a data block that is open or an instance too, or nullptr.
  static const Operand* namedBy(const Instruction& instruction, StatementRole role) {
    if (statementRole(instruction) != role || instruction.operands.empty()) return nullptr;
    const Operand& o = instruction.operands[0];
    const bool isInBlock = o.kind == OperandKind::Indirect && o.reach != nullptr &&
                           (o.reach->way == Way::OpenBlock || o.reach->way == Way::Instance);
    return o.kind == OperandKind::Direct || isInBlock ? &o : nullptr;
  }

  static bool isLocal(const Operand& operand) { return operand.kind == OperandKind::Direct && operand.area == Area::L; }

  void findStepWords() {
    for (const Pou& pou : program().pous) {
      words_.beginBlock(pou);
      std::map<std::uint32_t, const Operand*> copies;  // of words in local memory, by offset: CASE of SCL compares them
      for (const Network& network : pou.networks) {
        const std::vector<Instruction>& list = network.instructions;
        for (std::size_t i = 0; i < list.size(); ++i) {
          const Operand* const compared = i >= 2 && comparesForEquality(list[i]) && isConstantLoad(list[i - 1])
                                              ? namedBy(list[i - 2], StatementRole::Load)
                                              : nullptr;
          if (compared != nullptr) {
            const auto copy = isLocal(*compared) ? copies.find(compared->offset) : copies.end();
            words_.compares(copy != copies.end() ? *copy->second : *compared, list[i - 1].operands[0].value);
          }
          const Operand* const to = namedBy(list[i], StatementRole::Transfer);
          if (to == nullptr) continue;
          if (isLocal(*to)) {
            const Operand* const from = i >= 1 ? namedBy(list[i - 1], StatementRole::Load) : nullptr;
            if (from != nullptr && !isLocal(*from))
              copies[to->offset] = from;
            else
              copies.erase(to->offset);
          }
          if (i >= 1 && isConstantLoad(list[i - 1]))
            words_.moves(*to, list[i - 1].operands[0].value);
          else
            words_.writes(*to);
        }
      }
    }
  }

  State state_;
  std::vector<std::pair<State, ScanJoin>> levels_;
  const Instruction* loaded_ = nullptr;
  StepWords words_;
};

}  // namespace

std::unique_ptr<LogicReader> rloReader(CoverageMap& map) { return std::make_unique<RloReader>(map); }

}  // namespace rungproof
