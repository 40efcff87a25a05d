// Types of IEC 61131-3 as they lie in memory, and literals. A BOOL takes bit 0 of a byte, numbers lie one behind the
// other, the highest byte first. A TIME is a number of ms, an LTIME one of ns; DATE and DT are seconds since
// 1970-01-01, TOD is ms since midnight, LDATE, LDT and LTOD are ns. A STRING is a byte with its length and its
// characters. What has no place here (WSTRING, pointers) is not covered. Tested by tests/iec.
#pragma once

#include <deque>
#include <map>

#include "frontend/iec/iec_parser.hpp"

namespace rungproof::iec {

enum class Kind : std::uint8_t {
  Bool,
  Integer,
  BitString,
  Real,
  Time,
  Date,  ///< DATE, TOD, DT and their long forms
  Text,
  Enum,
  Array,
  Struct,
  Block,
  Unsupported
};

struct Type;
struct Field {
  std::string name;
  const Type* type = nullptr;
  std::uint32_t offset = 0;
  const VariableSyntax* declared = nullptr;
};

struct Type {
  Kind kind = Kind::Unsupported;
  std::string name;
  int width = 0;  ///< bits of a value: 1, 8, 16, 32, 64
  bool isSigned = false;
  std::uint32_t bytes = 0;
  std::int64_t low = 0, high = 0;  ///< of numbers; of ULINT and LWORD `high` is the pattern
  const Type* element = nullptr;
  std::vector<std::pair<std::int64_t, std::int64_t>> bounds;
  std::vector<Field> fields;
  std::vector<std::pair<std::string, std::int64_t>> items;  ///< Enum
  const BlockSyntax* block = nullptr;                       ///< of an instance
  const Initial* initial = nullptr;                         ///< of a named type

  bool isNumber() const { return kind == Kind::Integer || kind == Kind::BitString || kind == Kind::Enum; }
  bool isValue() const { return width > 0; }
  bool isLong() const { return width == 64; }
  /// Signed as the words of a register are compared.
  bool isOrdered() const { return kind != Kind::Array && kind != Kind::Struct && kind != Kind::Block; }
};

/// The value of a literal or constant expression.
struct Value {
  const Type* type = nullptr;  ///< nullptr: an integer literal, which takes any type
  std::int64_t number = 0;     ///< REAL: its pattern
  bool isReal = false;         ///< a real literal, which takes REAL or LREAL
  double real = 0;
  bool isHuge = false;     ///< above 2^63 - 1: `number` is the pattern of 64 bits
  bool isPattern = false;  ///< written as bits: 16#FFFF
};

/// Most bytes of all variables together, and so of one type.
inline constexpr std::uint32_t mostBytes = 1U << 20;

/// Types that begin so belong to variables that a panel writes.
inline constexpr std::string_view panelPrefix = "HMI_";
/// Elementary types, by name in capitals; nullptr for names that are none.
const Type* elementaryType(std::string_view folded);

/// Whether a type of whole numbers has limits of its own: INT (0..10).
bool isSubrange(const Type& type);

/// What a value of the type can be, where it has fewer values than patterns: a subrange, an enumeration, a time of day.
std::optional<ValueLimits> limitsOf(const Type& type);

/// What a literal means, or nothing with the reason.
std::optional<Value> literalValue(const Expr& literal, std::string& reason);
/// A constant of REAL or LREAL; type nullptr: it takes either.
Value realConstant(double real, const Type* type);
/// The pattern of a real constant of that many bits.
std::int64_t realPattern(double real, int width);
/// Whether a number written in a program does not become infinite in that many bits.
bool isWithinReal(double real, int width);
/// Most characters of a STRING.
inline constexpr std::int64_t mostTextLength = 254;

/// The types of a project by name.
class TypeTable {
 public:
  TypeTable(const ProjectSyntax& project, SyntaxSink& sink);

  /// The type, or nullptr with an error at its place.
  const Type* resolve(const TypeSyntax& syntax);
  const Type* named(const std::string& name, Span span);
  /// The value of an enumerator: `RED`, or of a type `COLOR`.
  std::optional<Value> enumerator(const std::string& name, const std::string& ofType = {}) const;
  /// Constants that bounds and labels may name; set by the lowering.
  std::map<std::string, Value> constants;
  /// A constant expression; nothing, without an error, if it is none.
  std::optional<Value> constant(const Expr& expr);
  std::optional<std::int64_t> integer(const Expr& expr);

 private:
  const Type* add(Type type);
  const Type* make(const TypeSyntax& syntax, const std::string& name);
  /// A type of parts, unless it has more bytes than all variables together may have.
  const Type* addWhole(Type type, std::uint64_t bytes, Span span);
  void error(Span span, std::string message);

  SyntaxSink& sink_;
  std::map<std::string, const NamedType*> declared_;
  std::map<std::string, const BlockSyntax*> blocks_;
  std::map<std::string, const Type*> resolved_;
  std::map<std::string, Value> items_;
  std::vector<std::string> open_;
  std::deque<Type> types_;
};

}  // namespace rungproof::iec
