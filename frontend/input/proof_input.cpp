// Settings become limits.
#include "frontend/input/proof_input.hpp"

#include <algorithm>

#include "analysis/proof/proof_watch.hpp"

namespace rungproof {

ProverOptions proverOptionsOf(const Settings& settings, std::initializer_list<const Program*> programs) {
  ProverOptions options;
  options.choices = settings.choices();
  options.retentive = settings.retentive();
  options.time.high = 0;
  for (const Program* program : programs)
    options.time.high =
        std::max(options.time.high, dialectOf(program->target).run.scanLimitMs(*program, options.choices));
  const bool haveInterval = std::ranges::all_of(programs, [](const Program* p) { return p->taskMs.has_value(); });
  if (haveInterval && programs.size() > 0) {
    options.time.low = options.time.high;
    for (const Program* program : programs) options.time.low = std::min(options.time.low, *program->taskMs);
  }
  if (const auto range = settings.scanTime()) {
    options.time.low = static_cast<std::uint32_t>(std::max<std::int64_t>(range->low.count() / 1000, 1));
    options.time.high =
        static_cast<std::uint32_t>(std::max<std::int64_t>(range->high.count() / 1000, options.time.low));
  }
  if (const auto timeout = settings.timeout()) options.timeout = static_cast<double>(timeout->count()) / 1e6;
  options.memory = settings.memory().value_or(usualMemoryLimit());
  options.bound = static_cast<int>(settings.number(Opt::Bound, 0));
  options.jobs = static_cast<int>(settings.number(Opt::Jobs, 2));
  options.seed = static_cast<std::uint64_t>(settings.number(Opt::Seed, 1));
  for (const std::string& name : settings.list(Opt::Without)) options.techniques.leaveOut(techniqueNamed(name)->id);
  return options;
}

ProverOptions lintProverOptionsOf(const Settings& settings, const Program& program) {
  constexpr std::uint64_t usual = 2ULL << 30;
  ProverOptions options = proverOptionsOf(settings, {&program});
  options.explains = false;
  if (!settings.memory()) options.memory = options.memory == 0 ? usual : std::min(options.memory, usual);
  if (const auto budget = settings.budget()) options.total = static_cast<double>(budget->count()) / 1e6;
  return options;
}

}  // namespace rungproof
