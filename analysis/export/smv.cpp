// SMV: state variables with init and next, inputs as variables without either, one DEFINE for each operation. Division
// and shifts are written so that no operand meets a case which SMV leaves undefined.
#include <fmt/format.h>

#include <cctype>
#include <unordered_map>
#include <unordered_set>

#include "analysis/export/system.hpp"
#include "analysis/graph/evaluate.hpp"
#include "ir/check.hpp"

namespace rungproof {

namespace {

class SmvText {
 public:
  explicit SmvText(const TransitionSystem& system) : system_(system), graph_(*system.graph) {}

  std::string run() {
    for (const StateVariable& s : system_.states) declare(s.node, variableName(s.node));
    for (const Node n : system_.inputs) declare(n, variableName(n));
    std::vector<Node> roots = system_.constraints;
    for (const Question& q : system_.questions) roots.push_back(q.bad);
    for (const StateVariable& s : system_.states) {
      roots.push_back(s.next);
      if (s.init != noNode) roots.push_back(s.init);
    }
    for (const Node n : coneOf(graph_, roots)) define(n);
    std::string assigns, rest;
    for (const StateVariable& s : system_.states) {
      if (s.init != noNode) assigns += fmt::format("  init({}) := {};\n", of(s.node), of(s.init));
      assigns += fmt::format("  next({}) := {};\n", of(s.node), of(s.next));
    }
    for (const Node n : system_.constraints) rest += fmt::format("INVAR {};\n", of(n));
    for (std::size_t q = 0; q < system_.questions.size(); ++q) {
      rest += fmt::format("-- {}\nINVARSPEC NAME p{} := !{};\n", exportLine(system_.questions[q].name), q,
                          of(system_.questions[q].bad));
    }
    return "MODULE main\nVAR\n" + variables_ + "DEFINE\n" + defines_ + "ASSIGN\n" + assigns + rest;
  }

 private:
  /// A name of letters, digits and underscores that occurs once.
  std::string variableName(Node n) {
    std::string name;
    for (const char c : graph_.variables()[graph_[n].value].name)
      name += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
    if (name.empty() || std::isdigit(static_cast<unsigned char>(name[0])) != 0) name = "v_" + name;
    name += "_";  // no keyword ends so
    std::string unique = name;
    for (int i = 2; !taken_.insert(unique).second; ++i) unique = fmt::format("{}{}", name, i);
    return unique;
  }
  void declare(Node n, const std::string& name) {
    const int width = graph_[n].width;
    variables_ +=
        width == 1 ? fmt::format("  {} : boolean;\n", name) : fmt::format("  {} : unsigned word[{}];\n", name, width);
    names_[indexOf(n)] = name;
  }
  const std::string& of(Node n) const { return names_.at(indexOf(n)); }
  static std::string literal(std::uint64_t value, int width) {
    return width == 1 ? (value != 0 ? "TRUE" : "FALSE") : fmt::format("0ud{}_{}", width, value);
  }
  /// As a word, also where the width is 1.
  std::string word(Node n) const { return graph_[n].width == 1 ? fmt::format("word1({})", of(n)) : of(n); }

  void define(Node n) {
    if (names_.contains(indexOf(n))) return;
    const NodeData& node = graph_[n];
    if (node.op == Op::Constant) {
      names_[indexOf(n)] = literal(node.value, node.width);
    } else if (node.op == Op::Variable || node.op >= Op::RealAdd) {
      declare(n, fmt::format("free_{}", indexOf(n)));
    } else {
      const std::string name = fmt::format("n{}", indexOf(n));
      defines_ += fmt::format("  {} := {};\n", name, expression(node));
      names_[indexOf(n)] = name;
    }
  }

  std::string expression(const NodeData& node) const {
    const Node a = node.child[0], b = node.child[1];
    const auto infix = [&](const char* op) { return fmt::format("({} {} {})", of(a), op, of(b)); };
    const bool isTruth = node.width == 1;
    switch (node.op) {
      case Op::Not: return "!" + of(a);
      case Op::And: return infix("&");
      case Op::Or: return infix("|");
      case Op::Xor: return infix("xor");
      case Op::Equal: return infix("=");
      case Op::Ult: return fmt::format("({} < {})", word(a), word(b));
      case Op::Ule: return fmt::format("({} <= {})", word(a), word(b));
      case Op::Slt: return fmt::format("(signed({}) < signed({}))", word(a), word(b));
      case Op::Sle: return fmt::format("(signed({}) <= signed({}))", word(a), word(b));
      case Op::Ite: return fmt::format("({} ? {} : {})", of(a), of(b), of(node.child[2]));
      case Op::Concat: return fmt::format("({} :: {})", word(a), word(b));
      case Op::Zext: return fmt::format("extend({}, {})", word(a), node.width - graph_[a].width);
      case Op::Sext: return fmt::format("unsigned(extend(signed({}), {}))", word(a), node.width - graph_[a].width);
      case Op::Extract: {
        const std::string slice = fmt::format("{}[{}:{}]", word(a), node.value + node.width - 1, node.value);
        return isTruth ? fmt::format("bool({})", slice) : slice;
      }
      default: {
        const std::string text = arithmetic(node);
        return isTruth ? fmt::format("bool({})", text) : text;
      }
    }
  }

  /// Operations on words that give a word of the same width.
  std::string arithmetic(const NodeData& node) const {
    const std::string a = word(node.child[0]), b = word(node.child[1]);
    const int w = node.width;
    const auto number = [&](std::uint64_t value) { return fmt::format("0ud{}_{}", w, value); };
    const std::string zero = number(0), divisor = fmt::format("({} = {} ? {} : {})", b, zero, number(1), b);
    const auto isNegative = [](const std::string& x) { return fmt::format("(signed({0}) < signed({0} - {0}))", x); };
    const auto magnitude = [&](const std::string& x) { return fmt::format("({} ? -{} : {})", isNegative(x), x, x); };
    switch (node.op) {
      case Op::Add: return fmt::format("({} + {})", a, b);
      case Op::Sub: return fmt::format("({} - {})", a, b);
      case Op::Mul: return fmt::format("({} * {})", a, b);
      case Op::Udiv: return fmt::format("({} = {} ? {} : {} / {})", b, zero, number(Graph::maskOf(w)), a, divisor);
      case Op::Urem: return fmt::format("({} = {} ? {} : {} mod {})", b, zero, a, a, divisor);
      case Op::Sdiv: {
        const std::string quotient = fmt::format("({} / {})", magnitude(a), magnitude(divisor));
        const std::string byZero = fmt::format("({} ? {} : {})", isNegative(a), number(1), number(Graph::maskOf(w)));
        return fmt::format("({} = {} ? {} : {} xor {} ? -{} : {})", b, zero, byZero, isNegative(a), isNegative(b),
                           quotient, quotient);
      }
      case Op::Srem: {
        const std::string remainder = fmt::format("({} mod {})", magnitude(a), magnitude(divisor));
        return fmt::format("({} = {} ? {} : {} ? -{} : {})", b, zero, a, isNegative(a), remainder, remainder);
      }
      case Op::Shl:
        return fmt::format("({} < {} ? {} << {} : {})", b, number(static_cast<std::uint64_t>(w)), a, shift(b, w), zero);
      case Op::Lshr:
        return fmt::format("({} < {} ? {} >> {} : {})", b, number(static_cast<std::uint64_t>(w)), a, shift(b, w), zero);
      default: CHECK(false, "operation without SMV text"); return {};
    }
  }
  static std::string shift(const std::string& count, int w) {
    return fmt::format("({0} < 0ud{1}_{1} ? {0} : 0ud{1}_0)", count, w);
  }

  const TransitionSystem& system_;
  const Graph& graph_;
  std::string variables_, defines_;
  std::unordered_map<std::uint32_t, std::string> names_;  ///< by node index: name or literal
  std::unordered_set<std::string> taken_;
};

}  // namespace

std::string exportSmv(const TransitionSystem& system, const ExportRemarks& remarks) {
  std::string text;
  for (const std::string& remark : remarks) text += "-- " + exportLine(remark) + "\n";
  return text + SmvText(system).run();
}

}  // namespace rungproof
