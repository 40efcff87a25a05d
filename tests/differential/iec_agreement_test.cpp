// Random programs of IEC 61131-3: the transition system and the reference engine agree in every place after every scan.
// RUNGPROOF_SEED chooses other programs, RUNGPROOF_PROGRAMS how many.
#include <gtest/gtest.h>

#include <cstdlib>

#include "frontend/input/program_input.hpp"
#include "frontend/input/project.hpp"
#include "tests/differential/random_source.hpp"
#include "tests/differential/scan_agreement.hpp"
#include "tests/iec/random_block_program.hpp"
#include "tests/iec/random_chart.hpp"
#include "tests/iec/random_iec_program.hpp"
#include "tests/iec/random_library_program.hpp"
#include "tests/iec/random_list.hpp"
#include "tests/iec/random_type_program.hpp"

namespace rungproof {
namespace {

/// The inputs of the program are free.
EncoderOptions freeInputs(Program& program) {
  EncoderOptions options;
  for (const ExternalRange& range : readProperties(program, {}, lookupIn(program)).externals) {
    const bool areBits = range.first.width == Width::Bit;
    const std::uint32_t last = range.last.offset + static_cast<std::uint32_t>(bytes(range.last.width)) - 1;
    options.externals.push_back({range.first.area, range.first.offset, last,
                                 static_cast<std::uint8_t>(areBits ? range.first.bit : 0),
                                 static_cast<std::uint8_t>(areBits ? range.last.bit : 7)});
  }
  return options;
}

/// `asksForAll`: the engine asks for every value that the system takes from outside. A result that the standard leaves
/// open is such a value, and the engine asks for it only where a run comes to it.
template <class Make>
void agreeOnAll(std::uint64_t offset, int standard, int scans, Make&& make, bool asksForAll = true) {
  const char* const asked = std::getenv("RUNGPROOF_PROGRAMS");
  const int count = asked == nullptr ? standard : std::atoi(asked);
  int compared = 0, exact = 0;
  for (int i = 0; i < count; ++i) {
    const std::uint64_t seed = testSeed() + offset + static_cast<std::uint64_t>(i);
    const std::string text = make(seed);
    Program program = readText("main.st", text);
    const AgreementOutcome outcome =
        compareScans(program, seed, scans,
                     {.options = freeInputs(program), .asked = {}, .usesAllExternals = asksForAll, .seen = {}});
    ASSERT_EQ(outcome.difference, "") << "seed " << seed << "\n" << text;
    compared += outcome.scans;
    exact += outcome.isExact && outcome.scans > 0 ? 1 : 0;
  }
  std::printf("%d scans of %d programs compared\n", compared, count);
  EXPECT_GT(exact * 2, count) << "too few scans were compared";
}

TEST(IecAgreement, PlainPrograms) {
  agreeOnAll(0, 60, 40, [](std::uint64_t seed) { return iec_random::IecProgram(seed).text(); });
}

TEST(IecAgreement, AllTypes) {
  agreeOnAll(
      10000, 20, 20, [](std::uint64_t seed) { return iec_types::TypeProgram(seed, false).text(); }, false);
}

TEST(IecAgreement, TheLibrary) {
  agreeOnAll(
      15000, 30, 30, [](std::uint64_t seed) { return iec_naive::LibraryProgram(seed).text(); }, false);
}

TEST(IecAgreement, Lists) {
  agreeOnAll(20000, 40, 20, [](std::uint64_t seed) { return iec_list::RandomList(seed).text(); });
}

TEST(IecAgreement, Charts) {
  agreeOnAll(25000, 40, 30, [](std::uint64_t seed) { return iec_chart::TokenGame(seed).text(); });
}

TEST(IecAgreement, BlocksTextsAndLongTypes) {
  agreeOnAll(5000, 40, 30, [](std::uint64_t seed) { return iec_naive::BlockProgram(seed).text(); });
}

}  // namespace
}  // namespace rungproof
