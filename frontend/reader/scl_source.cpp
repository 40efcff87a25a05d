// Reader of sources in SCL for the S7-300/400: blocks, data blocks and types.
#include "frontend/step7/scl_source.hpp"

#include "frontend/files/file_reader.hpp"
#include "frontend/step7/step7_project.hpp"
#include "frontend/stl/syntax_sink.hpp"
#include "frontend/xml/xml_text.hpp"
#include "ir/s7300/dialect.hpp"

namespace rungproof {

namespace {

int rate(const SourceFile& file, const InputText& input, const ReadOptions& options) {
  if (input.isSymbolFile || looksLikeXml(file.text())) return sureness::None;
  if (!options.allows(s7300Dialect) && !options.allows(s7400Dialect)) return sureness::None;
  const bool isNamed = endsInAny(file.name(), {".scl"});
  if (!step7::looksLikeScl(file.text(), isNamed)) return sureness::None;
  return isNamed ? sureness::Certain + 1 : sureness::Certain;
}

void read(Program& program, const InputText& input, const ReadOptions&) {
  SyntaxSink sink(program, input.file);
  input.step7->drawn.push_back(step7::readSclSource(program.sources->file(input.file), sink));
}

}  // namespace

extern const FileReader scl_source{"SCL source", &rate, &read};

}  // namespace rungproof
