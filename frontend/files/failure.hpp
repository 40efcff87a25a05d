// Failure: why the tool could not do what it was asked (exit code 2). Printed to standard error in the anatomy of
// findings: what, where, help. Findings about programs are ir/finding.hpp.
#pragma once

#include <iosfwd>
#include <string>

namespace rungproof {

struct Failure {
  std::string message;     ///< one sentence without a full stop
  std::string place = {};  ///< "rungproof.toml:3:1", a file name, or empty
  std::string help = {};   ///< what to do; may be empty
};

void print(std::ostream& err, const Failure& failure);

}  // namespace rungproof
