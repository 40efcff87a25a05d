// One drawing for each look of each network.
#include "frontend/simulation/scan_drawings.hpp"

#include <fmt/format.h>

#include "frontend/picture/network_view.hpp"
#include "frontend/picture/svg_picture.hpp"
#include "frontend/picture/timing_diagram.hpp"
#include "frontend/step7/source_writer.hpp"
#include "frontend/text/safe_text.hpp"
#include "ir/drawing.hpp"

namespace rungproof {

namespace {

constexpr std::size_t pageBytes = 8'000'000;  // what a browser still takes lightly

/// Everything that the drawing of a network can show of a scan.
std::string lookOf(const Network& network, const InstructionRecorder& recorder) {
  std::string look;
  for (const Instruction& instruction : network.instructions) {
    const InstructionRecord& record = recorder.of(instruction);
    if (record.executions == 0) {
      look += '-';
      continue;
    }
    const bool joins =
        instruction.desc->execution == Execution::Compare && record.before[0];  // strings are judged by the stack
    look += fmt::format("{}{}{}{}{}", joins ? 1 : 0, record.after[0] ? 1 : 0, record.scrActive ? 1 : 0,
                        record.eno ? 1 : 0, record.elementBit ? 1 : 0);
    for (std::size_t i = 0; i < record.read.size(); ++i)
      look += fmt::format(",{:x},{:x}", record.read[i].value_or(0), record.written[i].value_or(0));
  }
  return look;
}

}  // namespace

void ScanDrawings::add() {
  if (bytes_ < pageBytes) {
    std::vector<std::size_t>& pages = drawings_.pagesOf.emplace_back();
    for (const Pou& pou : program_.pous) {
      if (step7::isLibraryBlock(program_, pou)) continue;
      for (const Network& network : pou.networks) {
        if (!network.instructions.empty()) pages.push_back(draw(pou, network));
      }
    }
  }
  recorder_.beginScan(bytes_ < pageBytes);
}

std::size_t ScanDrawings::draw(const Pou& pou, const Network& network) {
  std::string look = lookOf(network, recorder_);
  const auto [place, isNew] = last_.try_emplace(&network);
  if (!isNew && place->second.look == look) return place->second.page;
  ViewOptions options;
  if (network.drawing != nullptr && network.drawing->isOfVariables) options.form = formAsRead(network);
  options.recorder = &recorder_;
  const NetworkView view = networkView(program_, pou, network, options);
  // Networks stay in program order, whatever look came first.
  const auto order = static_cast<std::size_t>(&pou - program_.pous.data()) * 10000 +
                     static_cast<std::size_t>(&network - pou.networks.data());
  drawings_.pages.push_back(fmt::format("<div class=\"drawn\" hidden style=\"order:{}\"><h3>{}, {}</h3>{}</div>\n",
                                        order, xmlText(pou.name), xmlText(view.heading), pictureSvg(view)));
  bytes_ += drawings_.pages.back().size();
  place->second = {std::move(look), drawings_.pages.size() - 1};
  return place->second.page;
}

TraceDrawings ScanDrawings::take() {
  drawings_.style = svgStyle();
  return std::move(drawings_);
}

}  // namespace rungproof
