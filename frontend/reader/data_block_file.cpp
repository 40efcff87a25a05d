// Reader of data blocks that stand in a file of their own without a DATA_BLOCK heading.
#include "frontend/files/file_reader.hpp"
#include "frontend/stl/data_block.hpp"

namespace rungproof {

namespace {

int rate(const SourceFile& file, const InputText& input, const ReadOptions&) {
  if (input.isSymbolFile) return sureness::None;
  const int share = dataLineShare(file.text());
  if (share >= 60) return sureness::Likely + share / 3;
  return endsInAny(file.name(), {".db", ".dbl"}) ? sureness::Ending : sureness::None;
}

void read(Program& program, const InputText& input, const ReadOptions&) {
  const std::string_view text = program.sources->file(input.file).text();
  SyntaxSink sink(program, input.file);
  DataBlockReader reader(text, sink, input.encoding);
  StlLexer lexer(text);
  Line line;
  while (lexer.next(line)) reader.line(line);
}

}  // namespace

extern const FileReader data_block_file{"data block", &rate, &read};

}  // namespace rungproof
