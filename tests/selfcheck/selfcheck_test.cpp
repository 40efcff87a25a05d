// The self-check on programs of which it is known what their properties notice.
#include <gtest/gtest.h>

#include <map>

#include "analysis/equivalence/equivalence.hpp"
#include "analysis/selfcheck/self_check.hpp"
#include "tests/prover/proved_text.hpp"

namespace rungproof::test {
namespace {

SelfCheck checked(const ProgramInput& input, std::vector<FaultKind> kinds = {}) {
  SelfCheckOptions options;
  options.prover = usualOptions(5);
  options.kinds = std::move(kinds);
  const ProofRun before = prove(input.program, input.properties, options.prover);
  return selfCheck(input.program, input.properties, before.results, options);
}

Equality comparedOutputs(const Program& before, Program after) {
  after.number();
  EquivalenceOptions options;
  options.prover = usualOptions(10);
  return compareBehaviour({&before, {}}, {&after, {}}, options).equality;
}

const FaultResult* faultNamed(const SelfCheck& check, const std::string& part, FaultKind kind) {
  for (const FaultResult& result : check.results) {
    if (result.fault.kind == kind && result.fault.text.find(part) != std::string::npos) return &result;
  }
  ADD_FAILURE() << "no fault is called " << part;
  return nullptr;
}

TEST(SelfCheck, TellsNoticedFromUnnoticed) {
  // The property speaks of the stop button only: the start button's polarity is nobody's concern.
  const ProgramInput input =
      inputOf("//@ prove stop: not I0.1 implies not Q0.0\n", "Network 1\nLD I0.0\nO Q0.0\nA I0.1\n= Q0.0\n");
  const SelfCheck check = checked(input);
  const FaultResult* stop = faultNamed(check, "A I0.1", FaultKind::RemovedContact);
  ASSERT_NE(stop, nullptr);
  EXPECT_EQ(stop->fate, FaultFate::Noticed);
  EXPECT_EQ(stop->noticedBy, "stop");
  EXPECT_EQ(stop->where, "");  // an output is named where nothing notices
  const FaultResult* start = faultNamed(check, "LDN I0.0", FaultKind::Polarity);
  ASSERT_NE(start, nullptr);
  EXPECT_EQ(start->fate, FaultFate::Unnoticed);
  EXPECT_EQ(start->where.find("Q0.0 in scan "), 0U) << start->where;
}

TEST(SelfCheck, LeavesOutFaultsWithoutEffect) {
  // The second contact of I0.0 is in series with the first one; networks 1 and 2 do not touch each other.
  const ProgramInput input = inputOf("//@ prove contact: Q0.0 implies I0.0\n",
                                     "Network 1\nLD I0.0\nA I0.0\n= Q0.0\nNetwork 2\nLD I0.1\n= Q0.1\n");
  const SelfCheck check = checked(input);
  const FaultResult* doubled = faultNamed(check, "A I0.0", FaultKind::RemovedContact);
  ASSERT_NE(doubled, nullptr);
  EXPECT_EQ(doubled->fate, FaultFate::NoEffect);
  const FaultResult* swapped = faultNamed(check, "networks 1 and 2", FaultKind::SwappedNetworks);
  ASSERT_NE(swapped, nullptr);
  EXPECT_EQ(swapped->fate, FaultFate::NoEffect);
}

TEST(SelfCheck, PlantsEveryKind) {
  const ProgramInput input = inputOf("",
                                     "Network 1\nLD I0.0\nEU\nS M0.0, 1\nLD I0.1\nR M0.0, 1\nNetwork 2\nLD M0.0\nTON "
                                     "T37, 50\nNetwork 3\nLD T37\nA I0.2\n= Q0.0\n");
  std::map<FaultKind, std::size_t> count;
  for (const Fault& fault : faultsOf(input.program)) ++count[fault.kind];
  EXPECT_EQ(count[FaultKind::Polarity], 5U);  // five contacts
  EXPECT_EQ(count[FaultKind::RemovedContact], 5U);
  EXPECT_EQ(count[FaultKind::SetForReset], 2U);
  EXPECT_EQ(count[FaultKind::LatchOrder], 1U);
  EXPECT_EQ(count[FaultKind::Edge], 1U);
  EXPECT_EQ(count[FaultKind::TimerKind], 1U);
  EXPECT_EQ(count[FaultKind::Preset], 2U);  // 25 and 100
  EXPECT_EQ(count[FaultKind::SwappedNetworks], 2U);
}

TEST(SelfCheck, PlantsFaultsInS7300Programs) {
  const ProgramInput input = inputOfSource(
      "ORGANIZATION_BLOCK OB 1\n//@ prove stop wins: not I0.1 implies not Q0.0\nBEGIN\n"
      "NETWORK\nA I 0.0;\nS Q 0.0;\nAN I 0.1;\nR Q 0.0;\nNETWORK\nO I 0.2;\n= Q 0.1;\nEND_ORGANIZATION_BLOCK\n");
  std::map<FaultKind, std::size_t> count;
  for (const Fault& fault : faultsOf(input.program)) ++count[fault.kind];
  EXPECT_EQ(count[FaultKind::Polarity], 3U);  // A, AN and O
  EXPECT_EQ(count[FaultKind::SetForReset], 2U);
  EXPECT_EQ(count[FaultKind::LatchOrder], 0U);  // nothing says where one rung ends
  EXPECT_EQ(count[FaultKind::SwappedNetworks], 1U);
  const SelfCheck check = checked(input);
  const FaultResult* stop = faultNamed(check, "A I0.1 for AN I0.1", FaultKind::Polarity);
  ASSERT_NE(stop, nullptr);
  EXPECT_EQ(stop->noticedBy, "stop wins");
  const FaultResult* lamp = faultNamed(check, "ON I0.2 for O I0.2", FaultKind::Polarity);
  ASSERT_NE(lamp, nullptr);
  EXPECT_EQ(lamp->fate, FaultFate::Unnoticed);
  const FaultResult* order = faultNamed(check, "networks 1 and 2", FaultKind::SwappedNetworks);
  ASSERT_NE(order, nullptr);
  EXPECT_EQ(order->fate, FaultFate::NoEffect);
}

TEST(SelfCheck, OrderOfSetAndResetExchangesTheirRungs) {
  const ProgramInput input = inputOf("", "Network 1\nLD I0.0\nS Q0.0, 1\nLD I0.1\nA I0.2\nR Q0.0, 1\n");
  for (const Fault& fault : faultsOf(input.program)) {
    if (fault.kind != FaultKind::LatchOrder) continue;
    const Program changed = planted(input.program, fault);
    std::string order;
    for (const Instruction& instruction : changed.pous[0].networks[0].instructions)
      order += std::string(instruction.desc->stl) + " ";
    EXPECT_EQ(order, "LD A R LD S ");
    EXPECT_EQ(comparedOutputs(input.program, changed), Equality::Different);
    return;
  }
  FAIL() << "no such fault";
}

TEST(SelfCheck, ComparesOutputsOverTime) {
  // T37 after 5 s and after 10 s: the same outputs for at least ten scans, then not.
  const ProgramInput slow = inputOf("", "Network 1\nLD I0.0\nTON T37, 100\nNetwork 2\nLD T37\n= Q0.0\n");
  const ProgramInput fast = inputOf("", "Network 1\nLD I0.0\nTON T37, 50\nNetwork 2\nLD T37\n= Q0.0\n");
  EXPECT_EQ(comparedOutputs(slow.program, fast.program), Equality::Different);
  EXPECT_EQ(comparedOutputs(slow.program, slow.program), Equality::Equal);
}

}  // namespace
}  // namespace rungproof::test
