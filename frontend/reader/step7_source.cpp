// Reader of STEP 7 sources and listings of the S7-300/400. What is read here becomes a program when all files are
// known.
#include "frontend/files/file_reader.hpp"
#include "frontend/step7/step7_likeness.hpp"
#include "frontend/step7/step7_project.hpp"
#include "frontend/step7/symbol_list.hpp"
#include "frontend/xml/xml_text.hpp"
#include "ir/s7300/dialect.hpp"

namespace rungproof {

namespace {

int rate(const SourceFile& file, const InputText& input, const ReadOptions& options) {
  if (input.isSymbolFile || looksLikeXml(file.text())) return sureness::None;
  const bool isNamed = options.dialect == s7300Dialect.name || options.dialect == s7400Dialect.name;
  if (!isNamed && options.dialect != "auto") return sureness::None;
  const step7::Step7Likeness likeness = step7::step7Likeness(file.text());
  if (likeness.isStructuredText()) return sureness::None;
  if (!likeness.hasHeading && step7::isSymbolList(file.text())) return sureness::None;
  if (likeness.isStep7()) return sureness::Certain;
  if (!isNamed) return sureness::None;
  return likeness.statements > 0 ? sureness::Certain : sureness::Ending;
}

void read(Program&, const InputText& input, const ReadOptions&) {
  input.step7->sources.push_back({input.file, input.encoding});
}

}  // namespace

extern const FileReader step7_source{"STEP 7 source", &rate, &read};

}  // namespace rungproof
