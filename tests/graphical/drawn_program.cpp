// Generator, writer and evaluator of random drawings.
#include "tests/graphical/drawn_program.hpp"

#include <algorithm>

#include "tests/graphical/plcopen_text.hpp"

namespace rungproof {

namespace {

class Generator {
 public:
  explicit Generator(std::mt19937& random) : random_(random) {}

  DrawnProgram make() {
    program_.isLadder = pick(2) == 0;
    const int rungs = 3 + pick(8);
    for (int i = 0; i < rungs; ++i) rung();
    return std::move(program_);
  }

 private:
  int pick(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }

  std::string source() {
    const int kind = pick(10);
    if (kind < 5) return fmt::format("i{}", pick(6));
    if (kind < 7) return fmt::format("q{}", pick(6));
    if (kind < 9 || program_.boxes.empty()) return fmt::format("m{}", pick(6));
    auto box = program_.boxes.begin();
    std::advance(box, pick(static_cast<int>(program_.boxes.size())));
    const bool isPlain = box->second == "TON" || box->second == "TOF" || box->second == "TP" || box->second == "CTU" ||
                         box->second == "CTD";
    return isPlain ? box->first + ".Q" : fmt::format("i{}", pick(6));
  }

  DrawnExprPtr contact() {
    auto e = std::make_shared<DrawnExpr>();
    if (pick(12) == 0) {
      static const char* relations[] = {"GT", "GE", "EQ", "LE", "LT", "NE"};
      e->kind = DrawnExpr::Kind::Compare;
      e->type = relations[pick(6)];
      e->name = fmt::format("n{}", pick(3));
      e->preset = pick(8);
      return e;
    }
    e->name = source();
    e->negated = pick(3) == 0;
    if (program_.isLadder && !e->negated && pick(6) == 0) {
      e->edge = pick(2) == 0 ? 1 : -1;
      e->memory = program_.memories++;
    }
    return e;
  }

  DrawnExprPtr power(int depth) {
    if (depth == 0 || pick(3) == 0) return contact();
    auto e = std::make_shared<DrawnExpr>();
    const int kind = pick(program_.isLadder ? 2 : 4);
    e->kind = kind == 0   ? DrawnExpr::Kind::And
              : kind == 1 ? DrawnExpr::Kind::Or
              : kind == 2 ? DrawnExpr::Kind::Xor
                          : DrawnExpr::Kind::Not;
    const int count = e->kind == DrawnExpr::Kind::Not ? 1 : e->kind == DrawnExpr::Kind::Xor ? 2 : 2 + pick(2);
    for (int i = 0; i < count; ++i) e->inputs.push_back(power(depth - 1));
    if (!program_.isLadder) e->negated = pick(5) == 0;
    return e;
  }

  DrawnExprPtr box() {
    static const char* types[] = {"TON", "TOF", "TP", "CTU", "CTD", "CTUD", "SR", "RS", "R_TRIG", "F_TRIG"};
    auto e = std::make_shared<DrawnExpr>();
    e->kind = DrawnExpr::Kind::Box;
    e->type = types[pick(10)];
    e->name = fmt::format("B{}", program_.boxes.size());
    const bool isCount = e->type.starts_with("CT");
    e->preset = isCount ? pick(6) - 1 : 1 + pick(6);
    const std::size_t inputs = e->type == "CTUD"                                                            ? 4
                               : e->type == "CTU" || e->type == "CTD" || e->type == "SR" || e->type == "RS" ? 2
                                                                                                            : 1;
    for (std::size_t i = 0; i < inputs; ++i) e->inputs.push_back(power(i == 0 ? 2 : 1));
    if (e->type == "R_TRIG" || e->type == "F_TRIG") e->memory = program_.memories++;
    program_.boxes[e->name] = e->type;
    return e;
  }

  void rung() {
    DrawnRung rung;
    const int kind = pick(10);
    if (kind == 0) {
      rung.power = contact();
      rung.target = fmt::format("n{}", pick(3));
      rung.number = pick(2) == 0 ? "STEP" : "PICK";
      rung.preset = pick(9);
      rung.other = fmt::format("n{}", pick(3));
      program_.rungs.push_back(std::move(rung));
      return;
    }
    rung.power = kind < 4 ? box() : power(3);
    rung.target = fmt::format("{}{}", pick(2) == 0 ? 'q' : 'm', pick(6));
    const int storage = pick(8);
    if (storage < 4)
      rung.storage = 0;
    else if (storage == 4)
      rung.storage = 2;
    else if (program_.isLadder)
      rung.storage = storage == 5 ? 1 : storage == 6 ? -1 : pick(2) == 0 ? 3 : 4;
    if (rung.storage >= 3) rung.memory = program_.memories++;
    program_.rungs.push_back(std::move(rung));
  }

  std::mt19937& random_;
  DrawnProgram program_;
};

class Writer {
 public:
  Writer(const DrawnProgram& program, std::mt19937& random) : program_(program), random_(random) {}

  std::string write() {
    if (program_.isLadder) lines_.push_back(railElement(rail_));
    for (const DrawnRung& rung : program_.rungs) {
      writeRung(rung);
      y_ += 100;
    }
    std::shuffle(lines_.begin(), lines_.end(), random_);
    std::string body;
    for (const std::string& line : lines_) body += line;
    std::vector<std::string> variables;
    for (int i = 0; i < 6; ++i) {
      variables.push_back(fmt::format("i{}:BOOL@%IX0.{}", i, i));
      variables.push_back(fmt::format("q{}:BOOL@%QX0.{}", i, i));
      variables.push_back(fmt::format("m{}:BOOL", i));
      if (i < 3) variables.push_back(fmt::format("n{}:INT", i));
    }
    for (const auto& [name, type] : program_.boxes) variables.push_back(name + ":" + type);
    return plcopen(variables, program_.isLadder ? "LD" : "FBD", body);
  }

 private:
  using Sources = std::vector<std::string>;
  int id() { return next_++; }

  Sources power(const DrawnExpr& e, Sources left, int& x) {
    switch (e.kind) {
      case DrawnExpr::Kind::Compare: {
        const int a = id(), b = id(), block = id();
        lines_.push_back(inElement(a, e.name, "", x, y_ + 20));
        lines_.push_back(inElement(b, fmt::format("{}", e.preset), "", x, y_ + 40));
        std::vector<TestPin> pins;
        if (program_.isLadder) pins.push_back({"EN", left});
        pins.push_back({"IN1", {fmt::format("{}", a)}});
        pins.push_back({"IN2", {fmt::format("{}", b)}});
        lines_.push_back(blockElement(block, e.type, "", pins, {"ENO", "OUT"}, x += 10, y_));
        return {fmt::format("{}.OUT", block)};
      }
      case DrawnExpr::Kind::Contact: {
        const int i = id();
        if (program_.isLadder) {
          const std::string attributes = e.negated    ? "negated=\"true\""
                                         : e.edge > 0 ? "edge=\"rising\""
                                         : e.edge < 0 ? "edge=\"falling\""
                                                      : "negated=\"false\"";
          lines_.push_back(contactElement(i, left, e.name, attributes, x += 10, y_));
        } else {
          lines_.push_back(inElement(i, e.name, e.negated ? "negated=\"true\"" : "", x, y_));
        }
        return {fmt::format("{}", i)};
      }
      case DrawnExpr::Kind::Box: return box(e, left, x);
      default: break;
    }
    if (program_.isLadder) {
      if (e.kind == DrawnExpr::Kind::And) {
        for (const DrawnExprPtr& part : e.inputs) left = power(*part, left, x);
        return left;
      }
      Sources ends;
      for (const DrawnExprPtr& part : e.inputs) {
        for (std::string& end : power(*part, left, x)) ends.push_back(std::move(end));
      }
      return ends;
    }
    std::vector<TestPin> pins;
    for (const DrawnExprPtr& part : e.inputs)
      pins.push_back({fmt::format("IN{}", pins.size() + 1), power(*part, {}, x)});
    const int i = id();
    const char* type = e.kind == DrawnExpr::Kind::And   ? "AND"
                       : e.kind == DrawnExpr::Kind::Or  ? "OR"
                       : e.kind == DrawnExpr::Kind::Xor ? "XOR"
                                                        : "NOT";
    std::string text = blockElement(i, type, "", pins, {"OUT"}, x += 10, y_);
    if (e.negated) text.replace(text.rfind("formalParameter=\"OUT\""), 21, "formalParameter=\"OUT\" negated=\"true\"");
    lines_.push_back(text);
    return {fmt::format("{}.OUT", i)};
  }

  Sources box(const DrawnExpr& e, const Sources& left, int& x) {
    static const std::map<std::string, std::vector<std::string>> names = {
        {"TON", {"IN"}},      {"TOF", {"IN"}},       {"TP", {"IN"}},
        {"CTU", {"CU", "R"}}, {"CTD", {"CD", "LD"}}, {"CTUD", {"CU", "CD", "R", "LD"}},
        {"SR", {"S1", "R"}},  {"RS", {"S", "R1"}},   {"R_TRIG", {"CLK"}},
        {"F_TRIG", {"CLK"}}};
    std::vector<TestPin> pins;
    for (std::size_t k = 0; k < e.inputs.size(); ++k)
      pins.push_back({names.at(e.type)[k], power(*e.inputs[k], left, x)});
    const bool isTimer = e.type[0] == 'T', isCounter = e.type[0] == 'C';
    if (isTimer || isCounter) {
      const int preset = id();
      lines_.push_back(inElement(preset, isTimer ? fmt::format("T#{}ms", e.preset * 100) : fmt::format("{}", e.preset),
                                 "", x, y_ + 30));
      pins.push_back({isTimer ? "PT" : "PV", {fmt::format("{}", preset)}});
    }
    const std::string out = e.type == "CTUD" ? "QU" : e.type == "SR" || e.type == "RS" ? "Q1" : "Q";
    const int i = id();
    lines_.push_back(blockElement(i, e.type, e.name, pins, {out}, x += 10, y_));
    return {fmt::format("{}.{}", i, out)};
  }

  void writeRung(const DrawnRung& rung) {
    int x = 10;
    const Sources left = program_.isLadder ? Sources{fmt::format("{}", rail_)} : Sources{};
    const Sources ends = power(*rung.power, left, x);
    const int i = id();
    if (rung.number == "STEP") {
      const int a = id(), one = id(), top = id(), sum = id(), least = id();
      lines_.push_back(inElement(a, rung.target, "", x, y_ + 20));
      lines_.push_back(inElement(one, "1", "", x, y_ + 30));
      lines_.push_back(inElement(top, fmt::format("{}", rung.preset), "", x, y_ + 40));
      lines_.push_back(blockElement(sum, "ADD", "",
                                    {{"EN", ends}, {"IN1", {fmt::format("{}", a)}}, {"IN2", {fmt::format("{}", one)}}},
                                    {"ENO", "OUT"}, x + 10, y_));
      lines_.push_back(blockElement(
          least, "MIN", "", {{"EN", ends}, {"IN1", {fmt::format("{}.OUT", sum)}}, {"IN2", {fmt::format("{}", top)}}},
          {"ENO", "OUT"}, x + 20, y_));
      lines_.push_back(outElement(i, {fmt::format("{}.OUT", least)}, rung.target, "", x + 30, y_));
      return;
    }
    if (rung.number == "PICK") {
      const int a = id(), b = id(), choice = id();
      lines_.push_back(inElement(a, fmt::format("{}", rung.preset), "", x, y_ + 20));
      lines_.push_back(inElement(b, rung.other, "", x, y_ + 30));
      lines_.push_back(blockElement(choice, "SEL", "",
                                    {{"G", ends}, {"IN0", {fmt::format("{}", a)}}, {"IN1", {fmt::format("{}", b)}}},
                                    {"OUT"}, x + 10, y_));
      lines_.push_back(outElement(i, {fmt::format("{}.OUT", choice)}, rung.target, "", x + 30, y_));
      return;
    }
    if (!program_.isLadder) {
      lines_.push_back(outElement(i, ends, rung.target, rung.storage == 2 ? "negated=\"true\"" : "", x + 10, y_));
      return;
    }
    static const std::map<int, std::string> attributes = {{0, ""},
                                                          {1, "storage=\"set\""},
                                                          {-1, "storage=\"reset\""},
                                                          {2, "negated=\"true\""},
                                                          {3, "edge=\"rising\""},
                                                          {4, "edge=\"falling\""}};
    lines_.push_back(coilElement(i, ends, rung.target, attributes.at(rung.storage), x + 10, y_));
  }

  const DrawnProgram& program_;
  std::mt19937& random_;
  std::vector<std::string> lines_;
  int rail_ = 1, next_ = 2, y_ = 100;
};

}  // namespace

std::string DrawnProgram::text(std::mt19937& random) const { return Writer(*this, random).write(); }

DrawnProgram randomDrawing(std::mt19937& random) { return Generator(random).make(); }

void DrawnEvaluator::scan(const std::map<std::string, bool>& inputs) {
  ++scans_;
  for (const auto& [name, value] : inputs) bits_[name] = value;
  for (const DrawnRung& rung : program_.rungs) {
    const bool flow = power(*rung.power);
    if (rung.number == "STEP") {
      if (flow) numbers_[rung.target] = std::min(numbers_[rung.target] + 1, rung.preset);
    } else if (rung.number == "PICK") {
      numbers_[rung.target] = flow ? numbers_[rung.other] : rung.preset;
    } else if (rung.storage == 0) {
      bits_[rung.target] = flow;
    } else if (rung.storage == 2) {
      bits_[rung.target] = !flow;
    } else if (rung.storage >= 3) {
      bits_[rung.target] = edge(rung.memory, rung.storage == 3 ? 1 : -1, flow);
    } else if (flow) {
      bits_[rung.target] = rung.storage == 1;
    }
  }
}

bool DrawnEvaluator::edge(int memory, int kind, bool now) {
  // R_TRIG: Q := CLK AND NOT M; M := CLK. F_TRIG: the same of NOT CLK. M starts with 0, so the first scan has edges.
  const bool seen = kind > 0 ? now : !now;
  const bool before = memory_[static_cast<std::size_t>(memory)];
  memory_[static_cast<std::size_t>(memory)] = seen;
  return seen && !before;
}

/// All parts are evaluated, whatever the others say: they may have edges and boxes.
bool DrawnEvaluator::power(const DrawnExpr& e) {
  std::vector<bool> in;
  if (e.kind != DrawnExpr::Kind::Box) {
    for (const DrawnExprPtr& part : e.inputs) in.push_back(power(*part));
  }
  bool result = false;
  switch (e.kind) {
    case DrawnExpr::Kind::Contact: {
      const std::size_t point = e.name.find('.');
      result = (point == std::string::npos ? bits_[e.name] : boxes_[e.name.substr(0, point)].q) != e.negated;
      return e.edge == 0 ? result : edge(e.memory, e.edge, result);
    }
    case DrawnExpr::Kind::Compare: {
      const int value = numbers_[e.name];
      return e.type == "GT"   ? value > e.preset
             : e.type == "GE" ? value >= e.preset
             : e.type == "EQ" ? value == e.preset
             : e.type == "LE" ? value <= e.preset
             : e.type == "LT" ? value < e.preset
                              : value != e.preset;
    }
    case DrawnExpr::Kind::And: result = std::all_of(in.begin(), in.end(), [](bool b) { return b; }); break;
    case DrawnExpr::Kind::Or: result = std::any_of(in.begin(), in.end(), [](bool b) { return b; }); break;
    case DrawnExpr::Kind::Xor: result = in[0] != in[1]; break;
    case DrawnExpr::Kind::Not: result = !in[0]; break;
    case DrawnExpr::Kind::Box: return box(e);
  }
  return result != e.negated;
}

bool DrawnEvaluator::box(const DrawnExpr& e) {
  std::vector<bool> in;
  for (const DrawnExprPtr& part : e.inputs) in.push_back(power(*part));
  Box& b = boxes_[e.name];
  const bool rises = in[0] && !b.before;  // the memory of an edge starts with 0
  if (e.type == "TON") {
    // The scan in which a timer is enabled brings it nothing: it counts the time of the scan before (001:6590).
    b.current = in[0] && b.before ? std::min(b.current + 1, 32767) : 0;
    b.q = in[0] && b.current >= e.preset;
  } else if (e.type == "TOF") {
    const bool wasRunning = b.running;
    if (in[0]) {
      b.q = true;
      b.running = false;
      b.current = 0;
    } else if (b.before) {
      b.running = true;
    }
    if (b.running) {
      b.current += wasRunning ? 1 : 0;
      if (b.current >= e.preset) b.q = b.running = false;
    }
  } else if (e.type == "TP") {
    // A pulse that follows at once on the last one keeps the timer running, so that it counts without a pause.
    const bool wasTiming = b.active || b.ended;
    if (!b.active && rises) {
      b.active = true;
      b.current = 0;
    }
    if (b.active && wasTiming) ++b.current;
    b.ended = b.active && b.current >= e.preset;
    if (b.ended) b.active = false;
    b.q = b.active;
  } else if (e.type == "CTU") {
    if (in[1])
      b.current = 0;
    else if (rises && b.current < 32767)
      ++b.current;
    b.q = b.current >= e.preset;
  } else if (e.type == "CTD") {
    if (in[1])
      b.current = e.preset;
    else if (rises && b.current > 0)
      --b.current;
    b.q = b.current <= 0;
  } else if (e.type == "CTUD") {
    const bool risesDown = in[1] && !b.beforeDown;
    if (in[2])
      b.current = 0;
    else if (in[3])
      b.current = e.preset;
    else if (rises && !risesDown)
      b.current = std::min(b.current + 1, 32767);
    else if (risesDown && !rises && b.current > 0)
      --b.current;
    b.beforeDown = in[1];
    b.q = b.current >= e.preset;
  } else if (e.type == "SR") {
    b.q = in[0] || (b.q && !in[1]);
  } else if (e.type == "RS") {
    b.q = (in[0] || b.q) && !in[1];
  } else {
    b.q = edge(e.memory, e.type == "R_TRIG" ? 1 : -1, in[0]);
  }
  b.before = in[0];
  return b.q;
}

}  // namespace rungproof
