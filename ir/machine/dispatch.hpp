// The dispatch table of a domain: what to run for an opcode. Each domain instantiates it in exactly one source
// file (engine/dispatch_concrete.cpp, analysis/encoding/dispatch_graph.cpp), because that costs compile time.
#pragma once

#include <functional>
#include <span>

#include "ir/machine/machine.hpp"

namespace rungproof {

template <class D>
using Execute = void (*)(Machine<D>&, const Instruction&);

/// Indexed by Desc::opcode. Control instructions have entries that do nothing; ir/machine/scan.hpp gives them meaning.
template <class D>
std::span<const Execute<D>> dispatchTable();
/// The same for the instructions of the S7-300/400; what their control instructions decide is in Step7Registers::jumps.
template <class D>
std::span<const Execute<D>> step7DispatchTable();

/// The same for the instructions of the IEC 61131-3 machine.
template <class D>
std::span<const Execute<D>> iecDispatchTable();

/// Runs the block of the CPU or of a library that the machine has entered (ir/s7300/library/system_block.hpp).
template <class D>
void runSystemBlock(Machine<D>& machine, const std::function<void()>& between);
/// What a call of a block does to the CPU itself (ir/s7300/library/cpu_call.hpp); the block is named by a constant.
template <class D>
void actOnCpu(Machine<D>& machine, const Instruction& call);

}  // namespace rungproof
