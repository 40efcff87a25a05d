// Shapes of symbols; all wires of one state are one path.
#include "frontend/picture/svg_picture.hpp"

#include <fmt/format.h>

#include <iterator>

#include "frontend/text/excerpt.hpp"
#include "frontend/text/safe_text.hpp"

namespace rungproof {

namespace {

class SvgDrawer {
 public:
  SvgDrawer(std::string& svg, const Picture& picture, int x, int y) : svg_(svg), picture_(picture), x_(x), y_(y) {}

  void draw() {
    wires(Flow3::Unknown, "rw");
    wires(Flow3::Off, "rw off");
    wires(Flow3::On, "rw on");
    for (const PictureDot& dot : picture_.dots) {
      add("<circle class=\"rd{}\" cx=\"{}\" cy=\"{}\" r=\"3\"/>", suffix(dot.state), cx(dot.x), cy(dot.y));
    }
    for (const PictureRail& rail : picture_.rails) {
      add("<path class=\"rr{}\" d=\"M{} {}V{}\"/>", rail.state == Flow3::On ? " on" : "", cx(rail.x), cy(rail.y0) - 9,
          cy(rail.y1) + 9);
    }
    for (const PictureSymbol& symbol : picture_.symbols) this->symbol(symbol);
    for (const PictureDot& circle : picture_.circles) {
      add("<circle class=\"rc\" cx=\"{}\" cy=\"{}\" r=\"4\"/>", cx(circle.x) - 4, cy(circle.y));
    }
    for (const PictureLabel& label : picture_.labels) this->label(label);
    svg_ += '\n';
  }

 private:
  template <class... T>
  void add(fmt::format_string<T...> format, T&&... values) {
    fmt::format_to(std::back_inserter(svg_), format, std::forward<T>(values)...);
  }
  int cx(int column) const { return x_ + column * svgCellWidth + svgCellWidth / 2; }
  int cy(int row) const { return y_ + row * svgRowHeight + svgRowHeight / 2; }
  static std::string_view suffix(Flow3 state) { return state == Flow3::On ? " on" : state == Flow3::Off ? " off" : ""; }

  void wires(Flow3 state, std::string_view className) {
    bool isOpen = false;
    for (const PictureWire& wire : picture_.wires) {
      if (wire.state != state) continue;
      if (!isOpen) add("<path class=\"{}\" d=\"", className);
      isOpen = true;
      if (wire.isVertical())
        add("M{} {}V{}", cx(wire.x0), cy(wire.y0), cy(wire.y1));
      else
        add("M{} {}H{}", cx(wire.x0), cy(wire.y0), cx(wire.x1));
    }
    if (isOpen) svg_ += "\"/>";
  }

  void symbol(const PictureSymbol& s) {
    const int left = cx(s.x), right = cx(s.x + s.width - 1), y = cy(s.y);
    if (s.seen) seenHalves(left, right, y, *s.seen);
    const std::string_view state = suffix(s.state);
    switch (s.kind) {
      case SymbolKind::Box:
        add("<rect class=\"rb{}\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>", state, left, y, right - left,
            (s.height - 1) * svgRowHeight);
        return;
      case SymbolKind::Contact:
        if (!s.seen) add("<path class=\"rf{}\" d=\"M{} {}H{}V{}H{}Z\"/>", state, left, y - 7, right, y + 7, left);
        add("<path class=\"rs\" d=\"M{} {}v14M{} {}v14\"/>", left, y - 7, right, y - 7);
        break;
      case SymbolKind::Coil:
        add("<path class=\"rf{}\" d=\"M{} {}Q{} {} {} {}H{}Q{} {} {} {}Z\"/>", state, left + 3, y - 7, left - 3, y,
            left + 3, y + 7, right - 3, right + 3, y, right - 3, y - 7);
        add("<path class=\"rs\" d=\"M{} {}Q{} {} {} {}M{} {}Q{} {} {} {}\"/>", left + 3, y - 7, left - 3, y, left + 3,
            y + 7, right - 3, y - 7, right + 3, y, right - 3, y + 7);
        break;
      case SymbolKind::Bracket:
        if (!s.seen) add("<path class=\"rf{}\" d=\"M{} {}H{}V{}H{}Z\"/>", state, left, y - 8, right, y + 8, left);
        add("<path class=\"rs\" d=\"M{} {}h-4v16h4M{} {}h4v16h-4\"/>", left + 4, y - 8, right - 4, y - 8);
        break;
    }
    if (s.sign == "/") {
      add("<path class=\"rs\" d=\"M{} {}L{} {}\"/>", (left + right) / 2 - 4, y + 6, (left + right) / 2 + 4, y - 6);
    } else if (s.sign != " ") {
      add("<text class=\"rt m\" x=\"{}\" y=\"{}\">{}</text>", (left + right) / 2, y + 4, xmlText(s.sign));
    }
  }

  /// The left half tells whether the bit was 1, the right one whether it was 0.
  void seenHalves(int left, int right, int y, std::pair<bool, bool> seen) {
    const int middle = (left + right) / 2;
    add("<path class=\"rv{}\" d=\"M{} {}H{}V{}H{}Z\"><title>{}</title></path>", seen.first ? "" : " no", left, y - 7,
        middle, y + 7, left, seen.first ? "was 1" : "was never 1");
    add("<path class=\"rv{}\" d=\"M{} {}H{}V{}H{}Z\"><title>{}</title></path>", seen.second ? "" : " no", middle, y - 7,
        right, y + 7, middle, seen.second ? "was 0" : "was never 0");
  }

  void label(const PictureLabel& l) {
    const int width = displayWidth(l.text);
    const int left = x_ + l.x * svgCellWidth, right = left + width * svgCellWidth, baseline = cy(l.y) + 4;
    if (l.role == LabelRole::Mark) {
      add("<rect class=\"rm s{}\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"15\" rx=\"3\"/>", l.severity, left - 2,
          cy(l.y) - 7, right - left + 4);
    }
    const int x = l.align == Align::Left    ? left
                  : l.align == Align::Right ? right
                                            : (left + right) / 2 + (l.halfRight ? svgCellWidth / 2 : 0);
    add("<text class=\"rt{}{}\" x=\"{}\" y=\"{}\">{}</text>",
        l.align == Align::Left    ? ""
        : l.align == Align::Right ? " e"
                                  : " m",
        roleClass(l.role), x, baseline, xmlText(l.role == LabelRole::Mark ? " " + l.text.substr(1) : l.text));
  }
  static std::string_view roleClass(LabelRole role) {
    switch (role) {
      case LabelRole::Symbol: return " y";
      case LabelRole::BoxName: return " n";
      case LabelRole::PinName:
      case LabelRole::Note: return " p";
      case LabelRole::Mark: return " k";
      case LabelRole::Connector: return " c";
      default: return "";
    }
  }

  std::string& svg_;
  const Picture& picture_;
  int x_;
  int y_;
};

}  // namespace

std::string_view svgStyle() {
  return ".rw{fill:none;stroke:#1f2933;stroke-width:1.4}.rw.off{stroke:#7b8794}.rw.on{stroke:#0b62d6;stroke-width:3.2}"
         ".rd{fill:#1f2933}.rd.off{fill:#7b8794}.rd.on{fill:#0b62d6}"
         ".rr{fill:none;stroke:#1f2933;stroke-width:2.6}.rr.on{stroke:#0b62d6;stroke-width:3.6}"
         ".rs{fill:none;stroke:#1f2933;stroke-width:1.8}.rf{fill:#fff;stroke:none}.rf.on{fill:#9cc9ff}"
         ".rb{fill:#fff;stroke:#1f2933;stroke-width:1.6}.rb.on{fill:#e2f0ff}.rc{fill:#fff;stroke:#1f2933;stroke-width:"
         "1.4}"
         ".rt{font:12.5px \"DejaVu Sans Mono\",Consolas,Menlo,\"Liberation "
         "Mono\",monospace;fill:#1f2933;white-space:pre}.rt.m{text-anchor:middle}.rt.e{text-anchor:end}"
         ".rt.y{fill:#0a4f8f}.rt.n{font-weight:bold}.rt.p{fill:#4b5865}.rt.c{fill:#4b5865;font-weight:bold}.rt.k{fill:#"
         "fff;font-weight:bold}"
         ".rv{fill:#bfe3c4}.rv.no{fill:#f3b8b0}"
         ".rm.s2{fill:#c62828}.rm.s1{fill:#a35a00}.rm.s0{fill:#1565c0}"
         ".rh{font:bold 15px \"DejaVu Sans\",\"Segoe UI\",Arial,sans-serif;fill:#1f2933}.rk{font:13px \"DejaVu "
         "Sans\",\"Segoe UI\",Arial,sans-serif;fill:#3e6b3e}"
         ".rp{font:bold 18px \"DejaVu Sans\",\"Segoe UI\",Arial,sans-serif;fill:#1f2933}";
}

void appendSvg(std::string& svg, const Picture& picture, int x, int y) { SvgDrawer(svg, picture, x, y).draw(); }

void appendSvgText(std::string& svg, int x, int y, std::string_view text, std::string_view className) {
  fmt::format_to(std::back_inserter(svg), "<text class=\"{}\" x=\"{}\" y=\"{}\">{}</text>\n", className, x, y,
                 xmlText(text));
}

}  // namespace rungproof
