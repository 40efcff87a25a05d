// SMV as NuSMV 2.6 and nuXmv define it, as far as exports use it: boolean and unsigned word[N] variables, DEFINE,
// ASSIGN with init and next, INVAR, INVARSPEC. Types are checked as NuSMV does: no mixing of booleans and words, of
// signed and unsigned, or of widths; shift counts may not exceed the width and divisors may not be 0.
#include <cctype>
#include <set>
#include <sstream>
#include <stdexcept>

#include "tests/export/word_reader.hpp"

namespace rungproof::test {
namespace {

enum class Kind : std::uint8_t { Boolean, Unsigned, Signed };

struct Value {
  Kind kind = Kind::Boolean;
  int width = 1;
  std::uint64_t v = 0;
  bool isUndefined = false;  ///< a case that SMV leaves open; may only be met where it is not chosen
};

std::int64_t asSigned(const Value& x) {
  const std::uint64_t sign = 1ULL << (x.width - 1);
  return static_cast<std::int64_t>((x.v ^ sign) - sign);
}

/// Reads one expression; precedence from weak to strong: ?:, xor |, &, = < <=, << >>, + -, * / mod, ::, prefix - !.
class Expression {
 public:
  Expression(std::string text, const std::map<std::string, Value>& values) : text_(std::move(text)), values_(values) {}
  Value read() {
    const Value v = choice();
    skip();
    require(at_ == text_.size(), "text behind an expression");
    return v;
  }

 private:
  void require(bool condition, const char* what) const {
    if (!condition) throw std::runtime_error(std::string(what) + ": " + text_ + " at " + std::to_string(at_));
  }
  void skip() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
  }
  bool take(const std::string& token) {
    skip();
    if (text_.compare(at_, token.size(), token) != 0) return false;
    const bool isWord = std::isalpha(static_cast<unsigned char>(token[0])) != 0;
    const char after = at_ + token.size() < text_.size() ? text_[at_ + token.size()] : ' ';
    if (isWord && (std::isalnum(static_cast<unsigned char>(after)) != 0 || after == '_')) return false;
    if (token == "<" && (after == '<' || after == '=')) return false;
    if (token == ":" && after == ':') return false;
    at_ += token.size();
    return true;
  }
  void must(const std::string& token) { require(take(token), ("expected " + token).c_str()); }
  std::uint64_t digits() {
    skip();
    require(at_ < text_.size() && std::isdigit(static_cast<unsigned char>(text_[at_])) != 0, "a number is missing");
    std::size_t used = 0;
    const std::uint64_t n = std::stoull(text_.substr(at_), &used);
    at_ += used;
    return n;
  }
  void same(const Value& a, const Value& b) const { require(a.kind == b.kind && a.width == b.width, "types differ"); }
  static Value boolean(bool v, bool isUndefined) { return {Kind::Boolean, 1, v ? 1ULL : 0ULL, isUndefined}; }

  Value choice() {
    const Value c = disjunction();
    if (!take("?")) return c;
    require(c.kind == Kind::Boolean, "a condition must be boolean");
    const Value a = choice();
    must(":");
    const Value b = choice();
    same(a, b);
    Value result = c.v != 0 ? a : b;
    result.isUndefined = result.isUndefined || c.isUndefined;
    return result;
  }
  Value bitwise(const Value& a, const Value& b, std::uint64_t v) const {
    same(a, b);
    return {a.kind, a.width, v, a.isUndefined || b.isUndefined};
  }
  Value disjunction() {
    Value a = conjunction();
    for (;;) {
      if (take("xor")) {
        const Value b = conjunction();
        a = bitwise(a, b, a.v ^ b.v);
      } else if (take("|")) {
        const Value b = conjunction();
        a = bitwise(a, b, a.v | b.v);
      } else {
        return a;
      }
    }
  }
  Value conjunction() {
    Value a = comparison();
    while (take("&")) {
      const Value b = comparison();
      a = bitwise(a, b, a.v & b.v);
    }
    return a;
  }
  Value comparison() {
    const Value a = shifted();
    for (const std::string op : {"<=", "<", "="}) {
      if (!take(op)) continue;
      const Value b = shifted();
      same(a, b);
      require(op == "=" || a.kind != Kind::Boolean, "booleans have no order");
      const bool less = a.kind == Kind::Signed ? asSigned(a) < asSigned(b) : a.v < b.v;
      return boolean(op == "=" ? a.v == b.v : op == "<" ? less : less || a.v == b.v, a.isUndefined || b.isUndefined);
    }
    return a;
  }
  Value shifted() {
    const Value a = sum();
    for (const std::string op : {"<<", ">>"}) {
      if (!take(op)) continue;
      const Value b = sum();
      require(a.kind == Kind::Unsigned && b.kind == Kind::Unsigned, "only words can be shifted");
      const auto w = static_cast<std::uint64_t>(a.width);
      const std::uint64_t v = b.v >= w ? 0 : op == "<<" ? a.v << b.v & mask(a.width) : a.v >> b.v;
      return {a.kind, a.width, v, a.isUndefined || b.isUndefined || b.v > w};
    }
    return a;
  }
  Value arithmetic(const Value& a, const Value& b, std::uint64_t v) const {
    require(a.kind != Kind::Boolean, "booleans have no arithmetic");
    Value result = bitwise(a, b, v & mask(a.width));
    return result;
  }
  Value sum() {
    Value a = product();
    for (;;) {
      if (take("+")) {
        const Value b = product();
        a = arithmetic(a, b, a.v + b.v);
      } else if (take("-")) {
        const Value b = product();
        a = arithmetic(a, b, a.v - b.v);
      } else {
        return a;
      }
    }
  }
  Value product() {
    Value a = joined();
    for (;;) {
      if (take("*")) {
        const Value b = joined();
        a = arithmetic(a, b, a.v * b.v);
      } else if (take("/") || take("mod")) {
        const bool isDivision = text_[at_ - 1] == '/';
        const Value b = joined();
        require(a.kind == Kind::Unsigned, "signed division is not used");
        a = arithmetic(a, b, b.v == 0 ? 0 : isDivision ? a.v / b.v : a.v % b.v);
        a.isUndefined = a.isUndefined || b.v == 0;
      } else {
        return a;
      }
    }
  }
  Value joined() {
    const Value a = prefix();
    if (!take("::")) return a;
    const Value b = prefix();
    require(a.kind == Kind::Unsigned && b.kind == Kind::Unsigned && a.width + b.width <= 64,
            "only words can be joined");
    return {Kind::Unsigned, a.width + b.width, a.v << b.width | b.v, a.isUndefined || b.isUndefined};
  }
  Value prefix() {
    if (take("!")) {
      Value a = prefix();
      a.v = ~a.v & mask(a.width);
      return a;
    }
    if (take("-")) {
      Value a = prefix();
      require(a.kind != Kind::Boolean, "booleans have no sign");
      a.v = (0 - a.v) & mask(a.width);
      return a;
    }
    return sliced();
  }
  Value sliced() {
    Value a = primary();
    if (!take("[")) return a;
    const std::uint64_t high = digits();
    must(":");
    const std::uint64_t low = digits();
    must("]");
    require(a.kind != Kind::Boolean && low <= high && high < static_cast<std::uint64_t>(a.width),
            "slice outside its word");
    const int width = static_cast<int>(high - low) + 1;
    return {Kind::Unsigned, width, a.v >> low & mask(width), a.isUndefined};
  }
  Value call(Kind from, Kind to) {
    must("(");
    Value a = choice();
    must(")");
    require(a.kind == from, "conversion of another type");
    require(to != Kind::Boolean || a.width == 1, "bool() of a wide word");
    a.kind = to;
    return a;
  }
  Value primary() {
    if (take("(")) {
      const Value v = choice();
      must(")");
      return v;
    }
    if (take("word1")) return call(Kind::Boolean, Kind::Unsigned);
    if (take("bool")) return call(Kind::Unsigned, Kind::Boolean);
    if (take("signed")) return call(Kind::Unsigned, Kind::Signed);
    if (take("unsigned")) return call(Kind::Signed, Kind::Unsigned);
    if (take("extend")) {
      must("(");
      const Value a = choice();
      must(",");
      const int more = static_cast<int>(digits());
      must(")");
      require(a.kind != Kind::Boolean && a.width + more <= 64, "only words can be extended");
      const std::uint64_t v =
          a.kind == Kind::Signed ? static_cast<std::uint64_t>(asSigned(a)) & mask(a.width + more) : a.v;
      return {a.kind, a.width + more, v, a.isUndefined};
    }
    if (take("TRUE")) return boolean(true, false);
    if (take("FALSE")) return boolean(false, false);
    skip();
    if (text_.compare(at_, 3, "0ud") == 0) {
      at_ += 3;
      const int width = static_cast<int>(digits());
      must("_");
      const std::uint64_t v = digits();
      require(v <= mask(width), "constant wider than its word");
      return {Kind::Unsigned, width, v, false};
    }
    std::string name;
    while (at_ < text_.size() && (std::isalnum(static_cast<unsigned char>(text_[at_])) != 0 || text_[at_] == '_'))
      name += text_[at_++];
    const auto found = values_.find(name);
    require(found != values_.end(), "name not defined before its use");
    return found->second;
  }

  std::string text_;
  std::size_t at_ = 0;
  const std::map<std::string, Value>& values_;
};

class Smv {
 public:
  Smv(const std::vector<std::uint64_t>* states, const std::vector<std::uint64_t>* inputs)
      : states_(states), inputs_(inputs) {}

  void read(const std::string& text) {
    for (const std::string& name : namesWithNext(text)) isState_.insert(name);
    std::istringstream lines(text);
    std::string section;
    std::map<std::string, std::uint64_t> init, next;
    for (std::string line; std::getline(lines, line);) {
      if (line.rfind("--", 0) == 0 || line == "MODULE main") continue;
      if (line == "VAR" || line == "DEFINE" || line == "ASSIGN") {
        section = line;
      } else if (line.rfind("INVARSPEC NAME ", 0) == 0) {
        step.bads.push_back(!truth(between(line, " := ", ";")));
      } else if (line.rfind("INVAR ", 0) == 0) {
        step.constraints.push_back(truth(between(line, "INVAR ", ";")));
      } else if (section == "VAR") {
        declare(between(line, "  ", " : "), between(line, " : ", ";"));
      } else if (section == "DEFINE") {
        const std::string name = between(line, "  ", " := ");
        if (!values_.emplace(name, Expression(between(line, " := ", ";"), values_).read()).second)
          throw std::runtime_error("defined twice: " + name);
      } else {
        const bool isInit = line.rfind("  init(", 0) == 0;
        const std::string name = between(line, "(", ") := ");
        const Value v = Expression(between(line, " := ", ";"), values_).read();
        const Value& variable = values_.at(name);
        if (v.kind != variable.kind || v.width != variable.width || v.isUndefined)
          throw std::runtime_error("assignment of another type: " + line);
        (isInit ? init : next)[name] = v.v;
      }
    }
    for (const std::string& name : order_) {
      if (!isState_.contains(name)) continue;
      step.next.push_back(next.at(name));
      step.init.push_back(init.contains(name) ? init[name] : 0);
    }
  }

  WordStep step;
  WordFileShape shape;

 private:
  static std::string between(const std::string& line, const std::string& from, const std::string& to) {
    const std::size_t begin = line.find(from);
    const std::size_t end = begin == std::string::npos ? begin : line.find(to, begin + from.size());
    if (end == std::string::npos) throw std::runtime_error("unreadable: " + line);
    return line.substr(begin + from.size(), end - begin - from.size());
  }
  static std::vector<std::string> namesWithNext(const std::string& text) {
    std::vector<std::string> names;
    for (std::size_t at = text.find("\n  next("); at != std::string::npos; at = text.find("\n  next(", at + 1)) {
      names.push_back(text.substr(at + 8, text.find(')', at) - at - 8));
    }
    return names;
  }
  bool truth(const std::string& expression) const {
    const Value v = Expression(expression, values_).read();
    if (v.kind != Kind::Boolean || v.isUndefined) throw std::runtime_error("not a truth value: " + expression);
    return v.v != 0;
  }
  void declare(const std::string& name, const std::string& type) {
    Value v;
    if (type != "boolean") {
      v.kind = Kind::Unsigned;
      v.width = std::stoi(between(type, "unsigned word[", "]"));
    }
    const bool isState = isState_.contains(name);
    std::vector<int>& widths = isState ? shape.states : shape.inputs;
    const auto* given = isState ? states_ : inputs_;
    widths.push_back(v.width);
    if (given != nullptr && widths.size() <= given->size()) v.v = (*given)[widths.size() - 1];
    if (!values_.emplace(name, v).second) throw std::runtime_error("declared twice: " + name);
    order_.push_back(name);
  }

  const std::vector<std::uint64_t>* states_;
  const std::vector<std::uint64_t>* inputs_;
  std::set<std::string> isState_;
  std::vector<std::string> order_;
  std::map<std::string, Value> values_;
};

}  // namespace

WordFileShape smvShape(const std::string& text) {
  Smv file(nullptr, nullptr);
  file.read(text);
  return file.shape;
}

WordStep smvStep(const std::string& text, const std::vector<std::uint64_t>& states,
                 const std::vector<std::uint64_t>& inputs) {
  Smv file(&states, &inputs);
  file.read(text);
  return file.step;
}

}  // namespace rungproof::test
