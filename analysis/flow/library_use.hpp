// How the blocks of libraries and wizards are to be called: in every scan, once, or by a request whose first input is a
// pulse (001:8205-8330, 001:8599-8892, 001:9676-9735, 001:10069-10319, 001:10695-10779; the libraries of the S7-200
// SMART). Which block an instruction calls, and what is known of the power flow and the bits that a call is given, is
// asked here too. Their parameters stand in ir/s7200/library_block.hpp. Tested by tests/rules/library_rules_test.cpp.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/flow/facts.hpp"

namespace rungproof {

enum class LibraryRun : std::uint8_t {
  EveryScan,  ///< enabled by SM0.0, once a scan
  Once,       ///< by an edge or in the first scan
  Request     ///< its first input starts it: one scan long
};

struct LibraryUse {
  std::string_view name;  ///< "PTOx_RUN": x stands for a digit
  LibraryRun run = LibraryRun::EveryScan;
  std::string_view unit = {};  ///< of a request: what serves one at a time
  bool onceInProgram = false;  ///< a second call of the same block is a mistake
  bool mayBeHeld = false;      ///< of a request: its block looks at the input only when it is idle (001:8931)
  std::string_view manual = {};
};

/// nullptr: none of them.
const LibraryUse* libraryUseNamed(std::string_view name);

/// A call of such a block.
struct LibraryCall {
  const Instruction* call;
  const LibraryUse* use;
  std::string name;  ///< as the program calls it
};
/// All that can be reached, in program order.
std::vector<LibraryCall> libraryCalls(const Facts& facts);

/// What is known of bits that are prepared for a call: the editor keeps the rung of an input in L63.7 or L60.0 and
/// loads it again in front of CALL (001:10223-10238).
class CallInputs {
 public:
  explicit CallInputs(const Facts& facts);

  /// The coil in the same network that has prepared the bit, or nullptr.
  const Instruction* coilBefore(const Instruction& call, const Operand& bit) const;
  /// The condition under which the call is enabled.
  Condition enable(const Instruction& call) const;
  /// The condition of a bit that the call is given.
  Condition bit(const Instruction& call, const Operand& bit) const;
  /// Whether the bit is certain to stay on for many scans: an input, a step, a latch, a clock, or made of such.
  bool isLevel(const Instruction& call, const Operand& bit) const;
  /// Text of what makes the bit: its own address, or the rung of the coil that prepares it.
  std::string source(const Instruction& call, const Operand& bit) const;

 private:
  bool isLevelBit(const Operand& bit, std::uint32_t block, int depth) const;
  bool isLevelRung(const Instruction& output, int depth) const;
  std::vector<const Instruction*> rungOf(const Instruction& output) const;

  const Facts& facts_;
  KnownBits pulses_;
};

}  // namespace rungproof
