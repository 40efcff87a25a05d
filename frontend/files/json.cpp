// Between the values of json.hpp and nlohmann's, which reads and writes the text.
#include "frontend/files/json.hpp"

#include <algorithm>
#include <bit>
#include <nlohmann/json.hpp>

#include "frontend/text/safe_text.hpp"
#include "ir/check.hpp"

namespace rungproof {

namespace {

using Library = nlohmann::ordered_json;

constexpr std::size_t deepestJson = 500;  ///< arrays and objects inside each other

std::size_t depthOf(std::string_view text) {
  std::size_t depth = 0, deepest = 0;
  bool isInside = false;  // a string
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (isInside && c == '\\') {
      ++i;
      continue;
    }
    if (c == '"') isInside = !isInside;
    if (isInside) continue;
    if (c == '[' || c == '{') deepest = std::max(deepest, ++depth);
    if ((c == ']' || c == '}') && depth > 0) --depth;
  }
  return deepest;
}

}  // namespace

Json::Json(std::nullptr_t) {}
Json::Json(Kind kind, std::uint64_t bits) : kind_(kind), bits_(bits) {}
Json::Json(double real) : kind_(Kind::Real), bits_(std::bit_cast<std::uint64_t>(real)) {}
Json::Json(std::string_view text) : kind_(Kind::Text), text_(text) {}
Json::Json(const std::vector<std::string>& texts) : kind_(Kind::Array), items_(texts.begin(), texts.end()) {}
Json::Json(const std::vector<std::string_view>& texts) : kind_(Kind::Array), items_(texts.begin(), texts.end()) {}
Json::Json(std::initializer_list<Member> members) : kind_(Kind::Object) {
  for (const Member& member : members) (*this)[member.key] = member.value;
}
Json::Json(const Json&) = default;
Json::Json(Json&&) noexcept = default;
Json& Json::operator=(const Json&) = default;
Json& Json::operator=(Json&&) noexcept = default;
Json::~Json() = default;

Json Json::array(std::initializer_list<Json> items) {
  Json json(Kind::Array, 0);
  json.items_ = items;
  return json;
}

Json Json::object() { return Json(Kind::Object, 0); }

std::optional<std::uint64_t> Json::natural() const {
  const bool isNatural = kind_ == Kind::Natural || (kind_ == Kind::Whole && static_cast<std::int64_t>(bits_) >= 0);
  return isNatural ? std::optional(bits_) : std::nullopt;
}

const Json* Json::find(std::string_view key) const {
  const auto found = std::find(keys_.begin(), keys_.end(), key);
  return found == keys_.end() ? nullptr : &items_[static_cast<std::size_t>(found - keys_.begin())];
}

Json& Json::operator[](std::string_view key) {
  if (kind_ == Kind::Null) kind_ = Kind::Object;
  CHECK(kind_ == Kind::Object, "member of a value that is no object");
  const auto found = std::find(keys_.begin(), keys_.end(), key);
  if (found != keys_.end()) return items_[static_cast<std::size_t>(found - keys_.begin())];
  keys_.emplace_back(key);
  return items_.emplace_back();
}

void Json::push_back(Json item) {
  if (kind_ == Kind::Null) kind_ = Kind::Array;
  CHECK(kind_ == Kind::Array, "item of a value that is no array");
  items_.push_back(std::move(item));
}

std::string Json::dump(int indent, bool asciiOnly) const {
  const auto libraryValue = [](const auto& self, const Json& json) -> Library {
    switch (json.kind_) {
      case Kind::Null: return nullptr;
      case Kind::Truth: return json.bits_ != 0;
      case Kind::Whole: return static_cast<std::int64_t>(json.bits_);
      case Kind::Natural: return json.bits_;
      case Kind::Real: return std::bit_cast<double>(json.bits_);
      case Kind::Text: return json.text_;
      case Kind::Array: {
        Library array = Library::array();
        for (const Json& item : json.items_) array.push_back(self(self, item));
        return array;
      }
      case Kind::Object: break;
    }
    Library object = Library::object();
    for (std::size_t i = 0; i < json.items_.size(); ++i) object[json.keys_[i]] = self(self, json.items_[i]);
    return object;
  };
  return jsonText(libraryValue(libraryValue, *this).dump(indent, ' ', asciiOnly, Library::error_handler_t::replace));
}

std::optional<Json> Json::read(const std::string& text) {
  const auto value = [](const auto& self, const Library& library) -> Json {
    if (library.is_boolean()) return library.get<bool>();
    if (library.is_number_unsigned()) return library.get<std::uint64_t>();
    if (library.is_number_integer()) return library.get<std::int64_t>();
    if (library.is_number()) return library.get<double>();
    if (library.is_string()) return library.get_ref<const std::string&>();
    Json json;
    if (library.is_array()) json = Json::array();
    if (library.is_object()) json = Json::object();
    if (library.is_array()) {
      for (const Library& item : library) json.push_back(self(self, item));
    }
    if (library.is_object()) {
      for (const auto& [key, item] : library.items()) json[key] = self(self, item);
    }
    return json;
  };
  if (depthOf(text) > deepestJson) return std::nullopt;  // values are walked and freed by recursion
  const Library library = Library::parse(text, nullptr, false);
  return library.is_discarded() ? std::nullopt : std::optional(value(value, library));
}

}  // namespace rungproof
