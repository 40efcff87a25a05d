// Names of places, symbols beside addresses, the date.
#include "frontend/acceptance/page_text.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <cstdlib>
#include <ctime>

#include "frontend/text/safe_text.hpp"
#include "ir/manual.hpp"

namespace rungproof {

namespace {

bool isWordByte(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return std::isalnum(byte) != 0 || byte >= 0x80 || c == '_';
}

std::string inCapitals(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return result;
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k) text += i + k <= bytes.size() ? digits[group >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

}  // namespace

std::string placeName(std::string_view text) {
  std::string name;
  for (const char c : visibleText(text)) {
    if (isWordByte(c))
      name += c;
    else if (!name.empty() && name.back() != '-')
      name += '-';
  }
  while (!name.empty() && name.back() == '-') name.pop_back();
  return name.empty() ? "unnamed" : name;
}

std::string PlaceNames::of(std::string_view text) {
  const std::string plain = placeName(text);
  int& last = last_[plain];
  std::string name;
  do {
    name = ++last == 1 ? plain : fmt::format("{}-{}", plain, last);
  } while (!given_.insert(name).second);
  return name;
}

AddressNames::AddressNames(const std::vector<NamedAddress>& names) {
  for (const NamedAddress& name : names) {
    symbolOf_.try_emplace(name.address, name.symbol);
    addressOf_.try_emplace(inCapitals(name.symbol), name.address);
  }
}

std::string AddressNames::otherName(std::string_view word) const {
  std::string_view base = word;
  if (const std::size_t dot = base.find(".value"); dot != std::string_view::npos) base = base.substr(0, dot);
  if (const auto symbol = symbolOf_.find(inCapitals(base)); symbol != symbolOf_.end()) return symbol->second;
  const auto address = addressOf_.find(inCapitals(base));
  return address == addressOf_.end() ? "" : address->second;
}

std::string AddressNames::marked(std::string_view text, bool isExpression) const {
  std::string result;
  while (!text.empty()) {
    std::size_t end = 0;
    // An address has a point inside: Q0.0; a point at the end of a sentence is none.
    while (end < text.size() && (isWordByte(text[end]) ||
                                 (text[end] == '.' && end > 0 && end + 1 < text.size() && isWordByte(text[end + 1]))))
      ++end;
    if (end == 0) {
      result += xmlText(text.substr(0, 1));
      text.remove_prefix(1);
      continue;
    }
    const std::string_view word = text.substr(0, end);
    text.remove_prefix(end);
    result += xmlText(word);
    // In a sentence a word such as "left" is a word, whatever a symbol is called.
    const std::string other = isExpression || word.find_first_of("0123456789") != word.npos ? otherName(word) : "";
    const std::size_t next = std::min(text.find_first_not_of(" ('"), text.size());
    if (!other.empty() && !text.substr(next).starts_with(other))
      result += fmt::format(" <span class=\"also\">{}</span>", xmlText(other));
  }
  return result;
}

std::string AddressNames::markedStatement(std::string_view text) const {
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos) return marked(text, true);
  return xmlText(text.substr(0, colon + 1)) + marked(text.substr(colon + 1), true);
}

std::string dataLink(std::string_view mediaType, std::string_view text) {
  return fmt::format("data:{};base64,{}", mediaType, base64(text));
}

std::string pageDate() {
  const char* fixed = std::getenv("SOURCE_DATE_EPOCH");
  const std::time_t now =
      fixed != nullptr ? static_cast<std::time_t>(std::strtoll(fixed, nullptr, 10)) : std::time(nullptr);
  const std::chrono::sys_seconds moment{std::chrono::seconds(now)};
  const auto day = std::chrono::floor<std::chrono::days>(moment);
  const std::chrono::year_month_day date(day);
  const auto minutes = std::chrono::floor<std::chrono::minutes>(moment - day).count();
  return fmt::format("{:04}-{:02}-{:02} {:02}:{:02} UTC", static_cast<int>(date.year()),
                     static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()), minutes / 60,
                     minutes % 60);
}

}  // namespace rungproof
