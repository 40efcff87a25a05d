// A value that copies share and nobody changes, by a pointer of eight bytes; null if there is none. Tested by
// tests/ir/short_text_test.cpp.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace rungproof {

template <class T>
class Shared {
 public:
  Shared() = default;
  Shared(std::nullptr_t) {}
  explicit Shared(T value) : block_(new Block{std::move(value)}) {}
  Shared(const Shared& other) : block_(other.block_) {
    if (block_ != nullptr) block_->owners.fetch_add(1, std::memory_order_relaxed);
  }
  Shared(Shared&& other) noexcept : block_(std::exchange(other.block_, nullptr)) {}
  Shared& operator=(Shared other) noexcept {
    std::swap(block_, other.block_);
    return *this;
  }
  ~Shared() {
    if (block_ != nullptr) release();
  }

  const T* get() const { return block_ == nullptr ? nullptr : &block_->value; }
  const T& operator*() const { return block_->value; }
  const T* operator->() const { return &block_->value; }
  explicit operator bool() const { return block_ != nullptr; }
  friend bool operator==(const Shared& a, std::nullptr_t) { return a.block_ == nullptr; }
  friend bool operator==(const Shared& a, const Shared& b) { return a.block_ == b.block_; }

 private:
  struct Block {
    T value;
    std::atomic<std::uint32_t> owners{1};
  };
  void release() {
    if (block_->owners.fetch_sub(1, std::memory_order_acq_rel) == 1) delete block_;
  }

  Block* block_ = nullptr;
};

}  // namespace rungproof
