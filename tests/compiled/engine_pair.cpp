// Runs the pair scan by scan.
#include "tests/compiled/engine_pair.hpp"

#include <fmt/format.h>

#include "ir/s7300/cpu.hpp"

namespace rungproof::test {

namespace {

Operand place(Area area, Width width, std::uint32_t byte) { return direct(area, width, byte, 0); }

/// Gives nothing.
struct SilentOutside final : Outside {
  std::uint64_t external(const ExternalSite&, int) override { return 0; }
  void report(Hazard, const Instruction*) override {}
};

}  // namespace

std::string firstDifference(const Simulator& reference, const Simulator& compiled) {
  const Concrete::Store &a = reference.store(), &b = compiled.store();
  for (int i = 0; i < areaCount; ++i) {
    const Area area = static_cast<Area>(i);
    for (std::size_t k = 0; k < a.area(area).size(); ++k) {
      if (a.area(area)[k] != b.area(area)[k])
        return fmt::format("{}B{}: {:#x}, compiled {:#x}", areaName(area), k, a.area(area)[k], b.area(area)[k]);
    }
  }
  for (const RegInfo& info : regTable) {
    for (std::uint32_t k = 0; k < a.count(info.reg); ++k) {
      if (a.get(info.reg, k) != b.get(info.reg, k))
        return fmt::format("{}[{}]: {}, compiled {}", info.name, k, a.get(info.reg, k), b.get(info.reg, k));
    }
  }
  if (reference.timeUs() != compiled.timeUs())
    return fmt::format("time {}, compiled {}", reference.timeUs(), compiled.timeUs());
  const auto &errors = reference.errors().list(), &others = compiled.errors().list();
  if (errors.size() != others.size()) return fmt::format("{} errors, compiled {}", errors.size(), others.size());
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const RunTimeError &e = errors[i], &o = others[i];
    if (e.hazard != o.hazard || e.place != o.place || e.scan != o.scan || e.timeUs != o.timeUs || e.count != o.count)
      return fmt::format("error {}: {} in scan {} at {}, {} times; compiled {} in scan {} at {}, {} times", i,
                         hazardInfo(e.hazard).text, e.scan, e.timeUs, e.count, hazardInfo(o.hazard).text, o.scan,
                         o.timeUs, o.count);
  }
  return {};
}

PairOutcome runBoth(const Program& program, RandomSource& random, const PairOptions& options) {
  SimulatorOptions forReference = options.engine, forCompiled = options.engine;
  forReference.engine = EngineKind::Reference;
  forCompiled.engine = EngineKind::Compiled;
  SilentOutside silent;
  Outside* outside = options.isScripted ? &silent : nullptr;
  Simulator reference(program, forReference, outside), compiled(program, forCompiled, outside);
  if (options.isScripted) {
    reference.readUnknownAsZero(true);
    compiled.readUnknownAsZero(true);
    compiled.expectFreeZero();
  }
  const ScanScript quiet;
  ScanScript watchful;
  watchful.events.push_back({{ScanPlace::startOfScan - 1, 0}, 0});
  PairOutcome outcome;
  for (; outcome.scans < options.scans; ++outcome.scans) {
    const auto write = [&](const Operand& operand, std::uint64_t value) {
      reference.write(operand, value);
      compiled.write(operand, value);
    };
    for (std::uint32_t byte = 0; byte < 4; ++byte) {
      if (random.chance(40)) write(place(Area::I, Width::Byte, byte), random.below(256));
    }
    const std::uint32_t firstAnalog = isStep7(program.target) ? 256 : 0;
    if (random.chance(30)) write(place(Area::AI, Width::Word, firstAnalog + 2 * random.below(2)), random.value(16));
    if (options.writesMemory && random.chance(20))
      write(place(options.words, Width::Word, options.firstByte + random.below(64)), random.value(16));
    if (options.writesMemory && random.chance(20)) write(place(Area::M, Width::Byte, random.below(8)), random.value(8));
    ScanRequest request;
    request.lengthUs = random.chance(50) ? 10000 : 200 + random.below(options.longestUs);
    if (options.isScripted) request.lengthUs = (1 + request.lengthUs / 1000) * 1000;
    request.script = options.isScripted ? &watchful : nullptr;
    reference.scan(request);
    if (options.isScripted) request.script = &quiet;
    compiled.scan(request);
    outcome.difference = firstDifference(reference, compiled);
    if (!outcome.difference.empty()) {
      outcome.difference = fmt::format("scan {}: {}", outcome.scans + 1, outcome.difference);
      break;
    }
    if (!reference.isRunning()) {
      reference.run();
      compiled.run();
    }
  }
  outcome.compiled = compiled.compiledScans();
  return outcome;
}

}  // namespace rungproof::test
