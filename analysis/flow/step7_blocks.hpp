// The blocks of an S7-300/400 program that its own text states: rules speak about these, not about the statement lists
// that stand for blocks of the CPU and the libraries. Tested by tests/rules/nesting_rules_test.cpp.
#pragma once

#include "analysis/flow/facts.hpp"

namespace rungproof {

/// Whether the block is one of the CPU or a library, read from a text of this program (ir/s7300/library.hpp).
bool isLibraryText(const Program& program, const Pou& pou);
/// Whether the block may run more than once between two runs of OB1: called at two places that a run can pass both, in
/// a loop, or by a block that does so. Calls in start-ups do not count.
bool mayRunTwice(const Facts& facts, std::uint32_t block);
/// The same for two statements of the program: whether one scan may run both.
bool mayRunInOneScan(const Facts& facts, std::uint32_t a, std::uint32_t b);
/// What tells the place of a bit from others: places with equal texts are one. Those of parameters by reference and of
/// pointers are empty.
std::string placeKey(const Facts& facts, std::uint32_t block, const Operand& operand);
/// "network 3 of FC5".
std::string networkText(const Facts& facts, std::uint32_t instruction);

/// The networks of the block that could be read, as flows: all of them as one, or rows of them between those that could
/// not. A row that jumps join with the rest is left out. What stands in front of a row may be anything.
std::vector<Flow> readStretches(const Facts& facts, std::uint32_t block);

/// Calls visit(block, flow) for all that could be read of the program's own blocks: for rules that judge statements by
/// those in front of them, and take nothing from what they do not see.
template <class Visit>
void eachReadStretch(const Facts& facts, Visit&& visit) {
  for (std::uint32_t block = 0; block < facts.program().pous.size(); ++block) {
    if (facts.program().pous[block].protectedBlock || isLibraryText(facts.program(), facts.program().pous[block]))
      continue;
    if (!facts.hasUnreadCode(block)) {
      if (!facts.plan().flows[block].steps.empty()) visit(block, facts.plan().flows[block]);
      continue;
    }
    for (const Flow& flow : readStretches(facts, block)) visit(block, flow);
  }
}

/// Calls visit(block, flow) for every block of the program's own that could be read in full.
template <class Visit>
void eachOwnBlock(const Facts& facts, Visit&& visit) {
  for (std::uint32_t block = 0; block < facts.program().pous.size(); ++block) {
    const Pou& pou = facts.program().pous[block];
    const Flow& flow = facts.plan().flows[block];
    if (pou.protectedBlock || flow.steps.empty() || facts.hasUnreadCode(block) || isLibraryText(facts.program(), pou))
      continue;
    visit(block, flow);
  }
}

}  // namespace rungproof
