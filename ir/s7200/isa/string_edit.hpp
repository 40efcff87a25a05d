// Strings: SLEN SCPY SCAT SSCPY, SFND CFND (001:6067-6254). A string is a length byte and 0 to 254
// characters; positions count from 1. A longer one, or one that leaves its area, is error 0091. What the manual leaves
// open (results over 254, substrings beyond the end, empty search texts, overlap) are choices.
// Tests: tests/manual/string_test.cpp.
#pragma once

#include <algorithm>
#include <vector>

#include "ir/s7200/isa/overlapping_copy.hpp"

namespace rungproof::isa {

inline constexpr int maxString = 254;  // 001:1414

/// A string operand that is read: its length, whether it is legal, and how many characters it can have at most.
template <class D>
struct StringSource {
  using Bool = typename D::Bool;
  using Bits = typename D::Bits;

  StringSource(Machine<D>& machine, Args<D>& arguments, std::size_t operand) : m(machine), a(arguments), i(operand) {
    D& d = m.d;
    const Bits byte = a.byteAt(i, 0);
    length = d.zext(byte, 8, 16);
    isLegal =
        d.land(d.ule(byte, m.number(maxString, 8), 8), a.fits(i, d.add(length, m.number(1, 16), 16), Width::Byte));
    const int room = a.room(i, Width::Byte, maxString + 1) - 1;
    const auto known = d.known(length);
    limit = std::clamp(known ? static_cast<int>(*known) : maxString, 0, std::max(room, 0));
  }
  /// Character at a position, 1 to limit; the position may be a computed one.
  Bits at(Bits position) {
    D& d = m.d;
    if (const auto known = d.known(position)) return a.byteAt(i, static_cast<int>(*known));
    Bits result = m.number(0, 8);
    for (int k = 1; k <= limit; ++k)
      result = d.select(d.equal(position, m.number(static_cast<std::uint64_t>(k), 16), 16), a.byteAt(i, k), result, 8);
    return result;
  }

  Machine<D>& m;
  Args<D>& a;
  std::size_t i;
  Bits length{};  ///< width 16
  Bool isLegal{};
  int limit = 0;
};

/// Copies `count` characters of `source` from position `first` on to operand `to`, behind its first `behind`
/// characters, and sets the length of `to` to behind + count. Numbers have width 16. The whole result must fit.
template <class D>
void copyCharacters(Machine<D>& m, Args<D>& a, StringSource<D>& source, typename D::Bits first, typename D::Bits count,
                    std::size_t to, typename D::Bits behind) {
  using Bits = typename D::Bits;
  D& d = m.d;
  const auto later = [&](Bits from, int k) { return d.add(from, m.number(static_cast<std::uint64_t>(k), 16), 16); };
  const int room = a.room(to, Width::Byte, maxString + 1);
  const auto put = [&](int k, Bits character) {
    a.storeElementAt(to, later(behind, k + 1), room, Width::Byte, character);
  };
  const auto setLength = [&] { a.storeElement(to, 0, Width::Byte, d.extract(d.add(behind, count, 16), 7, 0)); };
  const auto character = [&](int k) { return source.at(later(first, k)); };
  OverlappingCopy<D> copy(m, a.mayOverlap(source.i, to), source.limit, 8);
  copy.begin(count, character);
  setLength();
  m.repeat(count, 16, source.limit, [&](int k) { put(k, copy.value(k, character)); });
}

constexpr Desc stringDesc(Role role, std::string_view stl, std::string_view box, std::string_view meaning,
                          std::uint32_t time, std::string_view manual) {
  return {.stl = stl,
          .meaning = meaning,
          .group = "strings",
          .role = role,
          .drawn = box,
          .stack = {1, 0, 0},
          .eno = true,
          .time = time,
          .manual = manual};
}

/// SLEN: the length byte (001:6071).
struct StringLength {
  static constexpr Desc desc =
      withOperands(stringDesc(Role::StringLength, "SLEN", "STR_LEN", "length of a string", 2100, "001:6071"),
                   {in("IN", Type::String, form::stringIn), out("OUT", Type::Byte, form::byteOut)});
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    StringSource<D> source(m, a, 0);
    m.hazard(Hazard::OutOfRange, m.d.lnot(source.isLegal));
    m.when(source.isLegal, [&] { a.store(1, m.d.extract(source.length, 7, 0)); });
  }
};

/// SCPY: copy (001:6075).
struct StringCopy {
  static constexpr Desc desc =
      withOperands(stringDesc(Role::StringCopy, "SCPY", "STR_CPY", "copy a string", 2700, "001:6075"),
                   {in("IN", Type::String, form::stringIn), out("OUT", Type::String, form::stringOut)});
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    StringSource<D> source(m, a, 0);
    const auto legal = m.d.land(source.isLegal, a.fits(1, m.d.add(source.length, m.number(1, 16), 16), Width::Byte));
    m.hazard(Hazard::OutOfRange, m.d.lnot(legal));
    m.when(legal, [&] { copyCharacters(m, a, source, m.number(1, 16), source.length, 1, m.number(0, 16)); });
  }
};

/// SCAT: appends IN to OUT (001:6079).
struct StringAppend {
  static constexpr Desc desc =
      withOperands(stringDesc(Role::StringAppend, "SCAT", "STR_CAT", "append a string", 3000, "001:6079"),
                   {in("IN", Type::String, form::stringIn), inout("OUT", Type::String, form::stringOut)});
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    D& d = m.d;
    StringSource<D> source(m, a, 0), target(m, a, 1);
    const auto most = m.number(maxString, 16);
    const auto total = d.add(source.length, target.length, 16);
    const auto isLong = d.ult(most, total, 16);
    const auto inside =
        d.land(d.land(source.isLegal, target.isLegal), a.fits(1, d.add(total, m.number(1, 16), 16), Width::Byte));
    m.hazard(Hazard::OutOfRange, d.lor(isLong, d.lnot(inside)));
    const auto cut = m.reads({Choice::StringResultOverflow, "cut"});
    const auto count = d.select(isLong, d.sub(most, target.length, 16), source.length, 16);
    m.when(d.land(inside, d.lor(cut, d.lnot(isLong))),
           [&] { copyCharacters(m, a, source, m.number(1, 16), count, 1, target.length); });
  }
};

/// SSCPY: N characters of IN from position INDX on become OUT (001:6133).
struct SubstringCopy {
  static constexpr Desc desc =
      withOperands(stringDesc(Role::StringPart, "SSCPY", "SSTR_CPY", "copy a substring", 4200, "001:6133"),
                   {in("IN", Type::String, form::stringIn), in("INDX", Type::Byte, form::byteIn),
                    in("N", Type::Byte, form::byteIn), out("OUT", Type::String, form::stringOut)});
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    D& d = m.d;
    StringSource<D> source(m, a, 0);
    const auto first = d.zext(a.value(1), 8, 16), wanted = d.zext(a.value(2), 8, 16);
    const auto isZero = d.equal(first, m.number(0, 16), 16);
    m.hazard(Hazard::StringIndexZero, isZero);
    const auto behind = d.add(source.length, m.number(1, 16), 16);
    const auto there = d.select(d.ult(first, behind, 16), d.sub(behind, first, 16), m.number(0, 16), 16);
    const auto tooMany = d.ult(there, wanted, 16);
    const auto count = d.select(tooMany, there, wanted, 16);
    auto legal = d.land(source.isLegal, a.fits(3, d.add(count, m.number(1, 16), 16), Width::Byte));
    legal = d.land(legal, d.lor(d.lnot(tooMany), m.reads({Choice::SubstringBeyondEnd, "cut"})));
    m.when(d.lnot(isZero), [&] {
      m.hazard(Hazard::OutOfRange, d.lnot(legal));
      m.when(legal, [&] { copyCharacters(m, a, source, first, count, 3, m.number(0, 16)); });
    });
  }
};

enum class Search { Text, AnyCharacter };

/// SFND, CFND: OUT becomes the first position, from its old value on, where IN2 stands in IN1, or where one of the
/// characters of IN2 stands; 0 if there is none (001:6158, 001:6170). OUT = 0 before is error 009B.
template <Search search, Name stlName, Name boxName, Name meaning, std::uint32_t time>
struct StringFind {
  static constexpr Desc desc =
      withOperands(stringDesc(Role::StringFind, stlName.view(), boxName.view(), meaning.view(), time,
                              search == Search::Text ? "001:6158" : "001:6170"),
                   {in("IN1", Type::String, form::stringIn), in("IN2", Type::String, form::stringIn),
                    inout("OUT", Type::Byte, form::byteOut)});
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    D& d = m.d;
    StringSource<D> text(m, a, 0), pattern(m, a, 1);
    const auto start = d.zext(a.value(2), 8, 16);
    const auto isZero = d.equal(start, m.number(0, 16), 16);
    m.hazard(Hazard::StringIndexZero, isZero);
    auto legal = d.land(text.isLegal, pattern.isLegal);
    legal = d.land(legal, d.lor(m.reads({Choice::FindStartBeyond, "not-found"}), d.ule(start, text.length, 16)));
    m.when(d.lnot(isZero), [&] {
      m.hazard(Hazard::OutOfRange, d.lnot(legal));
      m.when(legal, [&] { a.store(2, find(m, text, pattern, start)); });
    });
  }

 private:
  template <class D>
  static typename D::Bits find(Machine<D>& m, StringSource<D>& text, StringSource<D>& pattern, typename D::Bits start) {
    D& d = m.d;
    auto found = d.constant(false);
    auto position = m.number(0, 8);
    for (int p = 1; p <= text.limit; ++p) {
      if (const auto known = d.truth(found); known && *known) break;
      const auto here = m.number(static_cast<std::uint64_t>(p), 16);
      const auto inRange = d.land(d.ule(start, here, 16), d.ule(here, text.length, 16));
      const auto hit = d.land(d.land(inRange, d.lnot(found)), matches(m, text, pattern, p));
      position = d.select(hit, m.number(static_cast<std::uint64_t>(p), 8), position, 8);
      found = d.lor(found, hit);
    }
    return position;
  }
  template <class D>
  static typename D::Bool matches(Machine<D>& m, StringSource<D>& text, StringSource<D>& pattern, int p) {
    D& d = m.d;
    const auto empty = d.equal(pattern.length, m.number(0, 16), 16);
    const auto forEmpty =
        search == Search::Text ? d.land(empty, m.reads({Choice::FindEmpty, "at-start"})) : d.constant(false);
    auto result = d.constant(search == Search::Text);
    for (int k = 0; k < pattern.limit; ++k) {
      const auto used = d.ult(m.number(static_cast<std::uint64_t>(k), 16), pattern.length, 16);
      const int at = search == Search::Text ? p + k : p;
      const auto inText = d.ule(m.number(static_cast<std::uint64_t>(at), 16), text.length, 16);
      const auto same = d.land(d.constant(at <= text.limit), d.equal(text.a.byteAt(text.i, std::min(at, text.limit)),
                                                                     pattern.a.byteAt(pattern.i, k + 1), 8));
      if constexpr (search == Search::Text) result = d.land(result, d.lor(d.lnot(used), d.land(inText, same)));
      if constexpr (search == Search::AnyCharacter) result = d.lor(result, d.land(used, same));
      if (const auto known = d.truth(result); known && *known != (search == Search::Text)) break;
    }
    return d.lor(forEmpty, d.land(d.lnot(empty), result));
  }
};

using FindText = StringFind<Search::Text, "SFND", "STR_FIND", "find a string in a string", 3900>;
using FindCharacter =
    StringFind<Search::AnyCharacter, "CFND", "CHR_FIND", "find one of several characters in a string", 3500>;

using StringEditGroup = Group<StringLength, StringCopy, StringAppend, SubstringCopy, FindText, FindCharacter>;

}  // namespace rungproof::isa
