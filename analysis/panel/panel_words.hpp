// Words of an operator panel or a network partner, as `external` lines and tag lists name them, and what the program
// does with them: whether it writes what the other side sets too, or reaches into a word of the other side with one of
// its own. Rule ADR012 and `xref --tags` ask here. Tested by tests/rules/panel_rules_test.cpp.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/flow/facts.hpp"

namespace rungproof {

/// A word, byte, double word or bit of the panel; or a row of bytes that it uses as it likes.
struct PanelWord {
  Operand address;          ///< of a row: its first byte
  std::uint32_t bytes = 1;  ///< that it covers
  bool isRow = false;       ///< declared as bytes, first to last: what the words in it are, the program tells
  bool isOfRange = false;   ///< one of several words, first to last, that were declared together
  TagAccess access = TagAccess::Sets;
  bool isText = false;
  std::string name{};  ///< of the tag, or empty
  Span declared{};     ///< empty: a setting

  bool isBit() const { return address.width == Width::Bit; }
};

/// All of them: declared ranges, tags, and symbols whose comment says that the panel sets them.
std::vector<PanelWord> panelWords(const Facts& facts);
/// Whether a name or comment speaks of a value that people set: setpoint, Sollwert, recipe.
bool speaksOfSetting(std::string_view text);

/// Two hands on one word.
struct SharedWord {
  Operand address;            ///< the panel's word
  const PanelWord* panel;     ///< its declaration
  const Instruction* writer;  ///< of the program
  const Instruction* reader;  ///< where the program expects the panel's value
};
/// A word of the program that reaches into one of the panel.
struct CrossingWord {
  Operand address;  ///< the panel's word
  const PanelWord* panel;
  const Access* use;  ///< of the program
};

struct PanelConflicts {
  std::vector<SharedWord> shared;
  std::vector<CrossingWord> crossing;
};
/// Each word of the panel once, in program order.
PanelConflicts panelConflicts(const Facts& facts, const std::vector<PanelWord>& words);

}  // namespace rungproof
