// Blocks of the IEC 61131-3 library. Each is one struct with its name and its text in ST; a group of them is one file.
// In these texts `__READING('key', 'value')` is TRUE where that reading of an open point is in force.
// Tested by tests/iec/library_test.cpp.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <vector>

namespace rungproof::iec::library {

/// The types of numbers in which counters come.
struct Width {
  std::string_view suffix, type, greatest, least;
};
inline constexpr Width widths[] = {
    {"", "INT", "32767", "-32768"},
    {"_INT", "INT", "32767", "-32768"},
    {"_DINT", "DINT", "2147483647", "-2147483648"},
    {"_UDINT", "UDINT", "4294967295", "0"},
    {"_UINT", "UINT", "65535", "0"},
    {"_LINT", "LINT", "9223372036854775807", "-9223372036854775807 - 1"},
    {"_ULINT", "ULINT", "18446744073709551615", "0"},
};

/// A block that comes in several widths: {0} what follows its name, {1} type of PV and CV, {2} its greatest, {3} its
/// least number.
template <class Block>
concept ComesInWidths = requires {
  Block::isForEachWidth;
};

template <class... Blocks>
struct Group {
  /// Appends the declarations of the blocks of whose names `isWanted` is true.
  template <class IsWanted>
  static void addTo(std::string& text, const IsWanted& isWanted) {
    (add<Blocks>(text, isWanted), ...);
  }
  /// What the blocks are called, those that a program may declare.
  static void nameTo(std::vector<std::string>& names) { (name<Blocks>(names), ...); }

 private:
  template <class Block, class IsWanted>
  static void add(std::string& text, const IsWanted& isWanted) {
    if constexpr (ComesInWidths<Block>) {
      for (const Width& width : widths) {
        if (isWanted(std::string(Block::name) + std::string(width.suffix)))
          text += fmt::format(fmt::runtime(Block::text), width.suffix, width.type, width.greatest, width.least);
      }
    } else if (isWanted(std::string(Block::name))) {
      text += Block::text;
    }
  }
  template <class Block>
  static void name(std::vector<std::string>& names) {
    if (Block::name.starts_with("__")) return;
    if constexpr (ComesInWidths<Block>) {
      for (const Width& width : widths) names.push_back(std::string(Block::name) + std::string(width.suffix));
    } else {
      names.emplace_back(Block::name);
    }
  }
};

}  // namespace rungproof::iec::library
