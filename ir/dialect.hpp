// A dialect: a family of controllers with an instruction set, areas and CPUs of its own. What the rest of the tool asks
// of a family stands here, so that a further family is a further row of `dialects()`.
// Tested by tests/ir/dialect_test.cpp.
#pragma once

#include <array>
#include <span>
#include <string_view>

#include "ir/family.hpp"
#include "ir/instruction_table.hpp"
#include "ir/system_bit.hpp"
#include "ir/target.hpp"

namespace rungproof {

/// A set of dialects, one bit each.
using Dialects = std::uint8_t;
namespace dialect {
inline constexpr Dialects S7200 = 1, S7300 = 2, Iec = 4;  ///< S7300: the S7-400 too
inline constexpr Dialects Every = S7200 | S7300;          ///< whose programs are lists of statements
}  // namespace dialect

struct CpuModel {
  Cpu cpu;
  std::string_view name;
};
struct EditionModel {
  Edition edition;
  std::string_view name;    ///< as --edition takes it
  std::string_view text;    ///< as a sentence names it
  bool isFirmware = false;  ///< of the CPU; otherwise the edition of a manual
};

struct Dialect {
  std::string_view name;   ///< as --dialect takes it
  std::string_view title;  ///< as a sentence names it
  Dialects set;            ///< itself, in a set of dialects
  std::span<const CpuModel> cpus;
  std::span<const EditionModel> editions;
  Target usual;                               ///< where no CPU is named
  const InstructionTable& (*instructions)();  ///< made when it is asked for the first time
  SystemBits systemBits;
  StatementForm form;
  MemoryModel memory;
  RunModel run;
  TextModel text;
};

/// All of them; the first one is meant where nothing is said.
std::span<const Dialect* const> dialects();
/// The dialect of a CPU.
const Dialect& dialectOf(Cpu cpu);
inline const Dialect& dialectOf(const Target& target) { return dialectOf(target.cpu); }
inline StatementForm formOf(const Target& target) { return dialectOf(target).form; }
/// The row of an edition.
const EditionModel& editionModel(Edition edition);

}  // namespace rungproof
