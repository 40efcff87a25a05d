// Findings as diagnostics of the protocol: what lint reports for this document, with its codes and severities. Tested
// by tests/editor/diagnostics_test.cpp.
#pragma once

#include "frontend/editor/checked_document.hpp"

namespace rungproof {

/// All findings in the document; one in its place if it could not be checked.
Json diagnosticsOf(const CheckedDocument& document);
Json diagnosticOf(const CheckedDocument& document, const Finding& finding);
/// 1 error, 2 warning, 3 information.
int clientSeverity(Severity severity);

}  // namespace rungproof
