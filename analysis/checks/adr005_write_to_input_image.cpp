// ADR005: the program writes the image of the inputs. Tested by its examples and tests/rules/address_rules_test.cpp.
#include <fmt/format.h>

#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

void checkAdr005(const Facts& facts, FindingSink& sink) {
  for (const Access& access : facts.accesses().all()) {
    if (!access.write || access.maybe || access.viaPointer || access.area != Area::I ||
        access.operand == impliedOperand)
      continue;
    const Instruction& instruction = facts.instruction(access.instruction);
    const Operand& operand = instruction.operands[access.operand];
    Finding& finding = sink.report(
        operand.span, access.count > 1
                          ? fmt::format("{} writes the inputs {}; the next scan reads them from the terminals again",
                                        Facts::text(instruction), accessRange(access))
                          : fmt::format("{} writes the input {}; the next scan reads it from the terminals again",
                                        Facts::text(instruction), facts.name(operand)));
    finding.address = toString(operand);
    finding.help = "write to M or V memory and read that instead";
  }
}

}  // namespace

extern constexpr Rule adr005_write_to_input_image = {
    .id = "ADR005",
    .title = "Program writes the input image",
    .severity = Severity::Warning,
    .needs = Needs::Text,
    .detects = "a coil, S, R, move or other instruction with an I operand as its target",
    .why =
        "the image of the inputs is refreshed from the terminals at the start of every scan, so the value lives for "
        "one scan at most",
    .manual = "001:1283, 001:1220-1228",
    .bad = "Network 1\nLD M0.0\n= I0.5\n",
    .good = "Network 1\nLD M0.0\n= M0.5\n",
    .falsePositives = "an input forced by program for a test, to last to the end of the scan only",
    .peers = "SA0037",
    .dialects = dialect::S7200,
    .check = checkAdr005,
};

}  // namespace rungproof
