// The rule descriptor: everything the tool knows about one rule stands in one file of analysis/checks, as one
// object named after the file. From it come the check itself, what is asked of the prover and how its answers are
// told, the pages of `explain`, the list of `rules`, the SARIF rules array, the configuration keys and the completion
// list. tests/cli/rule_table_test.cpp demands unique ids and complete pages; the good and bad examples are run by the
// tests of the rules.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ir/dialect.hpp"
#include "ir/finding.hpp"
#include "ir/hazard.hpp"
#include "ir/program.hpp"

namespace rungproof {

class Facts;  // what rules may ask about a program; analysis/flow/facts.hpp
class FindingSink;
class Asking;        // what a rule's questions to the prover stand on; analysis/asking/asking.hpp
struct ProofResult;  // analysis/proof/prover.hpp
struct BitRow;       // analysis/flow/bit_ranges.hpp

/// How much has to be known before the rule can speak.
enum class Needs : std::uint8_t {
  Text,            ///< T: the text, the IR and tables
  Flow,            ///< F: data flow or the abstract run
  FlowThenSolver,  ///< F>Z: `check` names candidates, marked unconfirmed; the prover confirms or drops each
  Solver           ///< Z: only the prover can answer; runs under `lint --prove` and `prove --builtin`
};

enum class RuleStatus : std::uint8_t { Stable, Preview };
enum class FixClass : std::uint8_t { None, Safe, Unsafe };

/// An integer option of a rule: configuration key `[rules.STY002] contacts = 24`.
struct RuleOption {
  std::string_view name;
  int low = 0;
  int high = 0;
  int initial = 0;
  std::string_view meaning;
};

/// The runs of the prover in which a rule asks: a set, one bit each.
using AskedIn = std::uint8_t;
namespace asked {
inline constexpr AskedIn Builtin = 1;  ///< prove --builtin, and lint --prove
inline constexpr AskedIn Lint = 2;     ///< lint --prove only; with Builtin: its findings rest on such answers
inline constexpr AskedIn PowerUp = 4;  ///< lint --prove, of a run that begins with any retentive memory
}  // namespace asked

/// What a rule asks the prover. It asks in one of three ways: about the program at large, about each timer and counter,
/// or about hazards that the encoding has met.
struct RuleAsks {
  AskedIn in = 0;
  int turn = 100;            ///< place among the questions of all rules: earlier ones are asked and listed first
  int cost = 5;              ///< of not knowing: 1 stops the CPU, 2 two hands on one output, 3 waits for ever, 4-5 odd
  bool wantsYes = false;     ///< the answer should be yes (a timer can come on), not no (a fault cannot happen)
  bool onlySettles = false;  ///< the answer confirms or drops what `check` has found; without that it says nothing new
  std::string_view whenNone = {};      ///< name of the question that stands, proved, where there is no occasion to ask
  std::span<const Hazard> hazards{};   ///< each instruction that may meet one is a question
  void (*program)(Asking&) = nullptr;  ///< asks about the whole program
  void (*box)(Asking&, const Instruction& box) = nullptr;  ///< asks about a timer or counter, given its first box
};

/// How answers become findings. Most of a finding stands in the question (rule_question.hpp).
struct RuleTells {
  std::string_view advice = {};  ///< what to do; stands behind how the answer was found
  std::string_view otherPlace = "the other half of the conflict";  ///< what RuleQuestion::other is called
  /// One message for several bits; `last`: the instruction that has the last word on all of them, or empty.
  std::string (*bits)(const BitRow& row, std::string_view last) = nullptr;
  /// The message if the result of a declared property is this rule's to tell.
  std::optional<std::string> (*property)(const ProofResult& result) = nullptr;
};

/// Where the answer that explains another one lies.
enum class Where : std::uint8_t {
  SamePlace,       ///< at the same instruction
  SameNetwork,     ///< anywhere in the network
  NetworkBefore,   ///< in the network before, of the same block
  SameAddress,     ///< about the same operand
  LaterInNetwork,  ///< about the same operand, further down in the same network
  NotShown,        ///< nowhere: no run was found that gives the wanted answer about the same operand
  RelatedPlace,    ///< at the place that a finding of `check` points to
  SameProperty     ///< about the same declared property
};
/// An answer that makes a finding superfluous, because it says the same or makes it untrue.
struct Explanation {
  static constexpr int any = -1;
  std::string_view rule;  ///< whose answer explains
  Where where = Where::SamePlace;
  int aspect = any;  ///< of that rule's questions (RuleQuestion::aspect)
  int of = any;      ///< of this rule's questions
};
/// Aspects of the questions about a rung's power flow (LOG001), which explain findings of several rules.
inline constexpr int powerReaches = 0, canBeWithoutPower = 1;

struct Rule {
  std::string_view id;     ///< "ADR001": three letters of the group, three digits; never reused
  std::string_view title;  ///< a few words, as in the list of rules
  Severity severity = Severity::Warning;
  Needs needs = Needs::Text;
  std::string_view detects;      ///< what the rule reports
  std::string_view why;          ///< why it matters on this controller
  std::string_view manual = {};  ///< places of the manual, "001:2677-2716, 001:13997"; empty: not in the manual text
  std::string_view bad = {};   ///< STL of a MAIN block that the rule reports, lines ended by \n; empty: `check` is null
  std::string_view good = {};  ///< the same mended; the rule is silent on it
  std::string_view exampleCpu = "226";   ///< CPU on which the examples are checked
  std::string_view exampleSymbols = {};  ///< symbol table that goes with both examples; empty: none
  std::string_view falsePositives = {};  ///< when it speaks without cause, and what to do then; empty: none known
  std::string_view peers = {};           ///< rules of other tools, "SA0005; ironplc P4025"; empty: none has it
  Dialects dialects = dialect::Every;
  FixClass fix = FixClass::None;
  bool ofLists = false;  ///< judges how a statement list is written: has no subject in a body in SCL
  bool surplus = false;  ///< speaks of what could be taken away without a change; editors show it faded
  RuleStatus status = RuleStatus::Stable;
  bool enabledByDefault = true;
  /// Its errors are those for which the editor or the CPU takes no program (table C-3, 001:13978-14008), or which the
  /// manual forbids without a word on what they do, so no command runs the network they stand in (unread_code.hpp). A
  /// check may say otherwise of one finding.
  bool refuses = false;
  /// Judges each instruction by itself and by tables: it speaks even where a heading, a declaration or a Network line
  /// could not be read, and with it which block and which network the instructions around belong to.
  bool standsAlone = false;
  std::string_view since = "0.1";
  std::span<const RuleOption> options{};
  /// Reports into the sink. Null for rules that are spoken by the tool itself (SUP, SYN) or only by the prover (Z).
  void (*check)(const Facts&, FindingSink&) = nullptr;
  RuleAsks ask{};                              ///< what the prover is asked
  RuleTells tell{};                            ///< what becomes of the answers
  std::span<const Explanation> explainedBy{};  ///< answers that make a finding of this rule superfluous

  constexpr std::string_view group() const { return id.substr(0, 3); }
  /// Whether the examples need their CPU named: another than the usual one, and a product.
  bool namesCpu() const { return exampleCpu != "226" && dialectOf(*cpuNamed(exampleCpu)).text.hasProducts; }
};

/// Whether the rule knows programs for that CPU; whoever runs rules leaves out the others.
inline bool knows(const Rule& rule, const Target& target) { return (rule.dialects & dialectOf(target).set) != 0; }

/// Every rule, sorted by file name and so by id.
std::span<const Rule* const> allRules();
/// The rule of that id (case does not matter), or nullptr.
const Rule* ruleNamed(std::string_view id);

/// The groups: the three letters and what they are about.
struct RuleGroup {
  std::string_view prefix;
  std::string_view title;
};
std::span<const RuleGroup> ruleGroups();

std::string_view severityName(Severity severity);  ///< "error", "warning", "note"
Severity severityNamed(std::string_view name);     ///< Severity::Note for any other word
std::string_view needsName(Needs needs);           ///< "T", "F", "F>Z", "Z"

/// Values of rule options that differ from their initial ones, keyed "STY002.contacts".
using RuleSettings = std::map<std::string, int, std::less<>>;

/// Block and network that contain a place.
struct ProgramPlace {
  const Pou* pou = nullptr;
  const Network* network = nullptr;
};

/// Finds block and network of a place by their spans; built once per program, then logarithmic per question.
class PlaceIndex {
 public:
  explicit PlaceIndex(const Program& program);
  ProgramPlace at(Span span) const;
  /// Fills Finding::pou and Finding::network where they are empty.
  void complete(Finding& finding) const;

 private:
  struct Entry {
    Span span;
    ProgramPlace place;
  };
  static const Entry* containing(const std::vector<Entry>& entries, Span span);
  void listNetworks(const Program& program);
  std::vector<Entry> pous_;
  /// Of programs whose networks do not stand one behind the other, each within its block; those of all others are found
  /// in Pou::networks.
  std::vector<Entry> networks_;
  bool isInOrder_ = false;
};

/// Where rules put what they found. Sets rule, severity, confirmation, block and network; the rule gives the rest.
class FindingSink {
 public:
  FindingSink(const Program& program, const RuleSettings& settings) : places_(program), settings_(settings) {}

  /// Adds a finding of the current rule; the reference stays valid until the next call. The rule may add help,
  /// related places, a fix, the address, or another severity.
  Finding& report(Span span, std::string message);
  /// The value of an option of the current rule.
  int option(std::string_view name) const;

  /// For the runner: the rule that speaks next.
  void begin(const Rule& rule) { rule_ = &rule; }
  std::vector<Finding> take();

 private:
  PlaceIndex places_;
  const RuleSettings& settings_;
  const Rule* rule_ = nullptr;
  /// Pieces of equal length, which need no second room while they grow.
  std::vector<std::vector<Finding>> pieces_;
};

}  // namespace rungproof
