// Which networks of a witness are drawn.
#include "frontend/simulation/witness_drawing.hpp"

#include <gtest/gtest.h>

#include "frontend/input/project.hpp"
#include "frontend/text/excerpt.hpp"

namespace rungproof {
namespace {

/// The networks that drive the property's output, and those that drive what they read; not the others.
TEST(WitnessDrawing, NetworksThatMatter) {
  const Program program =
      readText("test.awl",
               "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD I0.0\n= M0.0\nNetwork 2\nLD I0.5\n= Q1.0\nNetwork "
               "3\nLD M0.0\n= Q0.0\nNetwork 4\nLD Q0.0\nTON T37, 10\nEND_ORGANIZATION_BLOCK\n",
               {});
  ProofResult result;
  ExprNode node;
  node.op = ExprOp::Address;
  node.operand = direct(Area::Q, Width::Bit, 0, 0);
  result.property.first.nodes.push_back(node);
  std::string numbers;
  for (const auto& [pou, network] : networksThatMatter(program, result))
    numbers += std::to_string(network->number) + " ";
  EXPECT_EQ(numbers, "1 3 ");
}

Operand outputBit() { return direct(Area::Q, Width::Bit, 0, 0); }

/// A run of a program that asks about Q0.0: I0.0 is `values[n]` in scan n + 1.
ProofResult runWith(const std::vector<std::uint64_t>& values) {
  ProofResult result;
  ExprNode node;
  node.op = ExprOp::Address;
  node.operand = outputBit();
  result.property.first.nodes.push_back(node);
  Witness witness;
  for (const std::uint64_t value : values) {
    ReplayScan scan;
    scan.inputs = {{direct(Area::I, Width::Bit, 0, 0), value}};
    witness.scans.push_back(scan);
  }
  witness.scanCount = values.size();
  result.witness = witness;
  return result;
}

Program follower() {
  return readText("test.awl",
                  "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD I0.0\n= Q0.0\nEND_ORGANIZATION_BLOCK\n", {});
}

std::string wholeText(const ShownScan& scan) {
  std::string text;
  for (const std::string& line : scan.networks.at(0).text) text += line + "\n";
  return text;
}

/// Five scans, in the last of which I0.0 is 1: the first and the last are drawn, the coil is lit in the last one only.
TEST(WitnessDrawing, TheFirstAndTheLastScanAreDrawn) {
  const Program program = follower();
  const std::vector<ShownScan> scans = shownScans(program, Choices(), runWith({0, 0, 0, 0, 1}),
                                                  {.form = Form::Ladder, .lastScans = 1, .text = true, .svg = true});
  ASSERT_EQ(scans.size(), 2U);
  EXPECT_EQ(scans[0].scan, 1U);
  EXPECT_EQ(scans[1].scan, 5U);
  EXPECT_EQ(scans[1].timeMs, 50);  // five scans of 10 ms
  EXPECT_NE(wholeText(scans[0]).find("Q0.0=0"), std::string::npos);
  EXPECT_NE(wholeText(scans[1]).find("Q0.0=1"), std::string::npos);
  EXPECT_NE(scans[1].networks[0].svg.find("class=\"rw on\""), std::string::npos);
  EXPECT_EQ(scans[1].networks[0].heading, "MAIN, Network 1");
}

/// Q0.0 follows I0.0, so it changes in scans 3 and 4; of many changes the last four are drawn.
TEST(WitnessDrawing, ScansInWhichTheOutputChangesAreDrawn) {
  const Program program = follower();
  const auto scans = [&](const std::vector<std::uint64_t>& values) {
    return scansThatMatter(program, Choices(), runWith(values));
  };
  using Scans = std::set<std::uint64_t>;
  EXPECT_EQ(scans({0, 0, 1, 0, 0, 0, 0}), (Scans{1, 3, 4, 7}));
  EXPECT_EQ(scans({1, 0, 1, 0, 1, 0, 1, 0}), (Scans{1, 5, 6, 7, 8}));
  EXPECT_EQ(scans({1}), Scans{1});
}

/// A page has the last scans; what is drawn as text beside them is the last scan alone where that is wanted.
TEST(WitnessDrawing, APageHasTheLastScans) {
  const Program program = follower();
  const std::vector<ShownScan> page = shownScans(program, Choices(), runWith({0, 1, 0, 1, 0}),
                                                 {.lastScans = 3, .lastOnly = true, .text = true, .svg = true});
  ASSERT_EQ(page.size(), 3U);
  EXPECT_EQ(page[0].scan, 3U);
  EXPECT_TRUE(page[1].networks[0].text.empty());
  EXPECT_FALSE(page[2].networks[0].text.empty());
  EXPECT_FALSE(page[1].networks[0].svg.empty());
}

/// No line of a drawing is longer than the width that was asked for.
TEST(WitnessDrawing, LongRungsAreWrappedToTheWidth) {
  std::string rung = "LD I0.0\n";
  for (int bit = 1; bit < 8; ++bit) rung += "A I0." + std::to_string(bit) + "\n";
  const Program program = readText(
      "test.awl", "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\n" + rung + "= Q0.0\nEND_ORGANIZATION_BLOCK\n", {});
  for (const int width : {50, 80}) {
    const std::vector<ShownScan> scans = shownScans(program, Choices(), runWith({1}), {.width = width});
    ASSERT_EQ(scans.size(), 1U);
    for (const std::string& line : scans[0].networks.at(0).text) EXPECT_LE(displayWidth(line), width) << line;
  }
}

}  // namespace
}  // namespace rungproof
