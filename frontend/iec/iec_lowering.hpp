// From the syntax tree to a program of the IEC machine. Every variable of every instance gets a place of its own, every
// instance of a block a routine of its own: nothing is addressed indirectly but elements of arrays. Blocks with IN_OUT
// are written out where they are called, because these stand for variables of the caller.
// Tested by tests/iec.
#pragma once

#include <functional>
#include <set>
#include <unordered_map>

#include "frontend/iec/iec_types.hpp"
#include "ir/check.hpp"
#include "ir/machine/choices.hpp"

namespace rungproof::iec {

struct BlockInstance;

/// What a name stands for.
struct Variable {
  const Type* type = nullptr;
  std::uint32_t offset = 0;
  std::optional<Value> constant;
  BlockInstance* instance = nullptr;     ///< type is Kind::Block
  std::vector<BlockInstance*> elements;  ///< an array of blocks
  const VariableSyntax* declared = nullptr;
};

/// A block with its own variables. Of a function there is one.
struct BlockInstance {
  const BlockSyntax* block = nullptr;
  std::string path;                                 ///< "MAIN.T1"
  std::unordered_map<std::string, Variable> names;  ///< in capitals
  int routine = -1;                                 ///< number of its subroutine; -1: not made
  bool isOpen = false;                              ///< its body is being made
  bool hasInOut = false;
  /// Of a timer: the greatest PT that is given, as far as only constants are; nothing: any.
  std::optional<std::int64_t> longestPreset = 0;
  bool isCalled = false;
  /// Inputs with R_EDGE or F_EDGE: `names` has what the body sees, here stands what the caller gives.
  struct EdgeInput {
    std::uint32_t given, memory;
    bool isRising;
  };
  std::map<std::string, EdgeInput> edges;
  /// The place at which a caller writes a variable, and outsiders read it.
  std::uint32_t placeFromOutside(const std::string& folded) const {
    const auto edge = edges.find(folded);
    return edge != edges.end() ? edge->second.given : names.at(folded).offset;
  }
  /// Whether a member belongs to the model of a block of the standard, and not to the block.
  static bool isHidden(const BlockSyntax& block, const VariableSyntax& member) {
    return block.isLibrary && !block.isContract && member.section == Section::Local && !block.name.starts_with("__");
  }
  /// A member that others may name, or the end.
  auto memberNamed(const std::string& folded) const {
    const auto found = names.find(folded);
    const bool isHere = found != names.end() && found->second.declared != nullptr;
    return isHere && isHidden(*block, *found->second.declared) ? names.end() : found;
  }
  std::optional<std::uint32_t> enabled;  ///< place of ENO, where the project reads it as a part of an instance
  std::map<std::string, int> actions;    ///< numbers of their subroutines
};

/// A place: a variable, or elements of it by computed indices.
struct Reference {
  const Type* type = nullptr;
  std::uint32_t offset = 0;
  struct Index {
    const Expr* index;
    std::int64_t low;
    std::uint32_t count, stride;
  };
  std::vector<Index> indices;        ///< computed ones
  std::optional<std::uint32_t> bit;  ///< the lowest of a part of the value
  const Type* partType = nullptr;    ///< of that part
  std::optional<Value> constant;
  BlockInstance* instance = nullptr;
  const VariableSyntax* declared = nullptr;
  BlockInstance* owner = nullptr;  ///< the instance whose variable it is

  const Type& valueType() const { return bit ? *partType : *type; }
};

class Lowering {
 public:
  Lowering(Program& program, const ProjectSyntax& project, std::uint32_t file);
  void run();

 private:
  /// Thrown where a statement cannot be lowered; its network is left out.
  struct Refused {};
  struct ListState;
  /// A block that is being written.
  struct Scope {
    BlockInstance* self = nullptr;
    std::map<std::string, Reference> inOuts;
    std::vector<std::pair<int, int>> loops;  ///< labels of EXIT and CONTINUE
    std::map<std::string, int> labels;       ///< of a drawing
    int returnLabel = -1;                    ///< of a body that is written out; -1: RET
    int faultLabel = -1;                     ///< where a fault in what is tried goes on; -1: it ends the scan
    Scope* caller = nullptr;
    std::shared_ptr<ListState> list;  ///< of a body in IL
    const ActionSyntax* action = nullptr;
  };

  // iec_lowering.cpp
  void declareGlobals();
  bool containsItself(const BlockSyntax& block) const;
  BlockInstance* makeInstance(const BlockSyntax& block, std::string path);
  BlockInstance* functionNamed(const std::string& name);
  Variable makeVariable(const VariableSyntax& syntax, const std::string& path);
  std::uint32_t allocate(std::uint32_t bytes);
  void initialize(const Type& type, std::uint32_t offset, const Initial* initial);
  void expectInitial(const Value& value, const Type& type, Span span);
  void writeInitial(const Type& type, std::uint32_t offset, const Value& value);
  void nameVariables();
  void nameOperands();
  void nameVariable(const std::string& name, const Variable& variable, const std::string& alias);
  void nameValue(const std::string& name, const Type& type, std::uint32_t offset, const std::string& alias);
  void nameText(const std::string& name, const Type& type, std::uint32_t offset, const std::string& alias);
  void makeRoutine(BlockInstance& instance);
  void makeAction(BlockInstance& instance, const ActionSyntax& action);
  void writeRoutine(Pou pou, Scope& scope, const Statements& body);
  // iec_addresses.cpp
  std::optional<std::uint32_t> located(const VariableSyntax& syntax, const Type& type);
  void findSharedAddresses();
  std::int64_t extentOf(const VariableSyntax& variable);
  /// A place whose address meets another one on some controllers.
  struct SharedPlace {
    char area;
    std::uint32_t offset;
    const Type* type;
    std::int64_t inUnits, inBytes;  ///< its first bit
    int bits;
  };
  bool isApartAt(std::uint32_t offset) const;
  void writeThrough(std::uint32_t offset);
  void mergeBytes(const SharedPlace& from, const SharedPlace& to, std::int64_t fromBit, std::int64_t toBit,
                  std::string_view unit);
  void joinInputs();
  // iec_presets.cpp
  void findChangingPresets();
  bool mayChangePreset(const BlockInstance& timer) const;
  // iec_circuits.cpp
  using NetworkWriter = std::function<void(Span, const std::function<void()>&)>;  ///< of a place, with what to write
  std::size_t writeCircuit(Pou& pou, Scope& scope, const Statements& body, std::size_t first,
                           const NetworkWriter& write);
  void showValue(const Expr& expr);
  void place(const CircuitPicture& picture);
  std::optional<Operands> writtenBy(Scope& scope, const Statement& one);
  std::optional<Operands> placesOf(Scope& scope, const Expr& target);
  static bool calls(const Expr& expr);
  // iec_intermediate.cpp
  bool mayNeedMoreBits(Scope& scope, const Expr& expr);
  void valueInBothWidths(Scope& scope, const Expr& expr);
  bool operateInBothWidths(Scope& scope, const Expr& expr, const Type& type, bool isCompare);
  bool widenInBothWidths(Scope& scope, const Expr& expr, const Type& wanted);
  void freshLocals(Scope& scope);
  void findEdges(const BlockInstance& instance);
  void chooseMachine();
  void error(Syntax code, Span span, std::string message);
  [[noreturn]] void refuse(Span span, std::string message, Syntax code = Syntax::IecType);

  // iec_programs.cpp
  void makePrograms();
  const TaskSyntax* taskOf(const InstanceSyntax& instance) const;
  void checkTasks(const std::vector<const InstanceSyntax*>& instances);
  void freeVariable(const Type& type, std::uint32_t offset, Span span, bool isLocated = false);
  bool isFreed(std::uint32_t offset) const;
  void freeNamedVariables();
  void assumeType(const Symbol& symbol, Span span);
  void freeUnwrittenGlobals();
  void freeAccessed();
  void makeMain();
  void callProgram(std::size_t number);
  void callTasks(const std::vector<std::size_t>& order);
  std::vector<bool> interruptible() const;
  void startPhases();
  void startSubranges();

  // iec_emission.cpp
  void emit(std::string_view mnemonic, std::initializer_list<std::int64_t> numbers = {});
  void emitPlace(std::string_view mnemonic, const Type& type, std::uint32_t offset);
  void load(const Type& type, std::uint32_t offset);
  void store(const Type& type, std::uint32_t offset);
  void noteWritten(std::uint32_t byte);
  void constant(std::int64_t value, int width);
  int newLabel() { return nextLabel_++; }
  void label(int number) { emit("LBL", {number}); }
  void jump(int number) { emit("JMP", {number}); }
  void jumpIfFalse(int number) { emit("JMPCN", {number}); }
  void readReference(Scope& scope, const Reference& reference);
  /// The value lies on the stack; `prepare` has pushed the index before it.
  void prepareWrite(Scope& scope, const Reference& reference);
  void writeReference(Scope& scope, const Reference& reference);
  void pushIndex(Scope& scope, const Reference& reference);
  void element(std::string_view mnemonic, const Reference& reference);
  void copy(Scope& scope, const Reference& from, const Reference& to);
  void copyParts(Scope& scope, const Reference& from, const Reference& to);
  Reference withHeldIndices(Scope& scope, Reference at, std::vector<ExprPtr>& held);
  Instruction& last() { return network_->instructions.back(); }

  // iec_statements.cpp
  void statements(Scope& scope, const Statements& list);
  void statement(Scope& scope, const Statement& statement);
  void assign(Scope& scope, const Statement& statement);
  void declareResult(Scope& scope, const Expr& path, const std::function<const Type*()>& type);
  void assignWhole(Scope& scope, const Reference& target, const Expr& value);
  void jumpStatement(Scope& scope, const Statement& statement);
  int labelNamed(Scope& scope, const Expr& name);
  void branches(Scope& scope, const Statement& statement);
  void caseOf(Scope& scope, const Statement& statement);
  void caseLabel(const CaseLabel& label, const Type& type, std::uint32_t selector);
  void forLoop(Scope& scope, const Statement& statement);
  std::optional<std::uint32_t> keptBound(Scope& scope, const Statement& loop, const Expr* bound, const Type& type);
  void latchPreset(BlockInstance& timer, const Type& type);
  void callStatement(Scope& scope, const Expr& call);
  void callAction(Scope& scope, const ActionSyntax& action, Span span);
  void callInstance(Scope& scope, BlockInstance& instance, const Expr& call);
  void bindInputs(Scope& scope, BlockInstance& instance, const Expr& call, Scope& inner);
  void readOutputs(Scope& scope, BlockInstance& instance, const Expr& call);

  // iec_in_out.cpp
  bool mayMeet(const Scope& inner) const;
  void runWithInOuts(Scope& scope, BlockInstance& instance, Scope& inner, Span span);
  void runBody(Scope& scope, BlockInstance& instance, Scope& inner, Span span);

  // iec_enable.cpp
  void tellEnabled(Scope& scope, const std::string& name, const Expr& expr);
  void writeEnabled(Scope& scope, const Argument& argument, const std::function<void()>& push);
  const Argument* enableOf(const Expr& expr);
  void assignWholeWhereEnabled(Scope& scope, const Reference& target, const Expr& value);
  void assignWhereEnabled(Scope& scope, const Reference& target, const Expr& call, const Argument& enable);

  // iec_faults.cpp
  void tryStatement(Scope& scope, const Statement& statement);
  void guardFaults(Scope& scope, const Statement& statement);
  void guardDivisions(Scope& scope, const Expr& expr);
  void guardCall(Scope& scope, const Expr& call);

  // iec_list.cpp
  void beginList(Scope& scope, const Statements& body);
  void endList(Scope& scope);
  void listLabel(Scope& scope, const ListLine& line);
  void listLine(Scope& scope, const Statement& statement);
  void listOperation(Scope& scope, const Statement& statement);
  void listJump(Scope& scope, const Statement& statement);
  void listCall(Scope& scope, const Statement& statement);
  void listFunction(Scope& scope, const Statement& statement);
  void loadResult(Scope& scope, const Expr& value);
  void combineResult(Scope& scope, const std::string& op, ExprPtr left, ExprPtr right, Span span);
  static void loseResult(Scope& scope);
  ExprPtr currentResult(Scope& scope, Span span);
  ExprPtr heldValue(Scope& scope, const Expr& value, int depth);
  const Expr* heldChoice(Scope& scope, const Expr& expr);
  void jumpUnlessResult(Scope& scope, bool isNegated, Span span, int label);
  void carryResult(Scope& scope, const std::string& label, Span span);
  std::optional<Operands> writtenByLine(Scope& scope, const Statement& one);
  bool isInstanceNamed(Scope& scope, const Expr& expr);

  // iec_contracts.cpp
  void callContract(Scope& scope, BlockInstance& instance, const Expr& call);
  BlockInstance* contractOfMethod(Scope& scope, const Expr& call);
  void refuseMethod(Scope& scope, const Expr& call);
  const Variable& resultOfMethod(BlockInstance& instance, const Expr& call);

  // iec_conversions.cpp
  const Type* conversion(Scope& scope, const std::string& name, const Expr& expr);
  void convert(const Type& from, const Type& to, bool cuts, Span span);
  void toBool(const Type& from);
  void fromDuration(const Type& from, const Type& to, Span span);
  void toDuration(const Type& from, const Type& to, Span span);
  void fromBcd();
  void toBcd();

  // iec_texts.cpp
  /// Where a text lies; `bytes` with that of its length.
  struct TextAt {
    std::uint32_t offset = 0, bytes = 0;
  };
  TextAt text(Scope& scope, const Expr& expr);
  TextAt textFunction(Scope& scope, const std::string& name, const Expr& expr);
  TextAt freshText(std::uint32_t bytes);
  void writeTextInitial(std::uint32_t offset, std::uint32_t bytes, const Expr& literal);
  void copyText(Scope& scope, const TextAt& from, const Reference& to, Span span);
  void compareTexts(Scope& scope, const std::string& op, const Expr& left, const Expr& right);
  void emitTexts(std::string_view mnemonic, std::initializer_list<TextAt> texts);

  // iec_calendar.cpp
  static const Type* calendarResult(std::string_view op, const Type* left, const Type* right);
  const Type* calendarSum(Scope& scope, const std::string& op, const Expr& left, const Expr& right, Span span);
  void convertDate(const Type& from, const Type& to, Span span);
  const Type* scaledDuration(Scope& scope, const std::string& op, const Expr& left, const Expr& right, Span span);
  const Type* realTypeOf(Scope& scope, const Expr& expr);
  const Type* power(Scope& scope, const Expr& base, const Expr& exponent);

  // iec_expressions.cpp
  Reference reference(Scope& scope, const Expr& path, bool mayBeMissing = false);
  const Variable* find(Scope& scope, const std::string& folded, BlockInstance*& owner);
  void step(Reference& at, const PathPart& part, const Expr& path);
  void indexStep(Reference& at, const PathPart& part);
  /// The type without a wish; nullptr: a number literal, which takes any type.
  const Type* typeOf(Scope& scope, const Expr& expr);
  const Type* operandType(Scope& scope, const Expr& operand, const Type* wanted);
  static const Type* durationOf(const Type* left, const Type* right);
  const Type* common(const Type* left, const Type* right, const Type* wanted, Span span);
  /// Pushes the value as a `wanted`; nullptr: as its own type. Gives the type of what was pushed.
  const Type* value(Scope& scope, const Expr& expr, const Type* wanted);
  void valueAs(Scope& scope, const Expr& expr, const Type& wanted);
  void pushValue(const Value& value, const Type& wanted, Span span);
  void pushPattern(const Value& value, const Type& wanted, Span span);
  void expectFits(const Value& value, const Type& wanted, Span span);
  bool tellPattern(const Value& value, const Type& type, Span span);
  void checkRange(Scope& scope, const Type& type, Span span);
  void convertImplicitly(const Type& from, const Type& to, Span span);
  const Type* unary(Scope& scope, const Expr& expr, const Type* wanted);
  const Type* binary(Scope& scope, const Expr& expr, const Type* wanted);
  void operate(const std::string& op, const Type& type, Span span);
  void logicWithFaults(Scope& scope, const Expr& expr);
  bool mayFault(const Expr& expr) const;

  // iec_functions.cpp
  const Type* call(Scope& scope, const Expr& expr, const Type* wanted);
  const Type* resultOf(Scope& scope, const Expr& expr);
  const Type* standardResult(Scope& scope, const std::string& name, const Expr& expr);
  void limit(Scope& scope, const std::vector<const Expr*>& values, const Type& type,
             const std::function<void(std::string_view)>& extreme);
  const Type* multiplexer(Scope& scope, const std::vector<const Expr*>& values, const Type* wanted, Span span);
  const Type* standardCall(Scope& scope, const std::string& name, const Expr& expr, const Type* wanted);
  bool isStandard(const std::string& name) const;
  const Type* ownFunction(Scope& scope, BlockInstance& function, const Expr& expr);
  const Variable& runFunction(Scope& scope, BlockInstance& function, const Expr& expr);
  const Type* ownTypeOf(Scope& scope, const std::vector<const Expr*>& values, Span span);
  const Type* commonOf(Scope& scope, const std::vector<const Expr*>& values, const Type* wanted, Span span);
  std::vector<const Expr*> plainArguments(const Expr& expr, std::initializer_list<std::string_view> names) const;

  Program& program_;
  const ProjectSyntax& project_;
  SyntaxSink sink_;
  TypeTable types_;
  std::deque<BlockInstance> instances_;
  std::map<std::string, const BlockSyntax*> blocks_;
  std::map<std::string, BlockInstance*> functions_;
  std::map<std::string, Variable> globals_;
  struct TaskEvent {
    const TaskSyntax* task = nullptr;
    std::uint32_t memory = 0, due = 0;  ///< places
  };
  std::deque<TaskEvent> events_;
  TaskEvent* eventOf(const TaskSyntax& task);
  void askEvents();
  /// A program with what the configuration says of it.
  struct ProgramRun {
    const InstanceSyntax* instance = nullptr;
    std::int64_t priority = 0;  ///< 0: highest
    const TaskEvent* event = nullptr;
    bool isCyclic = false;
    std::uint32_t every = 1;       ///< scans from one run to the next
    std::uint32_t counter = 0;     ///< place of the scans since, where `every` is more than 1
    std::uint32_t phase = 0;       ///< likewise: the place whose value in the first scan says in which it runs first
    bool isInterruptible = false;  ///< what it shares with a task of other priority might change while it runs
  };
  std::vector<ProgramRun> runs_;  ///< parallel to programs_
  std::vector<BlockInstance*> programs_;
  std::vector<BlockInstance*> timers_;
  std::vector<std::pair<const Type*, std::uint32_t>> openStarts_;  ///< subranges with 0 inside that start by a reading
  std::vector<std::pair<BlockInstance*, std::int64_t>> steps_;     ///< of charts, with VariableSyntax::longestClock
  std::set<const ActionSyntax*> openActions_;
  std::map<std::string, std::uint32_t> places_;  ///< by address in capitals
  std::vector<SharedPlace> shared_;
  std::set<std::string> apart_;  ///< in capitals: addresses that meet an array at another address
  std::vector<std::pair<std::uint32_t, std::uint32_t>> unmodelledPlaces_;  ///< theirs: first byte, end
  std::set<std::string> changingPresets_;  ///< timers by the last part of their names, in capitals
  bool anyPresetMayChange_ = false;
  std::map<std::string, TextAt> literalTexts_;  ///< as written
  std::vector<std::pair<std::string, std::uint32_t>> addressNames_;
  struct Freed {
    std::uint32_t offset, bytes;
    Span span;
    bool isLocated;  ///< at an address of inputs
  };
  std::vector<Freed> freed_;  ///< located inputs, inputs of programs, globals that nobody writes
  std::vector<std::uint8_t> initial_;
  std::uint32_t next_ = 0;
  int nextRoutine_ = 0;
  int nextLabel_ = 0;
  int depth_ = 0;
  int openRoutines_ = 0;                     ///< that are being made, one below the other
  std::set<const BlockSyntax*> madeBlocks_;  ///< an instance of them was called or made
  bool isFull_ = false;                      ///< the variables have too many bytes, which was said
  bool isTooNested_ = false;           ///< instances stand in each other too deeply or are too many, which was said
  const Expr* enabledCall_ = nullptr;  ///< a call whose EN was asked already
  bool asksEnabled_ = false;           ///< some path ends in .ENO
  Network* network_ = nullptr;
  Span span_;                            ///< of the statement at hand
  std::vector<std::uint8_t> isWritten_;  ///< by byte
  /// Values of a drawn circuit that is being written: where in the source they are named, and who leaves them.
  struct Shown {
    std::uint32_t offset;
    std::string member;  ///< the last name of a path of several, in capitals
    bool isStored;
    std::uint32_t instruction;
  };
  std::vector<Shown> shown_;
  bool isDrawn_ = false;
};

/// Variables of a drawing whose type is that of what is written to them first.
inline constexpr std::string_view resultPrefix = "__result_";
/// What another maker calls an input of a block of the library, in capitals: RESET of a CTU is its R. The same name: he
/// has none of his own.
std::string libraryInput(const std::string& block, const std::string& folded);
/// The type that a conversion of that name gives (INT_TO_REAL), in capitals; nullptr: it is none.
const Type* conversionTarget(const std::string& name);
bool isText(const Type* type);
/// Whether the standard has a function of that name, in capitals.
bool isStandardFunction(const std::string& folded);
/// Whether it has no result for some values: SQRT, MUX, conversions of REAL.
bool isPartialFunction(const std::string& folded);
/// Whether it is one whose result is a truth value: EQ, LT ...
bool isComparisonFunction(const std::string& folded);
/// Makes the program of everything that the files hold; the tree becomes Program::syntax.
void buildIecProgram(Program& program, ProjectSyntax& project);
/// Appends blocks for the instances whose block no file has (BlockSyntax::isContract).
void addContracts(Program& program, ProjectSyntax& project);
/// The blocks of the library that a program may declare, in capitals.
std::vector<std::string> libraryBlockNames();
/// Appends the blocks of the standard that the project does not have itself.
void addStandardBlocks(Program& program, ProjectSyntax& project);

}  // namespace rungproof::iec
