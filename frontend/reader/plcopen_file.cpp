// Reader of PLCopen TC6 XML.
#include "frontend/files/file_reader.hpp"
#include "frontend/iec/iec_plcopen.hpp"
#include "frontend/plcopen/plcopen_reader.hpp"
#include "ir/iec/dialect.hpp"
#include "ir/s7200/dialect.hpp"

namespace rungproof {

namespace {

int rate(const SourceFile& file, const InputText& input, const ReadOptions& options) {
  if (input.isSymbolFile || !(options.allows(s7200Dialect) || options.allows(iecDialect))) return sureness::None;
  if (!looksLikeXml(file.text())) return sureness::None;
  const std::string_view text = file.text();
  if (text.find("plcopen.org/xml/tc6") != std::string_view::npos) return sureness::Certain;
  if (text.find("<project") != std::string_view::npos && text.find("<pou") != std::string_view::npos)
    return sureness::Keyword;
  return endsInAny(file.name(), {".xml"}) ? sureness::Ending : sureness::None;
}

/// Files with bodies in ST or SFC are programs of IEC 61131-3; drawings alone are read as an S7-200's where nothing
/// else is said.
void read(Program& program, const InputText& input, const ReadOptions& options) {
  const bool isText = options.dialect == iecDialect.name ||
                      (options.dialect == "auto" && iec::hasBodyOfThisFamily(program.sources->file(input.file).text()));
  if (isText) return iec::readPlcopenText(program, input, *input.iec);
  readPlcopen(program, input, *input.drawn);
  if (options.dialect == "auto") iec::readPlcopenText(*input.programAsIec, input, *input.drawnAsIec);
}

}  // namespace

extern const FileReader plcopen_file{"PLCopen XML", &rate, &read};

}  // namespace rungproof
