// One definition for each node and scan keeps the sharing of the graph.
#include "analysis/graph/smt_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "ir/check.hpp"

namespace rungproof {

namespace {

bool isReal(Op op) { return op >= Op::RealAdd; }

const char* wordOperator(Op op) {
  switch (op) {
    case Op::Not: return "bvnot";
    case Op::And: return "bvand";
    case Op::Or: return "bvor";
    case Op::Xor: return "bvxor";
    case Op::Add: return "bvadd";
    case Op::Sub: return "bvsub";
    case Op::Mul: return "bvmul";
    case Op::Udiv: return "bvudiv";
    case Op::Urem: return "bvurem";
    case Op::Sdiv: return "bvsdiv";
    case Op::Srem: return "bvsrem";
    case Op::Shl: return "bvshl";
    case Op::Lshr: return "bvlshr";
    case Op::Ult: return "bvult";
    case Op::Ule: return "bvule";
    case Op::Slt: return "bvslt";
    case Op::Sle: return "bvsle";
    default: return nullptr;
  }
}

const char* truthOperator(Op op) {
  switch (op) {
    case Op::Not: return "not";
    case Op::And: return "and";
    case Op::Or: return "or";
    case Op::Xor: return "xor";
    default: return nullptr;
  }
}

}  // namespace

SmtText::SmtText(const TransitionSystem& system, std::string tag, std::unordered_set<std::uint32_t> open)
    : system_(system), graph_(*system.graph), tag_(std::move(tag)), open_(std::move(open)) {
  for (std::size_t i = 0; i < system.states.size(); ++i) states_.emplace(indexOf(system.states[i].node), i);
  std::unordered_map<std::string, int> uses;
  for (const Variable& variable : graph_.variables()) {
    std::string name = variable.name;
    for (char& c : name) {
      if (c == '|' || c == '\\' || static_cast<unsigned char>(c) < 32 || static_cast<unsigned char>(c) > 126) c = '_';
    }
    const int use = uses[name]++;
    if (use > 0) name += fmt::format("#{}", use);
    names_.emplace(indexOf(variable.node), std::move(name));
  }
}

std::string SmtText::sort(int width) { return width == 1 ? "Bool" : fmt::format("(_ BitVec {})", width); }

std::string SmtText::constant(std::uint64_t value, int width) {
  if (width == 1) return value != 0 ? "true" : "false";
  return fmt::format("(_ bv{} {})", value, width);
}

std::string SmtText::symbol(Node variable, int frame) const {
  return fmt::format("|{}@{}{}|", names_.at(indexOf(variable)), frame, tag_);
}

std::string SmtText::named(Node n, int frame) {
  const NodeData& node = graph_[n];
  if (node.op == Op::Constant) return constant(node.value, node.width);
  if (node.op == Op::Variable) return symbol(n, frame);
  return fmt::format("n{}@{}{}", indexOf(n), frame, tag_);
}

/// The node as a bit vector, also when its width is 1.
std::string SmtText::word(Node n, int frame) {
  const NodeData& node = graph_[n];
  if (node.width > 1) return named(n, frame);
  if (node.op == Op::Constant) return node.value != 0 ? "#b1" : "#b0";
  return fmt::format("(ite {} #b1 #b0)", named(n, frame));
}

std::string SmtText::expression(Node n, int frame) {
  const NodeData& node = graph_[n];
  const Node a = node.child[0], b = node.child[1], c = node.child[2];
  const int childWidth = graph_[a].width;
  std::string text;
  switch (node.op) {
    case Op::Equal: return fmt::format("(= {} {})", named(a, frame), named(b, frame));
    case Op::Ite: return fmt::format("(ite {} {} {})", named(a, frame), named(b, frame), named(c, frame));
    case Op::Concat: return fmt::format("(concat {} {})", word(a, frame), word(b, frame));
    case Op::Zext: text = fmt::format("((_ zero_extend {}) {})", node.width - childWidth, word(a, frame)); break;
    case Op::Sext: text = fmt::format("((_ sign_extend {}) {})", node.width - childWidth, word(a, frame)); break;
    case Op::Extract:
      text = fmt::format("((_ extract {} {}) {})", node.value + node.width - 1, node.value, word(a, frame));
      break;
    default: {
      const bool compares = node.op == Op::Ult || node.op == Op::Ule || node.op == Op::Slt || node.op == Op::Sle;
      const bool isTruth = node.width == 1 && truthOperator(node.op) != nullptr;
      const char* name = isTruth ? truthOperator(node.op) : wordOperator(node.op);
      CHECK(name != nullptr, "operation without SMT-LIB name");
      const auto argument = [&](Node child) { return isTruth ? named(child, frame) : word(child, frame); };
      text = b == noNode ? fmt::format("({} {})", name, argument(a))
                         : fmt::format("({} {} {})", name, argument(a), argument(b));
      if (isTruth || compares) return text;
    }
  }
  return node.width == 1 ? fmt::format("(= {} #b1)", text) : text;
}

void SmtText::define(Node n, int frame) {
  const NodeData& node = graph_[n];
  if (node.op == Op::Constant) return;
  const std::string type = sort(node.width);
  if (node.op == Op::Variable) {
    const auto state = states_.find(indexOf(n));
    if (state != states_.end() && frame > 0) {
      definitions_.push_back({symbol(n, frame), type, named(system_.states[state->second].next, frame - 1)});
    } else {
      declarations_ += fmt::format("(declare-fun {} () {})\n", symbol(n, frame), type);
    }
  } else if (isReal(node.op) || open_.contains(indexOf(n))) {
    declarations_ += fmt::format("(declare-fun {} () {})\n", named(n, frame), type);
  } else {
    definitions_.push_back({named(n, frame), type, expression(n, frame)});
  }
}

std::string SmtText::text() const {
  std::string text = declarations_;
  for (const Definition& d : definitions_)
    text += fmt::format("(define-fun {} () {} {})\n", d.name, d.sort, d.expression);
  return text;
}

namespace {

/// Calls with each symbol of a term; numerals and words of the language are among them.
template <class Use>
void forEachSymbol(std::string_view text, Use&& use) {
  for (std::size_t i = 0; i < text.size();) {
    const bool isQuoted = text[i] == '|';
    const std::size_t end = isQuoted ? text.find('|', i + 1) + 1 : std::min(text.find_first_of("() |", i), text.size());
    if (end > i) use(text.substr(i, end - i));
    i = std::max(end, i + 1);
  }
}

}  // namespace

std::string withDefinitions(const std::vector<SmtText::Definition>& definitions, const std::string& formula) {
  std::unordered_map<std::string_view, std::size_t> number;
  for (std::size_t i = 0; i < definitions.size(); ++i) number.emplace(definitions[i].name, i);
  std::vector<bool> isNeeded(definitions.size(), false);
  const auto need = [&](std::string_view symbol) {
    if (const auto found = number.find(symbol); found != number.end()) isNeeded[found->second] = true;
  };
  forEachSymbol(formula, need);
  for (std::size_t i = definitions.size(); i-- > 0;) {
    if (isNeeded[i]) forEachSymbol(definitions[i].expression, need);
  }
  // Those that rest on definitions of lower levels only share one let.
  std::vector<std::size_t> level(definitions.size(), 0);
  std::vector<std::string> lets;
  for (std::size_t i = 0; i < definitions.size(); ++i) {
    if (!isNeeded[i]) continue;
    forEachSymbol(definitions[i].expression, [&](std::string_view symbol) {
      if (const auto found = number.find(symbol); found != number.end())
        level[i] = std::max(level[i], level[found->second] + 1);
    });
    if (lets.size() <= level[i]) lets.resize(level[i] + 1);
    lets[level[i]] += fmt::format("({} {}) ", definitions[i].name, definitions[i].expression);
  }
  std::string text;
  for (const std::string& bindings : lets) text += "(let (" + bindings + ")\n";
  return text + formula + std::string(lets.size(), ')');
}

std::string SmtText::term(Node n, int frame) {
  std::vector<std::pair<Node, int>> stack{{n, frame}};
  while (!stack.empty()) {
    const auto [top, f] = stack.back();
    if (defined_.contains(key(top, f))) {
      stack.pop_back();
      continue;
    }
    const NodeData& node = graph_[top];
    const std::size_t before = stack.size();
    const auto need = [&](Node child, int childFrame) {
      if (!defined_.contains(key(child, childFrame))) stack.push_back({child, childFrame});
    };
    const auto state = node.op == Op::Variable ? states_.find(indexOf(top)) : states_.end();
    if (state != states_.end() && f > 0) need(system_.states[state->second].next, f - 1);
    if (node.op != Op::Variable && !isReal(node.op) && !open_.contains(indexOf(top))) {
      for (const Node child : node.child) {
        if (child != noNode) need(child, f);
      }
    }
    if (stack.size() > before) continue;
    stack.pop_back();
    define(top, f);
    defined_.insert(key(top, f));
  }
  return named(n, frame);
}

std::vector<std::string> SmtText::initialEquations(const std::unordered_set<std::uint32_t>& variables) {
  std::vector<std::string> result;
  for (const StateVariable& state : system_.states) {
    if (state.init == noNode || !variables.contains(indexOf(state.node))) continue;
    const std::string name = term(state.node, 0);
    result.push_back(fmt::format("(= {} {})", name, term(state.init, 0)));
  }
  return result;
}

}  // namespace rungproof
