// Cell layout of properties.
#include "analysis/property.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rungproof {

int bitsFor(std::uint64_t highest) {
  int bits = 1;
  while (bits < 64 && highest >> bits != 0) ++bits;
  return bits;
}

namespace {

/// A clock is two cells: the ticks since it was started, and with a coarse base the digits below them at its start.
void addClock(std::vector<MonitorCell>& cells, const std::string& name, std::int64_t milliseconds, int timeBase) {
  cells.push_back({name + "time",
                   static_cast<std::uint8_t>(bitsFor(static_cast<std::uint64_t>(clockCap(milliseconds, timeBase))))});
  if (timeBase > 1) cells.push_back({name + "digits", 8});
}

void layoutExpr(Expr& expr, const std::string& prefix, std::vector<MonitorCell>& cells, int timeBase) {
  for (std::size_t i = 0; i < expr.nodes.size(); ++i) {
    ExprNode& node = expr.nodes[i];
    const auto first = static_cast<std::uint32_t>(cells.size());
    const auto add = [&](const char* what, int width) {
      cells.push_back({fmt::format("{}.{}{}", prefix, what, i), static_cast<std::uint8_t>(width)});
    };
    switch (node.op) {  // every operator is named, so that a new one cannot do without a decision
      case ExprOp::Constant:
      case ExprOp::Address:
      case ExprOp::Not:
      case ExprOp::And:
      case ExprOp::Or:
      case ExprOp::Xor:
      case ExprOp::Implies:
      case ExprOp::Equal:
      case ExprOp::NotEqual:
      case ExprOp::Less:
      case ExprOp::LessEqual:
      case ExprOp::Greater:
      case ExprOp::GreaterEqual:
      case ExprOp::Add:
      case ExprOp::Sub:
      case ExprOp::Mul:
      case ExprOp::Negate:
      case ExprOp::FirstScan: break;
      case ExprOp::Rises:
      case ExprOp::Falls: add("before", 1); break;
      case ExprOp::Prev: add("before", expr.nodes[node.args[0]].width); break;
      case ExprOp::Once: add("once", 1); break;
      case ExprOp::Since: add("since", 1); break;
      case ExprOp::Held:
        add("run", 1);
        addClock(cells, fmt::format("{}.{}.", prefix, i), node.milliseconds, timeBase);
        break;
    }
    node.cell = cells.size() > first ? first : noCell;
  }
}

}  // namespace

void layoutCells(Property& property) {
  property.cells.clear();
  layoutExpr(property.first, property.name, property.cells, property.timeBase);
  layoutExpr(property.second, property.name, property.cells, property.timeBase);
  property.patternCell = static_cast<std::uint32_t>(property.cells.size());
  const auto add = [&](const char* what, int width) {
    property.cells.push_back({fmt::format("{}.{}", property.name, what), static_cast<std::uint8_t>(width)});
  };
  const auto addTime = [&](std::int64_t milliseconds) {
    addClock(property.cells, property.name + ".", milliseconds, property.timeBase);
  };
  switch (property.kind) {
    case PropertyKind::LeadsToScans:
      add("pending", 1);
      add("scans", bitsFor(static_cast<std::uint64_t>(property.bound) + 1));
      break;
    case PropertyKind::LeadsToTime:
      add("pending", 1);
      addTime(property.bound + 1);
      break;
    case PropertyKind::OnlyAfter: add("seen", 1); break;
    case PropertyKind::Unless: add("bound", 1); break;
    case PropertyKind::HeldImplies:
      add("run", 1);
      addTime(property.bound);
      break;
    case PropertyKind::Pulse:
      add("before", 1);
      add("risen", 1);
      addTime(property.bound);
      break;
    case PropertyKind::Assume:
    case PropertyKind::Always:
    case PropertyKind::Never:
    case PropertyKind::Reach: break;
  }
  if (property.cells.size() == property.patternCell) property.patternCell = noCell;
}

int numberBits(const Operand& o) {
  const bool isRest = o.area == Area::T && o.width == Width::DWord;  // ms of an S5 timer
  return isRest ? 32 : bits(areaInfo(o.area).width.value_or(o.width));
}

bool hasClock(const Property& property) {
  const auto holds = [](const Expr& expr) {
    return std::any_of(expr.nodes.begin(), expr.nodes.end(), [](const ExprNode& n) { return n.op == ExprOp::Held; });
  };
  return property.kind == PropertyKind::LeadsToTime || property.kind == PropertyKind::HeldImplies ||
         property.kind == PropertyKind::Pulse || holds(property.first) || holds(property.second);
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
