// Rows and columns, then symbols, labels and wires at them.
#include "frontend/picture/placement.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <span>

#include "frontend/picture/node_shape.hpp"

namespace rungproof {

namespace {

constexpr int notPlaced = -1;

/// Rows at the border of two columns, from the first to the last of them.
struct Stretch {
  int row0;
  int row1;
};

/// What belongs to nets at the border of two columns.
struct Border {
  std::vector<std::vector<int>> netsAt;  ///< by row
  std::map<int, Stretch> last;           ///< by net: the stretch that grew last
};

/// Where a node stands.
struct Spot {
  int column = 0;
  int exit = 0;              ///< border behind the node, where its output is available
  int row = notPlaced;       ///< of its output and first input
  std::vector<int> pinRows;  ///< Box: of each input; Join: of each branch
};

class Placement {
 public:
  Placement(const PlanNodes& plan, int page)
      : nodes_(plan.nodes),
        hasRails_(plan.hasRails),
        usual_(std::min(page, usualWidth)),
        spots_(plan.nodes.size()),
        uses_(plan.nodes.size(), 0),
        joins_(plan.nodes.size()) {
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      for (const NodeInput& input : nodes_[i].inputs) {
        ++uses_[index(input.from)];
        std::vector<int>& joins = joins_[index(input.from)];
        const bool isNew = joins.empty() || joins.back() != static_cast<int>(i);
        if (nodes_[i].kind == NodeKind::Join && isNew) joins.push_back(static_cast<int>(i));
      }
    }
  }

  PlacedPicture run() {
    chooseColumns();
    for (std::size_t i = 0; i < nodes_.size() && reason_.empty(); ++i) {
      const bool isSink = uses_[i] == 0 && nodes_[i].kind != NodeKind::Rail;
      if (isSink) placeChain(static_cast<int>(i), 0);
    }
    if (!reason_.empty()) return {{}, reason_};
    measureColumns();
    draw();
    return {std::move(picture_), {}};
  }

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  const PlanNode& node(int i) const { return nodes_[index(i)]; }
  Spot& spot(int i) { return spots_[index(i)]; }
  bool isRail(int i) const { return node(i).kind == NodeKind::Rail; }

  // ---- Columns ----------------------------------------------------------------------------------

  void chooseColumns() {
    std::vector<int> depth(nodes_.size(), 0);  // columns of what stands before a node, shared nodes left out
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      const PlanNode& n = nodes_[i];
      Spot& s = spots_[i];
      int shared = 0;
      for (const NodeInput& input : n.inputs) {
        const bool isShared = uses_[index(input.from)] > 1 && !isRail(input.from);
        // A branch that goes on elsewhere keeps its own border, so that the two nets do not touch.
        s.column = std::max(s.column, spot(input.from).exit + (isShared && n.kind == NodeKind::Join ? 1 : 0));
        if (isShared)
          shared = std::max(shared, spot(input.from).exit);
        else
          depth[i] = std::max(depth[i], depth[index(input.from)]);
      }
      // What stands before the other pins of a box begins behind the wire that goes on elsewhere.
      if (shared > 0 && !hasRails_) s.column = std::max(s.column, shared + depth[i]);
      s.exit = n.kind == NodeKind::Join || n.kind == NodeKind::Rail ? s.column : s.column + 1;
      if (n.kind != NodeKind::Join) ++depth[i];
    }
    columns_ = 0;
    for (const Spot& s : spots_) columns_ = std::max(columns_, s.exit);
    moveToTheRight();
    columns_ = 0;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      hasCoils_ = hasCoils_ || nodes_[i].kind == NodeKind::Coil;
      if (nodes_[i].kind != NodeKind::Coil) columns_ = std::max(columns_, spots_[i].exit);
    }
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (nodes_[i].kind != NodeKind::Coil) continue;
      spots_[i].column = columns_;
      spots_[i].exit = columns_ + 1;
    }
    if (hasCoils_) ++columns_;
    low_.assign(index(2 * columns_ + 1), 0);
    owner_.assign(low_.size(), -1);
    taken_.resize(index(columns_ + 1));
    width_.assign(index(columns_), 2);
    lead_.assign(index(columns_), 0);
  }

  /// In FBD, outputs stand in the last column, and what feeds one pin only stands directly before it.
  void moveToTheRight() {
    if (hasRails_) return;
    for (std::size_t i = nodes_.size(); i-- > 0;) {
      if (nodes_[i].isLast) spots_[i] = {columns_ - 1, columns_, notPlaced, {}};
      for (const NodeInput& input : nodes_[i].inputs) {
        if (uses_[index(input.from)] != 1) continue;
        Spot& before = spot(input.from);
        before.column = spots_[i].column - 1;
        before.exit = spots_[i].column;
      }
    }
  }

  // ---- Rows -------------------------------------------------------------------------------------

  /// Nodes from the first that has no place yet to `end`, and what feeds the first of them; -1: nothing does.
  struct Chain {
    std::vector<int> nodes;
    int source = -1;
  };
  Chain chainTo(int end) {
    Chain chain;
    for (int i = end;;) {
      chain.nodes.push_back(i);
      if (node(i).inputs.empty()) break;
      const int before = node(i).inputs[0].from;
      if (isPlaced(before)) {
        chain.source = before;
        break;
      }
      i = before;
    }
    std::reverse(chain.nodes.begin(), chain.nodes.end());
    return chain;
  }
  bool isPlaced(int i) { return isRail(i) || spot(i).row != notPlaced; }

  /// Places `end` and everything on the chain of its first inputs that has no place yet, at the first free row from
  /// `minimum`. The row is also free up to slot `reach`, where the wire may meet the net `meets`.
  void placeChain(int end, int minimum, int reach = 0, int meets = -1) {
    const Chain chain = chainTo(end);
    const int from = chain.source < 0 ? 2 * spot(chain.nodes.front()).column + 1 : 2 * spot(chain.source).exit;
    const int to = std::max(reach, 2 * spot(end).exit - (hasWireBehind(end) ? 0 : 1));
    const int row = freeRow(from, to, chain, meets >= 0 ? meets : node(end).kind == NodeKind::Join ? end : -1, minimum);
    int at = from;
    int net = chain.source;
    for (const int i : chain.nodes) {
      Spot& s = spot(i);
      s.row = row;
      const int here = node(i).kind == NodeKind::Join ? 2 * s.column : 2 * s.column + 1;
      if (net >= 0) occupy(at, here, row, net);
      net = i;
      if (here % 2 != 0) raise(here, row + 1 + rowsBelow(node(i)), i);
      at = 2 * s.exit;
      if (hasWireBehind(i)) occupy(at, at, row, i);
    }
    if (chain.source >= 0 && !isRail(chain.source))
      connect(spot(chain.source).exit, spot(chain.source).row, row, chain.source);
    for (const int i : chain.nodes) {
      if (reason_.empty()) placeInputs(i);
    }
  }

  bool hasWireBehind(int i) const { return uses_[index(i)] > 0 || node(i).kind == NodeKind::Coil; }

  /// The further inputs of a join or box, below the first one.
  void placeInputs(int i) {
    Spot& s = spot(i);
    const PlanNode& n = node(i);
    s.pinRows = {s.row};
    int row = s.row;
    for (std::size_t k = 1; k < n.inputs.size() && reason_.empty(); ++k) {
      row = placeInput(n.inputs[k].from, i, row + 1);
      s.pinRows.push_back(row);
    }
    if (n.kind != NodeKind::Box) return;
    raise(2 * s.column + 1, s.row + boxRowsBelow(n, s.pinRows) + (n.mark.empty() ? 0 : 1) + 1, i);
  }

  /// A wire from `from` to node `to`, with what stands before it. Gives its row at `to`.
  int placeInput(int from, int to, int minimum) {
    const bool isJoin = node(to).kind == NodeKind::Join;
    const int end = 2 * spot(to).column;
    const int meets = isJoin ? to : -1;
    int row = 0;
    if (isPlaced(from)) {
      row = freeRow(2 * spot(from).exit, end, {{}, from}, meets, minimum);
      if (!isRail(from)) connect(spot(from).exit, spot(from).row, row, from);
    } else {
      placeChain(from, minimum, end, meets);
      row = spot(from).row;
    }
    occupy(2 * spot(from).exit, isJoin ? end - 1 : end, row, from);
    if (isJoin) connect(spot(to).column, spot(to).row, row, to);
    return row;
  }

  /// The first row from `minimum` at which the slots from `from` to `to` are free, with the headroom of the chain's
  /// nodes. At its ends the wire may touch what belongs to the same net.
  int freeRow(int from, int to, const Chain& chain, int meets, int minimum) {
    int row = minimum;
    for (int slot = from; slot <= to; ++slot) {
      const int owner = owner_[index(slot)];
      const bool begins =
          slot == from && slot % 2 == 0 && chain.source >= 0 && (isRail(chain.source) || owner == chain.source);
      const bool ends = slot == to && meets >= 0 && owner == meets;
      if (begins || ends) continue;
      int headroom = 0;
      for (const int i : chain.nodes) {
        if (2 * spot(i).column + 1 == slot) headroom = std::max(headroom, rowsAbove(node(i)));
      }
      row = std::max(row, low_[index(slot)] + headroom);
    }
    return row;
  }

  void raise(int slot, int low, int net) {
    if (low < low_[index(slot)]) return;
    low_[index(slot)] = low;
    owner_[index(slot)] = net;
  }
  void occupy(int from, int to, int row, int net) {
    for (int slot = from; slot <= to; ++slot) {
      raise(slot, row + 1, net);
      if (slot % 2 == 0) claim(slot / 2, row, row, net);
    }
  }
  /// A vertical wire at a border.
  void connect(int border, int row0, int row1, int net) {
    claim(border, std::min(row0, row1), std::max(row0, row1), net);
    raise(2 * border, std::max(row0, row1) + 1, net);
  }
  void claim(int border, int row0, int row1, int net) {
    if (border == 0 && hasRails_) return;
    Border& taken = taken_[index(border)];
    const auto claimRow = [&](int row) {
      if (index(row) >= taken.netsAt.size()) taken.netsAt.resize(index(row) + 1);
      std::vector<int>& nets = taken.netsAt[index(row)];
      if (std::ranges::any_of(nets, [&](int other) { return other != net && !meet(other, net); }))
        reason_ = "wires would cross";
      if (std::ranges::find(nets, net) == nets.end()) nets.push_back(net);
    };
    // A wire that grows downwards has claimed all but its new rows.
    const auto [place, isFirst] = taken.last.try_emplace(net, row0, row1);
    Stretch& last = place->second;
    const bool grows = !isFirst && last.row0 <= row1 && row0 <= last.row1;
    for (int row = row0; row <= row1; ++row) {
      if (grows && row == last.row0)
        row = last.row1;
      else
        claimRow(row);
    }
    last = grows ? Stretch{std::min(last.row0, row0), std::max(last.row1, row1)} : Stretch{row0, row1};
  }
  /// A wire that ends in a join touches it.
  bool meet(int a, int b) const { return feeds(a, b) || feeds(b, a); }
  bool feeds(int from, int to) const { return std::ranges::find(joins_[index(from)], to) != joins_[index(from)].end(); }

  // ---- Drawing ----------------------------------------------------------------------------------

  void measureColumns() {
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (nodes_[i].kind == NodeKind::Rail || nodes_[i].kind == NodeKind::Join) continue;
      int& width = width_[index(spots_[i].column)];
      width = std::max(width, columnWidth(nodes_[i]));
      int& lead = lead_[index(spots_[i].column)];
      if (nodes_[i].kind == NodeKind::Box) lead = std::max(lead, entryOffset(nodes_[i], 0));
    }
    // Boxes below each other begin at the same column.
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (nodes_[i].kind != NodeKind::Box) continue;
      int& width = width_[index(spots_[i].column)];
      width = std::max(width, columnWidth(nodes_[i]) + lead_[index(spots_[i].column)] - entryOffset(nodes_[i], 0));
    }
    border_.assign(index(columns_ + 1), 0);
    for (int c = 0; c < columns_; ++c) border_[index(c + 1)] = border_[index(c)] + 1 + width_[index(c)];
    // Coils of short and long rungs stand below each other.
    if (hasRails_ && border_.back() < usual_ - 1) {
      const int more = usual_ - 1 - border_.back();
      border_[index(columns_)] += more;
    }
  }

  int borderX(int border) const { return border_[index(border)]; }
  int columnX(int column) const { return borderX(column) + 1; }

  void wire(int x0, int y0, int x1, int y1, int net) {
    if (x0 == x1 && y0 == y1) return;
    picture_.wires.push_back({x0, y0, x1, y1, net, node(net).output});
  }

  void draw() {
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (nodes_[i].kind != NodeKind::Rail) drawNode(static_cast<int>(i));
    }
    int bottom = 0;
    for (const int low : low_) bottom = std::max(bottom, low);
    picture_.width = borderX(columns_) + 1;
    picture_.height = bottom;
    for (int b = 1; b < columns_; ++b) picture_.cuts.push_back(borderX(b));
    drawVerticals();
    if (hasRails_) drawRails(bottom);
  }

  void drawRails(int bottom) {
    Flow3 flow = Flow3::Unknown;
    for (const PlanNode& n : nodes_) {
      if (n.kind == NodeKind::Rail) flow = n.output;
    }
    picture_.rails.push_back({0, 0, bottom - 1, flow});
    picture_.rails.push_back({borderX(columns_), 0, bottom - 1, Flow3::Unknown});
  }

  /// The wires that lead into a node, then the node.
  void drawNode(int i) {
    const Spot& s = spot(i);
    const PlanNode& n = node(i);
    const int width = n.kind == NodeKind::Join ? 0 : width_[index(s.column)];
    int x = n.kind == NodeKind::Coil ? borderX(s.exit) - width : columnX(s.column);
    if (n.kind == NodeKind::Box) x += lead_[index(s.column)] - entryOffset(n, 0);
    const int entry = n.kind == NodeKind::Join ? borderX(s.column) : x + entryOffset(n, width);
    for (std::size_t k = 0; k < n.inputs.size(); ++k) {
      const int from = n.inputs[k].from;
      const int start = isRail(from) ? borderX(0) : borderX(spot(from).exit);
      const int row = s.pinRows.empty() ? s.row : s.pinRows[k];
      const int end = n.inputs[k].negated ? entry - 1 : entry;
      if (start <= end) wire(start, row, end, row, from);
      if (n.inputs[k].negated) picture_.circles.push_back({entry, row, node(from).output});
    }
    if (n.kind == NodeKind::Join) {
      addVertical(s.column, s.row, s.pinRows.back(), i);
      return;
    }
    const NodeFrame frame{x, width, s.row, s.pinRows};
    const int exit = drawSymbol(n, frame, picture_);
    if (hasWireBehind(i)) wire(exit, s.row, borderX(s.exit), s.row, i);
  }

  void addVertical(int border, int row0, int row1, int net) {
    const auto [place, isNew] = verticals_.emplace(std::pair{border, net}, std::pair{row0, row1});
    if (isNew) return;
    place->second.first = std::min(place->second.first, row0);
    place->second.second = std::max(place->second.second, row1);
  }

  void drawVerticals() {
    // From a node's exit to the rows of those that go on from there.
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      const Spot& s = spots_[i];
      for (std::size_t k = 0; k < nodes_[i].inputs.size(); ++k) {
        const int from = nodes_[i].inputs[k].from;
        const int row = s.pinRows.empty() ? s.row : s.pinRows[k];
        if (!isRail(from) && row != spot(from).row) addVertical(spot(from).exit, spot(from).row, row, from);
      }
    }
    for (const auto& [place, rows] : verticals_)
      wire(borderX(place.first), rows.first, borderX(place.first), rows.second, place.second);
    std::map<int, std::vector<const PictureWire*>> upright, level;  // by column of characters, by row
    for (const PictureWire& w : picture_.wires) (w.isVertical() ? upright[w.x0] : level[w.y0]).push_back(&w);
    std::set<std::pair<int, int>> marked;
    for (const auto& [place, rows] : verticals_) {
      const int x = borderX(place.first);
      for (int row = rows.first; row <= rows.second; ++row) {
        if (armsAt(x, row, upright[x], level[row]) > 2 && marked.emplace(x, row).second)
          picture_.dots.push_back({x, row, node(place.second).output});
      }
    }
  }

  /// How many lines meet at a point of a vertical wire, of the wires in its column and in its row.
  static int armsAt(int x, int row, std::span<const PictureWire* const> upright,
                    std::span<const PictureWire* const> level) {
    bool up = false, down = false, left = false, right = false;
    for (const PictureWire* w : upright) {
      up = up || (w->y0 < row && row <= w->y1);
      down = down || (w->y0 <= row && row < w->y1);
    }
    for (const PictureWire* w : level) {
      left = left || (w->x0 < x && x <= w->x1);
      right = right || (w->x0 <= x && x < w->x1);
    }
    return (up ? 1 : 0) + (down ? 1 : 0) + (left ? 1 : 0) + (right ? 1 : 0);
  }

  const std::vector<PlanNode>& nodes_;
  bool hasRails_;
  int usual_;
  std::vector<Spot> spots_;
  std::vector<int> uses_;
  std::vector<std::vector<int>> joins_;  ///< that a node feeds
  int columns_ = 0;
  bool hasCoils_ = false;
  std::vector<int> low_;    ///< by slot: first free row. Slot 2 b is border b, slot 2 c + 1 is column c
  std::vector<int> owner_;  ///< by slot: net of the lowest thing in it
  std::vector<Border> taken_;
  std::vector<int> width_;
  std::vector<int> lead_;  ///< by column: from its left end to the boxes in it
  std::vector<int> border_;
  std::map<std::pair<int, int>, std::pair<int, int>> verticals_;  ///< border and net: first and last row
  std::string reason_;
  Picture picture_;
};

}  // namespace

PlacedPicture place(const PlanNodes& plan, int page) {
  if (!plan.reason.empty()) return {{}, plan.reason};
  return Placement(plan, page).run();
}

}  // namespace rungproof
