// The subroutines of a program by number, for those who ask for many of them: Program::subroutine() looks at one block
// after the other. Tested by tests/ir/subroutine_index_test.cpp.
#pragma once

#include <unordered_map>

#include "ir/program.hpp"

namespace rungproof {

class SubroutineIndex {
 public:
  /// Of the blocks that the program has now.
  explicit SubroutineIndex(const Program& program) : program_(program) {
    for (std::size_t i = 0; i < program.pous.size(); ++i) {
      if (program.pous[i].kind == PouKind::Subroutine) first_.emplace(program.pous[i].number, i);
    }
  }

  /// The first of that number, or nullptr.
  const Pou* operator[](int number) const {
    const auto found = first_.find(number);
    return found == first_.end() ? nullptr : &program_.pous[found->second];
  }

 private:
  const Program& program_;
  std::unordered_map<int, std::size_t> first_;
};

}  // namespace rungproof
