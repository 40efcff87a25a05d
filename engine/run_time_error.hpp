// Run-time errors of a simulated run: the hazards that the machine reported, each with the place and the scan where it
// first happened (tables C-1 and C-2, 001:13917-13973). Covered by tests/engine/mode_test.cpp.
#pragma once

#include <cstdint>
#include <vector>

#include "ir/hazard.hpp"
#include "ir/program.hpp"

namespace rungproof {

struct RunTimeError {
  Hazard hazard;
  const Instruction* place;  ///< nullptr: not at an instruction
  std::uint64_t scan;        ///< first occurrence, from 1
  std::uint64_t timeUs;
  std::uint64_t count = 1;
};

/// Errors in the order of their first occurrence; repetitions at the same instruction are counted.
class RunTimeErrors {
 public:
  void add(Hazard hazard, const Instruction* place, std::uint64_t scan, std::uint64_t timeUs) {
    for (RunTimeError& error : list_) {
      if (error.hazard == hazard && error.place == place) {
        ++error.count;
        return;
      }
    }
    list_.push_back({hazard, place, scan, timeUs});
  }
  /// The one at `at` in the list has happened `times` more.
  void repeat(std::size_t at, std::uint64_t times) { list_[at].count += times; }
  const std::vector<RunTimeError>& list() const { return list_; }
  /// The error that stopped the CPU, or nullptr.
  const RunTimeError* fatal() const {
    for (const RunTimeError& error : list_) {
      if (hazardInfo(error.hazard).kind == HazardClass::Fatal) return &error;
    }
    return nullptr;
  }
  bool has(Hazard hazard) const {
    for (const RunTimeError& error : list_) {
      if (error.hazard == hazard) return true;
    }
    return false;
  }
  void clear() {
    list_.clear();
    ++clearings_;
  }
  /// How often the list has been cleared.
  std::uint64_t clearings() const { return clearings_; }

 private:
  std::uint64_t clearings_ = 0;
  std::vector<RunTimeError> list_;
};

}  // namespace rungproof
