// Marks that other families have and the S7-200 has not.
#include "frontend/input/foreign_family.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "frontend/logger/trace_cell.hpp"
#include "frontend/stl/stl_lexer.hpp"

namespace rungproof {

namespace {

constexpr std::string_view exportIt = "export the program from its editor as text (.awl) or as PLCopen XML";
constexpr std::string_view onlyOurs =
    "rungproof reads programs of the S7-200, S7-200 SMART, S7-300 and S7-400, and IEC 61131-3 as text or PLCopen XML";
constexpr std::size_t mostLines = 400;  ///< that are looked at

struct Mark {
  std::string_view text;
  ForeignFamily family;
};

constexpr std::array<Mark, 6> containers = {{
    {"\xD0\xCF\x11\xE0", {"the project of an editor (such as .mwp of STEP 7-Micro/WIN)", exportIt}},
    {"PK\x03\x04", {"an archive or a packed project", "unpack it, or export the program from its editor as text"}},
    {"%PDF", {"a PDF document", exportIt}},
    {"{\\rtf", {"an RTF document", "save it as plain text"}},
    {"\x7F"
     "ELF",
     {"a program for computers", onlyOurs}},
    {"MZ\x90", {"a program for computers", onlyOurs}},
}};

constexpr std::array<Mark, 9> roots = {{
    {"RSLogix5000Content", {"L5X of Rockwell Studio 5000", onlyOurs}},
    {"TcPlcObject", {"a block of Beckhoff TwinCAT", onlyOurs}},
    {"TcPlcProject", {"a project of Beckhoff TwinCAT", onlyOurs}},
    {"FEFExchangeFile", {"an export of Schneider Control Expert (Unity Pro)", onlyOurs}},
    {"LDExchangeFile", {"an export of Schneider Control Expert (Unity Pro)", onlyOurs}},
    {"STExchangeFile", {"an export of Schneider Control Expert (Unity Pro)", onlyOurs}},
    {"FBDExchangeFile", {"an export of Schneider Control Expert (Unity Pro)", onlyOurs}},
    {"html", {"a web page", exportIt}},
    {"!DOCTYPE html", {"a web page", exportIt}},
}};

constexpr ForeignFamily scl = {"SCL (structured text of an S7-300, S7-400, S7-1200 or S7-1500)", onlyOurs};
constexpr ForeignFamily structuredText = {"structured text (IEC 61131-3)",
                                          "write the program as LD, FBD or IL in PLCopen XML, or as a statement list"};
constexpr ForeignFamily step7List = {"STL of an S7-300 or S7-400", "read it with --dialect s7-300 or s7-400"};
constexpr ForeignFamily logix = {"a program for Allen-Bradley controllers (XIC, OTE)", onlyOurs};
constexpr ForeignFamily melsec = {"an instruction list for Mitsubishi MELSEC (X and Y operands, K constants)",
                                  onlyOurs};
constexpr ForeignFamily omron = {"mnemonics of an Omron controller", onlyOurs};

/// What stands in the lines of a text.
struct Evidence {
  int lines = 0, semicolons = 0, assignments = 0, contactsOfLogix = 0, melsec = 0, omron = 0, s7200 = 0;
  bool hasBlock = false;    ///< FUNCTION_BLOCK, FUNCTION, VERSION :
  bool hasProgram = false;  ///< PROGRAM, END_PROGRAM
  bool hasNetwork = false;
  bool hasControl = false;  ///< IF ... THEN, CASE ... OF, END_IF
};

bool isIn(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::ranges::find(words, word) != words.end();
}

bool isNumbered(std::string_view word, std::string_view letters) {
  return word.size() > 1 && letters.find(word[0]) != std::string_view::npos && word[1] >= '0' && word[1] <= '9';
}

/// One line without its comment.
void look(std::string_view line, bool& isDeclaration, Evidence& found) {
  std::array<std::string, 3> words;
  std::size_t count = 0;
  for (std::size_t at = 0; at < line.size() && count < words.size();) {
    at = line.find_first_not_of(" \t\r", at);
    if (at == std::string_view::npos) break;
    const std::size_t end = std::min(line.find_first_of(" \t\r", at), line.size());
    words[count] = lowered(line.substr(at, end - at));
    ++count;
    at = end;
  }
  if (count == 0) return;
  const std::string& first = words[0];
  found.hasBlock = found.hasBlock ||
                   isIn(first, {"function_block", "function", "end_function", "end_function_block"}) ||
                   (first == "version" && words[1] == ":");
  found.hasProgram = found.hasProgram || isIn(first, {"program", "end_program", "configuration"});
  found.hasNetwork = found.hasNetwork || first.starts_with("network") || first == "netzwerk";
  found.hasControl = found.hasControl || isIn(first, {"end_if", "end_if;", "end_case", "end_case;", "end_for;"}) ||
                     (isIn(first, {"if", "elsif"}) && line.find("THEN") != std::string_view::npos);
  if (first.starts_with("var") || first == "struct") isDeclaration = true;
  if (first.starts_with("end_var") || first.starts_with("end_struct")) {
    isDeclaration = false;
    return;
  }
  if (isDeclaration || first.find('=') == 0 || first.starts_with("title")) return;
  ++found.lines;
  const std::size_t last = line.find_last_not_of(" \t\r");
  if (line[last] == ';') ++found.semicolons;
  if (line.find(":=") != std::string_view::npos) ++found.assignments;
  if (isIn(first, {"xic", "xio", "ote", "otl", "otu"}) || first.starts_with("xic(") || first.starts_with("xio(") ||
      first.starts_with("ote(") || first == "sor")
    ++found.contactsOfLogix;
  const bool isBit = isIn(first, {"ld", "ldi", "and", "ani", "or", "ori", "out", "set", "rst", "pls", "anb", "orb"});
  if (isBit && isNumbered(words[1], "xy") && words[1].find('.') == std::string::npos) ++found.melsec;
  if (first == "out" && isNumbered(words[2], "k")) ++found.melsec;
  if (isIn(first, {"ldnot", "andnot", "ornot", "tim", "cnt", "andld", "orld"}) ||
      (isIn(first, {"ld", "and", "or", "out"}) && !words[1].empty() && words[1][0] >= '0' && words[1][0] <= '9') ||
      (isIn(first, {"ld", "and", "or"}) && words[1] == "not"))
    ++found.omron;
  const bool isOfS7200 = !words[1].empty() && isNumbered(words[1], "iqmvstce") &&
                         (words[1].find('.') != std::string::npos || isNumbered(words[1], "stc"));
  if (isOfS7200) ++found.s7200;
}

std::optional<ForeignFamily> ofXml(std::string_view text) {
  for (std::size_t at = text.find('<'); at != std::string_view::npos; at = text.find('<', at + 1)) {
    const std::string_view rest = text.substr(at + 1);
    if (rest.starts_with('?') || rest.starts_with("!--")) continue;
    for (const Mark& root : roots) {
      if (rest.size() > root.text.size() && equalsIgnoringCase(rest.substr(0, root.text.size()), root.text))
        return root.family;
    }
    return std::nullopt;
  }
  return std::nullopt;
}

}  // namespace

std::optional<ForeignFamily> foreignContainer(std::string_view bytes) {
  const auto found = std::ranges::find_if(containers, [&](const Mark& mark) { return bytes.starts_with(mark.text); });
  return found == containers.end() ? std::nullopt : std::optional(found->family);
}

std::optional<ForeignFamily> foreignText(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return std::nullopt;
  if (text[first] == '<') return ofXml(text.substr(first, 4096));
  Evidence found;
  bool isDeclaration = false;
  std::size_t lines = 0;
  for (std::size_t at = 0; at < text.size() && lines < mostLines; ++lines) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    std::string_view line = text.substr(at, end - at);
    line = line.substr(0, std::min(line.find("//"), line.find("(*")));
    look(line, isDeclaration, found);
    at = end + 1;
  }
  const auto most = [&](int count) { return found.lines > 0 && count * 2 > found.lines; };
  if (found.hasControl && found.assignments > 0) return found.hasProgram ? structuredText : scl;
  if (found.hasProgram && (found.assignments > 0 || found.semicolons > 0)) return structuredText;
  if (most(found.semicolons) && found.assignments * 2 > found.semicolons) return found.hasBlock ? scl : structuredText;
  if (found.hasBlock || (found.hasNetwork && most(found.semicolons))) return step7List;
  if (most(found.contactsOfLogix)) return logix;
  if (found.melsec > 2 * found.s7200 && found.melsec >= 2 && most(found.melsec)) return melsec;
  if (found.s7200 == 0 && found.omron >= 2 && most(found.omron)) return omron;
  return std::nullopt;
}

}  // namespace rungproof
