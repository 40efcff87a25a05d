// Questions to the contracts of the calls.
#include "analysis/unread/hidden_blocks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "analysis/flow/block_actuals.hpp"
#include "ir/s7300/block.hpp"
#include "ir/s7300/declarations.hpp"
#include "ir/s7300/library_contract.hpp"

namespace rungproof {

namespace {

using Source = CallContract::Source;

}  // namespace

std::vector<MissingBlock> missingBlocks(const Facts& facts) {
  std::vector<MissingBlock> blocks;
  std::map<std::string_view, std::size_t> known;
  for (const auto& [id, contract] : facts.contracts().all()) {
    if (contract.source != Source::Operands || contract.isUndefined) continue;
    const auto [found, isNew] = known.try_emplace(contract.name, blocks.size());
    if (isNew) blocks.push_back({contract.name, &facts.instruction(id)});
    MissingBlock& block = blocks[found->second];
    ++block.calls;
    block.isGivenNothing = block.isGivenNothing || contract.mayDoAnything;
  }
  return blocks;
}

std::string missingText(const MissingBlock& block) {
  const std::string times = block.calls == 1 ? "" : fmt::format(" {} times", block.calls);
  if (block.isGivenNothing)
    return fmt::format(
        "{} is called{}, but no file holds it, and a call gives it nothing to write: it may write anything", block.name,
        times);
  return fmt::format("{} is called{}, but no file holds it: what its calls give it to write may be any value",
                     block.name, times);
}

namespace {

/// Whether no power flow reaches the instruction in any scan, as behind LDN SM0.0, or no path.
bool neverActs(const Facts& facts, std::uint32_t instruction) {
  return !facts.execution().at(instruction).isReachable || (facts.conditionOf(instruction) & condition::Never) != 0;
}

}  // namespace

std::vector<bool> blocksThatMayRun(const Facts& facts) {
  const Program& program = facts.program();
  if (program.main() == nullptr || facts.dialect().run.startsBlocks) {
    std::vector<bool> all(program.pous.size(), true);
    for (std::uint32_t b = 0; program.main() != nullptr && b < all.size(); ++b)
      all[b] = program.pous[b].kind == PouKind::Main || facts.calls().reachedFromMain(b) ||
               facts.calls().reachedFromInterrupt(b);
    return all;
  }
  std::vector<bool> may(program.pous.size(), false);
  for (std::uint32_t b = 0; b < may.size(); ++b) may[b] = program.pous[b].kind == PouKind::Main;
  const std::vector<std::uint32_t> enables = facts.idsOf([](const Desc& desc) { return desc.role == Role::Eni; });
  for (bool isNew = true; isNew;) {
    isNew = false;
    const auto add = [&](std::uint32_t block) {
      if (block == noBlock || may[block]) return;
      may[block] = isNew = true;
    };
    const auto acts = [&](std::uint32_t id) { return may[facts.blockOf(id)] && !neverActs(facts, id); };
    for (const CallSite& site : facts.calls().sites()) {
      if (acts(site.instruction->id)) add(site.callee);
    }
    // What a block without text does is not known: it may enable interrupts as well.
    const bool isEnabled =
        std::ranges::any_of(enables, acts) || std::ranges::any_of(facts.contracts().all(), [&](const auto& call) {
          return call.second.mayDoAnything && acts(call.first);
        });
    for (const Attachment& attachment : facts.calls().attachments()) {
      if (isEnabled && acts(attachment.instruction->id)) add(attachment.routine);
    }
  }
  return may;
}

bool mayBeCalled(const Facts& facts, std::uint32_t instruction) {
  const bool isPart = facts.program().main() == nullptr;
  return blocksThatMayRun(facts)[facts.blockOf(instruction)] && (isPart || !neverActs(facts, instruction));
}

std::vector<ExternalRange> externalsOfCalls(const Facts& facts) {
  std::vector<ExternalRange> ranges;
  std::set<std::tuple<Area, std::uint32_t, std::uint32_t>> known;
  for (const auto& [id, contract] : facts.contracts().all()) {
    if (!mayBeCalled(facts, id)) continue;
    for (const MemoryRow& row : contract.memory) {
      // Outputs are written inside the call, by the master that the program serves there (001:10715).
      if (row.area == Area::Q || !known.emplace(row.area, row.first, row.count).second) continue;
      ranges.push_back({direct(row.area, Width::Byte, row.first / 8),
                        direct(row.area, Width::Byte, (row.first + row.count - 1) / 8),
                        {}});
    }
  }
  return ranges;
}

bool assumesOfCalls(const Program& program) {
  const bool lacksInstance = program.declarations != nullptr && !program.declarations->absentInstances.empty();
  return lacksInstance || restsOnContracts(program) || givesBlockActuals(program);
}

std::vector<std::string> assumptionsOfCalls(const Facts& facts) {
  std::vector<std::string> texts;
  const auto say = [&](std::string text) {
    if (std::ranges::find(texts, text) == texts.end()) texts.push_back(std::move(text));
  };
  const auto sayOfLibrary = [&](std::string_view name) {
    say(
        fmt::format("{} gives its outputs any value and writes nothing else of the program's but the buffers that its "
                    "parameters name",
                    name));
  };
  for (const auto& [id, contract] : facts.contracts().all()) {
    if (!mayBeCalled(facts, id) || contract.mayDoAnything) continue;
    if (contract.source == Source::Library) {
      sayOfLibrary(contract.name);
      if (contract.ownBytes > 0)
        say(fmt::format("the V memory of {} ({} bytes) is not touched by the program (library-memory names its place)",
                        contract.name, contract.ownBytes));
    } else {
      say(
          fmt::format("{}, whose text is missing, writes only what its calls give it, with any value "
                      "(missing-blocks = by-signature)",
                      contract.name));
    }
  }
  std::ranges::for_each(assumptionsOfActuals(facts), say);
  if (!facts.dialect().text.hasSystemBlocks) return texts;
  for (const std::string& name : facts.program().declarations->absentInstances)
    say(fmt::format("the instance \"{}\", which no file holds, begins with the start values of its block", name));
  const std::vector<bool> mayRun = blocksThatMayRun(facts);
  for (std::size_t block = 0; block < facts.program().pous.size(); ++block) {
    const Pou& pou = facts.program().pous[block];
    if (!mayRun[block] || !s7300::isContractOnly(pou)) continue;
    sayOfLibrary(pou.name);
    const std::string_view effect = s7300::effectOutside(pou.type, numberOfBlock(pou.number));
    if (!effect.empty()) say(fmt::format("{}: {}", pou.name, effect));
  }
  return texts;
}

bool restsOnContracts(const Program& program) {
  return std::ranges::any_of(program.pous, [](const Pou& pou) { return s7300::isContractOnly(pou); }) ||
         !CallContracts(program).empty();
}

}  // namespace rungproof
