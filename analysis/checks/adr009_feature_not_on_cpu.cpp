// ADR009: something that other CPUs have and the chosen one has not: fast counters, port 1, interrupt events,
// subroutine numbers, the clock, whole instructions. Ranges per CPU come from the descriptors and ir/s7200/cpu.hpp.
// Tested by tests/rules/operand_rules_test.cpp.
#include <fmt/format.h>

#include <algorithm>

#include "analysis/flow/facts.hpp"
#include "analysis/flow/operand_check.hpp"
#include "analysis/rule.hpp"
#include "ir/s7200/event.hpp"

namespace rungproof {

namespace {

class Checker {
 public:
  Checker(const Facts& facts, FindingSink& sink) : facts_(facts), sink_(sink), features_(cpuFeatures(facts.target())) {}

  void instruction(const Instruction& instruction) {
    const Desc& desc = *instruction.desc;
    const Target& target = facts_.target();
    if ((desc.cpus & cpuBit(target.cpu)) == 0) {
      report(instruction.mnemonic(), fmt::format("the {} has no instruction {} ({})", cpu(), desc.stl, desc.manual));
    } else if (desc.since2004 && target.edition == Edition::Edition2003) {
      report(instruction.mnemonic(),
             fmt::format("{} does not exist in the 2003 edition; it came with 2004 (001:130)", desc.stl));
    }
    if (desc.since28 && target.edition == Edition::Smart27) {
      report(instruction.mnemonic(),
             fmt::format("{} came with firmware V2.8 of the S7-200 SMART; the program is for {}", desc.stl,
                         editionText(target.edition)))
          .severity = Severity::Warning;
    }
    if (needsEthernet(desc) && (desc.cpus & seriesOf(target.cpu)) != 0) ethernet(instruction);
    const std::size_t count = std::min<std::size_t>(instruction.operands.size(), desc.operandCount);
    for (std::size_t i = 0; i < count; ++i) operand(instruction, i);
    if (roleOf(instruction) == Role::Todr || roleOf(instruction) == Role::Todw) clock(instruction);
  }

 private:
  /// GET, PUT and their kin reach a partner; all others that are modelled in full read or set what the CPU stores.
  static bool needsEthernet(const Desc& desc) {
    return desc.group == "communication" && (desc.cpus & s7200Cpus) == 0 &&
           (desc.modelling != Modelling::Whole || desc.role == Role::Get || desc.role == Role::Put);
  }
  /// A name that ends in s: serial ports only. Of the old compact CPUs the sources say both.
  void ethernet(const Instruction& instruction) {
    if (cpu().ends_with('s')) {
      report(instruction.mnemonic(),
             fmt::format("{} needs Ethernet, which the {} has not", Facts::text(instruction), cpu()));
    } else if (facts_.target().cpu == s7200Cpu("CR40") || facts_.target().cpu == s7200Cpu("CR60")) {
      report(instruction.mnemonic(), fmt::format("{} needs Ethernet; the sources differ on whether the {} has it",
                                                 Facts::text(instruction), cpu()))
          .severity = Severity::Note;
    }
  }
  std::string cpu() const { return fmt::format("CPU {}", cpuName(facts_.target().cpu)); }
  Finding& report(Span span, std::string message) {
    Finding& finding = sink_.report(span, std::move(message));
    finding.help = "choose the CPU that the program is meant for with --cpu, or do without";
    return finding;
  }

  void operand(const Instruction& instruction, std::size_t i) {
    const Operand& operand = instruction.operands[i];
    const OperandDesc& desc = instruction.desc->operands[i];
    if (operand.kind == OperandKind::Direct && operand.area == Area::HC)
      return fastCounter(instruction, operand, static_cast<int>(operand.offset));
    if (operand.kind != OperandKind::Constant || operand.form == ConstantForm::Real) return;
    const int value = static_cast<int>(std::clamp<std::int64_t>(operand.value, -1, 100000));
    const Role role = roleOf(instruction);
    if ((role == Role::Hsc || role == Role::Hdef) && i == 0) return fastCounter(instruction, operand, value);
    if (desc.type == Type::Subroutine) return subroutine(instruction, operand, value);
    if (desc.name == "EVNT") return event(instruction, operand, value);
    if (role == Role::Pls) olderFirmware(instruction, operand, value, features_.pulseOutputs);
    if (role == Role::Pid) olderFirmware(instruction, operand, value, features_.pidLoops);
    if (!desc.hasRanges() || !valueIsInRange(desc, operand.value, seriesOf(facts_.target().cpu)) ||
        valueIsInRange(desc, operand.value, cpuBit(facts_.target().cpu)))
      return;
    const std::string ranges = rangesText(desc, facts_.target().cpu);
    report(operand.span, ranges.empty()
                             ? fmt::format("the {} has no {} of {} ({})", cpu(), desc.name, instruction.desc->stl,
                                           instruction.desc->manual)
                             : fmt::format("{} of {} must be {} on the {}, not {} ({})", desc.name,
                                           Facts::text(instruction), ranges, cpu(), value, instruction.desc->manual))
        .address = toString(operand);
  }

  /// Numbers that a CPU has by its usual edition, and by the chosen one not yet.
  void olderFirmware(const Instruction& instruction, const Operand& operand, int number, int has) {
    const Target& target = facts_.target();
    const Target usual(target.cpu, usualEdition(target.cpu));
    const int has28 = roleOf(instruction) == Role::Pls ? cpuFeatures(usual).pulseOutputs : cpuFeatures(usual).pidLoops;
    if (number < has || number >= has28) return;
    report(operand.span, fmt::format("{} names number {}; the {} has the numbers 0 to {} ({})",
                                     Facts::text(instruction), number, cpu(), has - 1, editionText(target.edition)))
        .address = toString(operand);
  }

  void fastCounter(const Instruction& instruction, const Operand& operand, int number) {
    if (number < 0 || number > 5 || hscExists(facts_.target(), number)) return;
    report(operand.span, fmt::format("the {} has no fast counter HSC{}, which {} needs (001:4166-4168; tables 6-1 and "
                                     "6-2 print HC0 to HC5, 001:2662, 001:2716)",
                                     cpu(), number, Facts::text(instruction)))
        .address = toString(operand);
  }

  void event(const Instruction& instruction, const Operand& operand, int number) {
    if (number < 0 || number >= eventCount || eventExists(facts_.target(), number)) return;
    Finding& finding = report(operand.span, fmt::format("the {} has no interrupt event {}, which {} names (001:5366)",
                                                        cpu(), number, Facts::text(instruction)));
    finding.address = toString(operand);
    if (contains(features_.unlistedEvents, number)) finding.severity = Severity::Warning;
  }

  void subroutine(const Instruction& instruction, const Operand& operand, int number) {
    if (number < features_.subroutines || number > 127) return;
    const bool isDisputed = number < features_.callable;
    Finding& finding =
        report(operand.span,
               fmt::format("{} names subroutine {}; the {} has {} of them, numbers 0 to {} (001:2666{})",
                           Facts::text(instruction), number, cpu(), features_.subroutines, features_.subroutines - 1,
                           isDisputed ? "; table 6-78 gives 0 to 127, 001:6751" : ""));
    finding.address = toString(operand);
    if (!isDisputed) return;
    finding.severity = Severity::Warning;
    finding.help = "the manual contradicts itself for this CPU; a number below 64 is safe";
  }

  void clock(const Instruction& instruction) {
    if (features_.clockBuiltIn) return;
    Finding& finding =
        report(instruction.span, fmt::format("{} needs a clock; the {} has one only as a plug-in module (001:565)",
                                             Facts::text(instruction), cpu()));
    finding.severity = Severity::Warning;
    finding.help = "without the module the instruction ends with error 000C (001:13960)";
  }

  const Facts& facts_;
  FindingSink& sink_;
  CpuFeatures features_;
};

void checkAdr009(const Facts& facts, FindingSink& sink) {
  Checker checker(facts, sink);
  for (const InstructionPlace& place : facts.instructions()) checker.instruction(*place.instruction);
}

}  // namespace

extern constexpr Rule adr009_feature_not_on_cpu = {
    .id = "ADR009",
    .title = "Feature not on this CPU",
    .severity = Severity::Error,
    .needs = Needs::Text,
    .detects =
        "HSC1 or HSC2 on a 221 or 222, port 1 on a 221, 222 or 224, an interrupt event or subroutine number which the "
        "CPU lacks, an instruction, pulse output or PID loop newer than the chosen edition, GET, PUT and the like on a "
        "CR20s to CR60s, which "
        "have "
        "no Ethernet, the clock on a CPU that has it only as a module",
    .why = "the program is refused at download with a general error 0082 or 0090",
    .manual = "001:4166, 001:2670, 001:5366, 001:2666, 001:6751, 001:565",
    .bad = "Network 1\nLD SM0.1\nMOVB 16#F8, SMB47\nHDEF 1, 0\nHSC 1\n",
    .good = "Network 1\nLD SM0.1\nMOVB 16#F8, SMB37\nHDEF 0, 0\nHSC 0\n",
    .exampleCpu = "222",
    .falsePositives =
        "a program for another CPU than the chosen one: name it with --cpu; subroutine numbers above 63 on a 224XP, "
        "where the manual "
        "contradicts itself",
    .dialects = dialect::S7200,
    .refuses = true,
    .standsAlone = true,
    .check = checkAdr009,
};

}  // namespace rungproof
