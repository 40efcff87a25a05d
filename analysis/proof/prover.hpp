// Prover: verdicts on declared properties and built-in checks. It encodes the program
// once, asks the engines about each question, replays every witness in the reference engine before it counts, and
// looks for occasions so that nothing holds vacuously. Covered by tests/prover and tests/corpus.
#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "analysis/asking/rule_question.hpp"
#include "analysis/encoding/trail.hpp"
#include "analysis/schedule/schedule.hpp"
#include "analysis/schedule/technique.hpp"
#include "analysis/unread/unread_code.hpp"
#include "analysis/witness/both_traces.hpp"
#include "analysis/witness/outcome.hpp"
#include "analysis/witness/witness.hpp"

namespace rungproof {

struct ProverOptions {
  Choices choices;
  TimeRange time;
  std::optional<std::vector<RetentiveRange>> retentive{};  ///< nothing: the CPU's default
  double timeout = schedule::questionSeconds;  ///< seconds per question; encoding and checks of certificates count
  double total = 0;                            ///< seconds for everything, encoding included; 0: no limit
  double ruleTimeout = schedule::ruleSeconds;  ///< at most, for each question of a rule in lint
  int bound = 0;                               ///< scans that bounded search may look at; 0: no limit
  int jobs = 2;
  std::uint64_t seed = 1;
  std::uint64_t memory = 0;   ///< bytes; 0: no limit
  CheckGroups checks;         ///< what is asked beside the declared properties
  bool certificates = false;  ///< write out the proofs as SMT-LIB 2
  bool explains = true;       ///< name what results rest on; without: outcomes, and runs of properties only
  bool evidence = true;       ///< check certificates, shorten witnesses, name networks; without: verdicts only
  Techniques techniques{};    ///< what may be used
  bool usesCone = true;       ///< encode only networks that can have an effect on what is asked (cone_of_influence.hpp)
  const UnreadCode* unread = nullptr;  ///< what was left out of the program: all that depends on it is NOT COVERED
  const std::atomic<bool>* cancel = nullptr;  ///< set from outside, as by Ctrl-C: the run ends with what is settled
  std::shared_ptr<Trail> planted{};           ///< by tests: what the encoding is told with mistakes
};

/// How the program is encoded; relaxed: with scans of any length (time_model.hpp).
EncoderOptions encoderOptionsOf(const ProverOptions& options, bool relaxed = false);

struct ProofResult {
  Property property;  ///< declared; for a question of a rule only name and span
  std::optional<RuleQuestion> builtin;
  Outcome outcome = Outcome::Unknown;
  std::string method;
  int depth = 0;  ///< scans of the witness, or without a violation
  double seconds = 0;
  std::optional<Witness> witness;
  std::string certificate;  ///< SMT-LIB 2, if asked for and proved
  std::vector<std::string> notes;
  std::vector<std::string> assumptions;  ///< of this verdict, beside those of the run: choices and facts of the plant
  std::vector<std::pair<std::string, int>> networks;  ///< blocks and networks that a proof rests on
};

/// What was wrong with the tool itself: a witness that the engine does not repeat, or a proof of what the engine
/// refutes. The property is Unknown; the caller prints both traces and ends with exit 2.
struct Disagreement {
  std::string name;
  std::string explanation;
  BothTraces traces;
};

struct ProofRun {
  std::vector<ProofResult> results;
  std::vector<std::string> assumptions;     ///< CPU, scan time, initial memory, external writers
  std::vector<std::string> approximations;  ///< "PID at press.awl:41: result is any value"
  std::vector<Disagreement> disagreements;
  TechniqueUses techniques{};  ///< what each has done
  bool isInterrupted = false;  ///< by ProverOptions::cancel; what was open is Unknown
};

/// Called with each result as it is settled, those with a quickly found run first; false ends the run (the results so
/// far are returned, in the order of the questions).
using ProofProgress = std::function<bool(const ProofResult& result, std::size_t done, std::size_t total)>;

ProofRun prove(const Program& program, const PropertySet& set, const ProverOptions& options,
               const ProofProgress& progress = {});

}  // namespace rungproof
