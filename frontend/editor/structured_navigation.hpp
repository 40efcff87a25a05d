// Names in texts of IEC 61131-3: where they are declared and used, also where the text cannot be read as a whole.
// Tested by tests/editor/structured_navigation_test.cpp.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "frontend/editor/property_words.hpp"
#include "frontend/editor/structured_text.hpp"

namespace rungproof {

struct TextUse {
  Span span;
  bool isWritten = false;
};

/// A variable, or a block, of the texts of a program.
struct TextName {
  std::string name;
  std::string block;    ///< that declares it; empty: a global variable, or a block itself
  std::string section;  ///< "VAR_INPUT"; of a block "PROGRAM"
  std::string type;     ///< as declared
  bool isOfProgram = false;
  Span declaration;
  std::vector<TextUse> uses;  ///< without the declaration
  /// Where a word of a property names it; empty if none can.
  std::function<std::optional<Span>(const PropertyWord&)> inProperty{};
};

/// What the name at an offset of the document means, there or in a property; nothing if no text declares it.
std::optional<TextName> textNameAt(const CheckedDocument& document, std::uint32_t offset);

struct DeclaredName {
  std::string_view name, section, type;
  Span span;
};
/// A block of the document with what it declares.
struct DeclaredBlock {
  std::string_view name, kind;  ///< "FUNCTION_BLOCK"
  Span span, heading;
  std::vector<DeclaredName> variables;
};
std::vector<DeclaredBlock> declaredBlocksOf(const CheckedDocument& document);
/// Of VAR_GLOBAL, in all texts of the program.
std::vector<DeclaredName> declaredGlobalsOf(const CheckedDocument& document);

}  // namespace rungproof
