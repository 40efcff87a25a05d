// JSON values as reports, pages and the baseline build and read them: members keep their order, numbers stay whole.
// The library that knows JSON's text stands behind json.cpp alone, because its header costs every file that
// includes it three seconds of compile time. Tested by tests/cli/json_test.cpp and through every report.
#pragma once

#include <concepts>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rungproof {

class Json {
 public:
  struct Member;
  enum class Kind : std::uint8_t { Null, Truth, Whole, Natural, Real, Text, Array, Object };

  Json(std::nullptr_t = nullptr);
  Json(std::same_as<bool> auto truth) : Json(Kind::Truth, truth ? 1 : 0) {}
  Json(std::signed_integral auto whole)
      : Json(Kind::Whole, static_cast<std::uint64_t>(static_cast<std::int64_t>(whole))) {}
  Json(std::unsigned_integral auto natural) requires(!std::same_as<decltype(natural), bool>)
      : Json(Kind::Natural, natural) {}
  Json(double real);
  Json(std::string_view text);
  Json(const std::string& text) : Json(std::string_view(text)) {}
  Json(const char* text) : Json(std::string_view(text)) {}
  Json(const std::vector<std::string>& texts);
  Json(const std::vector<std::string_view>& texts);
  /// An object: {{"name", 1}, {"other", "text"}}.
  Json(std::initializer_list<Member> members);
  Json(const Json&);
  Json(Json&&) noexcept;
  Json& operator=(const Json&);
  Json& operator=(Json&&) noexcept;
  ~Json();

  static Json array(std::initializer_list<Json> items = {});
  static Json object();
  /// The value of a text; nothing if the text is not JSON.
  static std::optional<Json> read(const std::string& text);

  Kind kind() const { return kind_; }
  /// Array and object: their length.
  std::size_t size() const { return items_.size(); }
  bool empty() const { return items_.empty(); }
  const std::vector<Json>& items() const { return items_; }
  Json& back() { return items_.back(); }
  /// Text: the text; otherwise empty.
  const std::string& text() const { return text_; }
  /// A whole number that is not negative; otherwise nothing.
  std::optional<std::uint64_t> natural() const;
  /// Truth: its value; anything else is false.
  bool isTrue() const { return kind_ == Kind::Truth && bits_ != 0; }
  /// The member of an object; null if there is none or this is no object.
  const Json* find(std::string_view key) const;

  /// The member of an object, made at the end if it is new; null becomes an object.
  Json& operator[](std::string_view key);
  /// Null becomes an array.
  void push_back(Json item);

  /// On one line for -1, otherwise with this many spaces a level. Bytes that are not UTF-8 become U+FFFD.
  std::string dump(int indent = -1, bool asciiOnly = false) const;

 private:
  Json(Kind kind, std::uint64_t bits);

  Kind kind_ = Kind::Null;
  std::uint64_t bits_ = 0;  ///< Truth, Whole, Natural; Real: its representation
  std::string text_;
  std::vector<std::string> keys_;  ///< Object: beside items_
  std::vector<Json> items_;
};

struct Json::Member {
  std::string_view key;
  Json value;
};

}  // namespace rungproof
