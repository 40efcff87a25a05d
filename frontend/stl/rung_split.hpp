// Networks for texts without Network lines: a load after a coil or box begins a new rung if nothing that was on the
// stack before it is used later (s7200 dialect notes 9.2). Tested by tests/reader/rung_split_test.cpp.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "ir/program.hpp"

namespace rungproof {

/// Indices of the instructions that begin a rung; the first is always 0 unless there are none. Linear.
std::vector<std::size_t> rungStarts(const std::vector<Instruction>& instructions);

/// Cuts the only network of `pou` into rungs, numbered from 1. A rung begins on the line after the last instruction
/// of the rung before it, so comments go to the rung that follows them. `damaged` are the sorted offsets of
/// unreadable lines: the rungs next to them become incomplete. Returns the offset at which each rung begins.
std::vector<std::uint32_t> splitIntoRungs(Pou& pou, std::string_view text, const std::vector<std::uint32_t>& damaged);

}  // namespace rungproof
