// IEC020: a loop that nothing in its body can end. Tested by its examples and tests/rules/iec_rules_test.cpp.
#include <fmt/format.h>

#include <map>
#include <optional>
#include <set>

#include "analysis/flow/facts.hpp"
#include "analysis/flow/variable_uses.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

/// Names that a body writes or hands to calls, and whether something leaves it.
struct LoopBody {
  std::set<std::string> changed;
  bool isLeft = false;
  bool callsAnything = false;
};

std::string loopNameOf(const iec::Expr& path) {
  const bool isName = path.kind == iec::ExprKind::Path && !path.parts.empty();
  return isName ? iec::foldedName(path.parts[0].name) : std::string();
}

/// EXIT of an inner loop leaves that one only.
void readLoopBody(const iec::Statements& list, bool isInner, LoopBody& body) {
  for (const iec::Statement& one : list) {
    using enum iec::StatementKind;
    const bool isLoop = one.kind == For || one.kind == While || one.kind == Repeat;
    body.isLeft =
        body.isLeft || one.kind == Return || one.kind == Jump || one.kind == Unread || (one.kind == Exit && !isInner);
    if ((one.kind == Assign || one.kind == For) && one.target != nullptr) body.changed.insert(loopNameOf(*one.target));
    iec::eachExpression(one, [&](const iec::Expr& expr) {
      if (expr.kind != iec::ExprKind::Call) return;
      body.callsAnything = true;
      if (!expr.parts.empty()) body.changed.insert(iec::foldedName(expr.parts[0].name));
      for (const iec::Argument& argument : expr.arguments) {
        if (argument.value != nullptr) body.changed.insert(loopNameOf(*argument.value));
      }
    });
    for (const iec::Branch& branch : one.branches) readLoopBody(branch.body, isInner || isLoop, body);
    readLoopBody(one.otherwise, isInner || isLoop, body);
  }
}

/// Whether the condition can have another value behind the body; `asked` gets the name that it reads first.
bool conditionMayChange(const iec::VariableUses& uses, const iec::BlockSyntax& block, const iec::Expr& condition,
                        const LoopBody& body, std::string& asked) {
  bool may = false;
  iec::eachPart(condition, [&](const iec::Expr& part) {
    may = may || part.kind == iec::ExprKind::Call;
    if (part.kind != iec::ExprKind::Path) return;
    const std::string name = loopNameOf(part);
    if (asked.empty()) asked = part.parts.empty() ? "" : part.parts[0].name;
    // What others know of, a call may write.
    const iec::DeclaredVariable* row = uses.find(block, name);
    const bool isShared = row == nullptr || row->block == nullptr || row->variable->section == iec::Section::InOut ||
                          !row->variable->address.empty();
    may = may || body.changed.contains(name) || (isShared && body.callsAnything);
  });
  return may;
}

/// TRUE or FALSE as it is written; nothing: another expression.
std::optional<bool> conditionTruthOf(const iec::Expr& expr) {
  if (expr.kind != iec::ExprKind::Literal) return std::nullopt;
  const std::string text = iec::foldedName(expr.text);
  return text == "TRUE" || text == "1"    ? std::optional(true)
         : text == "FALSE" || text == "0" ? std::optional(false)
                                          : std::nullopt;
}

struct CounterEnds {
  std::int64_t least, greatest;
};

/// Why a FOR does not end: its counter wraps before it gets past the limit. Empty: it ends, or that is not known.
std::string reasonOfFor(const iec::VariableUses& uses, const iec::BlockSyntax& block, const iec::Statement& loop) {
  static const std::map<std::string, CounterEnds> ends = {
      {"SINT", {-128, 127}},     {"USINT", {0, 255}},  {"BYTE", {0, 255}},
      {"INT", {-32768, 32767}},  {"UINT", {0, 65535}}, {"DINT", {-2147483648LL, 2147483647}},
      {"UDINT", {0, 4294967295}}};
  const auto step = loop.by == nullptr ? std::optional<std::int64_t>(1) : iec::plainNumber(*loop.by);
  if (step == 0) return "its step is 0";
  const auto counter = ends.find(uses.elementaryTypeOf(block, *loop.target));
  const auto last = loop.last == nullptr ? std::nullopt : iec::plainNumber(*loop.last);
  if (!step || !last || counter == ends.end()) return {};
  const auto [least, greatest] = counter->second;
  const std::string& name = loop.target->parts[0].name;
  if (*step > 0 && *last >= greatest) return fmt::format("{} never gets above {}", name, greatest);
  if (*step < 0 && *last <= least) return fmt::format("{} never gets below {}", name, least);
  return {};
}

void checkIec020(const Facts& facts, FindingSink& sink) {
  const iec::VariableUses& uses = facts.variableUses();
  iec::eachOwnStatement(uses.project(), [&](const iec::BlockSyntax& block, const iec::Statement& loop,
                                            const iec::Statements&, std::size_t) {
    using enum iec::StatementKind;
    if (loop.kind != For && loop.kind != While && loop.kind != Repeat) return;
    LoopBody body;
    readLoopBody(loop.otherwise, false, body);
    if (body.isLeft) return;
    std::string reason;
    if (loop.kind == For) {
      if (loop.target == nullptr || body.changed.contains(loopNameOf(*loop.target))) return;
      reason = reasonOfFor(uses, block, loop);
    } else if (loop.value != nullptr) {
      const auto truth = conditionTruthOf(*loop.value);
      std::string asked;
      if (truth ? *truth == (loop.kind == Repeat) : conditionMayChange(uses, block, *loop.value, body, asked)) return;
      reason = truth ? "its condition never changes" : fmt::format("nothing in it changes {}", asked);
    }
    if (reason.empty()) return;
    const Span place = loop.kind == For ? loop.target->span : loop.value->span;
    Finding& finding = sink.report(place, fmt::format("once the loop goes on, it does not end: {}", reason));
    finding.help = loop.kind == For ? "choose a counter of a larger type, or another limit"
                                    : "change what the condition reads, or leave the loop with EXIT";
  });
}

}  // namespace

extern constexpr Rule iec020_loop_may_not_end = {
    .id = "IEC020",
    .title = "Loop that does not end",
    .severity = Severity::Warning,
    .needs = Needs::Flow,
    .detects =
        "a WHILE or REPEAT without EXIT and RETURN whose condition reads nothing that its body writes; a FOR whose "
        "step "
        "is 0, or whose limit is the last number that its counter has",
    .why =
        "no input changes within a scan and no time passes: the scan does not end, and the watchdog stops the "
        "controller",
    .bad =
        "PROGRAM Main\nVAR_INPUT Ready : BOOL; END_VAR\nVAR_OUTPUT n : INT; END_VAR\nWHILE NOT Ready DO\n  n := n + "
        "1;\nEND_WHILE;\nEND_PROGRAM\n",
    .good =
        "PROGRAM Main\nVAR_INPUT Ready : BOOL; END_VAR\nVAR_OUTPUT n : INT; END_VAR\nIF NOT Ready THEN\n  n := n + "
        "1;\nEND_IF;\nEND_PROGRAM\n",
    .exampleCpu = "IEC-4K",
    .dialects = dialect::Iec,
    .check = checkIec020,
};

}  // namespace rungproof
