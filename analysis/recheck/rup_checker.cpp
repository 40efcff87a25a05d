// Two watched literals. What follows from unit clauses stays assigned, so that forgetting a clause never takes back
// what it has led to.
#include "analysis/recheck/rup_checker.hpp"

#include <algorithm>

namespace rungproof {

namespace {

constexpr std::uint32_t noClause = 0xFFFFFFFF;

}  // namespace

RupChecker::RupChecker(int variables)
    : values_(2 * (static_cast<std::size_t>(variables) + 1), 0), watches_(values_.size()) {}

void RupChecker::assign(int literal) {
  values_[index(literal)] = 1;
  values_[index(-literal)] = -1;
  trail_.push_back(literal);
}

/// False where a clause has no literal left.
bool RupChecker::visit(int falsified) {
  std::vector<Watch>& watches = watches_[index(falsified)];
  std::size_t kept = 0, at = 0;
  bool isSound = true;
  for (; at < watches.size() && isSound; ++at) {
    const Watch watch = watches[at];
    if (isTrue(watch.other)) {
      watches[kept++] = watch;
      continue;
    }
    const int length = clauses_[watch.clause];
    if (length == 0) continue;
    int* literals = &clauses_[watch.clause + 1];
    if (literals[0] == falsified) std::swap(literals[0], literals[1]);
    if (isTrue(literals[0])) {
      watches[kept++] = {watch.clause, literals[0]};
      continue;
    }
    int next = 2;
    while (next < length && isFalse(literals[next])) ++next;
    if (next < length) {
      std::swap(literals[1], literals[next]);
      watches_[index(literals[1])].push_back({watch.clause, literals[0]});
      continue;
    }
    watches[kept++] = watch;
    if (isFalse(literals[0]))
      isSound = false;
    else
      assign(literals[0]);
  }
  for (; at < watches.size(); ++at) watches[kept++] = watches[at];
  watches.resize(kept);
  return isSound;
}

bool RupChecker::propagate() {
  while (done_ < trail_.size()) {
    if (!visit(-trail_[done_++])) return false;
  }
  return true;
}

/// Nothing is kept of a clause that unit clauses satisfy or make one themselves.
RupChecker::Reference RupChecker::take(std::span<const int> clause) {
  if (isRefuted_ || std::ranges::any_of(clause, [&](int l) { return isTrue(l); })) return noClause;
  const auto reference = static_cast<Reference>(clauses_.size());
  clauses_.push_back(static_cast<int>(clause.size()));
  clauses_.insert(clauses_.end(), clause.begin(), clause.end());
  const auto begin = clauses_.begin() + static_cast<std::ptrdiff_t>(reference) + 1;
  const auto open = std::partition(begin, clauses_.end(), [&](int l) { return !isFalse(l); }) - begin;
  if (open >= 2) {
    const int first = *begin, second = *(begin + 1);
    watches_[index(first)].push_back({reference, second});
    watches_[index(second)].push_back({reference, first});
    return reference;
  }
  if (open == 1) assign(*begin);
  clauses_.resize(reference);
  if (open == 0 || !propagate()) isRefuted_ = true;
  return noClause;
}

void RupChecker::add(std::span<const int> clause) {
  std::vector<int> literals(clause.begin(), clause.end());
  std::ranges::sort(literals, [](int a, int b) { return index(a) < index(b); });
  literals.erase(std::unique(literals.begin(), literals.end()), literals.end());
  for (std::size_t i = 0; i + 1 < literals.size(); ++i) {
    if (literals[i] == -literals[i + 1]) return;
  }
  take(literals);
}

bool RupChecker::derive(std::span<const int> clause) {
  if (isRefuted_) return true;
  const std::size_t before = trail_.size();
  bool follows = false;
  for (const int l : clause) {
    follows = follows || isTrue(l);
    if (!follows && !isFalse(l)) assign(-l);
  }
  follows = follows || !propagate();
  for (std::size_t i = before; i < trail_.size(); ++i) values_[index(trail_[i])] = values_[index(-trail_[i])] = 0;
  trail_.resize(before);
  done_ = before;
  if (!follows) return false;
  if (const Reference reference = take(clause); reference != noClause) derived_.emplace(keyOf(clause), reference);
  return true;
}

void RupChecker::forget(std::span<const int> clause) {
  std::vector<int> sorted(clause.begin(), clause.end());
  std::ranges::sort(sorted);
  const auto [first, last] = derived_.equal_range(keyOf(clause));
  for (auto at = first; at != last; ++at) {
    const auto begin = clauses_.begin() + static_cast<std::ptrdiff_t>(at->second) + 1;
    std::vector<int> known(begin, begin + clauses_[at->second]);
    std::ranges::sort(known);
    if (known != sorted) continue;
    clauses_[at->second] = 0;
    derived_.erase(at);
    return;
  }
}

/// The same for all orders of its literals.
std::uint64_t RupChecker::keyOf(std::span<const int> clause) {
  std::uint64_t sum = 0;
  for (const int l : clause) {
    std::uint64_t x = index(l) * 0x9E3779B97F4A7C15ULL;
    x ^= x >> 29U;
    sum += x * 0xBF58476D1CE4E5B9ULL;
  }
  return sum;
}

}  // namespace rungproof
