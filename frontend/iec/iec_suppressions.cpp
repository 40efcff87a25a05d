// Finding the comments again in the texts of a project.
#include "frontend/iec/iec_suppressions.hpp"

#include <algorithm>
#include <set>

#include "frontend/iec/iec_lexer.hpp"
#include "frontend/xml/xml_text.hpp"

namespace rungproof::iec {

namespace {

/// What every such comment holds; most texts have none, and are not cut into tokens again.
constexpr std::string_view toolName = "rungproof:";

std::set<std::uint32_t> textFilesOf(const ProjectSyntax& project) {
  std::set<std::uint32_t> files;
  for (const BlockSyntax& block : project.blocks) {
    if (!block.isLibrary && !block.isContract) files.insert(block.span.file);
  }
  for (const NamedType& type : project.types) files.insert(type.span.file);
  for (const VariableSyntax& variable : project.globals) files.insert(variable.span.file);
  return files;
}

}  // namespace

void addSuppressions(Program& program, const ProjectSyntax& project) {
  if (program.pous.empty()) return;
  for (const std::uint32_t file : textFilesOf(project)) {
    const std::string_view text = program.sources->file(file).text();
    if (looksLikeXml(text) || text.find(toolName) == std::string_view::npos) continue;
    Program unheard;
    SyntaxSink sink(unheard, file);
    std::vector<Directive> directives;
    std::vector<Span> comments;
    tokensOf({.text = text, .file = file}, sink, directives, &comments);
    for (const Span& comment : comments) {
      if (program.sources->text(comment).find(toolName) != std::string_view::npos)
        program.pous.front().comments.push_back({comment});
    }
  }
}

}  // namespace rungproof::iec
