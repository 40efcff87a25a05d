// Random programs in ST against plain C++; the generator makes both.
#include "tests/iec/iec_run.hpp"
#include "tests/iec/random_iec_program.hpp"

namespace rungproof {
namespace {

/// RUNGPROOF_IEC_PROGRAMS: how many programs, for longer runs.
TEST(IecRandom, ProgramsComputeWhatPlainCodeDoes) {
  const char* const asked = std::getenv("RUNGPROOF_IEC_PROGRAMS");
  const std::uint64_t programs = asked == nullptr ? 300 : std::strtoull(asked, nullptr, 10);
  for (std::uint64_t seed = 5100; seed < 5100 + programs; ++seed) {
    iec_random::IecProgram made(seed);
    SCOPED_TRACE(fmt::format("seed {}\n{}", seed, made.text()));
    IecRun run(made.text());
    iec_random::State state;
    for (int scan = 1; scan <= 6; ++scan) {
      for (const auto& [name, type] : made.inputs_) {
        const std::int64_t value = iec_random::wrapped(made.pick(-40000, 40000), *type);
        run.set(name, static_cast<double>(value));
        state[name] = value;
      }
      run.scan();
      made.scan(state);
      for (const auto& [name, type] : made.variables_)
        ASSERT_EQ(run.get(name), static_cast<double>(state[name])) << name << " in scan " << scan;
      for (int i = 0; i < 4; ++i) {
        const std::string element = fmt::format("a[{}]", i);
        ASSERT_EQ(run.get(element), static_cast<double>(state[element])) << element << " in scan " << scan;
      }
    }
  }
}

}  // namespace
}  // namespace rungproof
