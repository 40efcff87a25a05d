// From drawn blocks to a program, once all files are read. A block of the project that is executed becomes a block of
// the program: the one program that a task runs becomes MAIN; if there are several, MAIN calls them one after the
// other. Every instance of a function block is a subroutine of its own with its variables in V memory, so that timers,
// counters and edges of two instances never meet; a function is one subroutine. Parameters are passed by memory.
// Tested by tests/graphical/plcopen_test.cpp.
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "frontend/graphical/drawn_memory.hpp"
#include "frontend/graphical/drawn_model.hpp"
#include "frontend/graphical/drawn_scope.hpp"
#include "frontend/graphical/drawn_sink.hpp"
#include "ir/drawing.hpp"

namespace rungproof {

/// Appends blocks, symbols, data and findings to the program. Does nothing for an empty project.
void buildDrawnProject(Program& program, DrawnProject& project);

/// What the lowering of one block asks the project for.
class DrawnBuild {
 public:
  DrawnBuild(Program& program, DrawnProject& project);
  void run();

  Program& program() { return program_; }
  DrawnSink& sink() { return sink_; }
  DrawnMemory& memory() { return memory_; }

  /// A variable by its name in the block, else a global one; nullptr if there is none.
  VariablePlace* lookUp(DrawnCopy& copy, std::string_view name);
  /// A block of the project, or nullptr.
  const DrawnBlock* blockNamed(std::string_view name) const;
  /// The only copy of a function, built when it is first called; nullptr while it is being built (recursion).
  DrawnCopy* functionCopy(const DrawnBlock& block);
  /// A place of V memory for a value on its way; reports once if V memory is full.
  std::optional<Operand> temporary(IecType type);
  /// Whether some drawing names an output of an instance, "T1.ET", directly or through a path.
  bool isMentioned(std::string_view instance, std::string_view output) const;
  /// A jump label of the block that is being built.
  int newLabel() { return nextLabel_++; }

 private:
  void addGlobals();
  void buildPrograms();
  void freeVariable(const DrawnVariable& variable, const VariablePlace& place);
  void freeInputs(const DrawnCopy& program);
  void freeGlobals();
  DrawnCopy* newCopy(const DrawnBlock& block, const std::string& path);
  void declare(DrawnCopy& copy, const DrawnVariable& variable, const std::string& path);
  void declareInstance(VariablePlace& place, const DrawnVariable& variable, const std::string& path);
  void buildBody(DrawnCopy& copy, Pou& pou);
  void addInitialValue(const VariablePlace& place, const DrawnVariable& variable);
  void restoreLocals(DrawnCopy& copy, Pou& pou);
  void addUncovered(DrawnCopy& copy, Pou& pou);
  void addMainOf(const std::vector<DrawnCopy*>& programs, Span span);
  void addPou(DrawnCopy& copy, PouKind kind);
  void addSymbol(const std::string& name, const Operand& place, Span span);
  void noteMentions();
  void reserveLocated(const std::vector<DrawnVariable>& variables);

  Program& program_;
  DrawnProject& project_;
  DrawnSink sink_;
  DrawnMemory memory_;
  std::size_t tableSymbols_;  ///< symbols of tables beside the drawing; those behind are the drawing's own
  std::map<std::string, VariablePlace> globals_;
  std::map<std::string, const DrawnBlock*> blocks_;
  std::map<std::string, DrawnCopy*> functions_;
  std::vector<std::unique_ptr<DrawnCopy>> copies_;
  std::vector<std::string> open_;    ///< blocks being built, against recursion
  std::set<std::string> mentioned_;  ///< operands with a point, in capitals: their last two parts
  Drawing firstScan_;                ///< initial values of located variables
  int nextLabel_ = 0;
  bool isFullReported_ = false;
};

}  // namespace rungproof
