// The parser: one line at a time, a small state for the section it is in.
#include "frontend/stl/stl_parser.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "frontend/stl/data_block.hpp"
#include "frontend/stl/declaration.hpp"
#include "frontend/stl/directive.hpp"
#include "frontend/stl/pou_builder.hpp"
#include "frontend/stl/stl_keyword.hpp"
#include "frontend/stl/stl_likeness.hpp"
#include "frontend/stl/stl_statement.hpp"
#include "frontend/stl/symbol_table.hpp"

namespace rungproof {

namespace {

enum class Section : std::uint8_t { Outside, Heading, Variables, Body, Data, Symbols };

/// A heading or an end of a block or a table.
bool opensOrEnds(Keyword keyword) {
  switch (keyword) {
    case Keyword::OrganizationBlock:
    case Keyword::SubroutineBlock:
    case Keyword::InterruptBlock:
    case Keyword::DataBlock:
    case Keyword::SymbolTable:
    case Keyword::EndOrganizationBlock:
    case Keyword::EndSubroutineBlock:
    case Keyword::EndInterruptBlock:
    case Keyword::EndDataBlock:
    case Keyword::EndSymbolTable: return true;
    default: return false;
  }
}

class StlParser {
 public:
  StlParser(Program& program, const InputText& input, Spelling spelling)
      : program_(program),
        source_(program.sources->file(input.file)),
        text_(source_.text()),
        sink_(program, input.file),
        lexer_(text_),
        statements_(source_, sink_, {spelling, input.encoding}),
        data_(text_, sink_, input.encoding),
        blocks_(program, text_, sink_) {}

  void run() {
    while (lexer_.next(line_)) {
      if (line_.words.empty()) {
        keepComment();
        continue;
      }
      std::size_t length = 0;
      const Keyword keyword = keywordOf(word(0), length);
      if (keyword == Keyword::None) lastLineFailed_ = false;
      if (keyword == Keyword::None) {
        plainLine();
      } else {
        keywordLine(keyword, length);
      }
    }
    if (blocks_.isFramed() && !lastLineFailed_) blocks_.reportOpen();
    blocks_.finish(static_cast<std::uint32_t>(text_.size()));
    closeOpenTable();
  }

 private:
  std::string_view slice(std::uint32_t begin, std::uint32_t end) const { return text_.substr(begin, end - begin); }
  std::string_view word(std::size_t i) const {
    return i < line_.words.size() ? lexer_.slice(line_.words[i]) : std::string_view();
  }
  Span statementSpan() const { return sink_.span(line_.begin, line_.end); }
  std::string statementText() const { return excerpt(slice(line_.begin, line_.end)); }

  /// End of the physical line that holds the current statement; the lexer goes on after it.
  std::uint32_t takeRestOfLine() {
    std::size_t newline = text_.find('\n', line_.begin);
    if (newline == std::string_view::npos) newline = text_.size();
    lexer_.rewind(static_cast<std::uint32_t>(std::min(newline + 1, text_.size())));
    if (newline > line_.begin && text_[newline - 1] == '\r') --newline;
    return static_cast<std::uint32_t>(newline);
  }

  void keepComment() {
    if (!line_.hasComment()) return;
    const Span span = sink_.span(line_.commentBegin, line_.commentEnd);
    if (line_.isBanner) {
      const std::string shown = excerpt(slice(line_.commentBegin, line_.commentEnd));
      sink_.report(Syntax::StrayText, span, fmt::format("\"{}\" has no comment sign and was read as a comment", shown));
    }
    blocks_.addComment(span);
  }

  void keywordLine(Keyword keyword, std::size_t length) {
    switch (keyword) {
      case Keyword::OrganizationBlock: openFramed(PouKind::Main); break;
      case Keyword::SubroutineBlock: openFramed(PouKind::Subroutine); break;
      case Keyword::InterruptBlock: openFramed(PouKind::Interrupt); break;
      case Keyword::EndOrganizationBlock: closeFramed(PouKind::Main); break;
      case Keyword::EndSubroutineBlock: closeFramed(PouKind::Subroutine); break;
      case Keyword::EndInterruptBlock: closeFramed(PouKind::Interrupt); break;
      case Keyword::DataBlock: openTable(Section::Data); break;
      case Keyword::SymbolTable: openTable(Section::Symbols); break;
      case Keyword::EndDataBlock: closeTable(Section::Data); break;
      case Keyword::EndSymbolTable: closeTable(Section::Symbols); break;
      case Keyword::VarInput: openVariables(VarSection::Input); break;
      case Keyword::VarInOut: openVariables(VarSection::InOut); break;
      case Keyword::VarOutput: openVariables(VarSection::Output); break;
      case Keyword::Var: openVariables(VarSection::Temp); break;
      case Keyword::EndVar: endVariables(); break;
      case Keyword::Begin: begin(); break;
      case Keyword::Network: networkHeading(length); break;
      case Keyword::NetworkTitle:
      case Keyword::Title: title(length); break;
      case Keyword::NetworkComment: blocks_.addComment(sink_.span(line_.begin, takeRestOfLine())); break;
      case Keyword::None: break;
    }
  }

  void plainLine() {
    switch (section_) {
      case Section::Variables:
        readDeclaration(text_, line_.begin, line_.end, variables_, sink_, blocks_.locals());
        break;
      case Section::Data: {
        const std::size_t before = program_.findings.size();
        data_.line(line_);
        lastLineFailed_ = program_.findings.size() > before;
        break;
      }
      case Section::Symbols: return symbolRow();
      default: return instructionLine();
    }
    keepComment();
  }

  // Frames --------------------------------------------------------------------------------------------------------

  /// An unreadable line in front of the next heading may be the end that is missing.
  void closeWhatIsOpen() {
    if (blocks_.isFramed() && !lastLineFailed_) blocks_.reportOpen();
    blocks_.close(line_.begin);
    closeOpenTable();
  }

  void openFramed(PouKind kind) {
    closeWhatIsOpen();
    const std::uint32_t end = line_.hasComment() ? line_.commentBegin : takeRestOfLine();
    blocks_.open(readHeading(kind, slice(line_.words[0].end, end)), sink_.span(line_.begin, end), true);
    section_ = Section::Heading;
    keepComment();
  }

  void closeFramed(PouKind kind) {
    const bool matches = blocks_.isFramed() && blocks_.kind() == kind;
    if (!matches)
      sink_.report(Syntax::BlockNotOpen, statementSpan(), fmt::format("{} without its heading", statementText()));
    blocks_.close(line_.end);
    section_ = Section::Outside;
    keepComment();
  }

  /// Keyword of the line, with `continuation_` as that line.
  Keyword lookedAt() {
    std::size_t length = 0;
    return continuation_.words.empty() ? Keyword::None : keywordOf(lexer_.slice(continuation_.words[0]), length);
  }
  /// Keyword of the next line that has words; None behind the last one too.
  Keyword nextKeyword() {
    const std::uint32_t back = lexer_.position();
    continuation_.words.clear();
    while (continuation_.words.empty() && lexer_.next(continuation_)) {
    }
    const Keyword keyword = lookedAt();
    lexer_.rewind(back);
    return keyword;
  }
  /// The next heading or end of a block or table; the text is looked through once.
  Keyword nextFrame() {
    const std::uint32_t back = lexer_.position();
    if (back < frameFrom_ || back >= frameAt_) {
      frame_ = Keyword::None;
      frameFrom_ = back;
      while (frame_ == Keyword::None && lexer_.next(continuation_)) {
        if (opensOrEnds(lookedAt())) frame_ = lookedAt();
      }
      frameAt_ = frame_ == Keyword::None ? static_cast<std::uint32_t>(text_.size()) + 1 : continuation_.begin;
      lexer_.rewind(back);
    }
    return frame_;
  }

  /// The line stands where a heading is missing: what follows belongs to a block, or to a table, whose end is there.
  bool readLostHeading() {
    const Keyword end = nextFrame();
    if (end == Keyword::EndDataBlock || end == Keyword::EndSymbolTable) {
      outsideLine();
      table_ = statementSpan();
      data_.begin();
      section_ = end == Keyword::EndDataBlock ? Section::Data : Section::Symbols;
      return true;
    }
    const Keyword first = nextKeyword();
    if (first == Keyword::None || opensOrEnds(first)) return false;
    if (end != Keyword::EndOrganizationBlock && end != Keyword::EndSubroutineBlock && end != Keyword::EndInterruptBlock)
      return false;
    Heading heading;
    heading.kind = end == Keyword::EndOrganizationBlock ? PouKind::Main
                   : end == Keyword::EndSubroutineBlock ? PouKind::Subroutine
                                                        : PouKind::Interrupt;
    blocks_.open(std::move(heading), statementSpan(), true);
    section_ = Section::Heading;
    keepComment();
    return true;
  }

  /// A line in the head of a block that is no instruction: the head goes on behind it, or declarations follow whose VAR
  /// is missing.
  bool readLostHeadLine() {
    if (s7200Instructions().named(word(0)) != nullptr) return false;
    const Keyword keyword = nextKeyword();
    const bool isDeclared =
        keyword == Keyword::None && slice(continuation_.begin, continuation_.end).find(':') != std::string_view::npos;
    const bool isHead = keyword == Keyword::Title || keyword == Keyword::Begin || keyword == Keyword::Var ||
                        keyword == Keyword::VarInput || keyword == Keyword::VarInOut || keyword == Keyword::VarOutput;
    if (!isDeclared && !isHead) return false;
    sink_.report(Syntax::Declaration, statementSpan(),
                 isHead ? fmt::format("\"{}\" stands in the head of a block", statementText())
                        : fmt::format("\"{}\" does not say which declarations follow", statementText()));
    if (isDeclared) {
      resumeSection_ = Section::Heading;
      section_ = Section::Variables;
      variables_ = VarSection::Temp;
    }
    keepComment();
    return true;
  }

  void begin() {
    if (section_ == Section::Variables) section_ = Section::Heading;
    if (section_ == Section::Heading) {
      blocks_.startBody(line_.end);
      section_ = Section::Body;
    } else if (section_ == Section::Outside || section_ == Section::Body) {
      sink_.report(Syntax::OutsideBlock, statementSpan(), "BEGIN without the heading of a block");
    }
    keepComment();
  }

  void openVariables(VarSection section) {
    if (section_ != Section::Heading && section_ != Section::Variables) {
      sink_.report(Syntax::OutsideBlock, statementSpan(),
                   "declarations stand between the heading of a block and BEGIN");
      if (!blocks_.isOpen()) return;
    }
    if (section_ != Section::Variables) resumeSection_ = section_;
    section_ = Section::Variables;
    variables_ = section;
    keepComment();
  }

  void endVariables() {
    if (section_ != Section::Variables)
      return sink_.report(Syntax::OutsideBlock, statementSpan(), "END_VAR without VAR");
    section_ = resumeSection_;
    keepComment();
  }

  void title(std::size_t length) {
    const std::uint32_t end = takeRestOfLine();
    std::string_view text = trimmed(slice(line_.begin + static_cast<std::uint32_t>(length), end));
    if (!text.empty() && text[0] == '=') text = trimmed(text.substr(1));
    if (blocks_.isOpen()) return blocks_.setTitle(text);
    if (section_ == Section::Outside) blocks_.addComment(sink_.span(line_.begin, end));
  }

  // Tables --------------------------------------------------------------------------------------------------------

  void openTable(Section section) {
    closeWhatIsOpen();
    section_ = section;
    table_ = statementSpan();
    data_.begin();
    blocks_.noteTable();
    takeRestOfLine();
  }
  void closeTable(Section section) {
    if (section_ != section)
      sink_.report(Syntax::BlockNotOpen, statementSpan(), fmt::format("{} without its heading", statementText()));
    if (!blocks_.isOpen()) section_ = Section::Outside;
  }
  void closeOpenTable() {
    const bool isOpen = section_ == Section::Data || section_ == Section::Symbols;
    if (isOpen && !lastLineFailed_) blocks_.reportOpen(table_, "table");
    section_ = Section::Outside;
  }
  void symbolRow() {
    const std::uint32_t end = takeRestOfLine();
    if (readSymbolRow(text_, line_.begin, end, statements_.context().spelling, sink_)) return;
    sink_.report(Syntax::SymbolRow, sink_.span(line_.begin, end),
                 fmt::format("\"{}\" is not a row of name and address", excerpt(slice(line_.begin, end))));
  }

  // Networks and instructions -------------------------------------------------------------------------------------

  void openImplicitMain() {
    closeOpenTable();
    blocks_.openMain(line_.begin);
    section_ = Section::Body;
  }

  void networkHeading(std::size_t length) {
    if (!blocks_.isOpen()) openImplicitMain();
    section_ = Section::Body;
    blocks_.startNetwork(blocks_.nextNetworkNumber(), line_.begin);
    std::string_view digits = word(0).substr(length);
    std::size_t titleWord = 1;
    if (digits.empty() && line_.words.size() > 1) {
      digits = word(1);
      titleWord = 2;
    }
    while (!digits.empty() && (digits.back() == ':' || digits.back() == '.')) digits.remove_suffix(1);
    const bool isNumber = !digits.empty() && std::all_of(digits.begin(), digits.end(), isDigit);
    if (!isNumber) titleWord = 1;
    if (isNumber && digits.size() <= 6) {
      blocks_.renumberNetwork(std::stoi(std::string(digits)));
    } else if (isNumber) {
      sink_.report(Syntax::NetworkHeading, statementSpan(),
                   fmt::format("network number \"{}\" is too large", excerpt(digits)));
    }
    const bool speaks = line_.hasComment() && speaksToTool(slice(line_.commentBegin, line_.commentEnd));
    if (line_.hasComment() && !speaks) {
      blocks_.setNetworkTitle(trimmed(slice(line_.commentBegin + 2, line_.commentEnd)));
    } else if (line_.words.size() > titleWord) {
      blocks_.setNetworkTitle(trimmed(slice(line_.words[titleWord].begin, line_.end)));
    }
    if (speaks) keepComment();
    takeRestOfLine();
  }

  void openOlder(Heading heading) {
    program_.olderDialect = program_.olderDialect || heading.kind != PouKind::Main;
    blocks_.releaseTrailingComments();
    blocks_.close(line_.begin);
    blocks_.open(std::move(heading), statementSpan(), false);
    blocks_.startBody(line_.end);
    section_ = Section::Body;
    keepComment();
  }

  /// Lines behind the end of a block; neighbouring ones share a finding.
  void outsideLine() {
    std::vector<Finding>& findings = program_.findings;
    if (outsideLines_ > 0 && outsideFinding_ + 1 == findings.size()) {
      Finding& finding = findings[outsideFinding_];
      finding.span.length = line_.end - finding.span.offset;
      finding.message = fmt::format("{} lines outside of any block", ++outsideLines_);
    } else {
      outsideLines_ = 1;
      outsideFinding_ = findings.size();
      sink_.report(Syntax::OutsideBlock, statementSpan(),
                   fmt::format("\"{}\" stands outside of any block", statementText()));
    }
    keepComment();
  }

  void instructionLine() {
    if (!blocks_.isFramed()) {
      if (auto heading = readOlderHeading(word(0), word(1), line_.words.size())) return openOlder(std::move(*heading));
      if (isDataLine(text_, line_)) {  // data under the listing, as in the older dialect
        data_.line(line_);
        return keepComment();
      }
    }
    if (!blocks_.isOpen() && readLostHeading()) return;
    if (section_ == Section::Heading && readLostHeadLine()) return;
    if (!blocks_.isOpen()) {
      if (blocks_.hadBlock()) return outsideLine();
      openImplicitMain();
    }
    if (section_ == Section::Heading) {
      blocks_.startBody(line_.begin);
      section_ = Section::Body;
    }
    blocks_.needNetwork(line_.begin);
    joinContinuations();
    const Span span = statementSpan();
    switch (statements_.read(line_, instruction_)) {
      case StatementKind::Damaged: blocks_.addDamage(span.offset); [[fallthrough]];
      case StatementKind::Instruction:
        program_.olderDialect = program_.olderDialect || instruction_.desc->olderDialectOnly;
        blocks_.addInstruction(std::move(instruction_));
        instruction_ = Instruction{};
        break;
      case StatementKind::Stray: blocks_.addComment(span); break;
      case StatementKind::Failed:
        blocks_.addDamage(span.offset);
        lastLineFailed_ = true;
        break;
    }
    keepComment();
  }

  /// A statement that ends with a comma goes on in the next line, unless that line begins with an instruction.
  void joinContinuations() {
    constexpr std::size_t mostWords = 64;  // far above the 17 operands of a CALL
    while (line_.endsWithComma && !line_.hasComment() && line_.words.size() < mostWords) {
      const std::uint32_t back = lexer_.position();
      if (!lexer_.next(continuation_) || continuation_.words.empty() || continuation_.isBanner ||
          s7200Instructions().named(lexer_.slice(continuation_.words[0])) != nullptr) {
        return lexer_.rewind(back);
      }
      sink_.report(Syntax::LenientSpelling, sink_.span(line_.begin, continuation_.end),
                   "the statement goes on in the next line");
      continuation_.words[0].afterComma = true;
      line_.words.insert(line_.words.end(), continuation_.words.begin(), continuation_.words.end());
      line_.end = continuation_.end;
      line_.commentBegin = continuation_.commentBegin;
      line_.commentEnd = continuation_.commentEnd;
      line_.endsWithComma = continuation_.endsWithComma;
      line_.openQuote = line_.openQuote || continuation_.openQuote;
    }
  }

  Program& program_;
  const SourceFile& source_;
  std::string_view text_;
  SyntaxSink sink_;
  StlLexer lexer_;
  StatementReader statements_;
  DataBlockReader data_;
  PouBuilder blocks_;
  Line line_;
  Line continuation_;
  Instruction instruction_;
  Section section_ = Section::Outside;
  Section resumeSection_ = Section::Outside;
  VarSection variables_ = VarSection::Temp;
  Span table_;
  Keyword frame_ = Keyword::None;  ///< nextFrame(): what was found, behind where, and where
  std::uint32_t frameFrom_ = 0, frameAt_ = 0;
  bool lastLineFailed_ = false;  ///< the last line that is no keyword made no instruction
  std::size_t outsideFinding_ = 0;
  int outsideLines_ = 0;
};

}  // namespace

void readStatementList(Program& program, const InputText& input, const ReadOptions& options) {
  const std::string_view text = program.sources->file(input.file).text();
  Spelling spelling = options.mnemonics == Mnemonics::German ? Spelling::German : Spelling::International;
  if (options.mnemonics == Mnemonics::Auto) spelling = detectSpelling(text);
  StlParser(program, input, spelling).run();
}

}  // namespace rungproof
