// STY001: a block or network without a comment. Off by default. Tested by its examples.
#include <fmt/format.h>

#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

void checkSty001(const Facts& facts, FindingSink& sink) {
  for (const Pou& pou : facts.program().pous) {
    for (const Network& network : pou.networks) {
      if (network.instructions.empty() || !network.title.empty() || !network.comments.empty()) continue;
      sink.report(network.instructions.front().span,
                  fmt::format("network {} of {} has no comment", network.number, pou.name))
          .help = "say in one line what the network is for";
    }
  }
}

}  // namespace

extern constexpr Rule sty001_no_comment = {
    .id = "STY001",
    .title = "No comment",
    .severity = Severity::Note,
    .needs = Needs::Text,
    .detects = "a network without a title or comment",
    .why = "addresses alone do not tell what a rung is for",
    .manual = "001:2134",
    .bad = "Network 1\nLD I0.0\n= Q0.0\n",
    .good = "Network 1 // lamp follows the switch\nLD I0.0\n= Q0.0\n",
    .peers = "SA0162; C2",
    .enabledByDefault = false,
    .check = checkSty001,
};

}  // namespace rungproof
