// OBL001: an OB whose own local variables lie in its start information. Tested by its examples and
// tests/rules/step7_control_rules_test.cpp.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "analysis/flow/step7_blocks.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

constexpr std::uint32_t startBytes = 20;  // 002:2013-2015

/// Names as the editor gives them begin with the number of the block: OB1_SCAN_1, OB35_PRIORITY.
bool namesStartInformation(std::string_view name) {
  const auto isLetter = [&](std::size_t i, char letter) {
    return i < name.size() && std::toupper(static_cast<unsigned char>(name[i])) == letter;
  };
  std::size_t i = isLetter(0, 'O') && isLetter(1, 'B') ? 2 : 0;
  while (i > 0 && i < name.size() && std::isdigit(static_cast<unsigned char>(name[i])) != 0) ++i;
  if (i > 2) return true;
  static constexpr std::array<std::string_view, 6> parts = {"EV_CLASS", "PRIORITY",  "OB_NUMBR",
                                                            "RESERVED", "DATE_TIME", "SCAN_1"};
  return std::ranges::any_of(parts, [&](std::string_view part) { return name.find(part) != std::string_view::npos; });
}

/// TEMP0, TEMP12: what an upload calls variables whose names stand in no project.
bool isNameOfUpload(std::string_view name) {
  if (name.size() < 5) return false;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const auto c = static_cast<unsigned char>(name[i]);
    if (i < 4 ? std::toupper(c) != "TEMP"[i] : std::isdigit(c) == 0) return false;
  }
  return true;
}

/// Whether the declarations end the start information as it ends in every OB: by a DATE_AND_TIME at byte 12.
bool hasTimeOfStart(const Pou& pou) {
  return std::ranges::any_of(pou.locals, [](const LocalVariable& local) {
    return local.section == VarSection::Temp && local.type == DataType::DateAndTime &&
           local.address.offset == startBytes - 8;
  });
}

/// Whether the block writes below byte 20: the names of an upload do not tell, but nobody writes the start information.
bool writesStartInformation(const Facts& facts, std::uint32_t block) {
  for (const FlowStep& step : facts.plan().flows[block].steps) {
    for (const Access& access : facts.accesses().of(step.id())) {
      if (access.write && !access.viaPointer && access.area == Area::L && access.offset < startBytes) return true;
    }
  }
  return false;
}

void checkObl001(const Facts& facts, FindingSink& sink) {
  for (std::uint32_t block = 0; block < facts.program().pous.size(); ++block) {
    const Pou& pou = facts.program().pous[block];
    if (pou.type != BlockType::Ob || hasTimeOfStart(pou)) continue;
    const auto own = std::ranges::find_if(pou.locals, [](const LocalVariable& local) {
      const bool isStandIn = local.address.offset == 0 && local.size == startBytes;
      return local.section == VarSection::Temp && local.address.offset < startBytes && !isStandIn &&
             !namesStartInformation(local.name);
    });
    if (own == pou.locals.end()) continue;
    const bool areNamesLost = std::ranges::all_of(pou.locals, [](const LocalVariable& local) {
      return local.section != VarSection::Temp || isNameOfUpload(local.name) || namesStartInformation(local.name);
    });
    if (areNamesLost && !writesStartInformation(facts, block)) continue;
    Finding& finding =
        sink.report(own->span, fmt::format("{} of {} lies at byte {} of its local data, in the start information",
                                           own->name, pou.name, own->address.offset));
    finding.help = "declare the 20 bytes of the start information before the first own variable";
  }
}

}  // namespace

extern constexpr Rule obl001_start_information_covered = {
    .id = "OBL001",
    .title = "Own variables in the start information of an OB",
    .severity = Severity::Warning,
    .needs = Needs::Text,
    .detects =
        "a temporary variable of an OB below byte 20 whose name is none of the start information; not where a "
        "DATE_AND_TIME at byte 12 ends it; where all are called TEMP0, TEMP1 ... as after an upload, only if the block "
        "writes there",
    .why = "the operating system writes the first 20 bytes of the local data of every OB before it starts",
    .manual = "002:2000-2015",
    .bad =
        "ORGANIZATION_BLOCK OB 1\nVAR_TEMP\nOB1_EV_CLASS : BYTE;\nStep : INT;\nEND_VAR\nBEGIN\nNETWORK\nL 1;\n"
        "T #Step;\nEND_ORGANIZATION_BLOCK\n",
    .good =
        "ORGANIZATION_BLOCK OB 1\nVAR_TEMP\nOB1_START : ARRAY[0..19] OF BYTE;\nStep : INT;\nEND_VAR\nBEGIN\nNETWORK\n"
        "L 1;\nT #Step;\nEND_ORGANIZATION_BLOCK\n",
    .exampleCpu = "319-3",
    .dialects = dialect::S7300,
    .ofLists = true,
    .check = checkObl001,
};

}  // namespace rungproof
