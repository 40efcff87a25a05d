// The one place where all instruction meanings are compiled for plain numbers.
#include "engine/concrete.hpp"
#include "ir/dispatch.hpp"
#include "ir/isa_list.hpp"

namespace rungproof {

template <>
std::span<const Execute<Concrete>> dispatchTable<Concrete>() {
  static constexpr auto table = isa::makeDispatch<Concrete>(isa::AllInstructions{});
  return table;
}

}  // namespace rungproof
