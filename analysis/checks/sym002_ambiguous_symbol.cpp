// SYM002: two symbols for one address, one name twice, a local name that hides a global one.
// Tested by tests/rules/address_rules_test.cpp.
#include <fmt/format.h>

#include <unordered_map>

#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

void checkTable(const Facts& facts, FindingSink& sink) {
  std::unordered_map<std::string, const Symbol*> byAddress;
  for (const Symbol& symbol : facts.program().symbols) {
    const Symbol* named = facts.symbolNamed(symbol.name);
    if (named != nullptr && named != &symbol) {
      Finding& finding = sink.report(symbol.span, fmt::format("symbol {} is defined twice", symbol.name));
      finding.related.push_back({named->span, fmt::format("first defined here as {}", toString(named->address))});
      finding.help = "give each signal its own name (001:2410-2416)";
      finding.address = toString(symbol.address);
      continue;
    }
    if (symbol.address.kind != OperandKind::Direct) continue;
    const auto [place, isNew] = byAddress.emplace(toString(symbol.address), &symbol);
    if (isNew) continue;
    Finding& finding = sink.report(symbol.span, fmt::format("{} has two names, {} and {}", toString(symbol.address),
                                                            place->second->name, symbol.name));
    finding.related.push_back({place->second->span, fmt::format("{} stands here", place->second->name)});
    finding.help = "keep one of the names";
    finding.address = toString(symbol.address);
  }
}

void checkLocals(const Facts& facts, FindingSink& sink) {
  for (const Pou& pou : facts.program().pous) {
    std::unordered_map<std::string_view, const LocalVariable*> names;
    for (const LocalVariable& local : pou.locals) {
      const auto [place, isNew] = names.emplace(local.name, &local);
      if (!isNew) {
        Finding& finding =
            sink.report(local.span, fmt::format("local variable {} of {} is declared twice", local.name, pou.name));
        finding.related.push_back({place->second->span, "first declared here"});
        finding.help = "rename one of them";
        continue;
      }
      const Symbol* global = facts.dialect().text.quotesSymbols ? nullptr : facts.symbolNamed(local.name);
      if (global == nullptr) continue;
      Finding& finding =
          sink.report(local.span, fmt::format("local variable {} of {} hides the symbol of the same name ({})",
                                              local.name, pou.name, toString(global->address)));
      finding.related.push_back({global->span, "the symbol stands here"});
      finding.help = "which of the two a name without # means is not stated; rename one of them (001:2226)";
    }
  }
}

void checkSym002(const Facts& facts, FindingSink& sink) {
  checkTable(facts, sink);
  checkLocals(facts, sink);
}

}  // namespace

extern constexpr Rule sym002_ambiguous_symbol = {
    .id = "SYM002",
    .title = "Two symbols, one address; or one symbol twice",
    .severity = Severity::Warning,
    .needs = Needs::Text,
    .detects = "a name defined twice, a local name hiding a global one, two names for the same address",
    .why = "two people think of it as two signals; the cross reference shows one",
    .manual = "001:7828-7843, 001:2410-2416",
    .bad =
        "SUBROUTINE_BLOCK Ramp:SBR0\nVAR_INPUT\nLevel:WORD;\nLevel:WORD;\nEND_VAR\nBEGIN\nNetwork 1\nLD SM0.0\nMOVW "
        "LW0, VW0\nEND_SUBROUTINE_BLOCK\n",
    .good =
        "SUBROUTINE_BLOCK Ramp:SBR0\nVAR_INPUT\nLevel:WORD;\nSpeed:WORD;\nEND_VAR\nBEGIN\nNetwork 1\nLD SM0.0\nMOVW "
        "LW0, VW0\nEND_SUBROUTINE_BLOCK\n",
    .falsePositives = "a second name on purpose, such as one for the hardware point and one for its meaning",
    .peers = "SA0013; SA0027; N5; N9; CP4",
    .standsAlone = true,
    .check = checkSym002,
};

}  // namespace rungproof
