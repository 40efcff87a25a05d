// Evidence, line by line.
#include "frontend/step7/step7_likeness.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <unordered_map>

#include "frontend/step7/cursor.hpp"
#include "frontend/step7/source_keyword.hpp"
#include "frontend/stl/stl_lexer.hpp"
#include "ir/s7200/dialect.hpp"
#include "ir/s7300/dialect.hpp"

namespace rungproof::step7 {

namespace {

constexpr int mostLinesOfEvidence = 20000;
constexpr int wordsThatSettle = 16;  ///< of the S7-200 where none of the S7-300/400 was met

/// What one word at the beginning of a statement speaks for.
struct WordEvidence {
  bool isS7200 = false;                            ///< a mnemonic of the S7-200, in either set
  bool isGerman = false, isInternational = false;  ///< a mnemonic of the S7-300/400 in one set or in both
  bool isScan = false;                             ///< A, O and their kind
  bool isStructured = false;                       ///< a word of SCL

  bool isStep7() const { return isGerman || isInternational; }
};

/// Every mnemonic of both families.
const std::unordered_map<std::string_view, WordEvidence>& wordEvidence() {
  static const auto evidence = [] {
    std::unordered_map<std::string_view, WordEvidence> result;
    const auto firstWord = [](std::string_view mnemonic) { return mnemonic.substr(0, mnemonic.find(' ')); };  // NOP 0
    for (const Desc& desc : s7200Dialect.instructions().all())
      for (const std::string_view word : {desc.stl, desc.german})
        if (!word.empty()) result[firstWord(word)].isS7200 = true;
    for (const Desc& desc : s7300Dialect.instructions().all()) {
      result[firstWord(desc.stl)].isInternational = true;
      result[firstWord(desc.german.empty() ? desc.stl : desc.german)].isGerman = true;
    }
    for (const std::string_view scan : {"A", "AN", "O", "ON", "U", "UN"}) result[scan].isScan = true;
    for (const std::string_view word : {"IF", "ELSIF", "END_IF", "CASE", "END_CASE", "END_FOR", "WHILE", "END_WHILE"})
      result[word].isStructured = true;
    return result;
  }();
  return evidence;
}

std::string lettersInCapitals(std::string_view text) {
  std::string result(text);
  std::ranges::transform(result, result.begin(), upper);
  return result;
}

class EvidenceReader {
 public:
  Step7Likeness read(std::string_view text) {
    int lines = 0;
    for (std::size_t at = 0; at < text.size() && lines < mostLinesOfEvidence && !isSettled(); ++lines) {
      const std::size_t end = std::min(text.find('\n', at), text.size());
      std::string_view line = text.substr(at, end - at);
      line = line.substr(0, std::min(line.find("//"), line.find("(*")));
      lineOf(trimmed(line));
      at = end + 1;
    }
    return found_;
  }

 private:
  /// A source of the S7-300/400 shows itself in its first lines, by its heading if not by its statements.
  bool isSettled() const { return found_.s7200 >= wordsThatSettle && found_.step7 == 0 && !found_.hasHeading; }

  void lineOf(std::string_view line) {
    if (line.empty()) return;
    const std::string_view word = line.substr(0, wordLength(line));
    const std::string_view rest = trimmed(line.substr(word.size()));
    const SourceKeyword keyword = sourceKeywordOf(word);
    if (isOtherHeading(word, rest)) found_.otherHeading = true;
    if (opensBlock(keyword) || keyword == SourceKeyword::EndFunction || keyword == SourceKeyword::EndType)
      heading(keyword, rest);
    if (opensSection(keyword) || equalsWord(word, "STRUCT")) {
      ++declarations_;
    } else if (keyword == SourceKeyword::EndVar || keyword == SourceKeyword::EndStruct ||
               keyword == SourceKeyword::Begin) {
      declarations_ = keyword == SourceKeyword::Begin ? 0 : std::max(declarations_ - 1, 0);
    }
    if (opensBlock(keyword)) isCode_ = keyword != SourceKeyword::DataBlock && keyword != SourceKeyword::Type;
    if (declarations_ > 0 || keyword != SourceKeyword::None || equalsWord(word, "TITLE")) return;
    for (std::size_t at = 0; at < line.size();) {
      const std::size_t end = std::min(line.find(';', at), line.size());
      statement(trimmed(line.substr(at, end - at)), end < line.size());
      at = end + 1;
    }
  }

  static std::size_t wordLength(std::string_view line) {
    std::size_t length = 0;
    while (length < line.size() && isWordByte(line[length]) && blankLength(line, length) == 0) ++length;
    return length;
  }

  static bool isOtherHeading(std::string_view word, std::string_view rest) {
    if (equalsWord(word, "SUBROUTINE_BLOCK") || equalsWord(word, "INTERRUPT_BLOCK") ||
        equalsWord(word, "SYMBOL_TABLE") || equalsWord(word, "DATA_BLOCK_TAB"))
      return true;
    return equalsWord(word, "ORGANIZATION_BLOCK") && isNumberedName(rest);
  }

  /// MAIN:OB1, MAIN : OB 1; but not OB 1 VERSION : 0.1, a head on one line.
  static bool isNumberedName(std::string_view rest) {
    const std::size_t colon = rest.find(':');
    if (colon == std::string_view::npos) return false;
    const std::string_view before = trimmed(rest.substr(0, colon)), behind = trimmed(rest.substr(colon + 1));
    const bool isOneName = before.find_first_of(" \t") == std::string_view::npos;
    return isOneName || lettersInCapitals(behind.substr(0, 2)) == "OB";
  }

  /// DB 5: letters and number apart.
  static bool isNumberApart(std::string_view rest) {
    const std::string capitals = lettersInCapitals(rest);
    const std::string_view number = trimmed(std::string_view(capitals).substr(std::min<std::size_t>(2, rest.size())));
    return capitals.starts_with("DB ") && !number.empty() && number[0] >= '0' && number[0] <= '9' &&
           rest.find(':') == std::string_view::npos;
  }

  void heading(SourceKeyword keyword, std::string_view rest) {
    switch (keyword) {
      case SourceKeyword::Function:
      case SourceKeyword::FunctionBlock:
      case SourceKeyword::EndFunction: found_.hasHeading = true; break;
      case SourceKeyword::Type: found_.hasHeading = found_.hasHeading || !rest.empty(); break;
      case SourceKeyword::EndType: found_.hasHeading = true; break;
      case SourceKeyword::OrganizationBlock:
        // OB 100, OB 1 with a blank, or a name in marks; OB1 and MAIN:OB1 stand in exports of the other family too.
        if (!isNumberedName(rest) && (rest.starts_with('"') || lettersInCapitals(rest) != "OB1"))
          found_.hasHeading = true;
        break;
      case SourceKeyword::DataBlock:
        // DB 5 with a blank, and a structure behind it: data of the other family has neither.
        if (rest.starts_with('"') || isNumberApart(rest)) found_.hasHeading = true;
        break;
      default: break;
    }
  }

  /// name := value is no statement of a list. A parameter of a call stands in parentheses, or before one that closes.
  static bool isAssignment(std::string_view text) {
    int open = 0;
    bool assigns = false;
    for (std::size_t at = 0; at < text.size() && open >= 0; ++at) {
      open += text[at] == '(' ? 1 : text[at] == ')' ? -1 : 0;
      assigns = assigns || (open == 0 && text.substr(at, 2) == ":=");
    }
    return assigns && open == 0;
  }

  void statement(std::string_view text, bool isEnded) {
    if (text.empty()) return;
    // A label in front.
    const std::size_t colon = wordLength(text);
    if (colon > 0 && colon < text.size() && text[colon] == ':' && text.substr(colon, 2) != ":=")
      text = trimmed(text.substr(colon + 1));
    if (text.empty()) return;
    ++found_.statements;
    if (isCode_ && isEnded && isAssignment(text) && !equalsWord(text.substr(0, wordLength(text)), "CALL")) {
      ++found_.assignments;
      return;
    }
    std::size_t end = 0;
    while (end < text.size() && blankLength(text, end) == 0 && text[end] != '"' && text[end] != '#') ++end;
    const std::string first = lettersInCapitals(text.substr(0, end));
    std::string_view rest = trimmed(text.substr(end));
    if (first == "VERSION" || first == "STRUCT" || equalsWord(first, "KNOW_HOW_PROTECT")) {
      found_.step7 += rest.starts_with(':') || rest.empty() ? 1 : 0;
      return;
    }
    const auto known = wordEvidence().find(first);
    const WordEvidence word = known == wordEvidence().end() ? WordEvidence{} : known->second;
    if (word.isStructured) ++found_.structured;
    if (word.isScan) ++found_.scans;
    if (word.isStep7() && !word.isS7200) ++found_.step7;
    if ((word.isS7200 && !word.isStep7()) || isComparison(first)) ++found_.s7200;
    if (word.isGerman && !word.isInternational) ++found_.german;
    if (word.isInternational && !word.isGerman) ++found_.international;
    if (first == "CALL") {
      const std::string operand = lettersInCapitals(rest);
      const bool is7200 = operand.starts_with("SBR") || operand.starts_with("INT");
      const bool is7300 = operand.starts_with("FC") || operand.starts_with("FB") || operand.starts_with("SF") ||
                          operand.starts_with("#");
      found_.s7200 += is7200 ? 1 : 0;
      found_.step7 += is7300 ? 1 : 0;
    }
    // What a call gives its parameters.
    for (std::size_t at = text.find(":="); isCode_ && at != std::string_view::npos; at = text.find(":=", at + 2))
      operandOf(lettersInCapitals(trimmed(text.substr(at + 2, longestOperand))), first);
    const bool isGlued = end < text.size() && text[end] == '#' && end > 0 && isWordByte(text[end - 1]);  // W#5
    if (!isGlued) operandOf(lettersInCapitals(rest), first);
  }

  /// More letters than tell what an operand is; a call can have thousands of parameters behind it.
  static constexpr std::size_t longestOperand = 200;

  /// LDW=, AB>=, OR<>: compare contacts of the S7-200.
  static bool isComparison(std::string_view word) {
    const std::size_t sign = word.find_first_of("=<>");
    return sign != std::string_view::npos && sign >= 2 && (word[0] == 'L' || word[0] == 'A' || word[0] == 'O');
  }

  void operandOf(const std::string& rest, std::string_view first) {
    if (rest.empty() || first == "NETWORK") return;
    if (rest[0] == '"' || rest[0] == '\'') return;
    const std::string_view view = rest;
    const std::size_t digit = view.find_first_of("0123456789");
    const std::string letters(
        trimmed(view.substr(0, std::min(digit, view.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ% ")))));
    const bool hasNumber = digit != std::string_view::npos;
    const auto letterIs = [&](std::initializer_list<std::string_view> list) {
      return hasNumber && std::ranges::find(list, letters) != list.end();
    };
    if (letterIs({"DBX", "DBB", "DBW", "DBD", "DIX", "DIW", "PIW", "PIB", "PQW", "PQB", "PEW", "PAW"}) ||
        view.starts_with("W#16#") || view.starts_with("B#16#") || view.starts_with("DW#") || view.starts_with("S5T") ||
        view.starts_with("L#") || view.starts_with("P#") || view.starts_with("#") || view.starts_with("%") ||
        view.find("[AR") != std::string_view::npos)
      ++found_.step7;
    // E 0.0 behind a word of both families: the S7-200 writes letters and number together.
    const auto known = wordEvidence().find(first);
    const bool isOfBoth = known != wordEvidence().end() && known->second.isS7200 && known->second.isStep7();
    const bool isApart = isOfBoth && hasNumber && digit > 0 && view[digit - 1] == ' ';
    if (isApart && letterIs({"I",  "Q",  "M",  "E",  "A",  "IB", "QB", "MB", "EB", "AB",
                             "IW", "QW", "MW", "EW", "AW", "ID", "QD", "MD", "ED", "AD"}))
      ++found_.step7;
    if (letterIs({"V", "VB", "VW", "VD", "SM", "SMB", "SMW", "SMD", "AIW", "AQW", "AC", "HC", "SB", "VX"}) ||
        view.starts_with("*V") || view.starts_with("&V"))
      ++found_.s7200;
    if (letterIs({"E", "EB", "EW", "ED", "PEW", "PEB", "PAW", "PAB", "Z"})) ++found_.german;
    if (letterIs({"I", "IB", "IW", "ID", "Q", "QB", "QW", "QD", "PIW", "PIB", "PQW", "PQB", "C"}))
      ++found_.international;
    if (letterIs({"A", "AB", "AW", "AD"})) ++found_.german;
    if (letters == "BIE") ++found_.german;
    if (letters == "BR") ++found_.international;
  }

  Step7Likeness found_;
  bool isCode_ = false;   ///< inside a block that is no data block
  int declarations_ = 0;  ///< VAR and STRUCT that are open
};

}  // namespace

bool Step7Likeness::isStep7() const {
  if (hasHeading != otherHeading) return hasHeading;
  if (step7 != s7200) return step7 > s7200;
  return false;
}

Step7Likeness step7Likeness(std::string_view text) { return EvidenceReader().read(text); }

}  // namespace rungproof::step7
