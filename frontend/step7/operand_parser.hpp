// Operands of STEP 7 sources: addresses in either mnemonic set, with and without % and blanks, full addresses of data
// blocks, local and quoted names with their parts, constants, blocks, indirect forms (002:1622-1711).
// Tested by tests/step7/parser_test.cpp.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "frontend/step7/constant_parser.hpp"
#include "frontend/step7/syntax.hpp"

namespace rungproof::step7 {

/// How the text is to be read.
struct Spelling7 {
  MnemonicSet set = MnemonicSet::International;
  TextEncoding encoding = TextEncoding::Utf8;
};

/// What :P behind an address can mean.
inline constexpr std::string_view peripheralRule =
    ":P stands behind bytes, words and double words of inputs and outputs";

struct OperandOutcome {
  Operand operand;    ///< None: nothing stands there
  std::string fault;  ///< why what stands there is no operand
};

/// Reads an operand at the cursor, which stands behind it afterwards. `wantsLabel`: a bare word is a label, whatever
/// address it looks like.
OperandOutcome readOperand7(Cursor& cursor, const Spelling7& spelling, bool wantsLabel = false);
/// A block by number: FC 5, DB10. Nothing, and the cursor unmoved, if none stands there.
std::optional<BlockName> readBlockName(Cursor& cursor);
/// A name or text in quotation marks, or a word; nothing, and the cursor unmoved, if neither stands there.
std::optional<Name> readName(Cursor& cursor);
/// .part[1].part behind a name, appended to the path; the reason why it cannot be read, or empty.
std::string readParts(Cursor& cursor, std::vector<PathStep>& path);
/// [1,2] behind the last step of the path.
std::string readIndices(Cursor& cursor, std::vector<PathStep>& path);

}  // namespace rungproof::step7
