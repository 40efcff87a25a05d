// Structure of pictures: every element once, nothing on top of anything else, every wire connected, within the page.
// Checked on networks built by hand and on random ones of series and parallel parts.
#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>

#include "frontend/picture/box_form.hpp"
#include "frontend/picture/placement.hpp"
#include "frontend/text/excerpt.hpp"
#include "tests/show/drawings.hpp"

namespace rungproof::show_test {
namespace {

using Index = Builder::Index;

Picture pictureOf(const Drawing& drawing, Form form, int width = 1000) {
  const ElementTexts texts(nullptr, nullptr, drawing);
  const PlacedPicture placed = place(form == Form::Fbd ? fbdNodes(drawing, texts) : ladderNodes(drawing, texts));
  EXPECT_EQ(placed.reason, "");
  return wrapped(placed.picture, width);
}

/// Every element that is an instruction has exactly one symbol, or in FBD one name.
void expectEveryElementOnce(const Drawing& drawing, const Picture& picture) {
  std::map<int, int> seen;
  std::set<int> symbols;
  for (const PictureSymbol& symbol : picture.symbols) {
    ++seen[symbol.element];
    symbols.insert(symbol.element);
  }
  for (const PictureLabel& label : picture.labels) {
    if (label.element >= 0 && !symbols.contains(label.element)) ++seen[label.element];
  }
  for (std::size_t i = 0; i < drawing.elements.size(); ++i) {
    if (drawing.elements[i].desc == nullptr) continue;
    EXPECT_EQ(seen[static_cast<int>(i)], 1) << "element " << i << " " << drawing.elements[i].desc->stl;
  }
}

/// Cells of labels, contacts and coils, and edges of boxes: no cell is used twice.
void expectNoOverlap(const Picture& picture) {
  std::map<std::pair<int, int>, std::string> cells;
  const auto take = [&](int x, int y, const std::string& what) {
    const auto [place, isNew] = cells.emplace(std::pair{x, y}, what);
    EXPECT_TRUE(isNew) << what << " and " << place->second << " at column " << x << ", row " << y;
  };
  for (const PictureSymbol& s : picture.symbols) {
    for (int y = s.y; y < s.y + s.height; ++y) {
      for (int x = s.x; x < s.x + s.width; ++x) {
        const bool isEdge = y == s.y || y == s.y + s.height - 1 || x == s.x || x == s.x + s.width - 1;
        if (s.kind != SymbolKind::Box || isEdge) take(x, y, "symbol of element " + std::to_string(s.element));
      }
    }
  }
  for (const PictureLabel& label : picture.labels) {
    EXPECT_GE(label.x, 0) << label.text;
    EXPECT_LT(label.y, picture.height) << label.text;
    for (int x = label.x; x < label.x + displayWidth(label.text); ++x) take(x, label.y, "'" + label.text + "'");
  }
  // Wires run beside labels, never through them.
  for (const PictureWire& wire : picture.wires) {
    for (int y = std::min(wire.y0, wire.y1); y <= std::max(wire.y0, wire.y1); ++y) {
      for (int x = wire.x0; x <= wire.x1; ++x) {
        const auto found = cells.find({x, y});
        if (found != cells.end()) {
          EXPECT_EQ(found->second.front(), 's')
              << "a wire runs through " << found->second << " at column " << x << ", row " << y;
        }
      }
    }
  }
}

/// Both ends of every wire touch a rail, a symbol, a name, or a wire of the same power.
void expectConnected(const Picture& picture) {
  const auto touches = [&](int x, int y, const PictureWire& self) {
    for (const PictureRail& rail : picture.rails) {
      if (rail.x == x && rail.y0 <= y && y <= rail.y1) return true;
    }
    for (const PictureSymbol& s : picture.symbols) {
      if (s.x <= x && x < s.x + s.width && s.y <= y && y < s.y + s.height) return true;
    }
    for (const PictureDot& circle : picture.circles) {
      if (circle.y == y && circle.x - 1 == x) return true;
    }
    for (const PictureLabel& label : picture.labels) {
      const int end = label.x + displayWidth(label.text);
      if (label.y == y && (end == x || end + 1 == x || label.x == x + 1 || label.x == x + 2)) return true;
    }
    for (const PictureWire& w : picture.wires) {
      if (&w == &self) continue;
      const int y0 = std::min(w.y0, w.y1), y1 = std::max(w.y0, w.y1);
      if (w.x0 <= x && x <= w.x1 && y0 <= y && y <= y1) return true;
    }
    return false;
  };
  for (const PictureWire& wire : picture.wires) {
    EXPECT_TRUE(touches(wire.x0, wire.y0, wire))
        << "wire begins in the air at column " << wire.x0 << ", row " << wire.y0;
    EXPECT_TRUE(touches(wire.x1, wire.y1, wire)) << "wire ends in the air at column " << wire.x1 << ", row " << wire.y1;
  }
}

void expectSound(const Drawing& drawing, Form form, int width = 1000) {
  const Picture picture = pictureOf(drawing, form, width);
  expectEveryElementOnce(drawing, picture);
  expectNoOverlap(picture);
  expectConnected(picture);
}

void expectSoundInBothForms(const Drawing& drawing) {
  for (const Form form : {Form::Ladder, Form::Fbd}) {
    SCOPED_TRACE(form == Form::Ladder ? "ladder" : "FBD");
    expectSound(drawing, form);
  }
}

TEST(Layout, SeriesAndBranches) {
  Builder b;
  const Index rail = b.rail();
  const Index first = b.either({b.no("I0.0", rail), b.no("I0.1", rail), b.nc("M1.2", rail)});
  const Index second = b.either({b.no("I0.2", first), b.nc("I0.3", first)});
  b.out("Q0.0", b.nc("I0.4", second));
  expectSoundInBothForms(b.drawing);
}

TEST(Layout, BranchesToSeveralCoils) {
  Builder b;
  const Index shared = b.no("I0.0", b.rail());
  b.out("Q0.0", b.no("I0.1", shared));
  b.out("Q0.1", b.nc("I0.2", shared));
  b.coil("S", {bitOf("M1.0"), constant(3)}, shared);
  expectSoundInBothForms(b.drawing);
}

TEST(Layout, BoxesWithSeveralInputs) {
  Builder b;
  const Index rail = b.rail();
  const Index up = b.either({b.no("I0.0", rail), b.no("I0.5", rail)});
  b.box("CTUD", {bitOf("C48"), constant(4)}, {up, b.no("I0.1", rail), b.no("I0.2", rail)});
  expectSoundInBothForms(b.drawing);
}

TEST(Layout, ChainOfBoxesWithEno) {
  Builder b;
  const Index compare =
      b.contact("LDW>=", {word(Area::V, 10), constant(100)}, b.contact("EU", {}, b.no("I0.0", b.rail())));
  const Index move = b.box("MOVW", {word(Area::V, 0), word(Area::V, 4)}, {compare});
  b.out("Q1.0", b.box("+I", {constant(5), word(Area::V, 4)}, {move}));
  expectSoundInBothForms(b.drawing);
}

TEST(Layout, HeadingsStandOnTheRail) {
  for (const std::string_view mnemonic : {"LSCR", "SCRE", "NEXT"}) {
    Builder b;
    b.heading(mnemonic, mnemonic == "LSCR" ? Operands{bitOf("S0.1")} : Operands{});
    expectSoundInBothForms(b.drawing);
  }
}

/// The second part of an AND stands behind the first one; an edge there would see other power, so there is no ladder.
TEST(Layout, AndGateInLadder) {
  Builder b;
  const Index rail = b.rail();
  b.out("Q0.0", b.both({b.no("I0.0", rail), b.either({b.no("I0.1", rail), b.nc("I0.2", rail)})}));
  expectSoundInBothForms(b.drawing);
  Builder edge;
  const Index power = edge.rail();
  edge.out("Q0.0", edge.both({edge.no("I0.0", power), edge.contact("EU", {}, edge.no("I0.1", power))}));
  const ElementTexts texts(nullptr, nullptr, edge.drawing);
  EXPECT_NE(ladderNodes(edge.drawing, texts).reason.find("ladder has no AND gate"), std::string::npos);
  expectSound(edge.drawing, Form::Fbd);
}

/// Power from the middle of a branch to a coil below another branch would have to cross it.
TEST(Layout, CrossingWiresAreRefused) {
  Builder b;
  const Index rail = b.rail();
  const Index shared = b.no("I0.0", rail);
  b.out("Q0.0", b.either({shared, b.no("I0.1", rail)}));
  b.out("Q0.1", shared);
  const ElementTexts texts(nullptr, nullptr, b.drawing);
  EXPECT_EQ(place(ladderNodes(b.drawing, texts)).reason, "wires would cross");
}

TEST(Layout, WideRungsAreWrapped) {
  Builder b;
  const Index rail = b.rail();
  Index at = rail;
  for (int i = 0; i < 30; ++i)
    at = b.either({b.no("V" + std::to_string(1000 + i) + ".3", at), b.no("M0.1", i == 0 ? rail : at)});
  b.out("Q0.0", at);
  for (const int width : {60, 80, 100}) {
    expectSound(b.drawing, Form::Ladder, width);
    const Picture picture = pictureOf(b.drawing, Form::Ladder, width);
    EXPECT_LE(picture.width, std::max(width, 72));
    for (const PictureLabel& label : picture.labels)
      EXPECT_LE(label.x + displayWidth(label.text), std::max(width, 72)) << label.text;
  }
}

/// Series, branches, several coils and boxes at random; what a ladder can hold.
class RandomNetwork {
 public:
  explicit RandomNetwork(unsigned seed) : random_(seed) {}

  Drawing make() {
    const Index rail = builder_.rail();
    Index at = part(rail, 3);
    const int sinks = 1 + pick(3);
    for (int i = 0; i < sinks; ++i) {
      const Index from = pick(2) == 0 && sinks > 1 ? part(at, 1) : at;
      switch (pick(4)) {
        case 0: builder_.box("TON", {bitOf("T37"), constant(100)}, {from}); break;
        case 1: builder_.coil("R", {bitOf("M3.0"), constant(8)}, from); break;
        default: builder_.out(address("Q"), from); break;
      }
    }
    return std::move(builder_.drawing);
  }

 private:
  int pick(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
  std::string address(const std::string& area) {
    return area + std::to_string(pick(16)) + "." + std::to_string(pick(8));
  }
  Index part(Index from, int depth) {
    switch (depth == 0 ? 0 : pick(4)) {
      case 1: {
        std::vector<Index> branches;
        const int count = 2 + pick(2);
        for (int i = 0; i < count; ++i) branches.push_back(part(from, depth - 1));
        return builder_.either(branches);
      }
      case 2: return part(part(from, depth - 1), depth - 1);
      case 3:
        return builder_.contact(
            "LDW>=", {word(Area::V, static_cast<std::uint32_t>(2 * pick(500))), constant(pick(30000))}, from);
      default: return pick(2) == 0 ? builder_.no(address("I"), from) : builder_.nc(address("M"), from);
    }
  }
  std::mt19937 random_;
  Builder builder_;
};

TEST(Layout, RandomNetworks) {
  for (unsigned seed = 1; seed <= 300 && !HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    expectSound(RandomNetwork(seed).make(), Form::Ladder, seed % 2 == 0 ? 1000 : 80);
  }
}

TEST(BoxForm, NamesSignsAndPins) {
  const auto pins = [](std::string_view mnemonic) {
    std::string text;
    for (const OperandPin& pin : operandPins(*s7200Instructions().named(mnemonic), 5, nullptr)) {
      text += (text.empty() ? "" : " ") +
              std::string(pin.side == PinSide::Above  ? "^"
                          : pin.side == PinSide::Left ? "<"
                                                      : ">") +
              pin.name + std::to_string(pin.operand);
    }
    return text;
  };
  EXPECT_EQ(s7200Instructions().named("+I")->drawnName(), "ADD_I");
  EXPECT_EQ(s7200Instructions().named("TON.IEC")->drawnName(), "TON");
  EXPECT_EQ(s7200Instructions().named("FND<>")->drawnName(), "TBL_FIND <>");
  EXPECT_EQ(s7200Instructions().named("LDW>=")->drawnName(), ">=I");
  EXPECT_EQ(s7200Instructions().named("LDR=")->drawnName(), "==R");
  EXPECT_EQ(s7200Instructions().named("LDNI")->drawnName(), "/I");
  EXPECT_EQ(s7200Instructions().named("EU")->drawnName(), "P");
  EXPECT_EQ(s7200Instructions().named("=I")->drawnName(), "I");
  EXPECT_EQ(s7200Instructions().named("CRET")->drawnName(), "RET");
  EXPECT_EQ(pins("TON"), "^Txx0 <PT1");
  EXPECT_EQ(pins("MOVW"), "<IN0 >OUT1");
  EXPECT_EQ(pins("INCW"), "<IN0 >OUT0");
  EXPECT_EQ(pins("+I"), "<IN10 <IN21 >OUT1");
  // STL: OUT - IN1 = OUT (001:4814); the box subtracts IN2 from IN1.
  EXPECT_EQ(pins("-I"), "<IN11 <IN20 >OUT1");
  EXPECT_EQ(powerPins(*s7200Instructions().named("CTUD")), (std::vector<std::string>{"CU", "CD", "R"}));
  EXPECT_EQ(powerPins(*s7200Instructions().named("RS")), (std::vector<std::string>{"S", "R1"}));
}

}  // namespace
}  // namespace rungproof::show_test
