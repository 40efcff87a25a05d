// Cuts wide pictures into strips.
#include <algorithm>
#include <string>

#include "frontend/picture/picture.hpp"
#include "frontend/picture/placement.hpp"

namespace rungproof {

namespace {

constexpr int margin = 5;  // room for the arrow of a cut wire: "->12"
constexpr int betweenStrips = 1;

/// Columns [first, last] of the picture, and where they go.
struct Strip {
  int first;
  int last;
  int dx;
};

std::vector<Strip> stripsOf(const Picture& picture, int width) {
  std::vector<Strip> strips;
  for (int first = 0;;) {
    const int before = first == 0 ? 0 : margin;
    if (picture.width - first + before <= width) {
      strips.push_back({first, picture.width - 1, before - first});
      return strips;
    }
    int cut = -1;
    for (const int c : picture.cuts) {
      if (c <= first) continue;
      if (cut < 0 || c - first + 1 + before + margin <= width) cut = c;
    }
    if (cut < 0) {
      strips.push_back({first, picture.width - 1, before - first});
      return strips;
    }
    strips.push_back({first, cut, before - first});
    first = cut + 1;
  }
}

class Wrapper {
 public:
  Wrapper(const Picture& picture, int width)
      : from_(picture), usual_(std::min(width, usualWidth)), strips_(stripsOf(picture, width)) {}

  Picture run() {
    if (strips_.size() == 1) return from_;
    for (std::size_t k = 0; k < strips_.size(); ++k) {
      strip_ = strips_[k];
      findRows();
      if (k > 0) dy_ += betweenStrips;
      dy_ -= top_;
      const bool isLast = k + 1 == strips_.size();
      stretch_ = isLast && !from_.rails.empty() && from_.cuts.back() >= strip_.first
                     ? std::max(0, usual_ - 1 - from_.rails.back().x - strip_.dx)
                     : 0;
      copy(isLast);
      dy_ += bottom_ + 1;
    }
    to_.height = dy_;
    return std::move(to_);
  }

 private:
  bool holds(int x) const { return x >= strip_.first && x <= strip_.last; }
  bool crosses(const PictureWire& wire) const { return wire.x1 >= strip_.first && wire.x0 <= strip_.last; }

  void findRows() {
    top_ = from_.height;
    bottom_ = 0;
    const auto see = [&](int y0, int y1) {
      top_ = std::min(top_, y0);
      bottom_ = std::max(bottom_, y1);
    };
    for (const PictureWire& wire : from_.wires) {
      if (crosses(wire)) see(std::min(wire.y0, wire.y1), std::max(wire.y0, wire.y1));
    }
    for (const PictureSymbol& symbol : from_.symbols) {
      if (holds(symbol.x)) see(symbol.y, symbol.y + symbol.height - 1);
    }
    for (const PictureLabel& label : from_.labels) {
      if (holds(label.x)) see(label.y, label.y);
    }
    if (top_ > bottom_) top_ = bottom_;
  }

  /// Where a column of the picture goes.
  int placeOf(int x) const { return x + strip_.dx + (stretch_ > 0 && x > from_.cuts.back() ? stretch_ : 0); }

  void copy(bool isLast) {
    for (PictureRail rail : from_.rails) {
      if (!holds(rail.x)) continue;
      to_.rails.push_back({placeOf(rail.x), top_ + dy_, bottom_ + dy_, rail.state});
    }
    for (PictureWire wire : from_.wires) {
      if (!crosses(wire)) continue;
      const bool leaves = !isLast && wire.x1 > strip_.last, enters = wire.x0 < strip_.first;
      if (enters) connector(strip_.first, wire, true);
      if (leaves) connector(strip_.last, wire, false);
      wire.x0 = enters ? strip_.first - 1 + strip_.dx : placeOf(wire.x0);
      wire.x1 = leaves ? strip_.last + 1 + strip_.dx : placeOf(wire.x1);
      wire.y0 += dy_;
      wire.y1 += dy_;
      to_.wires.push_back(wire);
      see(wire.x1);
    }
    for (PictureSymbol symbol : from_.symbols) {
      if (!holds(symbol.x)) continue;
      symbol.x = placeOf(symbol.x);
      symbol.y += dy_;
      to_.symbols.push_back(std::move(symbol));
      see(to_.symbols.back().x + to_.symbols.back().width - 1);
    }
    for (PictureLabel label : from_.labels) {
      if (!holds(label.x)) continue;
      label.x = placeOf(label.x);
      label.y += dy_;
      to_.labels.push_back(std::move(label));
    }
    copyDots(from_.dots, to_.dots);
    copyDots(from_.circles, to_.circles);
    for (const PictureRail& rail : to_.rails) see(rail.x);
  }

  void copyDots(const std::vector<PictureDot>& from, std::vector<PictureDot>& to) const {
    for (const PictureDot& dot : from) {
      if (holds(dot.x)) to.push_back({placeOf(dot.x), dot.y + dy_, dot.state});
    }
  }

  /// The arrow at a cut: "->3" where the wire leaves, "3->" where it enters. One number for each cut of each row.
  void connector(int x, const PictureWire& wire, bool enters) {
    const int cut = enters ? x - 1 : x;
    const auto key = std::pair{cut, wire.y0};
    auto found = std::ranges::find(numbers_, key);
    if (found == numbers_.end()) found = numbers_.insert(numbers_.end(), key);
    const std::string number = std::to_string(found - numbers_.begin() + 1);
    PictureLabel label;
    label.role = LabelRole::Connector;
    label.y = wire.y0 + dy_;
    label.text = enters ? number + ">" : ">" + number;
    label.x = enters ? x + strip_.dx - 1 - static_cast<int>(label.text.size()) : x + strip_.dx + 2;
    label.align = enters ? Align::Right : Align::Left;
    if (!enters) see(label.x + static_cast<int>(label.text.size()) - 1);
    const bool isThere = std::ranges::any_of(
        to_.labels, [&](const PictureLabel& other) { return other.x == label.x && other.y == label.y; });
    if (!isThere) to_.labels.push_back(std::move(label));
  }

  void see(int x) { to_.width = std::max(to_.width, x + 1); }

  const Picture& from_;
  int usual_;
  std::vector<Strip> strips_;
  Strip strip_{};
  Picture to_;
  std::vector<std::pair<int, int>> numbers_;
  int top_ = 0;
  int bottom_ = 0;
  int dy_ = 0;
  int stretch_ = 0;  ///< added before the last column of the last strip
};

}  // namespace

Picture wrapped(const Picture& picture, int width) { return Wrapper(picture, width).run(); }

}  // namespace rungproof
