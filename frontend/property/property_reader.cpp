// Recursive descent over the property language. Binding, tightest first: unary minus; *; + -; comparisons; not;
// and; xor; or; implies (right-associative).
#include "frontend/property/property_reader.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/unsigned_number.hpp"
#include "frontend/property/external_range.hpp"
#include "frontend/property/goal_names.hpp"
#include "frontend/property/property_lexer.hpp"
#include "frontend/property/property_mistake.hpp"
#include "frontend/property/property_types.hpp"
#include "frontend/property/unread_statement.hpp"
#include "frontend/step7/name_lookup.hpp"
#include "frontend/stl/missing_address.hpp"
#include "ir/desc.hpp"
#include "ir/dialect.hpp"

namespace rungproof {
namespace {

using Mistake = PropertyMistake;

constexpr const char* syntaxRule = propertyMessages[0].id.data();
constexpr const char* addressRule = propertyMessages[1].id.data();
constexpr const char* typeRule = propertyMessages[2].id.data();
constexpr const char* nameRule = propertyMessages[3].id.data();

constexpr const char* formsHelp =
    "one statement a line, with and, or, xor, not, implies, comparisons and + - *; see prove --help for the forms";

std::string lower(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return result;
}

class Parser {
 public:
  /// `target`: the CPU whose addresses exist, or nullptr.
  Parser(std::vector<Token> tokens, const OperandLookup& lookup, const Target* target, std::string_view text,
         GoalNames& names)
      : tokens_(std::move(tokens)), lookup_(lookup), target_(target), text_(text), names_(names) {}

  void statement(PropertySet& set) {
    bool everyInstruction = false;
    if (accept("at")) {
      expect("every");
      expect("instruction");
      everyInstruction = true;
    }
    const Token head = peek();
    const std::string word = lower(head.text);
    if (word == "external") return external(set);
    if (word == "reset") return resetDominant(set);
    if (word == "initial") {
      take();
      expect("retentive");
      set.initialRetentive = true;
      return end();
    }
    Property property;
    property.atEveryInstruction = everyInstruction;
    property.span = tokens_.front().span;
    const Token& last = tokens_[tokens_.size() - 2];
    property.span.length = last.span.offset + last.span.length - property.span.offset;
    property.text = std::string(text_);
    if (word == "pulse") {
      take();
      pulse(property);
    } else if (word == "assume" || word == "prove" || word == "reach") {
      take();
      name(property, set);
      if (word == "prove") {
        goal(property);
      } else {
        property.kind = word == "assume" ? PropertyKind::Assume : PropertyKind::Reach;
        property.first = truth();
      }
    } else {
      throw Mistake{
          syntaxRule, head.span,
          fmt::format("a statement begins with assume, prove, reach, external, initial, pulse or reset, not with '{}'",
                      head.text),
          "write for example: prove no_shoot_through: never Q0.0 and Q0.1"};
    }
    end();
    if (everyInstruction && property.kind != PropertyKind::Always && property.kind != PropertyKind::Never) {
      throw Mistake{syntaxRule, head.span, "'at every instruction' goes with always and never only",
                    "leave it out, or state an invariant"};
    }
    property.remarks = std::move(remarks_);
    layoutCells(property);
    if (everyInstruction && !property.cells.empty()) {
      throw Mistake{syntaxRule, head.span,
                    "functions that look back in time are about scan ends, not about single instructions",
                    "leave out 'at every instruction', or the function"};
    }
    set.properties.push_back(std::move(property));
  }

 private:
  // ---- Statements ----------------------------------------------------------------------------------

  void name(Property& property, const PropertySet& set) {
    std::string text;
    Span span = peek().span;
    while (!is(":")) {
      if (peek().kind == PropertyToken::End)
        throw Mistake{syntaxRule, span, "no ':' after the name", "write: prove NAME: EXPRESSION"};
      const Token t = take();
      text +=
          text.empty() || t.span.offset == span.offset + span.length ? std::string(t.text) : " " + std::string(t.text);
      span = t.span;
    }
    take();
    if (text.empty()) text = fmt::format("property {}", set.properties.size() + 1);
    if (names_.isTaken(text, set))
      throw Mistake{nameRule, span, fmt::format("the name '{}' is already taken", text),
                    "give each property its own name"};
    property.name = text;
  }

  void goal(Property& property) {
    if (accept("always")) {
      property.kind = PropertyKind::Always;
      property.first = truth();
      return;
    }
    if (accept("never")) {
      property.kind = PropertyKind::Never;
      property.first = truth();
      return;
    }
    property.kind = PropertyKind::Always;
    property.first = truth();
    if (accept("leads")) {
      expect("to");
      property.second = truth();
      expect("within");
      const Token bound = peek();
      if (bound.kind == PropertyToken::Duration) {
        property.kind = PropertyKind::LeadsToTime;
        property.bound = duration();
      } else if (bound.kind == PropertyToken::Number) {
        property.kind = PropertyKind::LeadsToScans;
        property.bound = take().value;
        if (!accept("scans")) expect("scan");
      } else {
        throw Mistake{syntaxRule, bound.span, "'within' needs a number of scans or a time",
                      "write: within 3 scans, or: within 500ms"};
      }
    } else if (accept("only")) {
      expect("after");
      property.kind = PropertyKind::OnlyAfter;
      property.second = truth();
    } else if (accept("unless")) {
      property.kind = PropertyKind::Unless;
      property.second = truth();
    } else if (accept("held")) {
      property.kind = PropertyKind::HeldImplies;
      property.bound = duration();
      expect("implies");
      property.second = truth();
    }
  }

  void pulse(Property& property) {
    property.kind = PropertyKind::Pulse;
    const Token address = peek();
    property.name = fmt::format("pulse {}", address.text);
    property.first = truth();
    if (property.first.nodes.size() != 1 || property.first.root().op != ExprOp::Address)
      throw Mistake{syntaxRule, address.span, "'pulse' needs one input bit", "write: pulse I0.0 at most every 50ms"};
    const Area area = property.first.root().operand.area;
    if (area != Area::I && (area == Area::Q || !mayBeExternal(area)))
      throw Mistake{syntaxRule, address.span,
                    fmt::format("{} is no input: nothing outside the program sets it", address.text),
                    "write: pulse I0.0 at most every 50ms"};
    expect("at");
    expect("most");
    expect("every");
    property.bound = duration();
  }

  void external(PropertySet& set) {
    const Token head = take();
    do {
      ExternalRange range;
      range.span = head.span;
      range.first = range.last = address(take());
      if (accept("..")) range.last = address(take());
      if (const auto fault = faultOfRange(range.first, range.last))
        throw Mistake{typeRule, head.span, fault->message, fault->help};
      set.externals.push_back(range);
    } while (accept(","));
    end();
  }

  void resetDominant(PropertySet& set) {
    take();
    expect("dominant");
    do {
      const Token t = peek();
      const Operand bit = address(take());
      if (bit.width != Width::Bit || isInputArea(bit.area) || hasBitAndWord(bit.area))
        throw Mistake{typeRule, t.span, "a bit that is set and reset is needed here", "write for example Q0.0, M0.1"};
      set.resetDominant.push_back(bit);
    } while (accept(","));
    end();
  }

  std::int64_t duration() {
    const Token t = take();
    if (t.kind != PropertyToken::Duration)
      throw Mistake{syntaxRule, t.span, fmt::format("a time is needed here, not '{}'", t.text),
                    "write a number with ms, s, min or h, such as 500ms or 2s"};
    if (t.isTooLarge)
      throw Mistake{syntaxRule, t.span, fmt::format("'{}' is longer than any machine runs", t.text),
                    "times go up to 1000000h"};
    return t.value;
  }

  void end() {
    if (peek().kind != PropertyToken::End)
      throw Mistake{syntaxRule, peek().span, fmt::format("'{}' does not belong here", peek().text), formsHelp};
  }

  // ---- Expressions -----------------------------------------------------------------------------------

  Expr truth() {
    Expr expr;
    const std::uint32_t start = peek().span.offset;
    const std::uint32_t root = implies(expr);
    if (expr.nodes[root].type != ExprType::Truth && peek().kind == PropertyToken::Punctuation) end();
    needTruth(expr, root);
    const std::uint32_t stop = endOfLast();
    const std::uint32_t base =
        tokens_.front().span.offset - static_cast<std::uint32_t>(tokens_.front().text.data() - text_.data());
    expr.text = std::string(text_.substr(start - base, stop - start));
    if (expr.root().op == ExprOp::Implies)
      expr.premise = std::string(text_.substr(premise_.first - base, premise_.second - premise_.first));
    return expr;
  }

  /// Offset behind the token that was taken last.
  std::uint32_t endOfLast() const {
    return at_ == 0 ? peek().span.offset : tokens_[at_ - 1].span.offset + tokens_[at_ - 1].span.length;
  }

  /// `a implies b implies c` means a implies (b implies c). Without recursion: a chain has any length.
  std::uint32_t implies(Expr& e) {
    std::vector<std::uint32_t> parts;
    std::pair<std::uint32_t, std::uint32_t> outermost{};
    for (;;) {
      const std::uint32_t begin = peek().span.offset;
      parts.push_back(disjunction(e));
      if (parts.size() == 1) outermost = {begin, endOfLast()};
      if (!accept("implies")) break;
    }
    std::uint32_t node = parts.back();
    for (std::size_t i = parts.size() - 1; i-- > 0;) node = binary(e, ExprOp::Implies, parts[i], node);
    if (parts.size() > 1) premise_ = outermost;
    return node;
  }
  std::uint32_t disjunction(Expr& e) {
    std::uint32_t left = exclusive(e);
    while (accept("or")) left = binary(e, ExprOp::Or, left, exclusive(e));
    return left;
  }
  std::uint32_t exclusive(Expr& e) {
    std::uint32_t left = conjunction(e);
    while (accept("xor")) left = binary(e, ExprOp::Xor, left, conjunction(e));
    return left;
  }
  std::uint32_t conjunction(Expr& e) {
    std::uint32_t left = negation(e);
    while (accept("and")) left = binary(e, ExprOp::And, left, negation(e));
    return left;
  }
  std::uint32_t negation(Expr& e) {
    if (accept("not")) {
      Nesting nesting(*this);
      const std::uint32_t arg = negation(e);
      needTruth(e, arg);
      return add(e, {.op = ExprOp::Not, .args = {arg}});
    }
    return comparison(e);
  }
  std::uint32_t comparison(Expr& e) {
    const std::uint32_t left = sum(e);
    static constexpr std::pair<std::string_view, ExprOp> relations[] = {
        {"=", ExprOp::Equal},      {"==", ExprOp::Equal},  {"<>", ExprOp::NotEqual},    {"<", ExprOp::Less},
        {"<=", ExprOp::LessEqual}, {">", ExprOp::Greater}, {">=", ExprOp::GreaterEqual}};
    for (const auto& [text, op] : relations) {
      if (!is(text)) continue;
      const Token at = take();
      return compare(e, op, left, sum(e), at.span);
    }
    return left;
  }
  std::uint32_t sum(Expr& e) {
    std::uint32_t left = product(e);
    for (;;) {
      const Token at = peek();
      if (accept("+"))
        left = arithmetic(e, ExprOp::Add, left, product(e), at.span);
      else if (accept("-"))
        left = arithmetic(e, ExprOp::Sub, left, product(e), at.span);
      else
        return left;
    }
  }
  std::uint32_t product(Expr& e) {
    std::uint32_t left = unary(e);
    for (;;) {
      const Token at = peek();
      if (!accept("*")) return left;
      left = arithmetic(e, ExprOp::Mul, left, unary(e), at.span);
    }
  }
  std::uint32_t unary(Expr& e) {
    const Token at = peek();
    if (accept("not")) {  // behind a comparison sign, as in Q0.2 = not Q0.0
      Nesting nesting(*this);
      const std::uint32_t arg = unary(e);
      needTruth(e, arg);
      return add(e, {.op = ExprOp::Not, .args = {arg}});
    }
    if (accept("-")) {
      Nesting nesting(*this);
      const std::uint32_t arg = unary(e);
      needNumber(e, arg, at.span);
      needSigns(e, {arg}, at.span);
      const ExprNode& n = e.nodes[arg];
      return add(e, {.op = ExprOp::Negate,
                     .type = n.type,
                     .width = static_cast<std::uint8_t>(n.type == ExprType::Real ? n.width : std::min(64, n.width + 1)),
                     .args = {arg}});
    }
    return primary(e);
  }

  std::uint32_t primary(Expr& e) {
    const Token t = take();
    if (t.kind == PropertyToken::Number) {
      const bool isLong = target_ != nullptr && dialectOf(*target_).memory.numberBits > 32;
      if (isLong ? t.isHuge : t.isTooLarge)
        throw Mistake{syntaxRule, t.span, fmt::format("'{}' is larger than any number of the program", t.text),
                      isLong ? "numbers have up to 64 bits" : "numbers have up to 32 bits"};
      return add(e, {.op = ExprOp::Constant,
                     .type = ExprType::Number,
                     .width = t.value < 0 ? std::uint8_t{64} : signedWidth(t.value),
                     .value = t.value,
                     .operand = constant(t.value, t.isPattern   ? ConstantForm::Hex
                                                  : t.value < 0 ? amountForm
                                                                : ConstantForm::Decimal),
                     .span = t.span});
    }
    if (t.kind == PropertyToken::Real)
      return add(e, {.op = ExprOp::Constant,
                     .type = ExprType::Real,
                     .width = 32,
                     .value = t.value,
                     .operand = constant(t.longValue, ConstantForm::Real),
                     .span = t.span});
    if (t.text == "(") {
      Nesting nesting(*this);
      const std::uint32_t inner = implies(e);
      expect(")");
      return inner;
    }
    if (t.kind != PropertyToken::Word)
      throw Mistake{syntaxRule, t.span,
                    t.kind == PropertyToken::End
                        ? std::string("the expression ends too early")
                        : fmt::format("an address, a number or '(' is needed here, not '{}'", t.text),
                    formsHelp};
    const std::string word = lower(t.text);
    if (word == "true" || word == "false")
      return add(e, {.op = ExprOp::Constant, .value = word == "true", .span = t.span});
    if (word == "first_scan") return add(e, {.op = ExprOp::FirstScan, .span = t.span});
    if (is("(")) return function(e, word, t);
    return leaf(e, t);
  }

  std::uint32_t function(Expr& e, const std::string& word, const Token& t) {
    static constexpr std::pair<std::string_view, ExprOp> functions[] = {
        {"rises", ExprOp::Rises}, {"falls", ExprOp::Falls}, {"prev", ExprOp::Prev},
        {"once", ExprOp::Once},   {"since", ExprOp::Since}, {"held", ExprOp::Held}};
    const auto found =
        std::find_if(std::begin(functions), std::end(functions), [&](const auto& f) { return f.first == word; });
    if (found == std::end(functions))
      throw Mistake{syntaxRule, t.span, fmt::format("there is no function '{}'", t.text),
                    "functions: rises, falls, prev, once, since, held"};
    Nesting nesting(*this);
    expect("(");
    ExprNode node{.op = found->second, .span = t.span};
    node.args.push_back(implies(e));
    if (node.op == ExprOp::Since) {
      expect(",");
      node.args.push_back(implies(e));
    } else if (node.op == ExprOp::Held) {
      expect(",");
      node.milliseconds = duration();
    }
    expect(")");
    if (node.op == ExprOp::Prev) {
      node.type = e.nodes[node.args[0]].type;
      node.width = e.nodes[node.args[0]].width;
    } else {
      for (const std::uint32_t arg : node.args) needTruth(e, arg);
    }
    return add(e, std::move(node));
  }

  std::uint32_t leaf(Expr& e, const Token& t) {
    Token bare = t;
    const bool asValue = t.text.size() > 6 && lower(t.text.substr(t.text.size() - 6)) == ".value";
    if (asValue) bare.text.remove_suffix(6);
    ExprNode node{.op = ExprOp::Address, .operand = address(bare), .span = t.span};
    if (asValue) meansValue(node.operand);
    const Operand& o = node.operand;
    const bool hasBit = hasBitAndWord(o.area);
    if (asValue && !hasBit)
      throw Mistake{typeRule, t.span, fmt::format("'{}' has no value beside itself", bare.text),
                    ".value is for timers and counters"};
    if ((hasBit && !asValue) || (!areaInfo(o.area).width && o.width == Width::Bit)) return add(e, std::move(node));
    node.type = o.form == ConstantForm::Real ? ExprType::Real : ExprType::Number;
    node.width = signedWidth(o);
    const bool isMemory = target_ == nullptr || !dialectOf(*target_).memory.isOfVariables;
    node.isWhole = isMemory && o.form == ConstantForm::SignedDecimal;
    if (isMemory) node.operand.form = ConstantForm::Decimal;
    return add(e, std::move(node));
  }
  /// The value of a timer or counter instead of its bit; of an S5 timer the ms that are left.
  void meansValue(Operand& operand) const {
    if (operand.area == Area::T && target_ != nullptr && dialectOf(*target_).run.counting == Counting::Elements)
      operand.width = Width::DWord;
  }
  Operand address(const Token& t) {
    const std::optional<Operand> operand = t.kind == PropertyToken::Word ? lookup_(t.text) : std::nullopt;
    if (!operand && isKeyword(lower(t.text)))
      throw Mistake{syntaxRule, t.span, fmt::format("'{}' does not belong here", t.text), formsHelp};
    const bool isUnknown = !operand && target_ != nullptr && dialectOf(*target_).memory.hasDataBlocks;
    if (const std::optional<Operand> place = isUnknown ? step7::addressNamed(t.text) : std::nullopt;
        place && place->area == Area::DB)
      throw Mistake{addressRule, t.span, fmt::format("'{}' is in no data block of the program", t.text),
                    "add the source of the data block, or correct the address"};
    if (!operand || operand->kind != OperandKind::Direct) {
      const std::string joined = fmt::format("{}{}", t.text, peek().text);  // of "Q 4.0", as statement lists have it
      throw Mistake{addressRule, t.span, fmt::format("'{}' is no address and no known symbol", t.text),
                    !operand && lookup_(joined) ? fmt::format("write {}, without a blank", joined)
                                                : "give the symbol table with --symbols, or write the address"};
    }
    if (operand->area == Area::L) {
      throw Mistake{addressRule, t.span,
                    fmt::format("'{}' has no value between scans: local memory belongs to one call (001:1367)", t.text),
                    "let the program copy it to M or another memory that stays, and ask for that"};
    }
    if (target_ != nullptr) {
      if (const std::optional<std::string> reason = missingFrom(*target_, *operand))
        throw Mistake{addressRule, t.span, *reason, "correct the address, or choose the CPU with --cpu"};
    }
    return *operand;
  }

  // ---- Types ---------------------------------------------------------------------------------------

  void needTruth(Expr& e, std::uint32_t i) {
    ExprNode& n = e.nodes[i];
    if (n.type == ExprType::Truth) return;
    if (n.op == ExprOp::Constant && n.type == ExprType::Number && (n.value == 0 || n.value == 1)) {
      n.type = ExprType::Truth;
      n.width = 1;
      return;
    }
    throw Mistake{typeRule, n.span, "a condition is needed here, this is a number",
                  "compare it, for example VW10 > 100"};
  }
  /// A timer or counter bit in a numeric place means its current value.
  void needNumber(Expr& e, std::uint32_t i, Span at) {
    ExprNode& n = e.nodes[i];
    if (n.type != ExprType::Truth) return;
    if (n.op == ExprOp::Address && hasBitAndWord(n.operand.area)) {
      n.type = ExprType::Number;
      meansValue(n.operand);
      n.width = signedWidth(n.operand);
      return;
    }
    throw Mistake{typeRule, n.span.length != 0 ? n.span : at, "a number is needed here, this is a condition",
                  "use and, or, not between conditions"};
  }

  std::uint32_t compare(Expr& e, ExprOp op, std::uint32_t left, std::uint32_t right, Span at) {
    if (comparesTruth(e, op, left, right)) {
      needTruth(e, left);
      needTruth(e, right);
    } else {
      needNumber(e, left, at);
      needNumber(e, right, at);
      fitConstant(e, left, right, remarks_);
      fitConstant(e, right, left, remarks_);
      if (e.nodes[left].type == ExprType::Real || e.nodes[right].type == ExprType::Real)
        needSigns(e, {left, right}, at);
      asReals(e, left, right, remarks_);
    }
    return add(e, {.op = op, .args = {left, right}, .span = at});
  }
  std::uint32_t arithmetic(Expr& e, ExprOp op, std::uint32_t left, std::uint32_t right, Span at) {
    needNumber(e, left, at);
    needNumber(e, right, at);
    needSigns(e, {left, right}, at);
    asReals(e, left, right, remarks_);
    return add(e, arithmeticNode(e, op, left, right, at));
  }
  std::uint32_t binary(Expr& e, ExprOp op, std::uint32_t left, std::uint32_t right) {
    needTruth(e, left);
    needTruth(e, right);
    return add(e, {.op = op, .args = {left, right}});
  }
  static std::uint32_t add(Expr& e, ExprNode node) {
    e.nodes.push_back(std::move(node));
    return static_cast<std::uint32_t>(e.nodes.size() - 1);
  }

  // ---- Tokens --------------------------------------------------------------------------------------

  /// Keeps hostile nesting from exhausting the stack.
  struct Nesting {
    explicit Nesting(Parser& parser) : parser_(parser) {
      if (++parser_.depth_ > 500)
        throw Mistake{syntaxRule, parser_.peek().span, "the expression is nested too deeply",
                      "split it into several properties"};
    }
    ~Nesting() { --parser_.depth_; }
    Parser& parser_;
  };
  const Token& peek() const { return tokens_[at_]; }
  Token take() { return at_ + 1 < tokens_.size() ? tokens_[at_++] : tokens_[at_]; }
  bool is(std::string_view text) const { return peek().kind != PropertyToken::End && lower(peek().text) == text; }
  bool accept(std::string_view text) {
    if (!is(text)) return false;
    take();
    return true;
  }
  void expect(std::string_view text) {
    if (!accept(text))
      throw Mistake{
          syntaxRule, peek().span,
          fmt::format("'{}' is needed here{}", text,
                      peek().kind == PropertyToken::End ? std::string() : fmt::format(", not '{}'", peek().text)),
          ""};
  }

  std::vector<Token> tokens_;
  const OperandLookup& lookup_;
  const Target* target_;
  std::string_view text_;
  GoalNames& names_;
  std::vector<std::string> remarks_;
  std::pair<std::uint32_t, std::uint32_t>
      premise_{};  ///< offsets around the left side of an implication; the outermost is left here
  std::size_t at_ = 0;
  int depth_ = 0;
};

}  // namespace

void readPropertyText(std::uint32_t file, std::string_view text, std::uint32_t offset, const OperandLookup& lookup,
                      PropertySet& set, std::vector<Finding>& findings, const Target* target, GoalNames& names) {
  std::size_t begin = 0;
  while (begin <= text.size()) {
    const std::size_t stop = std::min(text.find('\n', begin), text.size());
    const std::string_view line = text.substr(begin, stop - begin);
    std::vector<Token> tokens = tokenize(line, file, offset + static_cast<std::uint32_t>(begin));
    if (tokens.size() > 1) {
      const std::size_t last =
          tokens[tokens.size() - 2].span.offset + tokens[tokens.size() - 2].span.length - (offset + begin);
      try {
        Parser(std::move(tokens), lookup, target, line.substr(0, last), names).statement(set);
      } catch (const Mistake& mistake) {
        Finding finding;
        finding.rule = mistake.rule;
        finding.severity = Severity::Error;
        finding.message = mistake.message;
        finding.span = mistake.span;
        finding.help = mistake.help;
        findings.push_back(std::move(finding));
        if (maySayOfTheWorld(line)) set.unread.push_back({std::string(line.substr(0, last)), mistake.span});
      }
    }
    begin = stop + 1;
  }
}

}  // namespace rungproof
