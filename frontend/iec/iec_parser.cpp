// Files: types, blocks with their declarations, configurations.
#include "frontend/iec/iec_parser.hpp"

#include <cctype>
#include <cstdlib>
#include <map>

#include "frontend/iec/iec_chart_parser.hpp"
#include "frontend/iec/iec_types.hpp"

namespace rungproof::iec {

std::optional<std::int64_t> nanosecondsOf(std::string_view text) {
  static constexpr std::pair<std::string_view, std::int64_t> units[] = {{"D", 86'400'000'000'000},
                                                                        {"H", 3'600'000'000'000},
                                                                        {"M", 60'000'000'000},
                                                                        {"S", 1'000'000'000},
                                                                        {"MS", 1'000'000},
                                                                        {"US", 1000},
                                                                        {"NS", 1}};
  bool isNegative = false;
  if (!text.empty() && (text[0] == '-' || text[0] == '+')) {
    isNegative = text[0] == '-';
    text.remove_prefix(1);
  }
  if (text.empty()) return std::nullopt;
  std::int64_t nanoseconds = 0;
  std::size_t last = 0, at = 0;
  while (at < text.size()) {
    std::string digits, fraction;
    bool isFraction = false;
    for (; at < text.size() &&
           (std::isdigit(static_cast<unsigned char>(text[at])) != 0 || text[at] == '.' || text[at] == '_');
         ++at) {
      if (text[at] == '.' && std::exchange(isFraction, true)) return std::nullopt;
      if (text[at] != '_' && text[at] != '.') (isFraction ? fraction : digits) += text[at];
    }
    const std::size_t first = at;
    while (at < text.size() && std::isalpha(static_cast<unsigned char>(text[at])) != 0) ++at;
    const std::string unit = foldedName(text.substr(first, at - first));
    std::size_t row = last;
    while (row < std::size(units) && units[row].first != unit) ++row;
    if (digits.empty() || row == std::size(units)) return std::nullopt;
    if (isFraction && at < text.size()) return std::nullopt;
    last = row + 1;
    std::int64_t share = units[row].second, whole = 0;
    for (const char c : digits) {
      if (__builtin_mul_overflow(whole, 10, &whole) || __builtin_add_overflow(whole, c - '0', &whole))
        return std::nullopt;
    }
    if (__builtin_mul_overflow(whole, share, &whole) || __builtin_add_overflow(nanoseconds, whole, &nanoseconds))
      return std::nullopt;
    for (const char c : fraction) {
      if (share % 10 != 0 && c != '0') return std::nullopt;
      share /= 10;
      nanoseconds += (c - '0') * share;
    }
    while (at < text.size() && text[at] == '_') ++at;
  }
  return isNegative ? -nanoseconds : nanoseconds;
}

std::optional<std::int64_t> millisecondsOf(std::string_view text) {
  const auto nanoseconds = nanosecondsOf(text);
  if (!nanoseconds || *nanoseconds % 1'000'000 != 0) return std::nullopt;
  const std::int64_t milliseconds = *nanoseconds / 1'000'000;
  return std::abs(milliseconds) <= 2147483647 ? std::optional(milliseconds) : std::nullopt;
}

namespace {

class ProjectParser : private ChartParser {
 public:
  ProjectParser(const SourceText& source, SyntaxSink& sink, ProjectSyntax& project)
      : ChartParser(source, sink, project.directives), project_(project) {}

  void run() {
    while (!isEnd()) {
      const std::size_t before = at_;
      const int depth = depth_;
      try {
        declaration();
      } catch (const Unreadable&) {
        depth_ = depth;
        project_.isDamaged = true;
        while (!isEnd() && !beginsDeclaration()) take();
      }
      if (at_ == before) take();
    }
  }

 private:
  void declaration() {
    if (accept(";")) return;
    if (accept("TYPE")) return types();
    if (is("FUNCTION") || is("FUNCTION_BLOCK") || is("PROGRAM")) return block();
    if (accept("CONFIGURATION")) return configuration();
    if (is("VAR_GLOBAL")) return variables(project_.globals);
    if (is("INTERFACE") && peek(1).kind == TokenKind::Word) return interface();
    fail(fmt::format("TYPE, FUNCTION, FUNCTION_BLOCK, PROGRAM or CONFIGURATION is needed here{}", found()));
  }

  /// A variable of the interface stands for an instance that is not known: it is a reference.
  void interface() {
    const std::uint32_t begin = take().begin;
    NamedType made;
    made.name = name("the name of the interface");
    leaveOut(begin, fmt::format("interfaces are not modelled: {} is left out", excerpt(made.name)), Severity::Note);
    while (!isEnd() && !is("END_INTERFACE") && !beginsDeclaration()) take();
    accept("END_INTERFACE");
    made.type = std::make_shared<TypeSyntax>();
    made.type->name = "REFERENCE";
    made.type->span = made.span = spanFrom(begin);
    project_.types.push_back(std::move(made));
  }

  /// METHOD or PROPERTY, which becomes an action that was not read: a call of it may write anything.
  void member(BlockSyntax& block) {
    const std::string word = foldedName(peek().text);
    const std::uint32_t begin = take().begin;
    modifiers();
    ActionSyntax made;
    made.name = name("a name");
    while (accept(".")) made.name = name("a name");
    const std::string told =
        fmt::format("{} are not modelled: {} of {} is left out", word == "METHOD" ? "methods" : "properties",
                    excerpt(made.name), excerpt(block.name));
    // Those of CODESYS that run by themselves at the start may write anything.
    const std::string folded = foldedName(made.name);
    const bool runsAlone = folded == "FB_INIT" || folded == "FB_REINIT";
    if (runsAlone)
      leaveOut(begin, told, Severity::Error, Syntax::IecNotModelled);
    else
      leaveOut(begin, told, Severity::Warning);
    const std::string end = "END_" + word;
    while (!isEnd() && !is(end) && !isAny({"END_FUNCTION_BLOCK", "END_PROGRAM", "END_FUNCTION"})) take();
    accept(end);
    made.span = spanFrom(begin);
    Statement& lost = made.body.emplace_back();
    lost.kind = StatementKind::Unread;
    lost.span = made.span;
    block.actions.push_back(std::move(made));
  }
  /// Who may use something says nothing about what it does.
  void modifiers() {
    while (isAny({"PUBLIC", "PRIVATE", "PROTECTED", "INTERNAL", "FINAL", "ABSTRACT", "OVERRIDE"}) &&
           peek(1).kind == TokenKind::Word && !isSectionWord(foldedName(peek(1).text)))
      take();
  }

  /// `EXTENDS Base IMPLEMENTS First, Second` behind the name of a block. False: it has more than is read.
  bool parents(const BlockSyntax& block) {
    bool isWhole = true;
    while (isAny({"EXTENDS", "IMPLEMENTS"}) && peek(1).kind == TokenKind::Word) {
      const std::uint32_t begin = peek().begin;
      const bool extends = is("EXTENDS");
      take();
      std::string names;
      do names += (names.empty() ? "" : ", ") + name("a name");
      while (accept(","));
      if (!extends) continue;
      isWhole = false;
      leaveOut(begin,
               fmt::format("inheritance is not modelled: {} has all of {}, so its body is left out",
                           excerpt(block.name), excerpt(names)),
               Severity::Warning);
    }
    return isWhole;
  }

  void types() {
    while (!accept("END_TYPE")) {
      if (isEnd()) fail("END_TYPE is needed here, the text ends");
      NamedType made;
      const std::uint32_t begin = peek().begin;
      made.name = name("the name of a type");
      expect(":");
      made.type = type();
      if (accept(":=")) made.initial = std::make_shared<Initial>(initial());
      made.span = spanFrom(begin);
      if (!accept(";") && !is("END_TYPE")) expect(";");
      project_.types.push_back(std::move(made));
    }
  }

  TypePtr type() {
    Nesting nesting(*this);
    auto made = std::make_shared<TypeSyntax>();
    const std::uint32_t begin = peek().begin;
    if (accept("ARRAY")) {
      made->form = TypeForm::Array;
      expect("[");
      do {
        ExprPtr low = expression();
        expect("..");
        made->bounds.emplace_back(std::move(low), expression());
      } while (accept(","));
      expect("]");
      expect("OF");
      made->element = type();
    } else if (accept("STRUCT")) {
      made->form = TypeForm::Struct;
      while (!accept("END_STRUCT")) {
        if (isEnd()) fail("END_STRUCT is needed here, the text ends");
        list(Section::Local, false, false, made->fields);
      }
    } else if (is("(")) {
      enumeration(*made);
      // (RED := 1, GREEN) UINT: its base behind it.
      const Type* base = peek().kind == TokenKind::Word ? elementaryType(foldedName(peek().text)) : nullptr;
      if (base != nullptr && base->isNumber()) made->name = take().text;
    } else {
      made->name = name("a type");
      while (accept(".")) made->name += "." + name("a type");
      const std::string word = foldedName(made->name);
      if ((word == "POINTER" || word == "REFERENCE") && accept("TO")) type();
      if (word == "REF_TO") type();
      if (is("(") && peek(1).kind != TokenKind::Word) {
        take();
        made->low = expression();
        if (accept("..")) made->high = expression();
        expect(")");
      } else if (is("(")) {  // INT (RED := 1, GREEN): an enumeration with its base
        enumeration(*made);
      } else if (accept("[")) {
        made->low = expression();
        expect("]");
      }
    }
    made->span = spanFrom(begin);
    return made;
  }
  void enumeration(TypeSyntax& made) {
    made.form = TypeForm::Enum;
    expect("(");
    do {
      std::string item = name("the name of a value");
      ExprPtr value = accept(":=") ? expression() : nullptr;
      made.items.emplace_back(std::move(item), std::move(value));
    } while (accept(","));
    expect(")");
  }

  Initial initial() {
    Nesting nesting(*this);
    Initial made;
    const std::uint32_t begin = peek().begin;
    if (accept("[")) {
      made.isRow = true;
      while (!accept("]")) {
        std::uint32_t times = 1;
        if (peek().kind == TokenKind::Number && peek(1).text == "(") {
          const std::string count(take().text);
          times = static_cast<std::uint32_t>(std::min(std::strtoul(count.c_str(), nullptr, 10), 1'000'000UL));
          take();
          if (!is(")")) made.row.emplace_back(times, initial());
          expect(")");
        } else {
          made.row.emplace_back(times, initial());
        }
        if (!accept(",") && !is("]")) expect(",");
      }
    } else if (is("(") && peek(1).kind == TokenKind::Word && peek(2).text == ":=") {
      take();
      made.isStructure = true;
      do {
        std::string field = name("the name of a field");
        expect(":=");
        made.fields.emplace_back(std::move(field), initial());
      } while (accept(","));
      expect(")");
    } else {
      made.value = expression();
    }
    made.span = spanFrom(begin);
    return made;
  }

  /// `a, b AT %IX0.0 : BOOL R_EDGE := TRUE;`
  void list(Section section, bool isConstant, bool isRetain, std::vector<VariableSyntax>& into) {
    std::vector<VariableSyntax> row;
    do {
      VariableSyntax made;
      const std::uint32_t begin = peek().begin;
      if (!is("AT")) made.name = name("the name of a variable");
      if (accept("AT")) {
        if (peek().kind != TokenKind::Address) fail(fmt::format("an address is needed here{}", found()));
        made.address = take().text;
        if (made.name.empty()) made.name = made.address;
      }
      made.section = section;
      made.isConstant = isConstant;
      made.isRetain = isRetain;
      made.span = spanFrom(begin);
      row.push_back(std::move(made));
    } while (accept(","));
    expect(":");
    const TypePtr named = type();
    const EdgeOf edge = accept("R_EDGE") ? EdgeOf::Rising : accept("F_EDGE") ? EdgeOf::Falling : EdgeOf::None;
    std::shared_ptr<Initial> value;
    if (accept(":=")) value = std::make_shared<Initial>(initial());
    for (VariableSyntax& variable : row) {
      variable.type = named;
      variable.initial = value;
      variable.edge = edge;
      into.push_back(std::move(variable));
    }
    expect(";");
  }

  /// VAR_INPUT ... END_VAR; a line that cannot be read is left out.
  void variables(std::vector<VariableSyntax>& into) {
    static const std::map<std::string, Section> sections = {
        {"VAR", Section::Local},        {"VAR_INPUT", Section::Input}, {"VAR_OUTPUT", Section::Output},
        {"VAR_IN_OUT", Section::InOut}, {"VAR_TEMP", Section::Temp},   {"VAR_EXTERNAL", Section::External},
        {"VAR_GLOBAL", Section::Global}};
    const auto section = sections.find(foldedName(peek().text));
    if (section == sections.end()) fail(fmt::format("{} is not read", excerpt(peek().text)));
    take();
    bool isConstant = false, isRetain = false;
    for (bool goesOn = true; goesOn;) {
      if (accept("CONSTANT"))
        isConstant = true;
      else if (accept("RETAIN") || accept("PERSISTENT"))
        isRetain = true;
      else
        goesOn = accept("NON_RETAIN");
    }
    while (!accept("END_VAR")) {
      if (isEnd()) fail("END_VAR is needed here, the text ends");
      const int depth = depth_;
      try {
        list(section->second, isConstant, isRetain, into);
      } catch (const Unreadable&) {
        depth_ = depth;
        isLineLost_ = true;
        while (!isEnd() && !is("END_VAR") && !accept(";")) take();
      }
    }
    accept(";");
  }

  void block() {
    BlockSyntax made;
    const std::uint32_t begin = peek().begin;
    const std::string word = foldedName(take().text);
    made.kind = word == "PROGRAM"    ? BlockKind::Program
                : word == "FUNCTION" ? BlockKind::Function
                                     : BlockKind::FunctionBlock;
    modifiers();
    made.name = name("the name of the block");
    sink_.setPlace(made.name, 0);
    isLineLost_ = false;
    const std::string end = "END_" + word;
    bool hasParent = false;
    try {
      hasParent = !parents(made);
      if (made.kind == BlockKind::Function) {
        expect(":");
        made.result = type();
        accept(";");
      }
      while (peek().kind == TokenKind::Word && isSectionWord(foldedName(peek().text))) variables(made.variables);
      made.isWhole = !isLineLost_ && !hasParent;
      while (beginsMember()) member(made);
      if (beginsChart())
        chartStatements(chart(end), made, sink_);
      else
        bodyUntil(end, made.body);
      while (beginsMember()) {
        member(made);
        bodyUntil(end, made.body);
      }
      expect(end);
      if (hasParent) made.body.clear();
    } catch (const Unreadable&) {
      made.isWhole = false;
      depth_ = 0;
      while (!isEnd() && !is(end) && !beginsDeclaration()) take();
      accept(end);
    }
    made.span = spanFrom(begin);
    sink_.setPlace("", 0);
    project_.blocks.push_back(std::move(made));
  }
  void configuration() {
    name("the name of the configuration");
    while (!accept("END_CONFIGURATION")) {
      if (isEnd()) fail("END_CONFIGURATION is needed here, the text ends");
      if (is("VAR_GLOBAL")) {
        variables(project_.globals);
      } else if (accept("VAR_ACCESS")) {
        accessPaths();
      } else if (accept("RESOURCE")) {
        name("the name of the resource");
        if (accept("ON")) name("the type of the resource");
      } else if (accept("END_RESOURCE") || accept(";")) {
      } else if (accept("TASK")) {
        task();
      } else if (accept("PROGRAM")) {
        instance();
      } else {
        fail(fmt::format("'{}' is not read in a configuration", excerpt(peek().text)));
      }
    }
  }

  /// `name : RES.PROG.var : TYPE READ_WRITE;`
  void accessPaths() {
    while (!accept("END_VAR")) {
      if (isEnd()) fail("END_VAR is needed here, the text ends");
      AccessSyntax made;
      const std::uint32_t begin = peek().begin;
      name("the name of a path");
      expect(":");
      made.path = expression();
      expect(":");
      type();
      const bool writes = accept("READ_WRITE");
      if (!writes) accept("READ_ONLY");
      made.span = spanFrom(begin);
      expect(";");
      if (writes) project_.accesses.push_back(std::move(made));
    }
    accept(";");
  }

  void task() {
    TaskSyntax made;
    const std::uint32_t begin = peek().begin;
    made.name = name("the name of the task");
    expect("(");
    do {
      const std::string word = foldedName(name("INTERVAL, SINGLE or PRIORITY"));
      expect(":=");
      ExprPtr value = expression();
      if (word == "INTERVAL") {
        made.intervalMs = value->kind == ExprKind::Literal ? millisecondsOf(value->text) : std::nullopt;
        if (!made.intervalMs || *made.intervalMs <= 0) fail("the interval is no duration of whole milliseconds");
      } else if (word == "PRIORITY") {
        made.priority = std::strtoll(value->text.c_str(), nullptr, 10);
      } else if (word == "SINGLE") {
        made.single = std::move(value);
      } else {
        fail(fmt::format("a task has no {}", excerpt(word)));
      }
    } while (accept(","));
    expect(")");
    accept(";");
    made.span = spanFrom(begin);
    project_.tasks.push_back(std::move(made));
  }

  void instance() {
    InstanceSyntax made;
    const std::uint32_t begin = peek().begin;
    if (!accept("RETAIN")) accept("NON_RETAIN");
    made.name = name("the name of the program instance");
    if (accept("WITH")) made.task = name("the name of a task");
    expect(":");
    made.type = name("the name of a program");
    if (is("(")) {
      made.connections = std::make_unique<Expr>();
      made.connections->kind = ExprKind::Call;
      made.connections->arguments = arguments();
      made.connections->span = spanFrom(begin);
    }
    accept(";");
    made.span = spanFrom(begin);
    project_.instances.push_back(std::move(made));
  }

  ProjectSyntax& project_;
  bool isLineLost_ = false;
};

}  // namespace

void parseProject(const SourceText& source, SyntaxSink& sink, ProjectSyntax& project) {
  ProjectParser(source, sink, project).run();
}

}  // namespace rungproof::iec
