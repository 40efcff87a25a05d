// For each call the places that its actuals name are compared with the accesses of all blocks that run before it ends.
#include "analysis/flow/block_actuals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "analysis/flow/open_blocks.hpp"
#include "ir/block_event.hpp"
#include "ir/block_map.hpp"
#include "ir/s7300/block.hpp"

namespace rungproof {

namespace {

/// A parameter of a call whose actual has a full address in a data block.
struct BlockActual {
  const LocalVariable* formal;
  const Operand* place;
  std::uint32_t first, last;  ///< bits of the data blocks, counted as byte * 8 + bit

  bool overlaps(std::uint64_t begin, std::uint64_t end) const { return begin <= last && first <= end; }
};

std::vector<BlockActual> blockActuals(const Instruction& call, const Pou& callee) {
  std::vector<BlockActual> actuals;
  std::size_t i = 1;  // behind the name of the block
  for (const LocalVariable& local : callee.locals) {
    if (local.section == VarSection::Temp || local.section == VarSection::Static) continue;
    if (i >= call.operands.size()) break;
    const Operand& operand = call.operands[i++];
    if (!isFullAddress(operand) || local.size > 4 || local.type == DataType::BlockDb) continue;
    const bool isBit = local.size == 0;
    const std::uint32_t first = operand.offset * 8 + (isBit ? operand.bit : 0);
    actuals.push_back({&local, &operand, first, isBit ? first : first + local.size * 8 - 1});
  }
  return actuals;
}

class ActualWays {
 public:
  explicit ActualWays(const Facts& facts) : facts_(facts) {
    const std::vector<Pou>& pous = facts.program().pous;
    for (std::uint32_t b = 0; b < pous.size(); ++b) {
      if (pous[b].type == BlockType::Ob && eventOfBlock(numberOfBlock(pous[b].number)) >= 0) reach(b, interrupting_);
    }
  }

  std::vector<std::string> texts() {
    for (const CallSite& site : facts_.calls().sites()) {
      if (site.callee == noBlock || facts_.program().pous[site.callee].type != BlockType::Fc) continue;
      if (!facts_.program().pous[site.callee].isBuiltIn) addCall(site);
    }
    return std::move(texts_);
  }

 private:
  void reach(std::uint32_t block, std::set<std::uint32_t>& blocks) const {
    if (block == noBlock || !blocks.insert(block).second) return;
    for (const std::uint32_t call : facts_.calls().callsIn(block)) reach(facts_.calls().sites()[call].callee, blocks);
  }

  void addCall(const CallSite& site) {
    const Pou& callee = facts_.program().pous[site.callee];
    const std::vector<BlockActual> actuals = blockActuals(*site.instruction, callee);
    if (actuals.empty()) return;
    std::set<std::uint32_t> running;
    reach(site.callee, running);
    for (const BlockActual& actual : actuals) {
      for (const BlockActual& other : actuals) {
        const bool isWritten = actual.formal->section != VarSection::Input;
        if (&other != &actual && isWritten && actual.overlaps(other.first, other.last))
          say(callee, actual, fmt::format("#{} is given it too", other.formal->name));
      }
      addBlocks(callee, actual, running);
      addBlocks(callee, actual, interrupting_);
    }
  }

  void addBlocks(const Pou& callee, const BlockActual& actual, const std::set<std::uint32_t>& blocks) {
    for (const std::uint32_t block : blocks) {
      for (const FlowStep& step : facts_.plan().flows[block].steps) {
        if (!reaches(*step.instruction, actual)) continue;
        say(callee, actual, fmt::format("{} reaches it by another way", facts_.program().pous[block].name));
        break;
      }
    }
  }

  bool reaches(const Instruction& instruction, const BlockActual& actual) const {
    return std::ranges::any_of(facts_.accesses().of(instruction.id), [&](const Access& access) {
      const bool changesSomething = access.write || access.maybe || actual.formal->section != VarSection::Input;
      if (!changesSomething) return false;
      if (access.viaPointer) {
        const bool isOfBlocks = access.pointed == Pointed::Anywhere || access.area == Area::DB;
        return access.pointed != Pointed::OfCall && isOfBlocks;
      }
      if (access.area != Area::DB || access.possibleLength() == 0) return false;
      const bool isBit = access.width == Width::Bit;
      const std::uint64_t first = std::uint64_t{access.offset} * 8 + (isBit ? access.bit : 0U);
      return actual.overlaps(first, isBit ? first + access.most - 1 : first + access.possibleLength() * 8 - 1);
    });
  }

  void say(const Pou& callee, const BlockActual& actual, const std::string& way) {
    std::string text =
        fmt::format("{} works on {} in place and not on a copy ({})", callee.name, toString(*actual.place), way);
    if (std::ranges::find(texts_, text) == texts_.end()) texts_.push_back(std::move(text));
  }

  const Facts& facts_;
  std::set<std::uint32_t> interrupting_;  ///< blocks that may run inside others
  std::vector<std::string> texts_;
};

}  // namespace

bool givesBlockActuals(const Program& program) {
  for (const Pou& pou : program.pous) {
    for (const Network& network : pou.networks) {
      for (const Instruction& one : network.instructions) {
        if (one.desc->control == Control::BlockCall && std::ranges::any_of(one.operands, isFullAddress)) return true;
      }
    }
  }
  return false;
}

std::vector<std::string> assumptionsOfActuals(const Facts& facts) {
  return facts.dialect().memory.hasDataBlocks ? ActualWays(facts).texts() : std::vector<std::string>{};
}

}  // namespace rungproof
