// Data blocks: initial values of V memory as free-form text (001:2374-2385). The first line needs an address; later
// lines and further values follow it. Separators are blanks, tabs and commas. The older dialect writes `B 100 5`.
// Tested by tests/reader/table_test.cpp.
#pragma once

#include "frontend/files/encoding.hpp"
#include "frontend/stl/stl_lexer.hpp"
#include "frontend/stl/syntax_sink.hpp"

namespace rungproof {

class DataBlockReader {
 public:
  DataBlockReader(std::string_view text, SyntaxSink& sink, TextEncoding encoding)
      : text_(text), sink_(sink), encoding_(encoding) {}

  /// Forgets the running address.
  void begin();
  /// One line; comment lines and empty ones are passed over.
  void line(const Line& line);

 private:
  bool readPlace(const Line& line, std::size_t& next);
  void readValue(const Word& word);
  void store(Span span, std::int64_t value, int count, bool isReal);

  std::string_view text_;
  SyntaxSink& sink_;
  TextEncoding encoding_;
  bool hasPlace_ = false;
  bool isOlder_ = false;  ///< "B 100": a text is its characters without a length byte
  std::uint32_t offset_ = 0;
  int size_ = 0;  ///< bytes of a value; 0: V without size letter, the value decides
};

/// Whether a line begins with an address of V memory (or B 100 of the older dialect) and a constant.
bool isDataLine(std::string_view text, const Line& line);

/// How sure it is that the text is a data block without DATA_BLOCK heading: share of its lines, 0 to 100.
int dataLineShare(std::string_view text);

}  // namespace rungproof
