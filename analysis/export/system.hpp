// A transition system with its questions in the formats of other model checkers: AIGER (bits), BTOR2, SMT-LIB 2 and
// SMV (words). REAL operations become free inputs. A question is a bad state: "unreachable" there means PROVED or
// UNREACHABLE here. Covered by tests/export, which reads the texts back, runs them and asks ABC.
#pragma once

#include <string>
#include <vector>

#include "analysis/graph/transition_system.hpp"

namespace rungproof {

/// Lines of text that go into the file as comments: assumptions, approximations.
using ExportRemarks = std::vector<std::string>;

/// Binary AIGER for the largest number of readers: bad states, but no constraints (a latch remembers that one was
/// broken, and nothing is bad from then on) and every latch starts with 0 (an input of the first scan gives free
/// values).
std::string exportAiger(const TransitionSystem& system, const ExportRemarks& remarks = {});
/// AIGER 1.9 in ascii, with constraints and resets as they are.
std::string exportAigerText(const TransitionSystem& system, const ExportRemarks& remarks = {});
std::string exportBtor2(const TransitionSystem& system, const ExportRemarks& remarks = {});
/// `scans` scans in a row from an initial state, with state |name@k| before scan k; for each question, between push and
/// pop, whether it can be bad in one of them.
std::string exportSmt2(const TransitionSystem& system, int scans = 1, const ExportRemarks& remarks = {});
/// The SMV of NuSMV and nuXmv: one module, truth values as boolean, others as unsigned word, INVARSPEC for each
/// question.
std::string exportSmv(const TransitionSystem& system, const ExportRemarks& remarks = {});

/// A name on one line, without characters that control a terminal or the direction of text, for comments and symbol
/// tables.
std::string exportLine(std::string name);

}  // namespace rungproof
