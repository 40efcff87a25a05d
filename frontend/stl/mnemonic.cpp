// Look-up of mnemonics with the liberties that printed and hand-written listings take.
#include "frontend/stl/mnemonic.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "frontend/files/closest_word.hpp"
#include "frontend/stl/stl_lexer.hpp"

namespace rungproof {

namespace {

constexpr std::size_t longestMnemonic = 10;  // BLKMOV_BIR

std::string capitals(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(), upper);
  return result;
}

const Desc* lookUp(std::string_view name, Spelling spelling) {
  if (spelling == Spelling::German) {
    if (const Desc* desc = s7200Instructions().namedGerman(name)) return desc;
  }
  return s7200Instructions().named(name);
}

/// Comparison signs of printed text and markup.
constexpr std::array<std::pair<std::string_view, std::string_view>, 8> signs = {{{"\\geq", ">="},
                                                                                 {"\\leq", "<="},
                                                                                 {"\\neq", "<>"},
                                                                                 {"&gt;", ">"},
                                                                                 {"&lt;", "<"},
                                                                                 {"\xE2\x89\xA5", ">="},
                                                                                 {"\xE2\x89\xA4", "<="},
                                                                                 {"\xE2\x89\xA0", "<>"}}};

/// Length of a comparison sign at the start of `text` and its plain spelling.
std::size_t signLength(std::string_view text, std::string& plain) {
  std::size_t length = 0;
  plain.clear();
  while (length < text.size() && plain.size() < 2) {
    const std::string_view rest = text.substr(length);
    if (rest[0] == '<' || rest[0] == '>' || rest[0] == '=') {
      plain += rest[0];
      ++length;
      continue;
    }
    const auto found = std::find_if(signs.begin(), signs.end(),
                                    [&](const auto& row) { return rest.substr(0, row.first.size()) == row.first; });
    if (found == signs.end()) break;
    plain += found->second;
    length += found->first.size();
  }
  return length;
}

/// Whether `rest` can be the first operand of an instruction whose mnemonic it is glued to.
bool canFollow(const Desc& desc, std::string_view rest, const OperandContext& context) {
  if (desc.operandCount == 0) return false;
  const OperandDesc& operand = desc.operand(0);
  const bool isBit = operand.type == Type::Bool && (operand.forms & form::Const) == 0;
  OperandResult result = readOperand(rest, context);
  if (result.fault == OperandFault::None && !(isBit && result.operand.kind == OperandKind::Constant)) {
    if (result.operand.kind == OperandKind::Symbol) return rest[0] == '*' || rest[0] == '&' || rest[0] == '#';
    if (result.operand.kind == OperandKind::Text || result.operand.kind == OperandKind::Missing) return true;
    const bool isBitAddress = result.operand.kind == OperandKind::Direct && result.operand.width == Width::Bit;
    return !isBit || isBitAddress;
  }
  return isBit && !mendedOperand(rest, context.spelling, true).empty();
}

/// Letters and digits exchanged by their look-alikes: "+1" is +I, "RET1" is RETI, "0LD" is OLD.
const Desc* lookUpLookAlike(std::string_view word, Spelling spelling) {
  std::string name = capitals(plainCharacters(word));
  if (const Desc* desc = lookUp(name, spelling)) return desc;
  for (char& c : name) {
    if (c == '1' || c == '|') c = 'I';
    if (c == '0') c = 'O';
  }
  if (const Desc* desc = lookUp(name, spelling)) return desc;
  name = plainCharacters(word);
  for (char& c : name) c = c == '1' || c == '|' ? 'L' : c == '0' ? 'O' : upper(c);
  return lookUp(name, spelling);
}

}  // namespace

MnemonicResult findMnemonic(std::string_view word, const OperandContext& context) {
  if (word.empty()) return {};
  if (word.size() <= longestMnemonic) {
    std::array<char, longestMnemonic> buffer{};
    std::transform(word.begin(), word.end(), buffer.begin(), upper);
    const std::string_view name(buffer.data(), word.size());
    if (const Desc* desc = lookUp(name, context.spelling)) return {desc, MnemonicMatch::Exact, word.size()};
    if (const Desc* desc = s7200Instructions().alias(name)) return {desc, MnemonicMatch::LadderName, word.size()};
  }
  if (word.size() <= 3 * longestMnemonic) {
    if (const Desc* desc = lookUpLookAlike(word, context.spelling))
      return {desc, MnemonicMatch::LookAlike, word.size()};
  }
  for (std::size_t length = std::min(longestMnemonic, word.size() - 1); length > 0; --length) {
    const Desc* desc = lookUp(capitals(word.substr(0, length)), context.spelling);
    if (desc != nullptr && canFollow(*desc, word.substr(length), context)) return {desc, MnemonicMatch::Exact, length};
  }
  for (std::size_t length = std::min(longestMnemonic, word.size() - 1); length > 1; --length) {
    const Desc* desc = lookUpLookAlike(word.substr(0, length), context.spelling);
    if (desc != nullptr && canFollow(*desc, word.substr(length), context))
      return {desc, MnemonicMatch::LookAlike, length};
  }
  // A sign of printed text inside the word: LDW≥VW0.
  for (std::size_t length = 1; length <= 3 && length < word.size(); ++length) {
    const MnemonicResult comparison = findComparison(word.substr(0, length), word.substr(length), context);
    if (comparison.desc != nullptr) return {comparison.desc, MnemonicMatch::LookAlike, length + comparison.length};
  }
  return {};
}

MnemonicResult findComparison(std::string_view word, std::string_view next, const OperandContext& context) {
  constexpr std::string_view firstOfSigns = "<>=\\&\xE2";
  if (word.size() > 3 || next.empty() || firstOfSigns.find(next[0]) == std::string_view::npos) return {};
  std::string sign;
  const std::size_t length = signLength(next, sign);
  if (length == 0) return {};
  const Desc* desc = lookUp(capitals(word) + sign, context.spelling);
  if (desc == nullptr || sign.empty()) return {};
  return {desc, MnemonicMatch::Exact, length};
}

std::string_view nearestMnemonic(std::string_view word) {
  if (word.empty() || word.size() > longestMnemonic + 2) return {};
  const std::string name = capitals(word);
  std::string_view best;
  std::size_t bestDistance = name.size() <= 3 ? 2 : 3;
  for (const Desc& desc : s7200Instructions().all()) {
    const std::size_t longer = std::max(name.size(), desc.stl.size());
    if (desc.drawingOnly || 2 * longer - name.size() - desc.stl.size() >= bestDistance) continue;
    const std::size_t distance = editDistance(name, desc.stl);
    if (distance < bestDistance && distance < name.size()) {
      bestDistance = distance;
      best = desc.stl;
    }
  }
  return best;
}

std::string_view nearestHeading(std::string_view word) {
  if (word.size() < 2 || word.size() > 4) return {};
  for (const std::string_view heading : {std::string_view("SBR"), std::string_view("INT")}) {
    if (editDistance(capitals(word), heading) == 1) return heading;
  }
  return {};
}

std::string_view familyOfForeignInstruction(std::string_view word) {
  static constexpr std::array<std::string_view, 1> smart = {"RTUM"};
  static constexpr std::array<std::string_view, 33> s7300 = {
      "L",   "T",   "X",   "XN",  "FP",   "FN",   "SET", "CLR", "SAVE", "JU",   "JC",
      "JCN", "JCB", "JNB", "SPB", "SPBN", "SPBI", "BE",  "BEC", "BEU",  "BEA",  "BEB",
      "OPN", "AUF", "SP",  "SE",  "SD",   "SS",   "SF",  "UC",  "CC",   "LAR1", "LAR2"};
  const std::string name = capitals(word.substr(0, longestMnemonic));
  if (std::find(smart.begin(), smart.end(), name) != smart.end()) return "S7-200 SMART";
  if (std::find(s7300.begin(), s7300.end(), name) != s7300.end()) return "S7-300/400";
  return {};
}

}  // namespace rungproof
