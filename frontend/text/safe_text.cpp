// Escapes of all forms of output.
#include "frontend/text/safe_text.hpp"

#include <fmt/format.h>
#include <unicode/utf8.h>

#include <algorithm>
#include <array>
#include <iterator>

namespace rungproof {

namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD";
constexpr char escapeByte = '\x1B';

bool isPlainAscii(char c) { return c >= ' ' && c < 0x7F; }

/// The code point at `at`, which moves behind it; negative: the byte there is none.
UChar32 nextCharacter(std::string_view text, std::size_t& at) {
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(text.data()) + at;
  const auto left = static_cast<std::int32_t>(std::min<std::size_t>(text.size() - at, 4));
  std::int32_t used = 0;
  UChar32 c = 0;
  U8_NEXT(bytes, used, left, c);
  if (c < 0) used = 1;
  at += static_cast<std::size_t>(used);
  return c;
}

void appendVisible(std::string& result, UChar32 c) {
  if (c < 0) {
    result += replacement;
  } else if (c < 0x20 || c == 0x7F) {  // the control pictures of Unicode
    const auto low = static_cast<unsigned>(c == 0x7F ? 0x21 : c);
    result.append("\xE2\x90").push_back(static_cast<char>(0x80U | low));
  } else {
    fmt::format_to(std::back_inserter(result), "<U+{:04X}>", static_cast<unsigned>(c));
  }
}

/// Gives plain ASCII to `plain`, other characters that are safe to `other`, hazards and bytes without meaning to
/// `hazard`; line feeds and tabs are plain.
template <class Plain, class Hazard>
void forEachPart(std::string_view text, const Plain& plain, const Hazard& hazard) {
  for (std::size_t at = 0; at < text.size();) {
    std::size_t end = at;
    while (end < text.size() && (isPlainAscii(text[end]) || text[end] == '\n' || text[end] == '\t')) ++end;
    if (end > at) plain(text.substr(at, end - at));
    if ((at = end) == text.size()) return;
    const UChar32 c = nextCharacter(text, end);
    if (c < 0 || isHazard(static_cast<char32_t>(c)))
      hazard(c);
    else
      plain(text.substr(at, end - at));
    at = end;
  }
}

/// Length of a code that a terminal may get from us at the beginning of `text`, 0 if there is none. `isOpen`: it may
/// become one. Colours of Paint and of pictures, the end of a line, a clear screen: none of them hides or moves text.
std::size_t ownCode(std::string_view text, bool& isOpen) {
  static constexpr std::array<std::string_view, 12> codes = {"\x1B[0m",    "\x1B[1m",    "\x1B[2m",    "\x1B[1;31m",
                                                             "\x1B[1;32m", "\x1B[1;33m", "\x1B[1;34m", "\x1B[1;36m",
                                                             "\x1B[36m",   "\x1B[K",     "\x1B[2J",    "\x1B[H"};
  isOpen = false;
  for (const std::string_view code : codes) {
    if (text.starts_with(code)) return code.size();
    isOpen = isOpen || code.starts_with(text);
  }
  return 0;
}

/// Whether the bytes may be the beginning of a longer character.
bool isCutCharacter(std::string_view text) {
  const auto first = static_cast<unsigned char>(text[0]);
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : first >= 0xC2 ? 2 : 1;
  return text.size() < length && std::all_of(text.begin() + 1, text.end(),
                                             [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; });
}

}  // namespace

bool isHazard(char32_t c) {
  if (c < 0x20) return c != '\n' && c != '\t';
  if (c < 0x7F) return false;
  return c <= 0x9F || c == 0x61C || c == 0x200E || c == 0x200F || (c >= 0x2028 && c <= 0x202E) ||
         (c >= 0x2066 && c <= 0x2069) || c == 0xFEFF || (c & 0xFFFEU) == 0xFFFEU;
}

std::string visibleText(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  forEachPart(
      text, [&](std::string_view plain) { result += plain; }, [&](UChar32 c) { appendVisible(result, c); });
  return result;
}

std::string lineText(std::string_view text) {
  std::string result = visibleText(text);
  for (std::size_t at = result.find('\n'); at != std::string::npos; at = result.find('\n', at))
    result.replace(at, 1, "\xE2\x90\x8A");
  return result;
}

std::string messageText(std::string_view text) {
  constexpr std::size_t longest = 2000, beginning = 1500, end = 300;  // bytes
  if (text.size() <= longest) return lineText(text);
  const auto isTail = [&](std::size_t at) { return (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80U; };
  std::size_t first = beginning, last = text.size() - end;
  while (first > 0 && isTail(first)) --first;
  while (last < text.size() && isTail(last)) ++last;
  return fmt::format("{} ... {} bytes more ... {}", lineText(text.substr(0, first)), last - first,
                     lineText(text.substr(last)));
}

std::string xmlText(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  const auto plain = [&](std::string_view part) {
    for (const char c : part) {
      switch (c) {
        case '&': result += "&amp;"; break;
        case '<': result += "&lt;"; break;
        case '>': result += "&gt;"; break;
        case '"': result += "&quot;"; break;
        default: result += c;
      }
    }
  };
  forEachPart(text, plain, [&](UChar32 c) {
    std::string shown;
    appendVisible(shown, c);
    plain(shown);
  });
  return result;
}

std::string workflowText(std::string_view text, bool isProperty) {
  std::string result;
  for (const char c : visibleText(text)) {
    switch (c) {
      case '%': result += "%25"; break;
      case '\n': result += "%0A"; break;
      case ':': result += isProperty ? "%3A" : ":"; break;
      case ',': result += isProperty ? "%2C" : ","; break;
      default: result += c;
    }
  }
  return result;
}

std::string csvCell(std::string_view text) {
  std::string line = lineText(text);
  if (line.find_first_of(",\"") == std::string::npos) return line;
  std::string result = "\"";
  for (const char c : line) {
    if (c == '"') result += '"';
    result += c;
  }
  return result + "\"";
}

std::string tomlText(std::string_view text) {
  std::string result = "\"";
  const auto plain = [&](std::string_view part) {
    for (const char c : part) {
      switch (c) {
        case '"': result += "\\\""; break;
        case '\\': result += "\\\\"; break;
        case '\n': result += "\\n"; break;
        case '\t': result += "\\t"; break;
        default: result += c;
      }
    }
  };
  forEachPart(text, plain, [&](UChar32 c) {
    if (c < 0)
      result += replacement;
    else
      fmt::format_to(std::back_inserter(result), "\\U{:08X}", static_cast<unsigned>(c));
  });
  return result + "\"";
}

std::string jsonText(std::string json) {
  const bool isPlain = std::ranges::all_of(json, [](char c) { return isPlainAscii(c) || c == '\n'; });
  if (isPlain) return json;
  std::string result;
  result.reserve(json.size());
  forEachPart(
      json, [&](std::string_view plain) { result += plain; },
      [&](UChar32 c) {
        if (c > 0xFFFF)  // no hazard of ours but the last two of each plane
          fmt::format_to(std::back_inserter(result), "\\u{:04x}\\u{:04x}", 0xD7C0U + (static_cast<unsigned>(c) >> 10),
                         0xDC00U + (static_cast<unsigned>(c) & 0x3FFU));
        else if (c >= 0)
          fmt::format_to(std::back_inserter(result), "\\u{:04x}", static_cast<unsigned>(c));
        else
          result += replacement;
      });
  return result;
}

std::string_view VisiblePieces::next(std::string_view piece) {
  std::string joined;
  if (!held_.empty()) {
    joined = std::move(held_).append(piece);
    held_.clear();
    piece = joined;
  }
  text_.clear();
  for (std::size_t at = 0; at < piece.size();) {
    std::size_t end = at;
    while (end < piece.size() && (isPlainAscii(piece[end]) || piece[end] == '\n' || piece[end] == '\t')) ++end;
    text_ += piece.substr(at, end - at);
    if ((at = end) == piece.size()) break;
    const std::string_view rest = piece.substr(at);
    const bool keepsCodes = colors_ == Colors::Kept;
    bool isOpen = false;
    if (rest[0] == escapeByte && keepsCodes) {
      if (const std::size_t length = ownCode(rest, isOpen); length > 0) {
        text_ += rest.substr(0, length);
        at += length;
        continue;
      }
    }
    if (rest[0] == '\r' && (keepsCodes || rest.starts_with("\r\n"))) {
      text_ += '\r';
      ++at;
      continue;
    }
    if (isOpen || isCutCharacter(rest) || rest == "\r") {
      held_ = rest;
      break;
    }
    const UChar32 c = nextCharacter(piece, end);
    if (c < 0 || isHazard(static_cast<char32_t>(c)))
      appendVisible(text_, c);
    else
      text_ += piece.substr(at, end - at);
    at = end;
  }
  return text_;
}

std::string_view VisiblePieces::rest() {
  text_ = visibleText(held_);
  held_.clear();
  return text_;
}

}  // namespace rungproof
