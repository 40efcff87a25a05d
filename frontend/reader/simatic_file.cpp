// Reader of SimaticML.
#include "frontend/files/file_reader.hpp"
#include "frontend/simatic/simatic_reader.hpp"

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

void read(Program& program, const InputText& input, const ReadOptions&) { readSimatic(program, input, *input.drawn); }

bool holdsTagsOnly(const SourceFile& file) { return file.text().find("<SW.Blocks.") == std::string_view::npos; }

}  // namespace

extern const FileReader simatic_file{"SimaticML", &rate, &read, &holdsTagsOnly};

}  // namespace rungproof
