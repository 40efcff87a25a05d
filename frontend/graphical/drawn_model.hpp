// What the readers of graphical files hand over: blocks, declarations and networks of elements with pins, still in
// the words of IEC 61131-3 and without memory or instructions. frontend/graphical turns it into a program once all
// files are read, because one export may call blocks of another. Nothing here knows XML. Tested by
// tests/graphical/plcopen_test.cpp.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ir/program.hpp"

namespace rungproof {

/// Types of variables that are read; anything else is a finding.
enum class IecType : std::uint8_t {
  None,
  Bool,
  Sint,
  Usint,
  Byte,
  Int,
  Uint,
  Word,
  Dint,
  Udint,
  Dword,
  Time,
  Real,
  String
};

enum class DrawnKind : std::uint8_t {
  LeftRail,
  RightRail,
  Contact,
  Coil,
  Block,
  InVariable,
  OutVariable,
  InOutVariable,
  Connector,
  Continuation,
  Jump,
  Label,
  Return
};
enum class DrawnEdge : std::uint8_t { None, Rising, Falling };
enum class DrawnStorage : std::uint8_t { None, Set, Reset };

/// A line that ends at an input pin: the element it comes from and that element's output pin (empty: its only one).
struct DrawnLink {
  std::string from;  ///< id of the element
  std::string pin;
  Span span;
};

struct DrawnPin {
  std::string name;
  std::vector<DrawnLink> links;  ///< several lines are joined as a parallel connection
  std::string expression;        ///< an operand written at the pin itself; empty: none
  bool negated = false;
  DrawnEdge edge = DrawnEdge::None;
  Span span;
};

struct DrawnElement {
  DrawnKind kind = DrawnKind::Block;
  std::string id;        ///< localId, UId
  std::string text;      ///< variable, expression, label, or name of a connector; of a block its type
  std::string instance;  ///< of a function block
  bool negated = false;
  DrawnEdge edge = DrawnEdge::None;
  DrawnStorage storage = DrawnStorage::None;
  std::vector<DrawnPin> inputs;
  std::vector<DrawnPin> outputs;  ///< negation only; their links are at the other end, or an expression is written to
  std::string code;               ///< statements in structured text that stand in a box
  Span codeSpan;
  bool readsOnce = false;  ///< an input whose value later readers share
  int order = 0;           ///< order of execution where the editor states it, from 1
  double x = 0, y = 0;
  Span span;
};

/// A comment in the drawing; it belongs to the circuit below it.
struct DrawnNote {
  std::vector<Comment> lines;
  std::string title;  ///< of a network, where the editor knows titles
  double y = 0;
  std::size_t before = 0;  ///< index of the element that follows in the file
};

struct DrawnNetwork {
  std::vector<DrawnNote> notes;
  std::vector<DrawnElement> elements;
  Span span;
  bool isDamaged = false;
};

/// A body in a language that is not read.
struct UncoveredBody {
  std::string language;
  std::string text;
  Span span;
};

enum class DrawnSection : std::uint8_t { Input, Output, InOut, Local, Temp, Global, External, Constant, Return };

struct DrawnVariable {
  std::string name;
  DrawnSection section = DrawnSection::Local;
  IecType type = IecType::None;
  std::string typeName;  ///< as written; of a function block its type
  std::string address;   ///< "%IX0.0", or empty
  std::string initial;   ///< literal, or empty
  bool isConstant = false;
  Span span;
};

enum class DrawnBlockKind : std::uint8_t { Program, FunctionBlock, Function };

struct DrawnBlock {
  DrawnBlockKind kind = DrawnBlockKind::Program;
  std::string name;
  std::string title;
  IecType returnType = IecType::None;
  std::vector<DrawnVariable> variables;
  std::vector<DrawnNetwork> networks;
  std::vector<Comment> comments;
  std::optional<UncoveredBody> uncovered;
  Form form = Form::Ladder;
  Span span;
};

/// A program that a task runs.
struct DrawnInstance {
  std::string name;
  std::string type;
  Span span;
};

struct DrawnProject {
  std::vector<DrawnBlock> blocks;
  std::vector<DrawnVariable> globals;
  std::vector<std::string> globalLists;  ///< names of lists: "GVL" in GVL.Speed
  std::vector<DrawnInstance> instances;
  std::vector<Directive> directives;

  bool isEmpty() const { return blocks.empty() && globals.empty(); }
};

}  // namespace rungproof
