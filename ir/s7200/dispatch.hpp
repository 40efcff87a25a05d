// The dispatch table of a domain: what to run for an opcode. Each domain instantiates it in exactly one source
// file (engine/dispatch_concrete.cpp, analysis/encoding/dispatch_graph.cpp), because that costs compile time.
#pragma once

#include <span>

#include "ir/s7200/machine.hpp"

namespace rungproof {

template <class D>
using Execute = void (*)(Machine<D>&, const Instruction&);

/// Indexed by Desc::opcode. Control instructions have entries that do nothing; ir/s7200/scan.hpp gives them meaning.
template <class D>
std::span<const Execute<D>> dispatchTable();
/// The same for the instructions of the S7-300/400; what their control instructions decide is in Step7Registers::jumps.
template <class D>
std::span<const Execute<D>> step7DispatchTable();

}  // namespace rungproof
