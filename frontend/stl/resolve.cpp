// The resolver.
#include "frontend/stl/resolve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <unordered_map>

#include "frontend/stl/file_block.hpp"
#include "frontend/stl/operand_reader.hpp"
#include "frontend/stl/stl_lexer.hpp"
#include "frontend/stl/stl_statement.hpp"
#include "frontend/stl/system_symbol.hpp"

namespace rungproof {

namespace {

/// Names are looked up as written first, then without regard to case.
template <class T>
class NameIndex {
 public:
  void add(std::string_view name, T value) {
    exact_.emplace(name, value);
    folded_.emplace(folded(name), value);
  }
  const T* find(std::string_view name) const {
    const auto found = exact_.find(name);
    if (found != exact_.end()) return &found->second;
    const auto other = folded_.find(folded(name));
    return other == folded_.end() ? nullptr : &other->second;
  }

 private:
  static std::string folded(std::string_view name) {
    std::string result(name);
    std::transform(result.begin(), result.end(), result.begin(), upper);
    return result;
  }
  std::unordered_map<std::string_view, T> exact_;
  std::unordered_map<std::string, T> folded_;
};

class Resolver {
 public:
  explicit Resolver(Program& program) : program_(program) {
    for (std::size_t i = 0; i < program.symbols.size(); ++i) symbols_.add(program.symbols[i].name, i);
    for (const Pou& pou : program.pous) {
      if (pou.kind != PouKind::Main)
        (pou.kind == PouKind::Interrupt ? interrupts_ : subroutines_).add(pou.name, pou.number);
    }
    // By what follows the underscore in SBR3_Valves, where no block has that name itself.
    for (const Pou& pou : program.pous) {
      const std::string_view name = pou.kind == PouKind::Main ? std::string_view() : shortName(pou.name);
      NameIndex<int>& routines = pou.kind == PouKind::Interrupt ? interrupts_ : subroutines_;
      if (!name.empty() && routines.find(name) == nullptr) routines.add(name, pou.number);
    }
  }

  void run() {
    for (Pou& pou : program_.pous) {
      NameIndex<std::size_t> locals;
      for (std::size_t i = 0; i < pou.locals.size(); ++i) locals.add(pou.locals[i].name, i);
      pou_ = &pou;
      locals_ = &locals;
      for (Network& network : pou.networks) {
        network_ = network.number;
        for (Instruction& instruction : network.instructions) {
          for (std::size_t i = 0; i < instruction.operands.size(); ++i) {
            if (!resolve(instruction.operands[i], operandDescOf(*instruction.desc, i))) network.complete = false;
          }
        }
      }
    }
  }

 private:
  /// False if the operand is damaged (reported).
  bool resolve(Operand& operand, const OperandDesc& expected) {
    if (expected.type == Type::Subroutine || expected.type == Type::Interrupt)
      return resolveRoutine(operand, expected.type);
    if (operand.kind == OperandKind::Text && expected.type != Type::String) return resolveQuoted(operand, expected);
    if (operand.kind != OperandKind::Symbol) return true;
    if (const std::size_t mark = std::string_view(operand.text).rfind(namedAddressMark); mark != std::string_view::npos)
      return resolveNamedAddress(operand, mark);
    const char sign = operand.text[0] == '*' || operand.text[0] == '&' ? operand.text[0] : '\0';
    const std::string_view name = std::string_view(operand.text).substr(sign == '\0' ? 0 : 1);
    Operand place;
    if (!lookUp(name, place)) return sign == '\0' ? mend(operand, expected) : true;
    return replace(operand, place, sign);
  }

  /// Start:I0.0: the address counts, and a table that knows the name has to agree.
  bool resolveNamedAddress(Operand& operand, std::size_t mark) {
    const std::string text(operand.text.view());
    const std::string name = text.substr(0, mark);
    Operand written, known;
    if (!readAddress(text.substr(mark + 1), Spelling::International, written)) return fault(operand, text);
    const bool isKnown = lookUp(name, known);
    if (isKnown && (known.kind != OperandKind::Direct || toString(known) != toString(written)))
      return fault(operand, fmt::format("{} is {} by the symbol table, and {} is written here", name, toString(known),
                                        toString(written)));
    operand.text = isKnown ? name : std::string();
    return replace(operand, isKnown ? known : written, '\0');
  }

  bool lookUp(std::string_view name, Operand& place) const {
    const bool onlyLocal = name[0] == '#';
    if (onlyLocal) name.remove_prefix(1);
    if (const std::size_t* local = locals_->find(name)) {
      place = pou_->locals[*local].address;
      return true;
    }
    if (onlyLocal) return false;
    if (const std::size_t* symbol = symbols_.find(name)) {
      place = program_.symbols[*symbol].address;
      return true;
    }
    const std::optional<Operand> system = systemSymbol(name);
    if (system) place = *system;
    return system.has_value();
  }

  bool replace(Operand& operand, const Operand& place, char sign) {
    const bool isNumbered = addressedByNumber(place.area);
    if (sign == '*') {
      const bool mayHold = place.kind == OperandKind::Direct && mayHoldPointer(place.area) &&
                           (place.area == Area::AC || place.width == Width::DWord);
      if (!mayHold)
        return fault(operand,
                     fmt::format("{} is {}, but pointers are kept in VD, LD or AC", operand.text, toString(place)));
    } else if (sign == '&' && (place.kind != OperandKind::Direct || (place.width == Width::Bit && !isNumbered))) {
      return fault(operand, fmt::format("{} is {}, which has no address", operand.text, toString(place)));
    }
    const Span span = operand.span;
    ShortText name = std::move(operand.text);
    operand = place;
    operand.span = span;
    operand.text = std::move(name);
    if (sign == '*') operand.kind = OperandKind::Indirect;
    if (sign == '&') {
      operand.kind = OperandKind::Address;
      if (!isNumbered && !isAnalogue(place.area)) operand.width = Width::Byte;
    }
    return true;
  }

  bool resolveRoutine(Operand& operand, Type type) {
    if (operand.kind == OperandKind::Text) {
      operand.text = quotedName(operand);
      operand.kind = OperandKind::Symbol;
    }
    if (operand.kind != OperandKind::Symbol) return true;
    operand.value = -1;
    const NameIndex<int>& routines = type == Type::Interrupt ? interrupts_ : subroutines_;
    std::optional<std::int64_t> number;
    if (const int* found = routines.find(operand.text)) {
      number = *found;
    } else if (const std::size_t* symbol = symbols_.find(operand.text);
               symbol != nullptr && program_.symbols[*symbol].address.kind == OperandKind::Constant) {
      number = program_.symbols[*symbol].address.value;
    } else {
      number = numberOf(operand.text, type);
    }
    if (!number) return true;
    operand.kind = OperandKind::Constant;
    operand.form = ConstantForm::Decimal;
    operand.value = *number;
    return true;
  }

  /// SBR_0, SBR0, FC0, INT_12.
  static std::optional<std::int64_t> numberOf(std::string_view name, Type type) {
    const FileBlock block = fileBlock(name);
    const bool isWhole = block.number && shortName(name).empty() && name.find('.') == std::string_view::npos;
    if (!isWhole || block.kind != (type == Type::Interrupt ? PouKind::Interrupt : PouKind::Subroutine))
      return std::nullopt;
    return *block.number;
  }

  /// The name as it is written between its marks. As a text for the controller it has one byte for a letter.
  std::string quotedName(const Operand& operand) const {
    std::string_view text = program_.sources->text(operand.span);
    const Quote open = text.empty() ? Quote{} : quoteAt(text, 0);
    if (open.length == 0) return operand.text;
    text.remove_prefix(open.length);
    std::size_t end = 0;
    while (end < text.size() && quoteAt(text, end).kind != open.kind) ++end;
    return std::string(text.substr(0, end));
  }

  /// "name" where no text is expected: a quoted symbol. A parameter of CALL may be either.
  bool resolveQuoted(Operand& operand, const OperandDesc& expected) {
    Operand place;
    std::string name = quotedName(operand);
    const bool isKnown = !name.empty() && lookUp(name, place);
    if (!isKnown && (expected.type == Type::Parameter || !isName(name))) return true;
    operand.text = std::move(name);
    if (isKnown) return replace(operand, place, '\0');
    operand.kind = OperandKind::Symbol;
    operand.value = -1;
    return true;
  }

  /// A name that no table knows: perhaps an address with look-alike characters, or K9.
  bool mend(Operand& operand, const OperandDesc& expected) {
    const std::string& text = operand.text;
    const bool mayBeConstant = (expected.forms & form::Const) != 0 && expected.type != Type::Bool;
    if (mayBeConstant && text.size() > 1 && text.size() < 8 && upper(text[0]) == 'K') {
      const bool isHex = upper(text[1]) == 'H' && text.size() > 2;
      ConstantResult value = readConstant(isHex ? "16#" + text.substr(2) : text.substr(1));
      if (value.fault == ConstantFault::None) {
        SyntaxSink& sink = sinkFor(operand);
        sink.lenient(operand.span, text, toString(value.operand));
        value.operand.span = operand.span;
        operand = std::move(value.operand);
        return true;
      }
    }
    if (isPartOfAddress(text, Spelling::International)) {
      return fault(
          operand,
          fmt::format("address {} has neither a size letter nor a bit number, and no symbol has this name", text));
    }
    const bool hasDigit = std::any_of(text.begin(), text.end(), isDigit) || upper(text[0]) == 'A' ||
                          static_cast<unsigned char>(text[0]) >= 0x80;
    const std::string mended = hasDigit ? mendedOperand(text, Spelling::International, true) : std::string();
    if (mended.empty()) return true;
    OperandResult result = readOperand(mended, {});
    SyntaxSink& sink = sinkFor(operand);
    sink.lookAlike(operand.span, text, mended);
    result.operand.span = operand.span;
    operand = std::move(result.operand);
    return true;
  }

  bool fault(const Operand& operand, std::string message) {
    SyntaxSink& sink = sinkFor(operand);
    sink.report(Syntax::BadOperand, operand.span, std::move(message));
    return false;
  }
  SyntaxSink& sinkFor(const Operand& operand) {
    SyntaxSink& sink = sinks_.try_emplace(operand.span.file, program_, operand.span.file).first->second;
    sink.setPlace(pou_->name, network_);
    return sink;
  }

  Program& program_;
  std::unordered_map<std::uint32_t, SyntaxSink> sinks_;  ///< by file
  NameIndex<std::size_t> symbols_;
  NameIndex<int> subroutines_;
  NameIndex<int> interrupts_;
  Pou* pou_ = nullptr;
  const NameIndex<std::size_t>* locals_ = nullptr;
  int network_ = 0;
};

}  // namespace

void resolveNames(Program& program) { Resolver(program).run(); }

}  // namespace rungproof
