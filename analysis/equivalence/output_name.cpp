// From the address over the whole variable to its name.
#include "analysis/equivalence/output_name.hpp"

#include "ir/dialect.hpp"
#include "ir/iec/variables.hpp"

namespace rungproof {

std::string outputName(const Program& program, const std::optional<Address>& address, const std::string& name) {
  if (!dialectOf(program.target).memory.isOfVariables || !address) return name;
  const Symbol* const symbol = program.symbolOf(wholeVariable(program, operandAt(*address)));
  return symbol == nullptr ? name : symbol->name;
}

}  // namespace rungproof
