// Graph: the domain of shared expression nodes. Running the scan once over it gives the next-state functions of
// the program as one hash-consed graph, from which solvers, exports, the cone of influence and fast simulation
// are fed. Nodes are bit vectors of width 1 to 64; width 1 serves as truth value.
//
// Construction folds constants and applies local identities (x & !x, ite with equal arms, extract of concat,
// concat of neighbouring extracts, (g & t) | (g & !t) -> g ...), so that what a guarded write leaves unchanged
// is the same node again. Real operations are nodes of their own: Z3 knows them, bit-level engines treat them
// as free inputs and say so.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "ir/domain.hpp"
#include "ir/machine.hpp"

namespace rungproof {

/// Index of a node in its Graph. Children have smaller indices than their parents, always.
enum class Node : std::uint32_t {};
constexpr std::uint32_t indexOf(Node n) { return static_cast<std::uint32_t>(n); }
inline constexpr Node noNode = static_cast<Node>(0xFFFFFFFF);

enum class Op : std::uint8_t {
  Constant,   ///< value
  Variable,   ///< state variable or input; value = its number in Graph::variables
  Not, And, Or, Xor,                          // bitwise
  Add, Sub, Mul, Udiv, Urem, Sdiv, Srem, Shl, Lshr,
  Equal, Ult, Ule, Slt, Sle,                  // width 1
  Ite,                                        // condition, then, else
  Concat,                                     // high, low
  Extract,                                    // value = lowest bit; width tells the highest
  Zext, Sext,
  RealAdd, RealSub, RealMul, RealDiv, RealFunction,  // RealFunction: value = which
  RealEqual, RealLess, RealLegal, RealFromInt,
  RealToInt                                   // value = 1: round; width 64
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

class Graph {
 public:
  /// Distinct types keep truth values and vectors apart in instruction meanings; both are nodes.
  struct Bool { Node node = noNode; };
  struct Bits { Node node = noNode; };
  using Targets = std::vector<PointerTarget<Graph>>;
  class Store;  // analysis/symbolic_store.hpp

  const NodeData& operator[](Node n) const { return nodes_[indexOf(n)]; }
  std::size_t size() const { return nodes_.size(); }
  const std::vector<Variable>& variables() const { return variables_; }
  Node variable(std::string name, int width, bool isState);
  Node constantNode(std::uint64_t value, int width);
  /// The one constructor: simplifies, then looks the node up or adds it.
  Node make(Op op, int width, Node a, Node b = noNode, Node c = noNode, std::uint64_t value = 0);

  // ---- Domain interface (ir/domain.hpp); laws there ----------------------------------------------
  Bool constant(bool v);
  Bool lnot(Bool a);
  Bool land(Bool a, Bool b);
  Bool lor(Bool a, Bool b);
  Bool lxor(Bool a, Bool b);
  Bool select(Bool c, Bool a, Bool b);
  std::optional<bool> truth(Bool a) const;
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

  // ---- What the machine asks for beyond values ------------------------------------------------------
  /// A fresh input for the site; the encoder remembers which (analysis/encoder.hpp).
  Bits external(const ExternalSite& site, int width);
  void report(Hazard hazard, Bool condition, const Instruction* place);
  /// Fills ref with the possible targets of a pointer, from the value analysis; gives the legality condition.
  Bool targets(Machine<Graph>& machine, Bits pointer, Width width, Ref<Graph>& ref);
  Bits unresolved(Machine<Graph>& machine, int width);
  void havoc(Machine<Graph>& machine);

  /// Receives externals, hazards and pointer questions while a scan is encoded.
  class Listener {
   public:
    virtual ~Listener() = default;
    virtual Bits external(const ExternalSite& site, int width) = 0;
    virtual void report(Hazard hazard, Bool condition, const Instruction* place) = 0;
    virtual Bool targets(Machine<Graph>& machine, Bits pointer, Width width, Ref<Graph>& ref) = 0;
    virtual Bits unresolved(Machine<Graph>& machine, int width) = 0;
    virtual void havoc(Machine<Graph>& machine) = 0;
  };
  void listen(Listener* listener) { listener_ = listener; }

 private:
  struct Key {
    NodeData data;
    bool operator==(const Key& other) const;
  };
  struct KeyHash {
    std::size_t operator()(const Key& key) const;
  };
  Node intern(const NodeData& data);
  Node simplify(Op op, int width, Node a, Node b, Node c, std::uint64_t value);

  std::vector<NodeData> nodes_;
  std::vector<Variable> variables_;
  std::unordered_map<Key, Node, KeyHash> index_;
  Listener* listener_ = nullptr;
};

}  // namespace rungproof
