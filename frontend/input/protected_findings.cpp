// Taking out of findings what they quote.
#include "frontend/input/protected_findings.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "frontend/settings/code_list.hpp"
#include "ir/s7300/block.hpp"
#include "ir/s7300/declarations.hpp"

namespace rungproof {

bool hasHiddenCode(const Program& program) {
  return program.declarations != nullptr && !program.declarations->protectedBlocks.empty();
}

bool isCodeHidden(const Program& program, const Pou& pou) {
  return hasHiddenCode(program) && program.declarations->protectedBlocks.contains(pou.number);
}

Program withoutHiddenCode(const Program& program) {
  Program open = program;
  for (Pou& pou : open.pous) {
    if (isCodeHidden(program, pou)) pou.networks.clear();
  }
  return open;
}

void hideProtected(const Program& program, std::vector<Finding>& findings) {
  if (!hasHiddenCode(program)) return;
  const auto hiding = [&](Span span) -> const Pou* {
    const auto found = std::ranges::find_if(
        program.pous, [&](const Pou& pou) { return span.beginsIn(pou.span) && isCodeHidden(program, pou); });
    return found == program.pous.end() ? nullptr : &*found;
  };
  for (Finding& finding : findings) {
    for (RelatedPlace& related : finding.related) {
      if (const Pou* pou = hiding(related.span))
        related.message = fmt::format("in {}, which is know-how protected", blockName(pou->number));
    }
    // What stands outside of networks is the interface, which is open.
    if (hiding(finding.span) == nullptr || finding.network == 0) continue;
    const auto code = codeNamed(static_cast<std::string_view>(finding.rule));
    finding.message = fmt::format("{}; the block is know-how protected, its statements are not shown",
                                  code ? code->title : std::string_view("Finding"));
    finding.fix = Shared<Fix>();
    finding.address = ShortText();
  }
}

}  // namespace rungproof
