// IEC009: a local variable that hides a global one, a function or a block. Tested by its examples and
// tests/rules/iec_rules_test.cpp.
#include <fmt/format.h>

#include <map>

#include "analysis/flow/facts.hpp"
#include "analysis/flow/variable_uses.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

void checkIec009(const Facts& facts, FindingSink& sink) {
  const iec::VariableUses& uses = facts.variableUses();
  std::map<std::string, const iec::VariableSyntax*> globals;
  for (const iec::VariableSyntax& global : uses.project().globals)
    globals.emplace(iec::foldedName(global.name), &global);
  std::map<std::string, const iec::BlockSyntax*> blocks;
  for (const iec::BlockSyntax& block : uses.project().blocks) {
    if (!block.isLibrary) blocks.emplace(iec::foldedName(block.name), &block);
  }
  iec::eachOwnBlock(uses.project(), [&](const iec::BlockSyntax& block) {
    for (const iec::VariableSyntax& variable : block.variables) {
      if (variable.section == iec::Section::External) continue;
      const auto global = globals.find(iec::foldedName(variable.name));
      const auto other = blocks.find(iec::foldedName(variable.name));
      if (global == globals.end() && other == blocks.end()) continue;
      const bool isVariable = global != globals.end();
      Finding& finding = sink.report(variable.span, fmt::format("{} of {} hides the {} of that name", variable.name,
                                                                block.name, isVariable ? "global variable" : "block"));
      finding.address = variable.name;
      finding.related.push_back({isVariable ? global->second->span : other->second->span, "it is declared here"});
      finding.help = isVariable ? "declare it VAR_EXTERNAL if the global one is meant, or rename it" : "rename it";
    }
  });
}

}  // namespace

extern constexpr Rule iec009_name_hidden = {
    .id = "IEC009",
    .title = "Name hides another",
    .severity = Severity::Warning,
    .needs = Needs::Text,
    .detects = "a variable of a block with the name of a global variable, or of a function or a block of the project",
    .why = "the block works on its own variable where a reader takes it for the global one",
    .bad =
        "CONFIGURATION c\nVAR_GLOBAL Fault : BOOL; END_VAR\nRESOURCE r ON p\nTASK t(INTERVAL := T#10ms, PRIORITY := "
        "1);\nPROGRAM m WITH t : Main;\nEND_RESOURCE\nEND_CONFIGURATION\nPROGRAM Main\nVAR_INPUT a : BOOL; "
        "END_VAR\nVAR Fault : BOOL; END_VAR\nVAR_OUTPUT Lamp : BOOL; END_VAR\nFault := a;\nLamp := "
        "Fault;\nEND_PROGRAM\n",
    .good =
        "CONFIGURATION c\nVAR_GLOBAL Fault : BOOL; END_VAR\nRESOURCE r ON p\nTASK t(INTERVAL := T#10ms, PRIORITY := "
        "1);\nPROGRAM m WITH t : Main;\nEND_RESOURCE\nEND_CONFIGURATION\nPROGRAM Main\nVAR_INPUT a : BOOL; "
        "END_VAR\nVAR_EXTERNAL Fault : BOOL; END_VAR\nVAR_OUTPUT Lamp : BOOL; END_VAR\nFault := a;\nLamp := "
        "Fault;\nEND_PROGRAM\n",
    .exampleCpu = "IEC-4K",
    .peers = "SA0013; SA0027",
    .dialects = dialect::Iec,
    .check = checkIec009,
};

}  // namespace rungproof
