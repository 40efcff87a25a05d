// Sources in SCL: data blocks, types, the interfaces of code blocks, and their bodies as syntax trees.
// Tested by tests/step7/scl_source_test.cpp.
#pragma once

#include "frontend/step7/syntax.hpp"
#include "frontend/stl/syntax_sink.hpp"

namespace rungproof::step7 {

/// Whether the text heads blocks of an S7-300/400 whose bodies are SCL. `isNamed`: its name ends in .scl.
bool looksLikeScl(std::string_view text, bool isNamed);

SourceSyntax readSclSource(const SourceFile& file, SyntaxSink& sink);

}  // namespace rungproof::step7
