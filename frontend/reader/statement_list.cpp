// Reader of statement lists: Micro/WIN and SMART exports, bare lists, and the older one-text dialect.
#include <algorithm>

#include "frontend/files/file_reader.hpp"
#include "frontend/stl/stl_likeness.hpp"
#include "frontend/stl/stl_parser.hpp"
#include "ir/s7200/dialect.hpp"

namespace rungproof {

namespace {

int rate(const SourceFile& file, const InputText& input, const ReadOptions& options) {
  if (input.isSymbolFile || !options.allows(s7200Dialect)) return sureness::None;
  const StlLikeness likeness = stlLikeness(file.text());
  if (likeness.isMarkup) return sureness::None;
  if (likeness.hasHeading) return sureness::Keyword;
  if (likeness.share >= 25) return sureness::Likely + likeness.share / 4;
  if (likeness.share > 0) return sureness::Ending + likeness.share / 4;
  return endsInAny(file.name(), {".awl", ".stl", ".il"}) ? sureness::Ending : sureness::None;
}

}  // namespace

extern const FileReader statement_list{"statement list", &rate, &readStatementList};

}  // namespace rungproof
