// The dispatch table of a domain: what to run for an opcode. Each domain instantiates it in exactly one source
// file (engine/dispatch_concrete.cpp, analysis/encoding/dispatch_graph.cpp), because that costs compile time.
#pragma once

#include <span>

#include "ir/machine.hpp"

namespace rungproof {

template <class D>
using Execute = void (*)(Machine<D>&, const Instruction&);

/// Indexed by Desc::opcode. Control instructions have entries that do nothing; ir/scan.hpp gives them meaning.
template <class D>
std::span<const Execute<D>> dispatchTable();

}  // namespace rungproof
