// The head of a certificate file: what was proved of which program, under which assumptions, and how to check it.
// Tested by tests/cli/certificate_file_test.cpp.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "analysis/proof/prover.hpp"

namespace rungproof {

/// What a certificate says.
struct CertifiedStatement {
  std::string kind;  ///< "property"
  std::string text;
  std::vector<const Program*> programs;
  std::vector<std::string> assumptions, notes;
  std::filesystem::path root{};  ///< of the project: the programs' files are named from there
};
/// Lines of SMT-LIB comments. `file`: the name that the certificate gets, without its folder.
std::string certificateHead(const CertifiedStatement& statement, const std::string& file);
/// The same for a property.
std::string certificateHead(const Program& program, const std::vector<std::string>& assumptions,
                            const ProofResult& result, const std::string& file, const std::filesystem::path& root = {});

}  // namespace rungproof
