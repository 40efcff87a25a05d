// Rules for truth values and if-then-else. A conjunction is seen as its set of conjuncts (up to a limit), and each
// part is asked what the others say about it: implied parts go, contradictions give 0, and two negated conjunctions
// that differ in one sign give their common part, so that guards split by a jump join to the guard they came from.
// The two-level rules follow Brummayer and Biere, "Local Two-Level And-Inverter Graph Minimization without Blowup".
#include <algorithm>

#include "analysis/graph/graph.hpp"

namespace rungproof {

namespace {

/// Nodes that one reduction looks at.
constexpr int reduceBudget = 24;

/// A comparison of a node with constants as an interval; signed values are shifted so that order is unsigned.
struct Range {
  Node subject = noNode;
  bool isSigned = false;
  bool isPoint = false;     ///< an equality, which has no signedness
  bool isInverted = false;  ///< everything but the interval
  std::uint64_t low = 0, high = 0;
};

std::optional<Range> rangeOf(const Graph& g, Node literal) {
  const bool isNegated = g[literal].op == Op::Not;
  const NodeData& n = g[isNegated ? g[literal].child[0] : literal];
  if (n.op != Op::Equal && n.op != Op::Ult && n.op != Op::Slt) return std::nullopt;
  const bool constantRight = g[n.child[1]].op == Op::Constant;
  if (!constantRight && g[n.child[0]].op != Op::Constant) return std::nullopt;
  Range r;
  r.subject = n.child[constantRight ? 0 : 1];
  const std::uint64_t mask = Graph::maskOf(g[r.subject].width);
  std::uint64_t k = g[n.child[constantRight ? 1 : 0]].value;
  if (n.op == Op::Equal) {
    r.isPoint = true;
    r.isInverted = isNegated;
    r.low = r.high = k;
    return r;
  }
  r.isSigned = n.op == Op::Slt;
  if (r.isSigned) k ^= mask ^ mask >> 1;
  if (constantRight) {  // x < k, or its negation k <= x
    r.low = isNegated ? k : 0;
    r.high = isNegated ? mask : k - 1;
    if (!isNegated && k == 0) return std::nullopt;
  } else {  // k < x, or its negation x <= k
    if (!isNegated && k == mask) return std::nullopt;
    r.low = isNegated ? 0 : k + 1;
    r.high = isNegated ? k : mask;
  }
  return r;
}

}  // namespace

Graph::Conjuncts Graph::conjunctsOf(Node a) const {
  Conjuncts result;
  result.item[result.count++] = a;
  for (std::size_t i = 0; i < result.count;) {
    const Node n = result.item[i];
    if (is(n, Op::And) && widthOf(n) == 1 && result.count < conjunctLimit) {
      result.item[i] = child(n, 0);
      result.item[result.count++] = child(n, 1);
    } else {
      ++i;
    }
  }
  return result;
}

/// Truth of `condition` where `assumed` holds, from the two alone.
Graph::Truth Graph::underOne(Node condition, Node assumed) const {
  if (condition == assumed) return Truth::True;
  const bool negated = is(condition, Op::Not), assumedNegated = is(assumed, Op::Not);
  if (negated && child(condition, 0) == assumed) return Truth::False;
  if (assumedNegated && child(assumed, 0) == condition) return Truth::False;
  const Node subject = compared_[indexOf(condition)];
  if (subject == noNode || subject != compared_[indexOf(assumed)]) return Truth::Open;
  const std::optional<Range> given = rangeOf(*this, assumed);
  if (!given || given->isInverted) return Truth::Open;
  std::optional<Range> asked = rangeOf(*this, condition);
  if (!asked) return Truth::Open;
  Range g = *given, q = *asked;
  const std::uint64_t mask = maskOf(widthOf(g.subject)), sign = mask ^ mask >> 1;
  if (g.isPoint && q.isSigned)
    g.low = g.high = g.low ^ sign;
  else if (q.isPoint && g.isSigned)
    q.low = q.high = q.low ^ sign;
  else if (!g.isPoint && !q.isPoint && g.isSigned != q.isSigned)
    return Truth::Open;
  const bool inside = q.low <= g.low && g.high <= q.high;
  const bool apart = q.high < g.low || g.high < q.low;
  if (inside) return q.isInverted ? Truth::False : Truth::True;
  if (apart) return q.isInverted ? Truth::True : Truth::False;
  return Truth::Open;
}

/// Truth of `condition` where the conjunction `refuted` is false.
Graph::Truth Graph::underFalse(Node condition, Node refuted) const {
  const bool isNegated = is(condition, Op::Not);
  const Node positive = isNegated ? child(condition, 0) : condition;
  if (positive == refuted) return isNegated ? Truth::True : Truth::False;
  if (!is(positive, Op::And)) return Truth::Open;
  const Conjuncts have = conjunctsOf(positive), needed = conjunctsOf(refuted);
  const bool contains = std::all_of(needed.all().begin(), needed.all().end(), [&](Node n) {
    return std::find(have.all().begin(), have.all().end(), n) != have.all().end();
  });
  if (!contains) return Truth::Open;
  return isNegated ? Truth::True : Truth::False;
}

Graph::Truth Graph::under(Node condition, std::span<const Node> assumed) const {
  const bool isNegated = is(condition, Op::Not);
  const Node positive = isNegated ? child(condition, 0) : condition;
  const bool isProduct = is(positive, Op::And);
  for (const Node a : assumed) {
    if (const Truth t = underOne(condition, a); t != Truth::Open) return t;
    // A refuted product refutes every product that contains it.
    if (isProduct && is(a, Op::Not) && is(child(a, 0), Op::And)) {
      if (const Truth t = underFalse(condition, child(a, 0)); t != Truth::Open) return t;
    }
  }
  if (!isProduct) return Truth::Open;
  bool allTrue = true;
  const Conjuncts parts = conjunctsOf(positive);
  for (const Node part : parts.all()) {
    Truth t = Truth::Open;
    for (std::size_t i = 0; i < assumed.size() && t == Truth::Open; ++i) t = underOne(part, assumed[i]);
    if (t == Truth::False) return isNegated ? Truth::True : Truth::False;
    if (t == Truth::Open) allTrue = false;
  }
  if (allTrue) return isNegated ? Truth::False : Truth::True;
  return Truth::Open;
}

Node Graph::makeNot(Node a) {
  const int width = widthOf(a);
  if (is(a, Op::Not)) return child(a, 0);
  if (isConstant(a)) return constantNode(~(*this)[a].value, width);
  return intern({Op::Not, static_cast<std::uint8_t>(width), {a, noNode, noNode}, 0});
}

/// !P & !Q where P and Q are conjunctions: their common part negated if they differ in one sign, or an equivalence.
Node Graph::joinNegated(Node a, Node b) {
  if (!is(a, Op::Not) || !is(b, Op::Not) || !is(child(a, 0), Op::And) || !is(child(b, 0), Op::And)) return noNode;
  const Conjuncts p = conjunctsOf(child(a, 0)), q = conjunctsOf(child(b, 0));
  if (p.count != q.count || p.count < 2) return noNode;
  const auto isComplement = [&](Node x, Node y) {
    return (is(x, Op::Not) && child(x, 0) == y) || (is(y, Op::Not) && child(y, 0) == x);
  };
  std::array<Node, conjunctLimit> common{};
  std::size_t commonCount = 0;
  int opposite = 0;
  for (const Node x : p.all()) {
    if (std::find(q.all().begin(), q.all().end(), x) != q.all().end()) {
      common[commonCount++] = x;
    } else if (std::any_of(q.all().begin(), q.all().end(), [&](Node y) { return isComplement(x, y); })) {
      ++opposite;
    } else {
      return noNode;
    }
  }
  if (opposite == 1 && commonCount + 1 == p.count) {
    Node product = common[0];
    for (std::size_t i = 1; i < commonCount; ++i) product = make(Op::And, 1, product, common[i]);
    return makeNot(product);
  }
  if (opposite == 2 && p.count == 2) return make(Op::Xor, 1, p.item[0], p.item[1]);  // !(x & y) & !(!x & !y)
  return noNode;
}

/// A truth value that equals `n` where the known literals hold, with what they decide inside it replaced. `budget`:
/// how many nodes may still be looked at.
Node Graph::reduce(Node n, std::span<const Node> known, int& budget) {
  if (isConstant(n) || --budget < 0) return n;
  switch (under(n, known)) {
    case Truth::True: return constantNode(1, 1);
    case Truth::False: return constantNode(0, 1);
    case Truth::Open: break;
  }
  if (is(n, Op::Not)) {
    const Node inner = reduce(child(n, 0), known, budget);
    return inner == child(n, 0) ? n : makeNot(inner);
  }
  if (is(n, Op::And)) {
    const Node left = reduce(child(n, 0), known, budget), right = reduce(child(n, 1), known, budget);
    return left == child(n, 0) && right == child(n, 1) ? n : make(Op::And, 1, left, right);
  }
  if (is(n, Op::Ite)) {
    const Truth t = under(child(n, 0), known);
    if (t != Truth::Open) return reduce(child(n, t == Truth::True ? 1 : 2), known, budget);
    const Node whenTrue = reduce(child(n, 1), known, budget), whenFalse = reduce(child(n, 2), known, budget);
    if (whenTrue != child(n, 1) || whenFalse != child(n, 2)) return make(Op::Ite, 1, child(n, 0), whenTrue, whenFalse);
  }
  return n;
}
Node Graph::reduced(Node n, std::span<const Node> known) {
  int budget = reduceBudget;
  return reduce(n, known, budget);
}

Node Graph::given(Node n, Node guard) {
  if (isAsWritten_ || isConstant(guard) || isConstant(n)) return n;
  const Node followed = is(guard, Op::Not) ? follow(n, child(guard, 0), false) : follow(n, guard, true);
  if (widthOf(n) != 1) return followed;
  work_ = workLimit;
  return reduced(followed, conjunctsOf(guard).all());
}

Node Graph::makeAnd(Node a, Node b) {
  if (isConstant(a)) std::swap(a, b);
  if (isConstant(b)) return isZero(b) ? b : a;
  if (a == b) return a;
  const Conjuncts ofA = conjunctsOf(a), ofB = conjunctsOf(b);
  switch (under(b, ofA.all())) {
    case Truth::True: return a;
    case Truth::False: return constantNode(0, 1);
    case Truth::Open: break;
  }
  switch (under(a, ofB.all())) {
    case Truth::True: return b;
    case Truth::False: return constantNode(0, 1);
    case Truth::Open: break;
  }
  if (const Node n = reduced(b, ofA.all()); n != b) return make(Op::And, 1, a, n);
  if (const Node n = reduced(a, ofB.all()); n != a) return make(Op::And, 1, b, n);
  // One side a single negated conjunction that joins with a part of the other.
  if (ofA.count == 1 || ofB.count == 1) {
    const Conjuncts& parts = ofB.count == 1 ? ofA : ofB;
    const Node single = ofB.count == 1 ? b : a;
    for (std::size_t i = 0; i < parts.count; ++i) {
      Node result = joinNegated(parts.item[i], single);
      if (result == noNode) continue;
      for (std::size_t n = 0; n < parts.count; ++n) {
        if (n != i) result = make(Op::And, 1, result, parts.item[n]);
      }
      return result;
    }
  }
  if (indexOf(b) < indexOf(a)) std::swap(a, b);
  return intern({Op::And, 1, {a, b, noNode}, 0});
}

Node Graph::makeXor(Node a, Node b) {
  if (isConstant(a)) std::swap(a, b);
  if (isConstant(b)) return isZero(b) ? a : makeNot(a);
  if (a == b) return constantNode(0, 1);
  if (is(a, Op::Not)) return makeNot(make(Op::Xor, 1, child(a, 0), b));
  if (is(b, Op::Not)) return makeNot(make(Op::Xor, 1, a, child(b, 0)));
  for (int i = 0; i < 2; ++i) {
    if (is(b, Op::Xor) && child(b, i) == a) return child(b, 1 - i);
    if (is(a, Op::Xor) && child(a, i) == b) return child(a, 1 - i);
  }
  if (indexOf(b) < indexOf(a)) std::swap(a, b);
  return intern({Op::Xor, 1, {a, b, noNode}, 0});
}

/// The arm of an if-then-else as far as c = value decides the conditions on its top.
Node Graph::follow(Node arm, Node c, bool value) const {
  const Conjuncts known = conjunctsOf(c);
  while (is(arm, Op::Ite)) {
    const Truth t = value ? under(child(arm, 0), known.all()) : underFalse(child(arm, 0), c);
    if (t == Truth::Open) break;
    arm = child(arm, t == Truth::True ? 1 : 2);
  }
  return arm;
}

Node Graph::makeIte(int width, Node c, Node a, Node b) {
  if (isConstant(c)) return isZero(c) ? b : a;
  if (is(c, Op::Not)) {
    c = child(c, 0);
    std::swap(a, b);
  }
  a = follow(a, c, true);
  b = follow(b, c, false);
  if (a == b) return a;
  if (width == 1) return makeIteBool(c, a, b);
  if (is(c, Op::Equal) && isConstant(child(c, 1))) {
    if (a == child(c, 0)) a = child(c, 1);
    if (b == child(c, 0) && a == child(c, 1)) return b;
  }
  if (is(b, Op::Ite)) {
    if (child(b, 1) == a) return make(Op::Ite, width, make(Op::Or, 1, c, child(b, 0)), a, child(b, 2));
    if (child(b, 2) == a) return make(Op::Ite, width, make(Op::And, 1, makeNot(c), child(b, 0)), child(b, 1), a);
  }
  if (is(a, Op::Ite)) {
    if (child(a, 2) == b) return make(Op::Ite, width, make(Op::And, 1, c, child(a, 0)), child(a, 1), b);
    if (child(a, 1) == b) return make(Op::Ite, width, make(Op::And, 1, c, makeNot(child(a, 0))), child(a, 2), b);
  }
  return intern({Op::Ite, static_cast<std::uint8_t>(width), {c, a, b}, 0});
}

Node Graph::makeIteBool(Node c, Node a, Node b) {
  const auto isComplement = [&](Node x, Node y) {
    return (is(x, Op::Not) && child(x, 0) == y) || (is(y, Op::Not) && child(y, 0) == x);
  };
  const Conjuncts known = conjunctsOf(c);
  const Truth ofA = isConstant(a) ? Truth::Open : under(a, known.all());
  const Truth ofB = isConstant(b) ? Truth::Open : underFalse(b, c);
  if (ofA != Truth::Open) a = constantNode(ofA == Truth::True, 1);
  if (ofB != Truth::Open) b = constantNode(ofB == Truth::True, 1);
  if (a == b) return a;
  if (isConstant(a)) return isZero(a) ? make(Op::And, 1, makeNot(c), b) : make(Op::Or, 1, c, b);
  if (isConstant(b)) return isZero(b) ? make(Op::And, 1, c, a) : make(Op::Or, 1, makeNot(c), a);
  if (isComplement(a, b)) return makeNot(make(Op::Xor, 1, c, a));
  if (const Node n = reduced(a, known.all()); n != a) return make(Op::Ite, 1, c, n, b);
  const Node refuted[] = {makeNot(c)};
  if (const Node n = reduced(b, refuted); n != b) return make(Op::Ite, 1, c, a, n);
  if (is(a, Op::Not) && is(b, Op::Not)) return makeNot(make(Op::Ite, 1, c, child(a, 0), child(b, 0)));
  if (is(b, Op::Ite)) {
    if (child(b, 1) == a) return make(Op::Ite, 1, make(Op::Or, 1, c, child(b, 0)), a, child(b, 2));
    if (child(b, 2) == a) return make(Op::Ite, 1, make(Op::And, 1, makeNot(c), child(b, 0)), child(b, 1), a);
  }
  if (is(a, Op::Ite)) {
    if (child(a, 2) == b) return make(Op::Ite, 1, make(Op::And, 1, c, child(a, 0)), child(a, 1), b);
    if (child(a, 1) == b) return make(Op::Ite, 1, make(Op::And, 1, c, makeNot(child(a, 0))), child(a, 2), b);
  }
  return intern({Op::Ite, 1, {c, a, b}, 0});
}

}  // namespace rungproof
