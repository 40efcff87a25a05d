// Bytes of a file to UTF-8 text. Micro/WIN writes the ANSI code page of its machine (CP1252, CP1251, GBK); other
// editors write UTF-8 with or without a byte order mark. All places of the program refer to the converted text.
// Tested by tests/reader/encoding_test.cpp.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace rungproof {

enum class TextEncoding : std::uint8_t { Auto, Utf8, Cp1252, Cp1251, Gb18030 };

/// "utf-8", "cp1252", "cp1251", "gb18030", "auto", or nothing.
std::optional<TextEncoding> encodingNamed(std::string_view name);
std::string_view encodingName(TextEncoding encoding);

struct DecodedText {
  std::string text;  ///< valid UTF-8 without byte order mark; a lone CR became LF
  TextEncoding encoding = TextEncoding::Utf8;
  bool wasUtf16 = false;
  std::size_t badBytes = 0;  ///< places that the encoding does not know, now U+FFFD
  std::size_t firstBad = 0;  ///< offset of the first in `text`
  std::size_t controls = 0;  ///< NUL and other control characters, now blanks
  std::size_t firstControl = 0;
};

DecodedText decode(std::string_view bytes, TextEncoding encoding);

/// Bytes of a UTF-8 text in that code page, as the controller would hold them; characters that the code page
/// lacks, and all characters under TextEncoding::Utf8 above U+00FF, keep their UTF-8 bytes.
std::string encodeForController(std::string_view utf8, TextEncoding encoding);

/// How the bytes of a file stand for its text, so that a changed text can be written as the file was.
struct ByteForm {
  std::string_view mark{};      ///< byte order mark
  const char* utf16 = nullptr;  ///< "UTF-16LE", "UTF-16BE", or nullptr
  TextEncoding encoding = TextEncoding::Utf8;
};
/// As decode() reads them.
ByteForm byteFormOf(std::string_view bytes, TextEncoding encoding);
/// The text in that form, without the mark; nothing if the form lacks a character of it.
std::optional<std::string> encode(std::string_view utf8, const ByteForm& form);

bool isValidUtf8(std::string_view text);

}  // namespace rungproof
