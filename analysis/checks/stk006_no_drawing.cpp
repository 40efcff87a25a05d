// STK006: a network that exists in STL only. What has a picture and why not is said by analysis/drawing/raise.hpp;
// a network that one of LAD and FBD can show is left alone. The older dialect knows no networks and is left out, and a
// program that is plainly kept as STL gets one line a block.
// Tested by its examples, tests/rules/stack_depth_test.cpp and tests/drawing/raise_test.cpp.
#include <fmt/format.h>

#include "analysis/drawing/editor_verdict.hpp"
#include "analysis/drawing/picture_shapes.hpp"
#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

/// Whether the program is kept as STL: a third of its networks, and at least three, hold several rungs.
bool isKeptAsStl(const Program& program) {
  const RungCount rungs = rungCount(program);
  return rungs.several >= 3 && rungs.several * 3 >= rungs.networks;
}

/// Of a program that is kept as STL each block is told once.
void checkStk006(const Facts& facts, FindingSink& sink) {
  if (facts.program().olderDialect) return;
  const bool isStl = isKeptAsStl(facts.program());
  PictureShapes pictures(facts.target());
  for (const Pou& pou : facts.program().pous) {
    std::size_t count = 0;
    std::string reason;
    Span first;
    for (const Network& network : pou.networks) {
      if (!network.complete || network.drawing != nullptr || pictures.canBeDrawn(network)) continue;
      if (++count > 1 && isStl) continue;
      const PictureShapes::Refusal refusal = pictures.refusalOf(network);
      const Span place = refusal.at == nullptr ? network.span : refusal.at->span;
      if (count == 1) {
        first = place;
        reason = refusal.reason;
      }
      if (!isStl)
        sink.report(place, fmt::format("neither LAD nor FBD can show this network: {}", refusal.reason)).help =
            "divide the network, or keep the block as STL";
    }
    if (!isStl || count == 0) continue;
    const std::string what = count == 1 ? "a network" : fmt::format("{} networks", count);
    sink.report(first, fmt::format("neither LAD nor FBD can show {} of {}{}: {}", what, pou.name,
                                   count == 1 ? "" : ", the first of them", reason))
        .help = "keep the program as STL, or divide the networks";
  }
}

}  // namespace

extern constexpr Rule stk006_no_drawing = {
    .id = "STK006",
    .title = "Cannot be shown as LAD or FBD",
    .severity = Severity::Note,
    .needs = Needs::Text,
    .detects =
        "two rungs in one network, an instruction that exists in STL only, or stack operations that no drawing has",
    .why = "a network of a drawing is one closed circuit; the editor can show such a network as STL only",
    .manual = "001:2230-2232, 001:6808-6809",
    .bad = "Network 1\nLD I0.0\n= Q0.0\nLD I0.1\n= Q0.1\n",
    .good = "Network 1\nLD I0.0\n= Q0.0\nNetwork 2\nLD I0.1\n= Q0.1\n",
    .falsePositives =
        "programs that are kept as STL on purpose: they get one note a block where a third of the networks, and at "
        "least three, hold several rungs",
    .dialects = dialect::S7200,
    .ofLists = true,
    .check = checkStk006,
};

}  // namespace rungproof
