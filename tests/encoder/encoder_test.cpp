// Small programs whose transition system can be written down by hand.
#include "analysis/encoding/encoder.hpp"

#include <gtest/gtest.h>

#include "tests/encoder/statements.hpp"

namespace rungproof {
namespace {

Node cellOf(const EncodedScan& encoding, std::string_view name) {
  for (const Variable& v : encoding.graph().variables()) {
    if (v.name == name) return v.node;
  }
  return noNode;
}
Node bitAtEnd(EncodedScan& encoding, std::string_view operand) { return encoding.atEnd(operandOf(operand), 1); }

TEST(Encoder, SeriesContactIsOneAnd) {
  const Program program = programOf("LD I0.0\nAN I0.1\n= Q0.0");
  EncodedScan encoding(program, {});
  Graph& g = encoding.graph();
  const Node expected = g.make(Op::And, 1, cellOf(encoding, "I0.0"), g.make(Op::Not, 1, cellOf(encoding, "I0.1")));
  EXPECT_EQ(bitAtEnd(encoding, "Q0.0"), expected);
}

TEST(Encoder, LatchIsSetOrHeldAndNotReset) {
  const Program program = programOf("LD I0.0\nS Q0.0, 1\nLD I0.1\nR Q0.0, 1");
  EncodedScan encoding(program, {});
  Graph& g = encoding.graph();
  const Node set = cellOf(encoding, "I0.0"), reset = cellOf(encoding, "I0.1"), old = cellOf(encoding, "Q0.0");
  EXPECT_EQ(bitAtEnd(encoding, "Q0.0"), g.make(Op::And, 1, g.make(Op::Or, 1, set, old), g.make(Op::Not, 1, reset)));
  ASSERT_EQ(encoding.bitWrites().size(), 2U);
  EXPECT_EQ(encoding.bitWrites()[0].guard, set);
  EXPECT_EQ(encoding.bitWrites()[1].guard, reset);
}

TEST(Encoder, WordsThatAreOnlyMovedAreOneVariable) {
  const Program program = programOf("LD I0.0\nMOVW VW10, VW20");
  EncoderOptions options;
  options.externals = {{Area::V, 10, 11}};  // otherwise VW10 would be the constant 0
  EncodedScan encoding(program, options);
  Graph& g = encoding.graph();
  const Node from = cellOf(encoding, "VW10"), to = cellOf(encoding, "VW20"), enable = cellOf(encoding, "I0.0");
  EXPECT_EQ(encoding.atEnd(operandOf("VW20"), 16), g.make(Op::Ite, 16, enable, from, to));
  EXPECT_EQ(encoding.atEnd(operandOf("VW10"), 16), from);
}

TEST(Encoder, JumpedOverCodeKeepsItsOutput) {
  const Program program = programOf("LD I0.0\nJMP 1\nLD I0.1\n= Q0.0\nLBL 1\nLD I0.2\n= Q0.1");
  EncodedScan encoding(program, {});
  Graph& g = encoding.graph();
  const Node jump = cellOf(encoding, "I0.0");
  EXPECT_EQ(bitAtEnd(encoding, "Q0.0"), g.make(Op::Ite, 1, jump, cellOf(encoding, "Q0.0"), cellOf(encoding, "I0.1")));
  EXPECT_EQ(bitAtEnd(encoding, "Q0.1"), cellOf(encoding, "I0.2"));  // the guards join again
}

TEST(Encoder, ForLoopIsUnrolledByItsConstantBounds) {
  // Three rounds add VW2 three times; INDX ends one above FINAL (001:5768).
  const Program program = programOf("LD I0.0\nFOR VW10, 1, 3\nLD SM0.0\nXORW VW2, VW0\nNEXT");
  EncoderOptions options;
  options.externals = {{Area::V, 2, 3}};
  EncodedScan encoding(program, options);
  Graph& g = encoding.graph();
  const Node enable = cellOf(encoding, "I0.0"), sum = cellOf(encoding, "VW0");
  EXPECT_EQ(encoding.atEnd(operandOf("VW10"), 16),
            g.make(Op::Ite, 16, enable, g.constantNode(4, 16), cellOf(encoding, "VW10")));
  const Node once = g.make(Op::Xor, 16, sum, cellOf(encoding, "VW2"));
  EXPECT_EQ(
      encoding.atEnd(operandOf("VW0"), 16),
      g.make(Op::Ite, 16, enable,
             g.make(Op::Xor, 16, g.make(Op::Xor, 16, once, cellOf(encoding, "VW2")), cellOf(encoding, "VW2")), sum));
}

TEST(Encoder, MemoryThatNothingWritesIsConstant) {
  const Program program = programOf("LD M0.0\nO I0.0\n= Q0.0\nLD I0.1\nMOVW VW10, VW20");
  EncodedScan encoding(program, {});
  EXPECT_EQ(bitAtEnd(encoding, "Q0.0"), cellOf(encoding, "I0.0"));
  EXPECT_EQ(encoding.atEnd(operandOf("VW20"), 16), encoding.graph().constantNode(0, 16));
}

TEST(Encoder, AlwaysOnBitThatTheProgramOverwritesIsNoConstant) {
  const Program program = programOf("LD I0.0\nR SM0.0, 1\nLD SM0.0\n= Q0.0");
  EncodedScan encoding(program, {});
  Graph& g = encoding.graph();
  const Node held = g.make(Op::And, 1, cellOf(encoding, "SM0.0"), g.make(Op::Not, 1, cellOf(encoding, "I0.0")));
  EXPECT_EQ(bitAtEnd(encoding, "Q0.0"), held);
}

}  // namespace
}  // namespace rungproof
