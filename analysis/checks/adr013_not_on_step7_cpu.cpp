// ADR013: what the CPU of an S7-300/400 does not have: addresses beyond its areas, data blocks that it does not take,
// instructions on more accumulators. Limits come from the rows of ir/s7300/cpu.hpp; where a pointer leads, the prover
// asks (OBL002). Tested by its examples and tests/rules/step7_address_rules_test.cpp.
#include <fmt/format.h>

#include "analysis/flow/operand_check.hpp"
#include "analysis/flow/step7_blocks.hpp"
#include "analysis/rule.hpp"
#include "ir/s7300/cpu.hpp"

namespace rungproof {

namespace {

class CpuLimits {
 public:
  CpuLimits(const Facts& facts, FindingSink& sink)
      : facts_(facts), sink_(sink), row_(step7Row(facts.target().cpu)), cpu_(fmt::format("CPU {}", row_.name)) {}

  void instruction(const Instruction& instruction) {
    const Desc& desc = *instruction.desc;
    if ((desc.cpus & cpuBit(facts_.target().cpu)) == 0)
      report(instruction.mnemonic(),
             fmt::format("{} moves ACCU3 and ACCU4, and the {} has two accumulators", desc.stl, cpu_))
          .refused = true;
    for (std::size_t i = 0; i < instruction.operands.size(); ++i) {
      const Operand& operand = instruction.operands[i];
      const bool isListed = i < desc.operandCount;
      place(operand, isListed ? accessWidth(desc.operands[i], operand) : operand.width);
      if (operand.reach != nullptr) place(operand.reach->pointer, operand.reach->pointer.width);
    }
  }

  void dataBlock(const DataBlock& block) {
    if (block.number > row_.lastBlock) {
      report(block.span,
             fmt::format("DB{} is beyond the last data block of the {}, DB{}", block.number, cpu_, row_.lastBlock));
    } else if (block.bytes.size() > row_.longestBlock) {
      report(block.span, fmt::format("DB{} has {} bytes, and a data block of the {} at most {}", block.number,
                                     block.bytes.size(), cpu_, row_.longestBlock));
    }
  }

 private:
  Finding& report(Span span, std::string message) {
    Finding& finding = sink_.report(span, std::move(message));
    finding.refused = false;  // a synchronous error of a running CPU
    finding.help = "correct it, or choose the CPU that the program is meant for with --cpu";
    return finding;
  }

  void place(const Operand& operand, Width width) {
    if (operand.kind != OperandKind::Direct || operand.area == Area::DB) return;
    const std::optional<AddressLimit> limit = addressLimit(facts_.target(), operand.area, width);
    if (!limit || operand.offset <= limit->lastByte) return;
    const std::string name = addressName(operand.area, width, operand.offset, operand.bit);
    report(operand.span, fmt::format("{} is beyond the last address of the {}, {}", name, cpu_,
                                     addressName(operand.area, width, limit->lastByte, 7)))
        .address = name;
  }

  const Facts& facts_;
  FindingSink& sink_;
  const Step7CpuRow& row_;
  std::string cpu_;
};

void checkAdr013(const Facts& facts, FindingSink& sink) {
  CpuLimits limits(facts, sink);
  for (const InstructionPlace& place : facts.instructions()) {
    if (!isLibraryText(facts.program(), facts.pouOf(place.instruction->id))) limits.instruction(*place.instruction);
  }
  for (const DataBlock& block : facts.program().dataBlocks) limits.dataBlock(block);
}

}  // namespace

extern constexpr Rule adr013_not_on_step7_cpu = {
    .id = "ADR013",
    .title = "Not on this S7-300/400 CPU",
    .severity = Severity::Error,
    .needs = Needs::Text,
    .detects =
        "an address beyond the bit memory, images, modules, local data, timers or counters of the CPU, a data block "
        "with a number or length that it does not take, ENT and LEAVE on two accumulators",
    .why =
        "the download is refused, or the access is a synchronous error: OB121 is called, and without it the CPU stops",
    .manual = "002:1289, 002:495, 002:502-508, 002:1518",
    .bad = "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nL MW 255;\nENT;\nT QW 4;\nEND_ORGANIZATION_BLOCK\n",
    .good = "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nL MW 254;\nT QW 4;\nEND_ORGANIZATION_BLOCK\n",
    .exampleCpu = "314",
    .falsePositives = "a program for another CPU than the chosen one: name it with --cpu",
    .dialects = dialect::S7300,
    .refuses = true,
    .standsAlone = true,
    .check = checkAdr013,
};

}  // namespace rungproof
