// Every node continues the circuit of one input, its parent: the only one, the first of a gate or box, or for an OR
// whose branches all begin at one shared node that node (then the OR is a block in series with it: LD, O, ALD). Nodes
// without a parent begin a circuit. A circuit ends in coils and boxes, or in one value that another circuit takes in
// as a further input; it is then written in place there. All loops are without recursion: drawings may be deep.
#include "analysis/drawing/branches.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

#include "analysis/drawing/code.hpp"

namespace rungproof {

namespace {

constexpr std::uint32_t levels = 9;  // of the logic stack, 001:2759
constexpr std::uint32_t noBranchNode = railNode;

/// Where the chain of contacts that ends in a node begins: the shared node (or the rail) and the first node behind it.
struct Chain {
  bool isPure = false;
  std::uint32_t source = railNode;
  std::uint32_t head = noBranchNode;
};

class Writer {
 public:
  Writer(const Drawing& drawing, const Circuit& circuit, PinOrder order, EditorBits taken)
      : drawing_(drawing),
        nodes_(circuit.nodes),
        order_(order),
        code_(circuit, drawing.elements.size(), taken),
        reads_(circuit) {}

  Branches run() {
    Branches result;
    if (!nodes_.empty()) write();
    result.circuits = static_cast<std::uint32_t>(tops_.size());
    if (tops_.size() > 1) result.second = elementOf(tops_[1]);
    result.lowered = code_.take();
    result.comparedAddresses = reads_.comparedAddresses();
    result.lowered.fault = fault_;
    if (fault_) result.lowered.instructions.clear();
    return result;
  }

 private:
  // ---- Which node continues which -------------------------------------------------------------------

  void write() {
    findParents();
    if (!fault_) findCircuits();
    if (!fault_) collectKids();
    for (std::size_t i = 0; i < tops_.size() && !fault_; ++i) emit(tops_[i]);
    if (!fault_ && written_.size() != nodes_.size()) refuse(0, "its circuits take in each other");
    if (!fault_) checkOrder();
  }

  void refuse(std::uint32_t n, std::string_view message) {
    if (fault_) return;
    const std::uint32_t element = elementOf(n);
    fault_ = LoweringFault{element, fmt::format("{}: {}", nameOf(drawing_.elements[element]), message)};
  }
  /// Of a negation circle: the element that it stands at, which follows it.
  std::uint32_t elementOf(std::uint32_t n) const {
    while (n + 1 < nodes_.size() && nodes_[n].element == noElement) ++n;
    return nodes_[n].element == noElement ? 0 : nodes_[n].element;
  }

  void findParents() {
    const std::size_t count = nodes_.size();
    parent_.assign(count, railNode);
    isBlock_.assign(count, 0);
    isBlockHead_.assign(count, 0);
    chains_.assign(count, {});
    firstPin_.assign(count, 0);
    for (std::uint32_t n = 0; n < count; ++n) {
      const CircuitNode& node = nodes_[n];
      if (node.shape == Shape::Or && joinsBlock(n)) continue;
      if (node.inputs.empty()) continue;
      firstPin_[n] = pinOf(n);
      const std::uint32_t from = node.inputs[firstPin_[n]];
      parent_[n] = from;
      if (node.isContact()) chains_[n] = from == railNode ? Chain{true, railNode, n} : chainBehind(from, n, 1);
    }
  }
  /// The chain of a contact or block behind `from`, which makes `uses` of the uses of `from`.
  Chain chainBehind(std::uint32_t from, std::uint32_t n, std::size_t uses) const {
    if (nodes_[from].uses.size() == uses && chains_[from].isPure) return chains_[from];
    return {true, from, n};
  }
  std::uint32_t pinOf(std::uint32_t n) const {
    const CircuitNode& node = nodes_[n];
    if (order_ == PinOrder::AsDrawn || !node.isGate()) return 0;
    for (std::uint32_t pin = 0; pin < node.inputs.size(); ++pin) {
      if (node.inputs[pin] != railNode && nodes_[node.inputs[pin]].uses.size() > 1) return pin;
    }
    return 0;
  }

  /// An OR whose branches are chains of contacts from one shared node, each used nowhere else.
  bool joinsBlock(std::uint32_t n) {
    const CircuitNode& node = nodes_[n];
    std::uint32_t source = railNode;
    for (const std::uint32_t from : node.inputs) {
      if (from == railNode || nodes_[from].uses.size() != 1 || !chains_[from].isPure) return false;
      if (chains_[from].source == railNode) return false;
      if (source != railNode && chains_[from].source != source) return false;
      source = chains_[from].source;
    }
    for (const std::uint32_t from : node.inputs) {
      const std::uint32_t head = chains_[from].head;
      if (isBlock_[head] != 0) {  // a block on the same node: inside this one it begins the branch itself
        isBlock_[head] = 0;
        parent_[head] = nodes_[head].inputs[0];
        heads_[n] += heads_[head];
        continue;
      }
      parent_[head] = railNode;
      isBlockHead_[head] = 1;
      ++heads_[n];
    }
    isBlock_[n] = 1;
    parent_[n] = source;
    chains_[n] = chainBehind(source, n, heads_[n]);
    return true;
  }

  void findCircuits() {
    const std::size_t count = nodes_.size();
    root_.resize(count);
    exit_.assign(count, noBranchNode);
    for (std::uint32_t n = 0; n < count; ++n) root_[n] = parent_[n] == railNode ? n : root_[parent_[n]];
    for (std::uint32_t n = 0; n < count && !fault_; ++n) {
      const CircuitNode& node = nodes_[n];
      for (std::uint32_t pin = 0; pin < node.inputs.size(); ++pin) {
        const std::uint32_t from = node.inputs[pin];
        if (from == railNode || isParentPin(n, pin)) continue;
        std::uint32_t& exit = exit_[root_[from]];
        if (root_[from] == root_[n])
          return refuse(from, "branches behind it meet again as no drawing of stack instructions can");
        if (exit != noBranchNode) return refuse(from, "two circuits take in its circuit");
        exit = from;
      }
    }
    for (std::uint32_t n = 0; n < count; ++n) {
      if (root_[n] == n && exit_[n] == noBranchNode) tops_.push_back(n);
    }
  }
  bool isParentPin(std::uint32_t n, std::uint32_t pin) const {
    if (isBlock_[n] != 0 || (isBlockHead_[n] != 0 && parent_[n] == railNode)) return isBlockHead_[n] != 0 && pin == 0;
    return pin == firstPin_[n];
  }

  /// Children of each node in the order of the first coil or box behind them; the value that leaves comes last.
  void collectKids() {
    const std::uint32_t count = static_cast<std::uint32_t>(nodes_.size());
    std::vector<std::uint32_t> firstEffect(count, noBranchNode - 1);
    for (std::uint32_t n = count; n-- > 0;) {
      if (nodes_[n].isEffect()) firstEffect[n] = n;
      if (parent_[n] != railNode) firstEffect[parent_[n]] = std::min(firstEffect[parent_[n]], firstEffect[n]);
    }
    // The branch that ends in the value which leaves must come last: it is on the top then.
    for (std::uint32_t root = 0; root < count; ++root) {
      if (root_[root] != root || exit_[root] == noBranchNode) continue;
      for (std::uint32_t n = exit_[root]; n != railNode; n = parent_[n]) firstEffect[n] = noBranchNode;
    }
    firstKid_.assign(count + 1, 0);
    for (std::uint32_t n = 0; n < count; ++n) {
      if (parent_[n] != railNode) ++firstKid_[parent_[n] + 1];
      if (root_[n] == n && exit_[n] != noBranchNode) ++firstKid_[exit_[n] + 1];
    }
    for (std::uint32_t n = 0; n < count; ++n) firstKid_[n + 1] += firstKid_[n];
    kids_.assign(firstKid_[count], noBranchNode);
    std::vector<std::uint32_t> next(firstKid_.begin(), firstKid_.end() - 1);
    for (std::uint32_t n = 0; n < count; ++n) {
      if (parent_[n] != railNode) kids_[next[parent_[n]]++] = n;
    }
    for (std::uint32_t n = 0; n < count; ++n) {
      const auto begin = kids_.begin() + firstKid_[n], end = kids_.begin() + next[n];
      std::stable_sort(begin, end, [&](std::uint32_t a, std::uint32_t b) { return firstEffect[a] < firstEffect[b]; });
    }
    std::stable_sort(tops_.begin(), tops_.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return firstEffect[a] < firstEffect[b]; });
  }

  // ---- Writing --------------------------------------------------------------------------------------

  enum class Stage : std::uint8_t { Begin, Pins, Join, Kids };
  struct Frame {
    std::uint32_t node = noBranchNode;
    Stage stage = Stage::Begin;
    std::uint32_t at = 0;     ///< pin, or child
    bool isSaved = false;     ///< LPS holds the value for further children
    bool isChanged = false;   ///< the top is not the value any more
    std::uint32_t below = 0;  ///< needed levels below the value when it was reached
    std::vector<unsigned> bits;
  };

  void emit(std::uint32_t top) {
    visit(top);
    below_ = 0;
    while (!frames_.empty() && !fault_) {
      switch (frames_.back().stage) {
        case Stage::Begin: begin(frames_.back()); break;
        case Stage::Pins: pins(frames_.back()); break;
        case Stage::Join: join(frames_.back()); break;
        case Stage::Kids: kids(frames_.back()); break;
      }
    }
  }

  void visit(std::uint32_t n) { frames_.emplace_back().node = n; }
  void load(std::uint32_t n) {
    code_.contact(n, Role::Load);
    checkDepth(n);
  }
  void loadPower(std::uint32_t n) {
    code_.power(Role::Load, nodes_[n].span);
    checkDepth(n);
  }
  void checkDepth(std::uint32_t n) {
    if (below_ >= levels) refuse(n, "more than nine levels of the logic stack would be needed");
  }
  bool isRoot(std::uint32_t n) const { return parent_[n] == railNode; }

  void begin(Frame& frame) {
    const std::uint32_t n = frame.node;
    const CircuitNode& node = nodes_[n];
    frame.below = below_;
    if (node.isContact()) {
      written_.push_back(n);
      if (isRoot(n))
        load(n);
      else
        code_.contact(n, Role::And);
      frame.stage = Stage::Kids;
      return;
    }
    if (isRoot(n) && !node.inputs.empty()) loadPower(n);
    if (node.isTransform() || node.inputs.size() <= 1) {
      written_.push_back(n);
      code_.instruction(n);
      return behind(frame);
    }
    if (isBlock_[n] != 0) {
      ++below_;
      frame.stage = Stage::Pins;
      return;
    }
    if (flowParameters(node) > 0 && !storePin(frame)) return;
    frame.stage = Stage::Pins;
  }

  /// Takes in the inputs that are not the parent, one after the other.
  void pins(Frame& frame) {
    const CircuitNode& node = nodes_[frame.node];
    if (frame.at == node.inputs.size()) return complete(frame);
    const std::uint32_t pin = frame.at, from = node.inputs[pin];
    const bool isFirstOfBlock = isBlock_[frame.node] != 0 && pin == 0;
    if (isBlock_[frame.node] == 0 && pin == firstPin_[frame.node]) {
      ++frame.at;
      return;
    }
    if (node.isGate() && !isFirstOfBlock) {
      if (from == railNode) {
        if (node.shape == Shape::Or) code_.power(Role::Or, node.span);
        ++frame.at;
        return;
      }
      if (isSingleContact(from)) {
        written_.push_back(from);
        code_.contact(from, node.shape == Shape::And ? Role::And : Role::Or);
        code_.mark(frame.node);
        ++frame.at;
        return;
      }
    }
    frame.stage = Stage::Join;
    if (!isFirstOfBlock && flowParameters(node) == 0) ++below_;
    if (from == railNode) return loadPower(frame.node);
    visit(root_[from]);
  }
  bool isSingleContact(std::uint32_t n) const {
    return nodes_[n].isContact() && isRoot(n) && nodes_[n].uses.size() == 1;
  }

  void join(Frame& frame) {
    const std::uint32_t n = frame.node;
    const CircuitNode& node = nodes_[n];
    const bool isFirstOfBlock = isBlock_[n] != 0 && frame.at == 0;
    if (node.isGate() && !isFirstOfBlock) {
      code_.operation(node.shape == Shape::And ? Role::Ald : Role::Old, n);
      code_.mark(n);
      --below_;
    }
    if (flowParameters(node) > 0 && !storePin(frame)) return;
    ++frame.at;
    frame.stage = Stage::Pins;
  }

  /// EN and flow inputs of CALL go to L60.0 and L63.7, L63.6, ... (001:6809).
  bool storePin(Frame& frame) {
    const std::optional<unsigned> bit = frame.bits.empty() ? code_.pool().takeLowest() : code_.pool().takeHighest();
    if (!bit) refuse(frame.node, "no bit in L60.0 to L63.7 is free for its inputs");
    if (!bit) return false;
    code_.store(*bit, frame.node);
    frame.bits.push_back(*bit);
    return true;
  }

  /// All inputs are on the stack: the gate is joined, the box is executed.
  void complete(Frame& frame) {
    const std::uint32_t n = frame.node;
    const CircuitNode& node = nodes_[n];
    written_.push_back(n);
    below_ = frame.below;
    if (isBlock_[n] != 0) {
      code_.operation(Role::Ald, n);
      code_.mark(n);
    } else if (!frame.bits.empty()) {
      code_.recall(frame.bits[0], Role::Load, n);
      code_.call(n, {frame.bits.begin() + 1, frame.bits.end()});
      for (const unsigned bit : frame.bits) code_.pool().give(bit);
    } else if (!node.isGate()) {
      code_.instruction(n);
    }
    behind(frame);
  }

  /// After the instruction: the output of a box comes to the top.
  void behind(Frame& frame) {
    const std::uint32_t n = frame.node;
    const CircuitNode& node = nodes_[n];
    frame.at = 0;
    frame.stage = Stage::Kids;
    if (node.shape != Shape::Box) return;
    if (leavesLevels(n) && below_ > 0) return refuse(n, "it changes the logic stack, so no other branch can follow it");
    if (node.uses.empty()) return;
    if (isIecBox(node)) {
      if (!code_.iecOutput(n)) refuse(n, "no bit in L60.0 to L63.7 is free for its output");
    } else if (node.desc->eno) {
      code_.operation(Role::Aeno, n);
    }
  }
  bool leavesLevels(std::uint32_t n) const {
    const CircuitNode& node = nodes_[n];
    if (node.shape != Shape::Box) return false;
    if (isIecBox(node) && !node.uses.empty()) return true;
    if (node.desc->control == Control::For) return true;  // each round begins with what NEXT leaves (001:5770)
    return flowParameters(node) > 0 || node.desc->stack.needs > node.desc->stack.pops + 1;
  }
  /// The top is another value after the child.
  bool changesTop(std::uint32_t kid) const {
    if (kid == noBranchNode) return false;
    const CircuitNode& node = nodes_[kid];
    if (node.shape == Shape::Coil) return false;
    if (node.shape != Shape::Box) return true;
    // FOR leaves the top as it was: 1 in every round that runs.
    const bool isLoop = node.desc->control == Control::For;
    return !node.uses.empty() || node.desc->stack.needs > 1 || (leavesLevels(kid) && !isLoop);
  }

  void kids(Frame& frame) {
    const std::uint32_t first = firstKid_[frame.node], count = firstKid_[frame.node + 1] - first;
    if (frame.at == count) {
      frames_.pop_back();
      return;
    }
    const std::uint32_t kid = kids_[first + frame.at];
    const bool isLast = frame.at + 1 == count;
    if (frame.isChanged) {
      const auto rest = kids_.begin() + first;
      const bool isNeededAgain =
          std::any_of(rest + frame.at, rest + count - 1, [&](std::uint32_t other) { return changesTop(other); });
      code_.operation(isNeededAgain ? Role::Lrd : Role::Lpp, frame.node);
      frame.isSaved = isNeededAgain;
      below_ = frame.below + (frame.isSaved ? 1 : 0);
    }
    frame.isChanged = changesTop(kid);
    if (frame.isChanged && !isLast && !frame.isSaved) {
      code_.operation(Role::Lps, frame.node);
      frame.isSaved = true;
      below_ = frame.below + 1;
      checkDepth(frame.node);
    }
    ++frame.at;
    if (kid != noBranchNode) visit(kid);
  }

  // ---- Order ----------------------------------------------------------------------------------------

  void checkOrder() {
    std::uint32_t place = 0;
    for (const std::uint32_t n : written_) {
      if (reads_.isFixed(n)) {
        if (reads_.fixed()[place] != n)
          return refuse(n, "its branch is executed in another order than the picture would be");
        ++place;
      } else if (!nodes_[n].isGate() && !reads_.mayMove(n, reads_.placeOf(n), place)) {
        return refuse(n, "its branch is executed in another order than the picture would be");
      }
    }
  }

  const Drawing& drawing_;
  const std::vector<CircuitNode>& nodes_;
  PinOrder order_;
  CircuitCode code_;
  ReadOrder reads_;
  std::vector<std::uint32_t> parent_;      ///< railNode: begins a circuit
  std::vector<std::uint8_t> isBlock_;      ///< OR in series with its parent
  std::vector<std::uint8_t> isBlockHead_;  ///< begins a branch of a block
  std::vector<Chain> chains_;
  std::unordered_map<std::uint32_t, std::size_t> heads_;  ///< by block: branches that begin at its source
  std::vector<std::uint32_t> firstPin_;                   ///< pin of the parent
  std::vector<std::uint32_t> root_;
  std::vector<std::uint32_t> exit_;  ///< by root: the value that another circuit takes in
  std::vector<std::uint32_t> tops_;
  std::vector<std::uint32_t> firstKid_;
  std::vector<std::uint32_t> kids_;  ///< noBranchNode: the value leaves here
  std::vector<Frame> frames_;
  std::vector<std::uint32_t> written_;  ///< nodes in the order of execution
  std::uint32_t below_ = 0;             ///< levels below the top that are still needed
  std::optional<LoweringFault> fault_;
};

}  // namespace

Branches lowerAlongBranches(const Drawing& drawing, const Circuit& circuit, PinOrder order, EditorBits taken) {
  return Writer(drawing, circuit, order, taken).run();
}

}  // namespace rungproof
