// What the hardware configuration of a project says of the CPU of a program: the same that rungproof.toml can say.
// Tested by tests/s7project/hardware_test.cpp.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "frontend/s7project/project_files.hpp"

namespace rungproof::s7project {

/// Data sets of the CPU's parameters, by number; one that is absent was never changed.
std::map<unsigned, std::string> dataSetsOf(std::string_view chain);

struct CpuConfiguration {
  std::string name;         ///< "CPU 315-2 DP", or as the project calls it
  std::string station;      ///< name of its station; may be empty
  std::string orderNumber;  ///< "6ES7 315-2AG10-0AB0"; empty: not known
  std::string type;         ///< the CPU of cpu.hpp whose limits it has; empty: not known
  std::optional<std::uint16_t> scanLimitMs;
  std::optional<std::uint16_t> clockByte;
  struct Retention {
    std::uint16_t markers = 0, timers = 0, counters = 0;
    struct Block {
      std::uint16_t number = 0, from = 0, bytes = 0;
    };
    std::vector<Block> blocks;
  };
  std::optional<Retention> retention;
  std::map<unsigned, std::uint16_t> cyclicMs;  ///< by the number of the OB

  /// Option and value for each of these, as --clock-memory takes them.
  std::vector<std::pair<std::string, std::string>> options() const;
};

/// Takes scan limit, clock memory, retention and cyclic interrupts out of the data sets.
void applyDataSets(const std::map<unsigned, std::string>& sets, CpuConfiguration& cpu);
/// The CPU of cpu.hpp for an order number or a name; empty: not known.
std::string cpuTypeOf(std::string_view orderNumberOrName);

/// CPUs by the ID of the program that runs on them.
std::map<std::int64_t, CpuConfiguration> readHardware(const ProjectFiles& files, std::vector<std::string>& faults);

}  // namespace rungproof::s7project
