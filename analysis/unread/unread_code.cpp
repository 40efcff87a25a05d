// Collects what is unread from the readers' findings, the rules that refuse, and calls of blocks without text.
#include "analysis/unread/unread_code.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <type_traits>

#include "analysis/lint/lint.hpp"
#include "analysis/unread/hidden_blocks.hpp"
#include "ir/block_map.hpp"
#include "ir/s7200/call_contract.hpp"
#include "ir/s7300/block.hpp"
#include "ir/s7300/coverage.hpp"
#include "ir/s7300/isa.hpp"
#include "ir/s7300/organization_block.hpp"
#include "ir/s7300/pointer_parameter.hpp"
#include "ir/s7300/statement_role.hpp"
#include "ir/subroutine_index.hpp"

namespace rungproof {

namespace {

constexpr std::string_view uncoveredBody = "SYN037";  // frontend/stl/syntax_message.hpp
constexpr std::string_view symbolRow = "SYN029";      // a name that is missed is reported where it is used
constexpr std::size_t mostTexts = 20;                 ///< lines about unread parts in a report

/// A name that no table knows, or an operand that was left open. The name of a block that has a contract needs no
/// table.
const Operand* openOperand(const Instruction& instruction, const CallContracts& contracts) {
  for (std::size_t i = 0; i < instruction.operands.size(); ++i) {
    const Operand& operand = instruction.operands[i];
    if (operand.kind != OperandKind::Symbol && operand.kind != OperandKind::Missing) continue;
    const bool mayBeLeftOut = instruction.desc->control == Control::BlockCall && i > 0;
    if (operand.kind == OperandKind::Missing && mayBeLeftOut) continue;
    const CallContract* contract = i == 0 ? contracts.of(instruction) : nullptr;
    if (contract != nullptr && !contract->isUndefined && operand.kind == OperandKind::Symbol) continue;
    return &operand;
  }
  return nullptr;
}

std::string networkName(const Pou& pou, const Network& network) {
  return fmt::format("{}, network {}", pou.name, network.number);
}

std::uint64_t keyOf(Span span) { return std::uint64_t{span.file} << 32 | span.offset; }

}  // namespace

class UnreadCode::Collector {
 public:
  Collector(const Program& program, const Facts& facts, const Choices& choices, UnreadCode& code)
      : program_(program), facts_(facts), choices_(choices), code_(code), places_(program), blocks_(program) {
    for (std::uint32_t block = 0; block < program.pous.size(); ++block) {
      const Pou& pou = program.pous[block];
      for (std::uint32_t n = 0; n < pou.networks.size(); ++n) {
        byNetwork_[&pou.networks[n]] = {block, n};
        byName_.emplace(std::pair(pou.name, pou.networks[n].number), NetworkPlace{block, n});
      }
    }
  }

  void run() {
    ofReaders();
    ofRules();
    ofOperands();
    ofUncovered();
    ofBlocks();
    if (facts_.dialect().run.startsBlocks) ofStartedBlocks();
    if (program_.declarations != nullptr) ofOpenBlocks();
  }

 private:
  /// Whether the block may run at all; a program without a main program is taken as a part of one.
  bool mayRun(std::uint32_t block) const {
    return program_.main() == nullptr || program_.pous[block].kind == PouKind::Main ||
           facts_.calls().reachedFromMain(block) || facts_.calls().reachedFromInterrupt(block);
  }

  UnreadPart& add(std::string what, std::string reason, Span span) {
    UnreadPart& part = code_.parts_.emplace_back();
    part.what = std::move(what);
    part.reason = std::move(reason);
    part.span = span;
    return part;
  }

  /// Whether that is a declaration, read but without a meaning, in a block of an S7-300/400 that never runs and of
  /// which there is no instance: it decides nothing else.
  bool isOfIdleBlock(const Finding& finding) const {
    constexpr std::string_view ofDeclarations[] = {"SYN042", "SYN043", "SYN051"};  // frontend/stl/syntax_message.cpp
    if (finding.network != 0 || std::ranges::find(ofDeclarations, finding.rule) == std::end(ofDeclarations))
      return false;
    for (std::uint32_t block = 0; facts_.dialect().memory.hasDataBlocks && block < program_.pous.size(); ++block) {
      const Pou& pou = program_.pous[block];
      if (!finding.span.beginsIn(pou.span) || (pou.type != BlockType::Fc && pou.type != BlockType::Fb)) continue;
      const auto isInstance = [&](int block7) { return pou.type == BlockType::Fb && block7 == pou.number; };
      const bool hasData = std::ranges::any_of(program_.dataBlocks, isInstance, &DataBlock::instanceOf);
      const bool isInside = std::ranges::any_of(program_.pous, [&](const Pou& other) {
        return std::ranges::any_of(other.locals, isInstance, &LocalVariable::instanceOf);
      });
      return !mayRun(block) && !hasData && !isInside;
    }
    return false;
  }

  /// Whether the statements of a network of an S7-300/400 that is not complete say what it may write.
  bool isBounded(NetworkPlace place) const {
    const Network& network = networkAt(place);
    return facts_.form() == StatementForm::Accumulators && !network.complete && network.mayWrite.has_value();
  }

  /// The part of a network, new with that reason if it has none yet.
  UnreadPart& partOf(NetworkPlace place, const std::string& reason, Span span, bool isBounded = false) {
    const auto [found, isNew] = parts_.try_emplace({place.block, place.network}, code_.parts_.size());
    if (!isNew) {
      UnreadPart& known = code_.parts_[found->second];
      known.isBounded = known.isBounded && isBounded;
      return known;
    }
    const Pou& pou = program_.pous[place.block];
    UnreadPart& part = add(networkName(pou, pou.networks[place.network]), reason, span);
    part.isBounded = isBounded;
    part.networks.push_back(place);
    return part;
  }

  const NetworkPlace* placeOf(const Finding& finding) const {
    const ProgramPlace place = places_.at(finding.span);
    const auto found = byNetwork_.find(place.network);
    // Numbers of a list may stand there twice; the elements of drawings stand mixed in their file.
    if (place.network != nullptr && place.network->form == Form::Stl && found != byNetwork_.end())
      return &found->second;
    const auto named = byName_.find({finding.pou, finding.network});
    if (finding.network != 0 && named != byName_.end()) return &named->second;
    return place.network == nullptr || found == byNetwork_.end() ? nullptr : &found->second;
  }

  /// Errors of the readers, and bodies in languages that are not covered.
  void ofReaders() {
    for (const Finding& finding : program_.findings) {
      if (!isProgramReadError(finding)) continue;
      const NetworkPlace* place = finding.network == 0 ? nullptr : placeOf(finding);
      UnreadPart& part = place != nullptr ? partOf(*place, finding.message, finding.span, isBounded(*place))
                                          : add(fileOf(finding.span), finding.message, finding.span);
      part.isRefused = true;
      part.isData = isBoundedReadError(program_, finding);
      if (part.isData) addOpenData(part, finding.span);
      if (part.isData) continue;
      const bool isOfProgram = isFrameReadError(finding) || (place == nullptr && finding.rule != symbolRow);
      part.isUnlimited = part.isUnlimited || (isOfProgram && !isOfIdleBlock(finding));
    }
    for (const Finding& finding : program_.findings) {
      const NetworkPlace* place = finding.network == 0 ? nullptr : placeOf(finding);
      if (place != nullptr && finding.severity == Severity::Warning && !networkAt(*place).complete)
        partOf(*place, finding.message, finding.span, isBounded(*place));
      if (finding.rule == uncoveredBody && finding.network == 0)
        add(finding.pou, finding.message, finding.span).isUnlimited = true;
    }
    for (const auto& [network, place] : byNetwork_) {
      if (network->complete) continue;
      UnreadPart& part = partOf(place, whyIncomplete(place), network->span, isBounded(place));
      if (!network->mayWrite) part.isUnlimited = part.isUnlimited || mayRun(place.block);
      if (!network->mayWrite || !mayRun(place.block)) continue;
      for (const Operand& operand : *network->mayWrite) part.places.push_back(rowOf(operand));
    }
    // A line was read in part: what it would do besides is not known.
    for (UnreadPart& part : code_.parts_) {
      if (!part.networks.empty() && networkAt(part.networks.front()).complete)
        part.isUnlimited = mayRun(part.networks.front().block);
    }
  }

  void ofRules() {
    std::vector<std::string> ids;
    for (const Rule* rule : allRules()) {
      if (rule->refuses) ids.emplace_back(rule->id);
    }
    code_.findings_ = runRules(facts_, RuleSelection(ids, {}), {});
    std::erase_if(code_.findings_,
                  [](const Finding& finding) { return !finding.refused || finding.severity != Severity::Error; });
    for (const Finding& finding : code_.findings_) {
      if (const NetworkPlace* place = placeOf(finding)) {
        partOf(*place, finding.message, finding.span).isRefused = true;
      } else {
        UnreadPart& part = add(fileOf(finding.span), finding.message, finding.span);
        part.isRefused = part.isUnlimited = true;
      }
    }
  }

  /// Instructions whose request goes on outside the program, in ways that are not modelled.
  void ofUncovered() {
    for (const InstructionPlace& place : facts_.instructions()) {
      const Desc& desc = *place.instruction->desc;
      if (desc.modelling == Modelling::Whole) continue;
      UnreadPart& part =
          partOf({place.block, place.network},
                 fmt::format("{} is not modelled: {}", desc.stl,
                             desc.modelling == Modelling::WritesAnything ? "a pointer names what it writes"
                                                                         : "its status changes from outside"),
                 place.instruction->span);
      const bool writesOperands = desc.modelling == Modelling::WritesOperands;
      if (!mayRun(place.block)) continue;
      part.isUnlimited = part.isUnlimited || !writesOperands;
      for (const Access& access : facts_.accesses().of(place.instruction->id)) {
        if (access.write && access.viaPointer) part.isUnlimited = true;
        if (access.write && !access.viaPointer) part.places.push_back(rowOf(access));
      }
    }
  }

  /// A name that is used twice has one finding, at its first place.
  void ofOperands() {
    for (const InstructionPlace& place : facts_.instructions()) {
      const Operand* open = openOperand(*place.instruction, facts_.contracts());
      if (open == nullptr) continue;
      const std::string reason = open->kind == OperandKind::Symbol
                                     ? fmt::format("{} is not defined", open->text)
                                     : fmt::format("an operand of {} is left open", place.instruction->desc->stl);
      const NetworkPlace network{place.block, place.network};
      partOf(network, reason, place.instruction->span, isBounded(network)).isRefused = true;
    }
  }

  /// S7-300/400: the data blocks that the finding leaves open.
  void addOpenData(UnreadPart& part, Span cause) const {
    for (const auto& [number, span] : program_.declarations->openBlocks) {
      if (span == cause) part.dataBlocks.push_back(number);
    }
    for (const s7300::OpenValue& value : program_.declarations->openValues) {
      if (value.cause != cause) continue;
      if (value.count == 0)
        part.dataBlocks.push_back(value.dataBlock);
      else
        part.places.push_back({Area::DB, dataByte(value.dataBlock, value.first) * 8, value.count * 8});
    }
    std::string names;
    for (const std::uint32_t number : part.dataBlocks)
      names += fmt::format("{}DB{}", names.empty() ? "" : ", ", number);
    for (const PlaceRow& row : part.places)
      names += fmt::format("{}{}", names.empty() ? "" : ", ", addressName(Area::DB, Width::Byte, row.first / 8));
    if (!names.empty()) part.what = names;
  }

  /// S7-300/400: networks that use data blocks of which nobody knows what stands where are no better known.
  void ofOpenBlocks() {
    const std::map<std::uint32_t, Span>& open = program_.declarations->openBlocks;
    if (open.empty()) return;
    const StatementInfluence reach(facts_);
    for (const auto& [network, place] : byNetwork_) {
      std::uint32_t number = 0;
      if (!reach.mayUse(place, open, number)) continue;
      partOf(place, fmt::format("no file says what stands in DB{}, which it may use", number), network->span, true);
    }
  }

  std::string whyIncomplete(NetworkPlace place) const {
    const bool isDeclared =
        isBounded(place) && std::ranges::none_of(networkAt(place).instructions, [&](const auto& each) {
          return openOperand(each, facts_.contracts()) != nullptr;
        });
    return isDeclared ? "not all declarations of its block are known" : "a line of it could not be read";
  }

  /// S7-300/400: blocks that the system starts, blocks without text, and what is read but not modelled. Registers are
  /// handed on over networks, so that whatever is left out may have an effect on everything.
  void ofStartedBlocks() {
    for (const Pou& pou : program_.pous) {
      if (pou.type != BlockType::Ob) continue;
      const s7300::OrganizationBlock* row = s7300::organizationBlock(numberOfBlock(pou.number));
      if (row != nullptr && (row->isModelled || !s7300::mayStart(program_, pou))) continue;
      if (pou.number == blockNumber(BlockType::Ob, 101) && choices_.is(Choice::HotRestart, "excluded")) continue;
      const std::string_view reason =
          row != nullptr ? gapReasonOf(*row) : s7300::gapReason(s7300::Gap::OrganizationBlock);
      add(blockName(pou.number), std::string(reason), pou.span).isUnlimited = true;
    }
    for (const InstructionPlace& place : facts_.instructions()) {
      const Instruction& instruction = *place.instruction;
      const std::string reason = step7Gap(instruction);
      if (reason.empty()) continue;
      const std::string text = fmt::format("{}: {}", Facts::text(instruction), reason);
      partOf({place.block, place.network}, text, instruction.span);
    }
    for (UnreadPart& part : code_.parts_) {
      for (const NetworkPlace& place : part.networks)
        part.isUnlimited = part.isUnlimited || (!part.isBounded && mayRun(place.block));
    }
  }

  /// What of an instruction is not modelled; empty: nothing.
  std::string step7Gap(const Instruction& instruction) const {
    if (hasOpaqueInstance() && reachesAnyBlock(instruction))
      return std::string(s7300::gapReason(s7300::Gap::SystemInstance));
    if (instruction.desc->control != Control::BlockCall || instruction.operands.empty()) return {};
    const Operand& block = instruction.operands[0];
    if (block.kind != OperandKind::Constant || block.value == blockNumber(BlockType::Sfc, 46)) return {};
    const int number = static_cast<int>(block.value);
    const Pou* callee = blocks_[number];
    if (number == blockNumber(BlockType::Sfc, 32) && !startsKnownBlock(instruction))
      return fmt::format("the block that it starts is in no file, or a CPU {} has no such block",
                         cpuName(program_.target.cpu));
    if (callee == nullptr) return std::string(s7300::gapReason(s7300::Gap::MissingBlock));
    if (callee->protectedBlock) return std::string(s7300::gapReason(s7300::Gap::ProtectedBlock));
    return {};
  }

  /// Whether a data block is the instance of an SFB of which nothing is known.
  bool hasOpaqueInstance() const {
    return std::ranges::any_of(program_.dataBlocks, [](const DataBlock& block) {
      return block.bytes.empty() && blockTypeOf(block.instanceOf) == BlockType::Sfb;
    });
  }
  /// Whether the data block that it uses is known when it runs only.
  bool reachesAnyBlock(const Instruction& instruction) const {
    const bool opens = statementRole(instruction) == StatementRole::OpenBlock;
    for (const Operand& operand : instruction.operands) {
      if (opens && operand.kind == OperandKind::Indirect) return true;
      if (operand.reach != nullptr && operand.reach->way == Way::Handed) return true;
    }
    if (instruction.desc->control != Control::BlockCall || instruction.operands.empty()) return false;
    const Pou* callee = instruction.operands[0].kind == OperandKind::Constant
                            ? blocks_[static_cast<int>(instruction.operands[0].value)]
                            : nullptr;
    if (callee == nullptr) return false;
    std::size_t at = hasInstance(*callee) && instruction.operands.size() > 1 ? 2 : 1;
    for (const LocalVariable& local : callee->locals) {
      if (!isParameter(local) || at >= instruction.operands.size()) break;
      const OperandKind kind = instruction.operands[at++].kind;
      if (isPointerType(local.type) && (kind == OperandKind::Direct || kind == OperandKind::Indirect)) return true;
    }
    return false;
  }

  /// Whether the organization block that SFC 32 starts is there, whichever it is: the end of a delay without one is an
  /// error of its own, and what a CPU does that has no such block is not stated.
  bool startsKnownBlock(const Instruction& call) const {
    const auto isThere = [&](int block) {
      return s7300::startsOn(block, program_.target.cpu) &&
             program_.interrupt(blockNumber(BlockType::Ob, block)) != nullptr;
    };
    if (call.operands.size() > 1 && call.operands[1].kind == OperandKind::Constant) {
      const auto block = static_cast<int>(call.operands[1].value);
      return !isDelayEvent(eventOfBlock(block)) || isThere(block);
    }
    for (int i = 0; i < static_cast<int>(delayBlockCount); ++i) {
      if (!isThere(firstDelayBlock + i)) return false;
    }
    return call.operands.size() > 1;
  }

  /// Blocks without text: who calls or attaches them runs something that nobody has read. A contract says what it may
  /// write.
  void ofBlocks() {
    const std::vector<bool> started = blocksThatMayRun(facts_);
    for (std::uint32_t block = 0; block < program_.pous.size(); ++block) {
      const Pou& pou = program_.pous[block];
      if (pou.kind != PouKind::Interrupt || !pou.protectedBlock || !started[block]) continue;
      add(pou.name, hiddenText, pou.span).isUnlimited = true;
    }
    std::set<std::string> named;
    for (const auto& [id, contract] : facts_.contracts().all()) {
      const InstructionPlace& place = facts_.place(id);
      const bool mayWriteAnything = contract.mayDoAnything || (contract.source != CallContract::Source::Library &&
                                                               choices_.is(Choice::MissingBlocks, "anything"));
      const Instruction& call = *place.instruction;
      const Pou* hidden =
          call.operands[0].kind == OperandKind::Constant ? blocks_[static_cast<int>(call.operands[0].value)] : nullptr;
      if (mayWriteAnything && hidden == nullptr && call.operands.size() == 1) {
        UnreadPart& part =
            partOf({place.block, place.network},
                   fmt::format("{} calls a subroutine that the program does not have", Facts::text(call)), call.span);
        part.isUnlimited = part.isUnlimited || mayRun(place.block);
      } else if (mayWriteAnything && mayBeCalled(facts_, id) && named.insert(contract.name).second) {
        add(contract.name, hidden != nullptr ? hiddenText : "its instructions are in no file",
            hidden != nullptr ? hidden->span : call.span)
            .isUnlimited = true;
      } else if (contract.fillsAnyV && mayBeCalled(facts_, id) && named.insert(contract.name).second) {
        UnreadPart& part = add(contract.name, "which V memory it fills stands in no text", call.span);
        part.places.push_back({Area::V, 0, areaSize(program_.target, Area::V) * 8});
        part.isOfBlock = true;
      }
    }
  }

  const Network& networkAt(NetworkPlace place) const { return program_.pous[place.block].networks[place.network]; }
  std::string fileOf(Span span) const { return std::string(program_.sources->file(span.file).name()); }

  static constexpr const char* hiddenText = "it is protected by a password: its instructions are not in the text";
  const Program& program_;
  const Facts& facts_;
  const Choices& choices_;
  UnreadCode& code_;
  PlaceIndex places_;
  const SubroutineIndex blocks_;
  std::map<const Network*, NetworkPlace> byNetwork_;
  std::map<std::pair<std::string, int>, NetworkPlace> byName_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> parts_;  ///< by network, index in code_.parts_
};

UnreadCode::UnreadCode(const Program& program, const Choices& choices)
    : program_(program), facts_(std::make_unique<const Facts>(program)) {
  Collector(program, *facts_, choices, *this).run();
  callsProtected_ = std::ranges::any_of(facts_->contracts().all(), [&](const auto& call) {
    return facts_->instruction(call.first).operands[0].kind == OperandKind::Constant;
  });
  if (parts_.empty()) return;
  for (const InstructionPlace& place : facts_->instructions())
    byPlace_[keyOf(place.instruction->span)] = {place.block, place.network};
  for (const UnreadPart& part : parts_) {
    for (const NetworkPlace place : part.networks)
      instructions_ += program.pous[place.block].networks[place.network].instructions.size();
  }
  std::uint32_t everything = Influence::none;
  if (facts_->form() == StatementForm::Accumulators) {
    auto influence = std::make_unique<StatementInfluence>(*facts_);
    addParts(*influence);
    everything = influence->everything();
    statements_ = std::move(influence);
  } else {
    auto influence = std::make_unique<Influence>(*facts_);
    addParts(*influence);
    everything = influence->everything();
    influence_ = std::move(influence);
  }
  if (everything != Influence::none) everything_.push_back(causeText(everything));
}

bool UnreadCode::mayRun(NetworkPlace place) const {
  return program_.main() == nullptr || program_.pous[place.block].kind == PouKind::Main ||
         facts_->calls().reachedFromMain(place.block) || facts_->calls().reachedFromInterrupt(place.block);
}

template <class Spread>
void UnreadCode::addParts(Spread& influence) {
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const std::uint32_t cause = static_cast<std::uint32_t>(i) + 1;
    UnreadPart& part = parts_[i];
    for (const NetworkPlace place : part.networks) {
      if (mayRun(place) && !part.isUnlimited) influence.addNetwork(place, cause);
    }
    for (const PlaceRow& row : part.places) influence.addPlace(row, cause);
    if constexpr (std::is_same_v<Spread, StatementInfluence>) {
      for (const std::uint32_t number : part.dataBlocks) influence.addDataBlock(number, cause);
    }
    if (part.isUnlimited) influence.addEverything(cause);
    part.isUnlimited = part.isUnlimited || influence.everything() == cause;
  }
  influence.spread();
}

std::uint32_t UnreadCode::causeAt(const PlaceRow& row) const {
  return statements_ != nullptr ? statements_->causeAt(row) : influence_->causeAt(row);
}

std::uint32_t UnreadCode::causeAt(NetworkPlace place) const {
  return statements_ != nullptr ? statements_->causeAt(place) : influence_->causeAt(place);
}

UnreadCode::~UnreadCode() = default;

std::string UnreadCode::hindrance() const {
  for (const UnreadPart& part : parts_) {
    // A program of another family is downloaded as a whole.
    if (statements_ == nullptr && !part.isOfBlock) return texts().front();
  }
  if (statements_ == nullptr) return {};
  if (isUnlimited()) return everything_.front();
  for (std::uint32_t block = 0; block < program_.pous.size(); ++block) {
    for (std::uint32_t network = 0; network < program_.pous[block].networks.size(); ++network) {
      const NetworkPlace place{block, network};
      const std::uint32_t cause = mayRun(place) ? causeAt(place) : Influence::none;
      if (cause != Influence::none) return textOf(parts_[cause - 1]);
    }
  }
  return {};
}

bool UnreadCode::isRefused() const {
  return std::any_of(parts_.begin(), parts_.end(), [](const UnreadPart& part) { return part.isRefused; });
}

std::string UnreadCode::causeText(std::uint32_t cause) const {
  const UnreadPart& part = parts_[cause - 1];
  const std::string place =
      fmt::format("{}:{}", program_.sources->file(part.span.file).name(), program_.sources->position(part.span).line);
  if (part.isData && !part.isUnlimited)
    return fmt::format("what {} holds is not known: {} ({})", part.what, part.reason, place);
  return fmt::format("{} is not executed and may write {}: {} ({})", part.what,
                     part.isUnlimited ? "anything" : "what this depends on", part.reason, place);
}

std::string UnreadCode::textOf(const UnreadPart& part) const {
  const std::string place =
      fmt::format("{}:{}", program_.sources->file(part.span.file).name(), program_.sources->position(part.span).line);
  if (part.isData && !part.isUnlimited)
    return fmt::format("what {} holds is not known: {} ({})", part.what, part.reason, place);
  return fmt::format("{} ({}) is not executed{}: {}", part.what, place,
                     part.isUnlimited ? " and may write anything" : "", part.reason);
}

std::vector<std::string> UnreadCode::reasons(const Property& property) const {
  if (empty() || isUnlimited()) return everything_;
  std::set<std::uint32_t> causes;
  for (const Operand* operand : addressesOf(property)) causes.insert(causeAt(rowOf(*operand)));
  causes.erase(Influence::none);
  std::vector<std::string> texts;
  for (const std::uint32_t cause : causes) texts.push_back(causeText(cause));
  return texts;
}

std::vector<std::string> UnreadCode::reasons(Span instruction, std::span<const Operand> operands) const {
  if (empty() || isUnlimited()) return everything_;
  std::set<std::uint32_t> causes;
  if (const auto place = byPlace_.find(keyOf(instruction)); place != byPlace_.end())
    causes.insert(causeAt(place->second));
  for (const Operand& operand : operands) {
    if (operand.kind == OperandKind::Direct) causes.insert(causeAt(rowOf(operand)));
  }
  causes.erase(Influence::none);
  std::vector<std::string> texts;
  for (const std::uint32_t cause : causes) texts.push_back(causeText(cause));
  return texts;
}

std::vector<std::string> UnreadCode::reasons(const Operand& place) const {
  if (empty() || isUnlimited() || place.kind != OperandKind::Direct) return everything_;
  const std::uint32_t cause = causeAt(rowOf(place));
  return cause == Influence::none ? std::vector<std::string>{} : std::vector<std::string>{causeText(cause)};
}

std::vector<std::string> UnreadCode::texts() const {
  std::vector<std::string> texts;
  for (const UnreadPart& part : parts_) {
    if (texts.size() == mostTexts) {
      texts.push_back(fmt::format("{} further places are not executed", parts_.size() - mostTexts));
      break;
    }
    texts.push_back(textOf(part));
  }
  return texts;
}

}  // namespace rungproof
