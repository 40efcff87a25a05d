// Edits of the text that allow a finding, in the forms that analysis/lint/suppress.hpp reads. They change comments
// only: statements, texts, properties and what other comments say stay. Tested by
// tests/editor/suppression_edit_test.cpp.
#pragma once

#include <optional>
#include <string>

#include "frontend/editor/checked_document.hpp"

namespace rungproof {

struct TextEdit {
  Span span;
  std::string text;
};

/// Allows the rule on the line of the finding; nothing where no comment would speak for that line alone.
std::optional<TextEdit> allowOnLine(const CheckedDocument& document, const Finding& finding);
/// Allows the rule in the network of the finding; nothing where there is none, as in structured text.
std::optional<TextEdit> allowInNetwork(const CheckedDocument& document, const Finding& finding);

}  // namespace rungproof
