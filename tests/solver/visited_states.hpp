// Small systems of states of width 1 made by chance, and what is true of them by visiting every state: the referee of
// what the portfolio answers. Constants are the initial values; a state without may begin with any.
#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <random>
#include <set>
#include <vector>

#include "analysis/bits/bit_blast.hpp"
#include "analysis/graph/evaluate.hpp"
#include "analysis/portfolio/portfolio.hpp"
#include "families.hpp"

namespace rungproof::families {

/// A term over the nodes of width 1, some levels deep.
inline Node randomTerm(Family& f, const std::vector<Node>& leaves, int depth, std::mt19937& random) {
  if (depth == 0) return leaves[random() % leaves.size()];
  const Node left = randomTerm(f, leaves, depth - 1, random), right = randomTerm(f, leaves, depth - 1, random);
  switch (random() % 4) {
    case 0: return f.both(left, right);
    case 1: return f.either(left, right);
    case 2: return f.no(left);
    default: return f.differ(left, right);
  }
}

/// Values of the states at the start of a scan as a number, one bit a state.
inline std::vector<std::uint64_t> bitsOf(std::uint64_t number, std::size_t count) {
  std::vector<std::uint64_t> bits;
  for (std::size_t i = 0; i < count; ++i) bits.push_back(number >> i & 1U);
  return bits;
}

struct ScanOf {
  bool isLegal, isBad;
  std::uint64_t after;
};

inline ScanOf scanOf(const Family& f, Evaluator& value, const std::vector<std::uint64_t>& states,
                     const std::vector<std::uint64_t>& inputs) {
  for (std::size_t i = 0; i < states.size(); ++i) value.set(f.system.states[i].node, states[i]);
  for (std::size_t i = 0; i < inputs.size(); ++i) value.set(f.system.inputs[i], inputs[i]);
  value.run();
  ScanOf scan{true, value[f.system.questions[0].bad] != 0, 0};
  for (const Node n : f.system.constraints) scan.isLegal = scan.isLegal && value[n] != 0;
  for (std::size_t i = 0; i < states.size(); ++i) scan.after |= value[f.system.states[i].next] << i;
  return scan;
}

inline std::vector<Node> rootsOf(const Family& f) {
  std::vector<Node> roots = f.system.constraints;
  roots.push_back(f.system.questions[0].bad);
  roots.insert(roots.end(), f.system.inputs.begin(), f.system.inputs.end());
  for (const StateVariable& s : f.system.states) roots.insert(roots.end(), {s.node, s.next});
  return roots;
}

inline bool isInitial(const Family& f, const std::vector<std::uint64_t>& states) {
  for (std::size_t s = 0; s < states.size(); ++s) {
    const Node init = f.system.states[s].init;
    if (init != noNode && (*f.graph)[init].value != states[s]) return false;
  }
  return true;
}

/// By visiting all states: some scan of some run is bad.
inline bool isBadReachable(const Family& f) {
  Evaluator value(*f.graph, rootsOf(f));
  std::vector<std::uint64_t> open;
  for (std::uint64_t state = 0; state < 1ULL << f.system.states.size(); ++state) {
    if (isInitial(f, bitsOf(state, f.system.states.size()))) open.push_back(state);
  }
  std::set<std::uint64_t> seen(open.begin(), open.end());
  while (!open.empty()) {
    const std::uint64_t state = open.back();
    open.pop_back();
    for (std::uint64_t in = 0; in < 1ULL << f.system.inputs.size(); ++in) {
      const ScanOf scan = scanOf(f, value, bitsOf(state, f.system.states.size()), bitsOf(in, f.system.inputs.size()));
      if (!scan.isLegal) continue;
      if (scan.isBad) return true;
      if (seen.insert(scan.after).second) open.push_back(scan.after);
    }
  }
  return false;
}

inline bool isRunToBad(const Family& f, const WordTrace& trace) {
  Evaluator value(*f.graph, rootsOf(f));
  std::vector<std::uint64_t> states = trace.initial;
  if (!isInitial(f, states)) return false;
  for (std::size_t i = 0; i < trace.inputs.size(); ++i) {
    const ScanOf scan = scanOf(f, value, states, trace.inputs[i]);
    if (!scan.isLegal) return false;
    if (scan.isBad && i + 1 == trace.inputs.size()) return true;
    states = bitsOf(scan.after, states.size());
  }
  return false;
}

/// The portfolio's answer to the question, which is that of all states and has a run that is one; nothing if the
/// technique did not settle it.
inline std::optional<QuestionAnswer> checkedAnswer(const Family& f, Technique technique) {
  PortfolioOptions options;
  options.seconds = 5;
  options.techniques.leaveOut(Technique::OneScan);
  TechniqueLog log;
  options.log = &log;
  QuestionAnswer answer = answerQuestions(f.system, options)[0];
  const bool isReachable = isBadReachable(f);
  EXPECT_EQ(answer.answer, isReachable ? Answer::Violated : Answer::Proved);
  EXPECT_TRUE(!isReachable || (answer.trace && isRunToBad(f, *answer.trace)));
  if (log.uses()[static_cast<std::size_t>(technique)].settled == 0) return std::nullopt;
  return answer;
}

}  // namespace rungproof::families
