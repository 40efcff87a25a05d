// A laid-out network: where every symbol, label and wire stands, in character cells. Text and SVG are two renderings
// of the same picture, so that what fits in one fits in the other. Tested by tests/show/layout_test.cpp.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rungproof {

enum class SymbolKind : std::uint8_t {
  Contact,  ///< two bars with a sign between them: ┤/├
  Coil,     ///< two arcs with a sign between them: (S)
  Bracket,  ///< a heading that stands on the rail: [SCR]
  Box       ///< a frame; its name and pins are labels
};

/// Whether power flows: unknown in a picture that shows no scan.
enum class Flow3 : std::uint8_t { Unknown, Off, On };

/// x, y: left upper cell. Contacts, coils and brackets are one row high.
struct PictureSymbol {
  SymbolKind kind = SymbolKind::Contact;
  int element = -1;  ///< index in the drawing
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 1;
  std::string sign;              ///< "/", "P", ">=I", "S"; a blank for the plain ones
  Flow3 state = Flow3::Unknown;  ///< contact: closed; coil: energised; box: its first power input
  /// Contact: whether tests have seen its bit as 1 and as 0; nothing: they are not asked.
  std::optional<std::pair<bool, bool>> seen{};
};

enum class LabelRole : std::uint8_t { Symbol, Address, Constant, BoxName, PinName, Note, Mark, Connector };
enum class Align : std::uint8_t { Left, Centre, Right };

/// x: left cell; the label is as wide as its text.
struct PictureLabel {
  LabelRole role = LabelRole::Address;
  int element = -1;
  int x = 0;
  int y = 0;
  std::string text;
  Align align = Align::Left;  ///< which of its points stands exactly, where a font is narrower than a cell
  int severity = -1;          ///< Mark: Severity of the worst finding
  bool halfRight = false;     ///< Centre: the true middle is half a cell further to the right
};

/// A straight line from cell to cell, both included. Lines of one net that touch are connected.
struct PictureWire {
  int x0 = 0;
  int y0 = 0;
  int x1 = 0;
  int y1 = 0;
  int net = 0;  ///< node that drives it
  Flow3 state = Flow3::Unknown;

  bool isVertical() const { return x0 == x1 && y0 != y1; }
};

/// A place where more than two lines of a net meet.
struct PictureDot {
  int x = 0;
  int y = 0;
  Flow3 state = Flow3::Unknown;
};

struct PictureRail {
  int x = 0;
  int y0 = 0;
  int y1 = 0;
  Flow3 state = Flow3::Unknown;
};

struct Picture {
  int width = 0;   ///< columns
  int height = 0;  ///< rows
  std::vector<PictureRail> rails;
  std::vector<PictureWire> wires;
  std::vector<PictureDot> dots;
  std::vector<PictureDot> circles;  ///< negation circles on pins
  std::vector<PictureSymbol> symbols;
  std::vector<PictureLabel> labels;
  std::vector<int> cuts;  ///< columns at which the picture may be cut in two, ascending
};

/// Cuts a picture that is wider than `width` columns into strips below each other. A wire that is cut ends in a
/// numbered arrow and goes on behind the same number. A single column wider than the page stays as it is.
Picture wrapped(const Picture& picture, int width);

}  // namespace rungproof
