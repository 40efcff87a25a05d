// The syntax tree of IEC 61131-3 texts: types, blocks with their declarations, statements, expressions, configurations.
// The readers of text and of PLCopen XML make it; the lowering gives it a meaning, and rules about what the text says
// read it. Names keep their spelling and are compared without regard to case (foldedName).
// Tested by tests/iec.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ir/drawing.hpp"
#include "ir/program.hpp"

namespace rungproof::iec {

/// In capitals, as names are compared.
std::string foldedName(std::string_view name);

enum class ExprKind : std::uint8_t {
  Literal,  ///< text: as written; prefix: type in front of #
  Text,     ///< string literal
  Path,     ///< variable, enumerator: parts
  Unary,    ///< text: "-" or "NOT"
  Binary,   ///< text: operator in capitals
  Call      ///< parts name the function; arguments
};

struct Expr;
using ExprPtr = std::unique_ptr<Expr>;

/// One step of a path: `.name`, `[indices]`, `.3` (a bit) or `.%B1` (a byte).
struct PathPart {
  enum class Kind : std::uint8_t { Name, Index, Bit } kind = Kind::Name;
  std::string name;
  std::vector<ExprPtr> indices;
  std::uint32_t bit = 0;   ///< the lowest
  std::uint32_t bits = 1;  ///< 8, 16, 32: `.%B1`, `.%W0`, `.%D1`
  Span span;
  bool isSlice = false;  ///< a bit with %: `.%X3`, not `.3`
};

struct Argument {
  std::string name;  ///< formal: of the parameter
  bool isOutput = false;
  bool isNegated = false;  ///< NOT q => x
  ExprPtr value;
  Span span;
};

struct Expr {
  ExprKind kind = ExprKind::Literal;
  Span span;
  std::string text;
  std::string prefix;
  std::vector<PathPart> parts;
  std::vector<ExprPtr> operands;
  std::vector<Argument> arguments;
};

enum class StatementKind : std::uint8_t {
  Assign,
  Call,
  If,
  Case,
  For,
  While,
  Repeat,
  Exit,
  Continue,
  Return,
  Try,
  Jump,   ///< of a drawing: to the label `target`, where `value` is TRUE
  Label,  ///< `target`
  Line,   ///< of IL
  Unread  ///< writes `target` if there is one, otherwise anything
};

struct CircuitPicture;
struct Statement;
using Statements = std::vector<Statement>;

/// A condition with its statements; of CASE: the values, `high` the end of a range.
struct CaseLabel {
  ExprPtr low, high;
};
struct Branch {
  ExprPtr condition;
  std::vector<CaseLabel> labels;
  Statements body;
};

/// A line of IL: `label: operator operand, operand`.
struct ListLine {
  std::string label;  ///< in front of the operator; a line may have nothing else
  std::string op;     ///< in capitals without modifiers; ")" closes; empty: none
  bool isNegated = false, isConditional = false;
  bool opens = false;     ///< `op(`
  bool hasNames = false;  ///< a function with `NAME := value`, which does not take the current result
  Span opSpan;
  /// Of CAL: one call. Of a jump: the label as a path. Otherwise the values behind the operator.
  std::vector<Argument> operands;
};

/// Try: `otherwise` is what is tried, the first branch what runs after a fault in it, the second one what runs in any
/// case behind it.
struct Statement {
  StatementKind kind = StatementKind::Assign;
  Span span;
  ExprPtr target;    ///< Assign: variable; Call: the call; For: counter
  ExprPtr value;     ///< Assign: value; Case: selector; For: first; While, Repeat: condition
  ExprPtr last, by;  ///< For
  std::vector<Branch> branches;
  Statements otherwise;
  bool hasElse = false;
  std::unique_ptr<ListLine> line;  ///< Line
  std::string picture;             ///< of a chart: the text that shows it
  int circuit = 0;                 ///< of a drawing: statements of one circuit have one number and are one network
  std::shared_ptr<const CircuitPicture> drawn;  ///< of the first statement of a circuit
};

/// Where the lowering finds a value that a picture shows: what was read or written at a place of the source.
struct ShownValue {
  enum class Part : std::uint8_t { Whole, Left, Right } part = Part::Whole;  ///< of the element
  enum class At : std::uint8_t { FirstRead, LastRead, Member, Stored } at = At::FirstRead;
  std::uint32_t element = 0;
  std::uint32_t pin = 0;     ///< Left, Right: of BoxFace
  std::uint32_t offset = 0;  ///< in the source
  std::string member;        ///< Member: in capitals; of a function: empty
};

/// How a circuit was drawn, with what stands above it.
struct CircuitPicture {
  Drawing drawing;
  std::vector<ShownValue> values;
  Form form = Form::Ladder;
  Span span;
  std::string title;
  std::vector<Comment> comments;
};

enum class TypeForm : std::uint8_t { Named, Array, Struct, Enum };

struct TypeSyntax;
using TypePtr = std::shared_ptr<TypeSyntax>;

struct Initial {
  ExprPtr value;                                       ///< one value
  std::vector<std::pair<std::uint32_t, Initial>> row;  ///< [1, 2, 3(0)]: how often, and what
  std::vector<std::pair<std::string, Initial>> fields;
  bool isRow = false, isStructure = false;
  Span span;
};

struct VariableSyntax;

struct TypeSyntax {
  TypeForm form = TypeForm::Named;
  Span span;
  std::string name;                                    ///< Named
  ExprPtr low, high;                                   ///< Named: a subrange
  std::vector<std::pair<ExprPtr, ExprPtr>> bounds;     ///< Array
  TypePtr element;                                     ///< Array
  std::vector<VariableSyntax> fields;                  ///< Struct
  std::vector<std::pair<std::string, ExprPtr>> items;  ///< Enum
};

enum class Section : std::uint8_t { Input, Output, InOut, Local, Temp, External, Global };
enum class EdgeOf : std::uint8_t { None, Rising, Falling };

struct VariableSyntax {
  std::string name;
  Section section = Section::Local;
  TypePtr type;
  std::string address;  ///< "%IX0.0", or empty
  std::shared_ptr<Initial> initial;
  bool isConstant = false, isRetain = false;
  EdgeOf edge = EdgeOf::None;
  Span span;
  /// Of a step: ms at which its CLOCK stands still, because nothing tells more; 0: nothing reads it.
  std::int64_t longestClock = 0;
};

enum class BlockKind : std::uint8_t { Program, FunctionBlock, Function };

/// A body that a block calls by its name, with the variables of the block.
struct ActionSyntax {
  std::string name;
  Statements body;
  Span span;
  bool isChart = false;      ///< made of a chart: it alone moves the tokens
  bool isCondition = false;  ///< computes the condition of a transition
  bool mayCall = false;      ///< of a condition: function blocks that it calls are called by the reading in force
};

struct BlockSyntax {
  BlockKind kind = BlockKind::Program;
  std::string name;
  TypePtr result;  ///< Function
  std::vector<VariableSyntax> variables;
  Statements body;
  std::vector<ActionSyntax> actions;
  Span span;
  bool isWhole = true;      ///< everything was read
  bool isLibrary = false;   ///< of the standard
  bool isContract = false;  ///< in no file: its variables are those that the project gives it and takes of it
  std::string unread;       ///< language of a body that is not read
};

struct NamedType {
  std::string name;
  TypePtr type;
  std::shared_ptr<Initial> initial;
  Span span;
};

struct TaskSyntax {
  std::string name;
  std::optional<std::int64_t> intervalMs;
  ExprPtr single;  ///< a rising edge of it starts the task; nullptr: none
  std::int64_t priority = 0;
  Span span;
};
struct InstanceSyntax {
  std::string name, task, type;
  ExprPtr connections;  ///< as of a call: inputs and outputs; nullptr: none
  Span span;
};

/// A path from outside to a variable: VAR_ACCESS with READ_WRITE.
struct AccessSyntax {
  ExprPtr path;
  Span span;
};
/// All files of a project.
struct ProjectSyntax {
  std::vector<NamedType> types;
  std::vector<BlockSyntax> blocks;
  std::vector<VariableSyntax> globals;
  std::vector<TaskSyntax> tasks;
  std::vector<InstanceSyntax> instances;
  std::vector<AccessSyntax> accesses;
  std::vector<Directive> directives;
  bool isDamaged = false;  ///< something outside of blocks could not be read

  bool isEmpty() const { return blocks.empty() && globals.empty() && types.empty(); }
};

}  // namespace rungproof::iec
