// Collects the cone as a fixpoint over next-state functions, then makes literals in the order of node numbers.
#include "analysis/bits/bit_blast.hpp"

#include <algorithm>

#include "analysis/graph/evaluate.hpp"
#include "analysis/schedule/schedule.hpp"
#include "ir/check.hpp"

namespace rungproof {

BitBlast::BitBlast(const TransitionSystem& system, const Questions& questions, const std::vector<Node>& extra,
                   const Budget* budget)
    : system_(system), graph_(*system.graph) {
  for (std::size_t i = 0; i < system.states.size(); ++i) states_.emplace(indexOf(system.states[i].node), i);
  for (std::size_t i = 0; i < system.inputs.size(); ++i) inputs_.emplace(indexOf(system.inputs[i]), i);
  std::vector<Node> roots = system.constraints;
  roots.insert(roots.end(), extra.begin(), extra.end());
  for (const std::size_t q : questions) roots.push_back(system.questions[q].bad);
  collectCone(roots, {}, budget);
  for (std::size_t latch = 0; latch < stateBits_.size(); ++latch) {
    const auto [state, bit] = stateBits_[latch];
    bits_.setNext(positive(bits_.latches[latch].variable), of(system.states[state].next)[bit]);
  }
  for (const Node n : system.constraints) {
    bits_.constraints.push_back(of(n)[0]);
    total_.push_back(std::find(system.totalConstraints.begin(), system.totalConstraints.end(), n) !=
                     system.totalConstraints.end());
  }
  ask(questions);
  for (const Node n : extra) remember(n);
}

void BitBlast::ask(const Questions& questions) {
  questions_ = questions;
  bits_.bads.clear();
  for (const std::size_t q : questions) bits_.bads.push_back(badOf(q));
}

BitBlast::BitBlast(const TransitionSystem& system, Node root, const std::unordered_set<std::uint32_t>& open)
    : system_(system), graph_(*system.graph) {
  for (const std::uint32_t n : open) literals_.emplace(n, freshInputs({}, graph_[static_cast<Node>(n)].width));
  collectCone({root}, open);
  bits_.bads.push_back(of(root)[0]);
}

void BitBlast::remember(Node n) {
  const Lit l = of(n)[0];
  if (graph_[n].width == 1 && bits_.isGate(l))
    nodes_.emplace(variableOf(l), isNegative(l) ? graph_.make(Op::Not, 1, n) : n);
}

void BitBlast::add(const std::vector<Node>& nodes) {
  for (const Node n : coneOf(graph_, nodes)) {
    if (contains(n)) continue;
    CHECK(graph_[n].op != Op::Variable, "a node over variables outside the cone");
    blast(n);
  }
  for (const Node n : nodes) remember(n);
}

void BitBlast::tell(Node valid) {
  bits_.constraints.push_back(of(valid)[0]);
  total_.push_back(true);
}

void BitBlast::collectCone(const std::vector<Node>& roots, const std::unordered_set<std::uint32_t>& open,
                           const Budget* budget) {
  std::vector<bool> inCone(graph_.size(), false);
  std::vector<Node> stack = roots;
  while (!stack.empty()) {
    const Node n = stack.back();
    stack.pop_back();
    if (inCone[indexOf(n)] || open.contains(indexOf(n))) continue;
    inCone[indexOf(n)] = true;
    const NodeData& node = graph_[n];
    if (node.op == Op::Variable) {
      if (const auto state = states_.find(indexOf(n)); state != states_.end())
        stack.push_back(system_.states[state->second].next);
      continue;
    }
    for (const Node child : node.child) {
      if (child != noNode) stack.push_back(child);
    }
  }
  // Node numbers grow from children to parents; variables come first in the bit system, latches by state order.
  for (std::size_t i = 0; i < inCone.size(); ++i) {
    const Node n = static_cast<Node>(i);
    if (inCone[i] && graph_[n].op == Op::Variable) blast(n);
  }
  std::size_t gates = 0;
  for (std::size_t i = 0; i < inCone.size(); ++i) {
    if (!inCone[i] || graph_[static_cast<Node>(i)].op == Op::Variable) continue;
    blast(static_cast<Node>(i));
    if (budget == nullptr || bits_.gates.size() < gates + schedule::gatesBetweenLooks) continue;
    gates = bits_.gates.size();
    if (budget->isExhausted()) throw OutOfBudget{};
  }
}

const LitVector& BitBlast::of(Node n) const {
  const auto found = literals_.find(indexOf(n));
  CHECK(found != literals_.end(), "node outside the cone");
  return found->second;
}

LitVector BitBlast::freshInputs(const std::string& name, int width) {
  LitVector result;
  for (int bit = 0; bit < width; ++bit) {
    inputBits_.push_back({noInput, static_cast<std::uint32_t>(bit)});
    result.push_back(bits_.addInput(width == 1 ? name : name + "[" + std::to_string(bit) + "]"));
  }
  return result;
}

void BitBlast::blastDivision(const NodeData& node, const LitVector& a, const LitVector& b, LitVector& out) {
  BitArithmetic arithmetic(bits_);
  LitVector quotient, remainder;
  if (node.op == Op::Udiv || node.op == Op::Urem)
    arithmetic.divide(a, b, quotient, remainder);
  else
    arithmetic.divideSigned(a, b, quotient, remainder);
  out = node.op == Op::Udiv || node.op == Op::Sdiv ? quotient : remainder;
}

void BitBlast::blast(Node n) {
  const NodeData& node = graph_[n];
  const int width = node.width;
  BitArithmetic arithmetic(bits_);
  const auto arg = [&](std::size_t i) -> const LitVector& { return of(node.child[i]); };
  LitVector out;
  switch (node.op) {
    case Op::Constant: out = BitArithmetic::constant(node.value, width); break;
    case Op::Variable: {
      const std::string& name = graph_.variables()[node.value].name;
      if (const auto state = states_.find(indexOf(n)); state != states_.end()) {
        const Node init = system_.states[state->second].init;
        CHECK(init == noNode || graph_[init].op == Op::Constant, "initial values are constants or free");
        for (int bit = 0; bit < width; ++bit) {
          const LatchInit value = init == noNode                          ? LatchInit::Free
                                  : (graph_[init].value >> bit & 1U) != 0 ? LatchInit::One
                                                                          : LatchInit::Zero;
          out.push_back(bits_.addLatch(width == 1 ? name : name + "[" + std::to_string(bit) + "]", value));
          stateBits_.push_back({state->second, static_cast<std::uint32_t>(bit)});
        }
        break;
      }
      out = freshInputs(name, width);
      if (const auto input = inputs_.find(indexOf(n)); input != inputs_.end()) {
        for (std::size_t i = inputBits_.size() - out.size(); i < inputBits_.size(); ++i)
          inputBits_[i].input = input->second;
      }
      break;
    }
    case Op::Not: out = arithmetic.bitNot(arg(0)); break;
    case Op::And: out = arithmetic.bitAnd(arg(0), arg(1)); break;
    case Op::Or: out = arithmetic.bitOr(arg(0), arg(1)); break;
    case Op::Xor: out = arithmetic.bitXor(arg(0), arg(1)); break;
    case Op::Add: out = arithmetic.add(arg(0), arg(1)); break;
    case Op::Sub: out = arithmetic.subtract(arg(0), arg(1)); break;
    case Op::Mul: out = arithmetic.multiply(arg(0), arg(1)); break;
    case Op::Udiv:
    case Op::Urem:
    case Op::Sdiv:
    case Op::Srem: blastDivision(node, arg(0), arg(1), out); break;
    case Op::Shl: out = arithmetic.shiftLeft(arg(0), arg(1)); break;
    case Op::Lshr: out = arithmetic.shiftRight(arg(0), arg(1)); break;
    case Op::Equal: out = {arithmetic.equal(arg(0), arg(1))}; break;
    case Op::Ult: out = {arithmetic.less(arg(0), arg(1))}; break;
    case Op::Ule: out = {negate(arithmetic.less(arg(1), arg(0)))}; break;
    case Op::Slt: out = {arithmetic.lessSigned(arg(0), arg(1))}; break;
    case Op::Sle: out = {negate(arithmetic.lessSigned(arg(1), arg(0)))}; break;
    case Op::Ite: out = arithmetic.choose(arg(0)[0], arg(1), arg(2)); break;
    case Op::Concat:
      out = arg(1);
      out.insert(out.end(), arg(0).begin(), arg(0).end());
      break;
    case Op::Extract:
      out.assign(arg(0).begin() + static_cast<std::ptrdiff_t>(node.value),
                 arg(0).begin() + static_cast<std::ptrdiff_t>(node.value) + width);
      break;
    case Op::Zext:
      out = arg(0);
      out.resize(static_cast<std::size_t>(width), falseLit);
      break;
    case Op::Sext:
      out = arg(0);
      out.resize(static_cast<std::size_t>(width), arg(0).back());
      break;
    case Op::RealAdd:
    case Op::RealSub:
    case Op::RealMul:
    case Op::RealDiv:
    case Op::RealFunction:
    case Op::RealEqual:
    case Op::RealLess:
    case Op::RealLegal:
    case Op::RealFromInt:
    case Op::RealToInt:
    case Op::LongReal:
      out = freshInputs("real " + std::to_string(indexOf(n)), width);
      unmodelled_.push_back(n);
      for (int bit = 0; bit < width; ++bit)
        unmodelledInputs_.push_back(static_cast<std::uint32_t>(bits_.inputs.size()) -
                                    static_cast<std::uint32_t>(width - bit));
      break;
  }
  CHECK(static_cast<int>(out.size()) == width, "width of a blasted node");
  literals_.emplace(indexOf(n), std::move(out));
}

Node BitBlast::nodeOf(Lit l) {
  std::vector<std::uint32_t> stack{variableOf(l)};
  while (!stack.empty()) {
    const std::uint32_t v = stack.back();
    if (nodes_.contains(v)) {
      stack.pop_back();
      continue;
    }
    const auto literal = [&](Lit child) {
      const Node n = nodes_.at(variableOf(child));
      return isNegative(child) ? graph_.make(Op::Not, 1, n) : n;
    };
    if (v == 0) {
      nodes_[v] = graph_.constantNode(0, 1);
    } else if (bits_.kind[v] == BitSystem::Kind::Latch) {
      const auto [state, bit] = stateBits_[bits_.position[v]];
      const Node word = system_.states[state].node;
      nodes_[v] = graph_[word].width == 1 ? word : graph_.make(Op::Extract, 1, word, noNode, noNode, bit);
    } else {
      CHECK(bits_.kind[v] == BitSystem::Kind::Gate, "an invariant over inputs");
      const auto [a, b] = bits_.gateOf(positive(v));
      const bool ready = nodes_.contains(variableOf(a)) && nodes_.contains(variableOf(b));
      if (!ready) {
        stack.push_back(variableOf(a));
        stack.push_back(variableOf(b));
        continue;
      }
      nodes_[v] = graph_.make(Op::And, 1, literal(a), literal(b));
    }
    stack.pop_back();
  }
  const Node n = nodes_.at(variableOf(l));
  return isNegative(l) ? graph_.make(Op::Not, 1, n) : n;
}

WordTrace BitBlast::wordTrace(const BitTrace& trace) const {
  WordTrace result;
  for (const StateVariable& state : system_.states)
    result.initial.push_back(state.init == noNode ? 0 : graph_[state.init].value);
  for (std::size_t i = 0; i < stateBits_.size(); ++i) {
    const auto [state, bit] = stateBits_[i];
    std::uint64_t& value = result.initial[state];
    value = (value & ~(1ULL << bit)) | static_cast<std::uint64_t>(trace.initial[i]) << bit;
  }
  for (const std::vector<bool>& scan : trace.inputs) {
    std::vector<std::uint64_t>& values = result.inputs.emplace_back(system_.inputs.size(), 0);
    for (std::size_t i = 0; i < inputBits_.size(); ++i) {
      if (inputBits_[i].input != noInput)
        values[inputBits_[i].input] |= static_cast<std::uint64_t>(scan[i]) << inputBits_[i].bit;
    }
  }
  return result;
}

BitTrace BitBlast::bitTrace(const WordTrace& trace) const {
  BitTrace result;
  for (const auto& [state, bit] : stateBits_) result.initial.push_back((trace.initial[state] >> bit & 1U) != 0);
  for (const std::vector<std::uint64_t>& scan : trace.inputs) {
    std::vector<bool>& values = result.inputs.emplace_back();
    for (const auto& [input, bit] : inputBits_) values.push_back(input != noInput && (scan[input] >> bit & 1U) != 0);
  }
  return result;
}

}  // namespace rungproof
