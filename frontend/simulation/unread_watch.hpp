// Watches a run for the first place that was not read (analysis/unread/run_until_unread.hpp), and shows it to one more
// observer. Tested by tests/step7/run_until_unread_test.cpp.
#pragma once

#include <map>
#include <string>

#include "engine/instruction_observer.hpp"
#include "ir/program.hpp"

namespace rungproof {

class UnreadWatch final : public InstructionObserver {
 public:
  /// `ends`: by Instruction::id, and why the run ends there.
  explicit UnreadWatch(const std::map<std::uint32_t, std::string>& ends) : ends_(ends) {}

  void showTo(InstructionObserver* next) { next_ = next; }
  bool isReached() const { return reached_ != nullptr; }
  /// Where the run came to it first, and why it ends there.
  const std::string& reached() const { return *reached_; }

  void before(const Machine<Concrete>& machine, const Instruction& instruction) override {
    if (reached_ == nullptr) {
      if (const auto end = ends_.find(instruction.id); end != ends_.end()) reached_ = &end->second;
    }
    if (next_ != nullptr) next_->before(machine, instruction);
  }
  void external(const ExternalSite& site, std::uint64_t value) override {
    if (next_ != nullptr) next_->external(site, value);
  }
  void programEnded(const Machine<Concrete>& machine) override {
    if (next_ != nullptr) next_->programEnded(machine);
  }

 private:
  const std::map<std::uint32_t, std::string>& ends_;
  const std::string* reached_ = nullptr;
  InstructionObserver* next_ = nullptr;
};

}  // namespace rungproof
