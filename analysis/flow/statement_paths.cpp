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

}  // namespace rungproof
