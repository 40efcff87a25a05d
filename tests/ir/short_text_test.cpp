// The small records that instructions and findings are made of: texts in eight bytes, shared values, rows of operands.
#include "ir/short_text.hpp"

#include <gtest/gtest.h>

#include <utility>

#include "ir/finding.hpp"
#include "ir/flow.hpp"
#include "ir/operands.hpp"
#include "ir/program.hpp"

namespace rungproof {
namespace {

TEST(ShortText, HoldsTextsOfEveryLength) {
  std::string text;
  for (int length = 0; length < 40; ++length, text += static_cast<char>('a' + length % 26)) {
    const ShortText held = text;
    EXPECT_EQ(held, text);
    EXPECT_EQ(held.size(), text.size());
    EXPECT_EQ(held.empty(), text.empty());
    const ShortText copy = held;
    EXPECT_EQ(copy, held);
    ShortText moved = copy;
    const ShortText target = std::move(moved);
    EXPECT_EQ(target.view(), text);
  }
}

TEST(ShortText, IsGivenAnotherText) {
  ShortText text = "a text that is not short";
  text = "short";
  EXPECT_EQ(text, "short");
  text += " and longer again";
  EXPECT_EQ(text, "short and longer again");
  const ShortText& self = text;
  text = self;
  EXPECT_EQ(text, "short and longer again");
  text = std::string_view(text).substr(6);
  EXPECT_EQ(text, "and longer again");
  EXPECT_EQ("> " + text + "\0 <", "> and longer again");
  EXPECT_LT(ShortText("M0.0"), ShortText("M0.1"));
  EXPECT_TRUE(text.starts_with("and") && text.starts_with('a') && text.ends_with("again"));
  EXPECT_EQ(text.find("longer"), 4U);
  EXPECT_EQ(std::hash<ShortText>()(text), std::hash<std::string_view>()("and longer again"));
}

TEST(ShortText, KeepsZerosAndBytesBeyondAscii) {
  const std::string text("\0\xC3\xA4\0z", 5);
  EXPECT_EQ(std::string(ShortText(text)), text);
  EXPECT_FALSE(ShortText(std::string(1, '\0')).empty());
}

TEST(Shared, IsHeldByItsCopies) {
  Shared<std::string> none;
  EXPECT_TRUE(none == nullptr);
  none = Shared<std::string>(std::string("a value that lies on the heap"));
  const Shared<std::string> copy = none;
  none = nullptr;
  EXPECT_EQ(*copy, "a value that lies on the heap");
  EXPECT_EQ(copy->size(), 29U);
}

TEST(Operands, BehaveAsAVector) {
  Operands row;
  EXPECT_TRUE(row.empty());
  for (int i = 0; i < 5; ++i) row.push_back(constant(i));
  row.insert(row.begin() + 1, constant(7));
  row.erase(row.begin());
  ASSERT_EQ(row.size(), 5U);
  EXPECT_EQ(row[0].value, 7);
  EXPECT_EQ(row.back().value, 4);
  const Operands more{direct(Area::Q, Width::Bit, 0), direct(Area::M, Width::Word, 2)};
  row.insert(row.begin() + 1, more.begin(), more.end());
  EXPECT_EQ(row[1].area, Area::Q);
  EXPECT_EQ(row[3].value, 1);
  row.resize(2);
  Operands copy = row;
  row.clear();
  EXPECT_EQ(copy.size(), 2U);
  copy = Operands();
  EXPECT_EQ(copy.begin(), copy.end());
}

/// Where a row becomes a long one, and back.
TEST(Operands, HaveAnyNumber) {
  for (int count = 0; count < 70; ++count) {
    Operands row;
    for (int i = 0; i < count; ++i) row.push_back(constant(i));
    EXPECT_EQ(row.size(), static_cast<std::size_t>(count));
    Operands copy(row.begin(), row.end());
    copy.resize(copy.size() + 3);
    ASSERT_EQ(copy.size(), row.size() + 3);
    EXPECT_EQ(copy.back().kind, OperandKind::Missing);
    copy.erase(copy.end() - 3, copy.end());
    for (; !row.empty(); row.pop_back(), copy.pop_back()) {
      EXPECT_EQ(row.back().value, static_cast<int>(row.size()) - 1);
      EXPECT_EQ(copy.back().value, row.back().value);
    }
    EXPECT_TRUE(copy.empty());
    row = {constant(count)};
    row.erase(row.begin());
    EXPECT_TRUE(row.empty());
  }
}

/// A long program has millions of them.
TEST(Records, AreSmall) {
  EXPECT_LE(sizeof(Operand), 48U);
  EXPECT_LE(sizeof(Instruction), 40U);
  EXPECT_LE(sizeof(FlowStep), 16U);
  EXPECT_LE(sizeof(Network), 128U);
  EXPECT_LE(sizeof(Finding), 104U);
}

}  // namespace
}  // namespace rungproof
