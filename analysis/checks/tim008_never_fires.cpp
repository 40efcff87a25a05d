// TIM008: timer or counter can never fire, or never returns. Only the prover can say. Tested by
// tests/prover/builtin_test.cpp and tests/prover/rule_questions_test.cpp, which runs the examples.
#include <fmt/format.h>

#include "analysis/asking/asking.hpp"
#include "analysis/rule.hpp"
#include "ir/s7200/isa.hpp"

namespace rungproof {

namespace {

void askTim008(Asking& asking, const Instruction& box) {
  Graph& graph = asking.graph();
  EncodedScan& encoding = asking.encoding();
  const Operand& o = box.operands[0];
  const Place bit = registerPlace(isBoxOf(box, Type::Timer) ? Reg::TimerBit : Reg::CounterBit, o.offset);
  const Node now = encoding.atEnd(bit);
  // A bit that is reset in the scan in which it comes on is on for the instructions between.
  const Node seen = asking.record().seenOn(o.area, o.offset);
  const Graph::Bool within{seen == noNode ? graph.constant(false).node : seen};
  const Node on = graph.lor({now}, within).node;
  const Graph::Bool before = graph.lor({encoding.atStart(bit)}, within);
  const std::string name = toString(o);
  asking.ask({.name = fmt::format("{} can come on", name),
              .message = fmt::format("the bit of {} can never be 1", name),
              .address = name,
              .place = &box,
              .bad = on});
  asking.ask({.name = fmt::format("{} can be reset", name),
              .message = fmt::format("once on, the bit of {} never returns to 0", name),
              .address = name,
              .place = &box,
              .bad = graph.land(before, graph.lnot({now})).node});
}

}  // namespace

extern constexpr Rule tim008_never_fires = {
    .id = "TIM008",
    .title = "Timer or counter can never fire",
    .severity = Severity::Warning,
    .needs = Needs::Solver,
    .detects = "a timer or counter whose bit can never become 1, or once 1 never returns to 0",
    .why = "a dead alarm or a dead step looks like a live one in the listing",
    .manual = "001:6569, 002:2865-2878",
    .bad = "Network 1\nLD I0.0\nEU\nTON T37, +10\nNetwork 2\nLD T37\n= Q0.0\n",
    .good = "Network 1\nLD I0.0\nTON T37, +10\nNetwork 2\nLD T37\n= Q0.0\n",
    .falsePositives = "a timer that is only used through its current value",
    .ask = {.in = asked::Builtin, .turn = 40, .cost = 3, .wantsYes = true, .box = askTim008},
    .tell = {.advice = "look at the input and the preset"},
};

}  // namespace rungproof
