// The referee's own reading of a property line and its meaning over the scan ends of a run (the contract of the
// property language: no scan before the first, prev(e) is e there, rises and falls are false).
#pragma once

#include <string>
#include <vector>

#include "machine.hpp"

namespace rungproof::referee {

class Property {
 public:
  /// A line such as `prove p: once(I0.0) implies MB1 <= 3`; throws std::invalid_argument for what it does not know.
  explicit Property(const std::string& line);

  const std::string& name() const { return name_; }
  const std::string& text() const { return text_; }
  bool isReach() const { return kind_ == Kind::Reach; }

  /// Forgets the run before.
  void reset();
  /// At a scan end: whether the property is broken there, or the state of a reach property is reached.
  bool hits(const Machine& machine);

 private:
  enum class Kind { Always, Reach, OnlyAfter, Unless, Within };
  struct Node {
    std::string op;
    int left = -1, right = -1;
    std::int64_t number = 0;
    Operand operand;
    bool value = false;  ///< timer or counter as number
    std::int64_t now = 0, before = 0;
    std::int64_t since = -1;
  };
  int add(Node node);
  int parse(int level);
  int primary();
  int call(const std::string& name);
  bool take(const std::string& token);
  std::string peek() const;

  Kind kind_ = Kind::Always;
  bool never_ = false;
  std::string name_, text_;
  std::vector<std::string> tokens_;
  std::size_t at_ = 0;
  std::vector<Node> nodes_;
  int root_ = -1, second_ = -1;
  int within_ = 0;
  bool first_ = true, pending_ = false, seen_ = false;
  int waiting_ = -1;
};

}  // namespace rungproof::referee
