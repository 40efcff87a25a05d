// Declarations are read by the reader of sources from a copy of the text in which all else is blank, so that places
// stay what they are; then the networks of each block, those in SCL as a syntax tree.
#include "frontend/simaticsd/sd_document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "frontend/flgnet/circuit_statements.hpp"
#include "frontend/simaticsd/sd_circuit.hpp"
#include "frontend/step7/scl_body.hpp"
#include "frontend/step7/source_parser.hpp"
#include "frontend/stl/directive.hpp"
#include "frontend/stl/stl_lexer.hpp"

namespace rungproof::simaticsd {

namespace {

using step7::BlockSyntax;
using step7::Cursor;

constexpr std::string_view sdByteOrderMark = "\xEF\xBB\xBF";

/// A piece of the text that is no declaration.
struct SdPiece {
  std::uint32_t begin = 0, end = 0;
  SdAttributes attributes;  ///< in front of a network or block
  std::uint32_t body = 0;   ///< of a network: behind the word
  bool isNetwork = false;
};

void blank(std::string& text, std::uint32_t begin, std::uint32_t end) {
  std::replace_if(
      text.begin() + begin, text.begin() + end, [](char c) { return c != '\n' && c != '\r'; }, ' ');
}

class DocumentReader {
 public:
  DocumentReader(const SourceFile& file, SyntaxSink& sink) : file_(file), sink_(sink) {}

  flgnet::DrawnSource read() {
    collect();
    std::string declared(file_.text());
    if (declared.starts_with(sdByteOrderMark)) blank(declared, 0, sdByteOrderMark.size());
    for (const SdPiece& piece : pieces_) blank(declared, piece.begin, piece.end);
    const step7::Spelling7 spelling{step7::MnemonicSet::International, TextEncoding::Utf8};
    result_.source = step7::readSource(declared, spelling, sink_);
    for (BlockSyntax& block : result_.source.blocks) complete(block);
    return std::move(result_);
  }

 private:
  /// Braces, and networks from the word to its end.
  void collect() {
    Cursor cursor(file_.text(), sink_.file());
    if (cursor.startsWith(sdByteOrderMark)) cursor.skip(sdByteOrderMark.size());
    SdPiece braces;
    bool hasBraces = false;
    for (cursor.skipSpace(); !cursor.atEnd(); cursor.skipSpace()) {
      const std::uint32_t begin = cursor.at();
      if (cursor.peek() == '{') {
        SdPiece piece;
        piece.begin = begin;
        piece.attributes = readAttributes(cursor);
        piece.end = endOfBraces(begin, cursor.at());
        pieces_.push_back(piece);
        braces = piece;
        hasBraces = true;
        continue;
      }
      if (cursor.peek() == '"' || cursor.peek() == '\'') {
        cursor.to(std::max(cursor.quotedEnd(), begin + 1));
        continue;
      }
      const std::string_view word = cursor.word();
      if (word.empty()) {
        cursor.skip(1);
        continue;
      }
      if (!step7::equalsWord(word, "NETWORK")) {
        if (hasBraces && isHeading(word)) ofBlocks_.emplace_back(begin, braces.attributes);
        hasBraces = false;
        continue;
      }
      SdPiece piece;
      piece.begin = begin;
      piece.isNetwork = true;
      piece.body = cursor.at();
      if (hasBraces) piece.attributes = braces.attributes;
      hasBraces = false;
      while (!cursor.atEnd() && !cursor.takeWord("END_NETWORK")) {
        if (cursor.peek() == '"')
          cursor.to(std::max(cursor.quotedEnd(), cursor.at() + 1));
        else if (cursor.word().empty())
          cursor.skip(1);
        cursor.skipSpace();
      }
      piece.end = cursor.at();
      pieces_.push_back(std::move(piece));
    }
  }

  /// Behind the last brace, not behind the blanks that follow.
  std::uint32_t endOfBraces(std::uint32_t begin, std::uint32_t end) const {
    const std::size_t last = file_.text().rfind('}', end == 0 ? 0 : end - 1);
    return last == std::string_view::npos || last < begin ? end : static_cast<std::uint32_t>(last + 1);
  }

  static bool isHeading(std::string_view word) {
    return std::ranges::any_of(std::array{"FUNCTION", "FUNCTION_BLOCK", "ORGANIZATION_BLOCK", "DATA_BLOCK", "TYPE"},
                               [&](std::string_view each) { return step7::equalsWord(word, each); });
  }

  void complete(BlockSyntax& block) {
    const bool isCode =
        block.kind == step7::BlockKind::Ob || block.kind == step7::BlockKind::Fc || block.kind == step7::BlockKind::Fb;
    if (isCode) block.hasBody = true;
    for (const auto& [at, attributes] : ofBlocks_) {
      if (at != block.heading.offset) continue;
      number(block, valueOf(attributes, "S7_BlockNumber"));
      block.title = valueOf(attributes, "S7_BlockTitle");
    }
    block.networks.clear();
    flgnet::BoxLabels labels;
    labelsOf(block, labels);
    for (const SdPiece& piece : pieces_) {
      if (piece.isNetwork && Span{block.span.file, piece.begin, 0}.beginsIn(block.span)) network(piece, block, labels);
    }
    sink_.setPlace({}, 0);
  }

  void number(BlockSyntax& block, std::string_view written) {
    std::uint32_t number = 0;
    const auto [end, error] = std::from_chars(written.data(), written.data() + written.size(), number);
    if (written.empty() || error != std::errc() || end != written.data() + written.size() || block.name.kind) return;
    step7::SymbolRow row;
    row.name = {block.name.symbol, block.name.span};
    block.name.kind = block.kind;
    block.name.number = number;
    row.address.form = step7::OperandForm::Block;
    row.address.block = block.name;
    row.address.span = block.name.span;
    if (!row.name.text.empty()) result_.symbols.push_back(std::move(row));
  }

  void labelsOf(const BlockSyntax& block, flgnet::BoxLabels& labels) const {
    for (const SdPiece& piece : pieces_) {
      if (!piece.isNetwork || !Span{block.span.file, piece.begin, 0}.beginsIn(block.span)) continue;
      Cursor cursor(file_.text(), sink_.file());
      cursor.to(piece.body);
      cursor.skipSpace();
      if (!cursor.takeWord("LABEL")) continue;
      cursor.skipSpace();
      cursor.take('(');
      cursor.skipSpace();
      labels.taken.emplace(cursor.word());
    }
  }

  void network(const SdPiece& piece, BlockSyntax& block, flgnet::BoxLabels& labels) {
    step7::NetworkSyntax& network = block.networks.emplace_back();
    network.number = static_cast<int>(block.networks.size());
    network.title = valueOf(piece.attributes, "S7_NetworkTitle");
    network.span = {sink_.file(), piece.begin, piece.end - piece.begin};
    sink_.setPlace(block.name.kind ? toString(block.name) : block.name.symbol, network.number);
    const std::string_view language = valueOf(piece.attributes, "S7_Language");
    const bool isFbd = equalsIgnoringCase(language, "FBD");
    if (equalsIgnoringCase(language, "SCL")) {
      const std::size_t last = file_.text().substr(0, piece.end).rfind("END_NETWORK");
      const std::uint32_t end =
          last == std::string_view::npos || last < piece.body ? piece.end : static_cast<std::uint32_t>(last);
      const step7::SclPlaces places{piece.body, end, {}};
      network.scl = step7::readSclBody(file_.text(), places, sink_, block, network);
      return;
    }
    if (!isFbd && !equalsIgnoringCase(language, "LAD") && !language.empty()) {
      sink_.report(Syntax::BodyNotCovered, network.span,
                   fmt::format("the network is written in {}, which is not covered", excerpt(language)));
      network.isUnread = true;
      return;
    }
    network.form = isFbd ? Form::Fbd : Form::Ladder;
    Cursor cursor(file_.text().substr(0, piece.end), sink_.file());
    cursor.to(piece.body);
    remarks(piece, block, network.number);
    const std::optional<flgnet::Circuit> circuit = readSdNetwork(cursor, block, sink_);
    if (circuit) flgnet::noteInstances(*circuit, block, result_.instances);
    if (!circuit || !flgnet::writeStatements(*circuit, labels, sink_, network)) network.isUnread = true;
  }

  /// Comments that speak to the tool.
  void remarks(const SdPiece& piece, BlockSyntax& block, int network) {
    const std::string_view text = file_.text().substr(piece.begin, piece.end - piece.begin);
    for (std::size_t at = text.find("//"); at != std::string_view::npos; at = text.find("//", at + 2)) {
      const std::size_t end = std::min(text.find('\n', at), text.size());
      const std::string_view line = trimmed(text.substr(at, end - at));
      if (const std::optional<std::string_view> said = directiveText(line)) {
        const auto begin = static_cast<std::uint32_t>(said->data() - file_.text().data());
        block.directives.push_back(
            {std::string(*said), {sink_.file(), begin, static_cast<std::uint32_t>(said->size())}, network});
      }
    }
  }

  const SourceFile& file_;
  SyntaxSink& sink_;
  std::vector<SdPiece> pieces_;
  std::vector<std::pair<std::uint32_t, SdAttributes>> ofBlocks_;  ///< by the offset of the heading
  flgnet::DrawnSource result_;
};

}  // namespace

bool looksLikeDocument(std::string_view text) {
  const bool hasRungs =
      text.find("END_RUNG") != std::string_view::npos && text.find("NETWORK") != std::string_view::npos;
  const bool hasBlock = text.find("END_FUNCTION") != std::string_view::npos ||
                        text.find("END_ORGANIZATION_BLOCK") != std::string_view::npos;
  const bool hasLanguage =
      text.find("S7_Language") != std::string_view::npos || text.find("S7_PreferredLanguage") != std::string_view::npos;
  return (hasRungs || hasLanguage) && hasBlock;
}

flgnet::DrawnSource readDocument(const SourceFile& file, SyntaxSink& sink) { return DocumentReader(file, sink).read(); }

bool looksLikeTexts(std::string_view text) {
  if (text.starts_with(sdByteOrderMark)) text.remove_prefix(sdByteOrderMark.size());
  return trimmed(text.substr(0, 64)).starts_with("MultiLingualTexts:");
}

std::map<std::string, std::string> readTexts(std::string_view text) {
  std::map<std::string, std::string> texts;
  std::string id;
  bool isEnglish = false, isBlock = false;
  std::size_t blockIndent = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view line = text.substr(at, end - at);
    const std::size_t indent = std::min(line.find_first_not_of(' '), line.size());
    std::string_view rest = trimmed(line);
    at = end + 1;
    if (isBlock && indent > blockIndent && !rest.empty()) {  // lines of a block scalar
      std::string& into = texts[id];
      if (isEnglish) into += (into.empty() ? "" : " ") + std::string(rest);
      continue;
    }
    isBlock = false;
    if (rest.starts_with("- ")) rest = trimmed(rest.substr(2));
    const std::size_t colon = rest.find(':');
    if (colon == std::string_view::npos) continue;
    const std::string_view key = trimmed(rest.substr(0, colon));
    std::string value(trimmed(rest.substr(colon + 1)));
    if (key == "id") {
      id = value;
      continue;
    }
    if (id.empty() || value.empty()) continue;
    isEnglish = key.starts_with("en") || !texts.contains(id);
    if (!isEnglish) continue;
    if (value[0] == '|' || value[0] == '>') {
      isBlock = true;
      blockIndent = indent;
      texts[id].clear();
      continue;
    }
    const char mark = value[0];
    if (value.size() >= 2 && (mark == '\'' || mark == '"') && value.back() == mark)
      value = value.substr(1, value.size() - 2);
    for (std::size_t twice = value.find("''"); mark == '\'' && twice != std::string::npos;
         twice = value.find("''", twice + 1))
      value.erase(twice, 1);
    texts[id] = value;
  }
  return texts;
}

}  // namespace rungproof::simaticsd
