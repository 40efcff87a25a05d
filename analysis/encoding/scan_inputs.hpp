// What a replayed scan is given from outside: the inputs of an encoding as operands of the engine, in one order that
// scripts, the search on the engine and the marks of inputs that do not matter all share. Physical inputs, memory that
// is written from outside, fast counters, and the samples of analog inputs. Tested by tests/prover/witness_test.cpp.
#pragma once

#include <cstdint>
#include <vector>

#include "analysis/encoding/encoder.hpp"

namespace rungproof {

struct ScanInput {
  Operand operand;  ///< a bit, byte, word or fast counter
  Node node;        ///< variable of the encoding that it is part of
  int shift = 0;    ///< lowest bit of it in the variable

  std::uint64_t highest() const { return Graph::maskOf(bits(operand.width)); }
  /// The operand's value when the variable has this one.
  std::uint64_t valueIn(std::uint64_t variable) const { return variable >> shift & highest(); }
};

std::vector<ScanInput> scanInputsOf(const EncodedScan& scan);

}  // namespace rungproof
