// What the S7-300 and the S7-400 are to those who ask for no particular family.
#include "ir/s7300/dialect.hpp"

#include <algorithm>

#include "ir/s7200/cpu.hpp"
#include "ir/s7300/isa.hpp"

namespace rungproof {

namespace {

constexpr std::size_t countOf(bool is400) {
  return static_cast<std::size_t>(
      std::ranges::count_if(cpu_rows::step7, [=](const Step7CpuRow& row) { return row.is400 == is400; }));
}

template <bool is400>
constexpr auto modelsOf() {
  std::array<CpuModel, countOf(is400)> models{};
  std::size_t next = 0;
  for (std::size_t i = 0; i < cpu_rows::step7.size(); ++i) {
    if (cpu_rows::step7[i].is400 == is400)
      models[next++] = {static_cast<Cpu>(firstStep7Cpu + i), cpu_rows::step7[i].name};
  }
  return models;
}

constexpr auto models300 = modelsOf<false>();
constexpr auto models400 = modelsOf<true>();
constexpr EditionModel editionModels[] = {{Edition::Step7, "step7-5.4", "STEP 7 V5.4"}};

}  // namespace

constinit const Dialect s7300Dialect{
    .name = "s7-300",
    .title = "S7-300",
    .set = dialect::S7300,
    .cpus = models300,
    .editions = editionModels,
    .usual = {step7Cpu("319-3"), Edition::Step7},
    .instructions = s7300Instructions,
    .systemBits = {},
};

constinit const Dialect s7400Dialect{
    .name = "s7-400",
    .title = "S7-400",
    .set = dialect::S7300,
    .cpus = models400,
    .editions = editionModels,
    .usual = {step7Cpu("417"), Edition::Step7},
    .instructions = s7300Instructions,
    .systemBits = {},
};

}  // namespace rungproof
