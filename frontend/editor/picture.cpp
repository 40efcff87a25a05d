// Networks as drawings.
#include "frontend/editor/picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "frontend/picture/network_view.hpp"

namespace rungproof {

EditorPicture pictureOf(const CheckedDocument& document, const Pou& pou, const Network& network, Form form) {
  ViewOptions options;
  options.form = form;
  for (const Finding& finding : document.report().findings) options.findings.push_back(&finding);
  std::ranges::stable_sort(options.findings, {}, [](const Finding* finding) {
    return std::pair(finding->span.file, finding->span.offset);
  });
  std::vector<BlockView> blocks{{blockHeading(pou), {networkView(document.program(), pou, network, options)}}};
  return {fmt::format("{}, Network {}", pou.name, network.number), viewText(blocks, {}), viewSvg(blocks)};
}

}  // namespace rungproof
