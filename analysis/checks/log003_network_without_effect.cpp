// LOG003: a network of which everything it writes is overwritten before anything reads it. A walk backwards through
// each block remembers what later code certainly overwrites; jumps, calls and labels forget it. Tested by its examples
// and tests/rules/output_rules_test.cpp.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <unordered_map>

#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

/// By cell: the instructions that will overwrite its bits.
using Overwrites = std::unordered_map<std::uint32_t, std::array<const Instruction*, 8>>;

/// The cells of an access, each with its first bit and the one behind its last.
template <class Visit>
void eachCell(const Facts& facts, const Access& access, Visit visit) {
  const std::uint32_t cell = facts.cellOf(access);
  if (cell == facts.index().cells().size()) return;
  const bool isBits = access.width == Width::Bit && !access.byNumber();
  std::uint32_t from = cell * 8 + (isBits ? access.bit : 0U);
  const std::uint32_t end = from + (isBits ? access.count : access.certainLength() * 8);
  for (; from < end; from = (from / 8 + 1) * 8) visit(from / 8, from % 8, std::min(end - from / 8 * 8, 8U));
}

bool isMemory(const Access& access) {
  if (access.viaPointer || access.maybe || access.isBox || access.most != access.count || access.certainLength() > 4)
    return false;
  return access.area == Area::Q || access.area == Area::M || access.area == Area::V || access.area == Area::L ||
         access.area == Area::AC;
}

/// An instruction whose only effect is to write memory, and all of it is overwritten later.
const Instruction* overwriter(const Facts& facts, const Instruction& instruction, const Overwrites& later) {
  const Role role = roleOf(instruction);
  const bool isPlain =
      (!instruction.desc->immediate && (isCoil(role) || isSet(role) || isReset(role))) || role == Role::Move;
  if (!isPlain) return nullptr;
  const Instruction* by = nullptr;
  for (const Access& access : facts.accesses().of(instruction.id)) {
    if (!access.write) continue;
    if (!isMemory(access)) return nullptr;
    bool isDead = true;
    eachCell(facts, access, [&](std::uint32_t cell, std::uint32_t bit, std::uint32_t end) {
      const auto found = later.find(cell);
      if (found == later.end()) isDead = false;
      for (; isDead && bit < end; ++bit) {
        by = found->second[bit];
        isDead = by != nullptr;
      }
    });
    if (!isDead) return nullptr;
  }
  return by;
}

void remember(const Facts& facts, const Instruction& instruction, Overwrites& later) {
  const bool isAlways = (facts.stack().at(instruction.id).flow & condition::Always) != 0;
  for (const Access& access : facts.accesses().of(instruction.id)) {
    if (!access.write || !isMemory(access) || (access.conditional && !isAlways)) continue;
    eachCell(facts, access, [&](std::uint32_t cell, std::uint32_t bit, std::uint32_t end) {
      for (auto& bits = later[cell]; bit < end; ++bit) bits[bit] = &instruction;
    });
  }
  for (const Access& access : facts.accesses().of(instruction.id)) {
    if (access.viaPointer || access.certainLength() != access.possibleLength() || access.certainLength() > 40)
      later.clear();
    else if (!access.write)
      eachCell(facts, access, [&](std::uint32_t cell, std::uint32_t bit, std::uint32_t end) {
        const auto found = later.find(cell);
        for (; found != later.end() && bit < end; ++bit) found->second[bit] = nullptr;
      });
  }
}

void checkNetworks(const Facts& facts, FindingSink& sink, const Flow& flow) {
  Overwrites later;
  std::uint32_t network = noPartner;
  bool isDead = false, hasEffect = false;
  const Instruction* first = nullptr;
  const Instruction* by = nullptr;
  const auto close = [&] {
    if (network == noPartner || !isDead || hasEffect || first == nullptr) return;
    Finding& finding =
        sink.report(first->span, "this network has no effect: everything it writes is overwritten before it is read");
    finding.related.push_back({by->span, "overwritten here"});
    finding.help = "join the conditions, or remove the network";
  };
  for (std::size_t i = flow.steps.size(); i-- > 0;) {
    const FlowStep& step = flow.steps[i];
    const Instruction& instruction = *step.instruction;
    if (step.network != network) {
      close();
      network = step.network;
      isDead = hasEffect = false;
    }
    if (instruction.desc->control != Control::None) later.clear();
    if (!isLogic(roleOf(instruction))) {
      const Instruction* overwrite = overwriter(facts, instruction, later);
      if (overwrite == nullptr)
        hasEffect = true;
      else
        by = overwrite;
      isDead = isDead || overwrite != nullptr;
    } else if (roleOf(instruction) == Role::Eu || roleOf(instruction) == Role::Ed) {
      hasEffect = true;  // the edge memory
    }
    first = &instruction;
    remember(facts, instruction, later);
  }
  close();
}

void checkLog003(const Facts& facts, FindingSink& sink) {
  const std::vector<Flow>& flows = facts.plan().flows;
  for (std::uint32_t block = 0; block < flows.size(); ++block) {
    if (!facts.hasUnreadCode(block)) checkNetworks(facts, sink, flows[block]);
  }
}

}  // namespace

extern constexpr Rule log003_network_without_effect = {
    .id = "LOG003",
    .title = "Network without effect",
    .severity = Severity::Note,
    .needs = Needs::Flow,
    .detects = "a network of which everything it writes is overwritten before it is read",
    .why = "outputs leave at the end of the scan only, so the network does nothing",
    .manual = "001:1254",
    .bad = "Network 1\nLD I0.0\n= Q0.0\nNetwork 2\nLD I0.1\n= Q0.0\n",
    .good = "Network 1\nLD I0.0\n= Q0.0\nNetwork 2\nLD I0.1\nA Q0.0\n= Q0.1\n",
    .peers = "SA0168; SA0003",
    .dialects = dialect::S7200,
    .check = checkLog003,
};

}  // namespace rungproof
