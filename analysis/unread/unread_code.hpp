// Unread code: the one statement, for all commands, of what could not be read or is not legal. A network is unread when
// a line of it could not be read (SYN, GRF), when its body is in a language that is not covered, or when it breaks a
// rule for which the editor or the CPU takes no program (Rule::refuses); a called block whose instructions are not in
// the text is unread as far as no contract says what it may write (ir/s7200/call_contract.hpp). Lint reports it; no
// other command runs it, and nothing is proved that may depend on it. Tested by tests/prover/unread_test.cpp.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "analysis/property.hpp"
#include "analysis/read_errors.hpp"
#include "analysis/unread/influence.hpp"
#include "analysis/unread/statement_influence.hpp"

namespace rungproof {

/// Something that no command runs.
struct UnreadPart {
  std::string what;    ///< "MAIN, network 3" or "SBR_1"
  std::string reason;  ///< why, in the words of its finding
  Span span;
  std::vector<NetworkPlace> networks;     ///< that are left out; empty: only named
  std::vector<PlaceRow> places;           ///< what it may write, besides what its instructions write
  std::vector<std::uint32_t> dataBlocks;  ///< of which it is not known what they hold
  bool isUnlimited = false;               ///< may write anything
  bool isBounded = false;                 ///< S7-300/400: its instructions say what it may write
  bool isData = false;                    ///< what data blocks hold, not what is executed
  bool isRefused = false;                 ///< by the readers, the editor or the CPU: exit code 2
  bool isOfBlock = false;                 ///< a library block fills memory of which no text says where it lies
};

class UnreadCode {
 public:
  /// Runs the rules that refuse, whatever is selected or silenced. Of the choices Choice::MissingBlocks and
  /// Choice::HotRestart count.
  explicit UnreadCode(const Program& program, const Choices& choices = {});
  ~UnreadCode();
  UnreadCode(const UnreadCode&) = delete;
  UnreadCode& operator=(const UnreadCode&) = delete;

  const Facts& facts() const { return *facts_; }
  bool empty() const { return parts_.empty(); }
  std::span<const UnreadPart> parts() const { return parts_; }
  /// Whether a run of the rest would be the run of another program.
  bool hinderRuns() const { return !hindrance().empty(); }
  /// What of it would be missed by a run; empty: nothing.
  std::string hindrance() const;
  /// Whether the readers, the editor or the CPU refuse something: exit code 2.
  bool isRefused() const;
  /// What the rules that refuse have found, in program order; errors of the readers stand in Program::findings.
  const std::vector<Finding>& findings() const { return findings_; }
  /// Instructions in networks that are left out because of themselves.
  std::size_t instructions() const { return instructions_; }
  /// Whether anything may depend on it, so that nothing needs to be asked.
  bool isUnlimited() const { return !everything_.empty(); }

  /// The program without what is unread: the rest keeps its places and is legal. Of an S7-300/400 what depends on it is
  /// left out too: with other values it might stop the CPU, and then nothing would be asked of the rest. A protected
  /// block is called by its name there, so that what it writes comes from outside.
  Program executable() const;
  /// The program without those networks, ready to run: of an S7-300/400 their labels stay, where jumps may end, and
  /// behind them the one statement that begins a new logic string.
  Program without(std::span<const NetworkPlace> networks) const;
  /// Whether that is the program itself.
  bool isWhole() const { return parts_.empty() && !callsProtected_; }

  /// Why nothing can be said about a property, or about an instruction and what it reads, one line for each cause;
  /// empty: nothing of it depends on unread code.
  std::vector<std::string> reasons(const Property& property) const;
  std::vector<std::string> reasons(Span instruction, std::span<const Operand> operands) const;
  std::vector<std::string> reasons(const Operand& place) const;
  /// Why nothing can be said at all; empty: something can.
  std::vector<std::string> reasons() const { return everything_; }
  /// "MAIN, network 3 (press.awl:12) is not executed: ...; it may write anything".
  std::string textOf(const UnreadPart& part) const;
  /// The same, one line for each part.
  std::vector<std::string> texts() const;

 private:
  class Collector;
  std::string causeText(std::uint32_t cause) const;
  bool mayRun(NetworkPlace place) const;
  template <class Spread>
  void addParts(Spread& influence);
  std::uint32_t causeAt(const PlaceRow& row) const;
  std::uint32_t causeAt(NetworkPlace place) const;

  const Program& program_;
  std::vector<UnreadPart> parts_;
  std::vector<Finding> findings_;
  std::size_t instructions_ = 0;
  bool callsProtected_ = false;  ///< a block stands in the text, without its instructions
  std::vector<std::string> everything_;
  std::unordered_map<std::uint64_t, NetworkPlace> byPlace_;  ///< by the place of an instruction
  std::unique_ptr<const Facts> facts_;
  std::unique_ptr<const Influence> influence_;
  std::unique_ptr<const StatementInfluence> statements_;  ///< S7-300/400: in place of that
};

}  // namespace rungproof
