// What the self-check of a starter costs beside the proofs of its properties: random runs of the program and of its
// faulty copies side by side (analysis/selfcheck/side_by_side.hpp) leave few faults to the prover.
#include <gtest/gtest.h>

#include <algorithm>

#include "analysis/selfcheck/self_check.hpp"
#include "engine/lanes/lane_code.hpp"
#include "tests/corpus/corpus_program.hpp"
#include "tests/timing/measured_proof.hpp"

namespace rungproof {
namespace {

/// Times the proofs: 0.2 is measured, and 22 where each fault is proved by itself, as it is without vectors.
constexpr double most = 2, mostWithoutVectors = 60;
constexpr int runs = 3;

TEST(SelfCheckPace, CostsAFewTimesItsProofs) {
  const double limit = lanes::vectorsHere() == lanes::Vectors::None ? mostWithoutVectors : most;
  const std::filesystem::path file =
      std::filesystem::path(RUNGPROOF_SOURCE_DIR) / "corpus" / "interlocks" / "star_delta.awl";
  const ProgramInput input = test::corpusInput(file);
  SelfCheckOptions options;
  options.prover = test::proverOptions(file);
  options.prover.jobs = 1;
  double proofs = 1e9, faults = 1e9;
  std::size_t noticed = 0, changing = 0;
  for (int run = 0; run < runs; ++run) {
    double begin = cpuSeconds();
    const ProofRun before = prove(input.program, input.properties, options.prover);
    proofs = std::min(proofs, cpuSeconds() - begin);
    begin = cpuSeconds();
    const SelfCheck check = selfCheck(input.program, input.properties, before.results, options);
    faults = std::min(faults, cpuSeconds() - begin);
    noticed = check.count(FaultFate::Noticed);
    changing = noticed + check.count(FaultFate::Unnoticed) + check.count(FaultFate::Undecided);
  }
  std::printf("proofs %.3f s, %zu of %zu faults noticed in %.3f s: x%.1f of x%.0f\n", proofs, noticed, changing, faults,
              faults / proofs, limit);
  EXPECT_GE(noticed, 20U);
  EXPECT_LE(faults, limit * proofs);
}

}  // namespace
}  // namespace rungproof
