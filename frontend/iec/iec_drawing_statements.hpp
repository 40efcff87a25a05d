// One drawn network on its way to statements. Values, results and coils: iec_drawing.cpp; blocks: iec_drawn_boxes.cpp.
// The box of a function is a call of its own where its result has other readers than one, where it may do more than
// give a result, or where its order is stated: it is called once in a scan, and what it gives stands in variables whose
// types the lowering finds. Any other is an expression of its one reader. Tested by tests/iec/drawn_box_test.cpp.
#pragma once

#include <functional>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "frontend/graphical/drawn_circuit.hpp"
#include "frontend/iec/iec_drawn_names.hpp"
#include "frontend/iec/iec_tree.hpp"
#include "frontend/stl/syntax_sink.hpp"
#include "ir/iec/syntax.hpp"

namespace rungproof::iec {

class DrawingToStatements {
 public:
  DrawingToStatements(Program& program, const DrawnNetwork& network, Form form, BlockSyntax& block, SyntaxSink& sink);

  void run();

 private:
  struct Unwritable {};
  /// What a box made of its function.
  struct Box {
    bool isCalled = false, isLost = false;
    std::string enable;                          ///< variable of what arrives at EN; empty: always TRUE
    std::string enabled;                         ///< of ENO, where it is not EN
    std::string result;                          ///< of the result; empty: it is not read
    std::map<std::string, std::string> outputs;  ///< of other outputs, by their names in capitals
  };
  enum class Output : std::uint8_t {
    Enabled,  ///< ENO
    Passed,   ///< the right pin of an IN_OUT
    Result,
    Other
  };

  // iec_drawing.cpp
  void writeBothOrders(const std::vector<int>& stated, const std::vector<int>& byPosition);
  void dropUnused();
  void joined(std::size_t first, const std::vector<int>& results);
  void placeNotes();
  DrawnSink& placed(const BlockSyntax& block);
  using InCircuit = std::pair<int, std::string>;
  InCircuit inCircuit(int i) const { return {circuit_.circuitOf(i), foldedName(circuit_.element(i).text)}; }
  void keepForContacts(int i);
  ExprPtr seenBy(int i);
  void attempt(int i);
  [[noreturn]] void refuse(const DrawnElement& element, std::string message);
  Statement statementAt(int i, StatementKind kind) const;
  ExprPtr parsed(const std::string& text, Span span);
  std::string hidden(std::string_view what, std::string_view type, Span span);
  void assign(int i, ExprPtr target, ExprPtr value);
  void whereTrue(int i, ExprPtr condition, ExprPtr target, ExprPtr value);
  ExprPtr edgeOf(int i, ExprPtr value, DrawnEdge edge);
  ExprPtr edgeOfContact(int i);
  ExprPtr arriving(int i, const DrawnPin& pin);
  ExprPtr flowInto(int i);
  ExprPtr leaving(int i, const std::string& pin);
  ExprPtr leavingOf(int i, const std::string& pin);
  ExprPtr shared(int i, const std::function<ExprPtr()>& make);
  void write(int i);
  void writeCoil(int i);
  void writeVariable(int i);

  // iec_drawn_boxes.cpp
  static const DrawnPin* outputOf(const DrawnElement& element, const std::string& pin);
  static const DrawnPin* inputNamed(const DrawnElement& element, const std::string& folded);
  static std::string nameOfOutput(const DrawnElement& element, const std::string& pin);
  static Output outputKind(const DrawnElement& element, const std::string& folded);
  bool isFunction(int i) const;
  ExprPtr memberOf(int i, const std::string& pin);
  ExprPtr resultOf(int i, const std::string& pin);
  ExprPtr passedOn(int i, const std::string& folded);
  ExprPtr enableOf(int source, const std::string& pin);
  int readersOf(int i, Output kind) const;
  bool isCallOfItsOwn(int i) const;
  bool isEarly(int i) const;
  std::vector<int> withoutUnneeded(const std::vector<int>& results) const;
  Box& called(int i);
  void callBox(int i, Box& box);
  void takeOutputs(int i, Box& box, Expr& call);
  ExprPtr wantedAs(int i);
  ExprPtr callAt(int i, bool withEnable);
  void writeBlock(int i);
  void declare(const DrawnElement& element);

  static ExprPtr inverted(ExprPtr inner);
  static bool isTrue(const Expr& expr) { return expr.kind == ExprKind::Literal && foldedName(expr.text) == "TRUE"; }

  Form form_;
  BlockSyntax& block_;
  SyntaxSink& sink_;
  DrawnSink drawnSink_;
  DrawnCircuit circuit_;
  std::vector<bool> isDone_;
  std::vector<std::string> flows_;
  std::set<InCircuit> contacts_;             ///< variables that contacts read
  std::map<InCircuit, std::string> before_;  ///< by variable that a coil has written: its value of before
  WrittenNames written_;                     ///< by results so far
  std::map<int, ExprPtr> edges_;             ///< by contact: its edge, once it was asked
  std::map<int, Box> boxes_;                 ///< of functions that are calls of their own
  std::set<int> early_;                      ///< of these: called where the editor says, before anybody asks
  std::vector<int> circuits_;                ///< with statements
  std::set<int> isJoined_;                   ///< the same
  std::vector<std::size_t> firsts_;          ///< parallel: the first statement of each
  std::set<std::string> isTaken_;            ///< of before_
  /// Elements behind each other, and all, of the statement that is being made.
  struct Load {
    int depth = std::numeric_limits<int>::max(), taken = std::numeric_limits<int>::max();
  };
  std::vector<Load> refused_;  ///< by element: with that and more no value leaves it
  int depth_ = 0, taken_ = 0;
};

}  // namespace rungproof::iec
