// A finding: what a rule, the reader or a run-time check says about a place of the program.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ir/source.hpp"

namespace rungproof {

enum class Severity : std::uint8_t { Note, Warning, Error };

/// A second place that belongs to a finding, with its own text.
struct RelatedPlace {
  Span span;
  std::string message;
};

/// A replacement of text that mends the finding.
struct Fix {
  Span span;
  std::string replacement;
  bool safe = false;  ///< true: cannot change what a correct program does
};

/// Whether a solver or the engine confirmed the finding.
enum class Confirmation : std::uint8_t { NotNeeded, Unconfirmed, Confirmed };

struct Finding {
  std::string rule;  ///< id such as "ADR001"; "SYN001" and following come from the readers
  Severity severity = Severity::Error;
  std::string message;  ///< one sentence, names the operand or instruction it is about
  Span span;
  std::string help;  ///< what to do; may be empty
  std::vector<RelatedPlace> related;
  std::optional<Fix> fix;
  std::string pou;       ///< name of the block, empty outside blocks
  int network = 0;       ///< network number as written, 0 outside networks
  bool refused = false;  ///< an error for which the editor or the CPU takes no program: its network is never run
  std::string address;   ///< the operand concerned, canonical spelling, or empty
  Confirmation confirmation = Confirmation::NotNeeded;
  std::string trace;  ///< file or inline id of the trace that shows it, or empty
};

}  // namespace rungproof
