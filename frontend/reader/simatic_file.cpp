// Reader of SimaticML.
#include <algorithm>
#include <iterator>

#include "frontend/files/file_reader.hpp"
#include "frontend/flgnet/block_reader.hpp"
#include "frontend/simatic/simatic_reader.hpp"
#include "frontend/step7/step7_project.hpp"
#include "frontend/stl/syntax_sink.hpp"
#include "ir/s7200/dialect.hpp"

namespace rungproof {

namespace {

bool holdsTagsOnly(const SourceFile& file) {
  return file.text().find("<SW.Blocks.") == std::string_view::npos &&
         file.text().find("<SW.Types.") == std::string_view::npos;
}

int rate(const SourceFile& file, const InputText& input, const ReadOptions&) {
  if (!looksLikeXml(file.text())) return sureness::None;
  const std::string_view text = file.text();
  if (holdsTagsOnly(file) && text.find("<SW.Tags.") == std::string_view::npos) return sureness::None;
  return input.isSymbolFile ? sureness::Certain + 1 : sureness::Certain;
}

/// What parts and types mean depends on the family.
void read(Program& program, const InputText& input, const ReadOptions& options) {
  const SourceFile& file = program.sources->file(input.file);
  const bool isForStep7 = input.isStep7Project || !options.allows(s7200Dialect);
  if (!isForStep7 || holdsTagsOnly(file)) return readSimatic(program, input, *input.drawn);
  SyntaxSink sink(program, input.file);
  flgnet::DrawnSource drawn = flgnet::readBlocks(file, sink);
  step7::Step7Project& project = *input.step7;
  project.drawn.push_back(std::move(drawn.source));
  std::ranges::move(drawn.symbols, std::back_inserter(project.drawnSymbols));
  if (file.text().find("<SW.Tags.") != std::string_view::npos) project.tables.push_back({input.file, input.encoding});
}

/// Its family is that of the sources beside it.
bool isToldByOthers(const SourceFile&) { return true; }

}  // namespace

extern const FileReader simatic_file{"SimaticML", &rate, &read, &isToldByOthers};

}  // namespace rungproof
