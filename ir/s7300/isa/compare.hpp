// Comparisons of ACCU2 with ACCU1 (002:2745-2752). They end no logic string and take no RLO into account. The flags of
// REAL comparisons with a value that is no number: general knowledge.
#pragma once

#include "ir/s7300/isa/load.hpp"

namespace rungproof::isa::step7 {

template <class D>
typename D::Bool relates(D& d, Relation relation, typename D::Bool less, typename D::Bool equal,
                         typename D::Bool greater) {
  switch (relation) {
    case Relation::Less: return less;
    case Relation::LessEqual: return d.lor(less, equal);
    case Relation::Equal: return equal;
    case Relation::GreaterEqual: return d.lor(greater, equal);
    case Relation::Greater: return greater;
    default: return d.lor(less, greater);
  }
}

/// CC1, CC0 and the bits of the logic string.
template <class D>
void endComparison(Step7Args<D>& a, typename D::Bool rlo) {
  a.setBit(a.s.rlo, rlo);
  a.setBit(a.s.sta, rlo);
  a.setBit(a.s.orBit, a.no());
  a.setBit(a.s.firstCheck, a.yes());
}

/// w: 16 for INT, 32 for DINT.
template <Relation relation, int w, Name stlName>
struct CompareIntegers {
  static constexpr Desc desc = accuDesc(stlName.view(), {}, "compare ACCU2 with ACCU1", "comparison", "002:2745");
  template <class D>
  static void run(Step7Args<D>& a) {
    const auto x = w == 16 ? a.low2() : a.accu2(), y = w == 16 ? a.low1() : a.accu1();
    const auto less = a.d.slt(x, y, w), greater = a.d.slt(y, x, w), equal = a.d.equal(x, y, w);
    a.setConditions(greater, less);
    a.setBit(a.s.ov, a.no());
    endComparison(a, relates(a.d, relation, less, equal, greater));
  }
};

template <Relation relation, Name stlName>
struct CompareReals {
  static constexpr Desc desc = accuDesc(stlName.view(), {}, "compare ACCU2 with ACCU1", "comparison", "002:651");
  template <class D>
  static void run(Step7Args<D>& a) {
    D& d = a.d;
    const auto x = a.accu2(), y = a.accu1();
    const auto isNan = [&](const auto& v) {
      return d.ult(a.number(0x7F800000), d.band(v, a.number(0x7FFFFFFF), 32), 32);
    };
    const auto unordered = d.lor(isNan(x), isNan(y)), ordered = d.lnot(unordered);
    const auto less = d.land(ordered, d.rless(x, y)), greater = d.land(ordered, d.rless(y, x)),
               equal = d.land(ordered, d.requal(x, y));
    a.setConditions(d.lor(unordered, greater), d.lor(unordered, less));
    a.setOverflow(unordered);
    endComparison(a, relates(d, relation, less, equal, greater));
  }
};

using Step7CompareGroup =
    Group<CompareIntegers<Relation::Equal, 16, "==I">, CompareIntegers<Relation::Equal, 32, "==D">,
          CompareIntegers<Relation::NotEqual, 16, "<>I">, CompareIntegers<Relation::NotEqual, 32, "<>D">,
          CompareIntegers<Relation::Greater, 16, ">I">, CompareIntegers<Relation::Greater, 32, ">D">,
          CompareIntegers<Relation::GreaterEqual, 16, ">=I">, CompareIntegers<Relation::GreaterEqual, 32, ">=D">,
          CompareIntegers<Relation::Less, 16, "<I">, CompareIntegers<Relation::Less, 32, "<D">,
          CompareIntegers<Relation::LessEqual, 16, "<=I">, CompareIntegers<Relation::LessEqual, 32, "<=D">,
          CompareReals<Relation::Equal, "==R">, CompareReals<Relation::NotEqual, "<>R">,
          CompareReals<Relation::Greater, ">R">, CompareReals<Relation::GreaterEqual, ">=R">,
          CompareReals<Relation::Less, "<R">, CompareReals<Relation::LessEqual, "<=R">>;

}  // namespace rungproof::isa::step7
