// The names in statements of the property language, in comments `//@` and in property files: also in statements that
// have a mistake, which still name what they mean. Tested by tests/editor/rename_test.cpp and navigation_test.cpp.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "frontend/editor/checked_document.hpp"

namespace rungproof {

struct PropertyWord {
  std::string_view text;  ///< as written: Motor, "Motor".Speed, P.Motor, Q0.0
  Span span;
};

/// The text of a part of a word.
inline std::string_view textOf(const PropertyWord& word, Span part) {
  return word.text.substr(part.offset - word.span.offset, part.length);
}
/// The first name of a word without its quotation marks: of "Motor".Speed it is Motor.
Span firstNameOf(const PropertyWord& word);
/// The name behind the first point; empty if there is none.
Span secondNameOf(const PropertyWord& word);

/// Those of the files that the document was read with.
std::vector<PropertyWord> propertyWordsOf(const CheckedDocument& document);

/// A property file that lies beside a program and speaks of it, but was not read with the document.
struct PropertyFileBeside {
  std::string uri;
  std::unique_ptr<const SourceFile> file;  ///< spans of the words are places in it
  std::vector<PropertyWord> words;
};
std::vector<PropertyFileBeside> propertyFilesBeside(const CheckedDocument& document);

}  // namespace rungproof
