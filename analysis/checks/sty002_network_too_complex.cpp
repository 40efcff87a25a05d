// STY002: a network with many contacts, levels or branches. Off by default; the limits are options.
// Tested by its examples and tests/rules/data_rules_test.cpp.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

constexpr std::array options = {
    RuleOption{"contacts", 1, 1000, 24, "most contacts and comparisons in one network"},
    RuleOption{"levels", 1, 9, 5, "most stack levels in use at one time"},
    RuleOption{"branches", 1, 1000, 8, "most LPS, LRD and LPP in one network"},
};

void checkSty002(const Facts& facts, FindingSink& sink) {
  const int mostContacts = sink.option("contacts"), mostLevels = sink.option("levels"),
            mostBranches = sink.option("branches");
  for (const Pou& pou : facts.program().pous) {
    for (const Network& network : pou.networks) {
      int contacts = 0, levels = 0, branches = 0;
      for (const Instruction& instruction : network.instructions) {
        const Role role = roleOf(instruction);
        if (role == Role::Load || role == Role::And || role == Role::Or) ++contacts;
        if (role == Role::Lps || role == Role::Lrd || role == Role::Lpp) ++branches;
        const bool pushes = role == Role::Load || role == Role::Lps || role == Role::Lds;
        levels = std::max(levels, facts.stack().at(instruction.id).levels + (pushes ? 1 : 0));
      }
      std::string text;
      const auto note = [&](int value, int limit, std::string_view what) {
        if (value > limit) text += fmt::format("{}{} {} (limit {})", text.empty() ? "" : ", ", value, what, limit);
      };
      note(contacts, mostContacts, "contacts");
      note(levels, mostLevels, "stack levels");
      note(branches, mostBranches, "branch instructions");
      if (text.empty()) continue;
      sink.report(network.instructions.front().span,
                  fmt::format("network {} of {} has {}", network.number, pou.name, text))
          .help = "split it, and keep intermediate results in M bits";
    }
  }
}

}  // namespace

extern constexpr Rule sty002_network_too_complex = {
    .id = "STY002",
    .title = "Network too complex",
    .severity = Severity::Note,
    .needs = Needs::Text,
    .detects = "a network with more contacts, stack levels or branches than the options allow",
    .why = "hard to review, and near the limit of nine levels",
    .manual = "001:2759",
    .bad = "Network 1\nLD I0.0\nLD I0.1\nLD I0.2\nLD I0.3\nLD I0.4\nLD I0.5\nALD\nOLD\nALD\nOLD\nALD\n= Q0.0\n",
    .good = "Network 1\nLD I0.0\nA I0.1\nLD I0.2\nA I0.3\nOLD\n= Q0.0\n",
    .peers = "L3; L6; CP9; SA0178; SA0150",
    .dialects = dialect::S7200,
    .ofLists = true,
    .enabledByDefault = false,
    .standsAlone = true,
    .options = options,
    .check = checkSty002,
};

}  // namespace rungproof
