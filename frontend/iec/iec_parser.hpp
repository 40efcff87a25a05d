// Reads IEC 61131-3 texts: whole files with types, blocks and configurations, and single bodies and expressions out of
// XML files. An error is reported at its place and reading goes on behind the statement, declaration or block.
// Tested by tests/iec.
#pragma once

#include "frontend/iec/iec_lexer.hpp"

namespace rungproof::iec {

/// A text file.
void parseProject(const SourceText& source, SyntaxSink& sink, ProjectSyntax& project);
/// The statements of a body.
Statements parseBody(const SourceText& source, SyntaxSink& sink, std::vector<Directive>& directives);
/// The lines of a body in IL.
Statements parseList(const SourceText& source, SyntaxSink& sink, std::vector<Directive>& directives);
/// One expression, or nullptr with an error.
ExprPtr parseExpression(const SourceText& source, SyntaxSink& sink);

/// ms of "T#1s" without its prefix: "1s", "1d2h3m4s5.6ms"; nothing if it cannot be read, has parts of a millisecond, or
/// does not fit into 32 bits.
std::optional<std::int64_t> millisecondsOf(std::string_view text);
/// The same in ns: exact, up to 292 years.
std::optional<std::int64_t> nanosecondsOf(std::string_view text);

}  // namespace rungproof::iec
