// RegisterPool: registers of the code library, of which there are as many as hold something at once. What it has given
// out in a step is free behind it if nothing holds it then.
#pragma once

#include <asmjit/x86.h>

#include <unordered_map>
#include <vector>

namespace rungproof::lanes {

template <class Register>
class RegisterPool {
 public:
  /// `make` gives a new one.
  template <class Make>
  Register take(Make&& make) {
    if (free_.empty()) {
      free_.push_back(make());
      all_.emplace(free_.back().id(), free_.back());
    }
    const Register reg = free_.back();
    free_.pop_back();
    holders_[reg.id()] = 0;
    ofStep_.push_back(reg);
    return reg;
  }
  void hold(const Register& reg) { ++holders_[reg.id()]; }
  void drop(const Register& reg) {
    if (--holders_[reg.id()] == 0) ofStep_.push_back(reg);
  }
  int holders(const Register& reg) const { return holders_.at(reg.id()); }
  void endStep() {
    for (const Register& reg : ofStep_) {
      int& holders = holders_[reg.id()];
      if (holders != 0) continue;
      free_.push_back(reg);
      holders = isFree;
    }
    ofStep_.clear();
  }
  /// Nothing is held any more.
  void clear() {
    for (auto& [id, holders] : holders_) {
      if (holders <= 0) continue;
      free_.push_back(all_.at(id));
      holders = isFree;
    }
  }

 private:
  static constexpr int isFree = -1;
  std::unordered_map<std::uint32_t, int> holders_;
  std::unordered_map<std::uint32_t, Register> all_;
  std::vector<Register> ofStep_, free_;
};

}  // namespace rungproof::lanes
