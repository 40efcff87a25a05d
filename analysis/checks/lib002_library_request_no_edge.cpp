// LIB002: requests of libraries whose first input is no pulse, and two that are started by the same signal. A level
// that the block ends itself is no finding where the block looks at the input only when it is idle. The prover settles
// what a coil prepares for the call. Tested by its examples and tests/rules/library_rules_test.cpp.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <vector>

#include "analysis/asking/asking.hpp"
#include "analysis/flow/facts.hpp"
#include "analysis/flow/library_use.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

constexpr std::size_t startOperand = 1;  ///< behind the name

bool hasStart(const LibraryCall& call) {
  return call.use->run == LibraryRun::Request && call.call->operands.size() > startOperand &&
         call.call->operands[startOperand].kind == OperandKind::Direct;
}

/// Bits that the call writes: Done among them.
Operands doneBits(const LibraryCall& call) {
  Operands bits;
  for (std::size_t i = startOperand + 1; i < call.call->operands.size(); ++i) {
    const Operand& o = call.call->operands[i];
    if (o.kind == OperandKind::Direct && (o.width == Width::Bit || o.width == Width::Byte)) bits.push_back(o);
  }
  return bits;
}

/// Whether a network that asks an output of the call writes the start bit, or leaves the step that starts it.
bool endsWithDone(const Facts& facts, const LibraryCall& call, const Operand& start) {
  if (start.area == Area::S) return true;
  const Operands done = doneBits(call);
  const std::uint32_t cell = facts.index().cells().cell(start.area, start.offset, facts.blockOf(call.call->id));
  if (cell == facts.index().cells().size()) return false;
  return std::ranges::any_of(facts.index().at(cell), [&](std::uint32_t i) {
    const Access& access = facts.access(i);
    if (!access.write || access.width != Width::Bit || access.bit != start.bit) return false;
    const InstructionPlace& place = facts.place(access.instruction);
    for (const Instruction& instruction : facts.networkOf(access.instruction).instructions) {
      for (const Operand& operand : instruction.operands) {
        const bool isAsked = isContact(roleOf(instruction)) && std::ranges::any_of(done, [&](const Operand& bit) {
                               return operand.kind == OperandKind::Direct && operand.area == bit.area &&
                                      operand.offset == bit.offset &&
                                      (bit.width == Width::Byte || operand.bit == bit.bit);
                             });
        if (isAsked && instruction.id <= place.instruction->id) return true;
      }
    }
    return false;
  });
}

void checkStart(const Facts& facts, FindingSink& sink, const CallInputs& inputs, const LibraryCall& call) {
  const Operand& start = call.call->operands[startOperand];
  const Condition known = inputs.bit(*call.call, start) | facts.conditionOf(call.call->id);
  if ((known & (condition::Pulse | condition::FirstScan | condition::Never)) != 0) return;
  const bool isAlways = (inputs.bit(*call.call, start) & condition::Always) != 0;
  if (!isAlways && !inputs.isLevel(*call.call, start)) return;
  const Instruction* coil = inputs.coilBefore(*call.call, start);
  if (!isAlways && call.use->mayBeHeld && (coil != nullptr || endsWithDone(facts, call, start))) return;
  Finding& finding =
      sink.report(call.call->span, fmt::format("{} is started by {}, which {}: it sends a request in each scan",
                                               call.name, inputs.source(*call.call, start),
                                               isAlways ? "is always on" : "may stay on for many scans"));
  finding.address = toString(start);
  finding.help = "put EU between the condition and the first input";
  if (isAlways) finding.confirmation = Confirmation::NotNeeded;
}

/// Requests of one unit that the same signal starts in the same scan.
void checkPairs(const Facts& facts, FindingSink& sink, const CallInputs& inputs,
                const std::vector<LibraryCall>& calls) {
  std::map<std::pair<std::string, std::string>, const LibraryCall*> first;
  for (const LibraryCall& call : calls) {
    if (!hasStart(call)) continue;
    const Operand& start = call.call->operands[startOperand];
    std::string unit(call.use->unit);
    for (const char c : call.name) {
      if (call.use->name.find('x') != std::string_view::npos && c >= '0' && c <= '9') unit += fmt::format(" {}", c);
    }
    const auto [found, isNew] = first.try_emplace({unit, inputs.source(*call.call, start)}, &call);
    if (isNew) continue;
    const Instruction& other = *found->second->call;
    const bool areBothEnabled = (inputs.enable(*call.call) & inputs.enable(other) & condition::Always) != 0;
    const bool mayBeLeftOut = facts.execution().at(call.call->id).isSkipped ||
                              facts.execution().at(other.id).isSkipped ||
                              facts.blockOf(call.call->id) != facts.blockOf(other.id);
    if (!areBothEnabled || mayBeLeftOut) continue;
    Finding& finding = sink.report(
        call.call->span, fmt::format("{} is started in the same scan as another request of {}: {} serves one at a time",
                                     call.name, found->second->name, call.use->unit));
    finding.address = toString(start);
    finding.related.push_back({other.span, "the other request"});
    finding.help = "start the second when Done of the first has come (error 6 of the Modbus master, 8 of USS)";
    finding.confirmation = Confirmation::NotNeeded;
  }
}

void checkLib002(const Facts& facts, FindingSink& sink) {
  if (facts.hasUnreadCode()) return;
  const std::vector<LibraryCall> calls = libraryCalls(facts);
  if (calls.empty()) return;
  const CallInputs inputs(facts);
  for (const LibraryCall& call : calls) {
    if (hasStart(call)) checkStart(facts, sink, inputs, call);
  }
  checkPairs(facts, sink, inputs, calls);
}

/// The only coil of a bit, or nullptr.
const Instruction* soleCoilOf(const Facts& facts, const Operand& bit) {
  const std::uint32_t cell = facts.index().cells().cell(bit.area, bit.offset, 0);
  if (bit.area == Area::L || cell == facts.index().cells().size() || bit.width != Width::Bit || bit.bit > 7 ||
      facts.writers(cell, bit.bit) != 1 || facts.index().isWrittenAtLarge(cell))
    return nullptr;
  const auto writers = facts.bits().at(cell * 8 + bit.bit);
  if (writers.size() != 1) return nullptr;
  const Instruction& writer = facts.instruction(facts.access(writers.front()).instruction);
  return isCoil(roleOf(writer)) ? &writer : nullptr;
}

/// A coil that makes the first input of a request and is on in two scans in a row.
void askLib002(Asking& asking) {
  const Facts facts(asking.program());
  const CallInputs inputs(facts);
  for (const LibraryCall& call : libraryCalls(facts)) {
    if (!hasStart(call) || call.use->mayBeHeld) continue;
    const Operand& start = call.call->operands[startOperand];
    const Instruction* prepared = inputs.coilBefore(*call.call, start);
    const Instruction* coil = prepared != nullptr ? prepared : soleCoilOf(facts, start);
    const Asking::Runs* runs = coil == nullptr ? nullptr : asking.runsOf(*coil);
    if (runs == nullptr || !runs->samples(0)) continue;
    const Graph::Bool now = runs->on[0];
    const Graph::Bool last{
        asking.askedProperties().before(fmt::format("start of {} at {}", call.name, call.call->id), now.node)};
    asking.ask({.name = fmt::format("{} is started in two scans in a row", call.name),
                .message = fmt::format("{} can be started in two scans in a row by {}", call.name,
                                       inputs.source(*call.call, start)),
                .place = call.call,
                .bad = asking.graph().land(now, last).node});
  }
}

}  // namespace

extern constexpr Rule lib002_library_request_no_edge = {
    .id = "LIB002",
    .title = "Library request without an edge, or two at once",
    .severity = Severity::Warning,
    .needs = Needs::FlowThenSolver,
    .detects =
        "MBUS_MSG, USS_RPM, USS_WPM and the requests of PTO, POS, AXIS and MOD blocks whose first input stays on for "
        "more than one scan; two requests of one unit that the same signal starts",
    .why = "a request is sent in every scan in which the input is on, and a second one ends with an error or is lost",
    .manual = "001:8231-8233, 001:8678-8680, 001:9703, 001:10069, 001:10252",
    .bad = "Network 1\nLD SM0.0\nCALL USS_RPM_W, I0.0, 0, 3, 0, &VB100, M0.1, VB10, VW12\n",
    .good =
        "Network 1\nLD I0.0\nEU\n= M0.0\nNetwork 2\nLD SM0.0\nCALL USS_RPM_W, M0.0, 0, 3, 0, &VB100, M0.1, VB10, "
        "VW12\n",
    .falsePositives = "a bit that another network takes back in the next scan: the prover drops it",
    .dialects = dialect::S7200,
    .check = checkLib002,
    .ask = {.in = asked::Lint, .turn = 64, .cost = 4, .onlySettles = true, .program = askLib002},
};

}  // namespace rungproof
