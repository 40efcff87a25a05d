// Patterns of names where the C library has no fnmatch(). It names nothing of a system: tests/platform compares it with
// fnmatch().
#pragma once

#include <cstddef>
#include <string_view>

namespace rungproof {

/// A set "[a-z]" or "[!a-z]" that begins at `at`; `at` goes behind it. False where it has no end: then [ is a sign.
inline bool readPatternSet(std::string_view pattern, std::size_t& at, char c, bool& isMember) {
  std::size_t i = at + 1;
  const bool isNegated = i < pattern.size() && (pattern[i] == '!' || pattern[i] == '^');
  if (isNegated) ++i;
  bool found = false;
  const auto sign = [&](std::size_t& place) {
    if (pattern[place] == '\\' && place + 1 < pattern.size()) ++place;
    return static_cast<unsigned char>(pattern[place++]);
  };
  const auto letter = static_cast<unsigned char>(c);
  for (bool isFirst = true; i < pattern.size(); isFirst = false) {
    if (pattern[i] == ']' && !isFirst) {
      at = i + 1;
      isMember = found != isNegated;
      return true;
    }
    const unsigned char low = sign(i);
    unsigned char high = low;
    if (i + 1 < pattern.size() && pattern[i] == '-' && pattern[i + 1] != ']') high = sign(++i);
    found = found || (low <= letter && letter <= high);
  }
  return false;
}

/// Whether a name fits a pattern with *, ?, [...] and \. Classes such as [:alpha:] are not known.
inline bool fitsPortablePattern(std::string_view name, std::string_view pattern) {
  constexpr std::size_t none = std::string_view::npos;
  std::size_t n = 0, p = 0, starAt = none, starName = 0;
  while (n < name.size() || p < pattern.size()) {
    bool fits = false;
    if (p < pattern.size() && pattern[p] == '*') {
      starAt = ++p;
      starName = n;
      continue;
    }
    if (p < pattern.size() && n < name.size()) {
      const char c = pattern[p];
      std::size_t next = p;
      bool isMember = false;
      if (c == '?') {
        fits = true;
        ++p;
      } else if (c == '[' && readPatternSet(pattern, next, name[n], isMember)) {
        fits = isMember;
        p = next;
      } else if (c == '\\' && p + 1 < pattern.size()) {
        fits = pattern[p + 1] == name[n];
        p += 2;
      } else {
        fits = c == name[n] && c != '\\';
        ++p;
      }
    }
    if (fits) {
      ++n;
      continue;
    }
    if (starAt == none || starName >= name.size()) return false;
    p = starAt;  // the star takes one sign more
    n = ++starName;
  }
  return true;
}

}  // namespace rungproof
