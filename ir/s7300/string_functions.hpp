// Functions of STRING: FC 2 CONCAT, FC 4 DELETE, FC 11 FIND, FC 17 INSERT, FC 20 LEFT, FC 21 LEN, FC 26 MID, FC 31
// REPLACE, FC 32 RIGHT and the comparisons FC 10, 13, 15, 19, 24, 29. A STRING has its greatest and its present length
// in two bytes before the characters (002:2035-2064). Positions count from 1 (general knowledge). What is not stated is
// any value: lengths and positions beyond the text, results that do not fit, and what stands behind a result.
// Tested by tests/step7/string_functions_test.cpp.
#pragma once

#include "ir/s7300/system_args.hpp"

namespace rungproof {

template <class D>
class StringFunctions {
 public:
  using Bool = typename D::Bool;
  using Bits = typename D::Bits;

  explicit StringFunctions(SystemArgs<D>& args) : a_(args), d_(args.d) {}

  void length() {
    const Text text = read(0);
    a_.set(1, a_.orAny(text.isValid, text.length, 16));
    a_.finish(a_.orAny(text.isValid, a_.yes()));
  }
  void left() { part(0, n(0), number(1), 2, false); }
  void right() { part(0, n(0), number(1), 2, true); }
  void middle() { part(0, d_.sub(number(2), n(1), 16), number(1), 3, false); }

  void concatenate() {
    const Text x = read(0), y = read(1);
    join({{x, n(0), x.length}, {y, n(0), y.length}}, d_.land(x.isValid, y.isValid), 2);
  }
  void cut() {
    const Text x = read(0);
    const Bits count = number(1), first = d_.sub(number(2), n(1), 16), end = d_.add(first, count, 16);
    join({{x, n(0), first}, {x, end, d_.sub(x.length, end, 16)}}, d_.land(x.isValid, lies(first, count, x.length)), 3);
  }
  void insert() {
    const Text x = read(0), y = read(1);
    const Bits at = number(2);
    join({{x, n(0), at}, {y, n(0), y.length}, {x, at, d_.sub(x.length, at, 16)}},
         d_.land(d_.land(x.isValid, y.isValid), d_.ule(at, x.length, 16)), 3);
  }
  void replace() {
    const Text x = read(0), y = read(1);
    const Bits count = number(2), first = d_.sub(number(3), n(1), 16), end = d_.add(first, count, 16);
    join({{x, n(0), first}, {y, n(0), y.length}, {x, end, d_.sub(x.length, end, 16)}},
         d_.land(d_.land(x.isValid, y.isValid), lies(first, count, x.length)), 4);
  }

  void find() {
    const Text x = read(0), y = read(1);
    if (x.chars.size() * y.chars.size() > mostPairs) return unfollowed(2);
    Bits place = n(0);
    for (std::size_t at = x.chars.size(); at-- > 0;) {
      Bool isHere = d_.ule(d_.add(n(at), y.length, 16), x.length, 16);
      for (std::size_t k = 0; k < y.chars.size(); ++k) {
        const Bool isEqual = at + k < x.chars.size() ? d_.equal(x.chars[at + k], y.chars[k], 8) : a_.no();
        isHere = d_.land(isHere, d_.lor(isEqual, d_.ule(y.length, n(k), 16)));
      }
      place = d_.select(isHere, n(at + 1), place, 16);
    }
    const Bool isStated = d_.land(d_.land(x.isValid, y.isValid), d_.lnot(d_.equal(y.length, n(0), 16)));
    a_.set(2, a_.orAny(isStated, place, 16));
    a_.finish(a_.orAny(isStated, a_.yes()));
  }

  /// The first character that differs decides; of two of which one begins the other, the longer one is greater.
  void compare(bool whenEqual, bool whenLess, bool whenGreater) {
    const Text x = read(0), y = read(1);
    const auto constant = [&](bool value) { return d_.constant(value); };
    Bool result = d_.select(d_.equal(x.length, y.length, 16), constant(whenEqual),
                            d_.select(d_.ult(x.length, y.length, 16), constant(whenLess), constant(whenGreater)));
    for (std::size_t k = std::min(x.chars.size(), y.chars.size()); k-- > 0;) {
      const Bool areThere = d_.land(d_.ult(n(k), x.length, 16), d_.ult(n(k), y.length, 16));
      const Bool differ = d_.land(areThere, d_.lnot(d_.equal(x.chars[k], y.chars[k], 8)));
      const Bool isLess = d_.ult(x.chars[k], y.chars[k], 8);
      result = d_.select(differ, d_.select(isLess, constant(whenLess), constant(whenGreater)), result);
    }
    const Bool isStated = d_.land(x.isValid, y.isValid);
    a_.set(2, a_.orAny(isStated, d_.fromBool(result, 1), 1));
    a_.finish(a_.orAny(isStated, a_.yes()));
  }

  /// Any text of any length in the parameter.
  void spoil(std::uint32_t parameter) {
    const Bits most = d_.zext(a_.byteOf(parameter, 0), 8, 16);
    a_.setByte(parameter, 1, a_.any(8));
    eachByte(parameter, most, [&](std::uint32_t k) { return a_.anyOf(k, 8); });
  }

 private:
  static constexpr std::uint32_t longest = 254;
  static constexpr std::size_t mostPairs = 4096;  ///< of characters that are compared or moved one by one

  struct Text {
    std::vector<Bits> chars;  ///< as far as the text can reach
    Bits length;              ///< 16 bits
    Bool isValid;
  };
  struct Piece {
    const Text& text;
    Bits first, count;
  };

  Bits n(std::uint64_t value) { return a_.number(value, 16); }
  Bits number(std::uint32_t parameter) { return a_.value(parameter); }
  /// Whether a part of a text lies inside of it; numbers below 0 do not.
  Bool lies(Bits first, Bits count, Bits length) {
    return d_.land(d_.ule(first, length, 16), d_.ule(count, d_.sub(length, first, 16), 16));
  }

  Text read(std::uint32_t parameter) {
    const Bits most = a_.byteOf(parameter, 0), present = a_.byteOf(parameter, 1);
    Text text{{}, d_.zext(present, 8, 16), d_.land(d_.ule(present, most, 8), d_.ule(most, a_.number(longest, 8), 8))};
    const auto known = d_.known(present), bound = d_.known(most);
    const std::uint64_t count = std::min<std::uint64_t>(known ? *known : bound ? *bound : longest, longest);
    for (std::uint32_t k = 0; k < count; ++k) {
      Bits character = a_.number(0, 8);
      a_.m.when(d_.ult(n(k), text.length, 16), [&] { character = a_.byteOf(parameter, 2 + k); });
      text.chars.push_back(character);
    }
    return text;
  }

  /// Characters from `first` on, or, `fromEnd`, the last ones.
  void part(std::uint32_t source, Bits first, Bits count, std::uint32_t target, bool fromEnd) {
    const Text text = read(source);
    const Bits begin = fromEnd ? d_.sub(text.length, count, 16) : first;
    join({{text, begin, count}}, d_.land(text.isValid, lies(begin, count, text.length)), target);
  }

  Bits at(const Text& text, Bits index) {
    if (const auto known = d_.known(index)) return *known < text.chars.size() ? text.chars[*known] : a_.number(0, 8);
    Bits result = a_.number(0, 8);
    for (std::size_t k = 0; k < text.chars.size(); ++k)
      result = d_.select(d_.equal(index, n(k), 16), text.chars[k], result, 8);
    return result;
  }

  /// Writes the pieces one behind the other.
  void join(const std::vector<Piece>& pieces, Bool isStated, std::uint32_t target) {
    const Bits most = d_.zext(a_.byteOf(target, 0), 8, 16);
    Bits length = n(0);
    for (const Piece& piece : pieces) length = d_.add(length, piece.count, 16);
    isStated = d_.land(isStated, d_.land(d_.ule(length, most, 16), d_.ule(most, n(longest), 16)));
    std::size_t pairs = 0;
    for (const Piece& piece : pieces) pairs += piece.text.chars.size() * piece.text.chars.size();
    if (!d_.known(length) && pairs > 4 * mostPairs) return unfollowed(target);
    std::vector<Bits> result;
    const auto known = d_.known(length), bound = d_.known(most);
    std::uint64_t reach = 0;
    for (const Piece& piece : pieces) reach += piece.text.chars.size();
    reach = std::min<std::uint64_t>(known ? *known : bound ? std::min(*bound, reach) : reach, longest);
    for (std::uint64_t k = 0; k < reach; ++k) {
      Bits character = a_.number(0, 8), begin = n(0);
      for (const Piece& piece : pieces) {
        const Bits inside = d_.sub(n(k), begin, 16);
        const Bool isHere = d_.ult(inside, piece.count, 16);
        if (const auto here = d_.truth(isHere); !here || *here)
          character = d_.select(isHere, at(piece.text, d_.add(piece.first, inside, 16)), character, 8);
        begin = d_.add(begin, piece.count, 16);
      }
      result.push_back(character);
    }
    a_.setByte(target, 1, a_.orAny(isStated, d_.extract(length, 7, 0), 8));
    eachByte(target, most, [&](std::uint32_t k) {
      if (k >= result.size()) return a_.anyOf(k, 8);
      return a_.orAnyOf(k, d_.land(isStated, d_.ult(n(k), length, 16)), result[k], 8);
    });
    a_.finish(a_.orAny(isStated, a_.yes()));
  }

  /// Writes each character that the target has room for.
  template <class Value>
  void eachByte(std::uint32_t target, Bits most, Value&& value) {
    for (std::uint32_t k = 0; k < longest; ++k) {
      const Bool hasRoom = d_.ult(n(k), most, 16);
      if (const auto known = d_.truth(hasRoom); known && !*known) return;
      a_.m.when(hasRoom, [&] { a_.setByte(target, 2 + k, value(k)); });
    }
  }

  /// Texts that are too long to be followed character by character.
  void unfollowed(std::uint32_t target) {
    if (a_.pou.locals[target].type == DataType::String)
      spoil(target);
    else
      a_.set(target, a_.d.unresolved(a_.m, 16));
    a_.finish(a_.anyBit());
  }

  SystemArgs<D>& a_;
  D& d_;
};

}  // namespace rungproof
