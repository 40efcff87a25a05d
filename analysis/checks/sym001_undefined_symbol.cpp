// SYM001: a symbolic operand that no table resolves. Tested by its examples and tests/rules/address_rules_test.cpp.
#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

/// Whether a row that could not be read names it: that row has its own finding.
bool standsInUnreadRow(const Program& program, std::string_view name) {
  return std::ranges::any_of(program.findings, [&](const Finding& finding) {
    if (finding.rule != "SYN029") return false;  // frontend/stl/syntax_message.hpp
    const std::string_view text = program.sources->file(finding.span.file).text();
    return text.substr(finding.span.offset, finding.span.length).find(name) != std::string_view::npos;
  });
}

void checkSym001(const Facts& facts, FindingSink& sink) {
  std::unordered_map<std::string_view, std::size_t> places;  // name to the number of its uses
  std::vector<const Operand*> first;
  for (const std::uint32_t id : facts.withOperand(OperandKind::Symbol)) {
    const Instruction& instruction = facts.instruction(id);
    const bool isCall = instruction.desc->control == Control::Call;
    for (const Operand& operand : instruction.operands) {
      const bool isCallee = isCall && &operand == &instruction.operands[0];
      const CallContract* contract = isCallee ? facts.contracts().of(instruction) : nullptr;
      if (contract != nullptr && !contract->isUndefined) continue;  // SUB008 speaks where the manual does not know it
      if (operand.kind == OperandKind::Symbol && ++places[operand.text] == 1) first.push_back(&operand);
    }
  }
  const bool hasTable = !facts.program().symbols.empty();
  for (const Operand* operand : first) {
    if (standsInUnreadRow(facts.program(), operand->text)) continue;
    const std::size_t count = places[operand->text];
    const std::string more = count == 1 ? std::string() : fmt::format(" (used {} times)", count);
    Finding& finding = sink.report(
        operand->span,
        fmt::format("{} is not defined: no symbol, local variable or block has that name{}", operand->text, more));
    finding.address = operand->text;
    finding.help = hasTable ? "correct the name, or add it to the symbol table"
                            : "give the symbol table of the project with --symbols FILE";
  }
}

}  // namespace

extern constexpr Rule sym001_undefined_symbol = {
    .id = "SYM001",
    .title = "Undefined symbol",
    .severity = Severity::Error,
    .needs = Needs::Text,
    .detects = "a symbolic operand without an entry in the global or local table",
    .why = "the download needs an address; without one nothing can be said about the instruction",
    .bad = "Network 1\nLD StartButton\n= Q0.0\n",
    .good = "Network 1\nLD I0.0\n= Q0.0\n",
    .falsePositives = "the symbol table was not given: name it with --symbols",
    .peers = "ironplc P4007; plceye S0002",
    .dialects = dialect::S7200,
    .refuses = true,
    .check = checkSym001,
};

}  // namespace rungproof
