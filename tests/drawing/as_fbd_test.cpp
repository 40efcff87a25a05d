// Ladders as FBD: gates instead of series, and still the same behaviour, which the solver proves through the
// instructions of both.
#include <gtest/gtest.h>

#include <algorithm>

#include "frontend/picture/network_view.hpp"
#include "ir/desc.hpp"
#include "tests/drawing/equality.hpp"
#include "tests/drawing/networks.hpp"
#include "tests/drawing/random_network.hpp"

namespace rungproof::testing {
namespace {

std::string converted(std::string_view statements) {
  const Program program = programOf(statements);
  return textOf(asFbd(*raise(onlyNetwork(program), Form::Ladder).drawing));
}

TEST(AsFbd, SeriesBecomesOneGate) {
  EXPECT_EQ(converted("LD I0.0; A I0.1; AN I0.2; = Q0.0"),
            "1 LD I0.0(0); 2 LD I0.1(0); 3 LDN I0.2(0); 4 AND(1,2,3); 5 = Q0.0(4)");
}

TEST(AsFbd, AGroupInSeriesIsConnectedAtEachBranch) {  // the ladder's own wiring: both branches begin behind I0.0
  EXPECT_EQ(converted("LD I0.0; LD I0.1; O I0.2; ALD; = Q0.0"),
            "1 LD I0.0(0); 2 LD I0.1(0); 3 AND(1,2); 4 LD I0.2(0); 5 AND(1,4); 6 OR(3,5); 7 = Q0.0(6)");
}

TEST(AsFbd, EdgesAndBoxesStandBehindTheirInput) {
  EXPECT_EQ(converted("LD I0.0; A I0.1; EU; MOVB 1, VB0; AENO; A I0.2; = Q0.0"),
            "1 LD I0.0(0); 2 LD I0.1(0); 3 AND(1,2); 4 EU(3); 5 MOVB 1, VB0(4); 6 LD I0.2(0); 7 AND(5,6); 8 = Q0.0(7)");
}

TEST(AsFbd, DoesTheSameWithGatesOfAtMost32Inputs) {
  std::mt19937_64 random(drawingSeed() + 4);
  for (int i = 0; i < 15; ++i) {
    const std::string statements = randomRung(random, Form::Ladder);
    const Program program = programOf(statements);
    const Drawing fbd = asFbd(*raise(onlyNetwork(program), Form::Ladder).drawing);
    for (const Element& element : fbd.elements) {
      const bool isSeries =
          element.shape == Shape::Contact && element.desc->stack.pushes == 1 && element.inputs[0].from != 0;
      EXPECT_FALSE(isSeries) << textOf(fbd);
      EXPECT_LE(element.inputs.size(), maxGateInputs);
    }
    const Lowered result = lower(fbd);
    ASSERT_FALSE(result.fault) << statements;
    ASSERT_EQ(difference(fbd, result.instructions, result.instructionOf), "") << textOf(fbd) << "\n"
                                                                              << textOf(result.instructions);
    ASSERT_EQ(difference(result.instructions, onlyNetwork(program).instructions), "")
        << "seed " << drawingSeed() + 4 << ": " << statements;
  }
  Drawing wide;
  wide.elements.emplace_back();
  Element join = element(Shape::Or, "", {});
  for (std::uint32_t i = 1; i <= 70; ++i) {
    wide.elements.push_back(element(Shape::Contact, "LD I0.0", {{0, false}}));
    join.inputs.push_back({i, false});
  }
  wide.elements.push_back(join);
  wide.elements.push_back(element(Shape::Coil, "= Q0.0", {{71, false}}));
  const Drawing divided = asFbd(wide);  // 32, then 31 more, then the other 7
  const auto isOr = [](const Element& each) { return each.shape == Shape::Or; };
  EXPECT_EQ(std::count_if(divided.elements.begin(), divided.elements.end(), isOr), 3);
}

TEST(AsFbd, ShowsALadderWhoseInstructionsHaveNoPicture) {  // what stands beside a counter waits in L60.0
  Drawing ladder;
  ladder.elements.emplace_back();
  const auto add = [&](Shape shape, std::string_view instruction, std::vector<Wire> inputs) {
    ladder.elements.push_back(element(shape, instruction, std::move(inputs)));
    return static_cast<std::uint32_t>(ladder.elements.size() - 1);
  };
  const std::uint32_t edge = add(Shape::Contact, "EU", {{add(Shape::Contact, "LD I0.0", {{0, false}}), false}});
  const std::uint32_t reset = add(Shape::Contact, "LD I0.1", {{0, false}});
  add(Shape::Box, "CTU C1, +5", {{edge, false}, {reset, false}});
  add(Shape::Coil, "= Q0.0", {{add(Shape::Contact, "LD I0.2", {{edge, false}}), false}});
  Program program = programOf("LD I0.0; = Q0.0");
  Network& network = program.pous[0].networks[0];
  network.form = Form::Ladder;
  ASSERT_FALSE(lowerInto(network, ladder));
  ASSERT_FALSE(raise(network, Form::Fbd).drawing);
  program.number();
  ViewOptions options;
  options.form = Form::Fbd;
  const NetworkView view = networkView(program, program.pous[0], network, options);
  EXPECT_EQ(view.reason, "");
  EXPECT_TRUE(view.statements.empty());
}

}  // namespace
}  // namespace rungproof::testing
