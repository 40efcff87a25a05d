// The campaign: every mutant of every instruction is tried against the manual's tests (test_manual_a, test_manual_b).
// It fails when an instruction is reached by no test, has fewer than 3 mutants or none that is noticed, when fewer than
// 95 % of all mutants are noticed, or when the survivors are not exactly those of survivors.tsv, each with its reason.
// "test_mutation +I" tries one mnemonic and prints each of its mutants.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "ir/isa.hpp"
#include "tests/mutation/trial.hpp"

namespace rungproof::mutation {
namespace {

/// Changes that make sense at a site.
bool applies(const Site& site, int change) {
  const Desc& desc = instructionTable()[site.opcode];
  const std::string& file = Mutation::instance().fileName(site);
  const bool shared = file == "machine.hpp" || file == "args.hpp";
  switch (site.op) {
    case Op::Whole: return change == 1 || desc.execution == Execution::Stack || desc.execution == Execution::Compare;
    case Op::Text:
      return change == 1 || desc.control == Control::LabelMark || desc.control == Control::Return || desc.control == Control::MainEnd ||
             desc.control == Control::InterruptReturn || desc.control == Control::Next;
    // The frame of every instruction joins conditions that are all true where plain numbers run at all.
    case Op::And: return change == 1 || !shared || Mutation::instance().isPowerFlow(site);
    case Op::Or: return change == 1 || !shared;
    default: return true;
  }
}

/// Names of the sites, free of line numbers: "+I integer.hpp add 2" is the second "add" that +I reaches in that file.
std::map<Site, std::string> nameSites() {
  std::map<Site, std::string> names;
  std::map<std::string, int> counts;
  for (const auto& [site, tests] : Mutation::instance().sites()) {
    const std::string_view mnemonic = instructionTable()[site.opcode].stl;
    if (site.op == Op::Whole || site.op == Op::Text) {
      names[site] = fmt::format("{}\t{}", mnemonic, opName(site.op));
      continue;
    }
    const std::string name = fmt::format("{}\t{} {}", mnemonic, Mutation::instance().fileName(site), opName(site.op));
    names[site] = fmt::format("{} {}", name, ++counts[name]);
  }
  return names;
}

struct Tally {
  int mutants = 0;
  int noticed = 0;
};

struct Campaign {
  std::vector<Tally> byOpcode = std::vector<Tally>(instructionTable().size());
  std::set<std::string> survivors;
};

Campaign run(const std::vector<std::string>& tests, std::string_view only) {
  Campaign campaign;
  const auto names = nameSites();
  for (const auto& [site, reachedBy] : Mutation::instance().sites()) {
    if (!only.empty() && instructionTable()[site.opcode].stl != only) continue;
    for (int change = 1; change <= static_cast<int>(changesOf(site.op).size()); ++change) {
      if (!applies(site, change)) continue;
      const bool noticed = isNoticed({site, static_cast<std::uint8_t>(change)}, reachedBy, tests);
      Tally& tally = campaign.byOpcode[site.opcode];
      ++tally.mutants;
      tally.noticed += noticed ? 1 : 0;
      const std::string name = fmt::format("{}\t{}", names.at(site), changesOf(site.op)[static_cast<std::size_t>(change - 1)]);
      if (!noticed) campaign.survivors.insert(name);
      if (!only.empty()) fmt::print("{}\t{}:{} {}\n", name, site.line, site.column, noticed ? "noticed" : "SURVIVES");
    }
  }
  return campaign;
}

/// Mnemonic, site, change and reason, separated by tabs; "*" as mnemonic stands for all.
struct KnownSurvivor {
  std::string mnemonic, siteAndChange;
  bool met = false;
};
std::vector<KnownSurvivor> knownSurvivors(int& problems) {
  std::vector<KnownSurvivor> list;
  std::ifstream file(RUNGPROOF_SOURCE_DIR "/tests/mutation/survivors.tsv");
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#') continue;
    const std::size_t site = line.find('\t'), change = line.find('\t', site + 1), reason = line.find('\t', change + 1);
    if (site == std::string::npos || change == std::string::npos || reason == std::string::npos || reason + 1 == line.size()) {
      fmt::print("survivors.tsv: a row without mnemonic, site, change or reason: {}\n", line);
      ++problems;
      continue;
    }
    list.push_back({line.substr(0, site), line.substr(site + 1, reason - site - 1)});
  }
  return list;
}

int compareWithKnown(const Campaign& campaign) {
  int problems = 0;
  std::vector<KnownSurvivor> known = knownSurvivors(problems);
  for (const std::string& survivor : campaign.survivors) {
    const std::size_t tab = survivor.find('\t');
    const auto row = std::find_if(known.begin(), known.end(), [&](const KnownSurvivor& k) {
      return (k.mnemonic == "*" || k.mnemonic == survivor.substr(0, tab)) && k.siteAndChange == survivor.substr(tab + 1);
    });
    if (row != known.end()) {
      row->met = true;
      continue;
    }
    fmt::print("unnoticed: {}\n", survivor);
    ++problems;
  }
  for (const KnownSurvivor& row : known) {
    if (row.met) continue;
    fmt::print("survivors.tsv: noticed now, or no mutant any more: {}\t{}\n", row.mnemonic, row.siteAndChange);
    ++problems;
  }
  return problems;
}

int judge(const Campaign& campaign) {
  int problems = compareWithKnown(campaign);
  Tally all;
  for (std::size_t i = 0; i < campaign.byOpcode.size(); ++i) {
    const Tally& tally = campaign.byOpcode[i];
    all.mutants += tally.mutants;
    all.noticed += tally.noticed;
    if (tally.mutants >= 3 && tally.noticed > 0) continue;
    fmt::print("{}: {} mutants, {} noticed\n", instructionTable()[i].stl, tally.mutants, tally.noticed);
    ++problems;
  }
  fmt::print("{} instructions, {} mutants, {} noticed ({:.2f} %)\n", campaign.byOpcode.size(), all.mutants, all.noticed,
             100.0 * all.noticed / std::max(all.mutants, 1));
  if (all.noticed * 100 < all.mutants * 95) ++problems;
  return problems;
}

}  // namespace
}  // namespace rungproof::mutation

int main(int argc, char** argv) {
  using namespace rungproof::mutation;
  testing::InitGoogleTest(&argc, argv);
  const std::vector<std::string> tests = recordTests();
  if (tests.empty()) return 1;
  const std::string_view only = argc > 1 ? argv[1] : "";
  const Campaign campaign = run(tests, only);
  return only.empty() && judge(campaign) != 0 ? 1 : 0;
}
