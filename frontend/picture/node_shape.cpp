// Contacts and coils are centred in their column; a box has its operands outside of the frame, left and right.
#include "frontend/picture/node_shape.hpp"

#include <algorithm>

#include "frontend/text/excerpt.hpp"

namespace rungproof {

namespace {

constexpr int nameRows = 2;  // upper edge of a box and its name
constexpr int stub = 2;      // wire between a box and what stands beside it
constexpr int wireEnds = 2;  // wire on each side of a contact

int widest(const std::vector<std::string>& lines) {
  int width = 0;
  for (const std::string& line : lines) width = std::max(width, displayWidth(line));
  return width;
}

int labelWidth(const PlanNode& node) {
  return std::max({widest(node.above), widest(node.below), displayWidth(node.mark)});
}

int operandWidth(const std::vector<DataPin>& pins) {
  int width = 0;
  for (const DataPin& pin : pins) width = std::max(width, displayWidth(pin.operand));
  return width + stub;
}

int frameWidth(const PlanNode& node) {
  int left = 0, right = displayWidth(node.outputPin);
  for (const NodeInput& input : node.inputs) left = std::max(left, displayWidth(input.pin));
  for (const DataPin& pin : node.left) left = std::max(left, displayWidth(pin.name));
  for (const DataPin& pin : node.right) right = std::max(right, displayWidth(pin.name));
  right = std::max(right, displayWidth(node.note));
  const int gap = left > 0 && right > 0 ? 2 : 0;
  return std::max({left + gap + right, displayWidth(node.name) + 2, 3}) + 2;
}

class Drawer {
 public:
  Drawer(const PlanNode& node, const NodeFrame& frame, Picture& picture)
      : node_(node), frame_(frame), picture_(picture) {}

  int inLine(SymbolKind kind) {
    const int width = displayWidth(node_.sign) + 2;
    const int x = frame_.x + entryOffset(node_, frame_.width);
    picture_.symbols.push_back({kind, node_.element, x, frame_.row, width, 1, node_.sign, node_.state});
    centre_ = 2 * x + width;
    centredLabels(frame_.row, frame_.row + 1);
    return x + width - 1;
  }

  int leaf() {
    const std::string& name = node_.above.at(0);
    const int x = frame_.x + frame_.width - displayWidth(name) - 2;
    label(LabelRole::Address, x, frame_.row, name, Align::Right);
    if (!node_.mark.empty()) mark(std::min(x, frame_.x + frame_.width - displayWidth(node_.mark) - 2), frame_.row + 1);
    return frame_.x + frame_.width - 1;
  }

  int box() {
    const int x = frame_.x + entryOffset(node_, frame_.width), width = frameWidth(node_), right = x + width - 1;
    const int bottom = frame_.row + boxRowsBelow(node_, frame_.pinRows);
    picture_.symbols.push_back({SymbolKind::Box,
                                node_.element,
                                x,
                                frame_.row - nameRows,
                                width,
                                bottom - frame_.row + nameRows + 1,
                                {},
                                node_.state});
    centre_ = 2 * x + width;
    centredLabels(frame_.row - nameRows, bottom + 1);
    centred(LabelRole::BoxName, frame_.row - 1, node_.name);
    for (std::size_t k = 0; k < node_.inputs.size(); ++k) pinName(x + 1, frame_.pinRows[k], node_.inputs[k].pin);
    int row = node_.inputs.empty() ? frame_.row : frame_.pinRows.back() + 1;
    for (const DataPin& pin : node_.left) {
      pinName(x + 1, row, pin.name);
      operand(pin, x - 1 - displayWidth(pin.operand), row, Align::Right);
      picture_.wires.push_back({x - 1, row, x, row, noNet, Flow3::Unknown});
      ++row;
    }
    if (!node_.note.empty())
      label(LabelRole::Note, right - displayWidth(node_.note), std::max(row - 1, frame_.row + 1), node_.note,
            Align::Right);
    row = frame_.row;
    if (node_.hasOutput) {
      if (!node_.outputPin.empty())
        label(LabelRole::PinName, right - displayWidth(node_.outputPin), row, node_.outputPin, Align::Right);
      ++row;
    }
    for (const DataPin& pin : node_.right) {
      label(LabelRole::PinName, right - displayWidth(pin.name), row, pin.name, Align::Right);
      operand(pin, right + 2, row, Align::Left);
      picture_.wires.push_back({right, row, right + 1, row, noNet, Flow3::Unknown});
      ++row;
    }
    return right;
  }

 private:
  static constexpr int noNet = -1;

  void label(LabelRole role, int x, int y, const std::string& text, Align align) {
    if (!text.empty()) picture_.labels.push_back({role, node_.element, x, y, text, align, -1, false});
  }
  void centred(LabelRole role, int y, const std::string& text) {
    const int twice = centre_ - displayWidth(text);
    label(role, twice / 2, y, text, Align::Centre);
    if (!text.empty()) picture_.labels.back().halfRight = twice % 2 != 0;
  }
  void pinName(int x, int y, const std::string& name) { label(LabelRole::PinName, x, y, name, Align::Left); }
  void operand(const DataPin& pin, int x, int y, Align align) {
    label(pin.isConstant ? LabelRole::Constant : LabelRole::Address, x, y, pin.operand, align);
  }
  void mark(int x, int y) {
    picture_.labels.push_back({LabelRole::Mark, node_.element, x, y, node_.mark, Align::Left, node_.severity, false});
  }

  /// Lines that end above row `top`, and lines from row `bottom` on.
  void centredLabels(int top, int bottom) {
    const auto count = static_cast<int>(node_.above.size());
    for (int k = 0; k < count; ++k) {
      const std::string& text = node_.above[static_cast<std::size_t>(k)];
      const bool isName = k == 0 && node_.namedAbove;
      centred(isName ? LabelRole::Symbol : LabelRole::Address, top - count + k, text);
    }
    for (const std::string& text : node_.below) centred(LabelRole::Address, bottom++, text);
    if (!node_.mark.empty()) mark((centre_ - displayWidth(node_.mark)) / 2, bottom);
  }

  const PlanNode& node_;
  const NodeFrame& frame_;
  Picture& picture_;
  int centre_ = 0;  ///< twice the column of the middle
};

}  // namespace

int rowsAbove(const PlanNode& node) {
  if (node.kind == NodeKind::Join || node.kind == NodeKind::Rail || node.kind == NodeKind::Leaf) return 0;
  const auto lines = static_cast<int>(node.above.size());
  return node.kind == NodeKind::Box ? lines + nameRows : lines;
}

int rowsBelow(const PlanNode& node) { return static_cast<int>(node.below.size()) + (node.mark.empty() ? 0 : 1); }

int boxRowsBelow(const PlanNode& node, const std::vector<int>& pinRows) {
  const int row = pinRows.front();
  const int leftEnd = (node.inputs.empty() ? row - 1 : pinRows.back()) + static_cast<int>(node.left.size());
  const int rightEnd = row - 1 + (node.hasOutput ? 1 : 0) + static_cast<int>(node.right.size());
  const int noteEnd = node.note.empty() ? row : row + 1;
  return std::max({leftEnd, rightEnd, noteEnd}) + 1 - row;
}

int columnWidth(const PlanNode& node) {
  if (node.kind == NodeKind::Leaf) return std::max(displayWidth(node.above.at(0)), displayWidth(node.mark)) + 2 + stub;
  if (node.kind != NodeKind::Box) {
    const int body = displayWidth(node.sign) + 2, width = std::max(body + 2 * wireEnds, labelWidth(node) + 2);
    return width + (width - body) % 2;  // the same on both sides
  }
  const int frame = operandWidth(node.left) + frameWidth(node) + operandWidth(node.right);
  return std::max(frame, labelWidth(node) + 2 * stub);
}

int entryOffset(const PlanNode& node, int width) {
  if (node.kind != NodeKind::Box) return (width - displayWidth(node.sign) - 2) / 2;
  const int own = operandWidth(node.left) + frameWidth(node) + operandWidth(node.right);
  const int overhang = (labelWidth(node) - frameWidth(node) + 1) / 2 + 1;  // a label above that is wider than the box
  return std::max(operandWidth(node.left), own < labelWidth(node) + 2 * stub ? overhang : 0);
}

int drawSymbol(const PlanNode& node, const NodeFrame& frame, Picture& picture) {
  Drawer drawer(node, frame, picture);
  switch (node.kind) {
    case NodeKind::Contact: return drawer.inLine(SymbolKind::Contact);
    case NodeKind::Leaf: return drawer.leaf();
    case NodeKind::Box: return drawer.box();
    default: return drawer.inLine(node.kind == NodeKind::Heading ? SymbolKind::Bracket : SymbolKind::Coil);
  }
}

}  // namespace rungproof
