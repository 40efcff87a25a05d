// Bugs seeded into the interlocks of the corpus - one contact removed, two networks swapped, EU for ED - are found by
// the declared properties: at least 95 % of those that change behaviour. A fault counts as harmless only if the prover
// has shown that the outputs are the same in every run (analysis/equivalence); one that it could not decide counts as
// not found.
#include <gtest/gtest.h>

#include "analysis/selfcheck/self_check.hpp"
#include "tests/corpus/corpus_program.hpp"

namespace rungproof::test {
namespace {

constexpr double share = 95;  ///< percent that must be noticed
constexpr double mostSeconds =
    4;  ///< for one fault; an idle machine needs milliseconds, so that only a busy one comes near it
constexpr std::size_t leastFaults =
    130;  ///< that change behaviour, over all programs: so that the share means something

struct Count {
  std::size_t noticed = 0, unnoticed = 0, undecided = 0, harmless = 0;
  std::string missed;
};

Outcome outcomeNamed(const std::string& verdict) {
  if (verdict == "PROVED") return Outcome::Proved;
  if (verdict == "VIOLATED") return Outcome::Violated;
  if (verdict == "REACHABLE") return Outcome::Reachable;
  if (verdict == "UNREACHABLE") return Outcome::Unreachable;
  ADD_FAILURE() << verdict;
  return Outcome::Unknown;
}

/// The verdicts of the head, which tests/corpus holds true.
std::vector<ProofResult> verdictsOf(const std::filesystem::path& file, const PropertySet& set) {
  const std::map<std::string, std::string> verdicts = trueVerdicts(file);
  std::vector<ProofResult> results;
  for (const Property& property : goalsOf(set)) {
    ProofResult result;
    result.property = property;
    result.outcome = outcomeNamed(verdicts.at(property.name));
    results.push_back(std::move(result));
  }
  return results;
}

void seed(const std::filesystem::path& file, Count& count) {
  const ProgramInput input = corpusInput(file);
  SelfCheckOptions options;
  options.prover = proverOptions(file);
  options.kinds = {FaultKind::RemovedContact, FaultKind::SwappedNetworks, FaultKind::Edge};
  options.seconds = mostSeconds;
  const SelfCheck check = selfCheck(input.program, input.properties, verdictsOf(file, input.properties), options);
  count.noticed += check.count(FaultFate::Noticed);
  count.unnoticed += check.count(FaultFate::Unnoticed);
  count.undecided += check.count(FaultFate::Undecided);
  count.harmless += check.count(FaultFate::NoEffect);
  for (const FaultResult& result : check.results) {
    if (result.fate != FaultFate::Unnoticed && result.fate != FaultFate::Undecided) continue;
    const bool isOpen = result.fate == FaultFate::Undecided;
    count.missed += "\n  " + file.filename().string() + ": " + result.fault.text + (isOpen ? " (undecided)" : "");
  }
}

TEST(InterlockFaults, AreNoticed) {
  Count count;
  for (const std::filesystem::path& file : corpusFiles("interlocks")) {
    if (file.stem().string().find("faulty") == std::string::npos) seed(file, count);
  }
  const std::size_t changing = count.noticed + count.unnoticed + count.undecided;
  const double percent =
      100 * static_cast<double>(count.noticed) / static_cast<double>(std::max<std::size_t>(changing, 1));
  std::cout << count.noticed << " of " << changing << " seeded faults are noticed (" << percent << " %), "
            << count.undecided << " of them undecided; " << count.harmless
            << " are proved to change no output; missed:" << count.missed << "\n";
  EXPECT_GE(changing, leastFaults);
  EXPECT_GE(percent, share) << count.missed;
}

}  // namespace
}  // namespace rungproof::test
