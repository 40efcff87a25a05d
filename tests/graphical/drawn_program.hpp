// Random drawings and a direct evaluator of them, written without looking at the product's lowering: the evaluator
// walks the same tree that the text is written from. Scans are 100 ms long, so that a timer of 100 ms counts one step
// in every scan but the first. Edges are those of EU and ED: none in the first scan.
#pragma once

#include <map>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace rungproof {

struct DrawnExpr;
using DrawnExprPtr = std::shared_ptr<DrawnExpr>;

/// Power: a contact, gates, or the output of a function block.
struct DrawnExpr {
  enum class Kind { Contact, And, Or, Xor, Not, Box, Compare } kind = Kind::Contact;
  std::string name;  ///< variable; instance of a box
  bool negated = false;
  int edge = 0;  ///< contact: 1 rising, -1 falling
  std::vector<DrawnExprPtr> inputs;
  std::string type;  ///< box; relation of a comparison
  int preset = 0;    ///< steps or count; right side of a comparison
  int memory = -1;   ///< of an edge contact
};

/// One circuit: power to a coil or a variable, or a number to a variable.
struct DrawnRung {
  DrawnExprPtr power;
  std::string target;
  int storage = 0;  ///< 1 set, -1 reset, 2 negated, 3 rising, 4 falling
  int memory = -1;
  std::string number;  ///< "STEP": target := MIN(target + 1, preset) under power; "PICK": SEL(power, preset, other)
  int preset = 0;
  std::string other;
};

struct DrawnProgram {
  bool isLadder = true;
  std::vector<DrawnRung> rungs;
  std::map<std::string, std::string> boxes;  ///< instance to type
  int memories = 0;

  std::string text(std::mt19937& random) const;
};

DrawnProgram randomDrawing(std::mt19937& random);

/// State of one program and its meaning.
class DrawnEvaluator {
 public:
  explicit DrawnEvaluator(const DrawnProgram& program)
      : program_(program), memory_(static_cast<std::size_t>(program.memories), false) {}
  void scan(const std::map<std::string, bool>& inputs);
  bool bit(const std::string& name) { return bits_[name]; }
  int number(const std::string& name) { return numbers_[name]; }

 private:
  struct Box {
    bool q = false, running = false, before = false, beforeDown = false, active = false, ended = false;
    int current = 0;
  };
  bool power(const DrawnExpr& e);
  bool box(const DrawnExpr& e);
  bool edge(int memory, int kind, bool now);

  const DrawnProgram& program_;
  std::map<std::string, bool> bits_;
  std::map<std::string, int> numbers_;
  std::map<std::string, Box> boxes_;
  std::vector<bool> memory_;
  int scans_ = 0;
};

}  // namespace rungproof
