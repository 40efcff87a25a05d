// Bodies are blanked in a copy, so that places stay what they are.
#include "frontend/step7/scl_source.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "frontend/step7/cursor.hpp"
#include "frontend/step7/source_keyword.hpp"
#include "frontend/step7/source_parser.hpp"
#include "frontend/step7/step7_likeness.hpp"
#include "frontend/stl/stl_lexer.hpp"

namespace rungproof::step7 {

namespace {

/// From behind BEGIN, or behind the last section, to the end of the block.
struct SclBody {
  std::uint32_t block = 0;  ///< where its heading begins
  std::uint32_t begin = 0, end = 0;
  bool hasBegin = false;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> sections;  ///< constants and labels, which only bodies use
};

bool endsCode(std::string_view word) {
  return equalsWord(word, "END_FUNCTION") || equalsWord(word, "END_FUNCTION_BLOCK") ||
         equalsWord(word, "END_ORGANIZATION_BLOCK");
}
bool headsCode(std::string_view word) {
  return equalsWord(word, "FUNCTION") || equalsWord(word, "FUNCTION_BLOCK") || equalsWord(word, "ORGANIZATION_BLOCK");
}

class SclBodies {
 public:
  SclBodies(std::string_view text, std::uint32_t file) : cursor_(text, file) {}

  std::vector<SclBody> find() {
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
    SclBody body;
    body.block = heading;
    while (next()) {
      if (endsCode(word_)) {
        body.end = static_cast<std::uint32_t>(cursor_.at() - word_.size());
        if (body.begin == 0) body.begin = body.end;
        bodies_.push_back(body);
        return;
      }
      const auto at = static_cast<std::uint32_t>(cursor_.at() - word_.size());
      if (!body.hasBegin && (equalsWord(word_, "CONST") || equalsWord(word_, "LABEL")))
        body.sections.emplace_back(at, at);
      if (!body.sections.empty() && (equalsWord(word_, "END_CONST") || equalsWord(word_, "END_LABEL")))
        body.sections.back().second = cursor_.at();
      const bool isBegin = equalsWord(word_, "BEGIN");
      const bool isSection =
          equalsWord(word_, "END_VAR") || equalsWord(word_, "END_CONST") || equalsWord(word_, "END_LABEL");
      if (!body.hasBegin && (isBegin || isSection)) body.begin = cursor_.at();
      body.hasBegin = body.hasBegin || isBegin;
    }
  }

  Cursor cursor_;
  std::string_view word_;
  std::vector<SclBody> bodies_;
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
  if (!likeness.isStructuredText()) return false;
  const std::vector<SclBody> bodies = SclBodies(text, 0).find();
  return !bodies.empty() && (isNamed || std::ranges::any_of(bodies, &SclBody::hasBegin));
}

SourceSyntax readSclSource(const SourceFile& file, SyntaxSink& sink) {
  const std::vector<SclBody> bodies = SclBodies(file.text(), sink.file()).find();
  std::string declared(file.text());
  for (const SclBody& body : bodies) {
    blankPart(declared, body.begin, body.end);
    for (const auto& [begin, end] : body.sections) blankPart(declared, begin, end);
  }
  SourceSyntax source = readSource(declared, {MnemonicSet::International, TextEncoding::Utf8}, sink);
  for (BlockSyntax& block : source.blocks) {
    const auto body = std::ranges::find(bodies, block.heading.offset, &SclBody::block);
    if (body == bodies.end()) continue;
    block.hasBody = true;
    block.networks.clear();
    NetworkSyntax& network = block.networks.emplace_back();
    network.number = 1;
    network.span = {sink.file(), body->begin, body->end - body->begin};
    Cursor cursor(file.text().substr(0, body->end), sink.file());
    cursor.to(body->begin);
    cursor.skipSpace();
    if (cursor.atEnd()) continue;  // nothing stands there
    network.isUnread = true;
    const std::string name = block.name.kind ? toString(block.name) : block.name.symbol;
    sink.setPlace(name, 1);
    sink.report(Syntax::BodyNotCovered, block.heading, fmt::format("{} is written in SCL, which is not covered", name));
    sink.setPlace({}, 0);
  }
  return source;
}

}  // namespace rungproof::step7
