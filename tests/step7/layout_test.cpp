// Places of declared data: the layouts that 002 gives, and random nested declarations against a second layouter that
// shares no code: it counts bits, one after the other, over a plain tree.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>

#include "ir/s7300/declaration.hpp"

namespace rungproof::s7300 {
namespace {

Type elementary(std::string_view name) {
  const std::optional<Type> type = typeNamed(name);
  EXPECT_TRUE(type.has_value()) << name;
  return type.value_or(Type{});
}

Field named(std::string name, Type type, Section section = Section::Static) {
  Field field;
  field.name = std::move(name);
  field.type = std::move(type);
  field.section = section;
  return field;
}

Type structOf(std::vector<Field> fields) {
  auto structure = std::make_shared<Structure>();
  structure->fields = std::move(fields);
  layOut(*structure);
  Type type;
  type.kind = TypeKind::Struct;
  type.structure = std::move(structure);
  return type;
}

Type arrayOf(std::vector<Bounds> bounds, Type element) {
  Type type;
  type.kind = TypeKind::Array;
  type.bounds = std::move(bounds);
  type.element = std::make_shared<Type>(std::move(element));
  return type;
}

std::string places(const Structure& structure) {
  std::string text;
  for (const Field& field : structure.fields)
    text += fmt::format("{}{}.{}", text.empty() ? "" : " ", field.byte, field.bit);
  return text + fmt::format(" = {}", structure.size);
}

TEST(Layout300, DeclarationsOfTheManual) {
  // 002:2121-2126.
  const Type motor = structOf({named("ON", elementary("BOOL")), named("OFF", elementary("BOOL")),
                               named("Delay", elementary("S5TIME")), named("Speed", elementary("INT"))});
  EXPECT_EQ(places(*motor.structure), "0.0 0.1 2.0 4.0 = 6");
  // 002:2134-2141: a TIME_OF_DAY needs no more than an even byte.
  const Type volume = structOf({named("Width1", elementary("INT")), named("Length", elementary("INT")),
                                named("Height", elementary("INT")), named("MeasTi", elementary("TOD"))});
  EXPECT_EQ(places(*volume.structure), "0.0 2.0 4.0 6.0 = 10");
  const Type meas = structOf({named("Duration", elementary("TIME")), named("Volume1", volume)});
  EXPECT_EQ(places(*meas.structure), "0.0 4.0 = 14");
  // 002:764-767: five recipes of 20 bytes.
  std::vector<Field> ten;
  for (int i = 0; i < 10; ++i) ten.push_back(named(fmt::format("part{}", i), elementary("INT")));
  const Type recipe = structOf(ten);
  EXPECT_EQ(recipe.structure->size, 20u);
  EXPECT_EQ(sizeOf(arrayOf({{1, 5}}, recipe)), 100u);
  // 002:2097-2109: the last index runs fastest.
  const Type speeds = arrayOf({{1, 10}, {1, 2}}, elementary("INT"));
  EXPECT_EQ(sizeOf(speeds), 40u);
  const Type holder = structOf({named("speed", speeds)});
  const std::vector<PathStep> path = {{"SPEED", {3, 2}, {}}};
  const PathResult found = lookUp(*holder.structure, path);
  EXPECT_EQ(found.fault, PathFault::None);
  EXPECT_EQ(found.byte, 10u);
  EXPECT_EQ(found.type->kind, TypeKind::Int);
}

TEST(Layout300, InstancesOfTheManual) {
  // 002:265-267 and 002:738-740.
  Structure ints;
  ints.fields = {named("RR_V", elementary("INT"), Section::Static), named("MAX", elementary("INT"), Section::Output),
                 named("NUM", elementary("INT"), Section::Input)};
  layOutInstance(ints);
  EXPECT_EQ(ints.fields[0].name, "NUM");
  EXPECT_EQ(places(ints), "0.0 2.0 4.0 = 6");
  Structure reals;
  reals.fields = {named("NUM", elementary("REAL"), Section::Input), named("MAX", elementary("REAL"), Section::Output),
                  named("RR_V", elementary("REAL"), Section::Static)};
  layOutInstance(reals);
  EXPECT_EQ(places(reals), "0.0 4.0 8.0 = 12");
  // The block that measures a period: event 0.0, time_period 2.0, help_edge 6.0, prev_time 8.0, 12 bytes
  // (002:2458-2513).
  Structure period;
  period.fields = {
      named("event", elementary("BOOL"), Section::Input), named("time_period", elementary("REAL"), Section::Output),
      named("help_edge", elementary("BOOL"), Section::Static), named("prev_time", elementary("DINT"), Section::Static)};
  layOutInstance(period);
  EXPECT_EQ(places(period), "0.0 2.0 6.0 8.0 = 12");
}

TEST(Layout300, AComplexInOutIsAPointerOfSixBytes) {
  Structure instance;
  instance.fields = {named("list", arrayOf({{1, 100}}, elementary("REAL")), Section::InOut),
                     named("flag", elementary("BOOL"), Section::InOut),
                     named("x", elementary("BYTE"), Section::Static)};
  layOutInstance(instance);
  EXPECT_EQ(places(instance), "0.0 6.0 8.0 = 10");
  EXPECT_TRUE(instance.fields[0].byReference);
  EXPECT_FALSE(instance.fields[1].byReference);
  const std::vector<PathStep> path = {{"list", {3}, {}}};
  const PathResult found = lookUp(instance, path);
  EXPECT_TRUE(found.byReference);
  EXPECT_EQ(found.byte, 8u);  // within what the pointer leads to
}

TEST(Layout300, BitsAndBytesArePackedAndRowsOfBitsBeginAtBytes) {
  const Type packed =
      structOf({named("a", elementary("BOOL")), named("b", elementary("BYTE")), named("c", elementary("BOOL")),
                named("d", elementary("CHAR")), named("e", elementary("BOOL")), named("f", elementary("WORD"))});
  EXPECT_EQ(places(*packed.structure), "0.0 1.0 2.0 3.0 4.0 6.0 = 8");
  const Type nine = arrayOf({{0, 8}}, elementary("BOOL"));
  EXPECT_EQ(sizeOf(nine), 2u);
  const Type grid = arrayOf({{1, 3}, {1, 5}}, elementary("BOOL"));  // three rows of a byte, filled up
  EXPECT_EQ(sizeOf(grid), 4u);
  const Type holder = structOf({named("first", elementary("BOOL")), named("grid", grid)});
  EXPECT_EQ(places(*holder.structure), "0.0 2.0 = 6");
  const std::vector<PathStep> path = {{"grid", {2, 4}, {}}};
  const PathResult found = lookUp(*holder.structure, path);
  EXPECT_EQ(found.byte, 3u);
  EXPECT_EQ(found.bit, 3u);
}

TEST(Layout300, AStringHasTwoBytesInFront) {
  Type text = elementary("STRING");
  EXPECT_EQ(sizeOf(text), 256u);
  text.length = 10;
  EXPECT_EQ(sizeOf(text), 12u);  // 002:2050
}

TEST(Layout300, FaultsOfNames) {
  const Type motor = structOf({named("on", elementary("BOOL")), named("list", arrayOf({{-1, 1}}, elementary("INT")))});
  const auto faultOf = [&](std::vector<PathStep> path) { return lookUp(*motor.structure, path).fault; };
  EXPECT_EQ(faultOf({{"off", {}, {}}}), PathFault::NoField);
  EXPECT_EQ(faultOf({{"on", {}, {}}, {"x", {}, {}}}), PathFault::NoStructure);
  EXPECT_EQ(faultOf({{"on", {1}, {}}}), PathFault::NoArray);
  EXPECT_EQ(faultOf({{"list", {1, 1}, {}}}), PathFault::IndexCount);
  EXPECT_EQ(faultOf({{"list", {2}, {}}}), PathFault::IndexRange);
  EXPECT_EQ(faultOf({{"LIST", {-1}, {}}}), PathFault::None);
}

// The second layouter: a tree without shared code, places counted in bits.

struct Node {
  std::string kind;  ///< "bit", "byte", "word", "dword", "dt", "string", "struct", "array"
  int length = 0;    ///< of a string
  std::vector<std::pair<int, int>> bounds;
  std::vector<Node> parts;
  long firstBit = 0;
};

long roundedUp(long value, long unit) { return (value + unit - 1) / unit * unit; }

/// Bits of a value; children get places from the beginning of their structure.
long bitsOf(Node& node) {
  if (node.kind == "bit") return 1;
  if (node.kind == "byte") return 8;
  if (node.kind == "word") return 16;
  if (node.kind == "dword") return 32;
  if (node.kind == "dt") return 64;
  if (node.kind == "string") return 8L * (node.length + 2);
  if (node.kind == "struct") {
    long at = 0;
    for (Node& part : node.parts) {
      const long size = bitsOf(part);
      const long unit = part.kind == "bit" ? 1 : part.kind == "byte" ? 8 : 16;
      part.firstBit = roundedUp(at, unit);
      at = part.firstBit + size;
    }
    return roundedUp(at, 16);
  }
  // An array: its last dimension is a row, rows begin at bytes or, with wider elements, at words.
  Node& element = node.parts[0];
  const long size = bitsOf(element);
  const long step = element.kind == "bit" || element.kind == "byte" ? size : roundedUp(size, 16);
  long bits = step * (node.bounds.back().second - node.bounds.back().first + 1);
  bits = roundedUp(bits, 8);
  for (std::size_t i = 0; i + 1 < node.bounds.size(); ++i) bits *= node.bounds[i].second - node.bounds[i].first + 1;
  return roundedUp(bits, 16);
}

class RandomDeclaration {
 public:
  explicit RandomDeclaration(unsigned seed) : random_(seed) {}

  Node make(int depth) {
    static const std::vector<std::string> kinds = {"bit", "bit", "byte", "word", "dword", "dt", "string"};
    const int which = number(0, depth > 0 ? 10 : 6);
    Node node;
    if (which <= 6) {
      node.kind = kinds[static_cast<std::size_t>(which)];
      node.length = number(0, 9);
    } else if (which <= 8) {
      node.kind = "struct";
      const int count = number(1, 6);
      for (int i = 0; i < count; ++i) node.parts.push_back(make(depth - 1));
    } else {
      node.kind = "array";
      const int dimensions = number(1, 3);
      for (int i = 0; i < dimensions; ++i) {
        const int first = number(-3, 3);
        node.bounds.emplace_back(first, first + number(0, 10));
      }
      do node.parts = {make(depth - 1)};
      while (node.parts[0].kind == "array");
    }
    return node;
  }

 private:
  int number(int least, int most) { return std::uniform_int_distribution<int>(least, most)(random_); }
  std::mt19937 random_;
};

Type typeOf(const Node& node) {
  static const std::map<std::string, std::string> names = {{"bit", "BOOL"},   {"byte", "BYTE"}, {"word", "INT"},
                                                           {"dword", "REAL"}, {"dt", "DT"},     {"string", "STRING"}};
  if (const auto name = names.find(node.kind); name != names.end()) {
    Type type = elementary(name->second);
    if (node.kind == "string") type.length = static_cast<std::uint16_t>(node.length);
    return type;
  }
  if (node.kind == "array") {
    std::vector<Bounds> bounds;
    for (const auto& [first, last] : node.bounds) bounds.push_back({first, last});
    return arrayOf(std::move(bounds), typeOf(node.parts[0]));
  }
  std::vector<Field> fields;
  for (const Node& part : node.parts) fields.push_back(named(fmt::format("f{}", fields.size()), typeOf(part)));
  return structOf(std::move(fields));
}

void expectSamePlaces(const Node& node, const Type& type, const std::string& way) {
  if (node.kind == "array") return expectSamePlaces(node.parts[0], *type.element, way + "[]");
  if (node.kind != "struct") return;
  for (std::size_t i = 0; i < node.parts.size(); ++i) {
    const Field& field = type.structure->fields[i];
    EXPECT_EQ(node.parts[i].firstBit, 8L * field.byte + field.bit) << way << '.' << field.name;
    expectSamePlaces(node.parts[i], field.type, way + "." + field.name);
  }
}

TEST(Layout300, TwoHundredRandomDeclarationsLieWhereASecondLayouterPutsThem) {
  constexpr unsigned firstSeed = 20261123;
  for (unsigned i = 0; i < 200; ++i) {
    SCOPED_TRACE(fmt::format("seed {}", firstSeed + i));
    RandomDeclaration random(firstSeed + i);
    Node root;
    root.kind = "struct";
    for (int k = 0; k < 5; ++k) root.parts.push_back(random.make(4));
    const long bits = bitsOf(root);
    const Type type = typeOf(root);
    EXPECT_EQ(bits, 8L * static_cast<long>(type.structure->size));
    expectSamePlaces(root, type, "");
  }
}

// Values.

Constant number(std::int64_t value, ConstantKind kind = ConstantKind::Integer) {
  Constant constant;
  constant.kind = kind;
  constant.value = value;
  return constant;
}
Constant text(std::string characters) {
  Constant constant;
  constant.kind = ConstantKind::Text;
  constant.text = std::move(characters);
  return constant;
}

TEST(InitialBytes, OfEachType) {
  Field count = named("count", elementary("INT"));
  count.initial = {number(-2)};
  Field name = named("name", elementary("STRING"));
  name.type.length = 4;
  name.initial = {text("ab")};
  Field flags = named("flags", arrayOf({{0, 9}}, elementary("BOOL")));
  flags.initial = {number(1, ConstantKind::Boolean), number(0, ConstantKind::Boolean),
                   number(1, ConstantKind::Boolean)};
  Field speed = named("speed", elementary("REAL"));
  speed.initial = {number(0x3F800000, ConstantKind::Real)};
  const Type type = structOf({count, name, flags, speed});
  EXPECT_EQ(initialBytes(*type.structure),
            (std::vector<std::uint8_t>{0xFF, 0xFE, 4, 2, 'a', 'b', 0, 0, 0x05, 0x00, 0x3F, 0x80, 0, 0}));
}

TEST(InitialBytes, WhereNothingIsSaid) {
  Type label = elementary("STRING");
  label.length = 3;
  const Type type = structOf({named("c", elementary("CHAR")), named("s", label), named("any", elementary("ANY"))});
  // A blank; the longest length; the null pointer P#P 0.0 VOID 0 (002:2265).
  EXPECT_EQ(initialBytes(*type.structure),
            (std::vector<std::uint8_t>{' ', 0, 3, 0, 0, 0, 0, 0, 0x10, 0, 0, 0, 0, 0, 0x80, 0, 0, 0}));
}

TEST(InitialBytes, ValuesThatDoNotFitAreNamed) {
  std::vector<std::uint8_t> bytes(10);
  const Type list = arrayOf({{1, 3}}, elementary("INT"));
  const std::vector<Constant> four = {number(1), number(2), number(3), number(4)};
  const auto tooMany = writeValues(list, four, 0, 0, bytes);
  ASSERT_TRUE(tooMany.has_value());
  EXPECT_TRUE(tooMany->tooMany);
  EXPECT_EQ(tooMany->value, 3u);
  EXPECT_EQ(bytes, (std::vector<std::uint8_t>{0, 1, 0, 2, 0, 3, 0, 0, 0, 0}));
  const std::vector<Constant> tooLarge = {number(1), number(40000)};
  const auto wrong = writeValues(list, tooLarge, 0, 0, bytes);
  ASSERT_TRUE(wrong.has_value());
  EXPECT_FALSE(wrong->tooMany);
  EXPECT_EQ(wrong->value, 1u);
}

TEST(InitialBytes, APointerHasItsBlockInFront) {
  std::vector<std::uint8_t> bytes(10);
  Constant any = number(0x84000000 | 5 << 3, ConstantKind::Any);  // P#DB60.DBX5.0 BYTE 26
  any.block = 60;
  any.anyType = 2;
  any.anyCount = 26;
  EXPECT_FALSE(writeValues(elementary("ANY"), std::vector<Constant>{any}, 0, 0, bytes).has_value());
  EXPECT_EQ(bytes, (std::vector<std::uint8_t>{0x10, 2, 0, 26, 0, 60, 0x84, 0, 0, 40}));  // 002:2275-2288
}

TEST(Names, CompareWithoutCase) {
  EXPECT_TRUE(isSameName("Motor_1", "MOTOR_1"));
  EXPECT_TRUE(isSameName("F\xC3\xBCller", "F\xC3\x9CLLER"));
  EXPECT_TRUE(isSameName("\xD0\x9D\xD0\xB0\xD1\x81\xD0\xBE\xD1\x81", "\xD0\xBD\xD0\xB0\xD1\x81\xD0\xBE\xD1\x81"));
  EXPECT_FALSE(isSameName("Motor", "Motor1"));
}

}  // namespace
}  // namespace rungproof::s7300
