// Group: the list of instruction types that a file of a family defines. The isa/list.hpp of the family joins the
// groups.
#pragma once

#include <array>
#include <string_view>

#include "ir/machine/machine.hpp"

namespace rungproof::isa {

template <class... Ops>
struct Group {
  static constexpr std::size_t size = sizeof...(Ops);
};

template <class... Groups>
struct Join;
template <class... A>
struct Join<Group<A...>> {
  using type = Group<A...>;
};
template <class... A, class... B, class... Rest>
struct Join<Group<A...>, Group<B...>, Rest...> {
  using type = typename Join<Group<A..., B...>, Rest...>::type;
};

/// A structural string so that a mnemonic can be a template argument of a family.
template <std::size_t N>
struct Name {
  char characters[N];
  constexpr Name(const char (&text)[N]) {
    for (std::size_t i = 0; i < N; ++i) characters[i] = text[i];
  }
  constexpr std::string_view view() const { return {characters, N - 1}; }
};

template <class... Ops>
constexpr std::array<Desc, sizeof...(Ops)> makeTable(Group<Ops...>) {
  std::array<Desc, sizeof...(Ops)> table = {Ops::desc...};
  for (std::size_t i = 0; i < table.size(); ++i) table[i].opcode = static_cast<std::uint16_t>(i);
  return table;
}

/// What a domain does with an instruction: one function per opcode.
template <class D>
using Execute = void (*)(Machine<D>&, const Instruction&);

}  // namespace rungproof::isa
