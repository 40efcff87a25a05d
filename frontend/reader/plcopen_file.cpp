// Reader of PLCopen TC6 XML.
#include <fmt/format.h>

#include <algorithm>

#include "frontend/files/file_reader.hpp"
#include "frontend/iec/iec_plcopen.hpp"
#include "frontend/plcopen/plcopen_reader.hpp"
#include "frontend/stl/syntax_sink.hpp"
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

/// An address that only an S7-200 has: %VW10, %AIW0, %SM0.1. IEC 61131-3 knows %I, %Q and %M.
bool hasAddressOfS7200(std::string_view text) {
  constexpr std::string_view before = "\">( ", others = "VASTCHL";
  for (std::size_t at = text.find('%'); at != std::string_view::npos; at = text.find('%', at + 1)) {
    if (at == 0 || before.find(text[at - 1]) == std::string_view::npos) continue;
    std::size_t end = at + 1;
    while (end < text.size() && text[end] >= 'A' && text[end] <= 'Z') ++end;
    const std::string_view letters = text.substr(at + 1, end - at - 1);
    const bool isNumbered = end < text.size() && text[end] >= '0' && text[end] <= '9';
    if (isNumbered && !letters.empty() && letters.size() <= 3 && others.find(letters[0]) != std::string_view::npos)
      return true;
  }
  return false;
}

/// Whether the file says that it is of an S7-200: by the editor that its heading names, or by its addresses.
bool saysS7200(std::string_view text) {
  const std::size_t heading = text.find("fileHeader");
  const std::string_view editor = heading == std::string_view::npos
                                      ? std::string_view()
                                      : text.substr(heading, std::min(text.find('>', heading), text.size()) - heading);
  const bool isNamed =
      editor.find("S7-200") != std::string_view::npos || editor.find("Micro/WIN") != std::string_view::npos;
  return isNamed || hasAddressOfS7200(text);
}

/// A program of IEC 61131-3, unless the file says that it is one of an S7-200.
void read(Program& program, const InputText& input, const ReadOptions& options) {
  const SourceFile& file = program.sources->file(input.file);
  const bool isOfS7200 = saysS7200(file.text());
  const bool isIec = options.dialect == iecDialect.name ||
                     (options.dialect == "auto" && (!isOfS7200 || iec::hasBodyOfThisFamily(file.text())));
  if (isIec) return iec::readPlcopenText(program, input, *input.iec);
  if (!isOfS7200) {
    return SyntaxSink(program, input.file)
        .report(Syntax::NotOfS7200, {input.file, 0, 0},
                fmt::format("{} does not say that it is a program of an S7-200", file.name()));
  }
  readPlcopen(program, input, *input.drawn);
}

}  // namespace

extern const FileReader plcopen_file{"PLCopen XML", &rate, &read};

}  // namespace rungproof
