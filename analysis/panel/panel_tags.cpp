// Asks the access lists about every tag.
#include "analysis/panel/panel_tags.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>

#include "analysis/flow/place_rows.hpp"
#include "analysis/panel/panel_words.hpp"

namespace rungproof {

namespace {

/// Width of what a panel shows; nothing for texts and types that are not known.
std::optional<Width> widthOfTag(TagType type) {
  switch (type) {
    case TagType::Bool: return Width::Bit;
    case TagType::Byte: return Width::Byte;
    case TagType::Unsigned16:
    case TagType::Signed16: return Width::Word;
    case TagType::Unsigned32:
    case TagType::Signed32:
    case TagType::Real: return Width::DWord;
    default: return std::nullopt;
  }
}

std::string_view tagWidthText(Width width) {
  switch (width) {
    case Width::Bit: return "a bit";
    case Width::Byte: return "a byte";
    case Width::Word: return "a word";
    default: return "a double word";
  }
}

/// How the program takes a double word: as REAL, as a whole number, or without saying.
enum class Taken : std::uint8_t { Unsaid, Real, Whole };
Taken takenAs(const Instruction& instruction, const Access& access) {
  const Desc& desc = *instruction.desc;
  if (desc.control == Control::Call || access.operand >= desc.operandCount) return Taken::Unsaid;
  const Type type = desc.operands[access.operand].type;
  if (type == Type::Real) return Taken::Real;
  return type == Type::DInt ? Taken::Whole : Taken::Unsaid;
}

class TagCheck {
 public:
  TagCheck(const Facts& facts, const std::vector<RetentiveRange>& retentive)
      : facts_(facts), retentive_(retentive), words_(panelWords(facts)), conflicts_(panelConflicts(facts, words_)) {}

  TagReport report(const PanelTag& tag) const {
    TagReport report{&tag};
    const Operand& address = tag.address;
    const CellMap& cells = facts_.index().cells();
    const std::uint32_t cell = cells.cell(address.area, address.offset, 0);
    const bool byNumber = addressedByNumber(address.area);
    const auto length = static_cast<std::uint32_t>(byNumber ? 1 : bytes(address.width));
    if (cell == cells.size() || address.offset + length > cells.length(address.area)) {
      add(report, TagFault::Missing, fmt::format("the CPU {} has no {}", cpuName(facts_.target().cpu), nameOf(tag)));
      return report;
    }
    const std::vector<const Access*> uses = usesOf(address, cell, length);
    for (const Access* use : uses) ++(use->write ? report.writers : report.readers);
    width(report, uses, cell, length);
    if (uses.empty()) {
      bool isReached = false;
      for (std::uint32_t k = 0; k < length; ++k)
        isReached = isReached || facts_.index().mayBeRead(cell + k) || facts_.index().mayBeWritten(cell + k);
      if (!isReached && !facts_.hasHiddenCode())
        add(report, TagFault::Unused, fmt::format("no instruction uses {}", nameOf(tag)));
      return report;
    }
    type(report, uses);
    masters(report);
    power(report, uses);
    return report;
  }

 private:
  static std::string nameOf(const PanelTag& tag) { return toString(tag.address); }
  static void add(TagReport& report, TagFault fault, std::string message, const Instruction* place = nullptr) {
    report.problems.push_back({fault, std::move(message), place});
  }

  std::vector<const Access*> usesOf(const Operand& address, std::uint32_t cell, std::uint32_t length) const {
    const PlaceRow row = rowOf(address);
    std::vector<const Access*> uses;
    std::set<std::uint32_t> seen;
    for (std::uint32_t k = 0; k < length; ++k) {
      for (const std::uint32_t i : facts_.index().at(cell + k)) {
        const Access& access = facts_.access(i);
        if (meet(row, rowOf(access)) && seen.insert(i).second) uses.push_back(&access);
      }
    }
    std::ranges::sort(uses, {}, &Access::instruction);
    return uses;
  }

  void width(TagReport& report, const std::vector<const Access*>& uses, std::uint32_t cell,
             std::uint32_t length) const {
    const PanelTag& tag = *report.tag;
    const Operand& address = tag.address;
    if (addressedByNumber(address.area)) return;
    const std::optional<Width> wanted = widthOfTag(tag.type);
    if (wanted && *wanted != address.width) {
      return add(report, TagFault::Width,
                 fmt::format("{} is {}, but the type {} takes {}", nameOf(tag), tagWidthText(address.width),
                             tag.typeText, tagWidthText(*wanted)));
    }
    if (address.width == Width::Bit || tag.type == TagType::Text) return;
    // The program's own word there has another width, and no instruction takes the panel's.
    const Access* other = nullptr;
    for (const Access* use : uses) {
      if (use->width == address.width && use->offset == address.offset) return;
      if (use->width != Width::Bit && use->most == 1) other = other == nullptr ? use : other;
    }
    if (other == nullptr) return;
    const std::uint32_t from = other->offset, to = from + other->certainLength();
    const bool isLowPart = from < address.offset && to == address.offset + length;
    bool isPacked = to < address.offset + length || from > address.offset;
    for (std::uint32_t k = 0; k < length && isPacked; ++k) isPacked = !facts_.index().at(cell + k).empty();
    if (isLowPart || isPacked) return;
    const Instruction& instruction = facts_.instruction(other->instruction);
    add(report, TagFault::Width,
        fmt::format("the tag takes {} at {}, the program {}: {}", tagWidthText(address.width), nameOf(tag),
                    accessName(*other), Facts::text(instruction)),
        &instruction);
  }

  void type(TagReport& report, const std::vector<const Access*>& uses) const {
    const PanelTag& tag = *report.tag;
    if (tag.address.width != Width::DWord || tag.type == TagType::Unknown || tag.type == TagType::Text) return;
    const Instruction *real = nullptr, *whole = nullptr;
    for (const Access* use : uses) {
      if (use->width != Width::DWord || use->offset != tag.address.offset || use->viaPointer) continue;
      const Instruction& instruction = facts_.instruction(use->instruction);
      const Taken taken = takenAs(instruction, *use);
      if (taken == Taken::Real) real = &instruction;
      if (taken == Taken::Whole) whole = &instruction;
    }
    if (tag.type == TagType::Real && whole != nullptr && real == nullptr)
      add(report, TagFault::Type,
          fmt::format("the tag takes {} as REAL, the program as a whole number: {}", nameOf(tag), Facts::text(*whole)),
          whole);
    if (tag.type != TagType::Real && real != nullptr && whole == nullptr)
      add(report, TagFault::Type,
          fmt::format("the tag takes {} as a whole number, the program as REAL: {}", nameOf(tag), Facts::text(*real)),
          real);
  }

  void masters(TagReport& report) const {
    const std::string name = nameOf(*report.tag);
    for (const SharedWord& word : conflicts_.shared) {
      if (toString(word.address) != name) continue;
      return add(report, TagFault::TwoMasters,
                 fmt::format("panel and program both set {}: {}", name, Facts::text(*word.writer)), word.writer);
    }
  }

  /// A number that the operator sets: the program reads it and does not set it itself.
  void power(TagReport& report, const std::vector<const Access*>& uses) const {
    const PanelTag& tag = *report.tag;
    const Operand& address = tag.address;
    const bool isNumber = address.width != Width::Bit && isMemoryArea(address.area);
    if (!isNumber || tag.access == TagAccess::Reads || tag.type == TagType::Text) return;
    bool isRead = false;
    for (const Access* use : uses) {
      isRead = isRead || !use->write;
      if (!use->write) continue;
      const Instruction& instruction = facts_.instruction(use->instruction);
      const bool isStart = (facts_.conditionOf(instruction.id) & condition::FirstScan) != 0;
      const bool isLimit = roleOf(instruction) == Role::Move && instruction.operands[0].kind == OperandKind::Constant &&
                           (facts_.stack().at(instruction.id).flow & condition::Always) == 0;
      if (isStart || !isLimit) return;  // the program gives it its value
    }
    if (!isRead) return;
    for (std::uint32_t k = 0; k < static_cast<std::uint32_t>(bytes(address.width)); ++k) {
      if (isRetentive(retentive_, address.area, address.offset + k)) continue;
      const bool isInData = std::ranges::any_of(facts_.program().data, [&](const DataInit& init) {
        return address.area == Area::V && init.offset <= address.offset &&
               address.offset < init.offset + init.bytes.size();
      });
      return add(report, TagFault::NotRetentive,
                 fmt::format("{} is set by the operator and not retentive: after a power failure it is {}", nameOf(tag),
                             isInData ? "as in the data block" : "0"));
    }
  }

  const Facts& facts_;
  const std::vector<RetentiveRange>& retentive_;
  const std::vector<PanelWord> words_;
  const PanelConflicts conflicts_;
};

}  // namespace

std::string_view tagFaultName(TagFault fault) {
  switch (fault) {
    case TagFault::Missing: return "missing";
    case TagFault::Unused: return "unused";
    case TagFault::Width: return "width";
    case TagFault::Type: return "type";
    case TagFault::TwoMasters: return "two masters";
    default: return "not retentive";
  }
}

std::vector<TagReport> tagReports(const Facts& facts, const std::vector<RetentiveRange>& retentive) {
  const TagCheck check(facts, retentive);
  std::vector<TagReport> reports;
  for (const PanelTag& tag : facts.surroundings().tags) reports.push_back(check.report(tag));
  return reports;
}

}  // namespace rungproof
