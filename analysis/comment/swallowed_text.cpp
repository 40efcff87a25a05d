// Looks for a place from which nothing but instructions follows, and weighs whether people would write it so.
#include "analysis/comment/swallowed_text.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

#include "ir/s7200/isa.hpp"

namespace rungproof {

namespace {

constexpr std::size_t longestMnemonic = 10;
/// Editors pad a mnemonic with blanks up to this column.
constexpr std::size_t paddedMnemonic = 7;

bool isGap(char c) { return c == ' ' || c == '\t' || c == '\r'; }
bool isNumeral(char c) { return c >= '0' && c <= '9'; }
bool isAsciiCapital(char c) { return c >= 'A' && c <= 'Z'; }
bool isAsciiLetter(char c) { return isAsciiCapital(c) || (c >= 'a' && c <= 'z'); }
bool isBeyondAscii(char c) { return static_cast<unsigned char>(c) >= 0x80; }
bool isPartOfName(char c) { return isAsciiLetter(c) || isNumeral(c) || c == '_' || isBeyondAscii(c); }
char asCapital(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

/// Instructions of one letter or sign, and contacts that may be words (ON, AN): prose and lists of points have them.
bool isLikeProse(const Desc& desc) {
  const bool isJoining = desc.role == Role::And || desc.role == Role::Or;
  return desc.stl.size() == 1 || (isJoining && desc.operands[0].type == Type::Bool);
}

struct FoundOperand {
  std::size_t length = 0;
  bool isAddress = false;
  bool isBit = false;  ///< a bit, a timer, a counter, or a name
};

struct FoundInstruction {
  const Desc* desc = nullptr;
  std::size_t begin = 0, end = 0;
  bool isPadded = false;  ///< as an editor writes it
};

/// Whether a mnemonic begins with that character, which few of a comment do.
bool mayBegin(char c) {
  static const std::array<bool, 256> begins = [] {
    std::array<bool, 256> result{};
    for (const Desc& desc : s7200Instructions().all()) {
      if (!desc.stl.empty()) result[static_cast<unsigned char>(desc.stl.front())] = true;
    }
    return result;
  }();
  return begins[static_cast<unsigned char>(c)];
}

class InstructionScanner {
 public:
  InstructionScanner(std::string_view text, const std::function<bool(std::string_view)>& isName)
      : text_(text), isName_(isName) {}

  /// An instruction with all its operands at that place. `anyCase`: small letters too.
  std::optional<FoundInstruction> instructionAt(std::size_t at, bool anyCase) const {
    if (at >= text_.size() || !mayBegin(anyCase ? asCapital(text_[at]) : text_[at])) return std::nullopt;
    std::size_t end = at;
    while (end < text_.size() && end - at <= longestMnemonic && !isGap(text_[end])) ++end;
    if (end - at > longestMnemonic) return std::nullopt;
    std::string name(text_.substr(at, end - at));
    if (anyCase) std::ranges::transform(name, name.begin(), asCapital);
    const Desc* desc = s7200Instructions().named(name);
    if (desc == nullptr || desc->drawingOnly || desc->control == Control::LabelMark) return std::nullopt;
    return operandsOf(*desc, at, end);
  }
  std::size_t behindBlanks(std::size_t at) const {
    while (at < text_.size() && isGap(text_[at])) ++at;
    return at;
  }

 private:
  std::optional<FoundInstruction> operandsOf(const Desc& desc, std::size_t begin, std::size_t at) const {
    FoundInstruction read{&desc, begin, at, false};
    if (desc.operandCount == 0) {
      const bool ends = at == text_.size() || isGap(text_[at]);
      return ends && desc.control == Control::None ? std::optional(read) : std::nullopt;
    }
    const std::size_t first = behindBlanks(at);
    if (first == at) return std::nullopt;
    const bool isColumn = isLikeProse(desc) ? first - begin == paddedMnemonic : first - at >= 3;
    read.isPadded = isColumn || text_.substr(at, first - at).find('\t') != std::string_view::npos;
    const std::size_t needed = static_cast<std::size_t>(std::count_if(
        desc.operands.begin(), desc.operands.begin() + desc.operandCount, [](const auto& o) { return !o.optional; }));
    bool hasAddress = false;
    std::size_t count = 0;
    for (std::size_t next = first;; ++count) {
      const auto operand = operandAt(next);
      if (!operand) return std::nullopt;
      if (count == 0 && desc.operands[0].type == Type::Bool && !operand->isBit) return std::nullopt;
      hasAddress = hasAddress || operand->isAddress;
      read.end = next + operand->length;
      next = behindBlanks(read.end);
      if (next == text_.size() || text_[next] != ',') break;
      next = behindBlanks(next + 1);
    }
    ++count;
    const bool fits = count >= needed && (count <= desc.operandCount || desc.control == Control::Call);
    return fits && hasAddress ? std::optional(read) : std::nullopt;
  }

  /// I0.0, VW10, *VD4, &VB0, T37, +50, 16#FF, 'AB', 1.5, or a name of the program.
  std::optional<FoundOperand> operandAt(std::size_t at) const {
    std::size_t i = at;
    if (i < text_.size() && (text_[i] == '*' || text_[i] == '&' || text_[i] == '%')) ++i;
    std::size_t letters = i;
    while (letters < text_.size() && isAsciiLetter(text_[letters])) ++letters;
    if (letters > i && letters - i <= 3 && letters < text_.size() && isNumeral(text_[letters])) {
      std::string area;
      for (std::size_t k = i; k < letters; ++k) area += asCapital(text_[k]);
      std::size_t end = letters;
      while (end < text_.size() && isNumeral(text_[end])) ++end;
      const bool hasBit = end + 1 < text_.size() && text_[end] == '.' && text_[end + 1] >= '0' && text_[end + 1] <= '7';
      if (hasBit) end += 2;
      if (isArea(area, hasBit)) return FoundOperand{end - at, true, hasBit || area == "T" || area == "C"};
    }
    if (i == at && !isNumeral(text_[at < text_.size() ? at : 0])) {
      std::size_t end = at;
      while (end < text_.size() && isPartOfName(text_[end])) ++end;
      if (end > at && isName_(text_.substr(at, end - at))) return FoundOperand{end - at, true, true};
    }
    return numberAt(at);
  }
  std::optional<FoundOperand> numberAt(std::size_t at) const {
    if (at < text_.size() && text_[at] == '\'') {
      const std::size_t close = text_.find('\'', at + 1);
      return close == std::string_view::npos ? std::nullopt : std::optional(FoundOperand{close + 1 - at});
    }
    std::size_t i = at;
    if (i < text_.size() && (text_[i] == '+' || text_[i] == '-')) ++i;
    const std::size_t digits = i;
    while (i < text_.size() && isNumeral(text_[i])) ++i;
    if (i == digits) return std::nullopt;
    if (i + 1 < text_.size() && text_[i] == '#') {
      ++i;
      while (i < text_.size() && (isNumeral(text_[i]) || (asCapital(text_[i]) >= 'A' && asCapital(text_[i]) <= 'F')))
        ++i;
    } else if (i + 1 < text_.size() && text_[i] == '.' && isNumeral(text_[i + 1])) {
      ++i;
      while (i < text_.size() && isNumeral(text_[i])) ++i;
    }
    return FoundOperand{i - at};
  }
  static bool isArea(std::string_view letters, bool hasBit) {
    if (letters == "SBR" || letters == "INT") return !hasBit;
    return std::ranges::any_of(areaTable, [&](const AreaInfo& area) {
      if (!letters.starts_with(area.name)) return false;
      const std::string_view rest = letters.substr(area.name.size());
      if (area.addressing == Addressing::Bytes)
        return hasBit ? rest.empty() : rest == "B" || rest == "W" || rest == "D";
      return !hasBit && (area.addressing == Addressing::Words ? rest == "W" : rest.empty());
    });
  }

  std::string_view text_;
  const std::function<bool(std::string_view)>& isName_;
};

/// Instructions from one place to the end of the text, a further comment, or the heading of a network.
struct FoundSequence {
  std::vector<FoundInstruction> instructions;
  bool isGlued = false;  ///< one begins where the operand before it ends
};

std::optional<FoundSequence> sequenceFrom(std::string_view text, const InstructionScanner& scanner, std::size_t at,
                                          bool anyCase);

/// The comment of a swallowed line may have swallowed the next one.
FoundSequence withFollowing(FoundSequence sequence, std::string_view text, const InstructionScanner& scanner,
                            std::size_t from) {
  for (std::size_t at = from; at < text.size(); ++at) {
    if (isAsciiCapital(text[at - 1]) || isGap(text[at])) continue;
    const auto rest = sequenceFrom(text, scanner, at, false);
    if (!rest) continue;
    sequence.instructions.insert(sequence.instructions.end(), rest->instructions.begin(), rest->instructions.end());
    return sequence;
  }
  return sequence;
}

std::optional<FoundSequence> sequenceFrom(std::string_view text, const InstructionScanner& scanner, std::size_t at,
                                          bool anyCase) {
  FoundSequence sequence;
  while (true) {
    const auto read = scanner.instructionAt(at, anyCase);
    if (!read) return std::nullopt;
    sequence.instructions.push_back(*read);
    at = scanner.behindBlanks(read->end);
    std::string_view rest = text.substr(at);
    if (rest.empty()) return sequence;
    if (rest.starts_with("//")) return withFollowing(std::move(sequence), text, scanner, at + 2);
    for (const std::string_view heading : {"NETWORK ", "Network ", "TITLE="}) {
      if (rest.starts_with(heading)) return sequence;
    }
    if (at == read->end) sequence.isGlued = true;
  }
}

/// Whether it cannot be what somebody has written about an instruction.
bool isSwallowed(const FoundSequence& sequence, std::string_view text, bool hasWords) {
  const auto& all = sequence.instructions;
  const bool isPadded = std::ranges::any_of(all, &FoundInstruction::isPadded);
  if (!hasWords) return all.size() > 1 && (isPadded || sequence.isGlued);
  const std::size_t begin = all.front().begin;
  const char before = text[begin - 1];
  const bool isJoined = !isGap(before) && (isPartOfName(before) || before == '.' || before == '!' || before == '?' ||
                                           before == ')' || before == '%');
  const bool isPlain = std::ranges::all_of(all, [](const auto& i) { return isLikeProse(*i.desc); });
  if (isPlain) return isPadded && all.size() > 1;
  if (isPadded || sequence.isGlued || isJoined) return true;
  std::size_t last = begin;
  while (last > 0 && isGap(text[last - 1])) --last;
  const bool isQuoted = last == 0 || !(isPartOfName(text[last - 1]) || text[last - 1] == '.');
  return all.size() > 1 && !isQuoted && all.front().desc->role == Role::Load && !isLogic(all.back().desc->role);
}

std::string withoutPadding(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (!isGap(c))
      result += c;
    else if (!result.empty() && result.back() != ' ')
      result += ' ';
  }
  return result;
}

}  // namespace

CommentText codeInComment(std::string_view comment, const std::function<bool(std::string_view)>& isName) {
  const InstructionScanner scanner(comment, isName);
  const auto found = [&](const FoundSequence& sequence, CommentedCode kind) {
    CommentText result{kind, sequence.instructions.front().begin};
    for (const FoundInstruction& read : sequence.instructions)
      result.instructions.push_back(withoutPadding(comment.substr(read.begin, read.end - read.begin)));
    return result;
  };
  std::size_t start = 0;
  while (start < comment.size() && (comment[start] == '/' || isGap(comment[start]))) ++start;
  if (start == comment.size()) return {};
  // "A valve" is no instruction even where a symbol has that name.
  const std::function<bool(std::string_view)> noName = [](std::string_view) { return false; };
  if (const auto whole = sequenceFrom(comment, InstructionScanner(comment, noName), start, true))
    return found(*whole, isSwallowed(*whole, comment, false) ? CommentedCode::Swallowed : CommentedCode::Disabled);
  for (std::size_t at = start + 1; at < comment.size(); ++at) {
    if (isAsciiCapital(comment[at - 1]) || isGap(comment[at]) || isBeyondAscii(comment[at])) continue;
    const auto rest = sequenceFrom(comment, scanner, at, false);
    if (rest && isSwallowed(*rest, comment, true)) return found(*rest, CommentedCode::Swallowed);
  }
  return {};
}

}  // namespace rungproof
