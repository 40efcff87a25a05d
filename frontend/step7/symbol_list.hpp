// Symbol tables of STEP 7: .sdf of STEP 7 V5 and of TIA, .asc, .dif, .seq, .csv, and tables with tabs. Addresses are
// read in either set of mnemonics, whichever the rows are written in. Tested by tests/step7/symbol_list_test.cpp.
#pragma once

#include "frontend/step7/operand_parser.hpp"
#include "frontend/stl/syntax_sink.hpp"

namespace rungproof::step7 {

/// Reads a table; reports rows that are none.
std::vector<SymbolRow> readSymbolList(std::string_view text, MnemonicSet set, SyntaxSink& sink);
/// Tags of a TIA tag table as XML (SimaticML: SW.Tags.PlcTagTable).
std::vector<SymbolRow> readTagTable(const SourceFile& file, SyntaxSink& sink);

/// Rows of the text that name an address or a block in that set, 0 to 100 of a hundred.
int symbolListShare(std::string_view text, MnemonicSet set);
/// Whether its form is one that only STEP 7 writes: quoted fields padded with blanks, `126,`, tuples.
bool hasSymbolListForm(std::string_view text);
/// That, or most of its rows name an address in one of the sets.
bool isSymbolList(std::string_view text);

}  // namespace rungproof::step7
