// What provers are compared on: one obligation is one property of one program, with the options that belong to it.
// A sample of the corpus, the properties that take the prover longest, and generated families.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rungproof::peers {

struct Obligation {
  std::string group;  ///< "corpus", "slowest" or the name of a family
  std::filesystem::path program;
  std::string property;
  std::vector<std::string> options;  ///< of the command line: --scan-time 100ms
  std::string stated;                ///< the verdict that the corpus or the family states

  std::string name() const { return program.stem().string() + ": " + property; }
};

/// At least one obligation of each stratum, which is a folder of the corpus with a verdict, and about `count` in all,
/// evenly from each. What is NOT COVERED is no obligation. The same for the same corpus.
std::vector<Obligation> corpusSample(std::size_t count);

/// The `count` properties of the corpus that take `rungproof prove` the longest, all of a program in one run; takes as
/// long as proving the corpus.
std::vector<Obligation> slowestOfCorpus(std::size_t count, const std::string& rungproof);

/// Programs of the generated families in several sizes, written into `folder`; of a program with many properties the
/// first, the middle and the last one.
std::vector<Obligation> familyObligations(const std::filesystem::path& folder);

}  // namespace rungproof::peers
