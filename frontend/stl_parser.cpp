// The parser: one line at a time, a small state for the section it is in.
#include "frontend/stl_parser.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "frontend/data_block.hpp"
#include "frontend/declaration.hpp"
#include "frontend/directive.hpp"
#include "frontend/local_layout.hpp"
#include "frontend/rung_split.hpp"
#include "frontend/stl_keyword.hpp"
#include "frontend/stl_statement.hpp"
#include "frontend/symbol_table.hpp"

namespace rungproof {

namespace {

enum class Section : std::uint8_t { Outside, Heading, Variables, Body, Data, Symbols };

class StlParser {
 public:
  StlParser(Program& program, const InputText& input, Spelling spelling)
      : program_(program),
        source_(program.sources->file(input.file)),
        text_(source_.text()),
        sink_(program, input.file),
        lexer_(text_),
        statements_(source_, sink_, {spelling, input.encoding}),
        data_(text_, sink_, input.encoding) {}

  void run() {
    while (lexer_.next(line_)) {
      if (line_.words.empty()) {
        if (line_.hasComment()) comment();
        continue;
      }
      statement();
    }
    finish();
  }

 private:
  std::string_view slice(std::uint32_t begin, std::uint32_t end) const { return text_.substr(begin, end - begin); }
  std::string_view word(std::size_t i) const { return i < line_.words.size() ? lexer_.slice(line_.words[i]) : std::string_view(); }

  /// End of the physical line that holds the current statement; the lexer goes on after it.
  std::uint32_t takeRestOfLine() {
    std::size_t newline = text_.find('\n', line_.begin);
    if (newline == std::string_view::npos) newline = text_.size();
    lexer_.rewind(static_cast<std::uint32_t>(std::min(newline + 1, text_.size())));
    if (newline > line_.begin && text_[newline - 1] == '\r') --newline;
    return static_cast<std::uint32_t>(newline);
  }

  void comment() {
    const Span span = sink_.span(line_.commentBegin, line_.commentEnd);
    if (line_.isBanner) sink_.report(Syntax::StrayText, span, fmt::format("\"{}\" has no comment sign and was read as a comment", excerpt(slice(span.offset, span.offset + span.length))));
    addComment(span);
  }

  void addComment(Span span) {
    if (const auto text = directiveText(slice(span.offset, span.offset + span.length))) {
      Directive directive;
      directive.text = *text;
      directive.span = span;
      directive.pou = isOpen_ ? static_cast<int>(program_.pous.size()) : -1;
      directive.network = isOpen_ && section_ == Section::Body ? network_.number : 0;
      program_.directives.push_back(std::move(directive));
    }
    if (!isOpen_) {
      pending_.push_back({span});
    } else if (section_ == Section::Body && inNetwork_) {
      network_.comments.push_back({span});
    } else {
      pou_.comments.push_back({span});
    }
  }

  void statement() {
    std::size_t length = 0;
    const Keyword keyword = keywordOf(word(0), length);
    if (keyword != Keyword::None && takeKeyword(keyword, length)) return;
    switch (section_) {
      case Section::Variables: declaration(); break;
      case Section::Data: data_.line(line_); keepComment(); break;
      case Section::Symbols: symbolRow(); break;
      default: instructionLine(); break;
    }
  }

  void keepComment() {
    if (line_.hasComment()) comment();
  }

  /// Returns false if the word is no keyword at this place.
  bool takeKeyword(Keyword keyword, std::size_t length) {
    switch (keyword) {
      case Keyword::OrganizationBlock: openFramed(PouKind::Main); return true;
      case Keyword::SubroutineBlock: openFramed(PouKind::Subroutine); return true;
      case Keyword::InterruptBlock: openFramed(PouKind::Interrupt); return true;
      case Keyword::EndOrganizationBlock: closeFramed(PouKind::Main); return true;
      case Keyword::EndSubroutineBlock: closeFramed(PouKind::Subroutine); return true;
      case Keyword::EndInterruptBlock: closeFramed(PouKind::Interrupt); return true;
      case Keyword::DataBlock: openTable(Section::Data); return true;
      case Keyword::SymbolTable: openTable(Section::Symbols); return true;
      case Keyword::EndDataBlock: closeTable(Section::Data); return true;
      case Keyword::EndSymbolTable: closeTable(Section::Symbols); return true;
      case Keyword::VarInput: openVariables(VarSection::Input); return true;
      case Keyword::VarInOut: openVariables(VarSection::InOut); return true;
      case Keyword::VarOutput: openVariables(VarSection::Output); return true;
      case Keyword::Var: openVariables(VarSection::Temp); return true;
      case Keyword::EndVar: endVariables(); return true;
      case Keyword::Begin: begin(); return true;
      case Keyword::Network: networkHeading(length); return true;
      case Keyword::NetworkTitle:
      case Keyword::Title: title(length); return true;
      case Keyword::NetworkComment: addComment(sink_.span(line_.begin, takeRestOfLine())); return true;
      case Keyword::None: break;
    }
    return false;
  }

  // Blocks -----------------------------------------------------------------------------------------------------

  void openFramed(PouKind kind) {
    if (isOpen_ && isFramed_) reportOpen();
    closePou(line_.begin);
    closeOpenTable();
    const std::uint32_t end = line_.hasComment() ? line_.commentBegin : takeRestOfLine();
    Heading heading = readHeading(kind, slice(line_.words[0].end, end));
    const Span span = sink_.span(line_.begin, end);
    openPou(heading, span);
    isFramed_ = true;
    section_ = Section::Heading;
    keepComment();
  }

  /// Opens a block; a heading without number gets the lowest free one.
  void openPou(Heading& heading, Span span) {
    pou_ = Pou{};
    pou_.kind = heading.kind;
    if (heading.number < 0) {
      heading.number = freeNumber(heading.kind);
      if (heading.name.empty()) heading.name = defaultName(heading.kind, heading.number);
      sink_.setPlace(heading.name, 0);
      sink_.report(Syntax::BlockHeading, span, fmt::format("heading \"{}\" has no readable number; {} was taken", excerpt(slice(span.offset, span.offset + span.length)), heading.number));
    }
    pou_.name = heading.name;
    pou_.number = heading.number;
    int& next = nextNumber_[static_cast<std::size_t>(heading.kind)];
    next = std::max(next, heading.number + 1);
    pou_.span = span;
    isOpen_ = true;
    isFramed_ = false;
    hasNetworkLines_ = false;
    inNetwork_ = false;
    headingSpan_ = span;
    damaged_.clear();
    localsDeclared_ = false;
    firstFinding_ = program_.findings.size();
    firstDirective_ = program_.directives.size();
    sink_.setPlace(pou_.name, 0);
  }

  /// One above the highest number that this file used for the kind.
  int freeNumber(PouKind kind) const { return nextNumber_[static_cast<std::size_t>(kind)]; }

  void reportOpen() { sink_.report(Syntax::BlockOpen, headingSpan_, fmt::format("block {} has no end", pou_.name)); }

  void closeFramed(PouKind kind) {
    const bool matches = isOpen_ && isFramed_ && pou_.kind == kind;
    if (!matches) sink_.report(Syntax::BlockNotOpen, sink_.span(line_.begin, line_.end), fmt::format("{} without its heading", excerpt(slice(line_.begin, line_.end))));
    closePou(line_.end);
    section_ = Section::Outside;
    keepComment();
  }

  void closePou(std::uint32_t end) {
    if (!isOpen_) return;
    closeNetwork(end);
    pou_.span.length = end - pou_.span.offset;
    if (!hasNetworkLines_ && pou_.networks.size() == 1) numberRungs(splitIntoRungs(pou_, text_, damaged_));
    checkProtection();
    program_.pous.push_back(std::move(pou_));
    isOpen_ = false;
    hadBlock_ = true;
    sink_.setPlace({}, 0);
  }

  /// Findings and directives inside a block that was cut into rungs get the number of their rung.
  void numberRungs(const std::vector<std::uint32_t>& begins) {
    const auto rungAt = [&](std::uint32_t offset) { return static_cast<int>(std::upper_bound(begins.begin(), begins.end(), offset) - begins.begin()); };
    for (std::size_t i = firstFinding_; i < program_.findings.size(); ++i) {
      Finding& finding = program_.findings[i];
      if (finding.network != 0) finding.network = std::max(1, rungAt(finding.span.offset));
    }
    for (std::size_t i = firstDirective_; i < program_.directives.size(); ++i) {
      Directive& directive = program_.directives[i];
      if (directive.network != 0) directive.network = std::max(1, rungAt(directive.span.offset));
    }
  }

  void checkProtection() {
    static constexpr std::string_view mark = "password-protected";
    const bool isEmpty = std::all_of(pou_.networks.begin(), pou_.networks.end(), [](const Network& network) { return network.instructions.empty(); });
    if (!isEmpty) return;
    for (const Network& network : pou_.networks) {
      if (network.title.find(mark) == std::string::npos) continue;
      pou_.protectedBlock = true;
      sink_.setNetwork(0);
      sink_.report(Syntax::ProtectedBlock, headingSpan_, fmt::format("block {} is protected by a password; its instructions are not in the text", pou_.name));
      return;
    }
  }

  void begin() {
    if (section_ == Section::Data || section_ == Section::Symbols) return keepComment();
    if (!isOpen_) {
      sink_.report(Syntax::OutsideBlock, sink_.span(line_.begin, line_.end), "BEGIN without the heading of a block");
      return;
    }
    if (section_ == Section::Variables) endVariables();
    startBody(line_.end);
    keepComment();
  }

  /// The part of a block before its first Network line; it stays if it holds instructions.
  void startBody(std::uint32_t offset) {
    if (!layOut()) return;
    section_ = Section::Body;
    startNetwork(1, offset);
    isImplicit_ = true;
  }

  bool layOut() {
    if (localsDeclared_) return true;
    localsDeclared_ = true;
    const std::uint32_t used = layOutLocals(pou_.locals);
    if (used > localMemoryBytes) {
      sink_.report(Syntax::LocalTableFull, headingSpan_, fmt::format("the local variables of {} need {} bytes, there are {}", pou_.name, used, localMemoryBytes));
    }
    return true;
  }

  // Declarations, tables ------------------------------------------------------------------------------------------

  void openVariables(VarSection section) {
    if (!isOpen_ || section_ == Section::Body) {
      sink_.report(Syntax::OutsideBlock, sink_.span(line_.begin, line_.end), "declarations stand between the heading of a block and BEGIN");
      if (!isOpen_) return;
    }
    resumeSection_ = section_ == Section::Variables ? resumeSection_ : section_;
    section_ = Section::Variables;
    variables_ = section;
    keepComment();
  }
  void endVariables() {
    if (section_ != Section::Variables) return sink_.report(Syntax::OutsideBlock, sink_.span(line_.begin, line_.end), "END_VAR without VAR");
    section_ = resumeSection_;
    keepComment();
  }
  void declaration() {
    readDeclaration(text_, line_.begin, line_.end, variables_, sink_, pou_.locals);
    keepComment();
  }

  void openTable(Section section) {
    if (isOpen_ && isFramed_) reportOpen();
    closePou(line_.begin);
    closeOpenTable();
    section_ = section;
    headingSpan_ = sink_.span(line_.begin, line_.end);
    data_.begin();
    hadBlock_ = true;
    takeRestOfLine();
  }
  void closeTable(Section section) {
    if (section_ != section) sink_.report(Syntax::BlockNotOpen, sink_.span(line_.begin, line_.end), fmt::format("{} without its heading", excerpt(slice(line_.begin, line_.end))));
    if (isOpen_) return;
    section_ = Section::Outside;
  }
  void closeOpenTable() {
    if (section_ == Section::Data || section_ == Section::Symbols) sink_.report(Syntax::BlockOpen, headingSpan_, "table has no end");
    section_ = Section::Outside;
  }
  void symbolRow() {
    const std::uint32_t end = takeRestOfLine();
    if (!readSymbolRow(text_, line_.begin, end, statements_.context().spelling, sink_)) {
      sink_.report(Syntax::SymbolRow, sink_.span(line_.begin, end), fmt::format("\"{}\" is not a row of name and address", excerpt(slice(line_.begin, end))));
    }
  }

  void title(std::size_t length) {
    const std::uint32_t end = takeRestOfLine();
    std::string_view text = trimmed(slice(line_.begin + static_cast<std::uint32_t>(length), end));
    if (!text.empty() && text[0] == '=') text = trimmed(text.substr(1));
    if (!isOpen_) {
      if (section_ == Section::Outside) addComment(sink_.span(line_.begin, end));
      return;
    }
    if (section_ == Section::Body && inNetwork_ && !isImplicit_) {
      network_.title = text;
    } else {
      pou_.title = text;
    }
  }

  // Networks -------------------------------------------------------------------------------------------------------

  void startNetwork(int number, std::uint32_t offset) {
    closeNetwork(offset);
    network_ = Network{};
    network_.number = number;
    network_.span = sink_.span(offset, offset);
    inNetwork_ = true;
    isImplicit_ = false;
    sink_.setNetwork(number);
  }

  void closeNetwork(std::uint32_t end) {
    if (!inNetwork_) return;
    inNetwork_ = false;
    const bool isLeadIn = isImplicit_ && network_.instructions.empty() && network_.complete;
    if (isLeadIn) {
      pou_.comments.insert(pou_.comments.end(), network_.comments.begin(), network_.comments.end());
      return;
    }
    network_.span.length = end - network_.span.offset;
    pou_.networks.push_back(std::move(network_));
  }

  void networkHeading(std::size_t length) {
    if (!isOpen_) {
      if (section_ != Section::Outside) closeOpenTable();
      openImplicitMain();
    }
    if (section_ == Section::Variables) section_ = Section::Heading;
    layOut();
    section_ = Section::Body;
    const int last = inNetwork_ && !isImplicit_ ? network_.number : pou_.networks.empty() ? 0 : pou_.networks.back().number;
    std::string_view digits = word(0).substr(length);
    std::size_t titleWord = 1;
    if (digits.empty() && line_.words.size() > 1) {
      digits = word(1);
      titleWord = 2;
    }
    while (!digits.empty() && (digits.back() == ':' || digits.back() == '.')) digits.remove_suffix(1);
    int number = last + 1;
    const bool isNumber = !digits.empty() && std::all_of(digits.begin(), digits.end(), isDigit);
    const Span span = sink_.span(line_.begin, line_.end);
    startNetwork(number, line_.begin);
    hasNetworkLines_ = true;
    if (isNumber && digits.size() <= 6) {
      number = std::stoi(std::string(digits));
      network_.number = number;
      sink_.setNetwork(number);
    } else if (isNumber) {
      sink_.report(Syntax::NetworkHeading, span, fmt::format("network number \"{}\" is too large", excerpt(digits)));
    } else if (titleWord == 2) {
      titleWord = 1;
    }
    std::string_view heading;
    if (line_.words.size() > titleWord) heading = slice(line_.words[titleWord].begin, line_.end);
    if (line_.hasComment()) heading = trimmed(slice(line_.commentBegin + 2, line_.commentEnd));
    network_.title = trimmed(heading);
    if (line_.hasComment() && directiveText(slice(line_.commentBegin, line_.commentEnd))) {
      network_.title.clear();
      keepComment();
    }
    takeRestOfLine();
  }

  // Instructions ---------------------------------------------------------------------------------------------------

  void openImplicitMain() {
    Heading heading{PouKind::Main, "MAIN", 1};
    openPou(heading, sink_.span(line_.begin, line_.begin));
    section_ = Section::Body;
    localsDeclared_ = true;
    startNetwork(1, line_.begin);
    isImplicit_ = true;
    network_.comments = std::move(pending_);
    pending_.clear();
  }

  /// Comment lines behind the last instruction of a block belong to the heading that follows.
  void takeLeadingComments() {
    if (!isOpen_ || !inNetwork_ || network_.instructions.empty()) return;
    const Span& last = network_.instructions.back().span;
    const std::size_t newline = std::min(text_.find('\n', last.offset + last.length), text_.size());
    std::vector<Comment>& comments = network_.comments;
    const auto first = std::find_if(comments.begin(), comments.end(), [&](const Comment& comment) { return comment.span.offset > newline; });
    pending_.insert(pending_.end(), first, comments.end());
    comments.erase(first, comments.end());
  }

  void openOlder(Heading heading) {
    const std::uint32_t begin = line_.begin;
    takeLeadingComments();
    closePou(begin);
    const Span span = sink_.span(begin, line_.end);
    openPou(heading, span);
    program_.olderDialect = program_.olderDialect || heading.kind != PouKind::Main;
    pou_.comments = std::move(pending_);
    pending_.clear();
    section_ = Section::Body;
    localsDeclared_ = true;
    startNetwork(1, line_.end);
    isImplicit_ = true;
    keepComment();
  }

  void outside() {
    const Span span = sink_.span(line_.begin, line_.end);
    const bool continues = outsideFinding_ < program_.findings.size() && outsideFinding_ + 1 == program_.findings.size();
    if (continues) {
      Finding& finding = program_.findings[outsideFinding_];
      finding.span.length = line_.end - finding.span.offset;
      finding.message = fmt::format("{} lines outside of any block", ++outsideLines_);
    } else {
      outsideLines_ = 1;
      outsideFinding_ = program_.findings.size();
      sink_.report(Syntax::OutsideBlock, span, fmt::format("\"{}\" stands outside of any block", excerpt(slice(line_.begin, line_.end))));
    }
    keepComment();
  }

  void instructionLine() {
    if (!isOpen_ || !isFramed_) {
      if (const auto heading = readOlderHeading(word(0), word(1), line_.words.size())) return openOlder(*heading);
    }
    if (!(isOpen_ && isFramed_) && isDataLine(text_, line_)) {  // data under the listing, as in the older dialect
      data_.line(line_);
      return keepComment();
    }
    if (!isOpen_) {
      if (hadBlock_) return outside();
      openImplicitMain();
    }
    if (section_ == Section::Heading) startBody(line_.begin);
    if (!inNetwork_) startNetwork(pou_.networks.empty() ? 1 : pou_.networks.back().number + 1, line_.begin);
    joinContinuations();
    const Span statement = sink_.span(line_.begin, line_.end);
    switch (statements_.read(line_, instruction_)) {
      case StatementKind::Damaged: markDamaged(statement.offset); [[fallthrough]];
      case StatementKind::Instruction:
        program_.olderDialect = program_.olderDialect || instruction_.desc->olderDialectOnly;
        network_.instructions.push_back(std::move(instruction_));
        instruction_ = Instruction{};
        break;
      case StatementKind::Stray: addComment(statement); break;
      case StatementKind::Failed: markDamaged(statement.offset); break;
    }
    keepComment();
  }

  void markDamaged(std::uint32_t offset) {
    network_.complete = false;
    damaged_.push_back(offset);
  }

  /// A statement that ends with a comma goes on in the next line, unless that line begins with an instruction.
  void joinContinuations() {
    constexpr std::size_t mostWords = 64;  // far above the 17 operands of a CALL
    while (line_.endsWithComma && !line_.hasComment() && line_.words.size() < mostWords) {
      const std::uint32_t back = lexer_.position();
      if (!lexer_.next(continuation_) || continuation_.words.empty() || continuation_.isBanner ||
          instructionNamed(lexer_.slice(continuation_.words[0])) != nullptr) {
        return lexer_.rewind(back);
      }
      sink_.lenient(sink_.span(line_.begin, continuation_.end), slice(line_.begin, line_.end), "one statement with the next line");
      continuation_.words[0].afterComma = true;
      line_.words.insert(line_.words.end(), continuation_.words.begin(), continuation_.words.end());
      line_.end = continuation_.end;
      line_.commentBegin = continuation_.commentBegin;
      line_.commentEnd = continuation_.commentEnd;
      line_.endsWithComma = continuation_.endsWithComma;
      line_.openQuote = line_.openQuote || continuation_.openQuote;
    }
  }

  void finish() {
    const auto end = static_cast<std::uint32_t>(text_.size());
    if (isOpen_ && isFramed_) reportOpen();
    closePou(end);
    closeOpenTable();
    if (!program_.pous.empty()) {
      std::vector<Comment>& comments = program_.pous.back().comments;
      comments.insert(comments.end(), pending_.begin(), pending_.end());
    }
  }

  Program& program_;
  const SourceFile& source_;
  std::string_view text_;
  SyntaxSink sink_;
  StlLexer lexer_;
  StatementReader statements_;
  DataBlockReader data_;
  Line line_;
  Line continuation_;
  Section section_ = Section::Outside;
  Section resumeSection_ = Section::Outside;
  VarSection variables_ = VarSection::Temp;
  Pou pou_;
  Network network_;
  Instruction instruction_;
  Span headingSpan_;
  bool isOpen_ = false;          ///< pou_ is being read
  bool isFramed_ = false;        ///< it began with a ..._BLOCK line
  bool inNetwork_ = false;
  bool isImplicit_ = false;      ///< network_ has no Network line
  bool hasNetworkLines_ = false;
  bool hadBlock_ = false;
  bool localsDeclared_ = false;
  std::array<int, 3> nextNumber_ = {1, 0, 0};  ///< by PouKind
  std::vector<std::uint32_t> damaged_;
  std::vector<Comment> pending_;
  std::size_t firstFinding_ = 0;
  std::size_t firstDirective_ = 0;
  std::size_t outsideFinding_ = static_cast<std::size_t>(-1);
  int outsideLines_ = 0;
};

}  // namespace

StlLikeness stlLikeness(std::string_view text) {
  StlLikeness likeness;
  const std::string_view start = trimmed(text.substr(0, 512));
  const std::size_t first = start.find_first_not_of(" \t\r\n");
  if (first != std::string_view::npos && (start[first] == '<' || start[first] == '{' || start[first] == '[')) {
    likeness.isMarkup = true;
    return likeness;
  }
  StlLexer lexer(text);
  Line line;
  int lines = 0, hits = 0, seen = 0;
  const OperandContext contexts[] = {{Spelling::International}, {Spelling::German}};
  while (seen < 4000 && lexer.next(line)) {
    if (line.words.empty()) continue;
    ++seen;
    const std::string_view word = lexer.slice(line.words[0]);
    std::size_t length = 0;
    switch (keywordOf(word, length)) {
      case Keyword::OrganizationBlock:
      case Keyword::SubroutineBlock:
      case Keyword::InterruptBlock:
      case Keyword::DataBlock:
      case Keyword::SymbolTable: likeness.hasHeading = true; return likeness;
      case Keyword::Network: ++lines, ++hits; continue;
      default: break;
    }
    if (lines >= 300 || static_cast<unsigned char>(word[0]) >= 0x80) continue;
    ++lines;
    const std::string_view second = line.words.size() > 1 ? lexer.slice(line.words[1]) : std::string_view();
    if (readOlderHeading(word, second, line.words.size())) {
      ++hits;
      continue;
    }
    for (const OperandContext& context : contexts) {
      MnemonicResult found = findMnemonic(word, context);
      if (found.desc == nullptr && !second.empty()) found = findComparison(word, second, context);
      if (found.desc == nullptr) continue;
      const OperandLimits limits = operandLimits(*found.desc);
      const std::size_t operands = line.words.size() - 1 + (found.length < word.size() ? 1 : 0);
      if (operands >= limits.least && operands <= 2 * limits.most + 1) {
        ++hits;
        break;
      }
    }
  }
  likeness.share = lines == 0 ? 0 : hits * 100 / lines;
  return likeness;
}

Spelling detectSpelling(std::string_view text) {
  StlLexer lexer(text);
  Line line;
  int german = 0, international = 0, seen = 0;
  Operand operand;
  while (seen < 20000 && lexer.next(line)) {
    if (line.words.empty()) continue;
    ++seen;
    const std::string_view word = lexer.slice(line.words[0]);
    if (word.size() <= 4 && line.words.size() <= 3) {
      const char first = upper(word[0]);
      if (first == 'U' && instructionNamedGerman(word) != nullptr) ++german;
      if (first == 'A' && instructionNamed(word) != nullptr) ++international;
    }
    for (std::size_t i = 1; i < line.words.size(); ++i) {
      const std::string_view text2 = lexer.slice(line.words[i]);
      const char first = upper(text2[0]);
      if (first == 'E' || first == 'A' || first == 'Z') {
        if (readAddress(text2, Spelling::German, operand) && !readAddress(text2, Spelling::International, operand)) ++german;
      } else if (first == 'I' || first == 'Q' || first == 'C') {
        if (readAddress(text2, Spelling::International, operand)) ++international;
      }
    }
  }
  return german > international ? Spelling::German : Spelling::International;
}

void readStatementList(Program& program, const InputText& input, const ReadOptions& options) {
  const std::string_view text = program.sources->file(input.file).text();
  Spelling spelling = options.mnemonics == Mnemonics::German ? Spelling::German : Spelling::International;
  if (options.mnemonics == Mnemonics::Auto) spelling = detectSpelling(text);
  StlParser(program, input, spelling).run();
}

}  // namespace rungproof
