// ADR001: an address that the chosen CPU does not have. Limits come from table 6-2 through ir/s7200/cpu.hpp, for every
// operand form: direct, the cell of a pointer, an address made with &. Tested by tests/rules/operand_rules_test.cpp.
#include <fmt/format.h>

#include <algorithm>

#include "analysis/flow/facts.hpp"
#include "analysis/flow/operand_check.hpp"
#include "analysis/rule.hpp"
#include "ir/s7200/cpu.hpp"

namespace rungproof {

namespace {

std::string cpuText(const Target& target) {
  return fmt::format("CPU {} ({})", cpuName(target.cpu), editionText(target.edition));
}

Target inOtherEdition(Target target) {
  target.edition = otherEdition(target);
  return target;
}

/// The editions of the manual disagree on L60-L63 and on SM166-SM179 of the 221 without a change of the hardware (s7200
/// C2, C7).
bool isDisputed(const Target& target, Area area, Width width, std::uint32_t offset) {
  if (editionModel(target.edition).isFirmware || (area != Area::L && area != Area::SM)) return false;
  return addressExists(inOtherEdition(target), area, width, offset, 0);
}

std::string limitText(const AddressLimit& limit) {
  std::string text =
      limit.source.empty() ? std::string("limit not in the manual text") : fmt::format("table 6-2, {}", limit.source);
  if (!limit.note.empty()) text += fmt::format("; {}", limit.note);
  return text;
}

void reportAddress(const Facts& facts, FindingSink& sink, const Instruction& instruction, const Operand& operand,
                   Width width) {
  const Target& target = facts.target();
  const bool isBit = width == Width::Bit && !hasBitAndWord(operand.area);
  if (addressExists(target, operand.area, width, operand.offset, isBit ? operand.bit : 0)) return;
  const std::optional<AddressLimit> limit = addressLimit(target, operand.area, width);
  const std::string name = addressName(operand.area, width, operand.offset, operand.bit);
  const std::string text = Facts::text(instruction);
  if (!limit) {
    Finding& finding =
        sink.report(operand.span, fmt::format("{} in {} does not exist: the {} has no {} area for {}", name, text,
                                              cpuText(target), areaName(operand.area), widthName(width)));
    finding.address = name;
    finding.help = "choose the CPU with --cpu, or use another area";
    return;
  }
  if (operand.area == Area::HC && operand.offset <= limit->lastByte)
    return;  // a gap in the row of fast counters: ADR009
  const bool isBeyond = operand.offset > limit->lastByte;
  const bool isInGap = !isBeyond && !addressExists(target, operand.area, width, operand.offset, 0) &&
                       rowEnd(target, operand.area, 0) <= operand.offset + static_cast<std::uint32_t>(bytes(width)) - 1;
  std::string message;
  if (isBeyond) {
    message = fmt::format("{} in {} is outside the {}: the last address for {} is {} ({})", name, text, cpuText(target),
                          widthName(width), addressName(operand.area, width, limit->lastByte, 7), limitText(*limit));
  } else if (isInGap) {
    message =
        fmt::format("{} in {} is outside the {}: the area has a gap behind {} ({})", name, text, cpuText(target),
                    addressName(operand.area, Width::Byte, rowEnd(target, operand.area, 0) - 1), limitText(*limit));
  } else if (isBit) {
    message = fmt::format("{} in {} has bit number {}; a byte has bits 0 to 7 ({})", name, text, operand.bit,
                          limitText(*limit));
  } else {
    message = fmt::format("{} in {} has an odd address; {} words begin at even addresses (001:1380, 001:1386)", name,
                          text, areaName(operand.area));
  }
  Finding& finding = sink.report(operand.span, std::move(message));
  finding.address = name;
  finding.help =
      isBeyond
          ? "use an address inside the area, or choose the CPU that the program is meant for with --cpu and --edition"
          : "correct the number";
  if (isBeyond && isDisputed(target, operand.area, width, operand.offset)) {
    finding.severity = Severity::Warning;
    finding.help = fmt::format("the other edition of the manual allows it ({}); check against the device",
                               limitText(*addressLimit(inOtherEdition(target), operand.area, width)));
  }
}

/// Rows of bits or bytes with a known length whose first element exists and whose last one does not.
void reportExtent(const Facts& facts, FindingSink& sink, const Instruction& instruction) {
  const Role role = roleOf(instruction);
  if (role == Role::BlockMove || role == Role::Fill) return;  // PTR004
  if (role == Role::Get || role == Role::Put) return;         // GET001
  std::uint8_t reported = impliedOperand;
  for (const Access& access : facts.accesses().of(instruction.id)) {
    if (access.viaPointer || access.count < 2 || access.operand == reported || access.operand == impliedOperand)
      continue;
    const std::uint32_t size = rowEnd(facts.target(), access.area, access.offset);
    if (access.offset >= size || access.offset + access.certainLength() <= size) continue;
    const std::string name = accessName(access);
    const std::string last = addressName(access.area, access.byNumber() ? access.width : Width::Byte, size - 1);
    Finding& finding =
        sink.report(instruction.operands[access.operand].span,
                    fmt::format("{} reaches {} elements from {}, beyond the end of the {} area of the {} at {}",
                                Facts::text(instruction), access.count, name, areaName(access.area),
                                cpuText(facts.target()), last));
    finding.address = name;
    finding.help = "lower the count or move the start; at run time the instruction ends with error 0091 (001:13968)";
    reported = access.operand;
  }
}

void checkAdr001(const Facts& facts, FindingSink& sink) {
  for (const InstructionPlace& place : facts.instructions()) {
    const Instruction& instruction = *place.instruction;
    const Desc& desc = *instruction.desc;
    for (std::size_t i = 0; i < instruction.operands.size(); ++i) {
      const Operand& operand = instruction.operands[i];
      const OperandDesc& operandDesc =
          desc.operands[std::min<std::size_t>(i, desc.operandCount == 0 ? 0 : desc.operandCount - 1U)];
      switch (operand.kind) {
        case OperandKind::Direct:
          reportAddress(facts, sink, instruction, operand, accessWidth(operandDesc, operand));
          break;
        case OperandKind::Indirect:
          if (pointerMayStandThere(operand)) reportAddress(facts, sink, instruction, operand, Width::DWord);
          break;
        case OperandKind::Address: {
          const bool isWord = hasBitAndWord(operand.area) || isAnalogue(operand.area);
          if (operand.area != Area::L && operand.area != Area::HC && operand.area != Area::AC) {
            reportAddress(facts, sink, instruction, operand, isWord ? Width::Word : Width::Byte);
          }
          break;
        }
        default: break;
      }
    }
    reportExtent(facts, sink, instruction);
  }
}

}  // namespace

extern constexpr Rule adr001_address_outside_cpu = {
    .id = "ADR001",
    .title = "Address outside the CPU",
    .severity = Severity::Error,
    .needs = Needs::Text,
    .detects =
        "a byte or number beyond the limit of the chosen CPU, a bit number above 7, a word or double word whose last "
        "byte runs over the "
        "end of its area, a row of bits that leaves its area",
    .why =
        "the limits differ from CPU to CPU: V ends at byte 2047, 8191 or 10239; the download is refused with error "
        "0091",
    .manual = "001:2677-2716, 001:13997",
    .bad = "Network 1\nLD SM0.0\nMOVW +1, VW10239\n",
    .good = "Network 1\nLD SM0.0\nMOVW +1, VW10238\n",
    .falsePositives = "a program for another CPU than the chosen one: name it with --cpu and --edition",
    .peers = "SA0005; Omron area boundary of multi-word operands; ironplc P4025 (bit range)",
    .dialects = dialect::S7200,
    .refuses = true,
    .standsAlone = true,
    .check = checkAdr001,
};

}  // namespace rungproof
