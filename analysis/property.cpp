// Cell layout of properties.
#include "analysis/property.hpp"

#include <fmt/format.h>

namespace rungproof {

int bitsFor(std::uint64_t highest) {
  int bits = 1;
  while (bits < 64 && highest >> bits != 0) ++bits;
  return bits;
}

namespace {

void layoutExpr(Expr& expr, const std::string& prefix, std::vector<MonitorCell>& cells) {
  for (std::size_t i = 0; i < expr.nodes.size(); ++i) {
    ExprNode& node = expr.nodes[i];
    node.cell = static_cast<std::uint32_t>(cells.size());
    const auto add = [&](const char* what, int width) {
      cells.push_back({fmt::format("{}.{}{}", prefix, what, i), static_cast<std::uint8_t>(width)});
    };
    switch (node.op) {
      case ExprOp::Rises:
      case ExprOp::Falls: add("before", 1); break;
      case ExprOp::Prev: add("before", expr.nodes[node.args[0]].width); break;
      case ExprOp::Once: add("once", 1); break;
      case ExprOp::Since: add("since", 1); break;
      case ExprOp::Held:
        add("run", 1);
        add("time", bitsFor(static_cast<std::uint64_t>(node.milliseconds)));
        break;
      default: break;
    }
  }
}

}  // namespace

void layoutCells(Property& property) {
  property.cells.clear();
  layoutExpr(property.first, property.name, property.cells);
  layoutExpr(property.second, property.name, property.cells);
  property.patternCell = static_cast<std::uint32_t>(property.cells.size());
  const auto add = [&](const char* what, int width) {
    property.cells.push_back({fmt::format("{}.{}", property.name, what), static_cast<std::uint8_t>(width)});
  };
  const int boundBits = bitsFor(static_cast<std::uint64_t>(property.bound) + 1);
  switch (property.kind) {
    case PropertyKind::LeadsToScans:
      add("pending", 1);
      add("scans", boundBits);
      break;
    case PropertyKind::LeadsToTime:
      add("pending", 1);
      add("time", boundBits);
      break;
    case PropertyKind::OnlyAfter: add("seen", 1); break;
    case PropertyKind::Unless: add("bound", 1); break;
    case PropertyKind::HeldImplies:
      add("run", 1);
      add("time", boundBits);
      break;
    case PropertyKind::Pulse:
      add("before", 1);
      add("risen", 1);
      add("time", boundBits);
      break;
    default: break;
  }
}

std::vector<const Operand*> addressesOf(const Property& property) {
  std::vector<const Operand*> addresses;
  for (const Expr* expr : {&property.first, &property.second}) {
    for (const ExprNode& node : expr->nodes) {
      if (node.op == ExprOp::Address) addresses.push_back(&node.operand);
    }
  }
  return addresses;
}

}  // namespace rungproof
