// Texts of the client.
#include "frontend/editor/document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "engine/platform/names.hpp"

namespace rungproof {

namespace {

/// Bytes of the character that begins with this byte; 1 for bytes that begin none.
std::size_t characterBytes(char first) {
  const auto byte = static_cast<unsigned char>(first);
  return byte < 0xC0 ? 1 : byte < 0xE0 ? 2 : byte < 0xF0 ? 3 : 4;
}

/// Characters beyond the basic plane are two units: those that take four bytes.
std::uint32_t unitsOf(char first) { return characterBytes(first) == 4 ? 2 : 1; }

/// Behind the line end at or after `from`; the end of the text if there is none. \r, \n and \r\n end a line.
std::size_t nextLine(std::string_view text, std::size_t from) {
  const std::size_t end = text.find_first_of("\r\n", from);
  if (end == std::string_view::npos) return std::string_view::npos;
  return text.substr(end, 2) == "\r\n" ? end + 2 : end + 1;
}

int digitOf(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

std::string withoutPercent(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool isCode = text[i] == '%' && i + 2 < text.size() && digitOf(text[i + 1]) >= 0 && digitOf(text[i + 2]) >= 0;
    result += isCode ? static_cast<char>(digitOf(text[i + 1]) * 16 + digitOf(text[i + 2])) : text[i];
    if (isCode) i += 2;
  }
  return result;
}

std::optional<std::uint32_t> smallNumber(const Json* json) {
  const auto number = json == nullptr ? std::nullopt : json->natural();
  if (!number) return std::nullopt;
  return static_cast<std::uint32_t>(std::min<std::uint64_t>(*number, 0x7FFFFFFF));
}

}  // namespace

std::size_t offsetOf(std::string_view text, ClientPlace place) {
  std::size_t at = 0;
  for (std::uint32_t line = 0; line < place.line; ++line) {
    at = nextLine(text, at);
    if (at == std::string_view::npos) return text.size();
  }
  std::uint32_t units = 0;
  while (at < text.size() && text[at] != '\r' && text[at] != '\n') {
    units += unitsOf(text[at]);
    if (units > place.character) break;
    at = std::min(at + characterBytes(text[at]), text.size());
  }
  return at;
}

ClientPlace placeOf(const SourceFile& file, std::uint32_t offset) {
  const auto size = static_cast<std::uint32_t>(file.text().size());
  const std::uint32_t end = std::min(offset, size);
  ClientPlace place;
  place.line = file.position(end).line - 1;
  const std::string_view before =
      file.text().substr(file.lineStart(place.line + 1), end - file.lineStart(place.line + 1));
  for (std::size_t i = 0; i < before.size(); i += characterBytes(before[i])) place.character += unitsOf(before[i]);
  return place;
}

Json rangeJson(ClientPlace begin, ClientPlace end) {
  return {{"start", Json{{"line", begin.line}, {"character", begin.character}}},
          {"end", Json{{"line", end.line}, {"character", end.character}}}};
}

Json rangeJson(const SourceFile& file, Span span) {
  return rangeJson(placeOf(file, span.offset), placeOf(file, span.offset + span.length));
}

std::optional<ClientPlace> placeFrom(const Json* json) {
  const auto line = json == nullptr ? std::nullopt : smallNumber(json->find("line"));
  const auto character = json == nullptr ? std::nullopt : smallNumber(json->find("character"));
  return line && character ? std::optional(ClientPlace{*line, *character}) : std::nullopt;
}

bool applyChange(Document& document, const Json& change) {
  const Json* const text = change.find("text");
  if (text == nullptr || text->kind() != Json::Kind::Text) return false;
  const Json* const range = change.find("range");
  if (range == nullptr) {
    document.text = text->text();
    return true;
  }
  const std::optional<ClientPlace> start = placeFrom(range->find("start")), end = placeFrom(range->find("end"));
  if (!start || !end) return false;
  const std::size_t from = offsetOf(document.text, *start), to = std::max(from, offsetOf(document.text, *end));
  document.text.replace(from, to - from, text->text());
  return true;
}

std::string pathOfUri(std::string_view uri, const std::string& folder) {
  if (uri.starts_with("file://")) {
    const std::size_t slash = uri.find('/', std::string_view("file://").size());
    return nameOfUriPath(withoutPercent(slash == std::string_view::npos ? std::string_view() : uri.substr(slash)));
  }
  const std::size_t cut = uri.find_last_of("/:");
  const std::string name = withoutPercent(cut == std::string_view::npos ? uri : uri.substr(cut + 1));
  return pathName(std::filesystem::path(folder) / (name.empty() ? "untitled" : name));
}

std::string uriOfPath(const std::string& path) {
  constexpr std::string_view plain = "/-._~!$'()*+,;=:@";
  std::string uri = "file://";
  for (const char c : uriPathOfName(path)) {
    const bool isPlain = (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
                         plain.find(c) != std::string_view::npos;
    uri += isPlain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return uri;
}

}  // namespace rungproof
