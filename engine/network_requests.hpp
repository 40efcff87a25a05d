// NETR, NETW, GET and PUT as a device: a request ends at the end of the scan after the one that made it, without error
// unless the stimulus gives one; the answer of NETR is whatever the stimulus writes into the table (001:3022-3131),
// that of GET what it writes into the own data. The manual gives no time. Covered by tests/engine/device_test.cpp.
#pragma once

#include <array>
#include <cstdint>

#include "engine/concrete.hpp"
#include "ir/s7200/device_end.hpp"

namespace rungproof {

class NetworkRequests {
 public:
  /// Error code 0..15 of requests that end from now on (001:3052-3065).
  void setError(std::uint8_t code) { error_ = code; }
  /// While held, no request ends.
  void setHeld(bool held) { isHeld_ = held; }

  void started(std::uint32_t entry) { age_[entry] = 0; }
  /// End of a scan.
  void endScan(Machine<Concrete>& machine) {
    Concrete::Store& store = machine.store;
    for (std::uint32_t entry = 0; entry < age_.size(); ++entry) {
      const auto table = static_cast<std::uint32_t>(store.get(Reg::NetTable, entry));
      if (table == 0 || isHeld_ || age_[entry]++ == 0) continue;
      const auto area = pointer::areaOf(table);
      const std::uint64_t status = error_ == 0 ? 0x80U : 0xA0U | error_;  // D, E and the code
      if (area) store.save(*area, pointer::offsetOf(table) * 8, 8, status, true);
      endNetworkRequest(machine, entry);
    }
  }
  void reset() { age_ = {}; }

 private:
  std::array<std::uint32_t, regInfo(Reg::NetTable).count> age_{};
  std::uint8_t error_ = 0;
  bool isHeld_ = false;
};

}  // namespace rungproof
