// The table of blocks at a look.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "frontend/compared_block.hpp"

namespace rungproof {

namespace {

constexpr std::array<std::string_view, 7> likenessNames = {"same",        "same statements", "other values", "changed",
                                                           "only in OLD", "only in NEW",     "not read"};
constexpr std::size_t widestLine = 100;
constexpr std::string_view indent = "                   ";

/// Names one after the other, in lines of that width.
std::string wrappedNames(const std::vector<std::string>& words, std::string_view between) {
  std::string text;
  std::size_t column = indent.size();
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string word = words[i] + std::string(i + 1 < words.size() ? between : "");
    if (column + word.size() > widestLine && column > indent.size()) {
      while (text.ends_with(' ')) text.pop_back();
      text += fmt::format("\n{}", indent);
      column = indent.size();
    }
    text += word;
    column += word.size();
  }
  return text;
}

std::string detailsOf(const ComparedBlock& block) {
  constexpr std::size_t mostValues = 8;
  std::vector<std::string> parts = block.networks;
  parts.insert(parts.end(), block.values.begin(),
               block.values.begin() + static_cast<std::ptrdiff_t>(std::min(mostValues, block.values.size())));
  if (block.values.size() > mostValues) parts.push_back(fmt::format("and {} more", block.values.size() - mostValues));
  if (!block.why.empty()) parts.push_back(block.why);
  return parts.empty() ? block.name : fmt::format("{}  {}", block.name, wrappedNames(parts, ", "));
}

}  // namespace

std::string_view likenessName(BlockLikeness likeness) { return likenessNames[static_cast<std::size_t>(likeness)]; }

std::string comparedBlocksText(const std::vector<ComparedBlock>& blocks) {
  if (blocks.empty()) return {};
  const auto count = [&](auto isCounted) { return std::ranges::count_if(blocks, isCounted); };
  const auto lacks = [](BlockLikeness likeness) {
    return [likeness](const ComparedBlock& block) { return block.likeness != likeness; };
  };
  std::string text = fmt::format("blocks: {} of OLD, {} of NEW\n", count(lacks(BlockLikeness::OnlyNew)),
                                 count(lacks(BlockLikeness::OnlyOld)));
  for (std::size_t i = 0; i < likenessNames.size(); ++i) {
    const auto likeness = static_cast<BlockLikeness>(i);
    const bool isPlain = likeness == BlockLikeness::Same || likeness == BlockLikeness::SameStatements ||
                         likeness == BlockLikeness::OnlyOld || likeness == BlockLikeness::OnlyNew;
    std::vector<std::string> names;
    for (const ComparedBlock& block : blocks) {
      if (block.likeness != likeness) continue;
      if (isPlain)
        names.push_back(block.name);
      else
        text += fmt::format("  {:<16} {}\n", likenessNames[i], detailsOf(block));
    }
    if (names.empty()) continue;
    text += fmt::format("  {:<16} {}{}\n", likenessNames[i], names.size() > 8 ? fmt::format("{}: ", names.size()) : "",
                        wrappedNames(names, " "));
  }
  return text;
}

}  // namespace rungproof
