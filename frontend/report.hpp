// What a run found, ready to be reported: findings, properties, comparison, coverage. Every command that judges a
// program fills one Report and hands it to finish(); one file of this folder per output form prints it.
// The JSON form is a contract, see schema.json beside this file; tests/cli/report_test.cpp validates against it.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/schedule/technique.hpp"
#include "analysis/witness/outcome.hpp"
#include "engine/trace_number.hpp"
#include "frontend/acceptance_record.hpp"
#include "frontend/compared_block.hpp"
#include "frontend/files/exit.hpp"
#include "ir/finding.hpp"
#include "ir/source.hpp"

namespace rungproof {

/// "PROVED", "HOLDS TO BOUND 20".
std::string verdictText(Outcome verdict, int depth);

enum class ResultKind : std::uint8_t { Prove, Reach, Builtin };
std::string_view resultKindName(ResultKind kind);

/// A network as it was in one scan of a witness, power flow lit.
struct ShownNetwork {
  std::string heading;            ///< "MAIN, Network 3  Star contactor"
  std::vector<std::string> text;  ///< lines; empty: not asked for
  std::string svg;                ///< an element for an HTML page that brings svgStyle(); empty: not asked for
};
struct ShownScan {
  std::uint64_t scan = 0;
  double timeMs = 0;  ///< at its end
  std::vector<ShownNetwork> networks;
};

/// The verdict on one property.
struct PropertyResult {
  std::string name;
  ResultKind kind = ResultKind::Prove;
  Outcome verdict = Outcome::Unknown;
  std::string method;  ///< "k-induction, k = 3"
  int depth = 0;       ///< scans: length of the witness, or how far it was looked
  double seconds = 0;
  std::string trace;                     ///< file that holds the witness, or empty
  std::string statement;                 ///< the property as written
  std::optional<Span> span;              ///< where it is declared, in the sources of the report
  std::vector<std::string> assumptions;  ///< of this property only; those of the run are in Report::assumptions
  std::string networks;                  ///< that the verdict rests on: "MAIN 1, 3-5; SBR_0 2", or empty
  std::vector<std::string> notes;        ///< what was tried, which lines are not covered, what the witness shows
  std::vector<ShownScan> scans{};        ///< the last scans of the witness as drawings
  std::vector<std::string> run{};        ///< the witness as a table, a line each, heading first
  std::string certificate{};             ///< file, or empty
  std::string program{};                 ///< its first file where the report is about several programs
  PropertyEvidence evidence{};           ///< for a page

  /// With the program if there are several.
  std::string title() const { return program.empty() ? name : name + " of " + program; }
};

/// A row of the table around the first difference: the values of all compared signals in one scan.
struct ComparedScan {
  int scan = 0;
  double timeMs = 0;
  std::vector<std::string> expected;
  std::vector<std::string> actual;
};

/// The outcome of a comparison of traces: the first difference, if there is one.
struct Comparison {
  bool equal = true;
  int scan = 0;
  double timeMs = 0;
  std::string signal;
  TraceNumber expected = 0;
  TraceNumber actual = 0;
  std::vector<std::string> signals;  ///< names of the columns of `around`
  std::vector<ComparedScan> around;  ///< scans before and after the difference
  bool hasEnded = false;             ///< the trace ends before that scan: there is no actual value
  /// Of two programs instead of two traces: "EQUAL", "DIFFERENT" or "UNKNOWN"; empty: of traces.
  std::string verdict{};
  std::string method{};
  double seconds = 0;
  std::vector<std::string> notes{};  ///< why nothing is decided, the run that differs
  std::string trace{};               ///< file that holds the run, or empty
  std::string certificate{};         ///< folder of the certificates, or empty
  std::vector<ShownScan> scans{};    ///< its last scans as drawings, networks of both programs

  bool isOfPrograms() const { return !verdict.empty(); }
  bool isUndecided() const { return verdict == "UNKNOWN"; }
};

/// Whole numbers with all their digits, others with six: "1476000", "0.05".
std::string plainNumber(TraceNumber value);
/// "scan 7, 70 ms, Q0.0: expected 1, actual 0", of programs "OLD 1, NEW 0"; or that the trace ends before, or why
/// nothing is decided.
std::string differenceText(const Comparison& comparison);

/// A planted fault and what became of it (analysis/selfcheck/self_check.hpp).
struct PlantedFault {
  std::string kind;  ///< "removed contact"
  std::string text;  ///< "A I0.2"
  std::string file;
  std::uint32_t line = 0;
  std::string pou;
  int network = 0;
  std::string fate;       ///< "noticed", "unnoticed", "without effect", "undecided"
  std::string noticedBy;  ///< a property, or empty
  std::string differs;    ///< unnoticed: "Q0.1 in scan 3"
};

/// Planted faults by what became of them.
struct FaultCounts {
  std::size_t noticed = 0, unnoticed = 0, withoutEffect = 0, undecided = 0;
};
FaultCounts countsOf(const std::vector<PlantedFault>& faults);

/// How much of the program the tool understood; a verdict is worth no more than this.
struct Coverage {
  std::size_t instructions = 0;
  std::size_t understood = 0;
  std::vector<std::string> approximated;  ///< "PID at press.awl:41: result is any value"
  std::vector<std::string> leftOut;       ///< "LOG001: 12 of 40 questions are open: ..."
  std::size_t open = 0;                   ///< questions that those lines speak of
};

/// Why the exit code is what it is: "a property does not hold"; empty if there is nothing to say.
struct ExitReason {
  Exit exit = Exit::Clean;
  std::string text{};
};

/// One of several runs that share the questions (--shard 2/4).
struct ReportPart {
  std::uint32_t part = 1, of = 1;
};

struct TestReport;  // of test tables; frontend/test_results.hpp

struct Report {
  std::string command;  ///< "lint", "prove", ...
  std::shared_ptr<const SourceSet> sources;
  std::vector<Finding> findings;
  std::vector<PropertyResult> properties;
  std::optional<Comparison> comparison;
  std::vector<ComparedBlock> blocks{};  ///< of two programs, where stored blocks are among them
  Coverage coverage;
  std::optional<std::vector<PlantedFault>> selfCheck;
  std::shared_ptr<const TestReport> tests{};  ///< nullptr: of another command
  std::vector<std::string> assumptions;       ///< CPU, scan time, initial memory, external writers
  std::vector<std::string> files;             ///< as given; for the closing line
  std::vector<std::string> defects;           ///< of rungproof itself, as internal disagreements: the exit code is 2
  std::vector<ExitReason> reasons{};          ///< of the exit code, beside what the rest of the report tells
  std::optional<Severity> failLevel{};        ///< findings below it leave the exit code alone; as set if none
  bool exitsZero = false;                     ///< whatever was found or stays open
  std::optional<TechniqueUses> techniques{};  ///< of the prover: what each has done
  std::size_t suppressed = 0;                 ///< findings that an allow-comment silenced
  std::size_t baselined = 0;                  ///< findings that the baseline lists
  std::vector<ProgramRecord> programs{};      ///< for a page that is signed
  std::optional<ReportPart> part{};           ///< nothing: all of it
  std::vector<Finding> lintFindings{};        ///< for such a page too; no say in the exit code
};

struct Summary {
  std::size_t errors = 0, warnings = 0, notes = 0, proved = 0, violated = 0, undecided = 0;
};
Summary summaryOf(const Report& report);

/// Exit code of the contract for what the report holds: 2 if the readers could not read everything or nothing was
/// checked, else 1, 3 or 0.
ExitReason exitReasonOf(const Report& report);
inline Exit exitOf(const Report& report) { return exitReasonOf(report).exit; }

/// Sorts findings by place and removes those that say the same of the same place.
void sortFindings(Report& report);

/// How a report is to look.
struct ReportStyle {
  bool color = false;
  bool quiet = false;
  bool verbose = false;
};

/// One output form; each file of frontend/report defines one.
struct Reporter {
  std::string_view name;
  std::string_view summary;  ///< for the help
  void (*write)(const Report& report, const ReportStyle& style, std::ostream& out);
};
std::span<const Reporter* const> allReporters();
const Reporter* reporterNamed(std::string_view name);

}  // namespace rungproof
