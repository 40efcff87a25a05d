// Cells with the four directions in which lines leave them; the character follows from the directions.
#include "frontend/picture/text_picture.hpp"

#include <algorithm>
#include <array>

#include "frontend/text/excerpt.hpp"

namespace rungproof {

namespace {

/// Lines by the weight (0 none, 1 light, 2 heavy) of what goes up, right, down and left: index ((up * 3 + right) * 3 +
/// down) * 3 + left.
constexpr std::array<std::string_view, 81> lines = {
    " ", "╴", "╸", "╷", "┐", "┑", "╻", "┒", "┓", "╶", "─", "╾", "┌", "┬", "┭", "┎", "┰", "┱", "╺", "╼", "━",
    "┍", "┮", "┯", "┏", "┲", "┳", "╵", "┘", "┙", "│", "┤", "┥", "╽", "┧", "┪", "└", "┴", "┵", "├", "┼", "┽",
    "┟", "╁", "╅", "┕", "┶", "┷", "┝", "┾", "┿", "┢", "╆", "╈", "╹", "┚", "┛", "╿", "┦", "┩", "┃", "┨", "┫",
    "┖", "┸", "┹", "┞", "╀", "╃", "┠", "╂", "╉", "┗", "┺", "┻", "┡", "╄", "╇", "┣", "╊", "╋",
};

enum class Ink : std::uint8_t { Plain, Power, Name, Faint, Error, Warning, Note };

struct ScreenCell {
  std::array<std::uint8_t, 4> weight{};  ///< up, right, down, left
  std::string text;                      ///< instead of lines
  bool isCovered = false;                ///< second half of a wide character
  Ink ink = Ink::Plain;
};

class Canvas {
 public:
  Canvas(const Picture& picture, const TextStyle& style) : picture_(picture), style_(style) {
    int width = picture.width;
    for (const PictureLabel& label : picture.labels) width = std::max(width, label.x + displayWidth(label.text));
    rows_.assign(static_cast<std::size_t>(std::max(picture.height, 1)),
                 std::vector<ScreenCell>(static_cast<std::size_t>(width)));
  }

  std::vector<std::string> draw() {
    for (const PictureRail& rail : picture_.rails) {
      for (int y = rail.y0; y <= rail.y1; ++y) {
        stroke(rail.x, y, up, rail.state);
        stroke(rail.x, y, down, rail.state);
      }
    }
    for (const PictureWire& wire : picture_.wires) line(wire.x0, wire.y0, wire.x1, wire.y1, wire.state);
    for (const PictureSymbol& symbol : picture_.symbols) drawSymbol(symbol);
    for (const PictureDot& circle : picture_.circles) put(circle.x - 1, circle.y, "o", inkOf(circle.state));
    for (const PictureLabel& label : picture_.labels) put(label.x, label.y, label.text, inkOf(label));
    std::vector<std::string> result;
    for (const std::vector<ScreenCell>& row : rows_) result.push_back(textOf(row));
    return result;
  }

 private:
  static constexpr std::size_t up = 0, right = 1, down = 2, left = 3;

  static Ink inkOf(Flow3 state) { return state == Flow3::On ? Ink::Power : Ink::Plain; }
  static Ink inkOf(const PictureLabel& label) {
    switch (label.role) {
      case LabelRole::Symbol: return Ink::Name;
      case LabelRole::PinName:
      case LabelRole::Note: return Ink::Faint;
      case LabelRole::Mark: return label.severity == 2 ? Ink::Error : label.severity == 1 ? Ink::Warning : Ink::Note;
      default: return Ink::Plain;
    }
  }

  ScreenCell* cell(int x, int y) {
    if (x < 0 || y < 0 || y >= static_cast<int>(rows_.size()) || x >= static_cast<int>(rows_[0].size())) return nullptr;
    return &rows_[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)];
  }
  void stroke(int x, int y, std::size_t direction, Flow3 state) {
    ScreenCell* c = cell(x, y);
    if (c == nullptr) return;
    c->weight[direction] = std::max<std::uint8_t>(c->weight[direction], state == Flow3::On ? 2 : 1);
    if (state == Flow3::On) c->ink = Ink::Power;
  }
  void line(int x0, int y0, int x1, int y1, Flow3 state) {
    if (y1 < y0) std::swap(y0, y1);
    for (int x = x0; x < x1; ++x) {
      stroke(x, y0, right, state);
      stroke(x + 1, y0, left, state);
    }
    for (int y = y0; y < y1; ++y) {
      stroke(x0, y, down, state);
      stroke(x0, y + 1, up, state);
    }
  }

  /// Text from a cell on, character by character.
  void put(int x, int y, const std::string& text, Ink ink) {
    for (std::size_t i = 0; i < text.size();) {
      std::size_t next = i + 1;
      while (next < text.size() && (static_cast<unsigned char>(text[next]) & 0xC0) == 0x80) ++next;
      const std::string character = text.substr(i, next - i);
      const int width = displayWidth(character);
      if (ScreenCell* c = cell(width == 0 ? x - 1 : x, y)) {
        if (width == 0)
          c->text += character;
        else
          c->text = character;
        c->ink = ink;
      }
      if (ScreenCell* c = width == 2 ? cell(x + 1, y) : nullptr) c->isCovered = true;
      x += width;
      i = next;
    }
  }

  void drawSymbol(const PictureSymbol& symbol) {
    const bool isOn = symbol.state == Flow3::On;
    const Ink ink = inkOf(symbol.state);
    if (symbol.kind == SymbolKind::Box) {
      const int x1 = symbol.x + symbol.width - 1, y1 = symbol.y + symbol.height - 1;
      line(symbol.x, symbol.y, x1, symbol.y, Flow3::Off);
      line(symbol.x, y1, x1, y1, Flow3::Off);
      line(symbol.x, symbol.y, symbol.x, y1, Flow3::Off);
      line(x1, symbol.y, x1, y1, Flow3::Off);
      return;
    }
    std::string open = "[", close = "]";
    if (symbol.kind == SymbolKind::Coil) open = "(", close = ")";
    if (symbol.kind == SymbolKind::Contact && style_.ascii && !isOn) open = close = "|";
    if (symbol.kind == SymbolKind::Contact && !style_.ascii) {
      open = isOn ? "┫" : "┤";
      close = isOn ? "┣" : "├";
    }
    const std::string inside = symbol.sign == " " && isOn ? (style_.ascii ? "#" : "█") : symbol.sign;
    put(symbol.x, symbol.y, open + inside + close, ink);
  }

  std::string glyph(const ScreenCell& c) const {
    if (!c.text.empty()) return c.text;
    std::array<std::uint8_t, 4> w = c.weight;
    const bool isHorizontal = w[left] + w[right] > 0, isVertical = w[up] + w[down] > 0;
    if (isHorizontal && !isVertical) w[left] = w[right] = std::max(w[left], w[right]);
    if (isVertical && !isHorizontal) w[up] = w[down] = std::max(w[up], w[down]);
    if (!style_.ascii) return std::string(lines[((w[up] * 3U + w[right]) * 3U + w[down]) * 3U + w[left]]);
    if (isHorizontal && isVertical) return "+";
    if (isHorizontal) return w[left] == 2 ? "=" : "-";
    if (isVertical) return w[up] == 2 ? "#" : "|";
    return " ";
  }

  static std::string_view codeOf(Ink ink) {
    switch (ink) {
      case Ink::Power: return "1;32";
      case Ink::Name: return "36";
      case Ink::Faint: return "2";
      case Ink::Error: return "1;31";
      case Ink::Warning: return "1;33";
      case Ink::Note: return "1;34";
      default: return "";
    }
  }

  std::string textOf(const std::vector<ScreenCell>& row) const {
    std::size_t end = row.size();
    while (end > 0 && !row[end - 1].isCovered && glyph(row[end - 1]) == " ") --end;
    std::string text;
    Ink ink = Ink::Plain;
    for (std::size_t x = 0; x < end; ++x) {
      if (row[x].isCovered) continue;
      const std::string character = glyph(row[x]);
      const Ink wanted = character == " " ? Ink::Plain : row[x].ink;
      if (style_.color && wanted != ink) {
        if (ink != Ink::Plain) text += "\x1B[0m";
        if (wanted != Ink::Plain) text += "\x1B[" + std::string(codeOf(wanted)) + "m";
        ink = wanted;
      }
      text += character;
    }
    if (ink != Ink::Plain) text += "\x1B[0m";
    return text;
  }

  const Picture& picture_;
  TextStyle style_;
  std::vector<std::vector<ScreenCell>> rows_;
};

}  // namespace

std::vector<std::string> textLines(const Picture& picture, const TextStyle& style) {
  return Canvas(picture, style).draw();
}

}  // namespace rungproof
