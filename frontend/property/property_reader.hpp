// Reads properties: `//@` comments of a program and *.prop files. Mistakes become
// findings PRP001-PRP004 with place and help; the statements around them are still read.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/property.hpp"
#include "ir/program.hpp"

namespace rungproof {

/// Gives the operand that an address or symbol means, or nothing.
using OperandLookup = std::function<std::optional<Operand>(std::string_view)>;

/// The same lookup, in which double words are marked that the program uses as REAL numbers (ConstantForm::Real) or as
/// whole ones (SignedDecimal).
OperandLookup withReals(const Program& program, OperandLookup lookup);

/// Reads the directives of `program`, then the files; findings go to program.findings. A file that cannot be
/// opened is an error finding as well.
PropertySet readProperties(Program& program, const std::vector<std::string>& files, const OperandLookup& lookup,
                           const std::filesystem::path& root = {});

/// Reads statements from one text, a line each; `#` begins a comment. Addresses must exist on `target`, if given. For
/// tests and for readProperties.
void readPropertyText(std::uint32_t file, std::string_view text, std::uint32_t offset, const OperandLookup& lookup,
                      PropertySet& set, std::vector<Finding>& findings, const Target* target = nullptr);

}  // namespace rungproof
