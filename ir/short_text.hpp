// A text in eight bytes: up to seven characters stand in the object, longer ones in a block that all copies share. For
// texts of which a program has a million and which are made once and then read: names of operands, parts of findings.
// Tested by tests/ir/short_text_test.cpp.
#pragma once

#include <array>
#include <atomic>
#include <bit>
#include <compare>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <functional>
#include <iosfwd>
#include <new>
#include <string>
#include <string_view>

namespace rungproof {

class ShortText {
 public:
  static constexpr std::size_t npos = std::string_view::npos;

  ShortText() = default;
  explicit ShortText(std::string_view text) {
    if (text.size() <= mostInside) {
      bytes_[0] = static_cast<char>(text.size() << 1U | 1U);
      std::memcpy(bytes_.data() + 1, text.data(), text.size());
      return;
    }
    void* room = ::operator new(sizeof(Block) + text.size());
    auto* block = new (room) Block{{1}, static_cast<std::uint32_t>(text.size())};
    std::memcpy(static_cast<char*>(room) + sizeof(Block), text.data(), text.size());
    std::memcpy(bytes_.data(), &block, sizeof block);
  }
  ShortText(const std::string& text) : ShortText(std::string_view(text)) {}
  ShortText(const char* text) : ShortText(std::string_view(text)) {}
  ShortText(const ShortText& other) : bytes_(other.bytes_) {
    if (!isInside()) block()->owners.fetch_add(1, std::memory_order_relaxed);
  }
  ShortText(ShortText&& other) noexcept : bytes_(other.bytes_) { other.bytes_ = empty_; }
  ShortText& operator=(const ShortText& other) { return *this = ShortText(other); }
  ShortText& operator=(ShortText&& other) noexcept {
    std::swap(bytes_, other.bytes_);
    return *this;
  }
  ShortText& operator=(std::string_view text) { return *this = ShortText(text); }
  ShortText& operator=(const std::string& text) { return *this = ShortText(text); }
  ShortText& operator=(const char* text) { return *this = ShortText(text); }
  ~ShortText() {
    if (!isInside()) release();
  }

  /// Valid while this object stands where it is.
  std::string_view view() const {
    if (isInside()) return {bytes_.data() + 1, static_cast<std::size_t>(static_cast<unsigned char>(bytes_[0]) >> 1U)};
    return {reinterpret_cast<const char*>(block() + 1), block()->size};
  }
  operator std::string_view() const { return view(); }
  operator std::string() const { return std::string(view()); }
  bool empty() const { return bytes_[0] == empty_[0] && isInside(); }
  std::size_t size() const { return view().size(); }
  char operator[](std::size_t i) const { return view()[i]; }
  std::size_t find(std::string_view what, std::size_t from = 0) const { return view().find(what, from); }
  bool starts_with(std::string_view what) const { return view().starts_with(what); }
  bool starts_with(char what) const { return view().starts_with(what); }
  bool ends_with(std::string_view what) const { return view().ends_with(what); }
  std::string substr(std::size_t from, std::size_t count = npos) const {
    return std::string(view().substr(from, count));
  }
  ShortText& operator+=(std::string_view more) { return *this = ShortText(std::string(view()).append(more)); }

  template <class T>
  requires std::convertible_to<const T&, std::string_view>
  friend bool operator==(const ShortText& a, const T& b) { return a.view() == std::string_view(b); }
  template <class T>
  requires std::convertible_to<const T&, std::string_view>
  friend std::strong_ordering operator<=>(const ShortText& a, const T& b) { return a.view() <=> std::string_view(b); }
  template <class T>
  requires std::convertible_to<const T&, std::string_view>
  friend std::string operator+(const ShortText& a, const T& b) {
    return std::string(a.view()).append(std::string_view(b));
  }
  template <class T>
  requires(std::convertible_to<const T&, std::string_view> && !std::same_as<T, ShortText>) friend std::string operator+(
      const T& a, const ShortText& b) {
    return std::string(std::string_view(a)).append(b.view());
  }
  template <class Traits>
  friend std::basic_ostream<char, Traits>& operator<<(std::basic_ostream<char, Traits>& out, const ShortText& text) {
    return out << text.view();
  }

 private:
  struct Block {
    std::atomic<std::uint32_t> owners;
    std::uint32_t size;
  };
  // The first byte is 2 * size + 1 of a text that stands inside, or the lowest byte of an address, which is even.
  static_assert(std::endian::native == std::endian::little && sizeof(void*) == 8);
  static constexpr std::size_t mostInside = 7;
  static constexpr std::array<char, 8> empty_{1};

  bool isInside() const { return (bytes_[0] & 1) != 0; }
  Block* block() const { return std::bit_cast<Block*>(bytes_); }
  void release() {
    Block* last = block();
    if (last->owners.fetch_sub(1, std::memory_order_acq_rel) == 1) ::operator delete(last);
  }

  alignas(8) std::array<char, 8> bytes_ = empty_;
};

}  // namespace rungproof

template <>
struct std::hash<rungproof::ShortText> {
  std::size_t operator()(const rungproof::ShortText& text) const { return std::hash<std::string_view>()(text.view()); }
};
