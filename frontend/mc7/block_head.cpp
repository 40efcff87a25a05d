// Heads.
#include "frontend/mc7/block_head.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "frontend/mc7/compiled_declaration.hpp"
#include "frontend/stl/stl_lexer.hpp"

namespace rungproof::mc7 {

namespace {

using step7::BlockKind;

struct FrameWords {
  BlockKind kind;
  std::string_view open, close;
};
/// System blocks are declared like those that they stand beside.
constexpr std::array<FrameWords, 7> frameWords = {{{BlockKind::Ob, "ORGANIZATION_BLOCK OB", "END_ORGANIZATION_BLOCK"},
                                                   {BlockKind::Fc, "FUNCTION FC", "END_FUNCTION"},
                                                   {BlockKind::Sfc, "FUNCTION FC", "END_FUNCTION"},
                                                   {BlockKind::Fb, "FUNCTION_BLOCK FB", "END_FUNCTION_BLOCK"},
                                                   {BlockKind::Sfb, "FUNCTION_BLOCK FB", "END_FUNCTION_BLOCK"},
                                                   {BlockKind::Db, "DATA_BLOCK DB", "END_DATA_BLOCK"},
                                                   {BlockKind::Udt, "TYPE UDT", "END_TYPE"}}};

const FrameWords& wordsOf(BlockKind kind) { return *std::ranges::find(frameWords, kind, &FrameWords::kind); }

/// The text without the line that declares a function's value VOID, which is none.
std::string withoutVoid(std::string_view text) {
  std::string kept;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size() - 1);
    const std::string_view line = text.substr(at, end - at + 1);
    const std::size_t colon = line.find(':');
    const std::string_view type = colon == std::string_view::npos ? "" : trimmed(line.substr(colon + 1));
    const bool isVoid =
        type.size() >= 4 && equalsIgnoringCase(type.substr(0, 4), "VOID") && trimmed(line).substr(0, 7) == "RET_VAL";
    if (!isVoid) kept += line;
    at = end + 1;
  }
  return kept;
}

std::string attributeLine(std::string_view keyword, std::string_view value) {
  const std::string text = asTitle(value);
  return trimmed(text).empty() ? "" : fmt::format("{} : {}\n", keyword, trimmed(text));
}

}  // namespace

std::string_view endKeywordOf(BlockKind kind) { return wordsOf(kind).close; }

std::string asTitle(std::string_view text) {
  std::string line(text);
  std::ranges::replace_if(
      line, [](char c) { return static_cast<unsigned char>(c) < 0x20; }, ' ');
  return line;
}

std::string asRemarks(std::string_view text) {
  std::string lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    lines += "//" + asTitle(text.substr(at, end - at)) + "\n";
    at = end + 1;
  }
  return lines;
}

BlockHead headOf(const StoredBlock& block, bool withProtection) {
  BlockHead head;
  const BlockKind kind = block.key.kind;
  head.text = fmt::format("{} {}{}\n", wordsOf(kind).open, block.key.number,
                          kind == BlockKind::Fc || kind == BlockKind::Sfc ? " : VOID" : "");
  head.text += fmt::format("TITLE ={}\n", asTitle(block.title));
  head.text += asRemarks(block.comment);
  if (withProtection && block.isProtected) head.text += "KNOW_HOW_PROTECT\n";
  if (kind != BlockKind::Udt) {
    head.text += attributeLine("AUTHOR", block.author) + attributeLine("FAMILY", block.family) +
                 attributeLine("NAME", block.name);
    head.text += fmt::format("VERSION : {}.{}\n", block.version >> 4, block.version & 15);
  }
  const CompiledDeclaration compiled = readCompiledDeclaration(block.declaration);
  if (kind == BlockKind::Db) {
    if (block.isUnlinked) head.text += "UNLINKED\n";
    if (block.isNonRetain) head.text += "NON_RETAIN\n";
    const bool isInstance =
        compiled.kind == DeclarationKind::InstanceOfFb || compiled.kind == DeclarationKind::InstanceOfSfb;
    if (isInstance && !block.declaration.empty()) {
      head.text +=
          fmt::format("{} {}\n", compiled.kind == DeclarationKind::InstanceOfFb ? "FB" : "SFB", compiled.number);
      return head;
    }
  }
  if (block.declarationText) {
    std::string text = withoutVoid(*block.declarationText);
    if (!text.empty() && !text.ends_with('\n')) text += '\n';
    head.text += text;
    return head;
  }
  head.fault = compiled.fault;
  if (kind == BlockKind::Db && compiled.text.empty())
    head.text += "STRUCT\nEND_STRUCT ;\n";
  else
    head.text += compiled.text;
  return head;
}

}  // namespace rungproof::mc7
