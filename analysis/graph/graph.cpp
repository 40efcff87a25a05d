// Making of nodes: hash-consing, the entry to the simplifier, and the domain interface on top of make().
// The rules themselves: graph_boolean.cpp, graph_words.cpp, graph_compare.cpp, graph_slices.cpp, graph_facts.cpp.
#include "analysis/graph/graph.hpp"

#include "analysis/graph/evaluate.hpp"
#include "ir/check.hpp"

namespace rungproof {

namespace {

/// Rewriting is local; the limits on depth and work only keep chains from being rewritten through and through.
constexpr int depthLimit = 40;

std::size_t hashOfNode(const NodeData& data) {
  std::uint64_t h = static_cast<std::uint64_t>(data.op) * 0x9E3779B97F4A7C15ULL + data.width;
  const auto mix = [&](std::uint64_t x) {
    h ^= x + 0x9E3779B97F4A7C15ULL + (h << 6) + (h >> 2);
    h *= 0xFF51AFD7ED558CCDULL;
    h ^= h >> 32;
  };
  for (const Node child : data.child) mix(indexOf(child));
  mix(data.value);
  return h;
}

bool same(const NodeData& a, const NodeData& b) {
  return a.op == b.op && a.width == b.width && a.child == b.child && a.value == b.value;
}

}  // namespace

bool Graph::isOnes(Node n) const { return isConstant(n, maskOf(widthOf(n))); }

void Graph::growTable() {
  std::vector<std::uint32_t> bigger(table_.empty() ? 1024 : table_.size() * 2, 0);
  for (const std::uint32_t entry : table_) {
    if (entry == 0) continue;
    std::size_t at = hashOfNode(nodes_[entry - 1]) & (bigger.size() - 1);
    while (bigger[at] != 0) at = (at + 1) & (bigger.size() - 1);
    bigger[at] = entry;
  }
  table_ = std::move(bigger);
}

Node Graph::intern(const NodeData& data) {
  if (nodes_.size() * 2 >= table_.size()) growTable();
  std::size_t at = hashOfNode(data) & (table_.size() - 1);
  for (; table_[at] != 0; at = (at + 1) & (table_.size() - 1)) {
    if (same(nodes_[table_[at] - 1], data)) return static_cast<Node>(table_[at] - 1);
  }
  const Facts facts = factsOf(data);
  if (data.op != Op::Constant && facts.low == facts.high && !isAsWritten_) return constantNode(facts.low, data.width);
  CHECK(nodes_.size() < 0xFFFFFFF0U, "graph is full");
  compared_.push_back(comparedBy(data));
  nodes_.push_back(data);
  facts_.push_back(facts);
  table_[at] = static_cast<std::uint32_t>(nodes_.size());
  return static_cast<Node>(nodes_.size() - 1);
}

Node Graph::constantNode(std::uint64_t value, int width) {
  return intern({Op::Constant, static_cast<std::uint8_t>(width), {noNode, noNode, noNode}, value & maskOf(width)});
}

Node Graph::variable(std::string name, int width, bool isState) {
  const Node node =
      intern({Op::Variable, static_cast<std::uint8_t>(width), {noNode, noNode, noNode}, variables_.size()});
  variables_.push_back({std::move(name), isState, node});
  return node;
}

bool Graph::widthsAgree(Op op, int width, Node a, Node b, Node c, std::uint64_t value) const {
  const auto w = [&](Node n) { return n == noNode ? 0 : widthOf(n); };
  if (width < 1 || width > 64) return false;
  switch (op) {
    case Op::Not: return w(a) == width;
    case Op::Equal:
    case Op::Ult:
    case Op::Ule:
    case Op::Slt:
    case Op::Sle: return w(a) == w(b) && width == 1;
    case Op::Ite: return w(a) == 1 && w(b) == width && w(c) == width;
    case Op::Concat: return w(a) + w(b) == width;
    case Op::Extract: return static_cast<int>(value) + width <= w(a);
    case Op::Zext:
    case Op::Sext: return w(a) <= width;
    case Op::RealAdd:
    case Op::RealSub:
    case Op::RealMul:
    case Op::RealDiv: return w(a) == 32 && w(b) == 32 && width == 32;
    case Op::RealEqual:
    case Op::RealLess: return w(a) == 32 && w(b) == 32 && width == 1;
    case Op::RealLegal: return w(a) == 32 && width == 1;
    case Op::RealFunction:
    case Op::RealFromInt: return w(a) == 32 && width == 32;
    case Op::RealToInt: return w(a) == 32 && width == 64;
    case Op::LongReal: return w(a) >= 32 && width >= 32;
    default: return w(a) == width && w(b) == width;
  }
}

Node Graph::make(Op op, int width, Node a, Node b, Node c, std::uint64_t value) {
  CHECK(widthsAgree(op, width, a, b, c, value), "operands of unequal width");
  if (isAsWritten_) return asWritten(op, width, a, b, c, value);
  if (depth_ == 0) work_ = workLimit;
  if (const auto folded = fold(op, width, a, b, c, value)) return constantNode(*folded, width);
  --work_;
  ++depth_;
  const Node result = simplify(op, width, a, b, c, value);
  --depth_;
  return result;
}

Node Graph::simplify(Op op, int width, Node a, Node b, Node c, std::uint64_t value) {
  const bool isTired = depth_ > depthLimit || work_ <= 0;
  const bool isCommutative =
      op == Op::And || op == Op::Or || op == Op::Xor || op == Op::Add || op == Op::Mul || op == Op::Equal;
  if (isCommutative && (isConstant(a) || (!isConstant(b) && indexOf(b) < indexOf(a)))) std::swap(a, b);
  switch (op) {
    case Op::Not: return makeNot(a);
    case Op::Or:
      if (width == 1) return makeOr(a, b);
      break;
    case Op::Ule: return makeNot(make(Op::Ult, 1, b, a));
    case Op::Sle: return makeNot(make(Op::Slt, 1, b, a));
    case Op::Equal:
      if (widthOf(a) == 1) return makeNot(make(Op::Xor, 1, a, b));
      break;
    case Op::Extract: {
      const int low = static_cast<int>(value);
      if (width == widthOf(a)) return a;
      if (!isTired) return makeExtract(a, low + width - 1, low);
      break;
    }
    case Op::Zext:
    case Op::Sext:
      if (width == widthOf(a)) return a;
      break;
    default: break;
  }
  if (!isTired) {
    switch (op) {
      case Op::And: return width == 1 ? makeAnd(a, b) : makeBitwise(op, width, a, b);
      case Op::Or: return makeBitwise(op, width, a, b);
      case Op::Xor: return width == 1 ? makeXor(a, b) : makeBitwise(op, width, a, b);
      case Op::Add: return makeAdd(width, a, b);
      case Op::Sub: return makeSub(width, a, b);
      case Op::Mul: return makeMul(width, a, b);
      case Op::Udiv:
      case Op::Urem:
      case Op::Sdiv:
      case Op::Srem: return makeDivision(op, width, a, b);
      case Op::Shl:
      case Op::Lshr: return makeShift(op, width, a, b);
      case Op::Equal: return makeEqual(a, b);
      case Op::Ult:
      case Op::Slt: return makeLess(op, a, b);
      case Op::Ite: return makeIte(width, a, b, c);
      case Op::Concat: return makeConcat(a, b);
      case Op::Zext: return makeZext(width, a);
      case Op::Sext: return makeSext(width, a);
      case Op::RealAdd:
      case Op::RealMul:
      case Op::RealEqual:
      case Op::RealLess:
      case Op::RealLegal: return makeReal(op, width, a, b, value);
      default: break;
    }
  }
  return intern({op, static_cast<std::uint8_t>(width), {a, b, c}, value});
}

/// Constants are computed, but a comparison of two stays: it is all that a program of constants has to say. Where a
/// constant condition leaves one part over, it is that part.
Node Graph::asWritten(Op op, int width, Node a, Node b, Node c, std::uint64_t value) {
  const bool isComparison = op == Op::Equal || (op >= Op::Ult && op <= Op::Sle);
  if (!isComparison) {
    if (const auto folded = fold(op, width, a, b, c, value)) return constantNode(*folded, width);
  }
  const bool isTruth = width == 1 && (op == Op::And || op == Op::Or);
  if (isTruth && (isConstant(a) || isConstant(b))) {
    if (!isConstant(a)) std::swap(a, b);
    return isZero(a) == (op == Op::And) ? a : b;
  }
  if (op == Op::Ite && isConstant(a)) return isZero(a) ? c : b;
  if ((op == Op::Extract || op == Op::Zext || op == Op::Sext) && width == widthOf(a)) return a;
  return intern({op, static_cast<std::uint8_t>(width), {a, b, c}, value});
}

std::optional<std::uint64_t> Graph::take(Decisions::Kind kind) const {
  if (decisions_->next == decisions_->made.size() || decisions_->made[decisions_->next].kind != kind)
    throw DecisionsDiverge{};
  return decisions_->made[decisions_->next++].answer;
}

std::optional<std::uint64_t> Graph::decide(Node n, const Bool* guard) const {
  const std::optional<std::uint64_t> own = isConstant(n) ? std::optional((*this)[n].value) : std::nullopt;
  if (decisions_ == nullptr) return own;
  if (!isAsWritten_) {
    return record(Decisions::Kind::Value, own);
  }
  const std::optional<std::uint64_t> answer = take(Decisions::Kind::Value);
  if (answer && own != answer) decided_.push_back({guard == nullptr ? noNode : guard->node, n, *answer});
  return answer;
}

Graph::Bool Graph::constant(bool v) { return {constantNode(v ? 1 : 0, 1)}; }
Graph::Bool Graph::lnot(Bool a) { return {make(Op::Not, 1, a.node)}; }
Graph::Bool Graph::land(Bool a, Bool b) { return {make(Op::And, 1, a.node, b.node)}; }
Graph::Bool Graph::lor(Bool a, Bool b) { return {make(Op::Or, 1, a.node, b.node)}; }
Graph::Bool Graph::lxor(Bool a, Bool b) { return {make(Op::Xor, 1, a.node, b.node)}; }
Graph::Bool Graph::select(Bool c, Bool a, Bool b) { return {make(Op::Ite, 1, c.node, a.node, b.node)}; }
std::optional<bool> Graph::truth(Bool a) const {
  const std::optional<std::uint64_t> value = decide(a.node, guard_);
  return value ? std::optional(*value != 0) : std::nullopt;
}
std::optional<bool> Graph::truthEverywhere(Bool a) const {
  const std::optional<std::uint64_t> value = decide(a.node, nullptr);
  return value ? std::optional(*value != 0) : std::nullopt;
}

Graph::Bits Graph::literal(std::uint64_t v, int w) { return {constantNode(v, w)}; }
std::optional<std::uint64_t> Graph::known(Bits a) const { return decide(a.node, guard_); }
Graph::Bits Graph::add(Bits a, Bits b, int w) { return {make(Op::Add, w, a.node, b.node)}; }
Graph::Bits Graph::sub(Bits a, Bits b, int w) { return {make(Op::Sub, w, a.node, b.node)}; }
Graph::Bits Graph::mul(Bits a, Bits b, int w) { return {make(Op::Mul, w, a.node, b.node)}; }
Graph::Bits Graph::udiv(Bits a, Bits b, int w) { return {make(Op::Udiv, w, a.node, b.node)}; }
Graph::Bits Graph::urem(Bits a, Bits b, int w) { return {make(Op::Urem, w, a.node, b.node)}; }
Graph::Bits Graph::sdiv(Bits a, Bits b, int w) { return {make(Op::Sdiv, w, a.node, b.node)}; }
Graph::Bits Graph::srem(Bits a, Bits b, int w) { return {make(Op::Srem, w, a.node, b.node)}; }
Graph::Bits Graph::band(Bits a, Bits b, int w) { return {make(Op::And, w, a.node, b.node)}; }
Graph::Bits Graph::bor(Bits a, Bits b, int w) { return {make(Op::Or, w, a.node, b.node)}; }
Graph::Bits Graph::bxor(Bits a, Bits b, int w) { return {make(Op::Xor, w, a.node, b.node)}; }
Graph::Bits Graph::bnot(Bits a, int w) { return {make(Op::Not, w, a.node)}; }
Graph::Bits Graph::shl(Bits a, Bits n, int w) { return {make(Op::Shl, w, a.node, n.node)}; }
Graph::Bits Graph::lshr(Bits a, Bits n, int w) { return {make(Op::Lshr, w, a.node, n.node)}; }
Graph::Bool Graph::equal(Bits a, Bits b, int) { return {make(Op::Equal, 1, a.node, b.node)}; }
Graph::Bool Graph::ult(Bits a, Bits b, int) { return {make(Op::Ult, 1, a.node, b.node)}; }
Graph::Bool Graph::ule(Bits a, Bits b, int) { return {make(Op::Ule, 1, a.node, b.node)}; }
Graph::Bool Graph::slt(Bits a, Bits b, int) { return {make(Op::Slt, 1, a.node, b.node)}; }
Graph::Bool Graph::sle(Bits a, Bits b, int) { return {make(Op::Sle, 1, a.node, b.node)}; }
Graph::Bits Graph::select(Bool c, Bits a, Bits b, int w) { return {make(Op::Ite, w, c.node, a.node, b.node)}; }
Graph::Bits Graph::zext(Bits a, int, int to) { return {make(Op::Zext, to, a.node)}; }
Graph::Bits Graph::sext(Bits a, int, int to) { return {make(Op::Sext, to, a.node)}; }
Graph::Bits Graph::extract(Bits a, int high, int low) {
  return {make(Op::Extract, high - low + 1, a.node, noNode, noNode, static_cast<std::uint64_t>(low))};
}
Graph::Bits Graph::concat(Bits high, int highWidth, Bits low, int lowWidth) {
  return {make(Op::Concat, highWidth + lowWidth, high.node, low.node)};
}
Graph::Bool Graph::bit(Bits a, int i) {
  return {make(Op::Extract, 1, a.node, noNode, noNode, static_cast<std::uint64_t>(i))};
}
Graph::Bits Graph::fromBool(Bool a, int w) { return {make(Op::Zext, w, a.node)}; }
Graph::Bits Graph::radd(Bits a, Bits b) { return {make(Op::RealAdd, 32, a.node, b.node)}; }
Graph::Bits Graph::rsub(Bits a, Bits b) { return {make(Op::RealSub, 32, a.node, b.node)}; }
Graph::Bits Graph::rmul(Bits a, Bits b) { return {make(Op::RealMul, 32, a.node, b.node)}; }
Graph::Bits Graph::rdiv(Bits a, Bits b) { return {make(Op::RealDiv, 32, a.node, b.node)}; }
Graph::Bits Graph::rfunction(std::uint64_t f, Bits a) {
  const Bits result{make(Op::RealFunction, 32, a.node, noNode, noNode, f)};
  if (static_cast<RealFunction>(f) == RealFunction::Sqrt) return result;  // has circuits
  // Checks of certificates know nothing of the function but its value where the argument is known.
  const std::optional<std::uint64_t> argument = known(a);
  if (!argument) return result;
  const std::uint64_t value = evaluateOperation(Op::RealFunction, 32, {32, 0}, {*argument, 0, 0}, f);
  return select(equal(a, literal(*argument, 32), 32), literal(value, 32), result, 32);
}
Graph::Bool Graph::requal(Bits a, Bits b) { return {make(Op::RealEqual, 1, a.node, b.node)}; }
Graph::Bool Graph::rless(Bits a, Bits b) { return {make(Op::RealLess, 1, a.node, b.node)}; }
Graph::Bool Graph::rlegal(Bits a) { return {make(Op::RealLegal, 1, a.node)}; }
Graph::Bits Graph::rfromInt(Bits a) { return {make(Op::RealFromInt, 32, a.node)}; }
Graph::Bits Graph::rtoInt(Bits a, bool round) {
  return {make(Op::RealToInt, 64, a.node, noNode, noNode, round ? 1 : 0)};
}

Graph::Bits Graph::longReal(std::uint64_t which, Bits a, Bits b, int width) {
  return {make(Op::LongReal, width, a.node, b.node, noNode, which)};
}

Graph::Bits Graph::external(const ExternalSite& site, int width) {
  CHECK(listener_ != nullptr, "an external value needs a listener");
  return listener_->external(site, width);
}
void Graph::report(Hazard hazard, Bool condition, const Instruction* place) {
  if (listener_ != nullptr) listener_->report(hazard, condition, place);
}
Graph::Bool Graph::targets(Machine<Graph>& machine, Bits pointer, Width width, Ref<Graph>& ref) {
  CHECK(listener_ != nullptr, "a pointer needs a listener");
  return listener_->targets(machine, pointer, width, ref);
}
std::optional<std::vector<std::uint64_t>> Graph::locations(Machine<Graph>& machine, Bits location) {
  CHECK(listener_ != nullptr, "a pointer needs a listener");
  return listener_->locations(machine, location);
}
std::optional<std::vector<std::uint64_t>> Graph::locationsInBlock(Machine<Graph>& machine, Bits location, Width width) {
  CHECK(listener_ != nullptr, "a pointer needs a listener");
  return listener_->locationsInBlock(machine, location, width);
}
Graph::Bits Graph::unresolved(Machine<Graph>& machine, int width) {
  CHECK(listener_ != nullptr, "an unresolved pointer needs a listener");
  return listener_->unresolved(machine, width);
}
void Graph::havoc(Machine<Graph>& machine) {
  CHECK(listener_ != nullptr, "an unresolved pointer needs a listener");
  listener_->havoc(machine);
}

static_assert(Domain<Graph>);

}  // namespace rungproof
