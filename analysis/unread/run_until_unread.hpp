// A run of a program with unread code: it is the run of the program as long as it does not come to what nobody knows.
// So it is begun, and ends there. Of an S7-300/400; a program of another family is downloaded as a whole.
// Tested by tests/step7/run_until_unread_test.cpp.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "analysis/unread/statement_influence.hpp"
#include "analysis/unread/unread_code.hpp"

namespace rungproof {

class RunUntilUnread {
 public:
  /// `unread` must outlive it.
  explicit RunUntilUnread(const UnreadCode& unread);
  ~RunUntilUnread();

  /// Why no run can be begun; empty: it can.
  const std::string& hindrance() const { return hindrance_; }
  /// What is run.
  const Program& program() const { return program_; }
  /// Whether a run may come to an end before its time.
  bool mayEnd() const { return !ends_.empty(); }
  /// By Instruction::id of program(): a run ends in front of these, and why.
  const std::map<std::uint32_t, std::string>& ends() const { return ends_; }
  /// Why nobody knows what stands there, however far the run comes; empty: it is known.
  std::string unknownAt(const Operand& place) const;

 private:
  const UnreadCode& unread_;
  std::string hindrance_;
  Program program_;
  std::map<std::uint32_t, std::string> ends_;
  std::unique_ptr<StatementInfluence> ofData_;  ///< what depends on data of which nobody knows what it holds
};

}  // namespace rungproof
