// What IEC 61131-3 is to those who ask for no particular family.
#include "ir/iec/dialect.hpp"

#include "ir/iec/cpu.hpp"
#include "ir/iec/isa.hpp"
#include "ir/s7200/cpu.hpp"

namespace rungproof {

namespace {

constexpr auto machineModels = [] {
  std::array<CpuModel, cpu_rows::iec.size()> models{};
  for (std::size_t i = 0; i < models.size(); ++i)
    models[i] = {static_cast<Cpu>(firstIecCpu + i), cpu_rows::iec[i].name};
  return models;
}();

constexpr EditionModel standardModels[] = {{Edition::Iec, "iec-61131-3", "IEC 61131-3"}};

}  // namespace

constinit const Dialect iecDialect{
    .name = "iec",
    .title = "IEC 61131-3",
    .set = dialect::Iec,
    .cpus = machineModels,
    .editions = standardModels,
    .usual = {static_cast<Cpu>(firstIecCpu), Edition::Iec},
    .instructions = iecInstructions,
    .systemBits = {},
};

}  // namespace rungproof
