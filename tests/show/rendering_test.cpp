// Pictures as text and SVG. The expected drawings follow from the rules of the layout, written beside them.
#include <gtest/gtest.h>

#include <pugixml.hpp>

#include "frontend/picture/network_view.hpp"
#include "frontend/picture/placement.hpp"
#include "frontend/picture/svg_picture.hpp"
#include "frontend/picture/text_picture.hpp"
#include "tests/show/drawings.hpp"

namespace rungproof::show_test {
namespace {

using Index = Builder::Index;

std::string textOf(const Drawing& drawing, Form form, const TextStyle& style = {},
                   const std::vector<ElementFlow>* flows = nullptr, int width = 1000) {
  ElementTexts texts(nullptr, nullptr, drawing);
  texts.setFlow(flows);
  const PlacedPicture placed = place(form == Form::Fbd ? fbdNodes(drawing, texts) : ladderNodes(drawing, texts), width);
  EXPECT_EQ(placed.reason, "");
  std::string text = "\n";
  for (const std::string& line : textLines(wrapped(placed.picture, width), style)) text += line + "\n";
  return text;
}

Drawing latch() {
  Builder b;
  const Index rail = b.rail();
  b.out("Q0.0", b.nc("I0.1", b.either({b.no("I0.0", rail), b.no("Q0.0", rail)})));
  return b.drawing;
}

// A contact is 3 cells wide with 2 cells of wire on each side, a border between columns is one cell; addresses stand
// above. The branch shares the column of the contact it bridges; the coil stands at the right rail, 72 columns from the
// left.
TEST(Text, Latch) {
  EXPECT_EQ(textOf(latch(), Form::Ladder), R"(
│ I0.0    I0.1                                                   Q0.0  │
├──┤ ├──┬──┤/├────────────────────────────────────────────────────( )──┤
│ Q0.0  │                                                              │
├──┤ ├──┘                                                              │
)");
}

TEST(Text, LatchInAscii) {
  EXPECT_EQ(textOf(latch(), Form::Ladder, {.ascii = true}), R"(
| I0.0    I0.1                                                   Q0.0  |
+--| |--+--|/|----------------------------------------------------( )--+
| Q0.0  |                                                              |
+--| |--+                                                              |
)");
}

// Start pressed: I0.0 = 1, I0.1 = 0, the coil was off before. The open branch of Q0.0 carries power from the rail to
// the contact only; what follows the OR is lit.
TEST(Text, LatchWithPowerFlow) {
  const Drawing drawing = latch();
  std::vector<ElementFlow> flows(drawing.elements.size());
  const auto set = [&](std::size_t i, bool state, bool output, std::string value) {
    flows[i] = {output ? Flow3::On : Flow3::Off, state ? Flow3::On : Flow3::Off, {std::move(value)}};
  };
  // Elements in the order of latch(): rail, I0.0, Q0.0, OR, I0.1, coil.
  set(0, true, true, "");
  set(1, true, true, "1");
  set(2, false, false, "0");
  set(3, true, true, "");
  set(4, true, true, "0");
  set(5, true, true, "1");
  const std::string text = textOf(drawing, Form::Ladder, {}, &flows);
  EXPECT_NE(text.find("┣━━━┫█┣━━━┳━━━┫/┣━━━"), std::string::npos) << text;
  EXPECT_NE(text.find("━(█)━━━┥"), std::string::npos) << text;
  EXPECT_NE(text.find("┣━━━┤ ├───┚"), std::string::npos) << text;
  const std::string ascii = textOf(drawing, Form::Ladder, {.ascii = true}, &flows);
  EXPECT_NE(ascii.find("+===[#]===+===[/]==="), std::string::npos) << ascii;
  EXPECT_NE(ascii.find("+===| |---+"), std::string::npos) << ascii;
}

// Gates are as high as what leads to them; a negated contact is a circle at the pin; names end two cells before the
// wire.
TEST(Text, LatchAsFbd) {
  EXPECT_EQ(textOf(latch(), Form::Fbd), R"(
                                   Q0.0
            ┌────┐     ┌─────┐     ┌───┐
            │ OR │     │ AND │     │ = │
   I0.0 ────┤    ├─────┤     ├─────┤   │
   Q0.0 ────┤    │     │     │     └───┘
            └────┘     │     │
              I0.1 ───o│     │
                       └─────┘
)");
}

// Two power inputs: each on the row of its branch, PV below them with a blank before its value; the number of the
// counter above the box.
TEST(Text, Counter) {
  Builder b;
  const Index rail = b.rail();
  const Index up = b.no("I0.0", rail);
  b.box("CTU", {bitOf("C4"), constant(10)}, {up, b.no("I0.1", rail)});
  EXPECT_EQ(textOf(b.drawing, Form::Ladder), R"(
│              C4                                                      │
│            ┌─────┐                                                   │
│ I0.0       │ CTU │                                                   │
├──┤ ├───────┤CU   │                                                   │
│ I0.1       │     │                                                   │
├──┤ ├───────┤R    │                                                   │
│         10─┤PV   │                                                   │
│            └─────┘                                                   │
)");
}

// A cut wire ends in an arrow with a number and begins again behind the same number; the coil stays at the right.
TEST(Text, WrappedRung) {
  Builder b;
  Index at = b.rail();
  for (int i = 0; i < 9; ++i) at = b.no("I1." + std::to_string(i % 8), at);
  b.out("Q0.0", at);
  EXPECT_EQ(textOf(b.drawing, Form::Ladder, {}, nullptr, 60), R"(
│ I1.0    I1.1    I1.2    I1.3    I1.4    I1.5
├──┤ ├─────┤ ├─────┤ ├─────┤ ├─────┤ ├─────┤ ├────>1

      I1.6    I1.7    I1.0                           Q0.0  │
  1>───┤ ├─────┤ ├─────┤ ├────────────────────────────( )──┤
)") << "no wider than the page of 60 columns";
}

/// Coils stand at the border of a page that is narrower than usual, so that a short rung is in one piece.
TEST(Text, ARungThatFitsANarrowPageIsNotCut) {
  EXPECT_EQ(textOf(latch(), Form::Ladder, {}, nullptr, 40).find(">1"), std::string::npos);
}

TEST(Text, ColorOnATerminal) {
  const Drawing drawing = latch();
  std::vector<ElementFlow> flows(drawing.elements.size(), ElementFlow{Flow3::On, Flow3::On, {}});
  EXPECT_NE(textOf(drawing, Form::Ladder, {.color = true}, &flows).find("\x1B[1;32m"), std::string::npos);
  EXPECT_EQ(textOf(drawing, Form::Ladder, {.color = true}).find('\x1B'), std::string::npos);
}

TEST(Text, LabelsAreCut) {
  EXPECT_EQ(shortened("short"), "short");
  EXPECT_EQ(shortened(std::string(40, 'x')), std::string(33, 'x') + "...");
  // Wide characters take two columns.
  EXPECT_EQ(shortened("压力机启动", 8), "压力...");
}

/// A document that an XML parser reads, with one symbol for each element and all of its texts.
TEST(Svg, DocumentIsWhole) {
  const Drawing drawing = latch();
  const ElementTexts texts(nullptr, nullptr, drawing);
  NetworkView view;
  view.heading = "Network 1  <start> & \"stop\"";
  view.comments = {"self-holding"};
  view.picture = place(ladderNodes(drawing, texts)).picture;
  const std::string svg = viewSvg({{"MAIN (OB1)", {view}}});
  pugi::xml_document document;
  ASSERT_TRUE(document.load_string(svg.c_str()));
  const pugi::xml_node root = document.child("svg");
  EXPECT_GT(root.attribute("width").as_int(), 72 * svgCellWidth);
  std::string names;
  for (const pugi::xml_node& text : root.children("text")) names += std::string(text.child_value()) + "|";
  EXPECT_EQ(names, "MAIN (OB1)|Network 1  <start> & \"stop\"|self-holding|I0.0|Q0.0|I0.1|Q0.0|");
  // Everything stays on the page.
  for (const pugi::xml_node& text : root.children("text")) {
    EXPECT_GE(text.attribute("x").as_int(), 0);
    EXPECT_LT(text.attribute("x").as_int(), root.attribute("width").as_int());
    EXPECT_LT(text.attribute("y").as_int(), root.attribute("height").as_int());
  }
}

TEST(Svg, PowerIsBlue) {
  const Drawing drawing = latch();
  std::vector<ElementFlow> flows(drawing.elements.size(), ElementFlow{Flow3::On, Flow3::On, {}});
  ElementTexts texts(nullptr, nullptr, drawing);
  texts.setFlow(&flows);
  std::string svg;
  appendSvg(svg, place(ladderNodes(drawing, texts)).picture, 0, 0);
  EXPECT_NE(svg.find("class=\"rw on\""), std::string::npos);
  EXPECT_EQ(svg.find("class=\"rw off\""), std::string::npos);
}

}  // namespace
}  // namespace rungproof::show_test
