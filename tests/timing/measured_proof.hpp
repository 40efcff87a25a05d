// One run of `prove` on a program text, with its verdicts and the CPU time that all its threads took. CPU time at the
// pace of a quiet machine, the least of several runs, is what bars are stated in.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace rungproof {

struct MeasuredProof {
  std::map<std::string, std::string> verdicts;  ///< by property
  double cpuSeconds = 0;
};

/// CPU seconds so far, of all threads of this process and of those it has waited for: certificates are checked in one
/// of its own.
double cpuSeconds();

/// Runs `prove` with these options; the least CPU time of at most `runs` runs, the last of which is the first to take
/// no more than `enough` seconds.
MeasuredProof measureProof(const std::string& program, const std::vector<std::string>& options = {}, int runs = 2,
                           double enough = 0);

}  // namespace rungproof
