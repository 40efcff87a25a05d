// Programs and inputs of any number of elements, in each form that a reader knows: in series, in parallel, nested, in a
// row. Part of large_matrix_test.cpp.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tests/temporary_folder.hpp"

namespace rungproof::test {

/// Something that is written into a folder with `count` elements; what comes back stands behind a command.
struct LargeForm {
  std::string name;
  std::vector<std::string> (*arguments)(const TemporaryFolder& folder, std::size_t count);
};

/// One for each reader of programs and each way to be long or deep.
const std::vector<LargeForm>& largePrograms();

/// What stands beside a small program: the command with its options first.
const std::vector<LargeForm>& largeInputs();

/// `element(i)` for each i below `count`, one behind the other.
template <class Element>
std::string inARow(std::size_t count, const Element& element) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) {
    if constexpr (requires { element(i); })
      text += element(i);
    else
      text += element;
  }
  return text;
}

}  // namespace rungproof::test
