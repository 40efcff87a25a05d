// Variables of an IEC 61131-3 program by their place in memory: to which one a byte belongs, and which ones a program
// gives out.
// Tested by tests/iec/variables_test.cpp.
#pragma once

#include <set>
#include <string>

#include "ir/program.hpp"

namespace rungproof {

/// Whether a byte of the memory of variables belongs to the place.
bool coversByte(const Operand& place, const Operand& byte);

/// IEC 61131-3: the variable to which a byte or bit of the memory belongs; another operand as it is.
Operand wholeVariable(const Program& program, const Operand& operand);

/// Outputs of an IEC 61131-3 program: VAR_OUTPUT of its programs and all variables at %Q.
class ProgramOutputs {
 public:
  explicit ProgramOutputs(const Program& program);
  /// Whether a name of what lies at the place is an output or a part of one.
  bool contains(const Operand& place) const;

 private:
  bool isNamed(const std::string& foldedName) const;

  const Program& program_;
  std::set<std::string> names_;
};

/// The place of each of these outputs, once.
Operands outputVariables(const Program& program);

}  // namespace rungproof
