// Rules over nodes; parts of properties are cut out as expressions of their own and read as monitors read them.
#include "analysis/encoding/state_rule.hpp"

#include <algorithm>

#include "analysis/encoding/monitor.hpp"

namespace rungproof {

namespace {

/// Whether the expression speaks of one moment, and of numbers that bits can tell.
bool isOfOneMoment(const ExprNode& n) {
  switch (n.op) {
    case ExprOp::Rises:
    case ExprOp::Falls:
    case ExprOp::Prev:
    case ExprOp::Once:
    case ExprOp::Since:
    case ExprOp::Held:
    case ExprOp::FirstScan: return false;
    default: return n.type != ExprType::Real;
  }
}

/// What stands under node `root`, which becomes the last one.
Expr partOf(const Expr& whole, std::uint32_t root) {
  std::vector<bool> isUsed(root + 1, false);
  isUsed[root] = true;
  for (std::uint32_t i = root + 1; i-- > 0;) {
    if (!isUsed[i]) continue;
    for (const std::uint32_t arg : whole.nodes[i].args) isUsed[arg] = true;
  }
  Expr part;
  std::vector<std::uint32_t> at(root + 1, 0);
  for (std::uint32_t i = 0; i <= root; ++i) {
    if (!isUsed[i]) continue;
    at[i] = static_cast<std::uint32_t>(part.nodes.size());
    part.nodes.push_back(whole.nodes[i]);
    for (std::uint32_t& arg : part.nodes.back().args) arg = at[arg];
  }
  return part;
}

}  // namespace

/// Nodes of all statements of a property together: a chain of a thousand terms has as many parts, each nearly as long.
constexpr std::size_t mostNodes = 20'000;

std::vector<Expr> statementsIn(const Property& property) {
  std::vector<Expr> statements;
  std::size_t nodes = 0;
  for (const Expr* whole : {&property.second, &property.first}) {
    std::vector<bool> isPlain;
    for (const ExprNode& n : whole->nodes)
      isPlain.push_back(isOfOneMoment(n) && std::ranges::all_of(n.args, [&](auto arg) { return isPlain[arg]; }));
    for (auto i = static_cast<std::uint32_t>(whole->nodes.size()); i-- > 0;) {  // the whole before its parts
      const ExprNode& n = whole->nodes[i];
      if (n.type != ExprType::Truth || n.op == ExprOp::Constant || !isPlain[i]) continue;
      Expr part = partOf(*whole, i), opposite = part;
      ExprNode negation;
      negation.op = ExprOp::Not;
      negation.args = {static_cast<std::uint32_t>(part.nodes.size() - 1)};
      opposite.nodes.push_back(negation);
      nodes += part.nodes.size() + opposite.nodes.size();
      if (nodes > mostNodes) return statements;
      statements.push_back(std::move(opposite));
      statements.push_back(std::move(part));
    }
  }
  return statements;
}

std::shared_ptr<const SaidOfMemory> SaidOfMemory::of(const Expr& said, const MemoryLayout& layout) {
  auto result = std::make_shared<SaidOfMemory>();
  result->property_.kind = PropertyKind::Never;
  result->property_.first = said;
  for (const ExprNode& n : said.nodes) {
    const int width = n.type == ExprType::Truth ? 1 : numberBits(n.operand);
    if (n.op == ExprOp::Address && !result->add(n.operand, width, layout)) return nullptr;
  }
  return result;
}

bool SaidOfMemory::add(const Operand& operand, int width, const MemoryLayout& layout) {
  const Area area = operand.area;
  if (operand.kind != OperandKind::Direct) return false;
  // Not data blocks: an address in them is that of its block, and the layout counts them in one row.
  if (area != Area::V && area != Area::M && area != Area::Q && area != Area::S && area != Area::SM) return false;
  const std::uint32_t count = (static_cast<std::uint32_t>(width) + 7) / 8;
  if (!layout.holds(area, operand.offset, count)) return false;
  Read& read = reads_.emplace_back(Read{operand, width, {}});
  const auto take = [&](const Place& cell, std::uint32_t low, std::uint8_t bits) {
    read.pieces.push_back({cell, low, bits});
    if (std::ranges::find(places_, cell) == places_.end()) places_.push_back(cell);
  };
  for (std::uint32_t byte = operand.offset; byte < operand.offset + count; ++byte) {
    if (layout.isSingleBits(area, byte)) {
      for (std::uint32_t bit = 8; bit-- > 0;) {
        if (width > 1 || bit == operand.bit) take(memoryPlace(area, byte, Width::Bit, bit), 0, 1);
      }
      continue;
    }
    const MemoryLayout::Word word = layout.wordOf(area, byte);
    const Place cell{false, area, Reg::Accumulator, word.first * 8, static_cast<std::uint8_t>(word.bytes * 8)};
    const std::uint32_t low = (word.first + word.bytes - 1 - byte) * 8;
    take(cell, width == 1 ? low + operand.bit : low, static_cast<std::uint8_t>(width == 1 ? 1 : 8));
  }
  return true;
}

Node SaidOfMemory::holds(Graph& graph, const std::function<Node(const Place&)>& valueOf) const {
  const auto leaf = [&](const Operand& operand, int width) -> Graph::Bits {
    const auto read = std::ranges::find_if(reads_, [&](const Read& r) {
      const Operand& o = r.operand;
      return o.area == operand.area && o.offset == operand.offset && o.bit == operand.bit && r.width == width;
    });
    Node value = noNode;
    int done = 0;
    for (const Piece& piece : read->pieces) {
      const Node part = graph.make(Op::Extract, piece.width, valueOf(piece.cell), noNode, noNode, piece.low);
      done += piece.width;
      value = value == noNode ? part : graph.make(Op::Concat, done, value, part);
    }
    return {value};
  };
  std::vector<Graph::Bits> none, ignored;
  const Moment<Graph> moment{graph.constant(false), graph.literal(0, 1), 1};
  return Monitor<Graph, decltype(leaf)>(graph, property_, leaf, moment, none, ignored).evaluate().node;
}

Node StateRule::holds(Graph& graph, const ValueOf& valueOf) const {
  if (kind == Kind::Said) return said->holds(graph, valueOf);
  const int w = place.width;
  const Graph::Bits value{valueOf(place)};
  const auto constant = [&](std::uint64_t c) { return graph.literal(c, w); };
  Graph::Bool result = graph.constant(false);
  switch (kind) {
    case Kind::AtLeast: result = graph.ule(constant(constants[0]), value, w); break;
    case Kind::AtMost: result = graph.ule(value, constant(constants[0]), w); break;
    case Kind::SignedAtLeast: result = graph.sle(constant(constants[0]), value, w); break;
    case Kind::SignedAtMost: result = graph.sle(value, constant(constants[0]), w); break;
    case Kind::OneOf: {
      // The ends as well: what follows pointers knows bounds.
      const auto [low, high] = std::ranges::minmax(constants);
      result = graph.land(graph.ule(constant(low), value, w), graph.ule(value, constant(high), w));
      if (high - low + 1 == constants.size()) break;
      Graph::Bool isListed = graph.constant(false);
      for (const std::uint64_t c : constants) isListed = graph.lor(isListed, graph.equal(value, constant(c), w));
      result = graph.land(result, isListed);
      break;
    }
    case Kind::Same: result = graph.equal(value, {valueOf(other)}, w); break;
    case Kind::NotAbove: result = graph.ule(value, {valueOf(other)}, w); break;
    default: result = graph.sle(value, {valueOf(other)}, w); break;
  }
  if (!where) return result.node;
  const Graph::Bool bit{valueOf(where->bit)};
  return graph.lor(where->isOn ? graph.lnot(bit) : bit, result).node;
}

std::vector<Place> StateRule::places() const {
  if (kind == Kind::Said) return said->places();
  std::vector<Place> places{place};
  if (kind >= Kind::Same) places.push_back(other);
  if (where) places.push_back(where->bit);
  return places;
}

Graph::Bool allHold(Graph& graph, const StateRules& rules, const StateRule::ValueOf& valueOf) {
  Graph::Bool result = graph.constant(true);
  for (const StateRule& rule : rules) result = graph.land(result, {rule.holds(graph, valueOf)});
  return result;
}

}  // namespace rungproof
