// ADR007: operands that overlap by part of their bytes, and words of which only the upper half is read. V, M, L, S and
// SM are one array of bytes seen at four widths. What lies wholly inside another operand is normal: the halves of a
// double word, the bits of a byte. Tested by its examples and tests/rules/address_rules_test.cpp.
#include <fmt/format.h>

#include <array>
#include <vector>

#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

/// First read and first write of a word or double word at one address.
struct Use {
  const Access* first = nullptr;
  const Access* write = nullptr;
};
/// By cell: words, double words; and bytes.
struct Uses {
  std::vector<std::array<Use, 3>> at;  ///< Byte, Word, DWord
};

std::size_t column(Width width) { return static_cast<std::size_t>(width) - 1; }

Uses collect(const Facts& facts) {
  const CellMap& cells = facts.index().cells();
  Uses uses;
  uses.at.resize(cells.size());
  for (const Access& access : facts.accesses().all()) {
    if (access.viaPointer || access.maybe || access.width == Width::Bit || access.byNumber() || access.most > 1 ||
        access.operand == impliedOperand)
      continue;
    if (access.area == Area::I || isAnalogue(access.area)) continue;
    const std::uint32_t cell = facts.cellOf(access);
    if (cell == cells.size()) continue;
    Use& use = uses.at[cell][column(access.width)];
    if (use.first == nullptr) use.first = &access;
    if (access.write && use.write == nullptr) use.write = &access;
  }
  return uses;
}

void reportOverlap(const Facts& facts, FindingSink& sink, const Access& low, const Access& high) {
  const Access& later = low.instruction > high.instruction ? low : high;
  const Access& earlier = &later == &low ? high : low;
  const Instruction& instruction = facts.instruction(later.instruction);
  const std::uint32_t shared = low.offset + low.certainLength() - high.offset;
  Finding& finding = sink.report(
      instruction.operands[later.operand].span,
      fmt::format("{} in {} shares {} with {} but is neither a part of it nor the whole", accessName(later),
                  Facts::text(instruction), shared == 1 ? std::string("one byte") : fmt::format("{} bytes", shared),
                  accessName(earlier)));
  finding.address = accessName(later);
  const Instruction& other = facts.instruction(earlier.instruction);
  finding.related.push_back(
      {other.operands[earlier.operand].span, fmt::format("{} is used here", accessName(earlier))});
  finding.help =
      "words need two bytes each and double words four: leave that distance between addresses (001:1272-1277)";
}

/// A word that only arithmetic or moves of words write, and of which nothing but the upper byte is ever read.
void reportUpperHalf(const Facts& facts, FindingSink& sink, const Uses& uses, std::uint32_t cell) {
  const Use& word = uses.at[cell][column(Width::Word)];
  const Use& upper = uses.at[cell][column(Width::Byte)];
  const CellMap& cells = facts.index().cells();
  if (word.write == nullptr || upper.first == nullptr || upper.write != nullptr || cell + 1 >= cells.size()) return;
  if (facts.index().isReadAtLarge(cell) || facts.index().isReadAtLarge(cell + 1) || facts.isExternal(cell)) return;
  for (const std::uint32_t c : {cell, cell + 1}) {
    for (const std::uint32_t i : facts.index().at(c)) {
      const Access& access = facts.accesses().all()[i];
      const bool isTheByte = access.width == Width::Byte && access.offset == word.write->offset && !access.write;
      const bool isTheWord = access.width == Width::Word && access.offset == word.write->offset && access.write;
      if (!isTheByte && !isTheWord) return;
    }
  }
  const Instruction& instruction = facts.instruction(upper.first->instruction);
  Finding& finding = sink.report(
      instruction.operands[upper.first->operand].span,
      fmt::format("{} reads {}, the upper byte of {}; the lower byte, which holds the values 0 to 255, is {}",
                  Facts::text(instruction), accessName(*upper.first), accessName(*word.write),
                  addressName(word.write->area, Width::Byte, word.write->offset + 1)));
  finding.address = accessName(*upper.first);
  finding.related.push_back({facts.instruction(word.write->instruction).span,
                             fmt::format("{} is written as a word here", accessName(*word.write))});
  finding.help = "the lower address holds the more significant byte (001:14372)";
}

void checkAdr007(const Facts& facts, FindingSink& sink) {
  const Uses uses = collect(facts);
  const CellMap& cells = facts.index().cells();
  for (std::uint32_t cell = 0; cell < cells.size(); ++cell) {
    for (const Width width : {Width::Word, Width::DWord}) {
      const Use& low = uses.at[cell][column(width)];
      if (low.first == nullptr) continue;
      const auto length = static_cast<std::uint32_t>(bytes(width));
      for (std::uint32_t distance = 1; distance < length && cell + distance < cells.size(); ++distance) {
        for (const Width otherWidth : {Width::Word, Width::DWord}) {
          const Use& high = uses.at[cell + distance][column(otherWidth)];
          if (high.first == nullptr || high.first->area != low.first->area ||
              high.first->offset != low.first->offset + distance)
            continue;
          const bool isInside = distance + static_cast<std::uint32_t>(bytes(otherWidth)) <= length;
          if (isInside || (low.write == nullptr && high.write == nullptr)) continue;
          reportOverlap(facts, sink, *low.first, *high.first);
        }
      }
    }
    reportUpperHalf(facts, sink, uses, cell);
  }
}

}  // namespace

extern constexpr Rule adr007_one_byte_two_meanings = {
    .id = "ADR007",
    .title = "One byte, two meanings",
    .severity = Severity::Warning,
    .needs = Needs::Flow,
    .detects =
        "two word or double word operands that overlap by a part of their bytes (VW100 and VW101), one of them "
        "written; a word of which "
        "only the upper byte is read",
    .why =
        "V, M, L, S and SM are one array of bytes seen at four widths; there are no declarations which would show the "
        "overlap",
    .manual = "001:1272-1277",
    .bad = "Network 1\nLD SM0.0\nMOVW +1, VW100\nMOVW +2, VW101\n",
    .good = "Network 1\nLD SM0.0\nMOVW +1, VW100\nMOVW +2, VW102\n",
    .falsePositives = "byte arithmetic by words at odd addresses, on purpose: silence it at the place",
    .peers = "SA0028; CP4",
    .dialects = dialect::S7200,
    .check = checkAdr007,
};

}  // namespace rungproof
