// The function blocks of the standard, in its own language: frontend/iec/library has a file for each group of them.
#include <algorithm>
#include <cctype>
#include <utility>

#include "frontend/iec/iec_lowering.hpp"
#include "frontend/iec/library/bistable_blocks.hpp"
#include "frontend/iec/library/counter_blocks.hpp"
#include "frontend/iec/library/regulation_blocks.hpp"
#include "frontend/iec/library/timer_blocks.hpp"

namespace rungproof::iec {

namespace {

/// The decimal digits of a number, and a minus sign: what INT_TO_STRING and its kin make on every implementation.
constexpr std::string_view digits = R"(
FUNCTION __UNSIGNED_TEXT : STRING[11]
VAR_INPUT X : UDINT; END_VAR
VAR REST : UDINT; I : INT; MADE : STRING[11]; END_VAR
REST := X;
FOR I := 1 TO 10 DO
  IF I = 1 OR REST > 0 THEN
    MADE := CONCAT(MID('0123456789', 1, UDINT_TO_DINT(REST MOD 10) + 1), MADE);
    REST := REST / 10;
  END_IF;
END_FOR;
__UNSIGNED_TEXT := MADE;
END_FUNCTION

FUNCTION __SIGNED_TEXT : STRING[11]
VAR_INPUT X : DINT; END_VAR
IF X < 0 THEN __SIGNED_TEXT := CONCAT('-', __UNSIGNED_TEXT(DINT_TO_UDINT(-X)));
ELSE __SIGNED_TEXT := __UNSIGNED_TEXT(DINT_TO_UDINT(X));
END_IF;
END_FUNCTION
)";

/// Calls visit(group) for each group of blocks.
template <class Visit>
void eachGroup(Visit visit) {
  visit(library::BistableBlocks{});
  visit(library::CounterBlocks{});
  visit(library::TimerBlocks{});
  visit(library::RegulationBlocks{});
}

/// The names that the texts of a program mention. Most programs use few blocks, and reading the others takes longer
/// than reading such a program.
class Mentions {
 public:
  explicit Mentions(const SourceSet& sources) {
    for (std::size_t i = 0; i < sources.size() && !isLong(); ++i)
      add(sources.file(static_cast<std::uint32_t>(i)).text());
  }

  void add(std::string_view text) {
    for (const char c : text) text_ += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    text_ += ' ';
  }
  /// Whether the word stands somewhere. Of long texts it is taken for granted.
  bool has(std::string_view word) const {
    if (isLong()) return true;
    const auto isPart = [&](std::size_t at) {
      return at < text_.size() && (text_[at] == '_' || std::isalnum(static_cast<unsigned char>(text_[at])) != 0);
    };
    for (std::size_t at = text_.find(word); at != std::string::npos; at = text_.find(word, at + 1)) {
      if ((at == 0 || !isPart(at - 1)) && !isPart(at + word.size())) return true;
    }
    return false;
  }
  /// Whether a text of the program or of the library names it, as a part of another word too: STRING_TO_INT.
  bool hasPart(std::string_view part) const { return isLong() || text_.find(part) != std::string::npos; }

 private:
  bool isLong() const { return text_.size() > (1U << 16U); }

  std::string text_;  ///< in capitals
};

/// The declarations of the blocks that are mentioned, of those that these use, and of those that charts and drawings
/// use without naming them.
std::string wantedBlocks(Mentions& mentions) {
  const auto isWanted = [&](const std::string& name) {
    static constexpr std::string_view unnamed[] = {"TON", "R_TRIG", "F_TRIG"};
    return name.starts_with("__") || std::ranges::find(unnamed, name) != std::end(unnamed) || mentions.has(name);
  };
  std::string text, before;
  do {
    before = std::exchange(text, {});
    eachGroup([&](auto group) { group.addTo(text, isWanted); });
    mentions.add(text);
  } while (text.size() != before.size());
  return text;
}

}  // namespace

std::string libraryInput(const std::string& block, const std::string& folded) {
  struct Alias {
    std::string_view blocks, name, own;
  };
  static constexpr Alias aliases[] = {{"SR", "SET1", "S1"},   {"SR", "RESET", "R"},       {"RS", "SET", "S"},
                                      {"RS", "RESET1", "R1"}, {"CTU CTUD", "RESET", "R"}, {"CTD CTUD", "LOAD", "LD"}};
  const std::string base = foldedName(block.substr(0, block.find('_')));
  for (const Alias& alias : aliases) {
    const std::size_t at = alias.blocks.find(base);
    const std::size_t end = at + base.size();
    const bool isOf = at != std::string_view::npos && (at == 0 || alias.blocks[at - 1] == ' ') &&
                      (end == alias.blocks.size() || alias.blocks[end] == ' ');
    if (isOf && alias.name == folded) return std::string(alias.own);
  }
  return folded;
}

std::vector<std::string> libraryBlockNames() {
  std::vector<std::string> names;
  eachGroup([&](auto group) { group.nameTo(names); });
  return names;
}

void addStandardBlocks(Program& program, ProjectSyntax& project) {
  Mentions mentions(*program.sources);
  std::string text = wantedBlocks(mentions);
  if (mentions.hasPart("STRING")) text += digits;
  const std::uint32_t file = program.sources->add("blocks of IEC 61131-3", text);
  SyntaxSink sink(program, file);
  ProjectSyntax library;
  parseProject({program.sources->file(file).text(), file, 0, nullptr}, sink, library);
  for (BlockSyntax& block : library.blocks) {
    const bool isOwn = std::ranges::any_of(
        project.blocks, [&](const BlockSyntax& own) { return foldedName(own.name) == foldedName(block.name); });
    if (isOwn) continue;
    block.isLibrary = true;
    block.isContract = block.name == library::Clock::name;
    project.blocks.push_back(std::move(block));
  }
}

}  // namespace rungproof::iec
