// Random rungs come back from their drawings instruction by instruction; random drawings are lowered to instructions
// that the solver proves equal to executing the drawing element by element.
#include <gtest/gtest.h>

#include "tests/drawing/equality.hpp"
#include "tests/drawing/networks.hpp"
#include "tests/drawing/random_network.hpp"

namespace rungproof::testing {
namespace {

void expectRoundTrips(Form form) {
  std::mt19937_64 random(drawingSeed());
  for (int i = 0; i < 1000; ++i) {
    const std::string statements = randomRung(random, form);
    ASSERT_EQ(roundTrip(statements, form), spelled(statements)) << "seed " << drawingSeed() << ", rung " << i;
  }
}

TEST(RandomRungs, LadderGivesTheSameInstructions) { expectRoundTrips(Form::Ladder); }
TEST(RandomRungs, FbdGivesTheSameInstructions) { expectRoundTrips(Form::Fbd); }

TEST(RandomRungs, LadderRungsAreDrawnAsFbdToo) {
  std::mt19937_64 random(drawingSeed() + 1);
  for (int i = 0; i < 500; ++i) {
    const std::string statements = randomRung(random, Form::Ladder);
    ASSERT_EQ(roundTrip(statements, Form::Fbd), spelled(statements)) << "seed " << drawingSeed() + 1 << ", rung " << i;
  }
}

TEST(RandomRungs, DrawingsDoWhatTheirRungsDo) {
  std::mt19937_64 random(drawingSeed() + 2);
  for (int i = 0; i < 40; ++i) {
    for (const Form form : {Form::Ladder, Form::Fbd}) {
      const std::string statements = randomRung(random, form);
      const Program program = programOf(statements);
      const Raised result = raise(onlyNetwork(program), form);
      ASSERT_TRUE(result.drawing) << statements << ": " << result.reason;
      const std::vector<Instruction>& instructions = onlyNetwork(program).instructions;
      std::vector<std::uint32_t> positions;
      for (const Element& element : result.drawing->elements) positions.push_back(element.instruction);
      ASSERT_EQ(difference(*result.drawing, instructions, positions), "")
          << "seed " << drawingSeed() + 2 << ": " << statements;
    }
  }
}

TEST(RandomDrawings, InstructionsDoWhatTheDrawingDoes) {
  std::mt19937_64 random(drawingSeed() + 3);
  int withBits = 0, refused = 0;
  for (int i = 0; i < 400; ++i) {
    const Drawing drawing = randomDrawing(random, 4 + static_cast<std::size_t>(i) % 14);
    const Lowered result = lower(drawing);
    if (result.fault) {
      ++refused;
      continue;
    }
    withBits += result.usesEditorBits ? 1 : 0;
    ASSERT_EQ(difference(drawing, result.instructions, result.instructionOf), "")
        << "seed " << drawingSeed() + 3 << ", drawing " << i << ": " << textOf(drawing) << "\n"
        << textOf(result.instructions);
  }
  EXPECT_EQ(refused, 0);    // seventeen elements never need 32 bits
  EXPECT_GT(withBits, 50);  // and many of these drawings branch in ways that the stack cannot follow
}

}  // namespace
}  // namespace rungproof::testing
