// Drawing random programs.
#include "program_generator.hpp"

#include <fmt/format.h>

namespace rungproof::reference {

std::string ProgramGenerator::program() {
  std::string text = "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\nNetwork 1\n" + start();
  const int rungs = 8 + pick(8);
  for (int n = 0; n < rungs; ++n) {
    text += fmt::format("Network {}\n", n + 2);
    switch (pick(13)) {
      case 0: text += loop(); break;
      case 1: text += jump(n); break;
      case 2: text += segment(n); break;
      case 3: text += load() + "CALL SBR0\n"; break;
      case 4: text += counter(n); break;
      case 5: text += timer(n); break;
      case 6: text += pick(3) == 0 ? pid() : rung(); break;
      default: text += rung(); break;
    }
  }
  if (pick(3) == 0) text += "Network 90\nLD I0.6\nA I0.7\nEND\nNetwork 91\n" + rung();
  text += "END_ORGANIZATION_BLOCK\nSUBROUTINE_BLOCK SBR_0:SBR0\nBEGIN\nNetwork 1\n" + rung() +
          "Network 2\nLD I0.5\nA I0.6\nCRET\nNetwork 3\n" + rung() + "END_SUBROUTINE_BLOCK\n";
  return text + "INTERRUPT_BLOCK INT_0:INT0\nBEGIN\nNetwork 1\nLD SM0.0\nNOP 1\nEND_INTERRUPT_BLOCK\n";
}

/// The first scan: a table, a pointer, strings, a PID table.
std::string ProgramGenerator::start() {
  std::string text =
      "LD SM0.1\nMOVW 5, VW100\nMOVW 0, VW102\nMOVD &VB8, VD140\nSCPY \"12.5\", VB300\nSCPY \"-7 ab\", VB600\nSPA 9, "
      "0\n";
  for (const auto& [offset, value] : {std::pair{0, "0.4"},
                                      {4, "0.5"},
                                      {8, "0.2"},
                                      {12, "1.5"},
                                      {16, "0.1"},
                                      {20, "2.0"},
                                      {24, "0.001"},
                                      {28, "0.1"},
                                      {32, "0.4"}})
    text += fmt::format("MOVR {}, VD{}\n", value, 1260 + offset);
  return text;
}

std::string ProgramGenerator::bit() {
  switch (pick(7)) {
    case 0:
    case 1: return fmt::format("I0.{}", pick(8));
    case 2: return fmt::format("Q0.{}", pick(8));
    case 3: return fmt::format("M{}.{}", pick(3), pick(8));
    case 4: return fmt::format("V{}.{}", pick(6), pick(8));
    case 5: return fmt::format("SM1.{}", pick(8));
    default: return any({"T40", "T33", "C10", "C12", "T97", "T101", "T4", "T8", "SM4.3"});
  }
}
std::string ProgramGenerator::target() {
  switch (pick(3)) {
    case 0: return fmt::format("Q0.{}", pick(8));
    case 1: return fmt::format("M{}.{}", pick(3), pick(8));
    default: return fmt::format("V{}.{}", pick(6), pick(8));
  }
}
std::string ProgramGenerator::byte(bool constant) {
  return constant && pick(3) == 0 ? fmt::format("{}", pick(256))
                                  : any({"VB8", "VB9", "VB20", "MB4", "AC0", "AC1", "IB0", "QB0", "*VD140"});
}
std::string ProgramGenerator::byteOut() { return any({"VB8", "VB9", "VB20", "MB4", "AC0", "AC1", "*VD140"}); }
std::string ProgramGenerator::word(bool constant) {
  if (constant && pick(3) == 0) return any({"0", "1", "-1", "32767", "-32768", "100", "9999", "16#1234", "7"});
  return any({"VW8", "VW9", "VW12", "MW4", "AC0", "AC2", "C11", "T41", "VW20", "*VD140"});
}
std::string ProgramGenerator::wordOut() { return any({"VW8", "VW9", "VW12", "MW4", "AC0", "AC2", "VW20", "*VD140"}); }
std::string ProgramGenerator::dword(bool constant) {
  return constant && pick(3) == 0 ? any({"0", "1", "-1", "2147483647", "-2147483648", "65536", "16#80000001"})
                                  : any({"VD8", "VD20", "VD24", "MD4", "AC0", "AC3"});
}
std::string ProgramGenerator::dwordOut() { return any({"VD8", "VD20", "VD24", "MD4", "AC0", "AC3"}); }
std::string ProgramGenerator::real() {
  return pick(2) == 0 ? any({"0.0", "1.0", "-2.5", "1.0E+20", "0.1", "12.75", "-0.004"})
                      : any({"VD40", "VD44", "VD48"});
}
std::string ProgramGenerator::realOut() { return any({"VD40", "VD44", "VD48"}); }
std::string ProgramGenerator::roundedOut() { return any({"VD52", "VD56", "VD60", "VD64", "VD68", "VD72", "VD76"}); }
std::string ProgramGenerator::text(bool constant) {
  return constant && pick(3) == 0 ? any({"\"ab\"", "\"1\"", "\"-3.5x\"", "\"\"", "\"  +42\"", "\"b\""})
                                  : any({"VB300", "VB600", "VB900"});
}

std::string ProgramGenerator::compare(const std::string& joint) {
  const std::string relation = any({"=", "<>", "<", "<=", ">", ">="});
  switch (pick(5)) {
    case 0: return fmt::format("{}B{} {}, {}\n", joint, relation, byte(false), byte(true));
    case 1: return fmt::format("{}W{} {}, {}\n", joint, relation, word(false), word(true));
    case 2: return fmt::format("{}R{} {}, {}\n", joint, relation, realOut(), real());
    case 3: return fmt::format("{}S{} {}, {}\n", joint, any({"=", "<>"}), text(true), text(false));
    default: return fmt::format("{}D{} {}, {}\n", joint, relation, dword(false), dword(true));
  }
}

std::string ProgramGenerator::load() {
  std::string text = pick(4) == 0   ? compare("LD")
                     : pick(6) == 0 ? fmt::format("{} I0.{}\n", any({"LDI", "LDNI"}), pick(8))
                                    : fmt::format("{} {}\n", any({"LD", "LDN"}), bit());
  for (int n = pick(4); n > 0; --n) {
    switch (pick(10)) {
      case 0: text += fmt::format("LD {}\nAN {}\n{}\n", bit(), bit(), any({"ALD", "OLD"})); break;
      case 1: text += compare(any({"A", "O"})); break;
      case 2: text += any({"NOT\n", "EU\n", "ED\n", "AENO\n", "LDS 1\nLPP\n", "NOP 3\n"}); break;
      case 3: text += fmt::format("LPS\nA {}\n= {}\nLRD\nAN {}\n= {}\nLPP\n", bit(), target(), bit(), target()); break;
      case 4: text += fmt::format("{} I0.{}\n", any({"AI", "ANI", "OI", "ONI"}), pick(8)); break;
      default: text += fmt::format("{} {}\n", any({"A", "AN", "O", "ON"}), bit()); break;
    }
  }
  return text;
}

std::string ProgramGenerator::box() {
  switch (pick(12)) {
    case 0: return fmt::format("{} {}, {}\n", any({"S", "R"}), target(), 1 + pick(12));
    case 1: return fmt::format("{} Q0.{}, {}\n", any({"SI", "RI"}), pick(8), 1 + pick(5));
    case 2: return fmt::format("=I Q0.{}\n", pick(8));
    case 3: return outsideBox();
    case 4: return tableBox();
    case 5: return characterBox();
    case 6: return stringBox();
    case 7: return conversion();
    case 8: return realBox();
    default: return wordBox();
  }
}

std::string ProgramGenerator::wordBox() {
  switch (pick(14)) {
    case 0: return fmt::format("{} {}, {}\n", any({"+I", "-I", "*I", "/I"}), word(true), wordOut());
    case 1: return fmt::format("{} {}, {}\n", any({"+D", "-D", "*D", "/D"}), dword(true), dwordOut());
    case 2: return fmt::format("{} {}, {}\n", any({"MUL", "DIV"}), word(true), dwordOut());
    case 3: return any({"INCB ", "DECB ", "INVB "}) + byteOut() + "\n";
    case 4: return any({"INCW ", "DECW ", "INVW ", "SWAP "}) + wordOut() + "\n";
    case 5: return any({"INCD ", "DECD ", "INVD "}) + dwordOut() + "\n";
    case 6: return fmt::format("{} {}, {}\n", any({"ANDB", "ORB", "XORB", "MOVB"}), byte(true), byteOut());
    case 7: return fmt::format("{} {}, {}\n", any({"ANDW", "ORW", "XORW", "MOVW"}), word(true), wordOut());
    case 8: return fmt::format("{} {}, {}\n", any({"ANDD", "ORD", "XORD", "MOVD"}), dword(true), dwordOut());
    case 9: return fmt::format("{} {}, {}\n", any({"SLB", "SRB", "RLB", "RRB"}), byteOut(), pick(20));
    case 10: return fmt::format("{} {}, {}\n", any({"SLW", "SRW", "RLW", "RRW"}), wordOut(), pick(36));
    case 11: return fmt::format("{} {}, {}\n", any({"SLD", "SRD", "RLD", "RRD"}), dwordOut(), pick(70));
    case 12: return fmt::format("SHRB {}, V80.{}, {}\n", bit(), pick(8), any({"1", "5", "14", "-3", "-14", "32"}));
    default:
      return one({fmt::format("BMB VB8, VB84, {}\n", 1 + pick(6)), fmt::format("BMW VW84, VW86, {}\n", 1 + pick(4)),
                  fmt::format("BMD VD20, VD88, {}\n", 1 + pick(2)),
                  fmt::format("MOVD &{}, VD140\n", any({"VB8", "VB20", "MB4", "VB9"}))});
  }
}

std::string ProgramGenerator::realBox() {
  switch (pick(4)) {
    case 0: return fmt::format("{} {}, {}\n", any({"SIN", "COS", "TAN", "LN", "EXP"}), real(), roundedOut());
    case 1: return fmt::format("{} {}, {}\n", any({"SQRT", "MOVR"}), real(), realOut());
    case 2: return fmt::format("{} {}, {}\n", any({"ROUND", "TRUNC"}), real(), dwordOut());
    default: return fmt::format("{} {}, {}\n", any({"+R", "-R", "*R", "/R"}), real(), realOut());
  }
}

std::string ProgramGenerator::conversion() {
  return one({fmt::format("BTI {}, {}\n", byte(true), wordOut()), fmt::format("ITB {}, {}\n", word(true), byteOut()),
              fmt::format("ITD {}, {}\n", word(true), dwordOut()), fmt::format("DTI {}, {}\n", dword(true), wordOut()),
              fmt::format("DTR {}, VD40\n", dword(true)), fmt::format("SEG {}, {}\n", byte(true), byteOut()),
              fmt::format("DECO {}, {}\n", byte(true), wordOut()), fmt::format("ENCO {}, {}\n", word(true), byteOut()),
              fmt::format("BCDI {}\n", wordOut()), fmt::format("IBCD {}\n", wordOut())});
}

std::string ProgramGenerator::characterBox() {
  switch (pick(4)) {
    case 0:
      return one({fmt::format("ATH VB1200, {}, {}\n", any({"VB8", "VB1240"}), pick(9)),
                  fmt::format("HTA {}, VB1200, {}\n", any({"VB8", "VB20", "VB1240"}), pick(9))});
    case 1:
      return one({fmt::format("ITA {}, VB1210, {}\n", word(true), pick(16)),
                  fmt::format("DTA {}, VB1220, {}\n", dword(true), pick(16)),
                  fmt::format("RTA {}, VB1200, 16#{:X}\n", real(), (2 + pick(14)) << 4 | pick(16))});
    case 2:
      return one({fmt::format("ITS {}, {}, {}\n", any({"VW8", "VW12", "MW4"}), pick(16), text(false)),
                  fmt::format("DTS {}, {}, {}\n", dword(true), pick(16), text(false)),
                  fmt::format("RTS {}, 16#{:X}, {}\n", real(), (2 + pick(14)) << 4 | pick(16), text(false))});
    default:
      return one({fmt::format("STI {}, {}, {}\n", text(true), pick(5), wordOut()),
                  fmt::format("STD {}, {}, {}\n", text(true), pick(5), dwordOut()),
                  fmt::format("STR {}, {}, {}\n", text(true), pick(5), roundedOut())});
  }
}

std::string ProgramGenerator::stringBox() {
  return one({fmt::format("SLEN {}, {}\n", text(true), byteOut()),
              fmt::format("SCPY {}, {}\n", text(true), text(false)),
              fmt::format("SCAT {}, {}\n", text(true), text(false)),
              fmt::format("SSCPY {}, {}, {}, {}\n", text(true), pick(6), pick(9), text(false)),
              fmt::format("SFND {}, {}, {}\n", text(false), text(true), byteOut()),
              fmt::format("CFND {}, {}, {}\n", text(false), text(true), byteOut())});
}

std::string ProgramGenerator::tableBox() {
  return one({fmt::format("ATT {}, VW100\n", word(true)), fmt::format("FIFO VW100, {}\n", wordOut()),
              fmt::format("LIFO VW100, {}\n", wordOut()), fmt::format("FILL {}, VW92, {}\n", word(true), 1 + pick(4)),
              fmt::format("FND{} VW102, {}, {}\n", any({"=", "<>", "<", ">"}), word(true), wordOut())});
}

std::string ProgramGenerator::outsideBox() {
  return one({fmt::format("BIR IB0, {}\n", byteOut()), fmt::format("BIW {}, QB0\n", byte(true)), "ENI\n", "DISI\n",
              "ATCH INT0, 12\n", "DTCH 12\n", "CEVNT 12\n", "WDR\n", fmt::format("DLED {}\n", byte(true)),
              fmt::format("GPA {}, 0\n", byteOut()), fmt::format("SPA {}, 0\n", byte(true)),
              "MOVD 16#04060517, VD1290\nMOVD 16#10200003, VD1294\nTODW VB1290\n", "TODWX VB1200\n"});
}

std::string ProgramGenerator::rung() {
  std::string text = load();
  for (int n = 1 + pick(3); n > 0; --n) text += pick(3) == 0 ? fmt::format("= {}\n", target()) : box();
  return text;
}
std::string ProgramGenerator::loop() {
  return load() + fmt::format("FOR VW124, {}, {}\n", pick(3), pick(5)) + rung() + rung() + "NEXT\n";
}
std::string ProgramGenerator::jump(int n) {
  return load() + fmt::format("JMP {}\n", n) + rung() + fmt::format("LBL {}\n", n) + rung();
}
std::string ProgramGenerator::segment(int n) {
  const std::string early = pick(2) == 0 ? fmt::format("LD {}\nCSCRE\n", bit()) + rung() : "";
  return fmt::format("{}S S0.{}, 1\nNetwork {}\nLSCR S0.{}\n", load(), n % 8, 100 + n, n % 8) + rung() +
         (pick(3) == 0 ? timer(n) : "") + early + fmt::format("LD {}\nSCRT S0.{}\n", bit(), (n + 1) % 8) + "SCRE\n";
}
std::string ProgramGenerator::counter(int n) {
  const std::string name = any({"CTU", "CTD", "CTUD"});
  return load() + load() + (name == "CTUD" ? load() : "") +
         fmt::format("{} C{}, {}\n", name, 10 + n, any({"1", "2", "3", "0"}));
}
std::string ProgramGenerator::timer(int n) {
  static constexpr int numbers[] = {33, 34, 35, 36, 97, 98, 99, 100, 40, 41, 42, 43, 101, 102, 103, 104};
  static constexpr int retentive[] = {1, 2, 3, 4, 65, 66, 67, 68, 5, 6, 7, 8, 69, 70, 71, 72};
  if (pick(3) == 0)
    return load() + fmt::format("TONR T{}, {}\n", retentive[n], any({"1", "3", "10"})) +
           (pick(2) == 0 ? fmt::format("LD {}\nR T{}, 1\n", bit(), retentive[n]) : "");
  return load() + fmt::format("{} T{}, {}\n", any({"TON", "TOF"}), numbers[n], any({"1", "3", "10"}));
}
std::string ProgramGenerator::pid() {
  return load() + fmt::format("MOVR {}, VD1260\n", any({"0.1", "0.45", "0.5", "0.9"})) + load() + "PID VB1260, 0\n";
}

}  // namespace rungproof::reference
