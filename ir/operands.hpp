// The operands of an instruction: a row in one piece of memory that is just as long as they need, by a pointer of eight
// bytes. A program has as many such rows as instructions. Tested by tests/ir/short_text_test.cpp.
#pragma once

#include <algorithm>
#include <cstddef>
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
  Operands(Operands&& other) noexcept : first_(std::exchange(other.first_, nullptr)) {}
  Operands& operator=(Operands other) noexcept {
    std::swap(first_, other.first_);
    return *this;
  }
  ~Operands() {
    if (first_ != nullptr) free();
  }

  std::size_t size() const { return first_ == nullptr ? 0 : head()->size; }
  bool empty() const { return size() == 0; }
  std::size_t capacity() const { return first_ == nullptr ? 0 : head()->capacity; }
  Operand* data() { return first_; }
  const Operand* data() const { return first_; }
  Operand* begin() { return first_; }
  Operand* end() { return first_ + size(); }
  const Operand* begin() const { return first_; }
  const Operand* end() const { return first_ + size(); }
  auto rbegin() const { return std::make_reverse_iterator(end()); }
  auto rend() const { return std::make_reverse_iterator(begin()); }
  Operand& operator[](std::size_t i) { return first_[i]; }
  const Operand& operator[](std::size_t i) const { return first_[i]; }
  Operand& front() { return first_[0]; }
  const Operand& front() const { return first_[0]; }
  Operand& back() { return first_[size() - 1]; }
  const Operand& back() const { return first_[size() - 1]; }

  /// Room for exactly so many, if there is less.
  void reserve(std::size_t count) {
    if (count > capacity()) move(count);
  }
  template <class... Args>
  Operand& emplace_back(Args&&... args) {
    Operand made{std::forward<Args>(args)...};
    if (size() == capacity()) move(size() + std::max<std::size_t>(size(), 1));
    return *new (first_ + head()->size++) Operand(std::move(made));
  }
  void push_back(Operand operand) { emplace_back(std::move(operand)); }
  void pop_back() { std::destroy_at(first_ + --head()->size); }
  void clear() {
    if (first_ == nullptr) return;
    std::destroy(begin(), end());
    head()->size = 0;
  }
  void resize(std::size_t count) {
    reserve(count);
    while (size() > count) pop_back();
    while (size() < count) new (first_ + head()->size++) Operand();
  }
  template <std::input_iterator It>
  void assign(It first, It last) {
    clear();
    if constexpr (std::forward_iterator<It>) reserve(static_cast<std::size_t>(std::distance(first, last)));
    for (; first != last; ++first) push_back(*first);
  }
  Operand* erase(const Operand* at) { return erase(at, at + 1); }
  Operand* erase(const Operand* from, const Operand* to) {
    Operand* const gap = first_ + (from - first_);
    if (from == to) return gap;
    Operand* const rest = std::move(first_ + (to - first_), end(), gap);
    while (end() != rest) pop_back();
    return gap;
  }
  Operand* insert(const Operand* at, Operand operand) {
    const std::ptrdiff_t place = at - first_;
    push_back(std::move(operand));
    std::rotate(first_ + place, end() - 1, end());
    return first_ + place;
  }
  template <std::input_iterator It>
  Operand* insert(const Operand* at, It first, It last) {
    const std::ptrdiff_t place = at - first_, old = static_cast<std::ptrdiff_t>(size());
    for (; first != last; ++first) push_back(*first);
    std::rotate(first_ + place, first_ + old, end());
    return first_ + place;
  }

 private:
  struct Head {
    std::uint32_t size, capacity;
  };
  static_assert(sizeof(Head) % alignof(Operand) == 0);

  Head* head() const { return reinterpret_cast<Head*>(first_) - 1; }
  void move(std::size_t capacity) {
    auto* head = static_cast<Head*>(::operator new(sizeof(Head) + capacity * sizeof(Operand)));
    auto* first = reinterpret_cast<Operand*>(head + 1);
    *head = {static_cast<std::uint32_t>(size()), static_cast<std::uint32_t>(capacity)};
    std::uninitialized_move(begin(), end(), first);
    if (first_ != nullptr) free();
    first_ = first;
  }
  void free() {
    std::destroy(begin(), end());
    ::operator delete(head());
  }

  Operand* first_ = nullptr;
};

}  // namespace rungproof
