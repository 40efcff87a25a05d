// ErrorLog: the run-time errors of a scan. An error that the test does not ask about fails the test: where the manual
// names no error there is none. What every error does is checked for every test: fatal ones, and nothing else, leave
// the scan without its end (001:13906-13910), SM4.3 is set by non-fatal ones only (001:14106), and the box that met one
// leaves ENO at 0 (001:2276-2278).
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "engine/concrete.hpp"
#include "ir/hazard.hpp"

namespace rungproof::manual {

class ErrorLog {
 public:
  void add(Hazard hazard, const Instruction* place) {
    list_.push_back(hazard);
    place_ = place;
  }
  /// Before a scan: SM4.3 as the scan finds it.
  void begin(const Concrete::Store& store) {
    clear();
    errorBitBefore_ = errorBit(store);
  }
  /// After it.
  void check(const Concrete::Store& store, const Program& program, bool halted, bool faulted) const {
    const bool isFatal =
        std::any_of(list_.begin(), list_.end(), [](Hazard h) { return hazardInfo(h).kind == HazardClass::Fatal; });
    EXPECT_TRUE(halted || !isFatal) << "a fatal error ends the program";
    EXPECT_EQ(faulted, isFatal) << "a fatal error leaves the scan without its end";
    const bool sets =
        std::any_of(list_.begin(), list_.end(), [](Hazard h) { return hazardInfo(h).kind == HazardClass::NonFatal; });
    EXPECT_EQ(errorBit(store), sets || errorBitBefore_) << "SM4.3";
    if (list_.empty() || place_ == nullptr || !place_->desc->eno) return;
    bool isLastBox = false;  // of a program without other blocks
    for (const Pou& pou : program.pous) {
      if (pou.kind != PouKind::Main) continue;
      for (const Network& network : pou.networks) {
        for (const Instruction& instruction : network.instructions) {
          if (instruction.desc->eno) isLastBox = &instruction == place_;
        }
      }
    }
    EXPECT_FALSE(isLastBox && store.get(Reg::Eno, 0) != 0) << "ENO of a box with an error";
  }
  const std::vector<Hazard>& list() const {
    asked_ = true;
    return list_;
  }
  /// Forgets all; fails the running test if there were errors that nobody asked about.
  void clear() {
    if (!asked_) {
      for (const Hazard hazard : list_)
        ADD_FAILURE() << "an error that the test does not expect: " << hazardInfo(hazard).code;
    }
    list_.clear();
    asked_ = false;
  }
  friend bool operator==(const ErrorLog& a, const ErrorLog& b) { return a.list_ == b.list_; }

 private:
  static bool errorBit(const Concrete::Store& store) { return store.load(Area::SM, 4 * 8 + 3, 1) != 0; }

  std::vector<Hazard> list_;
  const Instruction* place_ = nullptr;
  bool errorBitBefore_ = false;
  mutable bool asked_ = false;
};

}  // namespace rungproof::manual
