// One pass backwards for the need of the stack, one forwards for the cuts.
#include "frontend/stl/rung_split.hpp"

#include <algorithm>
#include <iterator>

#include "ir/desc.hpp"

namespace rungproof {

namespace {

/// Instructions that stand at the left rail, alone in their network (001:2304).
bool standsAlone(Control control) {
  switch (control) {
    case Control::LabelMark:
    case Control::Next:
    case Control::Lscr:
    case Control::ScrEnd:
    case Control::Return:
    case Control::InterruptReturn:
    case Control::MainEnd: return true;
    default: return false;
  }
}

bool isOutput(const Desc& desc) {
  return desc.stack.pushes == 0 && desc.execution != Execution::Stack && desc.execution != Execution::Compare;
}

}  // namespace

std::vector<std::size_t> rungStarts(const std::vector<Instruction>& instructions) {
  std::vector<std::size_t> starts;
  if (instructions.empty()) return starts;
  std::vector<std::uint32_t> need(
      instructions.size());  // levels that instruction i and its successors take from before i
  std::uint32_t after = 0;
  for (std::size_t i = instructions.size(); i-- > 0;) {
    const StackEffect& effect = instructions[i].desc->stack;
    const std::uint32_t left = after > effect.pushes ? after - effect.pushes : 0;
    after = std::max<std::uint32_t>(effect.needs, left + effect.pops);
    after = std::min<std::uint32_t>(after, 16);
    if (standsAlone(instructions[i].desc->control)) after = 0;
    need[i] = after;
  }
  bool outputSeen = false;
  starts.push_back(0);
  for (std::size_t i = 0; i < instructions.size(); ++i) {
    const Desc& desc = *instructions[i].desc;
    const bool isLoad = desc.stack.pushes > 0 && need[i] == 0;
    if (i > 0 && outputSeen && (isLoad || standsAlone(desc.control))) {
      starts.push_back(i);
      outputSeen = false;
    }
    if (isOutput(desc)) outputSeen = true;
  }
  return starts;
}

std::vector<std::uint32_t> splitIntoRungs(Pou& pou, std::string_view text, const std::vector<std::uint32_t>& damaged) {
  std::vector<std::uint32_t> begins;
  if (pou.networks.size() != 1) return begins;
  Network whole = std::move(pou.networks[0]);
  pou.networks.clear();
  std::vector<std::size_t> starts = rungStarts(whole.instructions);
  if (starts.empty()) starts.push_back(0);
  const std::uint32_t wholeEnd = whole.span.offset + whole.span.length;
  std::size_t comment = 0;
  std::size_t damage = 0;
  std::uint32_t begin = whole.span.offset;
  for (std::size_t r = 0; r < starts.size(); ++r) {
    const bool isLast = r + 1 == starts.size();
    const std::size_t first = starts[r];
    const std::size_t last = isLast ? whole.instructions.size() : starts[r + 1];
    std::uint32_t end = wholeEnd;
    if (!isLast) {
      const Span& span = whole.instructions[last - 1].span;
      const std::size_t newline = text.find('\n', span.offset + span.length);
      end = newline == std::string_view::npos ? wholeEnd : std::min(wholeEnd, static_cast<std::uint32_t>(newline) + 1);
      end = std::min(end, whole.instructions[last].span.offset);
    }
    Network rung;
    rung.number = static_cast<int>(r) + 1;
    rung.form = whole.form;
    rung.span = {whole.span.file, begin, end - begin};
    for (; comment < whole.comments.size() && (isLast || whole.comments[comment].span.offset < end); ++comment)
      rung.comments.push_back(whole.comments[comment]);
    const std::uint32_t firstInstruction = first < last ? whole.instructions[first].span.offset : begin;
    for (; damage < damaged.size() && (isLast || damaged[damage] < end); ++damage) {
      rung.complete = false;
      if (damaged[damage] < firstInstruction && !pou.networks.empty()) pou.networks.back().complete = false;
    }
    rung.instructions.assign(std::make_move_iterator(whole.instructions.begin() + static_cast<std::ptrdiff_t>(first)),
                             std::make_move_iterator(whole.instructions.begin() + static_cast<std::ptrdiff_t>(last)));
    pou.networks.push_back(std::move(rung));
    begins.push_back(begin);
    begin = end;
  }
  return begins;
}

}  // namespace rungproof
