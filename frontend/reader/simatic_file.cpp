// Reader of SimaticML, the XML of TIA Portal (Openness). The portal has no S7-200: its programs are read as for an
// S7-300/400, whatever controller they were exported for.
#include <algorithm>
#include <iterator>

#include "frontend/files/file_reader.hpp"
#include "frontend/flgnet/block_reader.hpp"
#include "frontend/step7/step7_project.hpp"
#include "frontend/stl/syntax_sink.hpp"
#include "frontend/xml/xml_text.hpp"
#include "ir/s7300/dialect.hpp"

namespace rungproof {

namespace {

bool holds(const SourceFile& file, std::string_view element) {
  return file.text().find(element) != std::string_view::npos;
}
bool holdsTagsOnly(const SourceFile& file) { return !holds(file, "<SW.Blocks.") && !holds(file, "<SW.Types."); }

int rate(const SourceFile& file, const InputText& input, const ReadOptions&) {
  if (!looksLikeXml(file.text()) || (holdsTagsOnly(file) && !holds(file, "<SW.Tags."))) return sureness::None;
  return input.isSymbolFile ? sureness::Certain + 1 : sureness::Certain;
}

void read(Program& program, const InputText& input, const ReadOptions& options) {
  const SourceFile& file = program.sources->file(input.file);
  SyntaxSink sink(program, input.file);
  if (!options.allows(s7300Dialect) && !options.allows(s7400Dialect)) {
    return sink.report(Syntax::FamilyUndecided, {input.file, 0, 0},
                       "SimaticML is an export of TIA Portal, which has no programs of that dialect");
  }
  step7::Step7Project& project = *input.step7;
  if (!holdsTagsOnly(file)) {
    flgnet::DrawnSource drawn = flgnet::readBlocks(file, sink);
    project.drawn.push_back(std::move(drawn.source));
    std::ranges::move(drawn.symbols, std::back_inserter(project.drawnSymbols));
    std::ranges::move(drawn.instances, std::back_inserter(project.drawnInstances));
  }
  if (holds(file, "<SW.Tags.")) project.tables.push_back({input.file, input.encoding});
}

}  // namespace

extern const FileReader simatic_file{"SimaticML", &rate, &read};

}  // namespace rungproof
