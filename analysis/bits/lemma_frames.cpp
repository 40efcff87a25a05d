// Lemmas by level; activities grow by a factor instead of being aged, and are scaled down before they overflow.
#include "analysis/bits/lemma_frames.hpp"

#include "analysis/schedule/schedule.hpp"

namespace rungproof {

bool subsumes(const Cube& general, const Cube& special) {
  if (general.size() > special.size()) return false;
  return std::includes(special.begin(), special.end(), general.begin(), general.end());
}

std::size_t LemmaFrames::size() const {
  std::size_t count = 0;
  for (int level = 1; level <= top(); ++level) count += at(level).size();
  return count;
}

std::vector<Cube> LemmaFrames::above(int level) const {
  std::vector<Cube> lemmas;
  for (int i = level + 1; i <= top(); ++i) lemmas.insert(lemmas.end(), at(i).begin(), at(i).end());
  return lemmas;
}

void LemmaFrames::add(const Cube& cube, int level) {
  for (int i = 1; i <= level; ++i)
    std::erase_if(frames_[static_cast<std::size_t>(i)], [&](const Cube& lemma) { return subsumes(cube, lemma); });
  frames_[static_cast<std::size_t>(level)].push_back(cube);
  bump_ *= schedule::activityGrowth;
  for (const Lit l : cube) {
    if (variableOf(l) >= activity_.size()) activity_.resize(variableOf(l) + 1, 0);
    activity_[variableOf(l)] += bump_;
  }
  if (bump_ > 1e100) {
    for (double& a : activity_) a *= 1e-100;
    bump_ *= 1e-100;
  }
}

bool LemmaFrames::isBlocked(const Cube& cube, int level) const {
  for (int i = level; i <= top(); ++i) {
    if (std::ranges::any_of(at(i), [&](const Cube& lemma) { return subsumes(lemma, cube); })) return true;
  }
  return false;
}

}  // namespace rungproof
