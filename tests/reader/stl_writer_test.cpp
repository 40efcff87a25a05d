// What was read, written and read again is the same program.
#include "frontend/stl/stl_writer.hpp"

#include <gtest/gtest.h>

#include "ir/s7200/isa.hpp"
#include "tests/reader/read.hpp"

namespace rungproof {
namespace {

/// Everything of a program but the places; names of operands only if asked for.
std::string picture(const Program& program, bool names) {
  std::string result;
  for (const Pou& pou : program.pous) {
    result += fmt::format("pou {} {} {} '{}'\n", static_cast<int>(pou.kind), pou.name, pou.number, pou.title);
    for (const LocalVariable& local : pou.locals)
      result += fmt::format(" {} {} {} {}\n", local.name, static_cast<int>(local.section), static_cast<int>(local.type),
                            toString(local.address));
    for (const Comment& comment : pou.comments) result += fmt::format(" {}\n", program.sources->text(comment.span));
    for (const Network& network : pou.networks) {
      result += fmt::format(" network {} '{}'\n", network.number, network.title);
      for (const Comment& comment : network.comments)
        result += fmt::format("  {}\n", program.sources->text(comment.span));
      for (const Instruction& instruction : network.instructions) {
        result += "  " + show(instruction);
        for (const Operand& operand : instruction.operands) {
          result += fmt::format(" {}/{}/{}/{}", static_cast<int>(operand.kind), static_cast<int>(operand.form),
                                operand.value, names ? operand.text : "");
        }
        result += '\n';
      }
    }
  }
  for (const DataInit& init : program.data) {
    result += fmt::format("data {}", init.offset);
    for (const std::uint8_t byte : init.bytes) result += fmt::format(" {}", byte);
    result += '\n';
  }
  if (names) {
    for (const Symbol& symbol : program.symbols)
      result += fmt::format("symbol {} {} {}\n", symbol.name, toString(symbol.address), symbol.comment);
  }
  return result;
}

void checkRoundTrip(const std::string& text) {
  const Program first = readText("a.awl", text);
  for (const bool symbolic : {false, true}) {
    StlWriterOptions options;
    options.symbolic = symbolic;
    const std::string written = writeStl(first, options);
    const Program second = readText("b.awl", written);
    EXPECT_EQ(picture(second, symbolic), picture(first, symbolic)) << written;
    EXPECT_EQ(writeStl(second, options), written);
    EXPECT_EQ(findings(second), "") << written;
  }
}

TEST(StlWriter, RoundTripOfAnExport) {
  checkRoundTrip(
      "ORGANIZATION_BLOCK MAIN:OB1\nTITLE=Pump\n// second line\nVAR\nt:BOOL;\nEND_VAR\nBEGIN\nNetwork 1 // start\n// "
      "comment\nLD Start // behind\nO Q0.0\n// between\nAN #t\n= Q0.0\n// end\n"
      "Network 5 \nLD SM0.0\nMOVW +100, VW0\nMOVD &VB100, AC1\nMOVB *AC1, 16#FF\nMOVR 1.5, VD10\nMOVD 'AB$'$$', "
      "VD0\nLDS= \"a$\"b$0D\", VB20\nLDW>= VW0, -5\nS Q0.1, 2\nCALL Pump, L63.7, DW#5, TRUE, 2#101\n"
      "END_ORGANIZATION_BLOCK\nSUBROUTINE_BLOCK "
      "Pump:SBR3\nTITLE=\nVAR_INPUT\na:BOOL;\nb:DWORD;\nEND_VAR\nVAR_IN_OUT\nc:INT;\nEND_VAR\nVAR_OUTPUT\nd:REAL;\nEND_"
      "VAR\nBEGIN\nNetwork 1 \nLD #a\nEND_SUBROUTINE_BLOCK\n"
      "INTERRUPT_BLOCK INT_0:INT0\nTITLE=\nBEGIN\nEND_INTERRUPT_BLOCK\n"
      "DATA_BLOCK\nBEGIN\nVB0 1, 2\nVW10 -1\nVD20 1.5\nVB30 \"text\"\nVB40 'a$'b$FF'\nEND_DATA_BLOCK\n"
      "SYMBOL_TABLE\nStart\tI0.0\tthe start // button\nLimit\t+500\t\nEND_SYMBOL_TABLE\n");
}

TEST(StlWriter, RoundTripOfAnOlderText) {
  const Program first = readText("a.txt", "LD 10.0 // c\n= Q0.0\nLD I0.1\nCALL1\nMEND\n// sub\nSBR 1\nINCB VB0\nRET\n");
  const std::string written = writeStl(first);
  const Program second = readText("b.awl", written);
  EXPECT_EQ(picture(second, false), picture(first, false)) << written;
  EXPECT_EQ(writeStl(second), written);
}

TEST(StlWriter, CanonicalForm) {
  EXPECT_EQ(
      writeStl(readText(
          "a.awl", "organization_block ob1\nbegin\nnetwork 1\nld i0.0\nldw>=vw10,+5\n=q0.0\nend_organization_block\n")),
      "ORGANIZATION_BLOCK MAIN:OB1\nTITLE=\nBEGIN\nNetwork 1 \nLD     I0.0\nLDW>=  VW10, +5\n=      "
      "Q0.0\nEND_ORGANIZATION_BLOCK\n");
  EXPECT_EQ(writeInstruction(readLines("TONR T5,100").pous[0].networks[0].instructions.at(0)), "TONR   T5, 100");
}

TEST(StlWriter, EveryInstructionCanBeWrittenAndRead) {
  int count = 0;
  for (const Desc& desc : s7200Instructions().all()) {
    if (desc.drawingOnly) continue;
    Instruction instruction;
    instruction.desc = &desc;
    for (int i = 0; i < desc.operandCount; ++i) {
      const bool isRoutine = desc.operand(i).type == Type::Subroutine || desc.operand(i).type == Type::Interrupt;
      instruction.operands.push_back(isRoutine ? constant(3) : direct(Area::V, Width::Word, 10));
    }
    const Program program = readLines(writeInstruction(instruction));
    ASSERT_EQ(program.instructionCount(), 1U) << desc.stl << ' ' << findings(program);
    EXPECT_EQ(show(program.pous[0].networks[0].instructions[0]), show(instruction));
    ++count;
  }
  EXPECT_GT(count, 100);
}

}  // namespace
}  // namespace rungproof
