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

/// Whether the call stands in a block that may run; a program without a main program is taken as a part of one.
bool mayBeCalled(const Facts& facts, std::uint32_t instruction);
/// Bytes of V memory, and of SM, that called blocks write at any time.
std::vector<ExternalRange> externalsOfCalls(const Facts& facts);
/// What is assumed of the blocks that are called, one line each.
std::vector<std::string> assumptionsOfCalls(const Facts& facts);

}  // namespace rungproof
