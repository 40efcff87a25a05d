// The grammar: a rung is a group and outputs; a group is a series of contacts and groups, or parallel branches.
#include "tests/drawing/random_network.hpp"

#include <cstdlib>
#include <vector>

#include "ir/s7200/isa.hpp"
#include "tests/drawing/networks.hpp"

namespace rungproof::testing {

namespace {

using Statements = std::vector<std::string>;

class Grammar {
 public:
  Grammar(std::mt19937_64& random, Form form) : random_(random), isFbd_(form == Form::Fbd) {}

  Statements rung() {
    if (chance(12)) return call();
    if (chance(10)) return box();
    Statements code = series(2, true);
    append(code, outputs(2));
    return code;
  }

 private:
  std::size_t below(std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_); }
  bool chance(std::size_t percent) { return below(100) < percent; }
  static void append(Statements& code, const Statements& more) { code.insert(code.end(), more.begin(), more.end()); }

  std::string bitAddress() { return (chance(70) ? "I0." : "M0.") + std::to_string(below(8)); }
  /// "LD I0.0", "A I0.0": `joint` is LD, A or O.
  std::string contact(const std::string& joint) {
    if (chance(15)) return joint + "W>= VW" + std::to_string(2 * below(4)) + ", +" + std::to_string(below(50));
    if (chance(10)) return joint + "I I0." + std::to_string(below(8));
    return joint + (chance(30) ? "N " : " ") + bitAddress();
  }
  std::string transform() {
    static constexpr const char* names[] = {"EU", "ED", "NOT"};
    return names[below(3)];
  }

  /// At least one contact; `mayTransform`: edges and NOT may stand in it, which a ladder allows at the rail only.
  Statements series(std::size_t depth, bool mayTransform) {
    Statements code = depth > 0 && chance(40) ? parallel(depth - 1, mayTransform) : Statements{contact("LD")};
    if (mayTransform && chance(15)) code.push_back(transform());
    for (std::size_t n = below(3); n > 0; --n) {
      if (depth > 0 && chance(35)) {
        append(code, parallel(depth - 1, isFbd_ && mayTransform));
        code.push_back("ALD");
      } else {
        code.push_back(contact("A"));
      }
      if (mayTransform && chance(10)) code.push_back(transform());
    }
    return code;
  }
  /// Two branches or more.
  Statements parallel(std::size_t depth, bool mayTransform) {
    Statements code = series(depth, mayTransform);
    for (std::size_t n = 1 + below(3); n > 0; --n) {
      Statements branch = series(depth, mayTransform);
      if (branch.size() == 1) {
        code.push_back("O" + branch[0].substr(2));
      } else {
        append(code, branch);
        code.push_back("OLD");
      }
    }
    return code;
  }

  std::string coil() {
    switch (below(6)) {
      case 0: return "S M0." + std::to_string(below(8)) + ", 1";
      case 1: return "R Q0." + std::to_string(below(8)) + ", 2";
      case 2: return "TON T" + std::to_string(37 + below(4)) + ", +" + std::to_string(below(9));
      case 3: return "=I Q1." + std::to_string(below(8));
      default: return "= " + std::string(chance(60) ? "Q0." : "M0.") + std::to_string(below(8));
    }
  }
  std::string enoBox() {
    return chance(50) ? "+I VW0, VW" + std::to_string(2 * below(4)) : "MOVW VW2, VW" + std::to_string(2 * below(4));
  }

  /// What stands on the right of a point: coils leave the top as it is, everything else changes it.
  struct Branch {
    Statements code;
    bool changesTop;
  };
  Branch branch(std::size_t depth) {
    if (depth == 0 || chance(40)) return {{chance(30) ? enoBox() : coil()}, false};
    Statements code;
    switch (below(4)) {
      case 0: code = {transform()}; break;
      case 1: code = {enoBox(), "AENO"}; break;
      case 2:
        code = parallel(1, isFbd_);
        code.push_back("ALD");
        break;
      default: code = {contact("A")};
    }
    append(code, outputs(depth - 1));
    return {std::move(code), true};
  }
  Statements outputs(std::size_t depth) {
    std::vector<Branch> branches;
    for (std::size_t n = 1 + below(3); n > 0; --n) branches.push_back(branch(depth));
    Statements code;
    bool isSaved = false;
    for (std::size_t i = 0; i < branches.size(); ++i) {
      if (i > 0 && branches[i - 1].changesTop) {
        isSaved = false;  // does another branch before the last one change the top?
        for (std::size_t k = i; k + 1 < branches.size(); ++k) isSaved = isSaved || branches[k].changesTop;
        code.push_back(isSaved ? "LRD" : "LPP");
      }
      if (branches[i].changesTop && i + 1 < branches.size() && !isSaved) {
        code.push_back("LPS");
        isSaved = true;
      }
      append(code, branches[i].code);
    }
    return code;
  }

  Statements call() {
    Statements code = series(1, true);
    code.push_back("= L60.0");
    append(code, series(1, true));
    code.push_back("= L63.7");
    append(code, series(1, true));
    append(code, {"= L63.6", "LD L60.0", "CALL SBR0, L63.7, L63.6, Q0.0"});
    return code;
  }
  Statements box() {
    Statements code = series(1, true);
    append(code, series(1, true));
    if (chance(50)) {
      code.push_back("CTU C1, +5");
    } else {
      append(code, series(1, true));
      code.push_back("CTUD C2, +5");
    }
    return code;
  }

  std::mt19937_64& random_;
  bool isFbd_;
};

}  // namespace

std::uint64_t drawingSeed() {
  const char* given = std::getenv("RUNGPROOF_SEED");
  return given == nullptr ? 20040601 : std::strtoull(given, nullptr, 10);
}

std::string randomRung(std::mt19937_64& random, Form form) {
  std::string text;
  for (const std::string& statement : Grammar(random, form).rung()) text += (text.empty() ? "" : "; ") + statement;
  return text;
}

Drawing randomDrawing(std::mt19937_64& random, std::size_t size) {
  struct Choice {
    Shape shape;
    std::string_view instruction;
    std::size_t inputs;
    bool hasOutput;
    std::string_view drawingOnly = {};  ///< the instruction that it is in truth, with these operands
  };
  static constexpr Choice choices[] = {
      {Shape::Contact, "LD I0.0", 1, true},
      {Shape::Contact, "LDN I0.1", 1, true},
      {Shape::Contact, "LD M0.0", 1, true},
      {Shape::Contact, "LD Q0.0", 1, true},
      {Shape::Contact, "LD T37", 1, true},
      {Shape::Contact, "LDW>= VW0, +3", 1, true},
      {Shape::Contact, "LDI I0.0", 1, true},
      {Shape::Contact, "LDB= SMB4, 0", 1, true},
      {Shape::Contact, "LD SM1.1", 1, true},
      {Shape::Contact, "EU", 1, true},
      {Shape::Contact, "NOT", 1, true},
      {Shape::And, "", 2, true},
      {Shape::And, "", 3, true},
      {Shape::Or, "", 2, true},
      {Shape::Or, "", 3, true},
      {Shape::Box, "+I VW2, VW0", 1, true},
      {Shape::Box, "MOVB 1, MB0", 1, true},
      {Shape::Box, "TON T37, +5", 1, false},
      {Shape::Box, "CTU C1, +5", 2, false},
      {Shape::Box, "CTUD C2, +5", 3, false},
      {Shape::Coil, "= Q0.0", 1, false},
      {Shape::Coil, "= M0.0", 1, false},
      {Shape::Coil, "S M0.0, 1", 1, false},
      {Shape::Coil, "R Q0.0, 2", 1, false},
      {Shape::Coil, "= Q0.1", 1, false},
      {Shape::Box, "= M0.1", 2, true, "SR"},
      {Shape::Box, "= M0.2", 2, true, "RS"},
      {Shape::Box, "TON T38, +5", 1, true, "TON.IEC"},
  };
  static const std::vector<Element> samples = [] {
    std::vector<Element> result;
    for (const Choice& choice : choices) {
      result.push_back(element(choice.shape, choice.instruction, {}));
      if (!choice.drawingOnly.empty()) result.back().desc = s7200Instructions().named(choice.drawingOnly);
    }
    return result;
  }();
  const auto below = [&](std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random); };
  Drawing drawing;
  drawing.elements.emplace_back();
  std::vector<std::uint32_t> outputs = {0};
  while (drawing.elements.size() < size) {
    const std::size_t chosen = below(std::size(choices));
    Element next = samples[chosen];
    for (std::size_t i = 0; i < choices[chosen].inputs; ++i) {
      const std::size_t recent = std::min<std::size_t>(outputs.size(), 4);
      const std::size_t from = below(100) < 60 ? outputs.size() - 1 - below(recent) : below(outputs.size());
      next.inputs.push_back({outputs[from], below(100) < 12});
    }
    if (choices[chosen].hasOutput) outputs.push_back(static_cast<std::uint32_t>(drawing.elements.size()));
    drawing.elements.push_back(std::move(next));
  }
  return drawing;
}

}  // namespace rungproof::testing
