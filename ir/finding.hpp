// A finding: what a rule, the reader or a run-time check says about a place of the program.
#pragma once

#include <cstdint>
#include <vector>

#include "ir/shared.hpp"
#include "ir/short_text.hpp"
#include "ir/source.hpp"

namespace rungproof {

enum class Severity : std::uint8_t { Note, Warning, Error };

/// A second place that belongs to a finding, with its own text.
struct RelatedPlace {
  Span span;
  ShortText message;
};

/// A replacement of text that mends the finding.
struct Fix {
  Span span;
  ShortText replacement;
  bool safe = false;  ///< true: cannot change what a correct program does
};

/// Whether a solver or the engine confirmed the finding.
enum class Confirmation : std::uint8_t { NotNeeded, Unconfirmed, Confirmed };

/// The fields stand so that little room is lost between them: a long program has a finding for every fifth instruction.
struct Finding {
  ShortText rule;  ///< id such as "ADR001"; "SYN001" and following come from the readers
  Severity severity = Severity::Error;
  Confirmation confirmation = Confirmation::NotNeeded;
  bool refused = false;  ///< an error for which the editor or the CPU takes no program: its network is never run
  int network = 0;       ///< network number as written, 0 outside networks
  Span span;
  ShortText message;  ///< one sentence, names the operand or instruction it is about
  ShortText help;     ///< what to do; may be empty
  std::vector<RelatedPlace> related;
  Shared<Fix> fix;    ///< null: none that is known
  ShortText pou;      ///< name of the block, empty outside blocks
  ShortText address;  ///< the operand concerned, canonical spelling, or empty
  ShortText trace;    ///< file or inline id of the trace that shows it, or empty
};

}  // namespace rungproof
