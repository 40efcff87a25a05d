// The comparison: what `rungproof prove` says of a program against many random runs of the referee. The product runs as
// a process of its own; nothing but the text of the program goes in, nothing but its JSON report comes out.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "case_draw.hpp"
#include "machine.hpp"
#include "property.hpp"

namespace rungproof::referee {

struct Settings {
  std::string prover;  ///< path of the executable
  std::string folder;  ///< for the files of a run
  double timeout = 2;  ///< seconds a property
  int runs = 300;      ///< of the referee, for each program
  int scans = 10;      ///< of each run
  OpenPoints open;
};

struct Verdict {
  std::string word;
  int depth = 0;
};
/// Verdicts by property; empty if the report could not be read. `complaint` gets what the product printed then.
std::map<std::string, Verdict> verdictsOf(const std::string& text, const Settings& settings, std::string& complaint);

/// A run of the referee that breaks a verdict.
struct Contradiction {
  std::string property;
  std::string verdict;
  std::uint64_t run = 0;  ///< its seed
  int scan = 0;
  std::string text;  ///< the program
  std::vector<std::string> told;
  std::string report() const;
};

/// What came of one program.
struct Outcomes {
  int pairs = 0, undecided = 0, proved = 0, shown = 0, reproduced = 0;
  std::map<std::string, int> words;
  std::vector<Contradiction> contradictions;
  std::vector<std::string> impossible;    ///< witnesses with an event that has no cause
  std::vector<std::string> unreproduced;  ///< properties with a witness that no run of the referee showed
  std::vector<std::string> complaints;
  void add(const Outcomes& other);
};
Outcomes compare(const Case& drawn, std::uint64_t seed, const Settings& settings);

/// Takes away networks and lines as long as the contradiction stays.
Contradiction shrink(Case drawn, const Contradiction& found, const Settings& settings);

/// A program with properties near the border of what holds: those that a few short runs do not decide are preferred.
Case drawCase(std::uint64_t seed, const std::vector<Topic>& topics, const Settings& settings);

}  // namespace rungproof::referee
