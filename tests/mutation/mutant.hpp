// Mutants: changes to the meaning of one instruction, made while tests run. A site is a place in the text of a meaning
// where an operation of the domain is asked for, seen from one mnemonic; a mutant is a site and one of the changes that
// its operation knows ("add": "sub", "plus 1"). Sites in files that all instructions share (isShared) also carry how
// many times the instruction has been there, so that operands and status bits are told apart (the rounds of a loop are
// not, nor what comes after the fifth visit). The campaign (campaign.cpp) collects the sites that the manual's tests
// reach, then runs those tests on each mutant.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <source_location>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ir/program.hpp"

namespace rungproof::mutation {

/// Whether a file of meanings is that of the machine, not of some instructions.
inline bool isShared(const std::string& file) {
  return file == "guarded_run.hpp" || file == "machine.hpp" || file == "args.hpp";
}

using Where = std::source_location;

/// Operations that can be changed. Whole is the instruction itself, Text its place in the program.
enum class Op : std::uint8_t {
  Constant,
  Not,
  And,
  Or,
  Xor,
  SelectBool,
  Literal,
  Add,
  Sub,
  Mul,
  UDiv,
  URem,
  SDiv,
  SRem,
  BitAnd,
  BitOr,
  BitXor,
  BitNot,
  ShiftLeft,
  ShiftRight,
  Equal,
  ULess,
  ULessEqual,
  SLess,
  SLessEqual,
  Select,
  ZeroExtend,
  SignExtend,
  Extract,
  Concat,
  Bit,
  FromBool,
  RealAdd,
  RealSub,
  RealMul,
  RealDiv,
  RealFunction,
  RealEqual,
  RealLess,
  RealLegal,
  RealFromInt,
  RealToInt,
  Load,
  Save,
  Get,
  Set,
  External,
  Report,
  Signal,
  Whole,
  Text,
  count
};
std::string_view opName(Op op);
/// Names of the changes; change k of a mutant is number k + 1 for the domain.
std::span<const std::string_view> changesOf(Op op);

struct Site {
  std::uint16_t opcode = 0;
  std::uint8_t file = 0;     ///< number given by Mutation
  std::uint8_t ordinal = 0;  ///< visit within the instruction, from 1; 0 where visits are not told apart
  std::uint16_t line = 0;
  std::uint16_t column = 0;
  Op op = Op::Whole;
  friend auto operator<=>(const Site&, const Site&) = default;
};

struct Mutant {
  Site site;
  std::uint8_t change = 1;  ///< 1 = first of changesOf
};

/// What the domain asks at every operation: which change is to be made. One per process.
class Mutation {
 public:
  static Mutation& instance();

  /// Notes the sites that are reached, by test; -1 ends it.
  void recordInto(int test) { test_ = test; }
  void activate(const Mutant& mutant) {
    active_ = mutant;
    isActive_ = true;
  }
  /// Switches the active mutant off and on, to see what the unchanged meaning does.
  void pause(bool paused) { isPaused_ = paused; }
  bool isActive() const { return isActive_; }
  /// Whether runs are compared with the unchanged meaning, and whether one of them has left another machine.
  bool comparesOutcomes = false;
  bool outcomeDiffers = false;
  const std::map<Site, std::set<int>>& sites() const { return sites_; }
  const std::string& fileName(const Site& site) const { return files_[site.file]; }
  /// The function that the site stands in: "powerFlow"; empty for Whole and Text.
  std::string_view functionName(const Site& site) const {
    const auto found = functions_.find({site.file, site.line});
    return found == functions_.end() ? std::string_view{} : found->second;
  }

  /// The machine that runs: its current instruction, its frame of local memory, and whether it is in an interrupt
  /// routine.
  struct Running {
    const Instruction* const* current = nullptr;
    const unsigned* frame = nullptr;
    const bool* inInterrupt = nullptr;
  };
  void watch(const Running& running) { running_ = running; }
  void beginInstruction() { visits_.clear(); }
  /// The timer whose time is passing outside its instruction.
  void advances(const Desc* timer) {
    timer_ = timer;
    visits_.clear();
  }

  /// 0: as the text says; k: change number k.
  int change(Op op, const Where& where);
  /// The same for the instruction as a whole.
  int changeOfWhole(Op op, const Desc& desc);

 private:
  std::uint8_t fileOf(const char* path);
  const Desc* desc() const;
  Site siteOf(Op op, const Where& where, const Desc& desc);

  int test_ = -1;
  bool isActive_ = false;
  bool isPaused_ = false;
  Mutant active_;
  Running running_;
  const Desc* timer_ = nullptr;
  std::map<Site, std::set<int>> sites_;
  std::map<Site, int> visits_;
  std::map<std::pair<std::uint8_t, std::uint16_t>, std::string> functions_;  ///< by file and line
  std::vector<std::string> files_;
  std::map<const char*, std::uint8_t> fileNumbers_;
};

}  // namespace rungproof::mutation
