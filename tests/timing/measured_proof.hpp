// One run of `prove` on a program text, with its verdicts and the CPU time that all its threads took. CPU time, the
// least of several runs, is what bars are stated in: it does not depend on what else the machine does.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace rungproof {

struct MeasuredProof {
  std::map<std::string, std::string> verdicts;  ///< by property
  double cpuSeconds = 0;
};

/// Runs `prove` with these options; the least CPU time of `runs` runs.
MeasuredProof measureProof(const std::string& program, const std::vector<std::string>& options = {}, int runs = 2);

}  // namespace rungproof
