// The operands of an instruction: a row in one piece of memory that is just as long as they need, by a pointer of eight
// bytes. A program has as many such rows as instructions, and nearly all are short: their number stands in the pointer.
// Tested by tests/ir/short_text_test.cpp.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <memory>
#include <new>
#include <utility>

#include "ir/operand.hpp"

namespace rungproof {

class Operands {
 public:
  using value_type = Operand;
  using iterator = Operand*;
  using const_iterator = const Operand*;
  using reference = Operand&;
  using const_reference = const Operand&;
  using size_type = std::size_t;
  using difference_type = std::ptrdiff_t;

  Operands() = default;
  explicit Operands(std::size_t count) { resize(count); }
  Operands(std::initializer_list<Operand> list) : Operands(list.begin(), list.end()) {}
  template <std::input_iterator It>
  Operands(It first, It last) {
    assign(first, last);
  }
  Operands(const Operands& other) : Operands(other.begin(), other.end()) {}
  Operands(Operands&& other) noexcept : row_(std::exchange(other.row_, 0)) {}
  Operands& operator=(Operands other) noexcept {
    std::swap(row_, other.row_);
    return *this;
  }
  ~Operands() {
    if (row_ != 0) free();
  }

  std::size_t size() const {
    const std::size_t few = row_ & fewBits;
    return isLong() ? head()->size : few;
  }
  bool empty() const { return size() == 0; }
  Operand* data() { return reinterpret_cast<Operand*>(row_ & ~fewBits); }
  const Operand* data() const { return reinterpret_cast<const Operand*>(row_ & ~fewBits); }
  Operand* begin() { return data(); }
  Operand* end() { return data() + size(); }
  const Operand* begin() const { return data(); }
  const Operand* end() const { return data() + size(); }
  auto rbegin() const { return std::make_reverse_iterator(end()); }
  auto rend() const { return std::make_reverse_iterator(begin()); }
  Operand& operator[](std::size_t i) { return data()[i]; }
  const Operand& operator[](std::size_t i) const { return data()[i]; }
  Operand& front() { return data()[0]; }
  const Operand& front() const { return data()[0]; }
  Operand& back() { return data()[size() - 1]; }
  const Operand& back() const { return data()[size() - 1]; }

  template <class... Args>
  Operand& emplace_back(Args&&... args) {
    Operand made{std::forward<Args>(args)...};
    return *new (stretch(size() + 1)) Operand(std::move(made));
  }
  void push_back(Operand operand) { emplace_back(std::move(operand)); }
  void pop_back() {
    std::destroy_at(&back());
    if (isLong()) {
      --head()->size;
    } else if (--row_; (row_ & fewBits) == 0) {
      ::operator delete(reinterpret_cast<void*>(std::exchange(row_, 0)));
    }
  }
  void clear() {
    if (row_ != 0) free();
    row_ = 0;
  }
  void resize(std::size_t count) {
    while (size() > count) pop_back();
    if (const std::size_t old = size(); old < count) std::uninitialized_value_construct_n(stretch(count), count - old);
  }
  template <std::input_iterator It>
  void assign(It first, It last) {
    clear();
    if constexpr (std::forward_iterator<It>) {
      if (first != last)
        std::uninitialized_copy(first, last, stretch(static_cast<std::size_t>(std::distance(first, last))));
    } else {
      for (; first != last; ++first) push_back(*first);
    }
  }
  Operand* erase(const Operand* at) { return erase(at, at + 1); }
  Operand* erase(const Operand* from, const Operand* to) {
    const std::ptrdiff_t place = from - begin();
    Operand* const rest = from == to ? end() : std::move(begin() + (to - begin()), end(), begin() + place);
    for (std::ptrdiff_t gone = end() - rest; gone > 0; --gone) pop_back();
    return begin() + place;
  }
  Operand* insert(const Operand* at, Operand operand) {
    const std::ptrdiff_t place = at - begin();
    push_back(std::move(operand));
    std::rotate(begin() + place, end() - 1, end());
    return begin() + place;
  }
  template <std::input_iterator It>
  Operand* insert(const Operand* at, It first, It last) {
    const std::ptrdiff_t place = at - begin(), old = static_cast<std::ptrdiff_t>(size());
    for (; first != last; ++first) push_back(*first);
    std::rotate(begin() + place, begin() + old, end());
    return begin() + place;
  }

 private:
  /// In front of the operands of a long row.
  struct alignas(__STDCPP_DEFAULT_NEW_ALIGNMENT__) Head {
    std::size_t size, capacity;
  };
  /// The bits that are 0 in every address of the allocator's: the number of operands of a short row, 0 for a long one.
  static constexpr std::uintptr_t fewBits = __STDCPP_DEFAULT_NEW_ALIGNMENT__ - 1;
  static_assert(alignof(Operand) <= alignof(Head));

  bool isLong() const { return row_ != 0 && (row_ & fewBits) == 0; }
  Head* head() const { return reinterpret_cast<Head*>(row_) - 1; }
  /// Makes the row so long. Gives the first of the new places, in which operands have to be made at once. Short rows
  /// have no room to spare: most are made in one go.
  Operand* stretch(std::size_t count) {
    const std::size_t old = size();
    if (isLong() && count <= head()->capacity) {
      head()->size = count;
      return data() + old;
    }
    void* room = nullptr;
    if (count <= fewBits) {
      room = ::operator new(count * sizeof(Operand));
    } else {
      const std::size_t capacity = std::max(count, 2 * old);
      room = new (::operator new(sizeof(Head) + capacity * sizeof(Operand))) Head{count, capacity} + 1;
    }
    auto* const first = static_cast<Operand*>(room);
    std::uninitialized_move_n(data(), old, first);
    if (row_ != 0) free();
    row_ = reinterpret_cast<std::uintptr_t>(first) | (count <= fewBits ? count : 0);
    return first + old;
  }
  void free() {
    std::destroy(begin(), end());
    ::operator delete(isLong() ? static_cast<void*>(head()) : data());
  }

  std::uintptr_t row_ = 0;  ///< address of the operands, and in `fewBits` their number
};

}  // namespace rungproof
