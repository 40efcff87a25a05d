// What the S7-200 is to those who ask for no particular family.
#include "ir/s7200/dialect.hpp"

#include "ir/s7200/cpu.hpp"
#include "ir/s7200/isa.hpp"
#include "ir/s7200/special_memory.hpp"

namespace rungproof {

namespace {

constexpr auto cpuModels = [] {
  std::array<CpuModel, cpuCount> models{};
  for (std::size_t i = 0; i < cpuCount; ++i) models[i] = {static_cast<Cpu>(i), cpu_rows::rows[i].name};
  return models;
}();

constexpr EditionModel editionModels[] = {
    {Edition::Edition2003, "2003", "2003 edition of the manual"},
    {Edition::Edition2004, "2004", "2004 edition of the manual"},
    {Edition::Smart27, "smart-2.7", "S7-200 SMART, firmware up to V2.7"},
    {Edition::Smart28, "smart-2.8", "S7-200 SMART, firmware from V2.8 on"},
};

}  // namespace

constinit const Dialect s7200Dialect{
    .name = "s7-200",
    .title = "S7-200",
    .set = dialect::S7200,
    .cpus = cpuModels,
    .editions = editionModels,
    .usual = {s7200Cpu("226"), Edition::Edition2004},
    .instructions = s7200Instructions,
    .systemBits = s7200SystemBits,
};

}  // namespace rungproof
