// Reading and evaluating a property.
#include "property.hpp"

#include <cctype>
#include <stdexcept>

namespace rungproof::referee {
namespace {

const std::vector<std::vector<std::string>>& binaryLevels() {
  static const std::vector<std::vector<std::string>> levels = {
      {"implies"}, {"or"}, {"xor"}, {"and"}, {"not"}, {"=", "<>", "<", "<=", ">", ">="}, {"+", "-"}};
  return levels;
}

std::vector<std::string> tokensOf(const std::string& text) {
  std::vector<std::string> tokens;
  for (std::size_t at = 0; at < text.size();) {
    const char c = text[at];
    if (c == ' ') {
      ++at;
      continue;
    }
    std::size_t end = at + 1;
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
      while (end < text.size() && (std::isalnum(static_cast<unsigned char>(text[end])) != 0 ||
                                   std::string("._#").find(text[end]) != std::string::npos))
        ++end;
    } else if (end < text.size() && (c == '<' || c == '>') && (text[end] == '=' || text[end] == '>')) {
      ++end;
    }
    tokens.push_back(text.substr(at, end - at));
    at = end;
  }
  return tokens;
}

}  // namespace

Property::Property(const std::string& line) : text_(line) {
  const std::size_t colon = line.find(':');
  if (colon == std::string::npos) throw std::invalid_argument("no colon in " + line);
  const std::vector<std::string> head = tokensOf(line.substr(0, colon));
  if (head.size() != 2) throw std::invalid_argument("no name in " + line);
  name_ = head[1];
  if (head[0] == "reach") kind_ = Kind::Reach;
  tokens_ = tokensOf(line.substr(colon + 1));
  if (take("never")) never_ = true;
  if (take("always")) never_ = false;
  root_ = parse(0);
  if (take("only")) {
    if (!take("after")) throw std::invalid_argument(line);
    kind_ = Kind::OnlyAfter;
    second_ = parse(0);
  } else if (take("unless")) {
    kind_ = Kind::Unless;
    second_ = parse(0);
  } else if (take("leads")) {
    if (!take("to")) throw std::invalid_argument(line);
    kind_ = Kind::Within;
    second_ = parse(0);
    if (!take("within")) throw std::invalid_argument(line);
    within_ = std::stoi(tokens_.at(at_++));
    if (!take("scans")) throw std::invalid_argument(line);
  }
  if (at_ != tokens_.size()) throw std::invalid_argument("the referee cannot read " + line);
}

int Property::add(Node node) {
  nodes_.push_back(std::move(node));
  return static_cast<int>(nodes_.size()) - 1;
}

std::string Property::peek() const { return at_ < tokens_.size() ? tokens_[at_] : std::string(); }

bool Property::take(const std::string& token) {
  if (peek() != token) return false;
  ++at_;
  return true;
}

int Property::parse(int level) {
  const auto& levels = binaryLevels();
  if (level == static_cast<int>(levels.size())) return primary();
  const std::vector<std::string>& here = levels[static_cast<std::size_t>(level)];
  if (here[0] == "not") {
    if (!take("not")) return parse(level + 1);
    Node node;
    node.op = "not";
    node.left = parse(level);
    return add(node);
  }
  int left = parse(level + 1);
  for (bool found = true; found;) {
    found = false;
    for (const std::string& op : here) {
      if (!take(op)) continue;
      Node node;
      node.op = op;
      node.left = left;
      node.right = parse(op == "implies" ? level : level + 1);
      left = add(node);
      found = true;
      break;
    }
  }
  return left;
}

int Property::call(const std::string& name) {
  Node node;
  node.op = name;
  node.left = parse(0);
  if (name == "held") {
    if (!take(",")) throw std::invalid_argument(text_);
    const std::string time = tokens_.at(at_++);
    const bool milliseconds = time.find("ms") != std::string::npos;
    node.number = std::stoll(time) * (milliseconds ? 1 : 1000);
  }
  if (!take(")")) throw std::invalid_argument(text_);
  return add(node);
}

int Property::primary() {
  if (take("(")) {
    const int inner = parse(0);
    if (!take(")")) throw std::invalid_argument(text_);
    return inner;
  }
  const std::string token = tokens_.at(at_++);
  for (const char* function : {"prev", "once", "rises", "falls", "held"}) {
    if (token == function && take("(")) return call(token);
  }
  Node node;
  if (token == "first_scan") {
    node.op = "first";
    return add(node);
  }
  const std::size_t dot = token.find(".value");
  node.operand = operandOf(token.substr(0, dot));
  node.value = dot != std::string::npos;
  node.number = node.operand.value;
  node.op = node.operand.area == Area::Number ? "number" : "address";
  return add(node);
}

void Property::reset() {
  first_ = true;
  pending_ = seen_ = false;
  waiting_ = -1;
}

bool Property::hits(const Machine& machine) {
  for (Node& n : nodes_) {  // operands stand before what uses them
    const std::int64_t left = n.left < 0 ? 0 : nodes_[static_cast<std::size_t>(n.left)].now;
    const std::int64_t right = n.right < 0 ? 0 : nodes_[static_cast<std::size_t>(n.right)].now;
    const std::int64_t before = n.before;
    if (n.op == "number")
      n.now = n.number;
    else if (n.op == "first")
      n.now = first_ ? 1 : 0;
    else if (n.op == "address") {
      const bool bit = (n.operand.area == Area::T || n.operand.area == Area::C) && !n.value;
      n.now = bit ? (machine.bitOf(n.operand) ? 1 : 0) : machine.valueOf(n.operand);
    } else if (n.op == "not")
      n.now = left == 0 ? 1 : 0;
    else if (n.op == "and")
      n.now = left != 0 && right != 0 ? 1 : 0;
    else if (n.op == "or")
      n.now = left != 0 || right != 0 ? 1 : 0;
    else if (n.op == "xor")
      n.now = (left != 0) != (right != 0) ? 1 : 0;
    else if (n.op == "implies")
      n.now = left == 0 || right != 0 ? 1 : 0;
    else if (n.op == "=")
      n.now = left == right ? 1 : 0;
    else if (n.op == "<>")
      n.now = left != right ? 1 : 0;
    else if (n.op == "<")
      n.now = left < right ? 1 : 0;
    else if (n.op == "<=")
      n.now = left <= right ? 1 : 0;
    else if (n.op == ">")
      n.now = left > right ? 1 : 0;
    else if (n.op == ">=")
      n.now = left >= right ? 1 : 0;
    else if (n.op == "+")
      n.now = left + right;
    else if (n.op == "-")
      n.now = left - right;
    else if (n.op == "prev") {
      n.now = first_ ? left : before;
      n.before = left;
    } else if (n.op == "rises") {
      n.now = !first_ && left != 0 && before == 0 ? 1 : 0;
      n.before = left;
    } else if (n.op == "falls") {
      n.now = !first_ && left == 0 && before != 0 ? 1 : 0;
      n.before = left;
    } else if (n.op == "once") {
      n.now = left != 0 || (!first_ && before != 0) ? 1 : 0;
      n.before = n.now;
    } else if (n.op == "held") {
      if (first_) n.since = -1;
      if (left == 0)
        n.since = -1;
      else if (n.since < 0)
        n.since = machine.now();
      n.now = n.since >= 0 && machine.now() - n.since >= n.number ? 1 : 0;
    }
  }
  first_ = false;
  const bool holds = nodes_[static_cast<std::size_t>(root_)].now != 0;
  const bool other = second_ >= 0 && nodes_[static_cast<std::size_t>(second_)].now != 0;
  switch (kind_) {
    case Kind::Reach: return holds;
    case Kind::Always: return never_ == holds;
    case Kind::OnlyAfter: seen_ = seen_ || other; return holds && !seen_;
    case Kind::Unless: {
      const bool broken = pending_ && !holds && !other;
      pending_ = holds && !other;
      return broken;
    }
    case Kind::Within:
      if (waiting_ >= 0) ++waiting_;
      if (holds && waiting_ < 0) waiting_ = 0;
      if (other) waiting_ = -1;
      return waiting_ >= within_;
  }
  return false;
}

}  // namespace rungproof::referee
