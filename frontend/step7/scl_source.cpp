// Declarations are read from a copy in which the bodies are blank, so that places stay what they are; then the bodies.
#include "frontend/step7/scl_source.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "frontend/step7/cursor.hpp"
#include "frontend/step7/scl_body.hpp"
#include "frontend/step7/source_keyword.hpp"
#include "frontend/step7/source_parser.hpp"
#include "frontend/step7/step7_likeness.hpp"
#include "frontend/stl/stl_lexer.hpp"

namespace rungproof::step7 {

namespace {

/// From behind BEGIN, or behind the last section, to the end of the block.
struct SclBlock {
  std::uint32_t block = 0;  ///< where its heading begins
  SclPlaces places;
  bool hasBegin = false;
};

bool endsCode(std::string_view word) {
  return equalsWord(word, "END_FUNCTION") || equalsWord(word, "END_FUNCTION_BLOCK") ||
         equalsWord(word, "END_ORGANIZATION_BLOCK");
}
bool headsCode(std::string_view word) {
  return equalsWord(word, "FUNCTION") || equalsWord(word, "FUNCTION_BLOCK") || equalsWord(word, "ORGANIZATION_BLOCK");
}

class SclBlocks {
 public:
  SclBlocks(std::string_view text, std::uint32_t file) : cursor_(text, file) {}

  std::vector<SclBlock> find() {
    while (next()) {
      if (headsCode(word_)) block(static_cast<std::uint32_t>(cursor_.at() - word_.size()));
    }
    return std::move(bodies_);
  }

 private:
  /// The next word outside of comments, texts and braces; false: there is none.
  bool next() {
    for (cursor_.skipSpace(); !cursor_.atEnd(); cursor_.skipSpace()) {
      const char c = cursor_.peek();
      if (c == '"' || c == '\'') {
        cursor_.to(std::max(cursor_.quotedEnd(), cursor_.at() + 1));
      } else if (c == '{') {
        while (!cursor_.atEnd() && cursor_.peek() != '}') cursor_.skip(1);
        cursor_.take('}');
      } else if (word_ = cursor_.word(); !word_.empty()) {
        return true;
      } else {
        cursor_.skip(1);
      }
    }
    return false;
  }

  void block(std::uint32_t heading) {
    SclBlock body;
    body.block = heading;
    while (next()) {
      if (endsCode(word_)) {
        body.places.end = static_cast<std::uint32_t>(cursor_.at() - word_.size());
        if (body.places.begin == 0) body.places.begin = body.places.end;
        bodies_.push_back(body);
        return;
      }
      const auto at = static_cast<std::uint32_t>(cursor_.at() - word_.size());
      if (!body.hasBegin && (equalsWord(word_, "CONST") || equalsWord(word_, "LABEL")))
        body.places.sections.emplace_back(at, at);
      if (!body.places.sections.empty() && (equalsWord(word_, "END_CONST") || equalsWord(word_, "END_LABEL")))
        body.places.sections.back().second = cursor_.at();
      const bool isBegin = equalsWord(word_, "BEGIN");
      const bool isSection =
          equalsWord(word_, "END_VAR") || equalsWord(word_, "END_CONST") || equalsWord(word_, "END_LABEL");
      if (!body.hasBegin && (isBegin || isSection)) body.places.begin = cursor_.at();
      body.hasBegin = body.hasBegin || isBegin;
    }
  }

  Cursor cursor_;
  std::string_view word_;
  std::vector<SclBlock> bodies_;
};

void blankPart(std::string& text, std::uint32_t begin, std::uint32_t end) {
  std::replace_if(
      text.begin() + begin, text.begin() + end, [](char c) { return c != '\n' && c != '\r'; }, ' ');
}

}  // namespace

bool looksLikeScl(std::string_view text, bool isNamed) {
  const Step7Likeness likeness = step7Likeness(text);
  // Data blocks and types alone, too.
  if (isNamed && (likeness.hasHeading || text.find("END_DATA_BLOCK") != std::string_view::npos)) return true;
  if (!isNamed && !likeness.isStructuredText()) return false;
  const std::vector<SclBlock> bodies = SclBlocks(text, 0).find();
  return !bodies.empty() && (isNamed || std::ranges::any_of(bodies, &SclBlock::hasBegin));
}

SourceSyntax readSclSource(const SourceFile& file, SyntaxSink& sink) {
  const std::vector<SclBlock> bodies = SclBlocks(file.text(), sink.file()).find();
  std::string declared(file.text());
  for (const SclBlock& body : bodies) {
    blankPart(declared, body.places.begin, body.places.end);
    for (const auto& [begin, end] : body.places.sections) blankPart(declared, begin, end);
  }
  SourceSyntax source = readSource(declared, {MnemonicSet::International, TextEncoding::Utf8}, sink);
  for (BlockSyntax& block : source.blocks) {
    const auto body = std::ranges::find(bodies, block.heading.offset, &SclBlock::block);
    if (body == bodies.end()) continue;
    block.hasBody = true;
    block.networks.clear();
    NetworkSyntax& network = block.networks.emplace_back();
    network.number = 1;
    const SclPlaces& places = body->places;
    network.span = {sink.file(), places.begin, places.end - places.begin};
    Cursor cursor(file.text().substr(0, places.end), sink.file());
    cursor.to(places.begin);
    cursor.skipSpace();
    const bool isEmpty = cursor.atEnd();
    sink.setPlace(block.name.kind ? toString(block.name) : block.name.symbol, 1);
    network.scl = readSclBody(file.text(), places, sink, block, network);
    sink.setPlace({}, 0);
    if (isEmpty) network.scl = nullptr;
    block.isScl = !isEmpty;
  }
  return source;
}

}  // namespace rungproof::step7
