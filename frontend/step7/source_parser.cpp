// Blocks and what stands in them.
#include "frontend/step7/source_parser.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "frontend/step7/source_keyword.hpp"
#include "frontend/step7/statement_parser.hpp"
#include "frontend/stl/stl_lexer.hpp"

namespace rungproof::step7 {

namespace {

class SourceParser {
 public:
  SourceParser(std::string_view text, const Spelling7& spelling, SyntaxSink& sink)
      : cursor_(text, sink.file()), spelling_(spelling), sink_(sink), declarations_(cursor_, spelling_, sink) {}

  SourceSyntax read() {
    source_.file = sink_.file();
    for (;;) {
      std::vector<Span> remarks;
      cursor_.skipSpace(remarks);
      if (cursor_.atEnd()) {
        noteDirectives(remarks, source_.directives, 0);
        break;
      }
      const SourceKeyword keyword = sourceKeywordOf(cursor_.peekWord());
      if (opensBlock(keyword)) {
        noteDirectives(remarks, source_.directives, 0);
        framedBlock(keyword);
      } else if (endsBlock(keyword)) {
        const std::string_view word = cursor_.word();
        noteDirectives(remarks, source_.directives, 0);
        sink_.report(Syntax::BlockNotOpen, cursor_.span(cursor_.at() - length(word), cursor_.at()),
                     fmt::format("{} without its heading", word));
      } else if (source_.blocks.empty() && !hasHeadingBehind()) {
        listing(remarks);
      } else {
        noteDirectives(remarks, source_.directives, 0);
        strayLines();
      }
    }
    return std::move(source_);
  }

 private:
  static std::uint32_t length(std::string_view word) { return static_cast<std::uint32_t>(word.size()); }

  /// Remarks are kept; those that begin with //@ are directives.
  void noteDirectives(const std::vector<Span>& remarks, std::vector<DirectiveSyntax>& directives, int network) {
    for (const Span& span : remarks) {
      const std::string_view text = cursor_.text().substr(span.offset, span.length);
      if (!text.starts_with("//@")) continue;
      const std::string_view rest = trimmed(text.substr(3));
      const auto begin =
          static_cast<std::uint32_t>(rest.empty() ? span.offset + 3 : rest.data() - cursor_.text().data());
      directives.push_back({std::string(rest), cursor_.span(begin, begin + length(rest)), network});
    }
  }

  std::string restOfLine() {
    cursor_.skipBlanks();
    const std::uint32_t end = cursor_.lineEnd();
    std::string text(trimmed(cursor_.slice(cursor_.at(), std::max(cursor_.at(), end))));
    cursor_.to(std::max(cursor_.at(), end));
    return text;
  }

  /// Whether a line further on opens a block: what stands before it is no list without a head.
  bool hasHeadingBehind() const {
    const std::string_view text = cursor_.text();
    for (std::size_t at = text.find('\n', cursor_.at()); at != std::string_view::npos; at = text.find('\n', at + 1)) {
      const std::string_view line = trimmed(text.substr(at + 1, text.find('\n', at + 1) - at - 1));
      std::size_t length = 0;
      while (length < line.size() && isWordByte(line[length])) ++length;
      if (opensBlock(sourceKeywordOf(line.substr(0, length)))) return true;
    }
    return false;
  }

  /// Lines between blocks: reported once, up to the next heading.
  void strayLines() {
    const std::uint32_t begin = cursor_.at();
    const std::uint32_t end = cursor_.lineEnd();
    sink_.report(Syntax::OutsideBlock, cursor_.span(begin, end),
                 fmt::format("\"{}\" stands outside of any block", excerpt(cursor_.slice(begin, end))));
    while (!cursor_.atEnd()) {
      cursor_.nextLine();
      cursor_.skipSpace();
      const SourceKeyword keyword = sourceKeywordOf(cursor_.peekWord());
      if (opensBlock(keyword) || endsBlock(keyword)) return;
    }
  }

  // Blocks ----------------------------------------------------------------------------------------------------------

  void listing(const std::vector<Span>& remarks) {
    BlockSyntax& block = source_.blocks.emplace_back();
    block.framed = false;
    block.hasBody = true;
    block.name = {BlockKind::Ob, 1, {}, cursor_.span(cursor_.at(), cursor_.at())};
    block.heading = block.name.span;
    const std::uint32_t begin = cursor_.at();
    openNetwork(block, begin);
    addRemarks(block, remarks);
    body(block, SourceKeyword::None);
    block.span = cursor_.spanFrom(begin);
  }

  static BlockKind kindOf(SourceKeyword keyword) {
    switch (keyword) {
      case SourceKeyword::OrganizationBlock: return BlockKind::Ob;
      case SourceKeyword::Function: return BlockKind::Fc;
      case SourceKeyword::FunctionBlock: return BlockKind::Fb;
      case SourceKeyword::DataBlock: return BlockKind::Db;
      default: return BlockKind::Udt;
    }
  }

  void framedBlock(SourceKeyword keyword) {
    const std::uint32_t begin = cursor_.at();
    cursor_.word();
    BlockSyntax block;
    block.kind = kindOf(keyword);
    name(block, begin);
    sink_.setPlace(block.name.kind ? toString(block.name) : block.name.symbol, 0);
    if (keyword == SourceKeyword::Function) {
      cursor_.skipSpace();
      if (cursor_.take(':')) {
        cursor_.skipSpace();
        block.type = declarations_.readType();
      }
    }
    block.heading = cursor_.spanFrom(begin);
    const std::size_t faults = declarations_.faults();
    head(block, keyword);
    if (declarations_.faults() > faults) block.declarationsRead = false;
    if (keyword == SourceKeyword::DataBlock && block.hasBody)
      assignments(block);
    else if (block.hasBody)
      body(block, keyword);
    close(block, keyword);
    block.span = cursor_.spanFrom(begin);
    source_.blocks.push_back(std::move(block));
    sink_.setPlace({}, 0);
  }

  void name(BlockSyntax& block, std::uint32_t begin) {
    cursor_.skipBlanks();
    const std::uint32_t from = cursor_.at();
    if (const std::optional<BlockName> byNumber = readBlockName(cursor_)) {
      block.name = *byNumber;
      if (*byNumber->kind == block.kind) return;
      sink_.report(Syntax::BlockHeading7, byNumber->span,
                   fmt::format("{} is no name of this kind of block", toString(*byNumber)));
      block.declarationsRead = false;
      return;
    }
    if (const std::optional<Name> symbol = cursor_.atLineEnd() ? std::nullopt : readName(cursor_)) {
      block.name = {std::nullopt, 0, symbol->text, symbol->span};
      return;
    }
    sink_.report(Syntax::BlockHeading7, cursor_.span(begin, std::max(from, cursor_.lineEnd())),
                 fmt::format("the name of the block is missing"));
    block.name.span = cursor_.span(begin, from);
    block.declarationsRead = false;
  }

  /// Attributes and declarations, in any order, up to BEGIN or the end.
  void head(BlockSyntax& block, SourceKeyword heading) {
    for (;;) {
      std::vector<Span> remarks;
      cursor_.skipSpace(remarks);
      noteDirectives(remarks, block.directives, 0);
      for (const Span& span : remarks) block.remarks.push_back({span});
      if (cursor_.atEnd()) return;
      const std::string_view word = cursor_.peekWord();
      const SourceKeyword keyword = sourceKeywordOf(word);
      if (keyword == SourceKeyword::Begin) {
        cursor_.skip(word.size());
        block.hasBody = true;
        return;
      }
      if (keyword == SourceKeyword::Network) {  // BEGIN is missing
        block.hasBody = true;
        return;
      }
      if (opensBlock(keyword) || endsBlock(keyword)) return;
      if (opensSection(keyword)) {
        section(block, keyword);
      } else if (cursor_.peek() == '{') {
        declarations_.skipAttributes();
      } else if (cursor_.peek() == ';') {
        cursor_.skip(1);
      } else if (!attribute(block) && !dataType(block, heading)) {
        const std::uint32_t begin = cursor_.at(), end = cursor_.lineEnd();
        sink_.report(Syntax::BlockHeading7, cursor_.span(begin, end),
                     fmt::format("\"{}\" is no line of a block's head", excerpt(cursor_.slice(begin, end))));
        block.declarationsRead = false;
        cursor_.to(std::max(end, begin + 1));
      }
    }
  }

  void section(BlockSyntax& block, SourceKeyword keyword) {
    cursor_.word();
    cursor_.skipBlanks();
    for (const std::string_view qualifier : {"RETAIN", "NON_RETAIN"}) cursor_.takeWord(qualifier);
    const bool isConstant = cursor_.takeWord("CONSTANT");
    Section section = Section::Static;
    if (keyword == SourceKeyword::VarInput) section = Section::Input;
    if (keyword == SourceKeyword::VarOutput) section = Section::Output;
    if (keyword == SourceKeyword::VarInOut) section = Section::InOut;
    if (keyword == SourceKeyword::VarTemp) section = Section::Temp;
    declarations_.readFields(section, "END_VAR", isConstant ? block.constants : block.declarations);
  }

  bool attribute(BlockSyntax& block) {
    const std::uint32_t back = cursor_.at();
    const std::string_view word = cursor_.word();
    struct Flag {
      std::string_view text;
      bool BlockSyntax::*value;
    };
    static constexpr std::array<Flag, 4> flags = {{{"KNOW_HOW_PROTECT", &BlockSyntax::knowHowProtected},
                                                   {"READ_ONLY", &BlockSyntax::readOnly},
                                                   {"UNLINKED", &BlockSyntax::unlinked},
                                                   {"NON_RETAIN", &BlockSyntax::nonRetain}}};
    for (const Flag& flag : flags) {
      if (!equalsWord(word, flag.text)) continue;
      block.*flag.value = true;
      return true;
    }
    // Of no meaning for what a block does.
    for (const std::string_view text : {"CODE_VERSION1", "STANDARD", "RETAIN", "TITLE_ENGLISH"}) {
      if (equalsWord(word, text)) return true;
    }
    if (equalsWord(word, "TITLE")) {
      cursor_.skipBlanks();
      if (cursor_.take('=')) {
        block.title = restOfLine();
        return true;
      }
    }
    struct Text {
      std::string_view text;
      std::string BlockSyntax::*value;
    };
    static constexpr std::array<Text, 4> texts = {{{"AUTHOR", &BlockSyntax::author},
                                                   {"FAMILY", &BlockSyntax::family},
                                                   {"NAME", &BlockSyntax::nameAttribute},
                                                   {"VERSION", &BlockSyntax::version}}};
    for (const Text& text : texts) {
      if (!equalsWord(word, text.text)) continue;
      cursor_.skipBlanks();
      if (cursor_.take(':') || cursor_.take('=')) {
        block.*text.value = valueOfAttribute();
        return true;
      }
    }
    cursor_.to(back);
    return false;
  }

  /// One word; the rest of the line, unless that goes on with the head.
  std::string valueOfAttribute() {
    cursor_.skipBlanks();
    const std::uint32_t begin = cursor_.at();
    const std::string whole = restOfLine();
    const std::size_t blank = whole.find_first_of(" \t");
    if (blank == std::string::npos) return whole;
    const std::string_view behind = trimmed(std::string_view(whole).substr(blank));
    std::size_t length = 0;
    while (length < behind.size() && isWordByte(behind[length])) ++length;
    const std::string_view next = behind.substr(0, length);
    constexpr std::array<std::string_view, 8> attributes = {"AUTHOR", "FAMILY",   "NAME",      "VERSION",
                                                            "TITLE",  "STANDARD", "READ_ONLY", "KNOW_HOW_PROTECT"};
    const bool goesOn = sourceKeywordOf(next) != SourceKeyword::None || equalsWord(next, "STRUCT") ||
                        std::ranges::any_of(attributes, [&](std::string_view word) { return equalsWord(next, word); });
    if (!goesOn) return whole;
    cursor_.to(begin + static_cast<std::uint32_t>(blank));
    return whole.substr(0, blank);
  }

  /// STRUCT, a UDT or an FB behind the head of a data block or of a type.
  bool dataType(BlockSyntax& block, SourceKeyword heading) {
    if (heading != SourceKeyword::DataBlock && heading != SourceKeyword::Type) return false;
    if (block.type != nullptr) return false;
    if (!isWordByte(cursor_.peek()) && cursor_.peek() != '"') return false;
    const std::uint32_t before = cursor_.at();
    block.type = declarations_.readType();
    if (cursor_.at() == before) return false;  // a word that begins no type
    cursor_.skipSpace();
    cursor_.take(';');
    return true;
  }

  void close(BlockSyntax& block, SourceKeyword heading) {
    const SourceKeyword keyword = sourceKeywordOf(cursor_.peekWord());
    if (keyword == endOf(heading)) {
      cursor_.word();
      cursor_.skipBlanks();
      cursor_.take(';');
      return;
    }
    block.isOpen = true;
    if (block.kind == BlockKind::Db || block.kind == BlockKind::Udt) block.declarationsRead = false;
    if (endsBlock(keyword)) {
      const std::string_view word = cursor_.peekWord();
      sink_.report(Syntax::BlockOpen, cursor_.span(cursor_.at(), cursor_.at() + length(word)),
                   fmt::format("{} ends a block that {} should end", word, keywordText(endOf(heading))));
      cursor_.skip(word.size());
      return;
    }
    sink_.report(Syntax::BlockOpen, block.heading, fmt::format("{} is missing", keywordText(endOf(heading))));
  }

  // Bodies ----------------------------------------------------------------------------------------------------------

  void openNetwork(BlockSyntax& block, std::uint32_t begin) {
    NetworkSyntax& network = block.networks.emplace_back();
    network.number = static_cast<int>(block.networks.size());
    network.span = cursor_.span(begin, begin);
    sink_.setNetwork(network.number);
  }

  void addRemarks(BlockSyntax& block, const std::vector<Span>& remarks) {
    if (remarks.empty()) return;
    NetworkSyntax& network = block.networks.back();
    for (const Span& span : remarks) network.remarks.push_back({span});
    noteDirectives(remarks, block.directives, network.number);
  }

  /// Statements up to a word that ends the block; of a list without a head only a heading does.
  void body(BlockSyntax& block, SourceKeyword heading) {
    for (;;) {
      std::vector<Span> remarks;
      const std::uint32_t before = cursor_.at();
      cursor_.skipSpace(remarks);
      if (!remarks.empty()) {
        if (block.networks.empty()) openNetwork(block, before);
        addRemarks(block, remarks);
      }
      if (cursor_.atEnd()) break;
      if (cursor_.take(';')) continue;
      const SourceKeyword keyword = sourceKeywordOf(cursor_.peekWord());
      if (opensBlock(keyword) || endsBlock(keyword)) break;
      if (keyword == SourceKeyword::Network) {
        network(block);
        continue;
      }
      if (!block.networks.empty() && title(block)) continue;
      statement(block);
    }
    for (std::size_t i = 0; i + 1 < block.networks.size(); ++i)
      endNetwork(block.networks[i], block.networks[i + 1].span.offset);
    if (!block.networks.empty()) endNetwork(block.networks.back(), cursor_.at());
    sink_.setNetwork(0);
    if (heading == SourceKeyword::None) return;
  }

  static void endNetwork(NetworkSyntax& network, std::uint32_t end) {
    network.span.length = end > network.span.offset ? end - network.span.offset : 0;
  }

  /// NETWORK, and in listings a number and a title behind it.
  void network(BlockSyntax& block) {
    const std::uint32_t begin = cursor_.at();
    cursor_.word();
    const bool isFirst = block.networks.size() == 1 && block.networks[0].statements.empty() &&
                         block.networks[0].title.empty() && !block.framed;
    if (!isFirst) openNetwork(block, begin);
    cursor_.skipBlanks();
    cursor_.take(':');
    cursor_.skipBlanks();
    while (isDecimal(cursor_.peek())) cursor_.skip(1);
    cursor_.skipBlanks();
    if (cursor_.peek() == ':' || cursor_.peek() == '-') cursor_.skip(1);
    if (!cursor_.atLineEnd()) block.networks.back().title = restOfLine();
  }

  /// TITLE = text behind NETWORK.
  bool title(BlockSyntax& block) {
    NetworkSyntax& network = block.networks.back();
    if (!network.statements.empty() || !equalsWord(cursor_.peekWord(), "TITLE")) return false;
    const std::uint32_t back = cursor_.at();
    cursor_.word();
    cursor_.skipBlanks();
    if (cursor_.take('=')) {
      network.title = restOfLine();
      return true;
    }
    cursor_.to(back);
    return false;
  }

  void statement(BlockSyntax& block) {
    if (block.networks.empty()) openNetwork(block, cursor_.at());
    std::vector<Span> remarks;
    Statement read = readStatement(cursor_, spelling_, remarks);
    addRemarks(block, remarks);
    block.networks.back().statements.push_back(std::move(read));
  }

  /// name.part[1] := value; up to END_DATA_BLOCK.
  void assignments(BlockSyntax& block) {
    for (;;) {
      std::vector<Span> remarks;
      cursor_.skipSpace(remarks);
      noteDirectives(remarks, block.directives, 0);
      if (cursor_.atEnd()) return;
      if (cursor_.take(';')) continue;
      const SourceKeyword keyword = sourceKeywordOf(cursor_.peekWord());
      if (opensBlock(keyword) || endsBlock(keyword)) return;
      assignment(block);
    }
  }

  void assignment(BlockSyntax& block) {
    const std::uint32_t begin = cursor_.at();
    Assignment assignment;
    const auto fail = [&](std::string message) {
      const std::uint32_t end = std::max(std::min(cursor_.lineEnd(), cursor_.at()), begin + 1);
      sink_.report(Syntax::Assignment7, cursor_.span(begin, end), std::move(message));
      block.declarationsRead = false;
      declarations_.recover();
    };
    const std::optional<Name> name = cursor_.peek() == '\'' ? std::nullopt : readName(cursor_);
    if (!name) return fail("an assignment begins with a name");
    assignment.path.push_back({name->text, {}, name->span});
    std::string fault = readIndices(cursor_, assignment.path);
    if (fault.empty()) fault = readParts(cursor_, assignment.path);
    if (!fault.empty()) return fail(std::move(fault));
    assignment.span = cursor_.spanFrom(begin);
    cursor_.skipSpace();
    if (!cursor_.startsWith(":=")) return fail(fmt::format(":= is missing behind {}", name->text));
    cursor_.skip(2);
    if (!declarations_.readValues(assignment.values)) {
      block.declarationsRead = false;
      return declarations_.recover();
    }
    cursor_.skipSpace();
    block.assignments.push_back(std::move(assignment));
    if (!cursor_.take(';')) fail("a semicolon is missing behind the value");
  }

  Cursor cursor_;
  Spelling7 spelling_;
  SyntaxSink& sink_;
  DeclarationParser declarations_;
  SourceSyntax source_;
};

}  // namespace

SourceSyntax readSource(std::string_view text, const Spelling7& spelling, SyntaxSink& sink) {
  return SourceParser(text, spelling, sink).read();
}

}  // namespace rungproof::step7
