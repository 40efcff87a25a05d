// Reader of symbol tables.
#include "frontend/files/file_reader.hpp"
#include "frontend/stl/symbol_table.hpp"

namespace rungproof {

namespace {

/// The spelling that the options name, or the one in which more rows can be read.
Spelling spellingOf(std::string_view text, const ReadOptions& options) {
  if (options.mnemonics == Mnemonics::German) return Spelling::German;
  if (options.mnemonics == Mnemonics::International) return Spelling::International;
  return symbolRowShare(text, Spelling::German) > symbolRowShare(text, Spelling::International)
             ? Spelling::German
             : Spelling::International;
}

int rate(const SourceFile& file, const InputText& input, const ReadOptions& options) {
  if (input.isSymbolFile) return sureness::Certain;
  const int share = symbolRowShare(file.text(), spellingOf(file.text(), options));
  if (share >= 50) return sureness::Likely + share / 5;
  return share > 0 && endsInAny(file.name(), {".csv", ".tsv", ".sym"}) ? sureness::Ending : sureness::None;
}

void read(Program& program, const InputText& input, const ReadOptions& options) {
  SyntaxSink sink(program, input.file);
  const std::string_view text = program.sources->file(input.file).text();
  readSymbolTable(text, spellingOf(text, options), sink);
}

}  // namespace

extern const FileReader symbol_table_file{"symbol table", &rate, &read, [](const SourceFile&) { return true; }};

}  // namespace rungproof
