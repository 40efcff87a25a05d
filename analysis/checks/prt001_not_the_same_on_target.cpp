// PRT001: what a program of one family of CPUs means on the other. A few habits of the S7-200 give a program for the
// S7-200 SMART away at once; the others are looked for when --port-to names the CPU that the program goes to. What that
// CPU does not have at all, the rules for addresses, constants, features, stack and nesting say when asked for it.
// Tested by its examples and tests/rules/port_rules_test.cpp.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <optional>
#include <set>
#include <tuple>

#include "analysis/flow/analogue_flow.hpp"
#include "analysis/flow/facts.hpp"
#include "analysis/flow/operand_check.hpp"
#include "analysis/rule.hpp"
#include "ir/s7200/hsc_inputs.hpp"
#include "ir/s7200/points.hpp"
#include "ir/s7200/pulse_output.hpp"

namespace rungproof {

namespace {

/// Rules that refuse what a CPU does not have.
constexpr std::array<std::string_view, 7> limitRules = {"ADR001", "ADR002", "ADR006", "ADR009",
                                                        "STK001", "SUB002", "TIM013"};

std::string_view familyName(bool smart) { return smart ? "S7-200 SMART" : "S7-200"; }

/// Full scale of a family (001:11972), what 4 mA of 20 mA give, and what lies between.
struct Scale {
  std::int64_t full, offset, span;
};
constexpr Scale scaleOf(bool smart) { return smart ? Scale{27648, 5530, 22118} : Scale{32000, 6400, 25600}; }

std::optional<std::int64_t> numberOf(const Operand& operand) {
  if (operand.kind != OperandKind::Constant) return std::nullopt;
  if (operand.form != ConstantForm::Real) return operand.value;
  const auto value = static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(operand.value)));
  if (value < -1e6 || value > 1e6 || value != std::floor(value)) return std::nullopt;
  return static_cast<std::int64_t>(value);
}

class PortCheck {
 public:
  PortCheck(const Facts& facts, FindingSink& sink)
      : facts_(facts),
        sink_(sink),
        target_(facts.surroundings().portTo.value_or(facts.target())),
        isPorted_(facts.surroundings().portTo.has_value()),
        toSmart_(isSmart(target_)),
        changesFamily_(isPorted_ && (toSmart_ || isSmart(facts.target()))) {}

  void run() {
    if (isPorted_) limits();
    if (!toSmart_ && !changesFamily_) return;
    modeSwitch();
    specialBytes();
    analogueScale();
    if (!changesFamily_) return;
    pulseOutputs();
    fastCounters();
    portModes();
    for (const Area area : {Area::I, Area::Q, Area::AI, Area::AQ}) modulePoints(area);
  }

 private:
  Finding& report(Span span, Severity severity, std::string message, std::string help) {
    Finding& finding = sink_.report(span, std::move(message));
    finding.severity = severity;
    finding.help = std::move(help);
    return finding;
  }
  std::string there() const { return fmt::format("the {}", familyName(toSmart_)); }
  std::string here() const { return fmt::format("the {}", familyName(!toSmart_)); }
  static bool isAt(const Access& access, std::uint32_t first, std::uint32_t last) {
    return access.area == Area::SM && !access.viaPointer && access.offset <= last &&
           access.offset + access.certainLength() > first;
  }
  template <class Do>
  void eachAccess(std::uint32_t first, std::uint32_t last, bool write, Do act) {
    for (const Access& access : facts_.accesses().all()) {
      if (access.write == write && access.operand != impliedOperand && isAt(access, first, last))
        act(access, facts_.instruction(access.instruction));
    }
  }

  /// What the rules about limits find on the other CPU and not on the program's own.
  void limits() {
    Program moved = facts_.program();
    moved.target = target_;
    const Facts there(moved, facts_.externals());
    const RuleSettings settings;
    for (const std::string_view id : limitRules) {
      const Rule& rule = *ruleNamed(id);
      const auto findingsOf = [&](const Facts& facts) {
        FindingSink sink(facts.program(), settings);
        sink.begin(rule);
        rule.check(facts, sink);
        return sink.take();
      };
      std::set<std::pair<std::uint32_t, std::uint32_t>> own;
      for (const Finding& finding : findingsOf(facts_)) own.emplace(finding.span.file, finding.span.offset);
      for (Finding& finding : findingsOf(there)) {
        if (own.contains({finding.span.file, finding.span.offset}) || !isLimit(finding, id)) continue;
        Finding& port = report(finding.span, finding.severity,
                               fmt::format("on a CPU {}: {}", cpuName(target_.cpu), finding.message),
                               fmt::format("{} ({})", portHelp, id));
        port.address = finding.address;
        port.related = std::move(finding.related);
      }
    }
  }
  /// TIM013 is about more than the number of edges.
  static bool isLimit(const Finding& finding, std::string_view id) {
    return id != "TIM013" || finding.message.find("is edge number") != std::string::npos;
  }
  static constexpr std::string_view portHelp = "use what the CPU has that the program is to run on";

  // SM0.7 -------------------------------------------------------------------------------------------------------------

  static bool isModeSwitch(const Operand& o) {
    const bool isBit =
        o.kind == OperandKind::Direct && o.area == Area::SM && o.width == Width::Bit && o.offset == 0 && o.bit == 7;
    return isBit && o.text.find("RTC") == std::string::npos && o.text.find("Lost") == std::string::npos;
  }
  void modeSwitch() {
    for (const InstructionPlace& place : facts_.instructions()) {
      const Instruction& contact = *place.instruction;
      if (!isContact(roleOf(contact)) || contact.operands.empty() || !isModeSwitch(contact.operands[0])) continue;
      // A program of the S7-200 SMART may ask whether the clock was lost: it remembers that, or sets the clock.
      if (!changesFamily_ && !actsAsSwitch(place)) continue;
      Finding& finding = report(
          contact.span, Severity::Error,
          toSmart_ ? fmt::format("{} asks for the mode switch, which the S7-200 SMART does not have: SM0.7 tells there "
                                 "for one scan that the clock was lost",
                                 Facts::text(contact))
                   : fmt::format("{} asks whether the clock was lost; on the S7-200 SM0.7 is the mode switch",
                                 Facts::text(contact)),
          toSmart_ ? "enable freeport with SM0.0 or a bit of the program's own"
                   : "read the clock and look whether the date is possible");
      finding.address = "SM0.7";
    }
  }
  /// Whether its rung sets a port up, sends or receives, or drives a coil that does not hold itself.
  bool actsAsSwitch(const InstructionPlace& place) const {
    const Flow& flow = facts_.plan().flows[place.block];
    for (std::uint32_t at = place.step + 1; at < flow.steps.size() && flow.steps[at].network == place.network; ++at) {
      const Instruction& instruction = *flow.steps[at].instruction;
      const Role role = roleOf(instruction);
      if (role == Role::Load && !isLogic(roleOf(*flow.steps[at - 1].instruction))) return false;
      if (role == Role::Xmt || role == Role::Rcv) return true;
      if (isCoil(role) && !isHeld(flow, place, at)) return true;
      for (const Access& access : facts_.accesses().of(instruction.id)) {
        if (access.write && (isAt(access, 30, 30) || isAt(access, 130, 130))) return true;
      }
    }
    return false;
  }
  static bool isHeld(const Flow& flow, const InstructionPlace& place, std::uint32_t coil) {
    const std::string bit = toString(flow.steps[coil].instruction->operands[0]);
    for (std::uint32_t at = 0; at < coil; ++at) {
      const Instruction& earlier = *flow.steps[at].instruction;
      if (flow.steps[at].network == place.network && isContact(roleOf(earlier)) && !earlier.operands.empty() &&
          toString(earlier.operands[0]) == bit)
        return true;
    }
    return false;
  }

  // Bytes of special memory with another meaning ----------------------------------------------------------------------

  void specialBytes() {
    const auto name = [](const Access& access) { return accessName(access); };
    eachAccess(28, 29, false, [&](const Access& access, const Instruction& instruction) {
      // Bits and comparisons are how a program of the S7-200 SMART looks at its signal board.
      if (!changesFamily_ && (access.width == Width::Bit || isContact(roleOf(instruction)))) return;
      report(instruction.span, Severity::Error,
             fmt::format("{} reads {} as a potentiometer; on the S7-200 SMART it is the {} of the signal board",
                         Facts::text(instruction), name(access), access.offset == 28 ? "identification" : "error byte"),
             toSmart_ ? "take the value from a panel or an analogue input" : "the S7-200 has no signal board")
          .address = name(access);
    });
    eachAccess(31, 33, true, [&](const Access& access, const Instruction& instruction) {
      if (!toSmart_) return;
      report(instruction.span, Severity::Warning,
             fmt::format("{} writes {}, which saves a value to permanent memory on the S7-200 and does nothing on the "
                         "S7-200 SMART",
                         Facts::text(instruction), name(access)),
             "declare the value retentive in the system block")
          .address = name(access);
    });
    if (!changesFamily_) return;
    for (const auto& [first, last, meaning] :
         {std::tuple{6U, 7U, "the identification of the CPU"}, std::tuple{200U, 549U, "data of intelligent modules"}}) {
      std::set<std::uint32_t> seen;
      for (const bool write : {false, true}) {
        eachAccess(first, last, write, [&](const Access& access, const Instruction& instruction) {
          if (!seen.insert(access.offset).second) return;
          report(instruction.span, Severity::Warning,
                 fmt::format("{} uses {}: {} is laid out differently on {}", Facts::text(instruction), name(access),
                             meaning, there()),
                 "look the value up in the manual of the new CPU")
              .address = name(access);
        });
      }
    }
  }
  /// Bits 1-0 of the control byte of a port: 2 was the PPI master.
  void portModes() {
    if (!toSmart_) return;
    for (const std::uint32_t byte : {30U, 130U}) {
      eachAccess(byte, byte, true, [&](const Access& access, const Instruction& instruction) {
        if (roleOf(instruction) != Role::Move || access.width != Width::Byte) return;
        const auto value = numberOf(instruction.operands[0]);
        if (!value || (*value & 3) != 2) return;
        report(instruction.span, Severity::Error,
               fmt::format("{} makes the port a PPI master, which the S7-200 SMART does not have",
                           Facts::text(instruction)),
               "exchange data by GET and PUT over Ethernet, or by a Modbus library")
            .address = accessName(access);
      });
    }
  }

  // Analogue values ---------------------------------------------------------------------------------------------------

  void analogueScale() {
    const Scale old = scaleOf(!toSmart_), now = scaleOf(toSmart_);
    std::optional<AnalogueFlow> flow;
    for (const InstructionPlace& place : facts_.instructions()) {
      const Instruction& instruction = *place.instruction;
      if (isContact(roleOf(instruction)) || isTimerBox(roleOf(instruction)) || isCounterBox(roleOf(instruction)))
        continue;
      for (const Operand& operand : instruction.operands) {
        const auto value = numberOf(operand);
        const bool isOld = value && (*value == old.full || *value == old.offset || *value == old.span);
        if (!isOld) continue;
        if (!flow) flow.emplace(facts_);
        if (!flow->concerns(instruction.id)) continue;
        const std::int64_t better = *value == old.full ? now.full : *value == old.offset ? now.offset : now.span;
        Finding& finding = report(operand.span, Severity::Warning,
                                  fmt::format("{} scales an analogue value by {}, as on {}; on {} full scale is {}",
                                              Facts::text(instruction), *value, here(), there(), now.full),
                                  fmt::format("{} becomes {}", *value, better));
        finding.address = toString(operand);
        break;
      }
    }
  }

  // Pulse outputs -----------------------------------------------------------------------------------------------------

  void pulseOutputs() {
    for (std::uint32_t output = 0; output < pulseOutputCount; ++output) {
      const std::uint32_t control = pulseControl(output);
      bool mayBeTrain = false;
      eachAccess(control, control, true, [&](const Access& access, const Instruction& instruction) {
        mayBeTrain = controlByte(access, instruction, control) || mayBeTrain;
      });
      if (!mayBeTrain) continue;
      eachAccess(control + 1, control + 2, true, [&](const Access& access, const Instruction& instruction) {
        if (access.width != Width::Word) return;
        report(instruction.span, Severity::Error,
               fmt::format("{} writes {} of a pulse train; on {} the word holds {}", Facts::text(instruction),
                           toSmart_ ? "the cycle time" : "the frequency", there(),
                           toSmart_ ? "its frequency in Hz" : "its cycle time"),
               toSmart_ ? "a cycle of 500 us is a frequency of 2000 Hz" : "2000 Hz is a cycle of 500 us")
            .address = accessName(access);
      });
      eachAccess(profileWord(output), profileWord(output) + 1, true,
                 [&](const Access& access, const Instruction& instruction) {
                   report(instruction.span, Severity::Error,
                          fmt::format("{} starts a profile with segments of {} bytes; on {} a segment has {}",
                                      Facts::text(instruction), pulseForm(otherFamily()).segmentBytes, there(),
                                      pulseForm(target_).segmentBytes),
                          "build the profile anew: S7-200 initial cycle, change and count, S7-200 SMART start "
                          "frequency, end frequency and count")
                       .address = accessName(access);
                 });
    }
  }
  Target otherFamily() const { return toSmart_ ? Target{} : Target{s7200Cpu("ST60"), usualEdition(s7200Cpu("ST60"))}; }
  /// Reports the mode that the byte selects; whether it selected a train in the family that the program comes from.
  bool controlByte(const Access& access, const Instruction& instruction, std::uint32_t control) {
    const bool isMove = roleOf(instruction) == Role::Move && access.width == Width::Byte;
    const auto value = isMove ? numberOf(instruction.operands[0]) : std::nullopt;
    if (access.width == Width::Bit) {
      if (access.bit > 6 || access.bit + access.count <= 6 || access.count == 8) return false;
    } else if (!value) {
      return true;
    }
    if (value && (*value & 0x80) == 0) return false;  // the output is switched off
    const bool isPwm = value && ((*value & 0x40) != 0) == pulseForm(otherFamily()).bit6IsPwm;
    report(instruction.span, Severity::Error,
           value ? fmt::format("{} selects a pulse {} on {}; on {} bit 6 of SMB{} means the opposite and selects a "
                               "pulse {}",
                               Facts::text(instruction), isPwm ? "width" : "train", here(), there(), control,
                               isPwm ? "train" : "width")
                 : fmt::format("{} selects pulse train or pulse width; on {} the bit means the opposite",
                               Facts::text(instruction), there()),
           value ? fmt::format("write 16#{:02X}", (*value ^ 0x40) & 0xFF) : "turn the bit round")
        .address = accessName(access);
    return !isPwm || !value;
  }

  // Fast counters and points ------------------------------------------------------------------------------------------

  void fastCounters() {
    for (const InstructionPlace& place : facts_.instructions()) {
      const Instruction& instruction = *place.instruction;
      if (roleOf(instruction) != Role::Hdef || instruction.operands.size() < 2) continue;
      const auto counter = numberOf(instruction.operands[0]), mode = numberOf(instruction.operands[1]);
      if (!counter || !mode || *counter > 5 || *mode > 12) continue;
      const int n = static_cast<int>(*counter), m = static_cast<int>(*mode);
      if (!hscHasMode(otherFamily(), n, m)) continue;
      if (!hscHasMode(target_, n, m)) {
        if (!valueIsInRange(instruction.desc->operands[1], m, cpuBit(target_.cpu))) continue;  // the limits have spoken
        report(instruction.span, Severity::Error,
               fmt::format("{}: HSC{} has no mode {} on {}", Facts::text(instruction), n, m, there()),
               "take a counter that has the inputs which the mode needs")
            .address = fmt::format("HC{}", n);
        continue;
      }
      for (int k = 0; k < hscInputCount; ++k) {
        const auto at = static_cast<std::size_t>(k);
        if (!hscModeUses(m, k) || hscInputs(otherFamily(), n)[at] == hscInputs(target_, n)[at]) continue;
        const auto point = [](int number) {
          return addressName(Area::I, Width::Bit, static_cast<unsigned>(number) / 8, static_cast<unsigned>(number) % 8);
        };
        report(instruction.span, Severity::Warning,
               fmt::format("{}: HSC{} takes {} on {} where {} is wired now", Facts::text(instruction), n,
                           point(hscInputs(target_, n)[at]), there(), point(hscInputs(otherFamily(), n)[at])),
               "change the wiring, or take another counter")
            .address = fmt::format("HC{}", n);
        break;
      }
    }
  }

  /// Addresses behind the points of the CPU itself belong to modules, which the families number differently: one
  /// finding for all of an area.
  void modulePoints(Area area) {
    const std::uint32_t end = std::min(onBoardEnd(facts_.target(), area), onBoardEnd(target_, area));
    const Access* first = nullptr;
    std::set<std::uint32_t> bits;
    for (const Access& access : facts_.accesses().all()) {
      if (access.area != area || access.viaPointer || access.operand == impliedOperand || access.bit > 7) continue;
      const std::uint32_t bit = access.offset * 8 + (access.width == Width::Bit ? access.bit : 0);
      if (bit < end) continue;
      if (first == nullptr) first = &access;
      bits.insert(bit);
    }
    if (first == nullptr) return;
    const Instruction& instruction = facts_.instruction(first->instruction);
    const std::string others =
        bits.size() > 1 ? fmt::format(" and {} further addresses of {} belong", bits.size() - 1, areaName(area))
                        : std::string(" belongs");
    report(instruction.operands[first->operand].span, Severity::Warning,
           fmt::format("{}{} to modules; {}", accessName(*first), others,
                       toSmart_ ? "the S7-200 SMART gives each slot fixed addresses from I8.0, Q8.0, AIW16, "
                                  "AQW16 on"
                                : "on the S7-200 the modules follow each other without holes"),
           "write a table of old and new addresses, and change them in one go")
        .address = accessName(*first);
  }

  const Facts& facts_;
  FindingSink& sink_;
  const Target target_;
  const bool isPorted_, toSmart_;
  const bool changesFamily_;  ///< the program is taken for one of the other family
};

void checkPrt001(const Facts& facts, FindingSink& sink) { PortCheck(facts, sink).run(); }

}  // namespace

extern constexpr Rule prt001_not_the_same_on_target = {
    .id = "PRT001",
    .title = "Not the same on the target",
    .severity = Severity::Error,
    .needs = Needs::Flow,
    .detects =
        "on a CPU of the S7-200 SMART: SM0.7 as mode switch, SMB28 and SMB29 as potentiometers, SMB31, the analogue "
        "scale of 32000; with --port-to CPU also what that CPU does not have, the mode bit and the cycle time of pulse "
        "outputs, profiles, counters with other inputs, PPI master mode, addresses of modules",
    .why =
        "the text compiles on both families, and then a pulse output moves the wrong way, freeport never starts, or "
        "a level is wrong by a seventh",
    .bad = "Network 1\nLD SM0.7\n= SM30.0\nNetwork 2\nLD SM0.0\nMOVB SMB28, VB10\n",
    .good = "Network 1\nLD SM0.1\nMOVB 16#09, SMB30\nNetwork 2\nLD SM0.7\nS M0.0, 1\n",
    .exampleCpu = "ST40",
    .falsePositives =
        "with --port-to a program of the S7-200 SMART is taken for one that was written for the S7-200: leave it out",
    .dialects = dialect::S7200,
    .check = checkPrt001,
};

}  // namespace rungproof
