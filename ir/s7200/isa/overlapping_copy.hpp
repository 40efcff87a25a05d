// Copies of several elements onto themselves: the manual does not say whether each element is written before the next
// is read (Choice::BlockMoveOverlap). Used by block moves and string copies. Tests: tests/manual/move_test.cpp,
// tests/manual/string_test.cpp.
#pragma once

#include <vector>

#include "ir/s7200/isa/group.hpp"

namespace rungproof::isa {

template <class D>
class OverlappingCopy {
 public:
  using Bits = typename D::Bits;

  /// Of at most `limit` elements of `width` bits; without overlap both readings are the same.
  OverlappingCopy(Machine<D>& machine, bool mayOverlap, int limit, int width)
      : m_(machine),
        width_(width),
        buffered_(mayOverlap ? machine.reads({Choice::BlockMoveOverlap, "buffered"}) : machine.d.constant(false)),
        buffer_(static_cast<std::size_t>(limit), machine.number(0, width)) {}

  /// Reads all `count` (width 16) elements where they are read before the first is written; element(k) reads one.
  template <class Element>
  void begin(Bits count, Element&& element) {
    if (m_.d.truth(buffered_) == std::optional(false)) return;
    m_.repeat(count, 16, static_cast<int>(buffer_.size()),
              [&](int k) { buffer_[static_cast<std::size_t>(k)] = element(k); });
  }
  /// Element k as it is to be written.
  template <class Element>
  Bits value(int k, Element&& element) {
    const std::optional<bool> known = m_.d.truth(buffered_);
    const Bits before = buffer_[static_cast<std::size_t>(k)];
    if (known) return *known ? before : element(k);
    return m_.d.select(buffered_, before, element(k), width_);
  }

 private:
  Machine<D>& m_;
  int width_;
  typename D::Bool buffered_;
  std::vector<Bits> buffer_;
};

}  // namespace rungproof::isa
