// Words of a line to mnemonic and operands.
#include "frontend/stl/stl_statement.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rungproof {

OperandLimits operandLimits(const Desc& desc) {
  if (desc.control == Control::Call) return {1, 17};  // the routine and up to 16 parameters (001:6775)
  OperandLimits limits;
  for (int i = 0; i < desc.operandCount; ++i) {
    ++limits.most;
    if (!desc.operand(i).optional) ++limits.least;
  }
  return limits;
}

const OperandDesc& operandDescOf(const Desc& desc, std::size_t index) {
  static constexpr OperandDesc routine = in("routine", Type::Subroutine, form::Const);
  static constexpr OperandDesc parameter = in("parameter", Type::Parameter, ~Forms{0});
  if (desc.control == Control::Call) return index == 0 ? routine : parameter;
  return desc.operands[std::min<std::size_t>(index, maxOperands - 1)];
}

namespace {

bool isOneDigit(std::string_view text) { return text.size() == 1 && text[0] >= '0' && text[0] <= '7'; }

bool allDigits(std::string_view text) { return !text.empty() && std::all_of(text.begin(), text.end(), isDigit); }

std::size_t letterCount(std::string_view text) {
  std::size_t count = 0;
  while (count < text.size() && isLetter(text[count])) ++count;
  return count;
}

bool beginsBeyondAscii(std::string_view text) { return !text.empty() && static_cast<unsigned char>(text[0]) >= 0x80; }

/// V0.1, *VD10, T37: an address of some kind, whether or not the CPU has it.
bool looksLikeAddress(std::string_view word) {
  if (!word.empty() && (word[0] == '*' || word[0] == '&')) word.remove_prefix(1);
  constexpr std::size_t mostLetters = 3;
  const std::size_t letters = letterCount(word);
  const auto isOfNumber = [](char c) { return isDigit(c) || c == '.'; };
  return letters > 0 && letters <= mostLetters && letters < word.size() && isDigit(word[letters]) &&
         std::ranges::all_of(word.substr(letters), isOfNumber);
}

/// What may be a mnemonic of another language: up to three letters of Cyrillic or Greek, or and, or, not in Chinese.
bool mayBeForeignMnemonic(std::string_view word) {
  constexpr std::size_t bytesOfThree = 6;
  const bool isOfCharacters = static_cast<unsigned char>(word[0]) >= 0xE0;
  return isOfCharacters ? word == "\xE4\xB8\x8E" || word == "\xE6\x88\x96" || word == "\xE9\x9D\x9E"
                        : word.size() <= bytesOfThree;
}

bool isRoutine(Type type) { return type == Type::Subroutine || type == Type::Interrupt || type == Type::Label; }

}  // namespace

const MnemonicResult& StatementReader::mnemonicOf(std::string_view word) {
  const auto code = [](char c) { return static_cast<unsigned char>(c); };
  KnownWord& known = words_[(code(word.front()) * 7U + code(word.back()) * 3U + word.size()) % words_.size()];
  if (known.word != word) known = {word, findMnemonic(word, context_)};
  return known.found;
}

StatementKind StatementReader::unknown(const Line& line) {
  const std::string_view word = slice(line.words[0].begin, line.words[0].end);
  const Span place = sink_.span(line.begin, line.end);
  const bool isStatement = line.words.size() > 1 && beginsBeyondAscii(word) && mayBeForeignMnemonic(word) &&
                           std::ranges::all_of(line.words.begin() + 1, line.words.end(), [&](const Word& operand) {
                             return looksLikeAddress(slice(operand.begin, operand.end));
                           });
  if (beginsBeyondAscii(word) && !isStatement) {
    sink_.report(
        Syntax::StrayText, place,
        fmt::format("\"{}\" has no comment sign and was read as a comment", excerpt(slice(line.begin, line.end))));
    return StatementKind::Stray;
  }
  const Span at = sink_.span(line.words[0].begin, line.words[0].end);
  if (const std::string_view family = familyOfForeignInstruction(word); !family.empty()) {
    sink_.report(Syntax::OtherFamily, at, fmt::format("{} is an instruction of the {}", excerpt(word), family));
    return StatementKind::Failed;
  }
  std::string message = fmt::format("unknown instruction \"{}\"", excerpt(word));
  const bool hasNumber = line.words.size() == 2 && allDigits(slice(line.words[1].begin, line.words[1].end));
  const std::string_view heading = hasNumber ? nearestHeading(word) : std::string_view();
  const std::string_view nearest = heading.empty() ? nearestMnemonic(word) : heading;
  if (!nearest.empty()) message += fmt::format("; did you mean {}?", nearest);
  sink_.report(Syntax::UnknownInstruction, at, std::move(message),
               nearest.empty() ? std::nullopt : std::optional<Fix>(Fix{at, std::string(nearest), false}));
  return StatementKind::Failed;
}

StatementKind StatementReader::read(const Line& line, Instruction& instruction) {
  const Word& first = line.words[0];
  const std::string_view word = slice(first.begin, first.end);
  MnemonicResult found;
  std::size_t nextWord = 1;
  std::uint32_t mnemonicEnd = first.end;
  std::uint32_t gluedBegin = first.end;
  bool isApart = false;
  if (line.words.size() > 1 && !line.words[1].afterComma) {
    const Word& second = line.words[1];
    found = findComparison(word, slice(second.begin, second.end), context_);
    if (found.desc != nullptr) {
      isApart = true;
      mnemonicEnd = second.begin + static_cast<std::uint32_t>(found.length);
      gluedBegin = mnemonicEnd;
      nextWord = 2;
    }
  }
  const std::uint32_t wordEnd = isApart ? line.words[1].end : first.end;
  if (!isApart) {
    found = mnemonicOf(word);
    if (found.desc == nullptr) return unknown(line);
    mnemonicEnd = first.begin + static_cast<std::uint32_t>(found.length);
    gluedBegin = mnemonicEnd;
  }
  const Desc& desc = *found.desc;
  if (desc.drawingOnly) {
    sink_.report(Syntax::UnknownInstruction, sink_.span(first.begin, first.end),
                 fmt::format("{} exists as a box of LAD and FBD only", desc.stl));
    return StatementKind::Failed;
  }
  const Span mnemonic = sink_.span(first.begin, mnemonicEnd);
  const std::string_view written = slice(first.begin, mnemonicEnd);
  if (found.match == MnemonicMatch::LookAlike) sink_.lookAlike(mnemonic, written, std::string(desc.stl));
  if (found.match == MnemonicMatch::LadderName) {
    sink_.report(Syntax::LadderName, mnemonic,
                 fmt::format("{} is the name of a box; the instruction is {}", written, desc.stl),
                 Fix{mnemonic, std::string(desc.stl), true});
  }
  if (isApart) sink_.lenient(mnemonic, written, std::string(desc.stl));

  pieces_.clear();
  if (gluedBegin < wordEnd) {
    const std::string_view glued = slice(first.begin, wordEnd);
    if (!isApart && desc.stl != "=")
      sink_.lenient(sink_.span(first.begin, wordEnd), glued,
                    fmt::format("{} {}", desc.stl, slice(gluedBegin, wordEnd)));
    pieces_.push_back({gluedBegin, wordEnd});
  }
  gather(line, nextWord);
  joinDecimalCommas(desc);

  if (line.openQuote) {
    sink_.report(Syntax::QuoteOpen, sink_.span(line.begin, line.end), "a quotation mark is not closed on this line");
    return StatementKind::Failed;
  }
  const OperandLimits limits = operandLimits(desc);
  StatementKind kind = StatementKind::Instruction;
  if (pieces_.size() > limits.most && !dropStrayTail(line, limits.most)) {
    sink_.report(Syntax::OperandCount, sink_.span(pieces_[limits.most].begin, pieces_.back().end),
                 fmt::format("{} takes {} operand{}, not {}", desc.stl, limits.most, limits.most == 1 ? "" : "s",
                             pieces_.size()));
    pieces_.resize(limits.most);
    kind = StatementKind::Damaged;
  }
  if (pieces_.size() < limits.least) {
    sink_.report(Syntax::OperandCount, sink_.span(first.begin, line.end),
                 fmt::format("{} takes {} operand{}, not {}", desc.stl, limits.least, limits.least == 1 ? "" : "s",
                             pieces_.size()));
    return StatementKind::Failed;
  }
  instruction.desc = &desc;
  instruction.mnemonicLength = mnemonic.length;
  instruction.span = sink_.span(first.begin, pieces_.empty() ? mnemonicEnd : std::max(mnemonicEnd, pieces_.back().end));
  instruction.operands.clear();
  instruction.operands.resize(pieces_.size());
  bool isReadable = true;
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    if (!readPiece(pieces_[i], desc, i, instruction.operands[i])) isReadable = false;
  }
  return isReadable ? kind : StatementKind::Failed;
}

/// Words after the mnemonic to operands; words that make one operand are joined.
void StatementReader::gather(const Line& line, std::size_t firstWord) {
  for (std::size_t i = firstWord; i < line.words.size(); ++i) {
    const Word& word = line.words[i];
    const std::string_view text = slice(word.begin, word.end);
    if (!pieces_.empty() && !word.afterComma && belongsTogether(pieces_.back(), text)) {
      Piece& piece = pieces_.back();
      const std::string_view before = textOf(piece);
      const bool isSign = before == "*" || before == "&" || before == "#" || before == "%";
      piece.joined = std::string(before) + std::string(text);
      piece.end = word.end;
      if (!isSign) sink_.lenient(sink_.span(piece.begin, piece.end), slice(piece.begin, piece.end), piece.joined);
      continue;
    }
    pieces_.push_back({word.begin, word.end, word.afterComma});
  }
}

bool StatementReader::belongsTogether(const Piece& piece, std::string_view next) const {
  const std::string_view text = textOf(piece);
  if (text == "*" || text == "&" || text == "#" || text == "%") return true;
  if (text == "+" || text == "-") return isDigit(next[0]);
  if (text.back() == '#' && text.size() > 1) return isDigit(next[0]) || isLetter(next[0]);
  if (text == "16" || text == "2") return next[0] == '#';
  if (text.back() == '.' && allDigits(next)) return true;
  if (next[0] == '.' && next.size() > 1 && allDigits(next.substr(1)) && isDigit(text.back())) return true;
  if (!isDigit(next[0])) return false;
  if (equalsIgnoringCase(text, "SBR") || equalsIgnoringCase(text, "INT") || equalsIgnoringCase(text, "LBL"))
    return true;
  const std::string_view letters = text[0] == '*' || text[0] == '&' || text[0] == '%' ? text.substr(1) : text;
  return isAreaPrefix(letters, context_.spelling);
}

/// "LD I0,1" and "S Q0,1, 5": a comma where the point of a bit address is due (004, 9 lines).
void StatementReader::joinDecimalCommas(const Desc& desc) {
  const std::size_t most = operandLimits(desc).most;
  for (std::size_t i = 0; i + 1 < pieces_.size() && pieces_.size() > most; ++i) {
    if (operandDescOf(desc, i).type != Type::Bool) continue;
    const std::string_view text = textOf(pieces_[i]);
    const std::size_t letters = letterCount(text);
    const bool isHalf =
        (letters == 0 || isAreaPrefix(text.substr(0, letters), context_.spelling)) && allDigits(text.substr(letters));
    if (!isHalf || !pieces_[i + 1].afterComma || !isOneDigit(textOf(pieces_[i + 1]))) continue;
    pieces_[i].joined = fmt::format("{}.{}", text, textOf(pieces_[i + 1]));
    pieces_[i].end = pieces_[i + 1].end;
    pieces_[i].pointWasComma = true;
    pieces_.erase(pieces_.begin() + static_cast<std::ptrdiff_t>(i) + 1);
  }
}

/// Text of a comment that lost its sign, behind the last operand.
bool StatementReader::dropStrayTail(const Line& line, std::size_t limit) {
  const Piece& tail = pieces_[limit];
  if (tail.afterComma || !beginsBeyondAscii(textOf(tail))) return false;
  sink_.report(
      Syntax::StrayText, sink_.span(tail.begin, line.end),
      fmt::format("\"{}\" has no comment sign and was read as a comment", excerpt(slice(tail.begin, line.end))));
  pieces_.resize(limit);
  return true;
}

bool StatementReader::readPiece(const Piece& piece, const Desc& desc, std::size_t index, Operand& operand) {
  const std::string_view text = textOf(piece);
  const OperandDesc& expected = operandDescOf(desc, index);
  const Span place = sink_.span(piece.begin, piece.end);
  const std::string_view written = slice(piece.begin, piece.end);
  const bool bitOnly = expected.type == Type::Bool && (expected.forms & form::Const) == 0;
  OperandResult result = readOperand(text, context_);
  if (isRoutine(expected.type) && result.operand.kind == OperandKind::Direct) {
    result.operand = Operand{};
    result.operand.kind = OperandKind::Symbol;
    result.operand.value = -1;
    result.operand.text = text;
  }
  const bool isMisplacedNumber =
      bitOnly && result.fault == OperandFault::None && result.operand.kind == OperandKind::Constant;
  if (result.fault != OperandFault::None || isMisplacedNumber ||
      (isRoutine(expected.type) && (text == "O" || text == "o"))) {
    std::string mended = isRoutine(expected.type) && (text == "O" || text == "o")
                             ? "0"
                             : mendedOperand(text, context_.spelling, bitOnly);
    if (!mended.empty()) {
      result = readOperand(mended, context_);
      sink_.lookAlike(place, written, std::move(mended));
    } else if (result.fault != OperandFault::None) {
      reportUnreadable(piece, result);
      return false;
    }
  } else if (piece.pointWasComma) {
    sink_.lookAlike(place, written, std::string(text));
  }
  operand = std::move(result.operand);
  if (operand.kind == OperandKind::Symbol) operand.text = *names_.insert(std::move(operand.text)).first;
  operand.span = place;
  return true;
}

void StatementReader::reportUnreadable(const Piece& piece, const OperandResult& result) {
  const Span place = sink_.span(piece.begin, piece.end);
  const std::string name = excerpt(slice(piece.begin, piece.end));
  const std::string_view text = textOf(piece);
  Operand other;
  if (context_.spelling == Spelling::International && readAddress(text, Spelling::German, other)) {
    sink_.report(Syntax::GermanSpelling, place,
                 fmt::format("\"{}\" is the German spelling of {}", name, toString(other)),
                 Fix{place, toString(other), true});
    return;
  }
  switch (result.fault) {
    case OperandFault::Constant:
      sink_.report(Syntax::BadConstant, place,
                   fmt::format("constant \"{}\" {}", name, faultText(result.constantFault)));
      break;
    case OperandFault::Pointer:
      sink_.report(Syntax::BadOperand, place,
                   fmt::format("\"{}\" is no pointer: pointers are kept in VD, LD or AC", name));
      break;
    case OperandFault::AddressOf:
      sink_.report(Syntax::BadOperand, place,
                   fmt::format("\"{}\": only bytes, words, timers and counters have an address", name));
      break;
    case OperandFault::Number:
      sink_.report(Syntax::BadOperand, place, fmt::format("the number of address \"{}\" is too large", name));
      break;
    default: sink_.report(Syntax::BadOperand, place, fmt::format("operand \"{}\" cannot be read", name)); break;
  }
}

}  // namespace rungproof
