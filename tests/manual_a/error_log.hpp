// ErrorLog: the run-time errors of a scan. An error that the test does not ask about fails the test: where the manual
// names no error there is none.
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "ir/hazard.hpp"

namespace rungproof::manual {

class ErrorLog {
 public:
  void add(Hazard hazard) { list_.push_back(hazard); }
  const std::vector<Hazard>& list() const {
    asked_ = true;
    return list_;
  }
  /// Forgets all; fails the running test if there were errors that nobody asked about.
  void clear() {
    if (!asked_) {
      for (const Hazard hazard : list_) ADD_FAILURE() << "an error that the test does not expect: " << hazardInfo(hazard).code;
    }
    list_.clear();
    asked_ = false;
  }
  friend bool operator==(const ErrorLog& a, const ErrorLog& b) { return a.list_ == b.list_; }

 private:
  std::vector<Hazard> list_;
  mutable bool asked_ = false;
};

}  // namespace rungproof::manual
