// Instruction list of IEC 61131-3 (2nd edition): one current result, operators with C and N, parentheses, jumps, calls
// of function blocks. Each operator becomes the element that a drawing would have, so that IL and FBD share one
// meaning. Tested by tests/graphical/block_test.cpp.
#include <fmt/format.h>

#include <array>
#include <optional>

#include "frontend/graphical/drawn_scope.hpp"
#include "frontend/plcopen/plcopen_reader.hpp"
#include "frontend/stl/directive.hpp"
#include "frontend/stl/stl_lexer.hpp"

namespace rungproof {

namespace {

class ListReader {
 public:
  ListReader(SyntaxSink& sink, Span span, std::string_view text) : sink_(sink), span_(span), text_(text) {
    network_.span = span;
  }

  DrawnNetwork read() {
    std::size_t at = 0;
    while (at < text_.size()) {
      const std::size_t end = std::min(text_.find('\n', at), text_.size());
      line(at, end);
      at = end + 1;
    }
    if (!open_.empty()) fault("a parenthesis is not closed");
    return std::move(network_);
  }

 private:
  /// A result waiting for its closing parenthesis.
  struct Open {
    std::string function;
    bool isNegated;
    std::string before;
  };

  void line(std::size_t begin, std::size_t end) {
    here_ = {span_.file, span_.offset + static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end - begin)};
    std::string_view rest = withoutComment(text_.substr(begin, end - begin));
    const std::size_t colon = rest.find(':');
    if (colon != std::string_view::npos && rest.substr(colon, 2) != ":=" && rest.find('(') > colon) {
      element(DrawnKind::Label).text = std::string(trimmed(rest.substr(0, colon)));
      current_.clear();  // what is current here depends on where one comes from
      rest = trimmed(rest.substr(colon + 1));
    }
    if (rest.empty()) return;
    std::size_t length = 0;
    while (length < rest.size() && rest[length] != ' ' && rest[length] != '\t' && rest[length] != '(') ++length;
    std::string name = foldedName(rest.substr(0, length));
    const std::string_view operand = trimmed(rest.substr(length));
    if (rest[0] == ')') return close();
    if (name == "&") name = "AND";
    if (name == "&N") name = "ANDN";
    if (name == "LD" || name == "LDN") {
      current_ = value(operand, name == "LD");
      if (name == "LDN") current_ = function("NOT", {current_});
    } else if (name == "ST" || name == "STN") {
      store(operand, name == "STN", DrawnStorage::None);
    } else if (name == "S" || name == "R") {
      store(operand, false, name == "S" ? DrawnStorage::Set : DrawnStorage::Reset);
    } else if (name == "NOT") {
      current_ = function("NOT", {current_});
    } else if (name == "JMP" || name == "JMPC" || name == "JMPCN" || name == "RET" || name == "RETC" ||
               name == "RETCN") {
      leave(name, operand);
    } else if (name == "CAL" || name == "CALC" || name == "CALCN") {
      call(name, operand);
    } else {
      operate(std::move(name), operand);
    }
  }

  std::string_view withoutComment(std::string_view line) {
    const std::size_t start = line.find("(*");
    if (start != std::string_view::npos) {
      const std::size_t stop = line.find("*)", start);
      DrawnNote note;
      note.before = network_.elements.size();
      const Span place{here_.file, here_.offset + static_cast<std::uint32_t>(start),
                       static_cast<std::uint32_t>(std::min(stop, line.size()) - start)};
      note.lines.push_back({place});
      network_.notes.push_back(std::move(note));
      line = line.substr(0, start);
    }
    line = line.substr(0, std::min(line.find("//"), line.size()));
    return trimmed(line);
  }

  DrawnElement& element(DrawnKind kind) {
    DrawnElement e;
    e.kind = kind;
    e.id = fmt::format("line {}.{}", count_ + 1, network_.elements.size());
    e.span = here_;
    e.order = ++count_;
    network_.elements.push_back(std::move(e));
    return network_.elements.back();
  }

  /// `isKept`: several operators may look at the value.
  std::string value(std::string_view operand, bool isKept = false) {
    DrawnElement& e = element(DrawnKind::InVariable);
    e.text = std::string(operand);
    e.readsOnce = isKept;
    return e.id;
  }

  std::string function(std::string_view name, const std::vector<std::string>& inputs) {
    DrawnElement& e = element(DrawnKind::Block);
    e.text = std::string(name);
    int number = 0;
    for (const std::string& from : inputs) {
      DrawnPin pin;
      pin.name = fmt::format("IN{}", ++number);
      pin.span = here_;
      if (!from.empty()) pin.links.push_back({from, "", here_});
      e.inputs.push_back(std::move(pin));
    }
    e.outputs.push_back({"OUT", {}, "", false, DrawnEdge::None, here_});
    return e.id;
  }

  void feed(DrawnElement& e, const std::string& from, bool negated) const {
    DrawnPin pin;
    pin.span = here_;
    pin.negated = negated;
    if (!from.empty()) pin.links.push_back({from, "", here_});
    e.inputs.push_back(std::move(pin));
  }

  void store(std::string_view operand, bool negated, DrawnStorage storage) {
    const std::string from = current_;
    DrawnElement& e = element(storage == DrawnStorage::None ? DrawnKind::OutVariable : DrawnKind::Coil);
    e.text = std::string(operand);
    e.negated = negated;
    e.storage = storage;
    feed(e, from, false);
  }

  void leave(const std::string& name, std::string_view operand) {
    const bool isJump = name[0] == 'J';
    const bool isConditional = name.find('C') != std::string::npos;
    const std::string from = isConditional ? current_ : value("TRUE");
    DrawnElement& e = element(isJump ? DrawnKind::Jump : DrawnKind::Return);
    if (isJump) e.text = std::string(operand);
    feed(e, from, name.back() == 'N');
  }

  /// CAL T1(IN := a, PT := T#1s); the type stands in the declaration and is filled in by the builder.
  void call(const std::string& name, std::string_view operand) {
    const std::size_t open = operand.find('(');
    const std::string from = current_;
    std::vector<std::pair<std::string, std::string>> arguments;
    if (open != std::string_view::npos) {
      const std::size_t close = operand.rfind(')');
      std::string_view list =
          operand.substr(open + 1, close == std::string_view::npos ? std::string_view::npos : close - open - 1);
      while (!list.empty()) {
        const std::size_t comma = std::min(list.find(','), list.size());
        const std::string_view one = list.substr(0, comma);
        const std::size_t sign = one.find(":=");
        if (sign == std::string_view::npos) return fault("arguments are written NAME := VALUE");
        arguments.emplace_back(foldedName(trimmed(one.substr(0, sign))), std::string(trimmed(one.substr(sign + 2))));
        list = list.substr(std::min(comma + 1, list.size()));
      }
    }
    DrawnElement& e = element(DrawnKind::Block);
    e.instance = std::string(trimmed(operand.substr(0, open)));
    if (name != "CAL") {
      DrawnPin enable;
      enable.name = "EN";
      enable.negated = name == "CALCN";
      enable.span = here_;
      enable.links.push_back({from, "", here_});
      e.inputs.push_back(std::move(enable));
    }
    for (auto& [pin, text] : arguments) e.inputs.push_back({pin, {}, text, false, DrawnEdge::None, here_});
  }

  void operate(std::string name, std::string_view operand) {
    static constexpr std::array<std::string_view, 14> operators = {"AND", "OR", "XOR", "ADD", "SUB", "MUL", "DIV",
                                                                   "MOD", "GT", "GE",  "EQ",  "NE",  "LE",  "LT"};
    bool isNegated = false;
    bool isKnown = false;
    for (const std::string_view row : operators) {
      if (name == row) isKnown = true;
      if (name.size() == row.size() + 1 && name.starts_with(row) && name.back() == 'N') {
        isKnown = isNegated = true;
        name = row;
      }
    }
    if (!isKnown) return fault(fmt::format("operator {} is not known", excerpt(name)));
    if (!operand.empty() && operand[0] == '(') {
      const std::string_view first = trimmed(operand.substr(1));
      open_.push_back({name, isNegated, current_});
      if (open_.size() > 64) return fault("parentheses are nested too deep");
      if (!first.empty()) current_ = value(first, true);
      return;
    }
    if (operand.empty()) return fault(fmt::format("{} needs an operand", name));
    const std::string left = current_;
    std::string right = value(operand);
    if (isNegated) right = function("NOT", {right});
    current_ = function(name, {left, right});
  }

  void close() {
    if (open_.empty()) return fault("a parenthesis is closed that is not open");
    const Open open = open_.back();
    open_.pop_back();
    std::string right = current_;
    if (open.isNegated) right = function("NOT", {right});
    current_ = function(open.function, {open.before, right});
  }

  void fault(std::string message) {
    sink_.report(Syntax::XmlStructure, here_, std::move(message));
    network_.isDamaged = true;
  }

  SyntaxSink& sink_;
  Span span_;
  std::string_view text_;
  Span here_;
  DrawnNetwork network_;
  std::string current_;  ///< element that holds the current result
  std::vector<Open> open_;
  int count_ = 0;
};

}  // namespace

DrawnNetwork readInstructionList(Program& program, Span span, std::string_view text, const std::string& pou) {
  SyntaxSink sink(program, span.file);
  sink.setPlace(pou, 1);
  return ListReader(sink, span, text).read();
}

}  // namespace rungproof
