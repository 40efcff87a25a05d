// CTL004: a loop that may take longer than the watchdog: a jump back, or a FOR whose largest number of rounds times the
// execution time of its body (Appendix F) reaches 500 ms. Limits from memory count as their largest value, 32767. Of
// the S7-300/400, whose statements have no times: a jump back over statements of which none counts; LOOP is CTL008's.
// Tested by its examples, tests/rules/control_rules_test.cpp and tests/rules/step7_control_rules_test.cpp.
#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "analysis/flow/facts.hpp"
#include "analysis/flow/statement_paths.hpp"
#include "analysis/flow/step7_blocks.hpp"
#include "analysis/rule.hpp"
#include "ir/machine/choices.hpp"

namespace rungproof {

namespace {

constexpr double indirectMicroseconds = 14;  // 001:14528
constexpr double unknownMicroseconds = 10;   // instructions whose time is lost in the table

/// Times of blocks in microseconds, loops at their largest number of rounds.
class Times {
 public:
  explicit Times(const Facts& facts)
      : facts_(facts), block_(facts.program().pous.size(), -1), rounds_(facts.instructionCount(), 0) {
    for (std::uint32_t b = 0; b < block_.size(); ++b) of(b, 0);
  }
  /// Time of all rounds of the loop that begins with that FOR; 0 if it has no end.
  double ofLoop(std::uint32_t instruction) const { return rounds_[instruction]; }

 private:
  static double largest(const Instruction& loop) {
    const auto value = [&](std::size_t i, double otherwise) {
      const Operand& o = loop.operands[i];
      return o.kind == OperandKind::Constant ? static_cast<double>(o.value) : otherwise;
    };
    return std::max(0.0, value(2, 32767) - value(1, 0) + 1);
  }
  static double ofInstruction(const Instruction& instruction) {
    double time = instruction.desc->time == 0 ? unknownMicroseconds : instruction.desc->time / 100.0;
    for (const Operand& o : instruction.operands) time += o.kind == OperandKind::Indirect ? indirectMicroseconds : 0;
    return time;
  }
  double of(std::uint32_t block, int depth) {
    if (block_[block] >= 0 || depth > 16) return std::max(block_[block], 0.0);
    block_[block] = 0;  // a call back to the block counts nothing: SUB001 speaks
    std::vector<double> open{0};
    std::vector<const Instruction*> loops;
    std::size_t call = 0;  // in callsIn, which has the order of the block
    for (const FlowStep& step : facts_.plan().flows[block].steps) {
      const Instruction& instruction = *step.instruction;
      open.back() += ofInstruction(instruction);
      if (instruction.desc->control == Control::Call) {
        const std::uint32_t callee = facts_.calls().sites()[facts_.calls().callsIn(block)[call++]].callee;
        if (callee != noBlock) open.back() += of(callee, depth + 1);
      }
      if (instruction.desc->control == Control::For && step.partner != noPartner && instruction.operands.size() >= 3) {
        open.push_back(0);
        loops.push_back(&instruction);
      } else if (instruction.desc->control == Control::Next && !loops.empty()) {
        const double body = open.back() * largest(*loops.back());
        rounds_[loops.back()->id] = body;
        open.pop_back();
        loops.pop_back();
        open.back() += body;
      }
    }
    while (open.size() > 1) {
      const double rest = open.back();
      open.pop_back();
      open.back() += rest;
    }
    return block_[block] = open.back();
  }

  const Facts& facts_;
  std::vector<double> block_;
  std::vector<double> rounds_;
};

/// Whether the statement may bring a loop nearer to its end: it counts, moves a pointer, or leaves it to another block.
bool mayCount(const Instruction& instruction) {
  switch (statementRole(instruction)) {
    case StatementRole::IntegerMath:
    case StatementRole::IntegerStep:
    case StatementRole::RealMath:
    case StatementRole::MoveAr1:
    case StatementRole::MoveAr2:
    case StatementRole::Loop:
    case StatementRole::Call:
    case StatementRole::CallByRlo: return true;
    default: return false;
  }
}

void checkStep7Jumps(const Facts& facts, FindingSink& sink) {
  eachOwnBlock(facts, [&](std::uint32_t, const Flow& flow) {
    for (std::uint32_t at = 0; at < flow.steps.size(); ++at) {
      const FlowStep& step = flow.steps[at];
      const Instruction& instruction = *step.instruction;
      const bool isBack = instruction.desc->control == Control::Branch && step.partner <= at;
      if (!isBack || !facts.execution().at(instruction.id).isReachable) continue;
      const auto counts = [](const FlowStep& other) { return mayCount(*other.instruction); };
      if (std::any_of(flow.steps.begin() + step.partner, flow.steps.begin() + at + 1, counts)) continue;
      Finding& finding = sink.report(
          instruction.span, fmt::format("{} jumps back, and nothing between counts the rounds: inputs do not change "
                                        "within a scan",
                                        Facts::text(instruction)));
      finding.related.push_back({flow.steps[step.partner].instruction->span, "the loop begins here"});
      finding.help = "wait by leaving the block and asking again in the next scan (002:1296)";
    }
  });
}

void checkCtl004(const Facts& facts, FindingSink& sink) {
  if (facts.form() == StatementForm::Accumulators) return checkStep7Jumps(facts, sink);
  const double watchdog = Choices().watchdogMs() * 1000.0;
  const bool hasLoop =
      std::any_of(facts.instructions().begin(), facts.instructions().end(),
                  [](const InstructionPlace& p) { return p.instruction->desc->control == Control::For; });
  const Times* times = nullptr;
  std::vector<Times> storage;
  if (hasLoop) times = &storage.emplace_back(facts);
  for (const InstructionPlace& place :
       facts.placesOf([](const Desc& desc) { return desc.control == Control::Jump || desc.control == Control::For; })) {
    const Instruction& instruction = *place.instruction;
    const FlowStep& step = facts.plan().flows[place.block].steps[place.step];
    if (!facts.execution().at(instruction.id).isReachable || step.partner == noPartner) continue;
    if (instruction.desc->control == Control::Jump && step.partner < place.step) {
      Finding& finding = sink.report(
          instruction.span,
          fmt::format("{} jumps back; nothing bounds the number of rounds within the watchdog time of 500 ms",
                      Facts::text(instruction)));
      finding.related.push_back(
          {facts.plan().flows[place.block].steps[step.partner].instruction->span, "the loop begins here"});
      finding.help = "do one round per scan, or use FOR with a small constant (001:5718; fatal error 0003, 001:13920)";
    } else if (instruction.desc->control == Control::For && times->ofLoop(instruction.id) >= watchdog) {
      Finding& finding = sink.report(
          instruction.span,
          fmt::format("{} may run for {:.0f} ms by the times of Appendix F, longer than the watchdog of 500 ms",
                      Facts::text(instruction), times->ofLoop(instruction.id) / 1000));
      finding.help = "use a smaller limit, or spread the rounds over several scans (001:5718)";
    }
  }
}

constexpr Hazard ctl004Hazards[] = {Hazard::LoopBound, Hazard::FatalWatchdog, Hazard::S7CycleTime};

}  // namespace

extern constexpr Rule ctl004_loop_may_outlast_watchdog = {
    .id = "CTL004",
    .title = "Loop may outlast the watchdog",
    .severity = Severity::Warning,
    .needs = Needs::FlowThenSolver,
    .detects =
        "a backward jump, or a FOR whose rounds may take longer than the watchdog time by the execution times of "
        "Appendix F; S7-300/400: a backward jump over statements of which none counts",
    .why =
        "a scan of more than 500 ms is the fatal error 0003, on an S7-300/400 one longer than its monitoring time "
        "calls OB80: the CPU stops and switches its outputs off",
    .manual = "001:5718, 001:13920, 001:14522-14660, 002:1296",
    .bad = "Network 1\nLBL 1\nNetwork 2\nLD SM0.0\nINCW VW0\nNetwork 3\nLDN I0.0\nJMP 1\n",
    .good = "Network 1\nLD SM0.0\nFOR VW0, +1, +10\nNetwork 2\nLD SM0.0\nINCW VW2\nNetwork 3\nNEXT\n",
    .falsePositives = "a loop whose exit condition comes soon, or that runs WDR: the prover drops what it can bound",
    .check = checkCtl004,
    .ask = {.in = asked::Builtin, .turn = 30, .cost = 1, .hazards = ctl004Hazards},
};

}  // namespace rungproof
