// The campaign: mutants of every instruction are tried against the manual's tests (tests/manual)
// and the naive interpreter (tests/reference). It fails when an instruction is reached by no test, has fewer than 3
// mutants or none that is noticed, when fewer than 95 % of all mutants are noticed, those that mean the same included,
// or when the survivors are not exactly those of survivors.tsv, each with its reason. "test_mutation +I" tries one
// mnemonic, or those that fit a pattern as of file names, and prints each mutant.
#include <fmt/format.h>
#include <fnmatch.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>

#include "ir/s7200/cpu.hpp"
#include "ir/s7200/isa.hpp"
#include "tests/mutation/trial.hpp"
#include "tests/reference/naive.hpp"

namespace rungproof::mutation {
namespace {

/// Changes that make sense at a site.
bool applies(const Site& site, int change) {
  const Desc& desc = s7200Instructions().all()[site.opcode];
  const std::string& file = Mutation::instance().fileName(site);
  const std::string_view function = Mutation::instance().functionName(site);
  const bool shared = isShared(file);
  // The frame keeps the books of guards: its conditions come from sites of their own, what it restores is for later
  // instructions.
  if (file == "guarded_run.hpp" && function == "when") return false;
  if (file == "flow_walk.hpp" && function == "walk") return false;
  const bool hasPlace = site.op != Op::Whole && site.op != Op::Text;
  if (hasPlace && file == "plant_run.hpp") return false;  // the tests' own surroundings
  switch (site.op) {
    case Op::Whole: return change == 1 || desc.execution == Execution::Stack || desc.execution == Execution::Compare;
    case Op::Text:
      return change == 1 || desc.control == Control::LabelMark || desc.control == Control::Return ||
             desc.control == Control::MainEnd || desc.control == Control::InterruptReturn ||
             desc.control == Control::Next;
    // The frame of every instruction joins conditions that are all true where plain numbers run at all.
    case Op::And: return change == 1 || !shared || function == "powerFlow";
    case Op::Or: return change == 1 || !shared;
    default: return true;
  }
}

/// Names of the sites, free of line numbers: "integer.hpp run add 2" is the second "add" that the mnemonic reaches in
/// that function.
std::map<Site, std::string> nameSites() {
  std::map<Site, std::string> names;
  std::map<std::pair<std::uint16_t, std::string>, int> counts;
  for (const auto& [site, tests] : Mutation::instance().sites()) {
    if (site.op == Op::Whole || site.op == Op::Text) {
      names[site] = opName(site.op);
      continue;
    }
    const Mutation& mutation = Mutation::instance();
    const std::string name =
        fmt::format("{} {} {}", mutation.fileName(site), mutation.functionName(site), opName(site.op));
    names[site] = fmt::format("{} {}", name, ++counts[{site.opcode, name}]);
  }
  return names;
}

/// Of the S7-200 SMART alone, those that the naive interpreter does not know: devices, and what is any value. They are
/// asked in tests/smart.
bool isLeftOut(std::size_t opcode) {
  const Desc& desc = s7200Instructions().all()[opcode];
  return (desc.cpus & s7200Cpus) == 0 && !naive::signatureOf(std::string(desc.stl));
}

struct Tally {
  int mutants = 0;
  int noticed = 0;
};

struct Survivor {
  std::string mnemonic, site, change;
};

struct Campaign {
  std::vector<Tally> byOpcode = std::vector<Tally>(s7200Instructions().all().size());
  std::vector<Survivor> survivors;
};

Campaign run(const std::vector<std::string>& tests, std::string_view only) {
  Campaign campaign;
  const auto names = nameSites();
  std::vector<Candidate> candidates;
  for (const auto& [site, reachedBy] : Mutation::instance().sites()) {
    const std::string mnemonic(s7200Instructions().all()[site.opcode].stl);
    if (isLeftOut(site.opcode)) continue;
    if (!only.empty() && fnmatch(std::string(only).c_str(), mnemonic.c_str(), 0) != 0) continue;
    for (int change = 1; change <= static_cast<int>(changesOf(site.op).size()); ++change) {
      if (applies(site, change)) candidates.push_back({{site, static_cast<std::uint8_t>(change)}, &reachedBy});
    }
  }
  const std::vector<Verdict> verdicts =
      only.empty() ? tryChosenMutants(candidates, tests) : tryMutants(candidates, tests);
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (verdicts[i] == Verdict::LeftOut) continue;
    const Mutant& mutant = candidates[i].mutant;
    const std::string mnemonic(s7200Instructions().all()[mutant.site.opcode].stl);
    const std::string changed(changesOf(mutant.site.op)[static_cast<std::size_t>(mutant.change - 1)]);
    Tally& tally = campaign.byOpcode[mutant.site.opcode];
    ++tally.mutants;
    tally.noticed += verdicts[i] == Verdict::Noticed ? 1 : 0;
    if (verdicts[i] != Verdict::Noticed) campaign.survivors.push_back({mnemonic, names.at(mutant.site), changed});
    if (!only.empty())
      fmt::print("{}\t{}\t{}\tline {}: {}\n", mnemonic, names.at(mutant.site), changed, mutant.site.line,
                 verdicts[i] == Verdict::Noticed     ? "noticed"
                 : verdicts[i] == Verdict::Unchecked ? "unchecked"
                                                     : "silent");
  }
  return campaign;
}

/// Without a change every test must pass in the same surroundings: else the campaign would count its own faults.
bool isSoundWithoutChange(const std::vector<std::string>& tests) {
  std::set<int> all;
  for (std::size_t i = 0; i < tests.size(); ++i) all.insert(static_cast<int>(i));
  const Mutant none{Mutation::instance().sites().begin()->first, 0};
  return tryMutants({{none, &all}}, tests).front() == Verdict::Silent;
}

/// A row of survivors.tsv: patterns of mnemonic, site and change, how many survivors they are, and why. "same": the
/// changed meaning is the same meaning; "open": it is another, and no test tells them apart.
struct KnownSurvivors {
  bool isSame = false;
  std::string mnemonic, site, change;
  int count = 0;
  int met = 0;

  bool match(const Survivor& s) const {
    const auto fits = [](const std::string& pattern, const std::string& text) {
      return fnmatch(pattern.c_str(), text.c_str(), 0) == 0;
    };
    return fits(mnemonic, s.mnemonic) && fits(site, s.site) && fits(change, s.change);
  }
};

std::vector<KnownSurvivors> knownSurvivors(int& problems) {
  std::vector<KnownSurvivors> list;
  std::ifstream file(RUNGPROOF_SOURCE_DIR "/tests/mutation/survivors.tsv");
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::vector<std::string> cells(1);
    for (const char c : line) {
      if (c == '\t')
        cells.emplace_back();
      else
        cells.back() += c;
    }
    if (cells.size() == 6 && (cells[0] == "same" || cells[0] == "open") && !cells[5].empty()) {
      list.push_back({cells[0] == "same", cells[1], cells[2], cells[3], std::atoi(cells[4].c_str())});
    } else {
      fmt::print("survivors.tsv: not same or open, mnemonic, site, change, count and reason: {}\n", line);
      ++problems;
    }
  }
  return list;
}

/// `same`: how many survivors are no other meaning.
int compareWithKnown(const Campaign& campaign, int& same) {
  int problems = 0;
  std::vector<KnownSurvivors> known = knownSurvivors(problems);
  for (const Survivor& survivor : campaign.survivors) {
    const auto row =
        std::find_if(known.begin(), known.end(), [&](const KnownSurvivors& k) { return k.match(survivor); });
    if (row != known.end()) {
      ++row->met;
      same += row->isSame ? 1 : 0;
      continue;
    }
    fmt::print("unnoticed: {}\t{}\t{}\n", survivor.mnemonic, survivor.site, survivor.change);
    ++problems;
  }
  for (const KnownSurvivors& row : known) {
    if (row.met == row.count || (row.met < row.count && !triesEveryMutant())) continue;
    fmt::print("survivors.tsv: {} instead of {}: {}\t{}\t{}\n", row.met, row.count, row.mnemonic, row.site, row.change);
    ++problems;
  }
  return problems;
}

int judge(const Campaign& campaign) {
  int same = 0;
  int problems = compareWithKnown(campaign, same);
  Tally all;
  for (std::size_t i = 0; i < campaign.byOpcode.size(); ++i) {
    const Tally& tally = campaign.byOpcode[i];
    all.mutants += tally.mutants;
    all.noticed += tally.noticed;
    if (isLeftOut(i)) continue;
    if (tally.mutants >= 3 && tally.noticed > 0) continue;
    fmt::print("{}: {} mutants, {} noticed\n", s7200Instructions().all()[i].stl, tally.mutants, tally.noticed);
    ++problems;
  }
  const auto share = [&](int of) { return 100.0 * all.noticed / std::max(of, 1); };
  fmt::print("{} instructions, {} mutants: {} noticed ({:.2f} %); without the {} that mean the same {:.2f} %\n",
             campaign.byOpcode.size(), all.mutants, all.noticed, share(all.mutants), same, share(all.mutants - same));
  if (share(all.mutants) < 95) {
    fmt::print("fewer than 95 % of the mutants are noticed\n");
    ++problems;
  }
  return problems;
}

}  // namespace
}  // namespace rungproof::mutation

int main(int argc, char** argv) {
  using namespace rungproof::mutation;
  testing::InitGoogleTest(&argc, argv);
  setenv("RUNGPROOF_CASES", "40", 1);  // of each random test: more of them notice hardly more
  const std::vector<std::string> tests = recordTests();
  if (tests.empty()) return 1;
  if (!isSoundWithoutChange(tests)) {
    fmt::print("a test fails without any change\n");
    return 1;
  }
  const std::string_view only = argc > 1 ? argv[1] : "";
  Mutation::instance().comparesOutcomes = !only.empty();
  const Campaign campaign = run(tests, only);
  return only.empty() && judge(campaign) != 0 ? 1 : 0;
}
