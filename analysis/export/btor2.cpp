// BTOR2: one line for each sort, variable and operation in the cone of the questions.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "analysis/export/system.hpp"
#include "analysis/graph/evaluate.hpp"

namespace rungproof {

namespace {

const char* operatorName(Op op) {
  switch (op) {
    case Op::Not: return "not";
    case Op::And: return "and";
    case Op::Or: return "or";
    case Op::Xor: return "xor";
    case Op::Add: return "add";
    case Op::Sub: return "sub";
    case Op::Mul: return "mul";
    case Op::Udiv: return "udiv";
    case Op::Urem: return "urem";
    case Op::Sdiv: return "sdiv";
    case Op::Srem: return "srem";
    case Op::Shl: return "sll";
    case Op::Lshr: return "srl";
    case Op::Equal: return "eq";
    case Op::Ult: return "ult";
    case Op::Ule: return "ulte";
    case Op::Slt: return "slt";
    case Op::Sle: return "slte";
    case Op::Ite: return "ite";
    case Op::Concat: return "concat";
    default: return nullptr;
  }
}

class Btor2Text {
 public:
  explicit Btor2Text(const TransitionSystem& system) : system_(system), graph_(*system.graph) {}

  std::string run() {
    // What a state begins with has to stand before it.
    for (const StateVariable& s : system_.states) {
      if (s.init != noNode && graph_[s.init].op == Op::Constant) define(s.init);
    }
    for (const StateVariable& s : system_.states) variable(s.node, "state");
    for (const Node n : system_.inputs) variable(n, "input");
    std::vector<Node> roots = system_.constraints;
    for (const Question& q : system_.questions) roots.push_back(q.bad);
    for (const StateVariable& s : system_.states) {
      roots.push_back(s.next);
      if (s.init != noNode) roots.push_back(s.init);
    }
    for (const Node n : coneOf(graph_, roots)) define(n);
    for (const StateVariable& s : system_.states) {
      const std::size_t type = sort(graph_[s.node].width);
      if (s.init != noNode) line(fmt::format("init {} {} {}", type, id(s.node), id(s.init)));
      line(fmt::format("next {} {} {}", type, id(s.node), id(s.next)));
    }
    for (const Node n : system_.constraints) line(fmt::format("constraint {}", id(n)));
    for (const Question& q : system_.questions) line(fmt::format("bad {} {}", id(q.bad), symbol(q.name)));
    return std::move(text_);
  }

 private:
  std::size_t line(const std::string& content) {
    text_ += fmt::format("{} {}\n", ++last_, content);
    return last_;
  }
  std::size_t sort(int width) {
    std::size_t& known = sorts_[width];
    if (known == 0) known = line(fmt::format("sort bitvec {}", width));
    return known;
  }
  std::size_t id(Node n) const { return ids_.at(n); }
  static std::string symbol(std::string name) {
    std::replace_if(
        name.begin(), name.end(), [](unsigned char c) { return c <= 32 || c == ';'; }, '_');
    return name;
  }
  /// With a name that no other variable has.
  std::size_t declare(const char* kind, int width, const std::string& name) {
    const std::string plain = symbol(name);
    std::string unique = plain;
    for (int k = 2; !given_.insert(unique).second; ++k) unique = fmt::format("{}#{}", plain, k);
    const std::size_t type = sort(width);
    return line(fmt::format("{} {} {}", kind, type, unique));
  }
  void variable(Node n, const char* kind) {
    ids_[n] = declare(kind, graph_[n].width, graph_.variables()[graph_[n].value].name);
  }

  void define(Node n) {
    if (ids_.contains(n)) return;
    const NodeData& node = graph_[n];
    const std::size_t type = sort(node.width);
    if (node.op == Op::Constant) {
      ids_[n] = line(fmt::format("constd {} {}", type, node.value));
    } else if (node.op == Op::Variable || node.op >= Op::RealAdd) {
      ids_[n] = declare("input", node.width, fmt::format("free_{}", indexOf(n)));
    } else if (node.op == Op::Extract) {
      ids_[n] =
          line(fmt::format("slice {} {} {} {}", type, id(node.child[0]), node.value + node.width - 1, node.value));
    } else if (node.op == Op::Zext || node.op == Op::Sext) {
      const char* name = node.op == Op::Zext ? "uext" : "sext";
      ids_[n] =
          line(fmt::format("{} {} {} {}", name, type, id(node.child[0]), node.width - graph_[node.child[0]].width));
    } else {
      std::string arguments;
      for (const Node child : node.child) {
        if (child != noNode) arguments += fmt::format(" {}", id(child));
      }
      ids_[n] = line(fmt::format("{} {}{}", operatorName(node.op), type, arguments));
    }
  }

  const TransitionSystem& system_;
  const Graph& graph_;
  std::string text_;
  std::size_t last_ = 0;
  std::map<int, std::size_t> sorts_;
  std::map<Node, std::size_t> ids_;
  std::set<std::string> given_;  ///< names
};

}  // namespace

std::string exportBtor2(const TransitionSystem& system, const ExportRemarks& remarks) {
  std::string text;
  for (const std::string& remark : remarks) text += "; " + exportLine(remark) + "\n";
  return text + Btor2Text(system).run();
}

}  // namespace rungproof
