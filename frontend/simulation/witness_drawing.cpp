// Which networks, and the replay that lights them.
#include "frontend/simulation/witness_drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "engine/instruction_recorder.hpp"
#include "frontend/picture/network_view.hpp"
#include "frontend/simulation/witness_report.hpp"
#include "frontend/step7/source_writer.hpp"

namespace rungproof {

namespace {

constexpr std::size_t networksOnPage = 8;
constexpr std::size_t mostChanges = 4;  ///< scans with a change that are drawn as text

/// A stretch of bits of an area, or of numbers of T and C.
struct Cells {
  Area area = Area::V;
  std::uint32_t first = 0;
  std::uint32_t count = 1;

  bool overlaps(const Cells& other) const {
    return area == other.area && first < other.first + other.count && other.first < first + count;
  }
};

std::optional<Cells> touchedCells(const Instruction& instruction, std::size_t index) {
  const Operand& o = instruction.operands[index];
  if (o.kind != OperandKind::Direct || !lastsOverScans(o.area)) return std::nullopt;
  if (addressedByNumber(o.area)) return Cells{o.area, o.offset, 1};
  const Width width = operandWidth(instruction, index);
  Cells cells{o.area, o.offset * 8 + (width == Width::Bit ? o.bit : 0U), static_cast<std::uint32_t>(bits(width))};
  // S and R: N bits.
  const bool hasCount = width == Width::Bit && index == 0 && instruction.operands.size() == 2 &&
                        instruction.operands[1].kind == OperandKind::Constant;
  if (hasCount)
    cells.count = static_cast<std::uint32_t>(std::clamp<std::int64_t>(instruction.operands[1].value, 1, 255));
  return cells;
}

bool mayWrite(const Instruction& instruction, std::size_t index) {
  return index >= instruction.desc->operandCount || instruction.desc->operands[index].direction != Direction::In;
}

bool writesOneOf(const Network& network, const std::vector<Cells>& wanted) {
  for (const Instruction& instruction : network.instructions) {
    for (std::size_t i = 0; i < instruction.operands.size(); ++i) {
      if (!mayWrite(instruction, i)) continue;
      const std::optional<Cells> cells = touchedCells(instruction, i);
      if (cells && std::ranges::any_of(wanted, [&](const Cells& w) { return w.overlaps(*cells); })) return true;
    }
  }
  return false;
}

void addRead(const Network& network, std::vector<Cells>& cells) {
  for (const Instruction& instruction : network.instructions) {
    for (std::size_t i = 0; i < instruction.operands.size(); ++i) {
      if (const std::optional<Cells> c = touchedCells(instruction, i)) cells.push_back(*c);
    }
  }
}

std::vector<Cells> cellsOfProperty(const ProofResult& result) {
  std::vector<Cells> cells;
  for (const Expr* expr : {&result.property.first, &result.property.second}) {
    for (const ExprNode& node : expr->nodes) {
      const Operand& o = node.operand;
      if (node.op != ExprOp::Address || !lastsOverScans(o.area)) continue;
      if (addressedByNumber(o.area))
        cells.push_back({o.area, o.offset, 1});
      else
        cells.push_back(
            {o.area, o.offset * 8 + (o.width == Width::Bit ? o.bit : 0U), static_cast<std::uint32_t>(bits(o.width))});
    }
  }
  return cells;
}

/// What the property, or the question of a rule, speaks of beside inputs.
std::vector<Operand> askedOperands(const ProofResult& result) {
  std::vector<Operand> asked;
  const auto add = [&](const Operand& o) {
    if (o.kind == OperandKind::Direct && lastsOverScans(o.area) && !isInputArea(o.area)) asked.push_back(o);
  };
  for (const Expr* expr : {&result.property.first, &result.property.second}) {
    for (const ExprNode& node : expr->nodes) {
      if (node.op == ExprOp::Address) add(node.operand);
    }
  }
  if (result.builtin) {
    for (const Operand& operand : result.builtin->operands()) add(operand);
  }
  return asked;
}

}  // namespace

std::vector<std::pair<const Pou*, const Network*>> networksThatMatter(const Program& program,
                                                                      const ProofResult& result) {
  using Place = std::pair<const Pou*, const Network*>;
  std::vector<Place> all, chosen;
  std::vector<Cells> wanted = cellsOfProperty(result);
  for (const Pou& pou : program.pous) {
    for (const Network& network : pou.networks) {
      if (network.instructions.empty()) continue;
      all.emplace_back(&pou, &network);
      const Instruction* place = result.builtin ? result.builtin->place : nullptr;
      const bool holdsPlace = place != nullptr && place >= network.instructions.data() &&
                              place < network.instructions.data() + network.instructions.size();
      if (holdsPlace) chosen.push_back(all.back());
    }
  }
  const auto isChosen = [&](const Place& place) { return std::ranges::find(chosen, place) != chosen.end(); };
  // Round by round: who drives what is wanted; what these read is wanted next.
  for (bool grows = true; grows && chosen.size() < networksOnPage;) {
    const std::size_t before = chosen.size();
    for (const Place& place : all) {
      if (chosen.size() < networksOnPage && !isChosen(place) && writesOneOf(*place.second, wanted))
        chosen.push_back(place);
    }
    for (std::size_t i = 0; i < chosen.size(); ++i) addRead(*chosen[i].second, wanted);
    grows = chosen.size() > before;
  }
  std::erase_if(chosen, [&](const Place& place) { return step7::isLibraryBlock(program, *place.first); });
  std::ranges::sort(chosen, {}, [&](const Place& place) { return std::ranges::find(all, place) - all.begin(); });
  return chosen;
}

std::set<std::uint64_t> scansThatMatter(const Program& program, const Choices& choices, const ProofResult& result) {
  if (!result.witness) return {};
  const Witness& witness = *result.witness;
  std::vector<TraceSignal> asked;
  for (const Operand& operand : askedOperands(result)) asked.push_back(signalOf(program, operand));
  std::vector<std::uint64_t> changes;
  if (!asked.empty()) {
    std::vector<std::optional<TraceNumber>> before;
    std::uint64_t scan = 0;
    replay(program, choices, witness.scans, witness.initial ? &*witness.initial : nullptr,
           [&](const Concrete::Store& state, std::size_t) {
             std::vector<std::optional<TraceNumber>> now = sampleValues(state, asked);
             if (++scan > 1 && now != before) changes.push_back(scan);
             before = std::move(now);
             return true;
           });
  }
  const std::size_t passed = changes.size() > mostChanges ? changes.size() - mostChanges : 0;
  std::set<std::uint64_t> scans(changes.begin() + static_cast<std::ptrdiff_t>(passed), changes.end());
  scans.insert({1, witness.scanCount});
  return scans;
}

std::vector<ShownScan> shownScans(const Program& program, const Choices& choices, const ProofResult& result,
                                  const WitnessDrawingOptions& options) {
  std::vector<ShownScan> shown;
  if (!result.witness) return shown;
  const Witness& witness = *result.witness;
  const std::vector<std::pair<const Pou*, const Network*>> networks = networksThatMatter(program, result);
  InstructionRecorder recorder(program.instructionCount());
  const std::uint64_t skipped = witness.scanCount > options.lastScans ? witness.scanCount - options.lastScans : 0;
  const std::set<std::uint64_t> inText = !options.text      ? std::set<std::uint64_t>()
                                         : options.lastOnly ? std::set{witness.scanCount}
                                                            : scansThatMatter(program, choices, result);
  const auto isShown = [&](std::uint64_t number) {
    return inText.contains(number) || (options.svg && number > skipped);
  };
  std::uint64_t scan = 0, timeMs = 0;
  recorder.beginScan(isShown(1));
  ViewOptions view;
  view.form = options.form;
  view.width = options.width;
  view.recorder = &recorder;
  replay(
      program, choices, witness.scans, witness.initial ? &*witness.initial : nullptr,
      [&](const Concrete::Store&, std::size_t at) {
        timeMs += witness.scans[at].lengthMs;
        if (isShown(++scan)) {
          ShownScan& now = shown.emplace_back(ShownScan{scan, static_cast<double>(timeMs), {}});
          for (const auto& [pou, network] : networks) {
            if (options.asRead) view.form = formAsRead(*network);
            const NetworkView picture = networkView(program, *pou, *network, view);
            ShownNetwork& drawn =
                now.networks.emplace_back(ShownNetwork{fmt::format("{}, {}", pou->name, picture.heading), {}, {}});
            if (options.svg) drawn.svg = pictureSvg(picture);
            if (inText.contains(scan)) drawn.text = contentLines(picture, {});
          }
        }
        recorder.beginScan(isShown(scan + 1));
        return true;
      },
      &recorder);
  return shown;
}

}  // namespace rungproof
