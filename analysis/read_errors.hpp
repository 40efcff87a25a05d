// Which findings of the readers say that something of the text is not known. The exit code is 2 then, and no command
// runs what they stand in (unread_code.hpp).
#pragma once

#include <algorithm>
#include <iterator>
#include <string_view>

#include "ir/program.hpp"
#include "ir/s7300/declarations.hpp"

namespace rungproof {

/// An error of the readers of programs (SYN, or GRF in a drawing).
inline bool isProgramReadError(const Finding& finding) {
  return finding.severity == Severity::Error && (finding.rule.starts_with("SYN") || finding.rule.starts_with("GRF"));
}
/// Such an error behind which it is not known which block or network the lines around belong to, or what a block
/// declares: a heading, a declaration, a Network line, a line outside of any block, a file.
inline bool isFrameReadError(const Finding& finding) {
  constexpr std::string_view firstOfFrame = "SYN020", lastOfFrame = "SYN028";
  constexpr std::string_view firstOfTables = "SYN029", lastOfTables = "SYN032";
  constexpr std::string_view nothingInside[] = {"SYN006", "SYN007"};
  if (!isProgramReadError(finding) || std::ranges::find(nothingInside, finding.rule) != std::end(nothingInside))
    return false;
  if (finding.rule >= firstOfFrame && finding.rule <= lastOfFrame) return true;
  return finding.network == 0 && (finding.rule < firstOfTables || finding.rule > lastOfTables);
}
/// Whether an error outside of networks leaves no more open than the data blocks and networks that the reader of an
/// S7-300/400 has marked.
inline bool isBoundedReadError(const Program& program, const Finding& finding) {
  return program.declarations != nullptr &&
         program.declarations->bounded.contains({finding.span.file, finding.span.offset});
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
