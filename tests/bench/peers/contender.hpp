// The provers that are compared, each as a process of its own whose processor time is taken from the system: ours from
// reading the program to the checked certificate, berkeley-abc from reading the AIGER file that we export.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "tests/bench/peers/obligation.hpp"
#include "tests/measured_process.hpp"

namespace rungproof::peers {

using test::ProcessRun, test::runProcess;

/// What a prover says of an obligation. Safe: PROVED, UNREACHABLE or VACUOUS.
enum class Answer { Open, Safe, Unsafe };

struct Measured {
  Answer answer = Answer::Open;
  double seconds = 0;  ///< processor time; of an open one at least the limit
};

struct Peer {
  std::string_view name;
  std::string_view script;    ///< commands of berkeley-abc behind read_aiger
  bool searchesOnly = false;  ///< proves nothing but what has very few states
};

/// The peers, in the order of every list of their measurements.
std::span<const Peer> peerTable();

/// The obligation as it is given to the peers.
struct Exported {
  std::string file;     ///< empty: it cannot be exported
  bool isExact = true;  ///< false: a bad state that can be reached may be one of the export alone
  double seconds = 0;   ///< processor time of the export
};

Exported exportObligation(const Obligation& obligation, const std::string& rungproof, const std::string& file);

/// Ours; `verdict` becomes the word of the report.
Measured proveObligation(const Obligation& obligation, const std::string& rungproof, double limit,
                         std::string& verdict);
Measured askPeer(const Peer& peer, const Exported& exported, double limit);

/// The answer in the output of berkeley-abc's print_status.
Answer answerOfAbc(const std::string& output);
/// The answer that a verdict of ours is.
Answer answerOfVerdict(const std::string& verdict);

}  // namespace rungproof::peers
