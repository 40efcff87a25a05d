// Texts: a byte with the length, then the characters. An operand is the first byte and how many the text takes. What
// lies behind the length means nothing; results leave 0 there. Positions count from 1 and have 32 bits.
#pragma once

#include "ir/iec/isa/iec_group.hpp"

namespace rungproof::isa::iec {

/// The text of the operands `first` (its place) and `first + 1` (its bytes).
template <class D>
struct TextPlace {
  using Bool = typename D::Bool;
  using Bits = typename D::Bits;

  TextPlace(IecArgs<D>& args, std::size_t first)
      : a(args), place(args.operand(first)), most(static_cast<std::uint32_t>(args.number(first + 1)) - 1) {}

  IecArgs<D>& a;
  const Operand& place;
  std::uint32_t most;  ///< characters

  Bits length() {
    const Bits told = a.m.load(place.area, place.offset, Width::Byte);
    const Bits limit = a.literal(most, 8);
    return a.d.select(a.d.ult(limit, told, 8), limit, told, 8);
  }
  Bool has(std::uint32_t i, Bits length) { return a.d.ult(a.literal(i, 8), length, 8); }
  /// All characters, 0 behind the length.
  std::vector<Bits> characters() {
    std::vector<Bits> all;
    const Bits length = this->length();
    for (std::uint32_t i = 0; i < most; ++i) {
      const Bits c = a.m.load(place.area, place.offset + 1 + i, Width::Byte);
      all.push_back(a.d.select(has(i, length), c, a.literal(0, 8), 8));
    }
    return all;
  }
  /// What does not fit is cut off; behind `length` the characters are 0.
  void write(Bits length, const std::vector<Bits>& characters) {
    const Bits limit = a.literal(most, 9);
    const Bits kept = a.d.extract(a.d.select(a.d.ult(limit, length, 9), limit, length, 9), 7, 0);
    a.m.save(place.area, place.offset, Width::Byte, kept);
    for (std::uint32_t i = 0; i < most; ++i) {
      const Bits c = i < characters.size() ? characters[i] : a.literal(0, 8);
      a.m.save(place.area, place.offset + 1 + i, Width::Byte, a.d.select(has(i, kept), c, a.literal(0, 8), 8));
    }
  }
};

/// The characters moved by a computed number of places, up or down; 0 comes in. `by` has 8 bits.
template <class D>
std::vector<typename D::Bits> moved(IecArgs<D>& a, std::vector<typename D::Bits> characters, typename D::Bits by,
                                    bool isUp) {
  const std::size_t count = characters.size();
  for (int stage = 0; stage < 8; ++stage) {
    const auto moves = a.d.bit(by, stage);
    if (a.d.truth(moves) == false) continue;
    const std::size_t distance = std::size_t{1} << stage;
    std::vector<typename D::Bits> next = characters;
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t from = isUp ? i - distance : i + distance;  // beyond the ends: wraps and is not below count
      next[i] = a.d.select(moves, from < count ? characters[from] : a.literal(0, 8), characters[i], 8);
    }
    characters = std::move(next);
  }
  return characters;
}

constexpr OperandDesc textIn(std::string_view name, int count) {
  return in(name, Type::Byte, variable).elements(1, 0).counted(count, 0);
}
constexpr OperandDesc textOut(std::string_view name, int count) {
  return out(name, Type::Byte, variable).elements(1, 0).counted(count, 0);
}

struct CopyText {
  static constexpr Desc desc = withOperands(described("COPY.TEXT", "copy a text", Role::Move),
                                            {textIn("FROM", 1), part("BYTES"), textOut("TO", 3), part("BYTES")});
  template <class D>
  static void run(IecArgs<D>& a) {
    TextPlace<D> from(a, 0), to(a, 2);
    const auto characters = from.characters();
    to.write(a.d.zext(from.length(), 8, 9), characters);
  }
};

/// Less: by the first character that differs; the beginning of a text comes before it.
template <Relation relation, Name mnemonic>
struct CompareText {
  static constexpr Desc desc = [] {
    Desc made = withOperands(described(mnemonic.view(), "compare two texts"),
                             {textIn("LEFT", 1), part("BYTES"), textIn("RIGHT", 3), part("BYTES")});
    made.relation = relation;
    return made;
  }();
  template <class D>
  static void run(IecArgs<D>& a) {
    D& d = a.d;
    TextPlace<D> left(a, 0), right(a, 2);
    auto x = left.characters(), y = right.characters();
    const std::size_t count = std::max(x.size(), y.size());
    x.resize(count, a.literal(0, 8));
    y.resize(count, a.literal(0, 8));
    if constexpr (relation == Relation::Equal) {
      auto isSame = d.equal(left.length(), right.length(), 8);
      for (std::size_t i = 0; i < count; ++i) isSame = d.land(isSame, d.equal(x[i], y[i], 8));
      return a.pushBool(isSame);
    }
    auto isLess = d.ult(left.length(), right.length(), 8);
    for (std::size_t i = count; i-- > 0;) isLess = d.lor(d.ult(x[i], y[i], 8), d.land(d.equal(x[i], y[i], 8), isLess));
    a.pushBool(isLess);
  }
};

struct TextLength {
  static constexpr Desc desc =
      withOperands(described("LEN.TEXT", "push the length of a text, 16 bits"), {textIn("FROM", 1), part("BYTES")});
  template <class D>
  static void run(IecArgs<D>& a) {
    a.push(a.d.zext(TextPlace<D>(a, 0).length(), 8, 16));
  }
};

struct JoinTexts {
  static constexpr Desc desc = withOperands(
      described("CONCAT.TEXT", "one text behind another", Role::Move),
      {textIn("LEFT", 1), part("BYTES"), textIn("RIGHT", 3), part("BYTES"), textOut("TO", 5), part("BYTES")});
  template <class D>
  static void run(IecArgs<D>& a) {
    D& d = a.d;
    TextPlace<D> left(a, 0), right(a, 2), to(a, 4);
    const auto length = left.length();
    auto characters = right.characters(), front = left.characters();
    const auto total = d.add(d.zext(length, 8, 9), d.zext(right.length(), 8, 9), 9);
    characters.resize(to.most, a.literal(0, 8));
    front.resize(std::max<std::size_t>(front.size(), to.most), a.literal(0, 8));
    characters = moved(a, characters, length, true);
    for (std::uint32_t i = 0; i < to.most; ++i)
      characters[i] = d.select(left.has(i, length), front[i], characters[i], 8);
    to.write(total, characters);
  }
};

/// Pops the position and how many: characters from there on, as many as there are. A count below 0 or a position below
/// 1 gives the empty text.
struct MiddleOfText {
  static constexpr Desc desc =
      withOperands(described("MID.TEXT", "pop position and count, cut a part out of a text", Role::Move),
                   {textIn("FROM", 1), part("BYTES"), textOut("TO", 3), part("BYTES")});
  template <class D>
  static void run(IecArgs<D>& a) {
    D& d = a.d;
    const auto position = a.pop(), count = a.pop();
    TextPlace<D> from(a, 0), to(a, 2);
    const auto zero = a.literal(0, 32);
    const auto length = d.zext(from.length(), 8, 32);
    const auto skipped = d.sub(position, a.literal(1, 32), 32);
    const auto isEmpty = d.lor(d.lor(d.slt(count, zero, 32), d.slt(skipped, zero, 32)), d.sle(length, skipped, 32));
    const auto rest = d.sub(length, skipped, 32);
    const auto taken = d.select(isEmpty, zero, d.select(d.slt(count, rest, 32), count, rest, 32), 32);
    const auto characters = moved(a, from.characters(), d.extract(skipped, 7, 0), false);
    to.write(d.extract(taken, 8, 0), characters);
  }
};

/// The position of the first place at which the second text stands in the first, or 0; an empty one stands nowhere.
struct FindText {
  static constexpr Desc desc = withOperands(described("FIND.TEXT", "push where a text stands in another, 16 bits"),
                                            {textIn("IN", 1), part("BYTES"), textIn("WHAT", 3), part("BYTES")});
  template <class D>
  static void run(IecArgs<D>& a) {
    D& d = a.d;
    TextPlace<D> whole(a, 0), what(a, 2);
    const auto x = whole.characters(), y = what.characters();
    const auto length = what.length();
    auto found = a.literal(0, 16);
    for (std::size_t at = x.size(); at-- > 0;) {
      const auto end = d.add(d.zext(length, 8, 9), a.literal(at, 9), 9);
      auto isHere = d.ule(end, d.zext(whole.length(), 8, 9), 9);
      for (std::size_t i = 0; i < y.size() && d.truth(isHere) != false; ++i) {
        const auto isEqual = at + i < x.size() ? d.equal(x[at + i], y[i], 8) : d.constant(false);
        isHere = d.land(isHere, d.lor(d.lnot(what.has(static_cast<std::uint32_t>(i), length)), isEqual));
      }
      found = d.select(isHere, a.literal(at + 1, 16), found, 16);
    }
    a.push(d.select(d.equal(length, a.literal(0, 8), 8), a.literal(0, 16), found, 16));
  }
};

using TextGroup = Group<CopyText, CompareText<Relation::Equal, "EQ.TEXT">, CompareText<Relation::Less, "LT.TEXT">,
                        TextLength, JoinTexts, MiddleOfText, FindText>;

}  // namespace rungproof::isa::iec
