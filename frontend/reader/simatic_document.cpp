// Reader of the text documents of TIA Portal V20 and later: blocks (.s7dcl) and the texts of their titles (.s7res).
#include <iterator>

#include "frontend/files/file_reader.hpp"
#include "frontend/simaticsd/sd_document.hpp"
#include "frontend/step7/step7_project.hpp"
#include "frontend/stl/syntax_sink.hpp"
#include "ir/s7300/dialect.hpp"

namespace rungproof {

namespace {

int rate(const SourceFile& file, const InputText& input, const ReadOptions& options) {
  if (!options.allows(s7300Dialect) && !options.allows(s7400Dialect)) return sureness::None;
  const std::string_view text = file.text();
  if (input.isSymbolFile || (!simaticsd::looksLikeDocument(text) && !simaticsd::looksLikeTexts(text)))
    return sureness::None;
  return sureness::Certain + 1;
}

void read(Program& program, const InputText& input, const ReadOptions&) {
  const SourceFile& file = program.sources->file(input.file);
  SyntaxSink sink(program, input.file);
  step7::Step7Project& project = *input.step7;
  if (simaticsd::looksLikeTexts(file.text())) {
    project.texts.merge(simaticsd::readTexts(file.text()));
    return;
  }
  flgnet::DrawnSource drawn = simaticsd::readDocument(file, sink);
  project.drawn.push_back(std::move(drawn.source));
  std::ranges::move(drawn.symbols, std::back_inserter(project.drawnSymbols));
  std::ranges::move(drawn.instances, std::back_inserter(project.drawnInstances));
}

}  // namespace

extern const FileReader simatic_document{"SIMATIC document", &rate, &read};

}  // namespace rungproof
