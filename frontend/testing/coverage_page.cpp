// Each network as it is drawn, and below it its contacts, coils and conditions with their colours.
#include "frontend/testing/coverage_page.hpp"

#include <fmt/format.h>

#include <map>

#include "frontend/picture/network_view.hpp"
#include "frontend/testing/table_run.hpp"
#include "frontend/text/safe_text.hpp"

namespace rungproof {

namespace {

constexpr std::string_view seenColor = "#bfe3c4", unseenColor = "#f3b8b0";

std::string colored(std::string_view text, bool isSeen) {
  return fmt::format("<span style=\"background:{};padding:0 .4em;border:1px solid #888\" title=\"{}\">{}</span>",
                     isSeen ? seenColor : unseenColor, isSeen ? "seen" : "not seen", xmlText(text));
}

}  // namespace

std::string networkAnchor(CoveragePlace place) { return fmt::format("n{}-{}", place.pou, place.network); }

std::string coverageDrawings(const CoverageRecorder& recorder) {
  const CoverageMap& map = recorder.map();
  struct Lines {
    std::string contacts, outputs;
    bool isReached = true;
  };
  std::map<std::pair<std::uint32_t, std::uint32_t>, Lines> networks;
  const auto at = [&](CoveragePlace place) -> Lines& { return networks[{place.pou, place.network}]; };
  for (std::size_t i = 0; i < map.networks().size(); ++i) at(map.networks()[i]).isReached = recorder.networkReached(i);
  for (std::uint32_t leaf = 0; leaf < map.leaves().size(); ++leaf) {
    const CoverageLeaf& contact = map.leaves()[leaf];
    if (contact.kind != LeafKind::Contact) continue;
    at(contact.place).contacts +=
        fmt::format("<li>{} {}{}</li>\n", xmlText(map.instructionText(*contact.instruction)),
                    colored("1", recorder.contactSeen(leaf, true)), colored("0", recorder.contactSeen(leaf, false)));
  }
  for (std::size_t d = 0; d < map.decisions().size(); ++d) {
    const Decision& decision = map.decisions()[d];
    std::string line;
    for (std::size_t i = 0; i < decision.leaves.size(); ++i) {
      const CoverageLeaf& leaf = map.leaves()[decision.leaves[i]];
      if (leaf.kind != LeafKind::Contact) continue;
      const PairState pair = recorder.pair(d, i);
      line += " " + colored(map.instructionText(*leaf.instruction), pair != PairState::None);
    }
    at(decision.place).outputs +=
        fmt::format("<li>{}: decided by{}</li>\n", xmlText(map.instructionText(*decision.instruction)), line);
  }
  std::string text = fmt::format(
      "<h2>Networks</h2>\n<p>{} seen, {} not seen. A contact has one colour for its bit as "
      "1 (in a drawing its left half) and one as 0; a condition of a coil or box is seen when it alone decided the "
      "outcome, as 1 and as 0.</p>\n",
      colored(" ", true), colored(" ", false));
  for (const auto& [place, lines] : networks) {
    const Pou& pou = map.program().pous[place.first];
    const Network& network = pou.networks[place.second];
    ViewOptions options;
    options.seen = [&](const Instruction& instruction) -> std::optional<std::pair<bool, bool>> {
      const int leaf = map.leafOf(instruction.id);
      if (leaf < 0 || map.leaves()[static_cast<std::size_t>(leaf)].kind != LeafKind::Contact) return std::nullopt;
      const auto number = static_cast<std::size_t>(leaf);
      return std::pair(recorder.contactSeen(number, true), recorder.contactSeen(number, false));
    };
    const NetworkView view = networkView(map.program(), pou, network, options);
    text += fmt::format("<div class=\"drawn\" id=\"{}\"><h3>{}, {} {}</h3>{}<ul>{}{}</ul></div>\n",
                        xmlText(networkAnchor({place.first, place.second})), xmlText(pou.name), xmlText(view.heading),
                        colored(lines.isReached ? "power reached it" : "no power reached it", lines.isReached),
                        pictureSvg(view), lines.contacts, lines.outputs);
  }
  return text;
}

}  // namespace rungproof
