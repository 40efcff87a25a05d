// INT004: a word or double word that an interrupt routine writes and the scan reads by more than one access, so that
// the interrupt may come between them; or a byte, word or double word that the scan copies, changes and writes back, so
// that what an interrupt writes into it in between is lost (001:5438: intermediate results must not be kept in shared
// memory). One instruction is atomic (001:5439); code between DISI and ENI is protected.
// Tested by its examples and tests/rules/control_rules_test.cpp.
#include <fmt/format.h>

#include <vector>

#include "analysis/flow/facts.hpp"
#include "analysis/flow/protected_code.hpp"
#include "analysis/rule.hpp"

namespace rungproof {

namespace {

bool isWide(const Access& access) { return access.width == Width::Word || access.width == Width::DWord; }

/// Whether the instruction takes over a whole value that stands somewhere else.
bool isCopy(const Instruction& instruction) {
  return roleOf(instruction) == Role::Move && !instruction.operands.empty() &&
         instruction.operands[0].kind != OperandKind::Constant;
}

/// Copied, changed and written back.
void findLostUpdates(const Facts& facts, const std::vector<std::uint8_t>& isProtected, FindingSink& sink) {
  const CellMap& cells = facts.index().cells();
  std::uint32_t lastReported = ~0U;
  for (std::uint32_t cell = 0; cell < cells.size(); ++cell) {
    const Area area = cells.areaOf(cell);
    if (!isMemoryArea(area) && area != Area::Q) continue;
    const Access* lost = nullptr;
    const Access* read = nullptr;
    const Access* back = nullptr;
    for (const std::uint32_t i : facts.index().at(cell)) {
      const Access& access = facts.access(i);
      const std::size_t block = facts.blockOf(access.instruction);
      const bool isInterrupt = facts.calls().reachedFromInterrupt(block) && !facts.calls().reachedFromMain(block);
      if (isInterrupt) {
        if (access.write && lost == nullptr) lost = &access;
      } else if (access.width != Width::Bit && isProtected[access.instruction] == 0 &&
                 isCopy(facts.instruction(access.instruction))) {
        if (!access.write && read == nullptr) read = &access;
        if (access.write && read != nullptr && back == nullptr && access.instruction > read->instruction)
          back = &access;
      }
    }
    if (lost == nullptr || read == nullptr || back == nullptr || back->instruction == lastReported) continue;
    lastReported = back->instruction;
    Finding& finding =
        sink.report(facts.instruction(back->instruction).span,
                    fmt::format("{} is written back here as it was read before; what the interrupt routine {} writes "
                                "to {} in between is lost",
                                accessName(*back), facts.pouOf(lost->instruction).name, accessName(*lost)));
    finding.address = accessName(*back);
    finding.related.push_back({facts.instruction(read->instruction).span, "read in the scan"});
    finding.related.push_back({facts.instruction(lost->instruction).span, "written in the interrupt routine"});
    finding.help =
        "change the bits in place by single instructions, or put DISI and ENI around reading and writing "
        "(001:5434-5440)";
  }
}

void checkInt004(const Facts& facts, FindingSink& sink) {
  if (facts.calls().attachments().empty()) return;
  const std::vector<std::uint8_t> isProtected = protectedCode(facts);
  findLostUpdates(facts, isProtected, sink);
  const CellMap& cells = facts.index().cells();
  std::uint32_t lastReported = ~0U;
  for (std::uint32_t cell = 0; cell < cells.size(); ++cell) {
    const Area area = cells.areaOf(cell);
    if (area != Area::V && area != Area::M) continue;
    const Access* write = nullptr;
    const Access* first = nullptr;
    const Access* second = nullptr;
    for (const std::uint32_t i : facts.index().at(cell)) {
      const Access& access = facts.access(i);
      const bool isInterrupt = facts.calls().reachedFromInterrupt(facts.blockOf(access.instruction));
      if (isInterrupt && !facts.calls().reachedFromMain(facts.blockOf(access.instruction))) {
        if (access.write && isWide(access) && write == nullptr) write = &access;
      } else if (!access.write && isProtected[access.instruction] == 0) {
        if (first == nullptr)
          first = &access;
        else if (second == nullptr && access.instruction != first->instruction)
          second = &access;
      }
    }
    if (write == nullptr || first == nullptr || second == nullptr || write->instruction == lastReported) continue;
    lastReported = write->instruction;
    const Instruction& reader = facts.instruction(second->instruction);
    Finding& finding =
        sink.report(reader.span, fmt::format("{} is written by the interrupt routine {} and read here a second time in "
                                             "the scan; the interrupt may come between the reads",
                                             accessName(*write), facts.pouOf(write->instruction).name));
    finding.address = accessName(*write);
    finding.related.push_back({facts.instruction(write->instruction).span, "written in the interrupt routine"});
    finding.related.push_back({facts.instruction(first->instruction).span, "first read in the scan"});
    finding.help = "copy the value once by MOV and use the copy, or put DISI and ENI around the reads (001:5434-5440)";
  }
}

}  // namespace

extern constexpr Rule int004_shared_data_not_protected = {
    .id = "INT004",
    .title = "Shared data not protected",
    .severity = Severity::Warning,
    .needs = Needs::Flow,
    .detects =
        "a word or double word written in an interrupt routine and read elsewhere by more than one access, or copied, "
        "changed and written back elsewhere, without DISI and ENI around them",
    .why =
        "the interrupt can come between two instructions, so the two reads may belong to different events, and what it "
        "wrote between reading and writing back is undone",
    .manual = "001:2084, 001:5434-5440",
    .bad =
        "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD SM0.1\nATCH INT0, 0\nENI\nNetwork 2\nLDW>= VW0, +10\n= "
        "Q0.0\nNetwork 3\nLDW< VW0, +10\n= Q0.1\nEND_ORGANIZATION_BLOCK\n"
        "INTERRUPT_BLOCK INT_0:INT0\nBEGIN\nNetwork 1\nLD SM0.0\nINCW VW0\nEND_INTERRUPT_BLOCK\n",
    .good =
        "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\nLD SM0.1\nATCH INT0, 0\nENI\nNetwork 2\nLD SM0.0\nMOVW VW0, "
        "VW2\nNetwork 3\nLDW>= VW2, +10\n= Q0.0\nNetwork 4\nLDW< VW2, +10\n= Q0.1\nEND_ORGANIZATION_BLOCK\n"
        "INTERRUPT_BLOCK INT_0:INT0\nBEGIN\nNetwork 1\nLD SM0.0\nINCW VW0\nEND_INTERRUPT_BLOCK\n",
    .falsePositives = "reads that need not agree with each other",
    .peers = "SA0006; SA0103; CP10; CP11; CP15; Frama-PLC task lists",
    .dialects = dialect::S7200,
    .check = checkInt004,
};

}  // namespace rungproof
