// Mnemonics, operands, labels. Calls: call_binder.cpp.
#include "frontend/step7/statement_binder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "ir/block_map.hpp"
#include "ir/check.hpp"
#include "ir/s7300/index_check.hpp"
#include "ir/s7300/isa.hpp"

namespace rungproof::step7 {

using s7300::TypeKind;

namespace {

/// The conditions of the status word in the order of their numbers (002:1570-1581).
constexpr std::array<std::string_view, 10> conditions = {"BR",  "OV", "OS", "UO",  "==0",
                                                         "<>0", ">0", "<0", ">=0", "<=0"};

const Desc* descOf(std::string_view mnemonic, MnemonicSet set) {
  if (mnemonic == "OR" || mnemonic == "LABEL" || mnemonic == indexCheck || mnemonic == bodyEnd || mnemonic == openValue)
    return nullptr;  // names of the table that nobody writes
  return set == MnemonicSet::German ? s7300Instructions().namedGerman(mnemonic) : s7300Instructions().named(mnemonic);
}

const Desc& required(std::string_view name) {
  const Desc* desc = s7300Instructions().named(name);
  CHECK(desc != nullptr, "the table has this instruction");
  return *desc;
}

/// Instructions whose operand makes another one of them: L T 5, S C 3, T STW.
bool hasVariants(std::string_view mnemonic) {
  static constexpr std::array<std::string_view, 8> names = {"L", "LC", "T", "S", "R", "FR", "LAR1", "TAR1"};
  return std::ranges::find(names, mnemonic) != names.end();
}

bool isRegisterWord(const Operand& operand) {
  static constexpr std::array<std::string_view, 6> names = {"STW", "DBNO", "DINO", "DBLG", "DILG", "AR2"};
  return operand.form == OperandForm::Word &&
         std::ranges::any_of(names, [&](std::string_view name) { return equalsWord(operand.name, name); });
}

std::string upperText(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  return result;
}

std::string_view widthWord(Width width) {
  switch (width) {
    case Width::Bit: return "bit";
    case Width::Byte: return "byte";
    case Width::Word: return "word";
    default: return "double word";
  }
}

}  // namespace

bool StatementBinder::refuse(Syntax code, Span span, std::string message, std::string_view help) {
  reports_.report(code, span, std::move(message), scope_->name, network_ != nullptr ? network_->number : 0,
                  std::string(help));
  return false;
}

bool StatementBinder::miss(Syntax code, Span span, std::string message, std::string_view help) {
  reports_.reportOnce(code, span, std::move(message), scope_->name, network_ != nullptr ? network_->number : 0,
                      std::string(help));
  return false;
}

bool StatementBinder::refuse(const BoundOperand& operand) {
  const bool isMissing = operand.code == Syntax::NameUndefined || operand.code == Syntax::BlockMissing;
  return isMissing ? miss(operand.code, operand.faultSpan, operand.fault, operand.help)
                   : refuse(operand.code, operand.faultSpan, operand.fault, operand.help);
}

bool StatementBinder::keep(const Statement& statement, const BoundOperand& bound) {
  const Desc* desc = descOf(statement.mnemonic.text, set_);
  if (desc == nullptr || desc->operandCount == 0 || desc->control != Control::None) return false;
  rungproof::Operand operand;
  operand.kind = OperandKind::Symbol;
  const std::uint32_t block = isMissing(bound) ? std::min(bound.block->number, lastDataBlock) : bound.dataBlock;
  operand.area = block != 0 ? Area::DB : Area::V;
  operand.offset = dataByte(block, 0);
  operand.text =
      std::string(reports_.program().sources->file(statement.operand.span.file).text(statement.operand.span));
  operand.span = statement.operand.span;
  append(*desc, statement, {std::move(operand)});
  isKept_ = true;
  return false;
}

void StatementBinder::findLabels(const BlockSyntax& block, BlockScope& scope) {
  scope_ = &scope;
  network_ = nullptr;
  std::map<std::string, Span> first;
  for (const NetworkSyntax& network : block.networks) {
    for (const Statement& statement : network.statements) {
      if (statement.label.text.empty()) continue;
      const auto [place, isNew] = first.emplace(statement.label.text, statement.label.span);
      if (isNew) {
        scope.labels.emplace(statement.label.text, static_cast<std::int64_t>(scope.labels.size()));
        continue;
      }
      reports_.report(Syntax::LabelOfBlock, statement.label.span,
                      fmt::format("label {} is there twice", statement.label.text), scope.name, network.number);
      reports_.relate(place->second, "the first one");
    }
  }
}

void StatementBinder::bind(const NetworkSyntax& syntax, MnemonicSet set, BlockScope& scope, Network& network) {
  set_ = set;
  scope_ = &scope;
  network_ = &network;
  isStructured_ = syntax.isStructured;
  bool isBounded = true;
  for (const Statement& each : syntax.statements) {
    isKept_ = false;
    if (statement(each)) continue;
    network.complete = false;
    isBounded = isBounded && isKept_;
  }
  // What it may write is what its instructions write.
  if (!network.complete && isBounded) network.mayWrite.emplace();
  network_ = nullptr;
}

void StatementBinder::append(const Desc& desc, const Statement& statement, rungproof::Operands operands) {
  Instruction instruction;
  instruction.desc = &desc;
  instruction.operands = std::move(operands);
  instruction.mnemonicLength = statement.mnemonic.span.length;
  const std::uint32_t end = statement.span.offset + statement.span.length;
  instruction.span = statement.mnemonic.span;
  instruction.span.length = std::max(end, instruction.span.offset) - instruction.span.offset;
  network_->instructions.push_back(std::move(instruction));
}

bool StatementBinder::statement(const Statement& statement) {
  if (!statement.label.text.empty()) {
    Instruction label;
    label.desc = &required("LABEL");
    label.span = statement.label.span;
    label.mnemonicLength = label.span.length;
    rungproof::Operand number = constant(scope_->labels[statement.label.text], ConstantForm::Typed);
    number.text = statement.label.text;
    number.span = statement.label.span;
    label.operands.push_back(std::move(number));
    network_->instructions.push_back(std::move(label));
  }
  const std::string& mnemonic = statement.mnemonic.text;
  if (mnemonic.empty()) return true;
  if (mnemonic == indexCheck && isStructured_) {
    append(required(indexCheck), statement,
           {constant(statement.operand.constant.value, ConstantForm::Typed),
            constant(statement.instance.constant.value, ConstantForm::Typed)});
    return true;
  }
  if (mnemonic == openValue && isStructured_) {
    append(required(openValue), statement, {});
    return true;
  }
  if (mnemonic == bodyEnd && isStructured_) {
    append(required(bodyEnd), statement, {constant(statement.operand.constant.value, ConstantForm::Typed)});
    return true;
  }
  const Desc* plain = descOf(mnemonic, set_);
  if (plain == nullptr && !hasVariants(mnemonic) && mnemonic != "NOP") {
    const bool isOfOtherSet =
        descOf(mnemonic, set_ == MnemonicSet::German ? MnemonicSet::International : MnemonicSet::German) != nullptr;
    if (isOfOtherSet)
      return refuse(Syntax::Statement7, statement.mnemonic.span,
                    fmt::format("{} is a mnemonic of the {} set, the source is written in the {} one", mnemonic,
                                set_ == MnemonicSet::German ? "international" : "German",
                                set_ == MnemonicSet::German ? "German" : "international"));
    return refuse(Syntax::Statement7, statement.mnemonic.span,
                  fmt::format("unknown instruction {}", excerpt(mnemonic)));
  }
  if (!statement.fault.empty()) return refuse(Syntax::Statement7, statement.faultSpan, statement.fault);
  if (plain != nullptr && (plain->control == Control::Branch || plain->control == Control::Distributor))
    return jump(*plain, statement);
  if (plain != nullptr && plain->control == Control::BlockCall) return call(*plain, statement);
  BoundOperand operand;
  if (statement.operand.form != OperandForm::None && !isRegisterWord(statement.operand)) {
    if (std::optional<rungproof::Operand> scanned = condition(statement)) {
      operand.operand = std::move(*scanned);
      operand.constant.emplace();
    } else {
      operand = operands_.bind(statement.operand, *scope_);
      if (!operand.fault.empty()) {
        refuse(operand);
        return operand.code != Syntax::Operand7 && keep(statement, operand);
      }
    }
  }
  const Desc* desc = instruction(statement, operand);
  if (desc == nullptr)
    return refuse(Syntax::Operand7,
                  statement.operand.form == OperandForm::None ? statement.mnemonic.span : statement.operand.span,
                  fmt::format("{} takes another operand", mnemonic));
  if (!operandFits(*desc, statement, operand)) return isMissing(operand) && keep(statement, operand);
  rungproof::Operands operands;
  if (desc->operandCount > 0 && operand.operand.kind != OperandKind::Missing)
    operands.push_back(std::move(operand.operand));
  append(*desc, statement, std::move(operands));
  return true;
}

/// The instruction that mnemonic and operand name together.
const Desc* StatementBinder::instruction(const Statement& statement, const BoundOperand& operand) {
  const std::string& mnemonic = statement.mnemonic.text;
  const auto named = [](const std::string& name) { return s7300Instructions().named(name); };
  if (mnemonic == "O" && statement.operand.form == OperandForm::None) return named("OR");
  if (mnemonic == "NOP") {
    const bool isNumber = operand.constant && operand.operand.value <= 1 && operand.operand.value >= 0;
    return isNumber ? named(fmt::format("NOP {}", operand.operand.value)) : nullptr;
  }
  if (isRegisterWord(statement.operand)) {
    const std::string word = upperText(statement.operand.name);
    return named(mnemonic + " " + word);
  }
  if (hasVariants(mnemonic) && operand.operand.isMemory() &&
      (operand.operand.area == Area::T || operand.operand.area == Area::C)) {
    const bool isCounter = operand.operand.area == Area::C;
    if (const Desc* variant = named(mnemonic + (isCounter ? " C" : " T"))) return variant;
    return nullptr;
  }
  return descOf(mnemonic, set_);
}

/// A ==0, O BR: what is scanned is the status word.
std::optional<rungproof::Operand> StatementBinder::condition(const Statement& statement) const {
  static constexpr std::array<std::string_view, 8> scans = {"A", "AN", "U", "UN", "O", "ON", "X", "XN"};
  if (statement.operand.form != OperandForm::Word || !statement.operand.path.empty()) return std::nullopt;
  if (std::ranges::find(scans, statement.mnemonic.text) == scans.end()) return std::nullopt;
  std::string word = upperText(statement.operand.name);
  if (set_ == MnemonicSet::German && word == "BIE") word = "BR";
  const auto found = std::ranges::find(conditions, word);
  if (found == conditions.end()) return std::nullopt;
  rungproof::Operand operand = constant(found - conditions.begin(), ConstantForm::Typed);
  operand.text = word;
  operand.width = Width::Bit;
  operand.span = statement.operand.span;
  return operand;
}

namespace {

/// Eight bytes of a date and time, ten of an ANY; a pointer's six where it names its data block.
bool isTooWide(const s7300::Constant& constant) {
  using enum s7300::ConstantKind;
  return constant.kind == DateAndTime || constant.kind == Any || (constant.kind == Pointer && constant.block != 0);
}

}  // namespace

/// A data block that no file defines. OPN DB 0 opens none.
bool StatementBinder::isMissing(const BoundOperand& bound) const {
  return bound.block && bound.block->kind == BlockKind::Db && bound.operand.kind == OperandKind::Direct &&
         bound.block->number != 0 && catalogue_.entry(*bound.block) == nullptr;
}

bool StatementBinder::operandFits(const Desc& desc, const Statement& statement, const BoundOperand& bound) {
  const std::string& mnemonic = statement.mnemonic.text;
  const rungproof::Operand& operand = bound.operand;
  const bool isGiven = statement.operand.form != OperandForm::None;
  if (desc.operandCount == 0) {
    const bool isPartOfName = isRegisterWord(statement.operand) || mnemonic == "NOP";
    if (!isGiven || isPartOfName) return true;
    return refuse(Syntax::Operand7, statement.operand.span, fmt::format("{} takes no operand", mnemonic));
  }
  const OperandDesc& wanted = desc.operands[0];
  if (!isGiven) {
    if (wanted.optional) return true;
    return refuse(Syntax::Operand7, statement.mnemonic.span, fmt::format("{} needs an operand", mnemonic));
  }
  const Span span = statement.operand.span;
  if (operand.kind == OperandKind::Constant && bound.block)
    return refuse(Syntax::Operand7, span, fmt::format("{} does not take {}", mnemonic, toString(*bound.block)));
  if (operand.kind == OperandKind::Constant || operand.kind == OperandKind::Address) {
    if ((wanted.forms & form::Const) == 0)
      return refuse(Syntax::Operand7, span, fmt::format("{} takes no constant", mnemonic));
    if (wanted.type == rungproof::Type::Bool && operand.width != Width::Bit)
      return refuse(Syntax::Operand7, span, fmt::format("{} takes a bit", mnemonic));
    if (bound.constant && bound.constant->kind == s7300::ConstantKind::Text && bound.constant->text.size() > 4)
      return refuse(Syntax::Operand7, span, "at most four characters fit into an accumulator");
    if (bound.constant && isTooWide(*bound.constant))
      return refuse(Syntax::Operand7, span, "the constant is wider than an accumulator");
    const bool isWordOnly = wanted.type == rungproof::Type::Word;
    if (isWordOnly && operand.width == Width::DWord)
      return refuse(Syntax::Operand7, span, fmt::format("{} takes a constant of 16 bits", mnemonic));
    for (const ValueRange& range : wanted.ranges) {
      if (range.cpus == 0) continue;
      const std::int64_t value = bound.constant ? bound.constant->value : operand.value;
      if (value < range.low || value > range.high)
        return refuse(Syntax::Operand7, span, fmt::format("{} takes {} to {}", mnemonic, range.low, range.high));
    }
    return true;
  }
  if (bound.type && s7300::isComplex(*bound.type) && desc.operands[0].type != rungproof::Type::Block)
    return refuse(Syntax::Operand7, span,
                  fmt::format("{} is {}: name one of its parts", operand.text, s7300::toString(*bound.type)));
  if (bound.type && !s7300::isComplex(*bound.type) &&
      (bound.type->kind == TypeKind::Any || bound.type->kind == TypeKind::Pointer))
    return refuse(Syntax::Operand7, span, fmt::format("{} is reached through P#{} only", operand.text, operand.text));
  if (desc.operands[0].type == rungproof::Type::Block) {
    const bool isDataBlock =
        (bound.block && bound.block->kind == BlockKind::Db) || (bound.type && bound.type->kind == TypeKind::BlockDb);
    if (!isDataBlock) return refuse(Syntax::Operand7, span, fmt::format("{} takes a data block", mnemonic));
    if (refuseOpaque(bound, span)) return false;
    return !isMissing(bound) ||
           miss(Syntax::BlockMissing, span, fmt::format("{} is in none of the files", toString(*bound.block)));
  }
  if (bound.block)
    return refuse(Syntax::Operand7, span, fmt::format("{} does not take {}", mnemonic, toString(*bound.block)));
  const bool isCrossing = operand.reach != nullptr && operand.reach->way == Way::Crossing;
  if (!isCrossing && (wanted.forms & form::area(operand.area)) == 0)
    return refuse(Syntax::Operand7, span, fmt::format("{} does not take an operand of this area", mnemonic));
  const auto needs = [&](Width width) {
    return operand.width == width ||
           refuse(Syntax::Operand7, span,
                  fmt::format("{} takes a {}, not a {}", mnemonic, widthWord(width), widthWord(operand.width)));
  };
  switch (wanted.type) {
    case rungproof::Type::Bool:
    case rungproof::Type::Timer:
    case rungproof::Type::Counter: return needs(Width::Bit);
    case rungproof::Type::DWord:
    case rungproof::Type::DInt: return needs(Width::DWord);
    case rungproof::Type::Value:
      return operand.width != Width::Bit ||
             refuse(Syntax::Operand7, span, fmt::format("{} takes a byte, word or double word, not a bit", mnemonic));
    default: return true;
  }
}

bool StatementBinder::jump(const Desc& desc, const Statement& statement) {
  if (statement.operand.form != OperandForm::Word)
    return refuse(Syntax::LabelOfBlock, statement.mnemonic.span,
                  fmt::format("{} needs a label", statement.mnemonic.text));
  const auto label = scope_->labels.find(statement.operand.name);
  if (label == scope_->labels.end())
    return refuse(Syntax::LabelOfBlock, statement.operand.span,
                  fmt::format("the block has no label {}", statement.operand.name));
  rungproof::Operand operand = constant(label->second, ConstantForm::Typed);
  operand.text = statement.operand.name;
  operand.span = statement.operand.span;
  append(desc, statement, {std::move(operand)});
  return true;
}

}  // namespace rungproof::step7
