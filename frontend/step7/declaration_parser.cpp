// Declarations, front to back.
#include "frontend/step7/declaration_parser.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "frontend/step7/source_keyword.hpp"
#include "frontend/stl/stl_lexer.hpp"

namespace rungproof::step7 {

namespace {

constexpr std::size_t mostInitialValues = 70000;  // more elements than bytes of a block
constexpr int deepestType = 32;                   // the editor allows 8; deeper ones are damage

}  // namespace

void DeclarationParser::report(std::uint32_t from, std::uint32_t to, std::string message) {
  ++faults_;
  sink_.report(Syntax::Declaration7, cursor_.span(from, to), std::move(message));
}

void DeclarationParser::reportHere(std::string message) {
  const std::uint32_t from = cursor_.at();
  std::uint32_t to = from + 1;
  const std::uint32_t end = cursor_.lineEnd();
  if (isWordByte(cursor_.peek())) to = from + static_cast<std::uint32_t>(cursor_.peekWord().size());
  report(from, std::min(to, std::max(end, from)), std::move(message));
}

void DeclarationParser::recover() {
  std::vector<Span> remarks;
  while (!cursor_.atEnd()) {
    if (cursor_.take(';')) return;
    if (cursor_.startsWith("//")) {
      cursor_.to(cursor_.lineEnd());
    } else if (cursor_.peek() == '\n') {
      cursor_.skipSpace(remarks);
      if (isSourceKeyword(cursor_.peekWord())) return;
    } else {
      cursor_.skip(1);
    }
  }
}

void DeclarationParser::skipAttributes() {
  cursor_.skipSpace();
  if (cursor_.peek() != '{') return;
  const std::uint32_t begin = cursor_.at();
  const std::size_t end = cursor_.text().find('}', begin);
  const std::size_t stop = cursor_.text().find(';', begin);
  if (end == std::string_view::npos) {
    report(begin, cursor_.lineEnd(), "the braces are not closed");
    cursor_.to(static_cast<std::uint32_t>(std::min({stop, cursor_.text().size(), std::size_t{cursor_.lineEnd()}})));
    return;
  }
  cursor_.to(static_cast<std::uint32_t>(end + 1));
  cursor_.skipSpace();
}

void DeclarationParser::readFields(Section section, std::string_view endWord, std::vector<DeclarationSyntax>& fields) {
  for (;;) {
    cursor_.skipSpace();
    if (cursor_.takeWord(endWord)) return;
    if (cursor_.take(';')) continue;
    if (cursor_.atEnd() || isSourceKeyword(cursor_.peekWord()))
      return reportHere(fmt::format("{} is missing", endWord));
    field(section, fields);
  }
}

void DeclarationParser::field(Section section, std::vector<DeclarationSyntax>& fields) {
  const std::uint32_t begin = cursor_.at();
  std::vector<DeclarationSyntax> names;
  do {
    cursor_.skipSpace();
    const std::optional<Name> name = cursor_.peek() == '\'' ? std::nullopt : readName(cursor_);
    if (!name) {
      reportHere("a declaration begins with a name");
      return recover();
    }
    names.emplace_back();
    names.back().name = *name;
    names.back().section = section;
    skipAttributes();
  } while (cursor_.take(','));
  if (cursor_.takeWord("AT")) {
    cursor_.skipSpace();
    const std::optional<Name> view = readName(cursor_);
    names.back().view = view ? view->text : "?";
    cursor_.skipSpace();
  }
  if (cursor_.peek() != ':' || cursor_.peek(1) == '=') {
    reportHere(fmt::format("a colon and a type are missing behind {}", names.back().name.text));
    return recover();
  }
  cursor_.skip(1);
  cursor_.skipSpace();
  const std::shared_ptr<const TypeSyntax> type = readType();
  if (type == nullptr) {
    // The name is known; what it is, is not.
    auto unknown = std::make_shared<TypeSyntax>();
    unknown->span = names.back().name.span;
    for (DeclarationSyntax& declaration : names) declaration.type = unknown;
    fields.insert(fields.end(), names.begin(), names.end());
    return recover();
  }
  std::vector<Constant> values;
  const std::uint32_t typeEnd = cursor_.at();
  skipAttributes();
  bool isRead = true;
  if (cursor_.startsWith(":=")) {
    cursor_.skip(2);
    isRead = readValues(values);
  }
  const std::uint32_t end = values.empty() ? typeEnd : cursor_.at();
  for (DeclarationSyntax& declaration : names) {
    declaration.type = type;
    declaration.initial = values;
    declaration.span = cursor_.span(begin, end);
    fields.push_back(std::move(declaration));
  }
  if (!isRead) return recover();
  cursor_.skipSpace();
  if (cursor_.take(';')) return;
  // STRUCT ... END_STRUCT stands without a semicolon in some sources.
  if (type->elementary.kind == s7300::TypeKind::Struct && type->named == std::nullopt) return;
  report(end > 0 ? end - 1 : 0, end, "a semicolon is missing behind the declaration");
}

std::shared_ptr<const TypeSyntax> DeclarationParser::readType() {
  const std::uint32_t begin = cursor_.at();
  auto type = std::make_shared<TypeSyntax>();
  if (depth_ >= deepestType) {
    reportHere("types are nested too deep");
    return nullptr;
  }
  if (cursor_.peek() == '"') {
    const std::optional<Name> name = readName(cursor_);
    if (!name) {
      reportHere("the name of a type has no second quotation mark");
      return nullptr;
    }
    type->elementary.kind = s7300::TypeKind::Struct;
    type->named = BlockName{std::nullopt, 0, name->text, name->span};
    type->span = name->span;
    return type;
  }
  if (const std::optional<BlockName> block = readBlockName(cursor_)) {
    type->elementary.kind = s7300::TypeKind::Struct;
    type->named = block;
    type->span = block->span;
    return type;
  }
  const std::string_view word = cursor_.peekWord();
  if (word.empty() || isSourceKeyword(word)) {
    reportHere("a type is missing");
    return nullptr;
  }
  cursor_.skip(word.size());
  if (equalsWord(word, "ARRAY")) return arrayType(begin);
  if (equalsWord(word, "STRUCT")) {
    type->elementary.kind = s7300::TypeKind::Struct;
    ++depth_;
    readFields(Section::Static, "END_STRUCT", type->fields);
    --depth_;
    type->span = cursor_.span(begin, begin + 6);
    return type;
  }
  if (const std::optional<s7300::Type> known = s7300::typeNamed(word)) {
    type->elementary = *known;
    if (known->kind == s7300::TypeKind::String) {
      const std::uint32_t back = cursor_.at();
      std::vector<PathStep> length{{}};
      const std::string fault = readIndices(cursor_, length);
      const bool isLength =
          fault.empty() && length[0].indices.size() == 1 && length[0].indices[0] >= 0 && length[0].indices[0] <= 254;
      if (!fault.empty() || (!length[0].indices.empty() && !isLength)) {
        report(back, cursor_.at(), "a STRING has 0 to 254 characters, as in STRING[20]");
        return nullptr;
      }
      if (isLength) type->elementary.length = static_cast<std::uint16_t>(length[0].indices[0]);
    }
  } else {
    type->elementary.kind = s7300::TypeKind::Struct;
    type->named = BlockName{std::nullopt, 0, std::string(word), cursor_.spanFrom(begin)};
  }
  type->span = cursor_.spanFrom(begin);
  return type;
}

bool DeclarationParser::bounds(std::vector<s7300::Bounds>& bounds) {
  const auto number = [&](std::int32_t& value) {
    cursor_.skipSpace();
    const bool isNegative = cursor_.take('-');
    std::int64_t sum = 0;
    if (!isDecimal(cursor_.peek())) return false;
    for (; isDecimal(cursor_.peek()) && sum < 1000000; cursor_.skip(1)) sum = sum * 10 + (cursor_.peek() - '0');
    value = static_cast<std::int32_t>(isNegative ? -sum : sum);
    return value >= -32768 && value <= 32767;
  };
  do {
    s7300::Bounds dimension;
    if (!number(dimension.first)) return false;
    cursor_.skipSpace();
    if (!cursor_.take('.') || !cursor_.take('.') || !number(dimension.last)) return false;
    if (dimension.last < dimension.first) return false;
    bounds.push_back(dimension);
    cursor_.skipSpace();
  } while (cursor_.take(','));
  return cursor_.take(']') && bounds.size() <= 6;
}

std::shared_ptr<const TypeSyntax> DeclarationParser::arrayType(std::uint32_t begin) {
  auto type = std::make_shared<TypeSyntax>();
  type->elementary.kind = s7300::TypeKind::Array;
  cursor_.skipSpace();
  const std::uint32_t from = cursor_.at();
  if (!cursor_.take('[') || !bounds(type->bounds)) {
    report(from, std::max(cursor_.at(), from + 1), "the bounds of an array are written [1..10] or [1..10,0..3]");
    return nullptr;
  }
  cursor_.skipSpace();
  if (!cursor_.takeWord("OF")) {
    reportHere("OF is missing behind the bounds of an array");
    return nullptr;
  }
  cursor_.skipSpace();
  ++depth_;
  type->element = readType();
  --depth_;
  if (type->element == nullptr) return nullptr;
  if (type->element->elementary.kind == s7300::TypeKind::Array) {
    report(type->element->span.offset, type->element->span.offset + type->element->span.length,
           "an array cannot be the element of an array");
    return nullptr;
  }
  type->span = cursor_.span(begin, begin + 5);
  return type;
}

bool DeclarationParser::readValues(std::vector<Constant>& values) {
  cursor_.skipSpace();
  const bool isBracketed = cursor_.take('[');
  if (!valueList(values, 0)) return false;
  cursor_.skipSpace();
  if (isBracketed && !cursor_.take(']')) {
    reportHere("the closing bracket is missing");
    return false;
  }
  return true;
}

bool DeclarationParser::valueList(std::vector<Constant>& values, int depth) {
  do {
    cursor_.skipSpace();
    const std::uint32_t from = cursor_.at();
    if (std::optional<Constant> object = objectNumber()) {
      values.push_back(std::move(*object));
    } else if (!valueOrGroup(from, values, depth)) {
      return false;
    }
    const std::uint32_t behind = cursor_.at();
    cursor_.skipSpace();
    if (cursor_.take(',')) continue;
    cursor_.to(behind);
    return true;
  } while (true);
}

/// T 5, Z5, DB 5: what STEP 7 writes behind a variable of type TIMER, COUNTER or BLOCK_DB in an instance.
std::optional<Constant> DeclarationParser::objectNumber() {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 7> objects = {
      {{"T", "T"}, {"C", "C"}, {"Z", "C"}, {"DB", "DB"}, {"SDB", "SDB"}, {"FB", "FB"}, {"FC", "FC"}}};
  const std::uint32_t from = cursor_.at();
  const std::string_view word = cursor_.peekWord();
  const std::string_view letters = word.substr(0, word.find_first_of("0123456789"));
  const auto object = std::ranges::find_if(objects, [&](const auto& row) { return equalsWord(letters, row.first); });
  if (object == objects.end()) return std::nullopt;
  cursor_.skip(letters.size());
  cursor_.skipBlanks();
  Constant constant;
  constant.kind = s7300::ConstantKind::Object;
  constant.text = object->second;
  const std::uint32_t digits = cursor_.at();
  for (; isDecimal(cursor_.peek()) && constant.value <= 0xFFFF; cursor_.skip(1))
    constant.value = constant.value * 10 + (cursor_.peek() - '0');
  constant.span = cursor_.spanFrom(from);
  if (cursor_.at() > digits && constant.value <= 0xFFFF && !isWordByte(cursor_.peek())) return constant;
  cursor_.to(from);
  return std::nullopt;
}

bool DeclarationParser::valueOrGroup(std::uint32_t from, std::vector<Constant>& values, int depth) {
  ConstantOutcome outcome = readConstant(cursor_, spelling_.set, spelling_.encoding);
  if (!outcome.fault.empty() || !outcome.constant) {
    report(from, std::max(cursor_.at(), from + 1),
           outcome.fault.empty() ? "a value is missing" : "the value cannot be read: " + outcome.fault);
    return false;
  }
  const std::uint32_t back = cursor_.at();
  cursor_.skipSpace();
  if (outcome.constant->kind != s7300::ConstantKind::Integer || cursor_.peek() != '(') {
    cursor_.to(back);
    values.push_back(std::move(*outcome.constant));
  } else {
    cursor_.skip(1);
    std::vector<Constant> group;
    if (depth > 6 || !valueList(group, depth + 1)) return false;
    cursor_.skipSpace();
    if (!cursor_.take(')')) {
      reportHere("the closing parenthesis is missing");
      return false;
    }
    const std::int64_t times = outcome.constant->value;
    if (times < 0 || static_cast<std::size_t>(times) * group.size() > mostInitialValues) {
      report(from, cursor_.at(), "the values are more than a block can hold");
      return false;
    }
    for (std::int64_t i = 0; i < times; ++i) values.insert(values.end(), group.begin(), group.end());
  }
  return true;
}

}  // namespace rungproof::step7
