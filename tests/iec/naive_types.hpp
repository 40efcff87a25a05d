// What the random programs over all types compute with: whole numbers in 128 bits, cut to their type behind each
// operator, and a state of plain values by name.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <string>

namespace rungproof::iec_types {

__extension__ typedef __int128 Whole;
__extension__ typedef unsigned __int128 Pattern;

/// I whole numbers, B bit strings, T durations, C dates and times of day; they differ in their operators alone.
struct Kind {
  const char* name;
  int bits;
  bool isSigned;
  char sort;
};
inline constexpr Kind kinds[] = {{"SINT", 8, true, 'I'},    {"INT", 16, true, 'I'},    {"DINT", 32, true, 'I'},
                                 {"LINT", 64, true, 'I'},   {"USINT", 8, false, 'I'},  {"UINT", 16, false, 'I'},
                                 {"UDINT", 32, false, 'I'}, {"ULINT", 64, false, 'I'}, {"BYTE", 8, false, 'B'},
                                 {"WORD", 16, false, 'B'},  {"DWORD", 32, false, 'B'}, {"LWORD", 64, false, 'B'},
                                 {"TIME", 32, true, 'T'},   {"LTIME", 64, true, 'T'},  {"DATE", 32, false, 'C'},
                                 {"TOD", 32, false, 'C'},   {"DT", 32, false, 'C'}};
inline constexpr const Kind &usintKind = kinds[4], &intKind = kinds[1], &dintKind = kinds[2], &timeKind = kinds[12];

inline Whole cut(Whole value, const Kind& kind) {
  const auto size = static_cast<Whole>(static_cast<Pattern>(1) << kind.bits);
  Whole rest = value % size;
  if (rest < 0) rest += size;
  return kind.isSigned && rest >= size / 2 ? rest - size : rest;
}
/// The low bits of a product, which may have more than 127.
inline Whole product(Whole a, Whole b, const Kind& kind) {
  const Pattern low = static_cast<Pattern>(a) * static_cast<Pattern>(b);
  return cut(static_cast<Whole>(low & ((static_cast<Pattern>(1) << kind.bits) - 1)), kind);
}
/// Halves to the even number; what does not fit is the nearest that does.
inline Whole nearest(double value, const Kind& kind) {
  const Whole most = (static_cast<Whole>(1) << (kind.bits - (kind.isSigned ? 1 : 0))) - 1;
  const Whole rounded = static_cast<Whole>(std::nearbyint(value));
  return std::clamp<Whole>(rounded, kind.isSigned ? -most - 1 : 0, most);
}

struct State {
  std::map<std::string, Whole> whole;
  std::map<std::string, double> real;
  std::map<std::string, std::string> text;
};
struct Returned {};

template <class T>
struct Term {
  std::string text;
  std::function<T(State&)> compute;
};
using Number = Term<Whole>;
using Real = Term<double>;
using Text = Term<std::string>;

}  // namespace rungproof::iec_types
