// What the editor says of each network when a text is imported: it becomes a program, or it is invalid. The editor of
// the S7-200 SMART leaves an invalid network out of the download without a compile error. A ladder network is one rung:
// walking through it with the depth of LPS and LPP, a load at depth 0 behind an output, a box or a call begins a second
// one. Tested by tests/smart/editor_verdict_test.cpp.
#pragma once

#include <string>
#include <vector>

#include "analysis/unread/unread_code.hpp"

namespace rungproof {

enum class EditorLanguage : std::uint8_t { Ladder, Stl };

struct NetworkVerdict {
  NetworkPlace place;
  std::string reason;   ///< why it is invalid; empty: it is valid
  Span span;            ///< of what is wrong
  bool isDrawn = true;  ///< a valid network that the ladder view cannot show: shown as STL, or as invalid
};

/// One verdict for each network, in program order. In STL a network may hold several rungs.
std::vector<NetworkVerdict> editorVerdicts(const Program& program, const UnreadCode& unread, EditorLanguage language);

/// Empties the networks that are invalid in every language, as the editor of the S7-200 SMART leaves them out of the
/// download: their instructions, and the readers' findings on them. Gives their verdicts.
std::vector<NetworkVerdict> leaveOutInvalid(Program& program);

/// Networks of a text that have instructions, and those among them that hold several rungs.
struct RungCount {
  std::size_t networks = 0, several = 0;
};
RungCount rungCount(const Program& program);
/// Whether an editor would be asked to show the program as STL: at least three networks, and more than half of those
/// with instructions, hold several rungs.
bool isWrittenAsStl(const Program& program);

}  // namespace rungproof
