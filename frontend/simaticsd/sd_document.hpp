// Documents of TIA Portal V20 and later (.s7dcl): declarations as in external sources, ladder and FBD networks as text.
// Networks in other languages, and what cannot be read, are reported and incomplete. Tested by
// tests/step7/simatic_sd_test.cpp.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "frontend/flgnet/block_reader.hpp"

namespace rungproof::simaticsd {

/// Whether the text has networks as such documents write them, or attributes of their blocks.
bool looksLikeDocument(std::string_view text);

flgnet::DrawnSource readDocument(const SourceFile& file, SyntaxSink& sink);

/// Whether the text is a table of texts beside a document (.s7res).
bool looksLikeTexts(std::string_view text);
/// "MLC_3fA" with its text, that in English where several languages are there.
std::map<std::string, std::string> readTexts(std::string_view text);

}  // namespace rungproof::simaticsd
