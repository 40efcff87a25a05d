// "Prove this property": a lens above each property of a document, the run of `rungproof prove` behind it, and its
// verdict in the lens and as a diagnostic. Tested by tests/editor/proof_test.cpp.
#pragma once

#include <map>

#include "frontend/editor/checked_document.hpp"
#include "frontend/rpc/background_job.hpp"

namespace rungproof {

/// What a run has said of one property of one version of the document.
struct ProofVerdict {
  std::int64_t version = 0;
  std::string word;     ///< "PROVED", "HOLDS TO BOUND 12"; empty: the run failed
  std::string message;  ///< for people, with the run of a violation
  Json row;             ///< the property as the JSON report has it
};
using ProofVerdicts = std::map<std::string, ProofVerdict>;  ///< by name

/// The property of that name in the program of the document, if it is one that can be proved.
const Property* goalNamed(const CheckedDocument& document, std::string_view name);

Json lensesOf(const CheckedDocument& document, const ProofVerdicts& verdicts);
/// The run itself, for a background job. `given`: options of the server's command line.
JobRequest proofOf(const CheckedDocument& document, const std::string& name, const std::vector<std::string>& given);
/// Runs a command for a server and gives what it prints.
extern const Worker commandWorker;
/// From what the run has printed; nothing: it did not come to its end.
ProofVerdict verdictFrom(const std::optional<std::string>& printed, const std::string& name, std::int64_t version);
/// Adds violations of this version of the document to its diagnostics.
void addVerdicts(const CheckedDocument& document, const ProofVerdicts& verdicts, Json& diagnostics);

}  // namespace rungproof
