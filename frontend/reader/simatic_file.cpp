// Reader of SimaticML.
#include "frontend/files/file_reader.hpp"
#include "frontend/simatic/simatic_reader.hpp"
#include "frontend/stl/syntax_sink.hpp"
#include "ir/s7200/dialect.hpp"
#include "ir/s7300/coverage.hpp"

namespace rungproof {

namespace {

int rate(const SourceFile& file, const InputText& input, const ReadOptions&) {
  if (!looksLikeXml(file.text())) return sureness::None;
  const std::string_view text = file.text();
  const bool isBlock =
      text.find("<SW.Blocks.") != std::string_view::npos || text.find("<SW.Tags.") != std::string_view::npos;
  if (!isBlock) return sureness::None;
  return input.isSymbolFile ? sureness::Certain + 1 : sureness::Certain;
}

/// Drawn blocks mean what those of an S7-200 mean; for the other family nothing may rest on that.
void read(Program& program, const InputText& input, const ReadOptions& options) {
  const SourceFile& file = program.sources->file(input.file);
  const bool isForStep7 = input.isStep7Project || !options.allows(s7200Dialect);
  if (!isForStep7 || file.text().find("<SW.Blocks.") == std::string_view::npos)
    return readSimatic(program, input, *input.drawn);
  SyntaxSink(program, input.file)
      .report(Syntax::BodyNotCovered, {input.file, 0, 0}, std::string(gapReason(s7300::Gap::Drawing)));
}

bool holdsTagsOnly(const SourceFile& file) { return file.text().find("<SW.Blocks.") == std::string_view::npos; }

}  // namespace

extern const FileReader simatic_file{"SimaticML", &rate, &read, &holdsTagsOnly};

}  // namespace rungproof
