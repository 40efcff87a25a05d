// Tables: ATT LIFO FIFO FILL FND (001:6256-6511). A table of words: +0 TL, the most entries; +1 EC,
// the entries there are; +2 the entries, at most 100. FND gets its TBL one word further, at EC (001:6441).
// Clearing of SM1.4 and SM1.5 by a success is not stated and assumed. Tests: tests/manual/table_test.cpp.
#pragma once

#include "ir/s7200/isa/move.hpp"

namespace rungproof::isa {

inline constexpr int tableEntries = 100;  // 001:6260
inline constexpr int firstEntry = 2;

/// Number of words of a table with `entries` entries, width 16.
template <class D>
typename D::Bits tableWords(Machine<D>& m, typename D::Bits entries, int head) {
  return m.d.add(entries, m.number(static_cast<std::uint64_t>(head), 16), 16);
}
/// Whether a table with that many entries exists: at most 100, all inside the area (0091).
template <class D>
typename D::Bool tableExists(Machine<D>& m, Args<D>& a, std::size_t table, typename D::Bits entries, int head) {
  return m.d.land(m.d.ule(entries, m.number(tableEntries, 16), 16),
                  a.fits(table, tableWords(m, entries, head), Width::Word));
}

/// ATT DATA, TBL: appends a value; a full table takes nothing and sets SM1.4.
struct AddToTable {
  static constexpr Desc desc =
      withOperands({.stl = "ATT",
                    .meaning = "add a value to a table",
                    .group = "table, find, conversion",
                    .role = Role::Att,
                    .drawn = "AD_T_TBL",
                    .stack = {1, 0, 0},
                    .eno = true,
                    .affects = status::TableFull,
                    .time = 3600,
                    .manual = "001:6260"},
                   {in("DATA", Type::Int, form::wordIn),
                    inout("TBL", Type::Word, wordBuffer).elements(2, firstEntry + tableEntries)});
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    D& d = m.d;
    const auto data = a.value(0);
    const auto count = a.element(1, 1, Width::Word);
    const auto full = d.ule(a.element(1, 0, Width::Word), count, 16);
    m.hazard(Hazard::TableFull, full);
    m.flag(status::TableFull, full);
    m.when(d.lnot(full), [&] {
      const auto entries = d.add(count, m.number(1, 16), 16);
      const auto exists = tableExists(m, a, 1, entries, firstEntry);
      m.hazard(Hazard::OutOfRange, d.lnot(exists));
      m.when(exists, [&] {
        a.storeElementAt(1, tableWords(m, count, firstEntry), tableEntries + firstEntry, Width::Word, data);
        a.storeElement(1, 1, Width::Word, entries);
      });
    });
  }
};

/// LIFO, FIFO TBL, DATA: take the newest or the oldest entry; an empty table sets SM1.5. FIFO moves the rest up.
template <bool oldest, Name stlName, Name meaning, std::uint32_t time>
struct TakeFromTable {
  static constexpr Desc desc =
      withOperands({.stl = stlName.view(),
                    .meaning = meaning.view(),
                    .group = "table, find, conversion",
                    .role = oldest ? Role::Fifo : Role::Lifo,
                    .stack = {1, 0, 0},
                    .eno = true,
                    .affects = status::TableEmpty,
                    .time = time,
                    .manual = "001:6314"},
                   {inout("TBL", Type::Word, wordBuffer).elements(2, firstEntry + tableEntries),
                    out("DATA", Type::Int, form::wordOut | form::AQ)});
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    D& d = m.d;
    const auto count = a.element(0, 1, Width::Word);
    const auto empty = d.equal(count, m.number(0, 16), 16);
    m.hazard(Hazard::TableEmpty, empty);
    m.flag(status::TableEmpty, empty);
    m.when(d.lnot(empty), [&] {
      const auto exists = tableExists(m, a, 0, count, firstEntry);
      m.hazard(Hazard::OutOfRange, d.lnot(exists));
      m.when(exists, [&] { take(m, a, d.sub(count, m.number(1, 16), 16)); });
    });
  }

 private:
  template <class D>
  static void take(Machine<D>& m, Args<D>& a, typename D::Bits left) {
    const int room = a.room(0, Width::Word, tableEntries + firstEntry);
    const auto data = oldest ? a.element(0, firstEntry, Width::Word)
                             : a.elementAt(0, tableWords(m, left, firstEntry), room, Width::Word);
    if constexpr (oldest) {
      m.repeat(left, 16, room - firstEntry - 1, [&](int k) {
        a.storeElement(0, firstEntry + k, Width::Word, a.element(0, firstEntry + k + 1, Width::Word));
      });
    }
    a.storeElement(0, 1, Width::Word, left);
    a.store(1, data);
  }
};

/// FILL IN, OUT, N: N words become IN (001:6383).
struct Fill {
  static constexpr Desc desc = withOperands(
      {.stl = "FILL",
       .meaning = "fill N words with a value",
       .group = "table, find, conversion",
       .role = Role::Fill,
       .drawn = "FILL_N",
       .stack = {1, 0, 0},
       .eno = true,
       .time = 1500,
       .manual = "001:6383"},
      {in("IN", Type::Int, form::wordIn), out("OUT", Type::Int, wordBuffer | form::AQ).elements(1, 0).counted(2, 255),
       in("N", Type::Byte, form::byteIn).within({{1, 255, everyCpu}})});
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    const auto value = a.value(0);
    const auto n = m.d.zext(a.value(2), 8, 16);
    const int room = a.room(1, Width::Word, 255);
    const auto count = legalCount(m, n, a.fits(1, n, Width::Word), room);
    m.repeat(count, 16, room, [&](int k) { a.storeElement(1, k, Width::Word, value); });
  }
};

/// FND TBL, PTN, INDX: first entry from INDX on with the relation to PTN, signed; otherwise INDX becomes EC
/// (001:6416-6418). An INDX above EC stays; the manual is silent.
template <Relation relation, Name stlName, Name boxName, Name meaning>
struct Find {
  static constexpr Desc desc =
      withOperands({.stl = stlName.view(),
                    .family = "FNDx",
                    .meaning = meaning.view(),
                    .group = "table, find, conversion",
                    .role = Role::Find,
                    .relation = relation,
                    .drawn = boxName.view(),
                    .stack = {1, 0, 0},
                    .eno = true,
                    .time = 3900,
                    .manual = "001:6416"},
                   {in("TBL", Type::Word, wordBuffer & ~form::S).elements(1, 1 + tableEntries),
                    in("PTN", Type::Int, form::wordIn), inout("INDX", Type::Word, form::wordOut)});
  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    D& d = m.d;
    const auto pattern = a.value(1), start = a.value(2);
    const auto count = a.element(0, 0, Width::Word);
    const auto exists = tableExists(m, a, 0, count, 1);
    m.hazard(Hazard::OutOfRange, d.lnot(exists));
    auto found = d.constant(false);
    auto index = d.select(d.ult(count, start, 16), start, count, 16);
    m.when(exists, [&] {
      m.repeat(count, 16, a.room(0, Width::Word, tableEntries + 1) - 1, [&](int k) {
        const auto here = m.number(static_cast<std::uint64_t>(k), 16);
        const auto inRange = d.land(d.ule(start, here, 16), d.ult(here, count, 16));
        const auto hit = d.land(d.land(d.lnot(found), inRange), holds(d, a.element(0, 1 + k, Width::Word), pattern));
        index = d.select(hit, here, index, 16);
        found = d.lor(found, hit);
      });
      a.store(2, index);
    });
  }

 private:
  template <class D>
  static typename D::Bool holds(D& d, typename D::Bits entry, typename D::Bits pattern) {
    if constexpr (relation == Relation::Equal) return d.equal(entry, pattern, 16);
    if constexpr (relation == Relation::NotEqual) return d.lnot(d.equal(entry, pattern, 16));
    if constexpr (relation == Relation::Less) return d.slt(entry, pattern, 16);
    if constexpr (relation == Relation::Greater) return d.slt(pattern, entry, 16);
  }
};

using LastIn = TakeFromTable<false, "LIFO", "take the newest entry from a table", 3700>;
using FirstIn = TakeFromTable<true, "FIFO", "take the oldest entry from a table", 3000>;
using FindEqual = Find<Relation::Equal, "FND=", "TBL_FIND =", "find an entry equal to the pattern">;
using FindNotEqual = Find<Relation::NotEqual, "FND<>", "TBL_FIND <>", "find an entry not equal to the pattern">;
using FindLess = Find<Relation::Less, "FND<", "TBL_FIND <", "find an entry below the pattern">;
using FindGreater = Find<Relation::Greater, "FND>", "TBL_FIND >", "find an entry above the pattern">;

using TableGroup = Group<AddToTable, LastIn, FirstIn, Fill, FindEqual, FindNotEqual, FindLess, FindGreater>;

}  // namespace rungproof::isa
