// The table of keywords.
#include "frontend/editor/structured_text.hpp"

#include <algorithm>
#include <array>

#include "frontend/files/disk_file.hpp"
#include "frontend/files/file_reader.hpp"
#include "frontend/stl/stl_lexer.hpp"

namespace rungproof {

namespace {

using enum Nesting;
constexpr std::array textWords = {TextWord{"PROGRAM", Opens},
                                  TextWord{"END_PROGRAM", Closes},
                                  TextWord{"FUNCTION", Opens},
                                  TextWord{"END_FUNCTION", Closes},
                                  TextWord{"FUNCTION_BLOCK", Opens},
                                  TextWord{"END_FUNCTION_BLOCK", Closes},
                                  TextWord{"CONFIGURATION", Opens},
                                  TextWord{"END_CONFIGURATION", Closes},
                                  TextWord{"RESOURCE", Opens},
                                  TextWord{"END_RESOURCE", Closes},
                                  TextWord{"TYPE", Opens},
                                  TextWord{"END_TYPE", Closes},
                                  TextWord{"STRUCT", Opens},
                                  TextWord{"END_STRUCT", Closes},
                                  TextWord{"VAR", Opens},
                                  TextWord{"VAR_INPUT", Opens},
                                  TextWord{"VAR_OUTPUT", Opens},
                                  TextWord{"VAR_IN_OUT", Opens},
                                  TextWord{"VAR_TEMP", Opens},
                                  TextWord{"VAR_GLOBAL", Opens},
                                  TextWord{"VAR_EXTERNAL", Opens},
                                  TextWord{"VAR_CONFIG", Opens},
                                  TextWord{"VAR_ACCESS", Opens},
                                  TextWord{"END_VAR", Closes},
                                  TextWord{"IF", Opens},
                                  TextWord{"THEN"},
                                  TextWord{"ELSIF", Between},
                                  TextWord{"ELSE", Between},
                                  TextWord{"END_IF", Closes},
                                  TextWord{"CASE", Opens},
                                  TextWord{"OF"},
                                  TextWord{"END_CASE", Closes},
                                  TextWord{"FOR", Opens},
                                  TextWord{"TO"},
                                  TextWord{"BY"},
                                  TextWord{"DO"},
                                  TextWord{"END_FOR", Closes},
                                  TextWord{"WHILE", Opens},
                                  TextWord{"END_WHILE", Closes},
                                  TextWord{"REPEAT", Opens},
                                  TextWord{"UNTIL", Between},
                                  TextWord{"END_REPEAT", Closes},
                                  TextWord{"STEP", Opens},
                                  TextWord{"INITIAL_STEP", Opens},
                                  TextWord{"END_STEP", Closes},
                                  TextWord{"TRANSITION", Opens},
                                  TextWord{"END_TRANSITION", Closes},
                                  TextWord{"ACTION", Opens},
                                  TextWord{"END_ACTION", Closes},
                                  TextWord{"EXIT"},
                                  TextWord{"CONTINUE"},
                                  TextWord{"RETURN"},
                                  TextWord{"AND"},
                                  TextWord{"OR"},
                                  TextWord{"XOR"},
                                  TextWord{"NOT"},
                                  TextWord{"MOD"},
                                  TextWord{"TRUE"},
                                  TextWord{"FALSE"},
                                  TextWord{"AT"},
                                  TextWord{"CONSTANT"},
                                  TextWord{"RETAIN"},
                                  TextWord{"NON_RETAIN"},
                                  TextWord{"ARRAY"},
                                  TextWord{"WITH"},
                                  TextWord{"TASK"},
                                  TextWord{"ON"}};

}  // namespace

std::span<const TextWord> structuredTextWords() { return textWords; }

const TextWord* structuredTextWord(std::string_view text) {
  const auto row =
      std::ranges::find_if(textWords, [&](const TextWord& one) { return equalsIgnoringCase(one.word, text); });
  return row == textWords.end() ? nullptr : &*row;
}

bool isStructuredText(const CheckedDocument& document) {
  return formOf(document.program().target) == StatementForm::Expressions &&
         !endsInAny(document.source().name(), {".xml"});
}

bool isSclText(const CheckedDocument& document) {
  return std::ranges::any_of(document.program().pous, [&](const Pou& pou) {
    return document.isHere(pou.span) && std::ranges::any_of(pou.networks, &Network::isStructured);
  });
}

std::vector<iec::IecToken> tokensOf(const CheckedDocument& document) { return tokensOf(document, document.file()); }

std::vector<iec::IecToken> tokensOf(const CheckedDocument& document, std::uint32_t file, std::vector<Span>* comments) {
  Program unheard;
  SyntaxSink sink(unheard, file);
  std::vector<Directive> directives;
  return iec::tokensOf(
      {.text = document.program().sources->file(file).text(), .file = file, .isScl = isSclText(document)}, sink,
      directives, comments);
}

std::vector<std::uint32_t> structuredTextsOf(const CheckedDocument& document) {
  std::vector<std::uint32_t> files;
  if (isSclText(document)) {
    files.push_back(document.file());
    for (const Pou& pou : document.program().pous) {
      const bool isScl = std::ranges::any_of(pou.networks, &Network::isStructured);
      if (isScl && !pou.isBuiltIn && std::ranges::find(files, pou.span.file) == files.end())
        files.push_back(pou.span.file);
    }
    return files;
  }
  if (formOf(document.program().target) != StatementForm::Expressions) return files;
  const SourceSet& sources = *document.program().sources;
  for (std::uint32_t file = 0; file < sources.size(); ++file) {
    const bool isOfProgram = std::ranges::any_of(document.files(), [&](const std::string& name) {
      return nameInProject(name, document.settings().root()) == sources.file(file).name();
    });
    if (isOfProgram && !endsInAny(sources.file(file).name(), {".xml", ".prop"})) files.push_back(file);
  }
  const auto own = std::ranges::find(files, document.file());
  if (own != files.end()) std::rotate(files.begin(), own, own + 1);
  return files;
}

}  // namespace rungproof
