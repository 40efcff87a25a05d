// One line of a statement list to one instruction. Accepts what printed and hand-written listings contain, and says
// so: blanks inside operands, glued mnemonics, look-alike characters (s7200 dialect notes 9.3). Tested by
// tests/reader/statement_test.cpp.
#pragma once

#include <array>
#include <string>
#include <unordered_set>
#include <vector>

#include "frontend/stl/mnemonic.hpp"
#include "frontend/stl/stl_lexer.hpp"
#include "frontend/stl/syntax_sink.hpp"

namespace rungproof {

enum class StatementKind : std::uint8_t {
  Instruction,
  Damaged,  ///< an instruction was made, but part of the line was dropped; reported
  Stray,    ///< text without comment sign; reported as a note
  Failed    ///< no instruction could be made; reported
};

class StatementReader {
 public:
  StatementReader(const SourceFile& file, SyntaxSink& sink, OperandContext context)
      : text_(file.text()), sink_(sink), context_(context) {}

  /// Reads a line that has at least one word.
  StatementKind read(const Line& line, Instruction& instruction);
  const OperandContext& context() const { return context_; }
  SyntaxSink& sink() { return sink_; }

 private:
  /// One operand as written; `joined` holds its text where words had to be put together.
  struct Piece {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
    bool afterComma = false;
    bool pointWasComma = false;
    std::string joined{};
  };

  std::string_view slice(std::uint32_t begin, std::uint32_t end) const { return text_.substr(begin, end - begin); }
  std::string_view textOf(const Piece& piece) const {
    return piece.joined.empty() ? slice(piece.begin, piece.end) : std::string_view(piece.joined);
  }
  const MnemonicResult& mnemonicOf(std::string_view word);
  StatementKind unknown(const Line& line);
  void gather(const Line& line, std::size_t firstWord);
  bool belongsTogether(const Piece& piece, std::string_view next) const;
  void joinDecimalCommas(const Desc& desc);
  bool dropStrayTail(const Line& line, std::size_t limit);
  bool readPiece(const Piece& piece, const Desc& desc, std::size_t index, Operand& operand);
  void reportUnreadable(const Piece& piece, const OperandResult& result);

  std::string_view text_;
  SyntaxSink& sink_;
  OperandContext context_;
  std::vector<Piece> pieces_;
  struct KnownWord {
    std::string_view word;
    MnemonicResult found;
  };
  std::array<KnownWord, 64> words_{};    ///< the last of each slot: a text has few mnemonics, over and over
  std::unordered_set<ShortText> names_;  ///< of operands, so that equal ones share their text
};

/// Least and greatest number of operands that the instruction takes in a statement list.
struct OperandLimits {
  std::size_t least = 0;
  std::size_t most = 0;
};
OperandLimits operandLimits(const Desc& desc);
/// The description that operand `index` follows; further parameters of CALL follow the last one.
const OperandDesc& operandDescOf(const Desc& desc, std::size_t index);

}  // namespace rungproof
