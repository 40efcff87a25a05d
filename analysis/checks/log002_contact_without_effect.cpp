// LOG002: contact without effect. A contact that changes nothing in any reachable state. Only the prover can say.
// Tested by tests/prover/rule_questions_test.cpp, which runs the examples.
#include <fmt/format.h>

#include "analysis/asking/asking.hpp"
#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

/// Interlocks against other outputs are doubled on purpose, and contacts of special memory say how often code runs.
void askLog002(Asking& asking) {
  for (const auto& [contact, matters] : asking.record().contactEffects()) {
    const bool isInterlock = contact->desc->negated && contact->operands[0].area == Area::Q;
    if (isOfSpecialMemory(*contact) || isInterlock) continue;
    const std::string text = Facts::text(*contact);
    asking.ask({.name = fmt::format("{} makes a difference", text),
                .message = fmt::format("without {} the network does the same in every reachable state", text),
                .address = contact->operands.empty() ? "" : toString(contact->operands[0]),
                .place = contact,
                .bad = matters});
  }
}

/// Contacts of a rung that is constant anyway or never runs; all but the last of contacts that stand for each other.
constexpr Explanation log002Explained[] = {{"LOG001", Where::SameNetwork},
                                           {"CTL003", Where::SameNetwork},
                                           {"CTL005", Where::SameNetwork},
                                           {"LOG002", Where::LaterInNetwork}};

}  // namespace

extern constexpr Rule log002_contact_without_effect = {
    .id = "LOG002",
    .title = "Contact without effect",
    .severity = Severity::Note,
    .needs = Needs::Solver,
    .detects =
        "a contact without which - bridged in a series, cut out of a parallel circuit - the network does the same in "
        "every reachable state; contacts of special memory and normally closed contacts of outputs, which are doubled "
        "on purpose, are excepted",
    .why = "leftovers of copying, or a contact at the wrong place: what it was to prevent is not prevented by it",
    .bad = "Network 1\nLD I0.0\nA I0.1\nA I0.0\n= Q0.0\n",
    .good = "Network 1\nLD I0.0\nA I0.1\nA I0.2\n= Q0.0\n",
    .falsePositives = "an interlock that other networks happen to guarantee, and that is kept in case they change",
    .peers = "Rockwell \"shorted branch\"",
    .dialects = dialect::S7200,
    .ask = {.in = asked::Lint, .turn = 71, .cost = 5, .wantsYes = true, .program = askLog002},
    .tell = {.advice = "remove it, or put it where it is needed"},
    .explainedBy = log002Explained,
};

}  // namespace rungproof
