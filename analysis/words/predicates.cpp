// Predicates with what the engine asks about them again and again.
#include "analysis/words/predicates.hpp"

#include <algorithm>

#include "analysis/words/linear_form.hpp"

namespace rungproof {

namespace {

std::unordered_map<std::uint32_t, Node> nextStates(const TransitionSystem& system) {
  std::unordered_map<std::uint32_t, Node> next;
  for (const StateVariable& state : system.states) next.emplace(indexOf(state.node), state.next);
  // Inputs stand for themselves: the substitution is never asked about a scan after next.
  return next;
}

}  // namespace

Predicates::Predicates(WordCone& cone, std::vector<WordState> samples)
    : cone_(cone), afterScan_(cone.graph(), nextStates(cone.system())), samples_(std::move(samples)) {
  for (std::size_t i = 0; i < cone.system().states.size(); ++i)
    state_.emplace(indexOf(cone.system().states[i].node), i);
}

std::optional<std::vector<std::uint32_t>> Predicates::wordsUnder(Node n) const {
  std::vector<std::uint32_t> words;
  const Node roots[] = {n};
  for (const Node under : coneOf(cone_.graph(), roots)) {
    if (cone_.graph()[under].op != Op::Variable) continue;
    const auto state = state_.find(indexOf(under));
    if (state == state_.end()) return std::nullopt;
    words.push_back(state->second);
  }
  std::ranges::sort(words);
  return words;
}

bool Predicates::add(Node n) {
  n = positive(linearForm(cone_.graph(), n));
  if (index_.contains(indexOf(n)) || cone_.graph()[n].op == Op::Constant) return false;
  std::optional<std::vector<std::uint32_t>> words = wordsUnder(n);
  if (!words) return false;
  Predicate predicate;
  predicate.now = n;
  predicate.next = linearForm(cone_.graph(), afterScan_(n));
  predicate.words = std::move(*words);
  predicate.initially = initialValue(predicate);
  predicate.samples = overSamples(n);
  index_.emplace(indexOf(n), predicates_.size());
  predicates_.push_back(std::move(predicate));
  return true;
}

bool Predicates::contains(Node n) const { return index_.contains(indexOf(positive(linearForm(cone_.graph(), n)))); }

std::optional<bool> Predicates::initialValue(const Predicate& predicate) const {
  const Node roots[] = {predicate.now};
  Evaluator evaluator(cone_.graph(), roots);
  for (const std::uint32_t word : predicate.words) {
    const StateVariable& state = cone_.system().states[word];
    if (state.init == noNode) return std::nullopt;
    evaluator.set(state.node, cone_.graph()[state.init].value);
  }
  evaluator.run();
  return evaluator[predicate.now] != 0;
}

std::vector<bool> Predicates::valuesIn(const WordState& state, std::span<const Node> nodes) const {
  Evaluator evaluator(cone_.graph(), nodes);
  for (std::size_t i = 0; i < state.size(); ++i) evaluator.set(cone_.system().states[i].node, state[i]);
  evaluator.run();
  std::vector<bool> values;
  for (const Node n : nodes) values.push_back(evaluator[n] != 0);
  return values;
}

bool Predicates::contains(const WordCube& cube, const WordState& state) const {
  std::vector<Node> nodes;
  for (const Lit l : cube) nodes.push_back(of(l).now);
  const std::vector<bool> values = valuesIn(state, nodes);
  for (std::size_t i = 0; i < cube.size(); ++i) {
    if (values[i] == isNegative(cube[i])) return false;
  }
  return true;
}

std::vector<std::uint64_t> Predicates::overSamples(Node n) const {
  std::vector<std::uint64_t> result((samples_.size() + 63) / 64, 0);
  const Node roots[] = {n};
  Evaluator evaluator(cone_.graph(), roots);
  const std::vector<std::uint32_t> words = wordsUnder(n).value_or(std::vector<std::uint32_t>{});
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    for (const std::uint32_t word : words) evaluator.set(cone_.system().states[word].node, samples_[i][word]);
    evaluator.run();
    result[i / 64] |= static_cast<std::uint64_t>(evaluator[n] != 0) << (i % 64);
  }
  return result;
}

std::vector<std::uint64_t> Predicates::samplesIn(const WordCube& cube) const {
  std::vector<std::uint64_t> inside((samples_.size() + 63) / 64, ~0ULL);
  if (samples_.size() % 64 != 0) inside.back() = (1ULL << (samples_.size() % 64)) - 1;
  for (std::size_t block = 0; block < inside.size(); ++block) {
    for (const Lit l : cube) inside[block] &= of(l).samples[block] ^ (isNegative(l) ? ~0ULL : 0);
  }
  return inside;
}

std::optional<std::size_t> Predicates::sampleIn(const WordCube& cube) const {
  const std::vector<std::uint64_t> inside = samplesIn(cube);
  for (std::size_t block = 0; block < inside.size(); ++block) {
    if (inside[block] != 0) return block * 64 + static_cast<std::size_t>(std::countr_zero(inside[block]));
  }
  return std::nullopt;
}

}  // namespace rungproof
