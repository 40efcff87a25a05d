// Graph: the domain of shared expression nodes. Running the scan once over it gives the next-state functions of
// the program as one hash-consed graph, from which solvers, exports, the cone of influence and fast simulation
// are fed. Nodes are bit vectors of width 1 to 64; width 1 serves as truth value.
//
// Construction folds constants and applies local identities (x & !x, ite with equal arms, extract of concat,
// concat of neighbouring extracts, (g & t) | (g & !t) -> g ...), so that what a guarded write leaves unchanged
// is the same node again. Real operations are nodes of their own: Z3 knows them, bit-level engines treat them
// as free inputs and say so.
//
// Normal form: Or of width 1 is a negated And; Ule and Sle are negated Ult and Slt; Concat with 0 is Zext;
// constants stand on the right of commutative operators.
// A graph made Rewriting::None keeps nodes as they are written: certificates and exports are about those, so that the
// rules above need not be believed. Only what a constant decides by itself is computed.
// Covered by tests/encoder/graph_test.cpp and tests/differential/domain_laws_test.cpp.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analysis/graph/decisions.hpp"
#include "ir/domain.hpp"
#include "ir/machine/machine.hpp"

namespace rungproof {

/// Index of a node in its Graph. Children have smaller indices than their parents, always.
enum class Node : std::uint32_t {};
constexpr std::uint32_t indexOf(Node n) { return static_cast<std::uint32_t>(n); }
inline constexpr Node noNode = static_cast<Node>(0xFFFFFFFF);

enum class Op : std::uint8_t {
  Constant,  ///< value
  Variable,  ///< state variable or input; value = its number in Graph::variables
  Not,
  And,
  Or,
  Xor,  // bitwise
  Add,
  Sub,
  Mul,
  Udiv,
  Urem,
  Sdiv,
  Srem,
  Shl,
  Lshr,
  Equal,
  Ult,
  Ule,
  Slt,
  Sle,      // width 1
  Ite,      // condition, then, else
  Concat,   // high, low
  Extract,  // value = lowest bit; width tells the highest
  Zext,
  Sext,
  RealAdd,
  RealSub,
  RealMul,
  RealDiv,
  RealFunction,  // RealFunction: value = which
  RealEqual,
  RealLess,
  RealLegal,
  RealFromInt,
  RealToInt,  // value = 1: round; width 64
  LongReal    // value = LongRealOperation
};

struct NodeData {
  Op op;
  std::uint8_t width;
  std::array<Node, 3> child;
  std::uint64_t value;
};

/// What a variable stands for.
struct Variable {
  std::string name;  ///< "V10.3", "T37.value", "I0.0", "dt"
  bool isState = false;
  Node node = noNode;
};

enum class Rewriting : bool { None, Full };

class Graph {
 public:
  explicit Graph(Rewriting rewriting = Rewriting::Full) : isAsWritten_(rewriting == Rewriting::None) {}

  /// Distinct types keep truth values and vectors apart in instruction meanings; both are nodes.
  struct Bool {
    Node node = noNode;
  };
  struct Bits {
    Node node = noNode;
  };
  using Targets = std::vector<PointerTarget<Graph>>;
  class Store;  // analysis/encoding/symbolic_store.hpp

  /// The highest value of a width.
  static constexpr std::uint64_t maskOf(int width) { return width >= 64 ? ~0ULL : (1ULL << width) - 1; }

  /// What all values of a node satisfy: bits that are always 0 or 1 (above the width: 0), and unsigned bounds.
  struct Facts {
    std::uint64_t zeros, ones, low, high;
    friend bool operator==(const Facts&, const Facts&) = default;
  };
  static constexpr Facts anyValue(int width) { return {~maskOf(width), 0, 0, maskOf(width)}; }
  static constexpr Facts exactly(std::uint64_t value) { return {~value, value, value, value}; }
  /// What follows for the result of an operation (NodeData's fields) from what is known of its operands.
  static Facts combine(Op op, int width, std::uint64_t value, std::array<int, 2> childWidth,
                       const std::array<Facts, 3>& operand);

  const NodeData& operator[](Node n) const { return nodes_[indexOf(n)]; }
  std::size_t size() const { return nodes_.size(); }
  const std::vector<Variable>& variables() const { return variables_; }
  Node variable(std::string name, int width, bool isState);
  /// Unsigned bounds that every value of the node keeps.
  std::uint64_t lowest(Node n) const { return facts_[indexOf(n)].low; }
  std::uint64_t highest(Node n) const { return facts_[indexOf(n)].high; }
  Node constantNode(std::uint64_t value, int width);
  /// The one constructor: simplifies, then looks the node up or adds it.
  Node make(Op op, int width, Node a, Node b = noNode, Node c = noNode, std::uint64_t value = 0);

  /// Answers of truth(), known() and listed() are recorded there, or with Rewriting::None taken from there; nullptr
  /// ends that. Throws DecisionsDiverge where they do not fit.
  void decideBy(Decisions* decisions) { decisions_ = decisions; }
  /// A node that equals `n` wherever `guard` (width 1) holds; simpler if the guard decides conditions in n.
  Node given(Node n, Node guard);

  // ---- Domain interface (ir/domain.hpp); laws there ----------------------------------------------
  Bool constant(bool v);
  Bool lnot(Bool a);
  Bool land(Bool a, Bool b);
  Bool lor(Bool a, Bool b);
  Bool lxor(Bool a, Bool b);
  Bool select(Bool c, Bool a, Bool b);
  /// Whether two conditions are one node; different nodes may still mean the same.
  bool isSame(Bool a, Bool b) const { return a.node == b.node; }
  std::optional<bool> truth(Bool a) const;
  /// The same for who relies on the answer outside the guard as well.
  std::optional<bool> truthEverywhere(Bool a) const;
  Bits literal(std::uint64_t v, int w);
  std::optional<std::uint64_t> known(Bits a) const;
  Bits add(Bits a, Bits b, int w);
  Bits sub(Bits a, Bits b, int w);
  Bits mul(Bits a, Bits b, int w);
  Bits udiv(Bits a, Bits b, int w);
  Bits urem(Bits a, Bits b, int w);
  Bits sdiv(Bits a, Bits b, int w);
  Bits srem(Bits a, Bits b, int w);
  Bits band(Bits a, Bits b, int w);
  Bits bor(Bits a, Bits b, int w);
  Bits bxor(Bits a, Bits b, int w);
  Bits bnot(Bits a, int w);
  Bits shl(Bits a, Bits n, int w);
  Bits lshr(Bits a, Bits n, int w);
  Bool equal(Bits a, Bits b, int w);
  Bool ult(Bits a, Bits b, int w);
  Bool ule(Bits a, Bits b, int w);
  Bool slt(Bits a, Bits b, int w);
  Bool sle(Bits a, Bits b, int w);
  Bits select(Bool c, Bits a, Bits b, int w);
  Bits zext(Bits a, int from, int to);
  Bits sext(Bits a, int from, int to);
  Bits extract(Bits a, int high, int low);
  Bits concat(Bits high, int highWidth, Bits low, int lowWidth);
  Bool bit(Bits a, int i);
  Bits fromBool(Bool a, int w);
  Bits radd(Bits a, Bits b);
  Bits rsub(Bits a, Bits b);
  Bits rmul(Bits a, Bits b);
  Bits rdiv(Bits a, Bits b);
  Bits rfunction(std::uint64_t f, Bits a);
  Bool requal(Bits a, Bits b);
  Bool rless(Bits a, Bits b);
  Bool rlegal(Bits a);
  Bits rfromInt(Bits a);
  Bits rtoInt(Bits a, bool round);
  Bits longReal(std::uint64_t which, Bits a, Bits b, int width);
  Bits longReal(std::uint64_t which, Bits a, int width) { return longReal(which, a, {}, width); }

  /// The list that `find` gives, or nothing: recorded, or taken from the decisions instead.
  template <class Find>
  std::optional<std::vector<std::uint64_t>> listed(Find&& find);
  bool isAsWritten() const { return isAsWritten_; }
  /// A node that was said to have a value by decisions that this graph follows, and is not that constant: where `guard`
  /// holds (noNode: everywhere).
  struct Decided {
    Node guard;
    Node node;
    std::uint64_t value;
  };
  const std::vector<Decided>& decided() const { return decided_; }
  /// What holds where a decision is asked for: values that are read under it matter only there. nullptr: nothing.
  void decideUnder(const Bool* guard) { guard_ = guard; }

  // ---- What the machine asks for beyond values ------------------------------------------------------
  /// A fresh input for the site; the encoder remembers which (analysis/encoding/encoder.hpp).
  Bits external(const ExternalSite& site, int width);
  void report(Hazard hazard, Bool condition, const Instruction* place);
  /// Fills ref with the possible targets of a pointer, from the value analysis; gives the legality condition.
  Bool targets(Machine<Graph>& machine, Bits pointer, Width width, Ref<Graph>& ref);
  /// All values that a place's number can have here, from the value analysis; nothing if they are too many.
  std::optional<std::vector<std::uint64_t>> locations(Machine<Graph>& machine, Bits location);
  /// All places in the one data block that the place's number can lie in, for accesses of that width; nothing if it may
  /// lie elsewhere or they are too many. Any other number leads beyond the block.
  std::optional<std::vector<std::uint64_t>> locationsInBlock(Machine<Graph>& machine, Bits location, Width width);
  Bits unresolved(Machine<Graph>& machine, int width);
  void havoc(Machine<Graph>& machine);

  /// Receives externals, hazards and pointer questions while a scan is encoded.
  class Listener {
   public:
    virtual ~Listener() = default;
    virtual Bits external(const ExternalSite& site, int width) = 0;
    virtual void report(Hazard hazard, Bool condition, const Instruction* place) = 0;
    virtual Bool targets(Machine<Graph>& machine, Bits pointer, Width width, Ref<Graph>& ref) = 0;
    virtual std::optional<std::vector<std::uint64_t>> locations(Machine<Graph>& machine, Bits location) = 0;
    virtual std::optional<std::vector<std::uint64_t>> locationsInBlock(Machine<Graph>& machine, Bits location,
                                                                       Width width) = 0;
    virtual Bits unresolved(Machine<Graph>& machine, int width) = 0;
    virtual void havoc(Machine<Graph>& machine) = 0;
    virtual void signalled(Signal, std::uint32_t /*index*/, Bool /*guard*/) {}
  };
  void signal(Signal which, std::uint32_t index, Bool guard) {
    if (listener_ != nullptr) listener_->signalled(which, index, guard);
  }
  void listen(Listener* listener) { listener_ = listener; }

 private:
  /// Truth values under an assumption; see graph_boolean.cpp.
  enum class Truth : std::uint8_t { False, True, Open };
  static constexpr std::size_t conjunctLimit = 12;
  static constexpr int workLimit = 400;  ///< rewriting steps of one make()
  struct Conjuncts {
    std::array<Node, conjunctLimit> item;
    std::size_t count = 0;
    std::span<const Node> all() const { return {item.data(), count}; }
  };

  // graph.cpp
  std::optional<std::uint64_t> decide(Node n, const Bool* guard) const;
  std::optional<std::uint64_t> record(Decisions::Kind kind, std::optional<std::uint64_t> answer) const {
    return decisions_->record(kind, answer);
  }
  std::optional<std::uint64_t> take(Decisions::Kind kind) const;
  Node asWritten(Op op, int width, Node a, Node b, Node c, std::uint64_t value);
  Node intern(const NodeData& data);
  Node simplify(Op op, int width, Node a, Node b, Node c, std::uint64_t value);
  void growTable();
  bool widthsAgree(Op op, int width, Node a, Node b, Node c, std::uint64_t value) const;
  bool isConstant(Node n) const { return (*this)[n].op == Op::Constant; }
  bool isConstant(Node n, std::uint64_t value) const { return isConstant(n) && (*this)[n].value == value; }
  bool isZero(Node n) const { return isConstant(n, 0); }
  bool isOnes(Node n) const;
  bool is(Node n, Op op) const { return (*this)[n].op == op; }
  int widthOf(Node n) const { return (*this)[n].width; }
  Node child(Node n, int i) const { return (*this)[n].child[static_cast<std::size_t>(i)]; }

  // graph_facts.cpp
  Facts factsOf(const NodeData& data) const;
  Node comparedBy(const NodeData& data) const;
  std::optional<std::uint64_t> fold(Op op, int width, Node a, Node b, Node c, std::uint64_t value) const;

  // graph_boolean.cpp
  Node makeNot(Node a);
  Node makeAnd(Node a, Node b);
  Node makeXor(Node a, Node b);
  Node makeOr(Node a, Node b) { return makeNot(makeAnd(makeNot(a), makeNot(b))); }
  Node joinNegated(Node a, Node b);
  Conjuncts conjunctsOf(Node a) const;
  Truth under(Node condition, std::span<const Node> assumed) const;
  Truth underOne(Node condition, Node assumed) const;
  Truth underFalse(Node condition, Node refuted) const;
  Node makeIte(int width, Node c, Node a, Node b);
  Node makeIteBool(Node c, Node a, Node b);
  Node follow(Node arm, Node c, bool value) const;
  Node reduce(Node n, std::span<const Node> known, int& budget);
  Node reduced(Node n, std::span<const Node> known);

  // graph_words.cpp
  Node makeBitwise(Op op, int width, Node a, Node b);
  Node makeAdd(int width, Node a, Node b);
  Node makeSub(int width, Node a, Node b);
  Node makeMul(int width, Node a, Node b);
  Node makeDivision(Op op, int width, Node a, Node b);
  Node makeShift(Op op, int width, Node a, Node b);
  Node makeReal(Op op, int width, Node a, Node b, std::uint64_t value);

  // graph_compare.cpp
  Node makeEqual(Node a, Node b);
  Node equalToConstant(Node a, std::uint64_t value);
  Node makeLess(Op op, Node a, Node b);
  Node withoutOverflow(Node a, Node b);

  // graph_slices.cpp
  Node makeExtract(Node a, int high, int low);
  bool isCheapSlice(Node a, int high, int low, int depth) const;
  Node makeConcat(Node a, Node b);
  Node joined(Node a, Node b);
  Node makeZext(int width, Node a);
  Node makeSext(int width, Node a);

  std::vector<NodeData> nodes_;
  std::vector<Facts> facts_;
  std::vector<Node> compared_;  ///< what the node compares with a constant, negated or not; noNode: nothing
  std::vector<Variable> variables_;
  std::vector<std::uint32_t> table_;  ///< open addressing: node index + 1, 0 free
  int depth_ = 0;                     ///< of nested rewriting; beyond a limit nodes are made as they are
  int work_ = 0;                      ///< rewriting steps left in the outermost make()
  Listener* listener_ = nullptr;
  bool isAsWritten_ = false;
  Decisions* decisions_ = nullptr;
  const Bool* guard_ = nullptr;
  mutable std::vector<Decided> decided_;
};

template <class Find>
std::optional<std::vector<std::uint64_t>> Graph::listed(Find&& find) {
  if (decisions_ == nullptr || !isAsWritten_) {
    std::optional<std::vector<std::uint64_t>> found = find();
    if (decisions_ == nullptr) return found;
    const std::optional<std::uint64_t> size = found ? std::optional<std::uint64_t>(found->size()) : std::nullopt;
    if (const auto told = record(Decisions::Kind::Targets, size); told && found) found->resize(*told);
    for (std::size_t i = 0; found && i < found->size(); ++i) record(Decisions::Kind::Target, (*found)[i]);
    return found;
  }
  const std::optional<std::uint64_t> count = take(Decisions::Kind::Targets);
  if (!count) return std::nullopt;
  std::vector<std::uint64_t> list;
  for (std::uint64_t i = 0; i < *count; ++i) list.push_back(take(Decisions::Kind::Target).value_or(0));
  return list;
}

}  // namespace rungproof
