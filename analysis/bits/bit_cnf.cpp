// Tseitin's encoding with an explicit stack, since unrollings are deep.
#include "analysis/bits/bit_cnf.hpp"

#include <array>

namespace rungproof {

int BitCnf::trueLiteral() {
  if (of_[0] == 0) {
    of_[0] = sat_.newVariable();
    sat_.add({-of_[0]});
  }
  return -of_[0];
}

int BitCnf::known(Lit l) const {
  const std::uint32_t v = variableOf(l);
  return v < of_.size() ? signedOf(l) : 0;
}

bool BitCnf::value(Lit l) const {
  const int s = known(l);
  return s != 0 ? sat_.value(s) : isNegative(l);
}

int BitCnf::literal(Lit l) {
  if (of_.size() < graph_.variableCount()) of_.resize(graph_.variableCount(), 0);
  const std::uint32_t v = variableOf(l);
  if (v == 0) {
    const int t = trueLiteral();
    return l == trueLit ? t : -t;
  }
  if (of_[v] == 0) encode(v);
  return signedOf(l);
}

void BitCnf::encode(std::uint32_t variable) {
  stack_.assign(1, variable);
  while (!stack_.empty()) {
    const std::uint32_t v = stack_.back();
    if (of_[v] != 0) {
      stack_.pop_back();
      continue;
    }
    if (graph_.kind[v] != BitSystem::Kind::Gate) {
      of_[v] = sat_.newVariable();
      stack_.pop_back();
      continue;
    }
    BitChoice choice;
    const bool isChoice = recogniseChoice(graph_, positive(v), choice);
    const AndGate& gate = graph_.gateOf(positive(v));
    const std::array<Lit, 3> children = isChoice ? std::array<Lit, 3>{choice.condition, choice.then, choice.otherwise}
                                                 : std::array<Lit, 3>{gate.left, gate.right, gate.right};
    bool ready = true;
    for (const Lit child : children) {
      if (of_[variableOf(child)] != 0) continue;
      stack_.push_back(variableOf(child));
      ready = false;
    }
    if (!ready) continue;
    stack_.pop_back();
    const int out = of_[v] = sat_.newVariable();
    const int a = signedOf(children[0]);
    const int b = signedOf(children[1]);
    if (!isChoice) {
      sat_.add({-out, a});
      sat_.add({-out, b});
      sat_.add({out, -a, -b});
      continue;
    }
    const int c = signedOf(children[2]);
    sat_.add({-a, -b, out});
    sat_.add({-a, b, -out});
    sat_.add({a, -c, out});
    sat_.add({a, c, -out});
    if (b != -c) {
      sat_.add({-b, -c, out});
      sat_.add({b, c, -out});
    }
  }
}

}  // namespace rungproof
