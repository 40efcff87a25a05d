// Mending and silencing findings: the fixes of `rungproof lint --fix`, and comments that allow a finding on its line or
// in its network, in the form that analysis/suppress.hpp reads. Tested by tests/editor/code_action_test.cpp.
#pragma once

#include "frontend/editor/checked_document.hpp"

namespace rungproof {

/// Actions for the findings that touch the range, and one for all safe fixes of the document.
Json codeActionsIn(const CheckedDocument& document, ClientPlace begin, ClientPlace end);

}  // namespace rungproof
