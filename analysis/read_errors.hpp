// Which findings of the readers say that something of the text is not known. The exit code is 2 then, and no command
// runs what they stand in (unread_code.hpp).
#pragma once

#include <algorithm>

#include "ir/program.hpp"

namespace rungproof {

/// An error of the readers of programs (SYN, or GRF in a drawing).
inline bool isProgramReadError(const Finding& finding) {
  return finding.severity == Severity::Error && (finding.rule.starts_with("SYN") || finding.rule.starts_with("GRF"));
}
/// The same, or an error of the reader of properties (PRP).
inline bool isReadError(const Finding& finding) {
  return isProgramReadError(finding) || (finding.severity == Severity::Error && finding.rule.starts_with("PRP"));
}
/// Whether the program is not wholly known.
inline bool hasReadErrors(const Program& program) {
  return std::any_of(program.findings.begin(), program.findings.end(), isProgramReadError);
}

}  // namespace rungproof
