// One network for each mnemonic of the table, with operands that its descriptor allows, on CPU 226: the text is read
// without a finding, in both spellings, and means the instruction it names. Operands written here are the plainest of
// each type: VB0, VW0, VD0, T37, C1, a number in its range.
#include <gtest/gtest.h>

#include "ir/s7200/cpu.hpp"
#include "ir/s7200/isa.hpp"
#include "tests/reader/read.hpp"

namespace rungproof {
namespace {

std::string constantFor(const OperandDesc& operand) {
  if (!operand.hasRanges()) return operand.type == Type::Real ? "1.0" : operand.type == Type::String ? "\"A\"" : "1";
  for (const ValueRange& range : operand.ranges) {
    if ((range.cpus & cpuBit(s7200Cpu("226"))) != 0) return std::to_string(range.low);
  }
  return "1";
}

std::string textFor(const OperandDesc& operand) {
  switch (operand.type) {
    case Type::Timer: return operand.hasRanges() ? "T" + constantFor(operand) : "T37";
    case Type::Counter: return "C1";
    case Type::Label:
    case Type::Subroutine: return "0";
    case Type::Interrupt: return "0";
    default: break;
  }
  const bool takesV = (operand.forms & form::V) != 0;
  if (operand.type == Type::Bool) {
    return takesV ? "V0.0" : (operand.forms & form::I) != 0 ? "I0.0" : (operand.forms & form::Q) != 0 ? "Q0.0" : "S0.0";
  }
  if (operand.hasRanges() && (operand.forms & form::Const) != 0) return constantFor(operand);
  if (takesV) {
    switch (widthOf(operand.type)) {
      case Width::Word: return "VW0";
      case Width::DWord: return "VD0";
      default: return "VB0";
    }
  }
  if ((operand.forms & form::I) != 0) return "IB0";
  if ((operand.forms & form::Q) != 0) return "QB0";
  return constantFor(operand);
}

/// E, A and Z for I, Q and C.
std::string inGerman(std::string operand) {
  if (operand[0] == 'I') operand[0] = 'E';
  if (operand[0] == 'Q') operand[0] = 'A';
  if (operand[0] == 'C') operand[0] = 'Z';
  return operand;
}

std::string programOf(bool german) {
  std::string text = "ORGANIZATION_BLOCK MAIN:OB1\nTITLE=\nBEGIN\n";
  int network = 0;
  for (const Desc& desc : s7200Instructions().all()) {
    if (desc.drawingOnly || desc.olderDialectOnly) continue;
    text += fmt::format("Network {}\n{}", ++network, german && !desc.german.empty() ? desc.german : desc.stl);
    for (int i = 0; i < desc.operandCount; ++i) {
      if (desc.operand(i).optional || desc.operand(i).type == Type::Parameter) break;
      const std::string operand = textFor(desc.operand(i));
      text += (i == 0 ? " " : ", ") + (german ? inGerman(operand) : operand);
    }
    text += '\n';
  }
  return text +
         "END_ORGANIZATION_BLOCK\nSUBROUTINE_BLOCK S:SBR0\nBEGIN\nNetwork 1\nNOP 0\nEND_SUBROUTINE_BLOCK\n"
         "INTERRUPT_BLOCK I:INT0\nBEGIN\nNetwork 1\nNOP 0\nEND_INTERRUPT_BLOCK\n";
}

void expectEveryMnemonic(bool german) {
  ReadOptions options;
  options.mnemonics = german ? Mnemonics::German : Mnemonics::International;
  const Program program = readText("all.awl", programOf(german), options);
  EXPECT_EQ(findings(program), "");
  std::size_t next = 0;
  for (const Desc& desc : s7200Instructions().all()) {
    if (desc.drawingOnly || desc.olderDialectOnly) continue;
    ASSERT_LT(next, program.pous[0].networks.size());
    const Network& network = program.pous[0].networks[next++];
    ASSERT_EQ(network.instructions.size(), 1U) << desc.stl;
    EXPECT_EQ(network.instructions[0].desc, &desc) << desc.stl << " " << show(network);
  }
  EXPECT_EQ(next, 280U) << "250 of the S7-200 without RET, RETI and MEND (older dialect only), 33 of the S7-200 SMART";
}

TEST(EveryMnemonic, IsReadInTheInternationalSpelling) { expectEveryMnemonic(false); }
TEST(EveryMnemonic, IsReadInTheGermanSpelling) { expectEveryMnemonic(true); }

}  // namespace
}  // namespace rungproof
