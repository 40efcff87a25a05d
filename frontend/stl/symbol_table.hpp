// Symbol tables: name, address, comment, separated by tabs, commas or semicolons, with or without a header row and
// a row number (001:2395-2416). Tested by tests/reader/table_test.cpp.
#pragma once

#include "frontend/stl/operand_reader.hpp"
#include "frontend/stl/syntax_sink.hpp"

namespace rungproof {

/// Reads one row of text[begin, end) into Program::symbols. Addresses of routines (SBR0, INT1) become constants with
/// the routine in Operand::text. Returns false, without a report, if it is no row.
bool readSymbolRow(std::string_view text, std::uint32_t begin, std::uint32_t end, Spelling spelling, SyntaxSink& sink);

/// Reads a whole table; reports rows that are none.
void readSymbolTable(std::string_view text, Spelling spelling, SyntaxSink& sink);

/// Share of the lines that are rows in that spelling, 0 to 100.
int symbolRowShare(std::string_view text, Spelling spelling);

}  // namespace rungproof
