// Looks along the paths.
#include "analysis/flow/statement_paths.hpp"

namespace rungproof {

bool isPath(const Flow& flow, std::uint32_t from, std::uint32_t to) {
  const std::size_t end = flow.steps.size();
  std::vector<std::uint8_t> seen(end + 1, 0);
  std::vector<std::uint32_t> open{from};
  while (!open.empty()) {
    const std::uint32_t at = open.back();
    open.pop_back();
    bool isFound = false;
    eachNext(flow, at, [&](std::uint32_t next) {
      isFound = isFound || next == to;
      if (next >= end || seen[next] != 0) return;
      seen[next] = 1;
      open.push_back(next);
    });
    if (isFound) return true;
  }
  return false;
}

namespace {

bool loadsAccu(const Instruction& instruction) {
  return statementRole(instruction) == StatementRole::Load || loadsElement(instruction);
}

}  // namespace

LoadsBefore loadsBefore(const Flow& flow, std::uint32_t at) {
  LoadsBefore loads;
  while (at-- > 0) {
    const Instruction& instruction = *flow.steps[at].instruction;
    if (loadsAccu(instruction)) {
      if (loads.accu1 != nullptr) {
        loads.accu2 = &instruction;
        return loads;
      }
      loads.accu1 = &instruction;
    } else if (!keepsAccus(statementRole(instruction))) {
      return loads;
    }
  }
  return loads;
}

bool asksOverflowBehind(const Flow& flow, std::uint32_t at) {
  constexpr std::uint32_t reach = 5;
  for (std::uint32_t next = at + 1; next < flow.steps.size() && next <= at + reach; ++next) {
    if (asksOverflow(*flow.steps[next].instruction)) return true;
  }
  return false;
}

bool isComparedBefore(const Flow& flow, std::uint32_t until, const Operand& operand) {
  const std::string name = toString(operand);
  for (std::uint32_t at = 0; at < until; ++at) {
    if (!isComparison(statementRole(*flow.steps[at].instruction))) continue;
    const LoadsBefore loads = loadsBefore(flow, at);
    for (const Instruction* load : {loads.accu1, loads.accu2}) {
      if (load != nullptr && toString(load->operands[0]) == name) return true;
    }
  }
  return false;
}

}  // namespace rungproof
