// Reader of IEC 61131-3 texts: blocks, types and configurations in ST. What is read here becomes a program when all
// files are known.
#include <cctype>

#include "frontend/files/file_reader.hpp"
#include "frontend/iec/iec_parser.hpp"
#include "frontend/stl/stl_lexer.hpp"
#include "frontend/xml/xml_text.hpp"
#include "ir/iec/dialect.hpp"

namespace rungproof {

namespace {

/// Whether a line consists of that word, or begins with it if `begins`.
bool hasLine(std::string_view text, std::string_view word, bool begins) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string line = iec::foldedName(trimmed(text.substr(0, end)));
    if (line.starts_with(word)) {
      const bool isAlone = line.size() == word.size() || line[word.size()] == ';' || line[word.size()] == '(';
      if (isAlone || (begins && line[word.size()] == ' ')) return true;
    }
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return false;
}

bool hasWord(std::string_view folded, std::string_view word) {
  const auto isPart = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  for (std::size_t at = folded.find(word); at != std::string_view::npos; at = folded.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if ((at == 0 || !isPart(folded[at - 1])) && (end >= folded.size() || !isPart(folded[end]))) return true;
  }
  return false;
}

int rateIec(const SourceFile& file, const InputText& input, const ReadOptions& options) {
  if (input.isSymbolFile || looksLikeXml(file.text()) || !options.allows(iecDialect)) return sureness::None;
  if (options.dialect == iecDialect.name) return sureness::Certain;
  const std::string_view text = file.text();
  // Sources of the S7-300/400 and SCL have BEGIN, and names of blocks in quotation marks.
  if (hasLine(text, "BEGIN", false) || hasLine(text, "NETWORK", true)) return sureness::None;
  const bool isNamed = endsInAny(file.name(), {".st", ".iecst", ".il"});
  const std::string folded = iec::foldedName(text);
  const bool hasProgram = hasWord(folded, "PROGRAM") && hasWord(folded, "END_PROGRAM");
  const bool hasBlock = hasWord(folded, "END_FUNCTION_BLOCK") || hasWord(folded, "END_FUNCTION") ||
                        hasWord(folded, "END_CONFIGURATION") || hasWord(folded, "END_TYPE");
  if (hasProgram || (hasBlock && isNamed)) return sureness::Certain;
  return isNamed ? sureness::Ending : sureness::None;
}

void readIec(Program& program, const InputText& input, const ReadOptions&) {
  SyntaxSink sink(program, input.file);
  iec::parseProject({program.sources->file(input.file).text(), input.file, 0, nullptr}, sink, *input.iec);
}

}  // namespace

extern const FileReader iec_text{"IEC 61131-3 text", &rateIec, &readIec};

}  // namespace rungproof
