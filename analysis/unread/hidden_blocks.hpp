// Blocks without text that a program calls (ir/s7200/call_contract.hpp), as reports and proofs speak of them: which are
// in no file, what is assumed of them, and which memory they write between two scans. Tested by
// tests/smart/contract_test.cpp.
#pragma once

#include <string>
#include <vector>

#include "analysis/flow/facts.hpp"

namespace rungproof {

/// A block that no file holds and the manual does not know, described by its calls alone.
struct MissingBlock {
  std::string name;              ///< "SBR21"
  const Instruction* firstCall;  ///< in program order
  std::size_t calls = 0;
  bool isGivenNothing = false;  ///< by one of its calls: it may write anything
};
std::vector<MissingBlock> missingBlocks(const Facts& facts);
/// "SBR21 is called, but no file holds it: ..."
std::string missingText(const MissingBlock& block);

/// By block: whether it may run at all: from the main program, by calls that power may reach, or as a routine that is
/// attached where interrupts are enabled. A program without a main program is taken as a part of one.
std::vector<bool> blocksThatMayRun(const Facts& facts);
/// Whether the call may be made: its block may run, and power may reach it.
bool mayBeCalled(const Facts& facts, std::uint32_t instruction);
/// Bytes of V memory, and of SM, that called blocks write at any time.
std::vector<ExternalRange> externalsOfCalls(const Facts& facts);
/// Whether calls may rest on something that is assumed: of blocks without text, of actuals that may be copied.
bool assumesOfCalls(const Program& program);
/// What is assumed of the blocks that are called, one line each.
std::vector<std::string> assumptionsOfCalls(const Facts& facts);
/// Whether there are such calls at all.
bool restsOnContracts(const Program& program);

}  // namespace rungproof
