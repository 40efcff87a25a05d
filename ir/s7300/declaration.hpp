// Declarations of the S7-300/400: types, the structures that blocks and data blocks are made of, where each of their
// parts lies, what a dotted name means, and the bytes that initial values make (002:1951-2149, 002:673-679).
// Tested by tests/step7/layout_test.cpp against an independent layouter.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ir/s7300/constant.hpp"
#include "ir/source.hpp"

namespace rungproof::s7300 {

enum class TypeKind : std::uint8_t {
  Unknown,  ///< could not be read, or nothing defines it
  Void,
  Bool,
  Byte,
  Char,
  Word,
  Int,
  S5Time,
  Date,
  DWord,
  DInt,
  Real,
  Time,
  TimeOfDay,
  DateAndTime,
  String,
  Array,
  Struct,  ///< STRUCT, a UDT or an instance of an FB
  Timer,
  Counter,
  BlockDb,
  BlockSdb,
  BlockFc,
  BlockFb,
  Pointer,
  Any
};

struct Structure;

/// Bounds of one dimension, both included; -32768 to 32767 (002:2068).
struct Bounds {
  std::int32_t first = 0;
  std::int32_t last = 0;
  std::uint32_t count() const { return static_cast<std::uint32_t>(last - first + 1); }
  friend bool operator==(const Bounds&, const Bounds&) = default;
};

struct Type {
  TypeKind kind = TypeKind::Unknown;
  std::uint16_t length = 0;                      ///< String: most characters, 0 to 254
  std::vector<Bounds> bounds{};                  ///< Array: 1 to 6 dimensions, the last one runs fastest
  std::shared_ptr<const Type> element{};         ///< Array
  std::shared_ptr<const Structure> structure{};  ///< Struct
  std::string name{};                            ///< Struct of a UDT or an FB: its canonical name, "UDT 1", "FB 2"
};

enum class Section : std::uint8_t { Input, Output, InOut, Static, Temp, Return };

/// A name with its type and its place in the structure.
struct Field {
  std::string name;
  Type type;
  Section section = Section::Static;
  std::vector<Constant> initial{};  ///< in the order of the elements; fewer than there are: the rest has the default
  Span span;                        ///< the name
  std::uint32_t byte = 0;           ///< from the beginning of the structure
  std::uint8_t bit = 0;
  bool byReference = false;  ///< an IN_OUT of complex type in an instance: a POINTER of six bytes stands for it
  std::string viewOf{};      ///< AT of SCL: the field of the same structure whose place it shares
};

struct Structure {
  std::vector<Field> fields;
  std::uint64_t size = 0;  ///< bytes
  /// Letters in any case (002:180), or nullptr.
  const Field* field(std::string_view name) const;
};

/// Bytes that a value of the type takes by itself; 0 for what has no place.
std::uint64_t sizeOf(const Type& type);
/// Whether it begins at an even byte: all but BOOL, BYTE and CHAR.
bool startsEven(const Type& type);
/// DATE_AND_TIME, STRING, ARRAY, STRUCT: handed on by pointer.
bool isComplex(const Type& type);
/// The same type as a formal and an actual parameter need it: structures by name or part by part, arrays by bounds.
bool isSameType(const Type& a, const Type& b);
/// "INT", "ARRAY[1..10] OF REAL", "UDT 1".
std::string toString(const Type& type);
/// BOOL, WORD, ... by its name, without what follows it (STRING gets 254); nothing if no elementary or parameter type
/// has the name. DT and TOD are the long names' short forms.
std::optional<Type> typeNamed(std::string_view name);

/// Gives every field its place. Bits and bytes are packed, wider values begin at even bytes, the whole is filled up to
/// an even length (002:673-679). A view lies where its field lies and takes no place of its own.
void layOut(Structure& structure);
/// The same for the instance of an FB: sections in the order IN, OUT, IN_OUT, STAT, each at an even byte; fields are
/// sorted so. An IN_OUT of complex type gets the six bytes of a POINTER.
void layOutInstance(Structure& structure);

/// One part of a dotted name: `list[2,3]`.
struct PathStep {
  std::string name;
  std::vector<std::int64_t> indices;
  Span span;
};

enum class PathFault : std::uint8_t {
  None,
  NoField,      ///< the structure has no such name
  NoStructure,  ///< a dot behind something that has no parts
  NoArray,      ///< an index behind something that is no array
  IndexCount,   ///< too few or too many indices
  IndexRange    ///< an index outside of its bounds
};

struct PathResult {
  PathFault fault = PathFault::None;
  std::size_t step = 0;          ///< at which the fault is
  const Field* field = nullptr;  ///< of the first step
  const Type* type = nullptr;    ///< of what the name means
  std::uint32_t byte = 0;        ///< from the beginning of the structure; behind a reference: of what it points to
  std::uint8_t bit = 0;
  bool byReference = false;  ///< the way leads through Field::byReference of the first step
};
/// What a name means in the structure. References stand only for whole parameters, so only the first step can be one.
PathResult lookUp(const Structure& structure, std::span<const PathStep> path);

/// How values do not fit a place.
struct ValueFault {
  std::size_t value = 0;  ///< index of the value
  bool tooMany = false;   ///< there are more values than elements; else: of the wrong type or out of range
};
/// Writes values into bytes, from the place at `byte`.`bit` on; arrays element by element.
std::optional<ValueFault> writeValues(const Type& type, std::span<const Constant> values, std::uint64_t byte,
                                      std::uint8_t bit, std::vector<std::uint8_t>& bytes);
/// Bytes of a structure as its declaration makes them; values that do not fit leave the default.
std::vector<std::uint8_t> initialBytes(const Structure& structure);

/// Names compare without case: ASCII, Latin and Cyrillic letters of UTF-8.
bool isSameName(std::string_view a, std::string_view b);
/// The form by which such names can be looked up.
std::string foldedName(std::string_view name);

}  // namespace rungproof::s7300
