// Reasons come from what no command runs (unread_code.hpp) and from the rung rule.
#include "analysis/drawing/editor_verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "analysis/drawing/levels.hpp"
#include "analysis/drawing/raise.hpp"
#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

struct RungFault {
  const Instruction* at = nullptr;  ///< nullptr: none
  std::string reason;
};

bool standsAlone(const Instruction& instruction) {
  switch (instruction.desc->control) {
    case Control::LabelMark:
    case Control::Next:
    case Control::ScrEnd:
    case Control::Lscr:
    case Control::End: return true;
    default: return false;
  }
}

bool begins(const Instruction& instruction) { return roleOf(instruction) == Role::Load; }

/// Neither a contact nor a stack operation: an output, a box, a call or a jump.
bool isOutput(const Instruction& instruction) {
  const Role role = roleOf(instruction);
  return !isLogic(role) && role != Role::Nop;
}

/// The first load that begins a second rung. The scratch that the editor itself writes for the flow inputs of a call
/// belongs to the rung of the call.
const Instruction* secondRung(const Network& network) {
  const CallIdiom idiom = callIdiomOf(network);
  int depth = 0;
  bool hasOutput = false, isBehindPop = false;
  for (std::size_t i = 0; i < network.instructions.size(); ++i) {
    const Instruction& instruction = network.instructions[i];
    const Role role = roleOf(instruction);
    if (role == Role::Lps) ++depth;
    if (role == Role::Lpp) --depth;
    const bool isScratch = i < idiom.roles.size() && idiom.roles[i] != CallRole::None;
    // Stores and recalls of the scratch, and the load of the input that is stored next, are parts of one rung.
    const bool leadsToScratch = begins(instruction) && i > 0 && i - 1 < idiom.roles.size() &&
                                idiom.roles[i - 1] != CallRole::None && idiom.roles[i - 1] != CallRole::Call;
    if (begins(instruction) && depth <= 0 && hasOutput && !isScratch && !leadsToScratch) {
      // A load behind LPP that ALD joins is a branch; where it is one, the ladder can be drawn.
      if (!isBehindPop || !raise(network, Form::Ladder).drawing) return &instruction;
    }
    hasOutput = hasOutput || isOutput(instruction);
    isBehindPop = role == Role::Lpp || (isBehindPop && isLogic(role));
  }
  return nullptr;
}

RungFault rungFault(const Network& network) {
  const std::vector<Instruction>& instructions = network.instructions;
  if (instructions.empty()) return {};
  const auto has = [&](Control control) {
    return std::ranges::any_of(instructions, [&](const Instruction& i) { return i.desc->control == control; });
  };
  if (has(Control::For) && has(Control::Next)) {
    const auto next =
        std::ranges::find_if(instructions, [](const Instruction& i) { return i.desc->control == Control::Next; });
    return {&*next, "FOR and NEXT stand in one network"};
  }
  if (std::ranges::all_of(instructions, standsAlone)) return {};
  const auto first = std::ranges::find_if_not(instructions, standsAlone);
  if (!begins(*first))
    return {&*first, fmt::format("no contact stands before {}: a rung begins with a load", Facts::text(*first))};
  if (const Instruction* second = secondRung(network))
    return {second, fmt::format("{} begins a second rung: a ladder network holds one", Facts::text(*second))};
  return {};
}

}  // namespace

std::vector<NetworkVerdict> editorVerdicts(const Program& program, const UnreadCode& unread, EditorLanguage language) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, const UnreadPart*> refused;
  for (const UnreadPart& part : unread.parts()) {
    if (!part.isRefused) continue;
    for (const NetworkPlace& place : part.networks) refused.try_emplace({place.block, place.network}, &part);
  }
  std::vector<NetworkVerdict> verdicts;
  for (std::uint32_t block = 0; block < program.pous.size(); ++block) {
    for (std::uint32_t n = 0; n < program.pous[block].networks.size(); ++n) {
      const Network& network = program.pous[block].networks[n];
      NetworkVerdict& verdict = verdicts.emplace_back();
      verdict.place = {block, n};
      verdict.span = network.span;
      if (const auto part = refused.find({block, n}); part != refused.end()) {
        verdict.reason = part->second->reason;
        verdict.span = part->second->span;
        continue;
      }
      if (!dialectOf(program.target).text.keepsFaults) continue;  // what can be read can be compiled
      if (language == EditorLanguage::Stl || network.form != Form::Stl) continue;
      RungFault fault = rungFault(network);
      if (fault.at != nullptr) {
        verdict.reason = std::move(fault.reason);
        verdict.span = fault.at->span;
        continue;
      }
      verdict.isDrawn =
          network.instructions.empty() || raise(network, Form::Ladder, program.target).drawing.has_value();
    }
  }
  return verdicts;
}

std::vector<NetworkVerdict> leaveOutInvalid(Program& program) {
  std::vector<NetworkVerdict> invalid = editorVerdicts(program, UnreadCode(program), EditorLanguage::Stl);
  std::erase_if(invalid, [](const NetworkVerdict& verdict) { return verdict.reason.empty(); });
  const PlaceIndex places(program);
  const auto isGone = [&](const Network* network) {
    return network != nullptr && std::ranges::any_of(invalid, [&](const NetworkVerdict& verdict) {
             return network == &program.pous[verdict.place.block].networks[verdict.place.network];
           });
  };
  std::erase_if(program.findings, [&](const Finding& finding) {
    return finding.network != 0 && isProgramReadError(finding) && isGone(places.at(finding.span).network);
  });
  for (const NetworkVerdict& verdict : invalid) {
    Network& network = program.pous[verdict.place.block].networks[verdict.place.network];
    network.instructions.clear();
    network.mayWrite.reset();
    network.complete = true;
  }
  program.number();
  return invalid;
}

RungCount rungCount(const Program& program) {
  RungCount count;
  for (const Pou& pou : program.pous) {
    for (const Network& network : pou.networks) {
      if (network.instructions.empty() || network.form != Form::Stl) continue;
      ++count.networks;
      count.several += secondRung(network) != nullptr ? 1U : 0U;
    }
  }
  return count;
}

bool isWrittenAsStl(const Program& program) {
  const RungCount count = rungCount(program);
  return count.several >= 3 && count.several * 2 > count.networks;
}

}  // namespace rungproof
