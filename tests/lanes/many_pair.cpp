// Runs them scan by scan.
#include "tests/lanes/many_pair.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "ir/s7300/cpu.hpp"

namespace rungproof::test {

namespace {

/// More than one group of 64, and the last one not full.
constexpr std::size_t traceCount = 70;
/// Those that have a reference engine beside them: both ends and the middles of registers, and another group.
constexpr std::size_t refereed[] = {0, 7, 8, 19, 31, 32, 63, 69};

std::string differenceOf(const Concrete::Store& reference, const Concrete::Store& lane) {
  for (int i = 0; i < areaCount; ++i) {
    const Area area = static_cast<Area>(i);
    for (std::size_t k = 0; k < reference.area(area).size(); ++k) {
      if (reference.area(area)[k] != lane.area(area)[k])
        return fmt::format("{}B{}: {:#x}, side by side {:#x}", areaName(area), k, reference.area(area)[k],
                           lane.area(area)[k]);
    }
  }
  for (const RegInfo& info : regTable) {
    for (std::uint32_t k = 0; k < reference.count(info.reg); ++k) {
      if (reference.get(info.reg, k) != lane.get(info.reg, k))
        return fmt::format("{}[{}]: {}, side by side {}", info.name, k, reference.get(info.reg, k),
                           lane.get(info.reg, k));
    }
  }
  return {};
}

std::string errorDifference(const RunTimeErrors& reference, std::vector<std::pair<Hazard, const Instruction*>> lane) {
  for (const RunTimeError& error : reference.list()) {
    const auto found = std::ranges::find(lane, std::pair(error.hazard, error.place));
    if (found == lane.end()) return fmt::format("without the error {}", hazardInfo(error.hazard).text);
    lane.erase(found);
  }
  return lane.empty() ? "" : fmt::format("with the error {}", hazardInfo(lane.front().first).text);
}

}  // namespace

ManyOutcome runBeside(const Program& program, RandomSource& random, const ManyOptions& options) {
  ManyTraces many(program, options.engine, traceCount, options.most);
  SimulatorOptions forReference = options.engine;
  forReference.engine = EngineKind::Reference;
  std::vector<std::unique_ptr<Simulator>> references;
  for (std::size_t k = 0; k < std::size(refereed); ++k)
    references.push_back(std::make_unique<Simulator>(program, forReference));
  ManyOutcome outcome;
  outcome.hindrance = many.hindrance();
  for (; outcome.scans < options.scans; ++outcome.scans) {
    for (std::uint32_t bit = 0; bit < 32; ++bit) {
      if (!random.chance(25)) continue;
      ManyTraces::TraceSet on((traceCount + 63) / 64);
      for (std::size_t trace = 0; trace < traceCount; ++trace)
        on[trace / 64] |= static_cast<std::uint64_t>(random.below(2)) << (trace % 64);
      many.setInput(bit / 8, bit % 8, on);
      for (std::size_t k = 0; k < references.size(); ++k)
        references[k]->write(direct(Area::I, Width::Bit, bit / 8, bit % 8), lanes::contains(on, refereed[k]) ? 1 : 0);
    }
    const auto write = [&](const Operand& operand) {
      const std::size_t k = random.below(static_cast<std::uint32_t>(references.size()));
      const std::uint64_t value = random.value(operand.width == Width::Byte ? 8 : 16);
      references[k]->write(operand, value);
      many.write(refereed[k], operand, value);
    };
    const std::uint32_t firstAnalog = isStep7(program.target) ? 256 : 0;
    if (random.chance(60)) write(direct(Area::AI, Width::Word, firstAnalog + 2 * random.below(2), 0));
    if (random.chance(20)) write(direct(Area::I, Width::Byte, random.below(4), 0));
    if (options.writesMemory && random.chance(60))
      write(direct(options.words, Width::Word, options.firstByte + random.below(64), 0));
    if (options.writesMemory && random.chance(40)) write(direct(Area::M, Width::Byte, random.below(8), 0));
    const std::uint32_t lengthUs =
        options.isTight ? 200 + random.below(30000) : 1000 * (options.leastMs + random.below(20));
    many.scan(lengthUs);
    outcome.traceScans += traceCount;
    outcome.sideBySide += many.sideBySide();
    for (std::size_t k = 0; k < references.size(); ++k) {
      references[k]->scan({.lengthUs = lengthUs});
      outcome.difference = differenceOf(references[k]->store(), many.store(refereed[k]));
      if (outcome.difference.empty())
        outcome.difference = errorDifference(references[k]->errors(), many.errors(refereed[k]));
      if (outcome.difference.empty()) continue;
      outcome.difference = fmt::format("scan {}, trace {}: {}", outcome.scans + 1, refereed[k], outcome.difference);
      return outcome;
    }
  }
  return outcome;
}

}  // namespace rungproof::test
