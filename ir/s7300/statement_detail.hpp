// What rules ask of a statement beside its role: on which value it jumps, whether it sets or resets, which numbers it
// compares. Tested by tests/ir/step7_role_test.cpp.
#pragma once

#include "ir/s7300/statement_role.hpp"

namespace rungproof {

/// JC, JCB, JBI: the jump is taken where its bit is 1.
bool jumpsOnOne(const Instruction& jump);
/// S of a bit, no R.
bool setsBit(const Instruction& instruction);
/// SD: a change of its RLO ends the time, and the next one starts it anew.
bool startsOnDelay(const Instruction& instruction);
/// ==R and its kind.
bool comparesReals(const Instruction& instruction);

}  // namespace rungproof
