// Compare contacts: 72 numeric ones and 6 for strings (001:3362-3431). They run without power
// flow, and a bad pointer, an illegal REAL or a string outside its area stops the CPU (001:3384-3391, 001:3417-3419).
// Bytes compare unsigned; INT, DINT and REAL signed (001:3371-3374). Tests: tests/manual/compare_test.cpp.
#pragma once

#include <algorithm>

#include "ir/s7200/isa/contact.hpp"

namespace rungproof::isa {

constexpr std::string_view symbolOf(Relation r) {
  constexpr std::string_view symbols[] = {"", "<", "<=", "=", ">=", ">", "<>"};
  return symbols[static_cast<std::size_t>(r)];
}
constexpr std::string_view prefixOf(Role j, bool german) {
  return j == Role::Load ? "LD" : j == Role::Or ? "O" : german ? "U" : "A";
}
constexpr std::string_view effectOf(Role j) {
  return j == Role::Load  ? "load the result"
         : j == Role::And ? "AND the result with the top of stack"
                          : "OR the result with the top of stack";
}

/// A text put together at compile time, for names of families.
struct JoinedText {
  std::array<char, 96> characters{};
  std::size_t length = 0;
  constexpr JoinedText(std::initializer_list<std::string_view> parts) {
    for (const std::string_view part : parts) {
      for (const char c : part) characters[length++] = c;
    }
  }
  constexpr std::string_view view() const { return {characters.data(), length}; }
};

/// "==I", ">=D": the relation between the rails of a ladder, with the letter of the box (001:2206).
constexpr JoinedText signOf(Relation relation, std::string_view letter) {
  return {relation == Relation::Equal ? "==" : symbolOf(relation), letter};
}

constexpr std::string_view letterOf(Type type) {
  return type == Type::Byte ? "B" : type == Type::Int ? "W" : type == Type::DInt ? "D" : type == Type::Real ? "R" : "S";
}

template <Role joint, Type type, Relation relation, std::uint16_t time>
struct Compare {
  static constexpr JoinedText stl{prefixOf(joint, false), letterOf(type), symbolOf(relation)};
  static constexpr JoinedText german{prefixOf(joint, true), letterOf(type), symbolOf(relation)};
  static constexpr JoinedText family{prefixOf(joint, false), letterOf(type), "x"};
  static constexpr JoinedText meaning{type == Type::Byte   ? "compare bytes (unsigned)"
                                      : type == Type::Int  ? "compare integers (words)"
                                      : type == Type::DInt ? "compare double words"
                                                           : "compare reals",
                                      ": IN1 ", symbolOf(relation), " IN2, ", effectOf(joint)};
  static constexpr JoinedText sign = signOf(relation, type == Type::Int ? "I" : letterOf(type));
  static constexpr Forms forms = type == Type::Byte   ? form::byteIn
                                 : type == Type::Int  ? form::wordIn
                                 : type == Type::DInt ? form::dwordIn
                                                      : form::realIn;
  static constexpr Desc desc = withOperands({.stl = stl.view(),
                                             .german = german.view(),
                                             .family = family.view(),
                                             .meaning = meaning.view(),
                                             .group = "boolean / compare",
                                             .role = joint,
                                             .relation = relation,
                                             .drawn = sign.view(),
                                             .execution = Execution::Compare,
                                             .stack = stackOf(joint),
                                             .time = time,
                                             .manual = "001:3371"},
                                            {in("IN1", type, forms), in("IN2", type, forms)});

  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    D& d = m.d;
    const auto x = a.value(0), y = a.value(1);
    const auto less = [&](const auto& p, const auto& q) {
      if constexpr (type == Type::Real) {
        return d.rless(p, q);
      } else if constexpr (type == Type::Byte) {
        return d.ult(p, q, 8);
      } else {
        return d.slt(p, q, bits(widthOf(type)));
      }
    };
    const auto equal = [&] {
      if constexpr (type == Type::Real) {
        return d.requal(x, y);
      } else {
        return d.equal(x, y, bits(widthOf(type)));
      }
    };
    if constexpr (type == Type::Real) {
      const auto isLegal = d.land(d.rlegal(x), d.rlegal(y));
      m.hazard(m.features.stopsInCompare ? Hazard::FatalReal : Hazard::BadCompareNumber, d.lnot(isLegal));
    }
    auto result = d.constant(false);
    if constexpr (relation == Relation::Less) result = less(x, y);
    if constexpr (relation == Relation::LessEqual) result = d.lor(less(x, y), equal());
    if constexpr (relation == Relation::Equal) result = equal();
    if constexpr (relation == Relation::GreaterEqual) result = d.lor(less(y, x), equal());
    if constexpr (relation == Relation::Greater) result = less(y, x);
    if constexpr (relation == Relation::NotEqual) result = d.lnot(equal());
    if constexpr (type == Type::Real) {
      if (!m.features.stopsInCompare) result = d.land(result, d.land(d.rlegal(x), d.rlegal(y)));
    }
    join<joint>(m, result);
  }
  /// The contact of a CPU that goes on after an illegal pointer.
  template <class D>
  static void fails(Machine<D>& m) {
    join<joint>(m, m.d.constant(false));
  }
};

/// LDS=, AS<> and so on: equal length and equal bytes. A constant may stand first only (001:3429-3430).
template <Role joint, Relation relation>
struct CompareString {
  /// Characters that can stand behind the length byte of operand i.
  template <class D>
  static int roomAfterLength(Args<D>& a, std::size_t i) {
    return std::max(a.room(i, Width::Byte, 255) - 1, 0);
  }

  static constexpr JoinedText stl{prefixOf(joint, false), "S", symbolOf(relation)};
  static constexpr JoinedText german{prefixOf(joint, true), "S", symbolOf(relation)};
  static constexpr JoinedText family{prefixOf(joint, false), "Sx"};
  static constexpr JoinedText meaning{"compare strings: IN1 ", symbolOf(relation), " IN2, ", effectOf(joint)};
  static constexpr JoinedText sign = signOf(relation, "S");
  static constexpr Desc desc =
      withOperands({.stl = stl.view(),
                    .german = german.view(),
                    .family = family.view(),
                    .meaning = meaning.view(),
                    .group = "boolean / compare",
                    .role = joint,
                    .relation = relation,
                    .drawn = sign.view(),
                    .execution = Execution::Compare,
                    .stack = stackOf(joint),
                    .time = 3300,
                    .manual = "001:3405"},
                   {in("IN1", Type::String, form::stringIn), in("IN2", Type::String, form::stringOut)});

  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    D& d = m.d;
    const auto length = a.byteAt(0, 0), other = a.byteAt(1, 0);
    auto outside = d.constant(false);
    for (std::size_t i = 0; i < 2; ++i) {
      const auto total = d.add(d.zext(i == 0 ? length : other, 8, 16), m.number(1, 16), 16);
      outside = d.lor(outside, d.lor(d.ult(m.number(255, 16), total, 16), d.lnot(a.fits(i, total, Width::Byte))));
    }
    m.hazard(m.features.stopsInCompare ? Hazard::FatalRange : Hazard::OutOfRange, outside);
    auto equal = d.equal(length, other, 8);
    const auto known = d.known(length) ? d.known(length) : d.known(other);
    const int limit = std::min({known ? static_cast<int>(*known) : 254, roomAfterLength(a, 0), roomAfterLength(a, 1)});
    for (int k = 0; k < limit; ++k) {
      if (const auto truth = d.truth(equal); truth && !*truth) break;
      const auto beyond = d.ule(length, m.number(static_cast<std::uint64_t>(k), 8), 8);
      equal = d.land(equal, d.lor(beyond, d.equal(a.byteAt(0, k + 1), a.byteAt(1, k + 1), 8)));
    }
    const auto result = relation == Relation::Equal ? equal : d.lnot(equal);
    join<joint>(m, m.features.stopsInCompare ? result : d.land(d.lnot(outside), result));
  }
  template <class D>
  static void fails(Machine<D>& m) {
    join<joint>(m, m.d.constant(false));
  }
};

template <Role j, Type t, std::uint16_t time>
using CompareFamily = Group<Compare<j, t, Relation::Less, time>, Compare<j, t, Relation::LessEqual, time>,
                            Compare<j, t, Relation::Equal, time>, Compare<j, t, Relation::GreaterEqual, time>,
                            Compare<j, t, Relation::Greater, time>, Compare<j, t, Relation::NotEqual, time>>;
template <Role j>
using CompareStringFamily = Group<CompareString<j, Relation::Equal>, CompareString<j, Relation::NotEqual>>;

using CompareGroup =
    Join<CompareFamily<Role::Load, Type::Byte, 1800>, CompareFamily<Role::And, Type::Byte, 1800>,
         CompareFamily<Role::Or, Type::Byte, 1800>, CompareFamily<Role::Load, Type::Int, 2400>,
         CompareFamily<Role::And, Type::Int, 2300>, CompareFamily<Role::Or, Type::Int, 2400>,
         CompareFamily<Role::Load, Type::DInt, 2700>, CompareFamily<Role::And, Type::DInt, 2700>,
         CompareFamily<Role::Or, Type::DInt, 2600>, CompareFamily<Role::Load, Type::Real, 2900>,
         CompareFamily<Role::And, Type::Real, 2900>, CompareFamily<Role::Or, Type::Real, 2900>,
         CompareStringFamily<Role::Load>, CompareStringFamily<Role::And>, CompareStringFamily<Role::Or>>::type;

}  // namespace rungproof::isa
