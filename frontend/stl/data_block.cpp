// Values to bytes, big-endian (001:14372).
#include "frontend/stl/data_block.hpp"

#include <fmt/format.h>

#include "frontend/stl/operand_reader.hpp"

namespace rungproof {

namespace {

/// V address with its size letter: VB10, VW10, VD10, V10; or the older B 10, W 10, D 10.
struct DataPlace {
  bool isPlace = false;
  bool isOlder = false;
  int size = 0;
  std::uint32_t offset = 0;
};

bool number(std::string_view digits, std::uint32_t& value) {
  if (digits.empty() || digits.size() > 9) return false;
  value = 0;
  for (const char c : digits) {
    if (!isDigit(c)) return false;
    value = value * 10 + static_cast<std::uint32_t>(c - '0');
  }
  return true;
}

int sizeOfLetter(char c) { return c == 'B' ? 1 : c == 'W' ? 2 : c == 'D' ? 4 : -1; }

/// `words` are the first one or two words; says through `used` how many the place takes.
DataPlace dataPlace(std::string_view first, std::string_view second, std::size_t& used) {
  DataPlace place;
  std::size_t letters = 0;
  while (letters < first.size() && isLetter(first[letters])) ++letters;
  if (letters == 0 || letters > 2) return place;
  const char one = upper(first[0]);
  if (letters == 2) {
    if (one != 'V') return place;
    place.size = sizeOfLetter(upper(first[1]));
  } else if (one == 'V') {
    place.size = 0;
  } else {
    place.size = sizeOfLetter(one);
    place.isOlder = true;
  }
  if (place.size < 0) return place;
  const bool isApart = letters == first.size();
  used = isApart ? 2 : 1;
  place.isPlace = number(isApart ? second : first.substr(letters), place.offset);
  return place;
}

}  // namespace

void DataBlockReader::begin() {
  hasPlace_ = false;
  isOlder_ = false;
}

bool DataBlockReader::readPlace(const Line& line, std::size_t& next) {
  const auto word = [&](std::size_t i) {
    return i < line.words.size() ? text_.substr(line.words[i].begin, line.words[i].end - line.words[i].begin)
                                 : std::string_view();
  };
  next = 0;
  if (!isLetter(word(0).empty() ? ' ' : word(0)[0]) || word(0).find('#') != std::string_view::npos) return hasPlace_;
  std::size_t used = 0;
  const DataPlace place = dataPlace(word(0), word(1), used);
  if (!place.isPlace) return false;
  hasPlace_ = true;
  isOlder_ = place.isOlder;
  size_ = place.size;
  offset_ = place.offset;
  next = used;
  return true;
}

void DataBlockReader::line(const Line& line) {
  if (line.words.empty()) return;
  if (line.openQuote)
    return sink_.report(Syntax::QuoteOpen, sink_.span(line.begin, line.end),
                        "a quotation mark is not closed on this line");
  std::size_t next = 0;
  if (!readPlace(line, next)) {
    const std::string_view text = text_.substr(line.begin, line.end - line.begin);
    const bool lacksPlace = !hasPlace_ && readConstant(text.substr(0, line.words[0].end - line.words[0].begin)).fault ==
                                              ConstantFault::None;
    const std::string shown = excerpt(text);
    return sink_.report(lacksPlace ? Syntax::DataAddress : Syntax::DataRow, sink_.span(line.begin, line.end),
                        lacksPlace ? fmt::format("value \"{}\" has no address before it", shown)
                                   : fmt::format("\"{}\" is not an address of V memory with values", shown));
  }
  if (next == line.words.size())
    return sink_.report(Syntax::DataRow, sink_.span(line.begin, line.end), "address without a value");
  for (std::size_t i = next; i < line.words.size(); ++i) readValue(line.words[i]);
}

void DataBlockReader::readValue(const Word& word) {
  const std::string_view text = text_.substr(word.begin, word.end - word.begin);
  const Span span = sink_.span(word.begin, word.end);
  if (const Quote quote = quoteAt(text, 0); quote.length > 0) {
    const std::optional<std::string> characters = unquoted(text, encoding_);
    if (!characters) return sink_.report(Syntax::DataRow, span, fmt::format("\"{}\" is not a text", excerpt(text)));
    DataInit init;
    init.offset = offset_;
    init.span = span;
    if (quote.kind == '"' && !isOlder_) {  // a string: length byte first (001:1414)
      if (characters->size() > 254) return sink_.report(Syntax::DataValue, span, "a string has at most 254 characters");
      init.bytes.push_back(static_cast<std::uint8_t>(characters->size()));
    }
    init.bytes.insert(init.bytes.end(), characters->begin(), characters->end());
    offset_ += static_cast<std::uint32_t>(init.bytes.size());
    sink_.program().data.push_back(std::move(init));
    return;
  }
  const ConstantResult value = readConstant(text, encoding_);
  if (value.fault != ConstantFault::None)
    return sink_.report(Syntax::DataRow, span, fmt::format("\"{}\" {}", excerpt(text), faultText(value.fault)));
  const bool isReal = value.operand.form == ConstantForm::Real;
  const std::int64_t v = value.operand.value;
  int count = size_;
  if (count == 0) count = isReal || v > 0xFFFF || v < -0x8000 ? 4 : v > 0xFF || v < -0x80 ? 2 : 1;
  if (value.operand.form == ConstantForm::Typed) count = std::max(count, bytes(value.operand.width));
  store(span, v, count, isReal);
}

void DataBlockReader::store(Span span, std::int64_t value, int count, bool isReal) {
  const std::int64_t limit = 1LL << (8 * count);
  if (value >= limit || value < -limit / 2 || (isReal && count != 4)) {
    return sink_.report(Syntax::DataValue, span,
                        fmt::format("value does not fit {} byte{}", count, count == 1 ? "" : "s"));
  }
  DataInit init;
  init.offset = offset_;
  init.span = span;
  for (int shift = 8 * (count - 1); shift >= 0; shift -= 8)
    init.bytes.push_back(static_cast<std::uint8_t>(value >> shift));
  offset_ += static_cast<std::uint32_t>(count);
  sink_.program().data.push_back(std::move(init));
}

bool isDataLine(std::string_view text, const Line& line) {
  const auto word = [&](std::size_t i) {
    return i < line.words.size() ? text.substr(line.words[i].begin, line.words[i].end - line.words[i].begin)
                                 : std::string_view();
  };
  std::size_t used = 0;
  const DataPlace place = dataPlace(word(0), word(1), used);
  return place.isPlace && used < line.words.size() && readConstant(word(used)).fault == ConstantFault::None;
}

int dataLineShare(std::string_view text) {
  StlLexer lexer(text);
  Line line;
  int lines = 0;
  int hits = 0;
  while (lines < 200 && lexer.next(line)) {
    if (line.words.empty()) continue;
    ++lines;
    const bool isValue = readConstant(lexer.slice(line.words[0])).fault == ConstantFault::None;
    if (isDataLine(text, line) || (isValue && hits > 0)) ++hits;
  }
  return lines == 0 ? 0 : hits * 100 / lines;
}

}  // namespace rungproof
