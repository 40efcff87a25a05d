// Bodies in SCL as statements of the S7-300/400: what they mean stands once, in these statements, and everything that
// reads them works unchanged. Each statement of the body is a network; what is computed in between lies in temporary
// data behind the declared ones. Every lowered statement keeps the place of what it was made of.
// Where no manual at hand tells what SCL does, it is not covered by name, or one meaning is taken, which
// frontend/guide/64_s7300.md names. Tested by tests/scl/micro_test.cpp, call_test.cpp, random_test.cpp.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "frontend/step7/operand_binder.hpp"
#include "frontend/step7/scl_body.hpp"

namespace rungproof::step7 {

/// BYTE, WORD, DWORD.
inline bool isSclBits(s7300::TypeKind kind) {
  return kind == s7300::TypeKind::Byte || kind == s7300::TypeKind::Word || kind == s7300::TypeKind::DWord;
}

/// A value on its way: a place or a constant that needs no statement, or what stands in ACCU1, of BOOL the RLO.
struct SclValue {
  s7300::TypeKind kind = s7300::TypeKind::Unknown;
  bool isPlain = false;    ///< `operand` says where it is; false: the accumulator, or the RLO
  bool isNegated = false;  ///< plain BOOL: what is read is turned round
  bool isUntyped = false;  ///< an address: of any type of its width
  bool isLiteral = false;  ///< a number without a type
  Operand operand;
  Span span;
};

class SclLowering {
 public:
  SclLowering(const BlockCatalogue& catalogue, TypeTable& types, Reports& reports, BlockScope& scope)
      : catalogue_(catalogue), types_(types), operands_(catalogue, types), reports_(reports), scope_(scope) {}

  /// One network a statement, from `first` on. Something that is not covered has a finding, and makes all of them
  /// unread: where the program goes on behind it is not known.
  std::vector<NetworkSyntax> lower(const SclBody& body, const NetworkSyntax& whole);
  /// Statements of one network among others, which stay what they are.
  void lowerInto(const SclBody& body, NetworkSyntax& network);

 private:
  using Kind = s7300::TypeKind;
  struct Refused {
    bool isNameMissing = false;  ///< a name that another file may define: what the compiler takes then is not known
  };

  // scl_statements.cpp
  void statement(const iec::Statement& statement);
  void statements(const iec::Statements& all);
  void assign(const iec::Statement& statement);
  bool keepStores(const iec::Statement& statement);
  void missed(const Refused& refused);
  void copyWhole(const Operand& to, const Operand& from, const s7300::Type& type, Span span);
  void ifStatement(const iec::Statement& statement);
  void caseStatement(const iec::Statement& statement);
  void forStatement(const iec::Statement& statement);
  void whileStatement(const iec::Statement& statement);
  void repeatStatement(const iec::Statement& statement);
  void jumpUnless(const iec::Expr& condition, const std::string& label);
  void leaveLoop(const iec::Statement& statement);
  std::int64_t constantNumber(const iec::Expr& expr);
  std::optional<std::int64_t> numberOf(const iec::Expr& expr, int depth = 0);

  // scl_expressions.cpp
  SclValue value(const iec::Expr& expr);
  SclValue valueAs(const iec::Expr& expr, Kind kind);
  SclValue binary(const iec::Expr& expr);
  SclValue logic(const iec::Expr& expr);
  SclValue withConstant(const std::string& op, bool isTrue, SclValue other);
  SclValue negated(SclValue value);
  /// AND, OR, XOR of two BOOL of which at most one stands in the RLO.
  SclValue joined(const std::string& op, SclValue left, SclValue right, Span span);
  SclValue words(const std::string& op, const iec::Expr& expr, SclValue left, const iec::Expr& right);
  SclValue wordsOf(const std::string& op, const iec::Expr& expr, SclValue left, SclValue right);
  SclValue compare(const iec::Expr& expr);
  SclValue arithmetic(const iec::Expr& expr);
  SclValue unary(const iec::Expr& expr);
  SclValue literal(const iec::Expr& expr);
  /// Both operands as that type, the left one in ACCU2 and the right one in ACCU1.
  void loadBoth(SclValue left, SclValue right, Kind kind);
  SclValue heldBefore(SclValue value, const iec::Expr& next);

  // scl_values.cpp
  /// Turns a value into one of another type where SCL does so by itself; refuses where it does not.
  SclValue as(SclValue value, Kind kind, Span span);
  /// The same as a constant, if it is one that fits.
  std::optional<SclValue> literalAs(const SclValue& value, Kind kind) const;
  void load(const SclValue& value);
  void scan(const SclValue& value);
  SclValue inTemporary(const SclValue& value);
  SclValue inRegister(Kind kind, Span span) const;
  Operand temporary(Kind kind);
  void store(const Operand& place, Kind kind);
  Kind commonKind(const SclValue& left, const SclValue& right, Span span);

  // scl_places.cpp, scl_slices.cpp
  struct Spot {
    Operand operand;  ///< without a computed index: the place; otherwise with the least indices
    BoundOperand bound;
    std::vector<std::pair<const iec::Expr*, s7300::Bounds>> indices;  ///< computed ones
    std::vector<std::int64_t> strides;                                ///< bits from one index to the next
    const iec::PathPart* slice = nullptr;  ///< `.%X3`, `.%B1`: which part of the value there is meant
  };
  SclValue path(const iec::Expr& expr);
  Spot placeOf(const iec::Expr& expr);
  Spot placeOrSlice(const iec::Expr& expr);
  Kind kindOfSlice(const Spot& spot, Kind whole);
  SclValue slice(const Spot& spot, SclValue whole);
  void storeSlice(const Spot& spot, Kind whole, const iec::Expr& given);
  std::optional<Spot> computedAddress(const iec::Expr& expr);
  Operand operandOf(const iec::Expr& expr, std::vector<std::pair<std::size_t, const iec::PathPart*>>& computed,
                    const iec::PathPart** slice = nullptr);
  std::optional<Operand> absolute(const iec::Expr& expr);
  bool isLocal(std::string_view name) const;
  Kind kindOf(const BoundOperand& bound, Span span, bool& isUntyped);
  BoundOperand bound(const Operand& operand);
  void checkRange(const SclValue& value, std::int64_t first, std::int64_t last, Span span);
  /// Leaves the address in AR1; the operand that reaches the place then.
  Operand pointTo(const Spot& place, Kind kind, Span span);
  void store(const Spot& place, const SclValue& value, Span span);

  // scl_calls.cpp
  SclValue call(const iec::Expr& expr, bool isStatement);
  std::optional<SclValue> blockCall(const iec::Expr& expr, bool isStatement);
  SclValue element(const iec::Expr& expr, const std::string& name, bool isStatement);
  SclValue s5TimeOfLiteral(SclValue time, Span span);
  const iec::Argument* argument(const iec::Expr& expr, std::string_view name) const;
  void giveOut(const iec::Argument& argument, const SclValue& value);

  // scl_functions.cpp
  SclValue standardFunction(const iec::Expr& expr, const std::string& name);
  SclValue conversion(const iec::Expr& expr, Kind from, Kind to, bool isBcd);
  SclValue absoluteValue(const iec::Expr& expr);
  SclValue realFunction(const iec::Expr& expr, std::string_view mnemonic);
  SclValue shift(const iec::Expr& expr, const std::string& name);
  SclValue rotate(SclValue in, SclValue count, bool isLeft, Span span);
  SclValue extreme(const iec::Expr& expr, bool isMost);
  SclValue limit(const iec::Expr& expr);
  SclValue alternative(const iec::Expr& expr, std::string_view name, std::size_t position);
  SclValue toBeTaken(Kind kind, Span span);
  void take(SclValue from, const SclValue& into);
  SclValue select(const iec::Expr& expr);
  SclValue multiplex(const iec::Expr& expr);
  const iec::Expr& input(const iec::Expr& expr, std::string_view name, std::size_t position);
  void improve(const Operand& best, SclValue next, Kind kind, bool isMost, Span span);
  Kind kindOfAll(const std::vector<SclValue>& values, Span span);

  // Emission
  void emit(std::string_view mnemonic, const Operand& operand = {});
  void leaveOpen(const Operand& place, Kind kind);
  void emitJump(std::string_view mnemonic, const std::string& label);
  void mark(const std::string& label);
  std::string freshLabel();
  [[noreturn]] void refuse(Span span, std::string message, Syntax code = Syntax::BodyNotCovered);
  std::string written(Span span) const;

  /// Whether a function or block is called in it, which may write what stands beside it.
  static bool calls(const iec::Expr& expr);

  struct Loop {
    std::string next, end;  ///< labels of CONTINUE and EXIT
  };

  const BlockCatalogue& catalogue_;
  TypeTable& types_;
  OperandBinder operands_;
  bool isNameMissing_ = false;                ///< in the statement at hand
  std::set<const iec::Statement*> unplaced_;  ///< assignments whose target was refused
  Reports& reports_;
  BlockScope& scope_;
  const SclBody* body_ = nullptr;
  NetworkSyntax* network_ = nullptr;
  std::vector<Loop> loops_;
  bool mayOverflow_ = false;   ///< some statement of the body
  int effects_ = 0;            ///< calls, timers and counters so far: what computing an expression changes
  std::optional<Operand> ok_;  ///< the flag OK, where the body writes it
  std::string endLabel_;
  bool isLeft_ = false;               ///< a RETURN jumps to the end
  bool isPart_ = false;               ///< one network among others
  std::uint32_t top_ = 0, next_ = 0;  ///< bits of temporary data in use, and from here on free
  int labels_ = 0;
  int constantDepth_ = 0;
  bool isWhole_ = true;
  Span span_;
};

/// The place, given by a statement list, of a constant.
Operand sclConstant(Constant constant, Span span);
/// 1, 8, 16 or 32 bits; 0: of another size.
int sclBits(s7300::TypeKind kind);
Size sclSize(s7300::TypeKind kind);

}  // namespace rungproof::step7
