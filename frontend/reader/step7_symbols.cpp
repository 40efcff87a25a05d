// Reader of symbol tables of STEP 7 and of tag tables of TIA Portal, where the project is one of an S7-300/400.
#include "frontend/files/file_reader.hpp"
#include "frontend/step7/step7_project.hpp"
#include "frontend/step7/symbol_list.hpp"
#include "frontend/xml/xml_text.hpp"

namespace rungproof {

namespace {

int rate(const SourceFile& file, const InputText& input, const ReadOptions&) {
  if (!input.isStep7Project) return sureness::None;
  const std::string_view text = file.text();
  if (looksLikeXml(text)) {
    const bool isTable = text.find("<SW.Tags.PlcTagTable") != std::string_view::npos;
    const bool hasBlocks = text.find("<SW.Blocks.") != std::string_view::npos;
    return isTable && !hasBlocks ? sureness::Certain + 2 : sureness::None;
  }
  return input.isSymbolFile || step7::isSymbolList(text) ? sureness::Certain + 2 : sureness::None;
}

void read(Program&, const InputText& input, const ReadOptions&) {
  input.step7->tables.push_back({input.file, input.encoding});
}

}  // namespace

extern const FileReader step7_symbols{"symbol table of STEP 7", &rate, &read, [](const SourceFile&) { return true; }};

}  // namespace rungproof
