// Conversion with ICU. Detection: byte order mark, then valid UTF-8, then the likelier of GB18030, CP1251 and CP1252.
#include "frontend/files/encoding.hpp"

#include <unicode/ucnv.h>
#include <unicode/ustring.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>
#include <utility>

namespace rungproof {

namespace {

constexpr std::array<std::pair<std::string_view, const char*>, 5> names = {
    {{"auto", ""}, {"utf-8", "UTF-8"}, {"cp1252", "windows-1252"}, {"cp1251", "windows-1251"}, {"gb18030", "gb18030"}}};

struct CloseConverter {
  void operator()(UConverter* converter) const { ucnv_close(converter); }
};
using Converter = std::unique_ptr<UConverter, CloseConverter>;

Converter open(const char* name) {
  UErrorCode error = U_ZERO_ERROR;
  Converter converter(ucnv_open(name, &error));
  return U_SUCCESS(error) ? std::move(converter) : nullptr;
}

/// Converts through ICU; bytes that do not fit become U+FFFD.
std::string convert(std::string_view bytes, const char* from) {
  const Converter source = open(from);
  const Converter target = open("UTF-8");
  if (!source || !target) return std::string(bytes);
  std::string result(bytes.size() * 3 + 16, '\0');
  char* out = result.data();
  const char* in = bytes.data();
  std::array<UChar, 1024> pivot;
  UChar* pivotSource = pivot.data();
  UChar* pivotTarget = pivot.data();
  UErrorCode error = U_ZERO_ERROR;
  ucnv_convertEx(target.get(), source.get(), &out, result.data() + result.size(), &in, bytes.data() + bytes.size(),
                 pivot.data(), &pivotSource, &pivotTarget, pivot.data() + pivot.size(), true, true, &error);
  result.resize(static_cast<std::size_t>(out - result.data()));
  return result;
}

/// Length of the valid UTF-8 sequence at `at`, 0 if there is none.
std::size_t sequenceLength(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return at + i < text.size() ? static_cast<unsigned char>(text[at + i]) : 0U; };
  const auto tail = [&](std::size_t i) { return (byte(i) & 0xC0U) == 0x80U; };
  const unsigned first = byte(0);
  if (first < 0x80) return 1;
  if (first >= 0xC2 && first <= 0xDF) return tail(1) ? 2 : 0;
  if (first >= 0xE0 && first <= 0xEF) {
    const bool fits = (first != 0xE0 || byte(1) >= 0xA0) && (first != 0xED || byte(1) < 0xA0);
    return tail(1) && tail(2) && fits ? 3 : 0;
  }
  if (first >= 0xF0 && first <= 0xF4) {
    const bool fits = (first != 0xF0 || byte(1) >= 0x90) && (first != 0xF4 || byte(1) < 0x90);
    return tail(1) && tail(2) && tail(3) && fits ? 4 : 0;
  }
  return 0;
}

/// Replaces invalid sequences by U+FFFD.
void repairUtf8(DecodedText& result) {
  if (isValidUtf8(result.text)) return;
  std::string repaired;
  for (std::size_t i = 0; i < result.text.size();) {
    const std::size_t length = sequenceLength(result.text, i);
    if (length == 0) {
      if (result.badBytes++ == 0) result.firstBad = repaired.size();
      repaired += "\xEF\xBF\xBD";
      ++i;
    } else {
      repaired.append(result.text, i, length);
      i += length;
    }
  }
  result.text = std::move(repaired);
}

/// How well the bytes above 0x7F fit each code page: GB18030 needs pairs; CP1251 Cyrillic has words of many high
/// letters; CP1252 has single high letters between ASCII ones.
TextEncoding guess(std::string_view bytes) {
  std::size_t pairs = 0, broken = 0, cyrillic = 0, highRuns = 0, high = 0;
  for (std::size_t i = 0; i < bytes.size();) {
    const auto byte = static_cast<unsigned char>(bytes[i]);
    if (byte < 0x80) {
      ++i;
      continue;
    }
    std::size_t end = i;
    while (end < bytes.size() && static_cast<unsigned char>(bytes[end]) >= 0x80) {
      const auto c = static_cast<unsigned char>(bytes[end]);
      if (c >= 0xC0 || c == 0xA8 || c == 0xB8) ++cyrillic;
      ++end;
    }
    high += end - i;
    ++highRuns;
    for (std::size_t k = i; k < end;) {
      const auto lead = static_cast<unsigned char>(bytes[k]);
      const unsigned trail = k + 1 < bytes.size() ? static_cast<unsigned char>(bytes[k + 1]) : 0U;
      const bool inCommonRows =
          (lead >= 0xB0 && lead <= 0xF7 && trail >= 0xA1) || (lead >= 0xA1 && lead <= 0xA9 && trail >= 0xA1);
      const bool isPair = lead >= 0x81 && lead <= 0xFE && trail >= 0x40 && trail != 0x7F;
      if (inCommonRows) ++pairs;
      if (!isPair) ++broken;
      k += isPair ? 2 : 1;
    }
    i = end;
  }
  if (high == 0) return TextEncoding::Utf8;
  const bool everyRunIsPaired = broken == 0 && pairs * 2 >= high - high / 8;
  const bool isMostlyCyrillic = cyrillic * 10 >= high * 8 && high >= highRuns * 2;
  if (everyRunIsPaired && !(isMostlyCyrillic && pairs * 2 < high)) {
    // Russian words pair up by chance only when all are of even length; Chinese leads lie in B0-F7 with any trail.
    std::size_t lower = 0, firstLevel = 0;
    for (const char c : bytes) {
      const auto byte = static_cast<unsigned char>(c);
      if (byte >= 0xE0) ++lower;
      if (byte >= 0xB0 && byte <= 0xD7) ++firstLevel;
    }
    return lower > 2 * firstLevel && isMostlyCyrillic ? TextEncoding::Cp1251 : TextEncoding::Gb18030;
  }
  return isMostlyCyrillic ? TextEncoding::Cp1251 : TextEncoding::Cp1252;
}

bool startsWith(std::string_view bytes, std::string_view mark) { return bytes.substr(0, mark.size()) == mark; }

/// UTF-16 by its mark, or by NUL in every second place of the first bytes.
const char* utf16Kind(std::string_view bytes) {
  if (startsWith(bytes, "\xFF\xFE")) return "UTF-16LE";
  if (startsWith(bytes, "\xFE\xFF")) return "UTF-16BE";
  const std::size_t sample = std::min<std::size_t>(bytes.size(), 64) / 2 * 2;
  if (sample < 8) return nullptr;
  std::size_t even = 0, odd = 0;
  for (std::size_t i = 0; i < sample; ++i) {
    if (bytes[i] == '\0') ++(i % 2 == 0 ? even : odd);
  }
  if (even == 0 && odd * 2 == sample) return "UTF-16LE";
  if (odd == 0 && even * 2 == sample) return "UTF-16BE";
  return nullptr;
}

/// NUL and other control characters to blanks; lone CR to LF.
void tidy(DecodedText& result) {
  std::string& text = result.text;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto c = static_cast<unsigned char>(text[i]);
    if (c >= ' ' && c != 0x7F) continue;
    if (c == '\r' && (i + 1 == text.size() || text[i + 1] != '\n')) text[i] = '\n';
    const bool isBlank =
        c == '\t' || c == '\n' || c == '\r' || c == '\f' || c == '\v' || (c == 0x1A && i + 1 == text.size());
    if (isBlank && c != '\f' && c != '\v' && c != 0x1A) continue;
    text[i] = ' ';
    if (!isBlank && result.controls++ == 0) result.firstControl = i;
  }
}

}  // namespace

std::optional<TextEncoding> encodingNamed(std::string_view name) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i].first == name) return static_cast<TextEncoding>(i);
  }
  return std::nullopt;
}

std::string_view encodingName(TextEncoding encoding) { return names[static_cast<std::size_t>(encoding)].first; }

bool isValidUtf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    std::uint64_t eight = 0;
    if (i + 8 <= text.size()) {
      std::memcpy(&eight, text.data() + i, 8);
      if ((eight & 0x8080808080808080ULL) == 0) {
        i += 8;
        continue;
      }
    }
    const std::size_t length = sequenceLength(text, i);
    if (length == 0) return false;
    i += length;
  }
  return true;
}

DecodedText decode(std::string_view bytes, TextEncoding encoding) {
  DecodedText result;
  if (const char* utf16 = utf16Kind(bytes)) {
    result.wasUtf16 = true;
    result.text = convert(bytes, utf16);
    if (startsWith(result.text, "\xEF\xBB\xBF")) result.text.erase(0, 3);
  } else {
    if (startsWith(bytes, "\xEF\xBB\xBF")) {
      bytes.remove_prefix(3);
      encoding = TextEncoding::Utf8;
    }
    if (encoding == TextEncoding::Auto) encoding = isValidUtf8(bytes) ? TextEncoding::Utf8 : guess(bytes);
    result.encoding = encoding;
    if (encoding == TextEncoding::Utf8) {
      result.text = bytes;
    } else {
      result.text = convert(bytes, names[static_cast<std::size_t>(encoding)].second);
      for (std::size_t at = result.text.find("\xEF\xBF\xBD"); at != std::string::npos;
           at = result.text.find("\xEF\xBF\xBD", at + 3)) {
        if (result.badBytes++ == 0) result.firstBad = at;
      }
    }
  }
  repairUtf8(result);
  tidy(result);
  return result;
}

ByteForm byteFormOf(std::string_view bytes, TextEncoding encoding) {
  ByteForm form;
  form.utf16 = utf16Kind(bytes);
  if (form.utf16 != nullptr) {
    if (startsWith(bytes, "\xFF\xFE") || startsWith(bytes, "\xFE\xFF")) form.mark = bytes.substr(0, 2);
    return form;
  }
  if (startsWith(bytes, "\xEF\xBB\xBF")) {
    form.mark = bytes.substr(0, 3);
    return form;
  }
  form.encoding = encoding != TextEncoding::Auto ? encoding : isValidUtf8(bytes) ? TextEncoding::Utf8 : guess(bytes);
  return form;
}

std::optional<std::string> encode(std::string_view utf8, const ByteForm& form) {
  if (form.utf16 == nullptr && form.encoding == TextEncoding::Utf8) return std::string(utf8);
  const Converter target =
      open(form.utf16 != nullptr ? form.utf16 : names[static_cast<std::size_t>(form.encoding)].second);
  const Converter source = open("UTF-8");
  if (!source || !target) return std::nullopt;
  UErrorCode error = U_ZERO_ERROR;
  ucnv_setFromUCallBack(target.get(), UCNV_FROM_U_CALLBACK_STOP, nullptr, nullptr, nullptr, &error);
  std::string result(utf8.size() * 4 + 16, '\0');
  char* out = result.data();
  const char* in = utf8.data();
  std::array<UChar, 1024> pivot;
  UChar* pivotSource = pivot.data();
  UChar* pivotTarget = pivot.data();
  ucnv_convertEx(target.get(), source.get(), &out, result.data() + result.size(), &in, utf8.data() + utf8.size(),
                 pivot.data(), &pivotSource, &pivotTarget, pivot.data() + pivot.size(), true, true, &error);
  if (U_FAILURE(error)) return std::nullopt;
  result.resize(static_cast<std::size_t>(out - result.data()));
  return result;
}

std::string encodeForController(std::string_view utf8, TextEncoding encoding) {
  const bool singleByteLatin = encoding == TextEncoding::Auto || encoding == TextEncoding::Utf8;
  const Converter target = singleByteLatin ? nullptr : open(names[static_cast<std::size_t>(encoding)].second);
  std::string result;
  for (std::size_t i = 0; i < utf8.size();) {
    const std::size_t length = std::max<std::size_t>(sequenceLength(utf8, i), 1);
    const std::string_view character = utf8.substr(i, length);
    i += length;
    if (length == 2 && singleByteLatin && static_cast<unsigned char>(character[0]) <= 0xC3) {
      result += static_cast<char>((static_cast<unsigned>(character[0]) & 0x03U) << 6 |
                                  (static_cast<unsigned>(character[1]) & 0x3FU));
      continue;
    }
    if (length == 1 || target == nullptr) {
      result += character;
      continue;
    }
    std::array<UChar, 4> unit;
    std::array<char, 8> bytes;
    UErrorCode error = U_ZERO_ERROR;
    std::int32_t units = 0;
    u_strFromUTF8(unit.data(), 4, &units, character.data(), static_cast<std::int32_t>(length), &error);
    ucnv_setFromUCallBack(target.get(), UCNV_FROM_U_CALLBACK_STOP, nullptr, nullptr, nullptr, &error);
    const std::int32_t count = ucnv_fromUChars(target.get(), bytes.data(), 8, unit.data(), units, &error);
    if (U_SUCCESS(error)) {
      result.append(bytes.data(), static_cast<std::size_t>(count));
    } else {
      result += character;
    }
  }
  return result;
}

}  // namespace rungproof
