// A dispatch table whose entries are one function, which looks the meaning up itself and may leave it out.
#pragma once

#include <array>
#include <utility>

#include "ir/machine/dispatch.hpp"
#include "tests/mutation/mutated.hpp"

namespace rungproof::mutation {

template <Execute<Mutated> execute, std::size_t... i>
constexpr std::array<Execute<Mutated>, sizeof...(i)> everyEntry(std::index_sequence<i...>) {
  return {((void)i, execute)...};
}

}  // namespace rungproof::mutation
