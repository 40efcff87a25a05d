// Builds the table of kinds from the mnemonics once.
#include "analysis/instruction_kind.hpp"

#include <string_view>
#include <utility>
#include <vector>

#include "ir/isa.hpp"

namespace rungproof {

namespace {

constexpr std::pair<std::string_view, Kind> named[] = {
    {"NOT", Kind::Not},
    {"EU", Kind::Eu},
    {"ED", Kind::Ed},
    {"ALD", Kind::Ald},
    {"OLD", Kind::Old},
    {"LPS", Kind::Lps},
    {"LRD", Kind::Lrd},
    {"LPP", Kind::Lpp},
    {"LDS", Kind::Lds},
    {"AENO", Kind::Aeno},
    {"=", Kind::Assign},
    {"=I", Kind::AssignImmediate},
    {"S", Kind::Set},
    {"R", Kind::Reset},
    {"SI", Kind::SetImmediate},
    {"RI", Kind::ResetImmediate},
    {"SR", Kind::Sr},
    {"RS", Kind::Rs},
    {"TON", Kind::Ton},
    {"TOF", Kind::Tof},
    {"TONR", Kind::Tonr},
    {"CTU", Kind::Ctu},
    {"CTD", Kind::Ctd},
    {"CTUD", Kind::Ctud},
    {"MUL", Kind::Mul},
    {"DIV", Kind::Div},
    {"/I", Kind::DivInt},
    {"/D", Kind::DivDInt},
    {"/R", Kind::DivReal},
    {"MOVB", Kind::MoveByte},
    {"MOVW", Kind::MoveWord},
    {"MOVD", Kind::MoveDWord},
    {"MOVR", Kind::MoveReal},
    {"BMB", Kind::BlockByte},
    {"BMW", Kind::BlockWord},
    {"BMD", Kind::BlockDWord},
    {"FILL", Kind::Fill},
    {"SHRB", Kind::Shrb},
    {"ATT", Kind::Att},
    {"LIFO", Kind::Lifo},
    {"FIFO", Kind::Fifo},
    {"SLB", Kind::Shift},
    {"SLW", Kind::Shift},
    {"SLD", Kind::Shift},
    {"SRB", Kind::Shift},
    {"SRW", Kind::Shift},
    {"SRD", Kind::Shift},
    {"RLB", Kind::Rotate},
    {"RLW", Kind::Rotate},
    {"RLD", Kind::Rotate},
    {"RRB", Kind::Rotate},
    {"RRW", Kind::Rotate},
    {"RRD", Kind::Rotate},
    {"FND=", Kind::Find},
    {"FND<>", Kind::Find},
    {"FND<", Kind::Find},
    {"FND>", Kind::Find},
    {"SLEN", Kind::StringLength},
    {"SCPY", Kind::StringCopy},
    {"SCAT", Kind::StringAppend},
    {"SSCPY", Kind::StringPart},
    {"SFND", Kind::StringFind},
    {"CFND", Kind::StringFind},
    {"STI", Kind::StringConvert},
    {"STD", Kind::StringConvert},
    {"STR", Kind::StringConvert},
    {"ATH", Kind::AsciiToHex},
    {"HTA", Kind::HexToAscii},
    {"ATCH", Kind::Atch},
    {"DTCH", Kind::Dtch},
    {"CEVNT", Kind::Cevnt},
    {"ENI", Kind::Eni},
    {"DISI", Kind::Disi},
    {"HDEF", Kind::Hdef},
    {"HSC", Kind::Hsc},
    {"PLS", Kind::Pls},
    {"PID", Kind::Pid},
    {"NETR", Kind::Netr},
    {"NETW", Kind::Netw},
    {"XMT", Kind::Xmt},
    {"RCV", Kind::Rcv},
    {"GPA", Kind::Gpa},
    {"SPA", Kind::Spa},
    {"TODR", Kind::Todr},
    {"TODRX", Kind::Todr},
    {"TODW", Kind::Todw},
    {"TODWX", Kind::Todw},
    {"INCD", Kind::IncDWord},
    {"DECD", Kind::DecDWord},
    {"+D", Kind::AddDInt},
    {"-D", Kind::SubDInt},
    {"+I", Kind::AddInt},
    {"-I", Kind::SubInt},
    {"WDR", Kind::Wdr},
};

Kind kindByShape(const Desc& desc) {
  const bool isContact =
      (desc.execution == Execution::Stack || desc.execution == Execution::Compare) && desc.operandCount > 0;
  if (isContact && desc.stl.starts_with("LD")) return Kind::Load;
  if (isContact && desc.stl.starts_with("A")) return Kind::And;
  if (isContact && desc.stl.starts_with("O")) return Kind::Or;
  if (desc.drawingOnly && desc.operandCount > 0 && desc.operands[0].type == Type::Timer) return Kind::IecTimer;
  if (desc.drawingOnly && desc.operandCount > 0 && desc.operands[0].type == Type::Counter) return Kind::IecCounter;
  return Kind::Other;
}

std::vector<Kind> makeTable() {
  std::vector<Kind> table;
  for (const Desc& desc : instructionTable()) {
    Kind kind = kindByShape(desc);
    for (const auto& [name, value] : named) {
      if (name == desc.stl) kind = value;
    }
    table.push_back(kind);
  }
  return table;
}

}  // namespace

Kind kindOf(const Desc& desc) {
  static const std::vector<Kind> table = makeTable();
  return table[desc.opcode];
}

bool isTimerBox(Kind kind) {
  return kind == Kind::Ton || kind == Kind::Tof || kind == Kind::Tonr || kind == Kind::IecTimer;
}

bool isCounterBox(Kind kind) {
  return kind == Kind::Ctu || kind == Kind::Ctd || kind == Kind::Ctud || kind == Kind::IecCounter;
}

bool isLogic(Kind kind) { return kind >= Kind::Load && kind <= Kind::Aeno; }

}  // namespace rungproof
