// Reader of symbol tables.
#include "frontend/file_reader.hpp"
#include "frontend/stl_parser.hpp"
#include "frontend/symbol_table.hpp"

namespace rungproof {

namespace {

int rate(const SourceFile& file, const InputText& input, const ReadOptions&) {
  if (input.isSymbolFile) return sureness::Certain;
  const int share = symbolRowShare(file.text());
  if (share >= 50) return sureness::Likely + share / 5;
  return share > 0 && endsInAny(file.name(), {".csv", ".tsv", ".sym"}) ? sureness::Ending : sureness::None;
}

void read(Program& program, const InputText& input, const ReadOptions& options) {
  SyntaxSink sink(program, input.file);
  const std::string_view text = program.sources->file(input.file).text();
  Spelling spelling = options.mnemonics == Mnemonics::German ? Spelling::German : Spelling::International;
  if (options.mnemonics == Mnemonics::Auto) spelling = detectSpelling(text);
  readSymbolTable(text, spelling, sink);
}

}  // namespace

extern const FileReader symbol_table_file{"symbol table", &rate, &read};

}  // namespace rungproof
