// Children first, without recursion; the state of a later scan is what the scan before has made of it.
#include "analysis/recheck/scan_clauses.hpp"

#include "ir/check.hpp"

namespace rungproof {

ScanClauses::ScanClauses(const TransitionSystem& system, std::unordered_set<std::uint32_t> open)
    : system_(system), graph_(*system.graph), open_(std::move(open)) {}

bool ScanClauses::hasAnyValue(Node n) const {
  return graph_[n].op == Op::Variable || graph_[n].op >= Op::RealAdd || open_.contains(indexOf(n));
}

const ScanClauses::Word& ScanClauses::wordOf(ScanNode wanted) {
  if (wanted.scan > 0 && next_.empty()) {
    for (const StateVariable& state : system_.states) next_.emplace(indexOf(state.node), state.next);
  }
  std::vector<ScanNode> stack{wanted};
  while (!stack.empty()) {
    const ScanNode top = stack.back();
    if (words_.contains(key(top))) {
      stack.pop_back();
      continue;
    }
    const std::size_t before = stack.size();
    const auto need = [&](ScanNode n) {
      if (!words_.contains(key(n))) stack.push_back(n);
    };
    const auto state = top.scan > 0 ? next_.find(indexOf(top.node)) : next_.end();
    if (state != next_.end()) {
      need({state->second, top.scan - 1});
    } else if (!hasAnyValue(top.node)) {
      for (const Node child : graph_[top.node].child) {
        if (child != noNode) need({child, top.scan});
      }
    }
    if (stack.size() > before) continue;
    stack.pop_back();
    Word word = state != next_.end() ? words_.at(key({state->second, top.scan - 1})) : made(top);
    words_.emplace(key(top), std::move(word));
  }
  return words_.at(key(wanted));
}

ScanClauses::Word ScanClauses::made(ScanNode n) {
  const NodeData& node = graph_[n.node];
  const int width = node.width;
  if (hasAnyValue(n.node)) return gates_.fresh(width);
  const auto arg = [&](std::size_t i) -> const Word& { return words_.at(key({node.child[i], n.scan})); };
  const auto bitwise = [&](auto&& operation) {
    Word result;
    for (std::size_t i = 0; i < arg(0).size(); ++i) result.push_back(operation(arg(0)[i], arg(1)[i]));
    return result;
  };
  switch (node.op) {
    case Op::Constant: return GateClauses::constant(node.value, width);
    case Op::Not: return GateClauses::inverted(arg(0));
    case Op::And: return bitwise([&](int a, int b) { return gates_.both(a, b); });
    case Op::Or: return bitwise([&](int a, int b) { return gates_.either(a, b); });
    case Op::Xor: return bitwise([&](int a, int b) { return gates_.differ(a, b); });
    case Op::Add: return gates_.add(arg(0), arg(1));
    case Op::Sub: return gates_.subtract(arg(0), arg(1));
    case Op::Mul: return gates_.multiply(arg(0), arg(1));
    case Op::Udiv: return gates_.divide(arg(0), arg(1)).quotient;
    case Op::Urem: return gates_.divide(arg(0), arg(1)).remainder;
    case Op::Sdiv: return gates_.divideSigned(arg(0), arg(1)).quotient;
    case Op::Srem: return gates_.divideSigned(arg(0), arg(1)).remainder;
    case Op::Shl: return gates_.shift(arg(0), arg(1), true);
    case Op::Lshr: return gates_.shift(arg(0), arg(1), false);
    case Op::Equal: return {gates_.equal(arg(0), arg(1))};
    case Op::Ult: return {gates_.less(arg(0), arg(1))};
    case Op::Ule: return {gates_.less(arg(0), arg(1), true)};
    case Op::Slt: return {gates_.lessSigned(arg(0), arg(1))};
    case Op::Sle: return {gates_.lessSigned(arg(0), arg(1), true)};
    case Op::Ite: return gates_.choose(arg(0)[0], arg(1), arg(2));
    case Op::Concat: {
      Word result = arg(1);
      result.insert(result.end(), arg(0).begin(), arg(0).end());
      return result;
    }
    case Op::Extract: {
      const auto low = arg(0).begin() + static_cast<std::ptrdiff_t>(node.value);
      return {low, low + width};
    }
    case Op::Zext:
    case Op::Sext: {
      Word result = arg(0);
      result.resize(static_cast<std::size_t>(width), node.op == Op::Zext ? -GateClauses::yes : arg(0).back());
      return result;
    }
    default: break;
  }
  CHECK(false, "operation without clauses");
  return {};
}

int ScanClauses::literalOf(const Formula& formula) {
  switch (formula.kind) {
    case Formula::Kind::Truth: return wordOf(formula.terms[0])[0];
    case Formula::Kind::Equal: {
      const Word first = wordOf(formula.terms[0]);
      return gates_.equal(first, wordOf(formula.terms[1]));
    }
    case Formula::Kind::Not: return -literalOf(formula.parts[0]);
    case Formula::Kind::All:
    case Formula::Kind::Any: break;
  }
  const int sign = formula.kind == Formula::Kind::All ? 1 : -1;
  std::vector<int> literals;
  for (const Formula& part : formula.parts) literals.push_back(sign * literalOf(part));
  return sign * gates_.all(literals);
}

}  // namespace rungproof
