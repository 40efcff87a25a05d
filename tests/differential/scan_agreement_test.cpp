// The transition system and the reference engine, on random programs: the same inputs, times and external values lead
// to the same state after every scan, in every place that the program touches. A failing program is shrunk before it
// is shown. The same holds in the places of a cone of influence where nothing but that cone is encoded: the engine runs
// the whole program. RUNGPROOF_SEED chooses other programs, RUNGPROOF_PROGRAMS how many.
#include "tests/differential/scan_agreement.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "analysis/unread/cone_of_influence.hpp"
#include "ir/s7200/cpu.hpp"
#include "tests/differential/program_generator.hpp"

namespace rungproof {
namespace {

/// One network for each rung: where the instructions so far have used up what they loaded.
Program inNetworks(Program program) {
  for (Pou& pou : program.pous) {
    const std::vector<Instruction> all = std::move(pou.networks[0].instructions);
    pou.networks.assign(1, {});
    int level = 0;
    for (const Instruction& instruction : all) {
      const StackEffect& effect = instruction.desc->stack;
      const bool isLoad = effect.needs == 0 && effect.pushes > effect.pops;
      if (isLoad && level <= 1 && !pou.networks.back().instructions.empty()) {
        pou.networks.emplace_back();
        level = 0;
      }
      level += effect.pushes - effect.pops;
      pou.networks.back().instructions.push_back(instruction);
    }
  }
  program.number();
  return program;
}

/// One or two places that the program writes.
std::vector<Access> someWritten(const Facts& facts, RandomSource& random) {
  std::vector<Access> written, chosen;
  for (const Access& access : facts.accesses().all()) {
    const bool isMemory = access.area == Area::Q || access.area == Area::M || access.area == Area::V;
    if (access.write && !access.viaPointer && (isMemory || access.area == Area::T || access.area == Area::C))
      written.push_back(access);
  }
  for (int i = random.chance(50) ? 1 : 2; i > 0 && !written.empty(); --i) chosen.push_back(random.oneOf(written));
  return chosen;
}

Place placeOf(const Access& access) {
  if (access.area == Area::T) return registerPlace(Reg::TimerCurrent, access.offset);
  if (access.area == Area::C) return registerPlace(Reg::CounterCurrent, access.offset);
  return memoryPlace(access.area, access.offset, access.width, access.bit);
}

enum class Part : std::uint8_t { Whole, Cone };

AgreementOutcome compare(const RandomProgram& random, std::uint64_t seed, int scanCount, const EncoderOptions& whole,
                         Part part) {
  const Program program = inNetworks(random.program());
  EncoderOptions options = whole;
  std::vector<Place> asked;
  if (part == Part::Cone) {
    const Facts facts(program);
    RandomSource choice(seed);
    std::vector<PlaceRow> rows;
    for (const Access& access : someWritten(facts, choice)) {
      asked.push_back(placeOf(access));
      rows.push_back(rowOf(access.area, access.width, access.offset, access.bit));
    }
    options.isLeftOut = outsideCone(facts, rows);
    if (std::ranges::count(options.isLeftOut, true) == 0) {
      AgreementOutcome nothing;
      nothing.isWhole = true;
      return nothing;
    }
  }
  return compareScans(program, seed, scanCount, {.options = options, .asked = asked});
}

RandomProgram shrunk(RandomProgram program, std::uint64_t seed, int scans, const EncoderOptions& options, Part part) {
  for (std::size_t i = program.size(); i-- > 0;) {
    const RandomProgram smaller = program.without(i);
    if (!compare(smaller, seed, scans, options, part).difference.empty()) program = smaller;
  }
  return program;
}

int programCount(int standard) {
  const char* given = std::getenv("RUNGPROOF_PROGRAMS");
  return given == nullptr ? standard : std::atoi(given);
}

void runAll(const GeneratorOptions& generator, const EncoderOptions& options, int programs, int scans,
            std::uint64_t offset, Part part = Part::Whole) {
  int total = 0, exact = 0, compared = 0;
  programs = programCount(programs);
  for (int i = 0; compared < programs; ++i) {
    ASSERT_LT(i, 100 * programs) << "too few programs have anything outside the cone";
    const std::uint64_t seed = testSeed() + offset + static_cast<std::uint64_t>(i);
    RandomSource random(seed);
    const RandomProgram program = randomProgram(random, generator);
    const AgreementOutcome outcome = compare(program, seed, scans, options, part);
    if (outcome.isWhole) continue;
    ++compared;
    total += outcome.scans;
    exact += outcome.isExact ? 1 : 0;
    if (outcome.difference.empty()) continue;
    const RandomProgram small = shrunk(program, seed, scans, options, part);
    FAIL() << "seed " << seed << "\n" << small.text() << compare(small, seed, scans, options, part).difference;
  }
  std::printf("%d scans of %d programs compared, %d programs not exact\n", total, programs, programs - exact);
  EXPECT_GT(exact * 2, programs) << "too many programs were approximated";
}

/// Memory that starts with any value: nothing is constant, so instructions meet all kinds of operands.
EncoderOptions anyMemory() {
  EncoderOptions options;
  options.initialRetentive = true;
  options.retentive = {{Area::V, 0, 0xFFFFFFFF}, {Area::M, 0, 31}, {Area::T, 0, 255}, {Area::C, 0, 255}};
  return options;
}

TEST(ScanAgreement, PlainPrograms) {
  runAll({.rungs = 8, .jumps = false, .loops = false, .subroutines = false}, anyMemory(), 120, 60, 0);
}

TEST(ScanAgreement, ControlFlow) { runAll({.rungs = 7}, anyMemory(), 30, 60, 10000); }

TEST(ScanAgreement, FromPowerUp) { runAll({.rungs = 7}, {}, 40, 60, 20000); }

TEST(ScanAgreement, FixedScanTime) {
  EncoderOptions options = anyMemory();
  options.time = {13, 13, false};
  runAll({.rungs = 6, .loops = false}, options, 40, 60, 30000);
}

TEST(ScanAgreement, Interrupts) {
  runAll({.rungs = 5, .loops = false, .subroutines = false, .interrupts = true}, anyMemory(), 15, 60, 40000);
}

TEST(ScanAgreement, Pointers) {
  runAll({.rungs = 6, .loops = false, .subroutines = false, .pointers = true}, {}, 40, 60, 50000);
}

constexpr Target smartTarget{s7200Cpu("ST60"), Edition::Smart28};

TEST(ScanAgreement, SmartPrograms) {
  runAll({.rungs = 8, .loops = false, .target = smartTarget}, anyMemory(), 60, 60, 90000);
}

TEST(ScanAgreement, SmartFromPowerUp) {
  runAll({.rungs = 8, .pointers = true, .target = smartTarget}, {}, 40, 60, 91000);
}

TEST(ScanAgreement, SmartInterrupts) {
  runAll({.rungs = 5, .loops = false, .subroutines = false, .interrupts = true, .target = smartTarget}, anyMemory(), 12,
         60, 92000);
}

TEST(ScanAgreement, ConeOfInfluence) {
  runAll({.rungs = 10, .jumps = false, .loops = false, .subroutines = false}, anyMemory(), 60, 60, 60000, Part::Cone);
}

TEST(ScanAgreement, ConeOfInfluenceUnderControlFlow) {
  runAll({.rungs = 10, .loops = false}, {}, 40, 60, 70000, Part::Cone);
}

TEST(ScanAgreement, ConeOfInfluenceUnderInterrupts) {
  runAll({.rungs = 8, .loops = false, .subroutines = false, .interrupts = true}, {}, 10, 60, 80000, Part::Cone);
}

}  // namespace
}  // namespace rungproof
