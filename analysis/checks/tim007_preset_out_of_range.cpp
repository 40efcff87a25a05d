// TIM007: a preset that is not within 1 to 32767: a constant, or a word that only constants are moved into. Values that
// the program computes are the prover's. Tested by its examples and tests/rules/timer_rules_test.cpp.
#include <fmt/format.h>

#include <map>
#include <optional>

#include "analysis/asking/asking.hpp"
#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

constexpr std::int64_t largest = 32767;

bool isBad(std::int64_t value) { return value < 1 || value > largest; }

/// A move of a constant outside the range into the word at the access, if nothing but such moves writes it.
const Instruction* badMove(const Facts& facts, const Access& preset) {
  const std::uint32_t cell = facts.cellOf(preset);
  if (cell == facts.index().cells().size() || facts.index().isWrittenAtLarge(cell) || facts.isExternal(cell))
    return nullptr;
  const Instruction* bad = nullptr;
  for (const std::uint32_t i : facts.index().at(cell)) {
    const Access& access = facts.access(i);
    if (!access.write) continue;
    const Instruction& instruction = facts.instruction(access.instruction);
    const bool isMove =
        isMoveOf(*instruction.desc, Type::Word) && access.offset == preset.offset && instruction.operands.size() == 2;
    if (!isMove || instruction.operands[0].kind != OperandKind::Constant) return nullptr;
    if (bad == nullptr && isBad(instruction.operands[0].value)) bad = &instruction;
  }
  return bad;
}

void checkBox(const Facts& facts, FindingSink& sink, const Instruction& box) {
  const bool isTimer = isTimerBox(roleOf(box));
  const Operand& preset = box.operands[1];
  const std::string_view effect = isTimer ? "the timer fires at once" : "the counter bit is on at once";
  const auto report = [&](Span span, std::int64_t value) -> Finding& {
    const std::string why =
        value > largest ? fmt::format("as a signed word it is {}", value - 65536) : std::string(effect);
    Finding& finding = sink.report(
        span, fmt::format("the preset of {} is {}, not within 1 to 32767: {}", Facts::text(box), value, why));
    finding.address = toString(box.operands[0]);
    finding.confirmation = Confirmation::NotNeeded;
    finding.help = "the preset is a signed word (001:6569); choose a number with a coarser resolution for longer times";
    return finding;
  };
  if (preset.kind == OperandKind::Constant && preset.form != ConstantForm::Real) {
    if (isBad(preset.value)) report(preset.span, preset.value);
    return;
  }
  for (const Access& access : facts.accesses().of(box.id)) {
    if (access.operand != 1 || access.write || access.viaPointer || access.byNumber()) continue;
    const Instruction* move = badMove(facts, access);
    if (move == nullptr) continue;
    report(move->operands[0].span, move->operands[0].value)
        .related.push_back({box.span, fmt::format("{} takes its preset from there", Facts::text(box))});
  }
}

void checkTim007(const Facts& facts, FindingSink& sink) {
  for (const InstructionPlace& place :
       facts.placesOf([](const Desc& desc) { return isTimerBox(desc.role) || isCounterBox(desc.role); })) {
    const Role role = roleOf(*place.instruction);
    if ((isTimerBox(role) || isCounterBox(role)) && place.instruction->operands.size() >= 2)
      checkBox(facts, sink, *place.instruction);
  }
}

/// 001:6569, 001:4015: presets are signed words. At 0 and below a timer fires, and a counter is on, at once.
void askTim007(Asking& asking) {
  Graph& graph = asking.graph();
  std::map<const Instruction*, Node> outside;
  std::vector<const Instruction*> order;
  for (const Visit& visit : asking.record().visits()) {
    if (visit.preset == noNode) continue;
    Graph::Bool bad = graph.land({visit.guard}, graph.slt({visit.preset}, graph.literal(1, 16), 16));
    if (isBoxOf(*visit.instruction, Type::Timer)) bad = graph.land(bad, {visit.flow[0]});
    const auto [place, isNew] = outside.try_emplace(visit.instruction, bad.node);
    if (isNew)
      order.push_back(visit.instruction);
    else
      place->second = graph.lor({place->second}, bad).node;
  }
  for (const Instruction* box : order) {
    const std::string text = Facts::text(*box);
    asking.ask({.name = fmt::format("the preset of {} is in range", text),
                .message = fmt::format("{} can be 0 or negative when {} runs", toString(box->operands[1]), text),
                .address = toString(box->operands[0]),
                .place = box,
                .bad = outside[box]});
  }
}

}  // namespace

extern constexpr Rule tim007_preset_out_of_range = {
    .id = "TIM007",
    .title = "Preset out of range",
    .severity = Severity::Warning,
    .needs = Needs::FlowThenSolver,
    .detects = "a preset of a timer or counter, given or moved as a constant, that is not within 1 to 32767",
    .why = "the preset is a signed word; 0 or a negative value fires at once",
    .manual = "001:6569, 001:6535, 001:4015",
    .bad = "Network 1\nLD I0.0\nTON T37, +0\nNetwork 2\nLD T37\n= Q0.0\n",
    .good = "Network 1\nLD I0.0\nTON T37, +10\nNetwork 2\nLD T37\n= Q0.0\n",
    .peers = "SA0056 (constants only)",
    .dialects = dialect::S7200,
    .check = checkTim007,
    .ask = {.in = asked::Builtin, .turn = 50, .cost = 3, .program = askTim007},
};

}  // namespace rungproof
