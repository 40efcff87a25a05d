// Contracts of one program against blocks and contracts of the other.
#include "analysis/equivalence/hidden_blocks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "ir/s7200/call_contract.hpp"

namespace rungproof {

namespace {

/// By name: whether the manual says what the block does.
std::map<std::string, bool> hiddenCalls(const Program& program) {
  std::map<std::string, bool> names;
  const CallContracts contracts(program);
  for (const auto& [id, contract] : contracts.all())
    names[contract.name] = contract.source == CallContract::Source::Library;
  return names;
}

bool showsBlock(const Program& program, const std::string& name) {
  return std::ranges::any_of(program.pous, [&](const Pou& pou) {
    const bool isCalledSo = pou.name == name || fmt::format("SBR{}", pou.number) == name;
    return pou.kind == PouKind::Subroutine && !pou.protectedBlock && isCalledSo;
  });
}

void addReasons(const std::map<std::string, bool>& hidden, const std::map<std::string, bool>& there,
                const Program& other, const char* own, const char* others, std::vector<std::string>& reasons) {
  for (const auto& [name, isLibrary] : hidden) {
    if (showsBlock(other, name))
      reasons.push_back(fmt::format(
          "{} is called in {} without its instructions, which {} shows: whether both do the same is not known", name,
          own, others));
    else if (!isLibrary && !there.contains(name))
      reasons.push_back(fmt::format(
          "only {} calls {}, whose instructions are not in the text: what it does is not known", own, name));
  }
}

}  // namespace

std::vector<std::string> hiddenInOneOnly(const Program& before, const Program& after) {
  std::vector<std::string> reasons;
  const std::map<std::string, bool> ofOld = hiddenCalls(before), ofNew = hiddenCalls(after);
  addReasons(ofOld, ofNew, after, "OLD", "NEW", reasons);
  addReasons(ofNew, ofOld, before, "NEW", "OLD", reasons);
  return reasons;
}

}  // namespace rungproof
