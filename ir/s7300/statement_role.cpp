// The kinds by mnemonic.
#include "ir/s7300/statement_role.hpp"

#include <array>
#include <string_view>
#include <vector>

#include "ir/check.hpp"
#include "ir/s7300/isa.hpp"

namespace rungproof {

namespace {

struct RoleRow {
  StatementRole role;
  std::array<std::string_view, 8> mnemonics;
};

constexpr std::array roleRows = {
    RoleRow{StatementRole::AndScan, {"A", "AN"}},
    RoleRow{StatementRole::OrScan, {"O", "ON"}},
    RoleRow{StatementRole::XorScan, {"X", "XN"}},
    RoleRow{StatementRole::OrOfAnds, {"OR"}},
    RoleRow{StatementRole::Open, {"A(", "AN(", "O(", "ON(", "X(", "XN("}},
    RoleRow{StatementRole::Close, {")"}},
    RoleRow{StatementRole::Edge, {"FP", "FN"}},
    RoleRow{StatementRole::Compare, {"==I", "<>I", ">I", "<I", ">=I", "<=I"}},
    RoleRow{StatementRole::Compare, {"==D", "<>D", ">D", "<D", ">=D", "<=D"}},
    RoleRow{StatementRole::Compare, {">R", "<R", ">=R", "<=R"}},
    RoleRow{StatementRole::CompareRealEqual, {"==R", "<>R"}},
    RoleRow{StatementRole::Negate, {"NOT"}},
    RoleRow{StatementRole::SetRlo, {"SET"}},
    RoleRow{StatementRole::ClearRlo, {"CLR"}},
    RoleRow{StatementRole::Save, {"SAVE"}},
    RoleRow{StatementRole::Assign, {"="}},
    RoleRow{StatementRole::Latch, {"S", "R"}},
    RoleRow{StatementRole::StartTimer, {"SP", "SE", "SD", "SS", "SF"}},
    RoleRow{StatementRole::ResetTimer, {"R T"}},
    RoleRow{StatementRole::FreeTimer, {"FR T"}},
    RoleRow{StatementRole::CountUp, {"CU"}},
    RoleRow{StatementRole::CountDown, {"CD"}},
    RoleRow{StatementRole::SetCounter, {"S C"}},
    RoleRow{StatementRole::ResetCounter, {"R C"}},
    RoleRow{StatementRole::FreeCounter, {"FR C"}},
    RoleRow{StatementRole::JumpAlways, {"JU"}},
    RoleRow{StatementRole::JumpByRlo, {"JC", "JCN"}},
    RoleRow{StatementRole::JumpKeepingRlo, {"JCB", "JNB"}},
    RoleRow{StatementRole::JumpByBr, {"JBI", "JNBI"}},
    RoleRow{StatementRole::JumpByResult, {"JO", "JOS", "JZ", "JN", "JP", "JM", "JPZ", "JMZ"}},
    RoleRow{StatementRole::JumpByResult, {"JUO"}},
    RoleRow{StatementRole::Loop, {"LOOP"}},
    RoleRow{StatementRole::Distributor, {"JL"}},
    RoleRow{StatementRole::End, {"BE", "BEU"}},
    RoleRow{StatementRole::EndByRlo, {"BEC"}},
    RoleRow{StatementRole::Call, {"CALL", "UC"}},
    RoleRow{StatementRole::CallByRlo, {"CC"}},
    RoleRow{StatementRole::OpenRelay, {"MCR("}},
    RoleRow{StatementRole::CloseRelay, {")MCR"}},
    RoleRow{StatementRole::Relay, {"MCRA", "MCRD"}},
    RoleRow{StatementRole::Load, {"L"}},
    RoleRow{StatementRole::Transfer, {"T"}},
    RoleRow{StatementRole::TransferStatus, {"T STW"}},
    RoleRow{StatementRole::LoadAr1, {"LAR1"}},
    RoleRow{StatementRole::LoadAr2, {"LAR2"}},
    RoleRow{StatementRole::StoreAr1, {"TAR1"}},
    RoleRow{StatementRole::StoreAr2, {"TAR2"}},
    RoleRow{StatementRole::Ar2ToAr1, {"LAR1 AR2"}},
    RoleRow{StatementRole::Ar1ToAr2, {"TAR1 AR2"}},
    RoleRow{StatementRole::ExchangeAr, {"CAR"}},
    RoleRow{StatementRole::MoveAr1, {"+AR1"}},
    RoleRow{StatementRole::MoveAr2, {"+AR2"}},
    RoleRow{StatementRole::OpenBlock, {"OPN"}},
    RoleRow{StatementRole::ExchangeBlocks, {"CDB"}},
    RoleRow{StatementRole::FromBcd, {"BTI", "BTD"}},
    RoleRow{StatementRole::IntegerMath, {"+I", "-I", "*I", "/I", "+D", "-D", "*D", "/D"}},
    RoleRow{StatementRole::IntegerMath, {"MOD"}},
    RoleRow{StatementRole::IntegerStep, {"+", "INC", "DEC"}},
    RoleRow{StatementRole::RealMath, {"+R", "-R", "*R", "/R"}},
    RoleRow{StatementRole::MoveAccus, {"TAK", "PUSH", "POP", "ENT", "LEAVE"}},
    RoleRow{StatementRole::Nothing, {"NOP 0", "NOP 1", "BLD"}},
};

std::vector<StatementRole> rolesByOpcode() {
  std::vector<StatementRole> roles(s7300Instructions().all().size(), StatementRole::Other);
  for (const RoleRow& row : roleRows) {
    for (const std::string_view mnemonic : row.mnemonics) {
      if (mnemonic.empty()) continue;
      const Desc* desc = s7300Instructions().named(mnemonic);
      CHECK(desc != nullptr, "the rows name instructions that exist");
      roles[desc->opcode] = row.role;
    }
  }
  return roles;
}

}  // namespace

StatementRole statementRole(const Instruction& instruction) {
  static const std::vector<StatementRole> roles = rolesByOpcode();
  static const Desc* const first = s7300Instructions().all().data();
  const Desc* desc = instruction.desc;
  const bool isOurs = desc->opcode < roles.size() && desc == first + desc->opcode;
  return isOurs ? roles[desc->opcode] : StatementRole::Other;
}

ScanJoin scanJoin(const Instruction& instruction) {
  const std::string_view name = instruction.desc->stl;
  const StatementRole role = name.starts_with('A')   ? StatementRole::AndScan
                             : name.starts_with('O') ? StatementRole::OrScan
                                                     : StatementRole::XorScan;
  return {role, name.size() > 1 && name[1] == 'N'};
}

std::optional<std::uint32_t> divisorBits(const Instruction& instruction) {
  const StatementRole role = statementRole(instruction);
  const std::string_view name = instruction.desc->stl;
  if (role == StatementRole::RealMath) return name == "/R" ? std::optional(0x7FFFFFFFU) : std::nullopt;
  if (role != StatementRole::IntegerMath) return std::nullopt;
  if (name == "/I") return 0xFFFFU;
  return name == "/D" || name == "MOD" ? std::optional(0xFFFFFFFFU) : std::nullopt;
}

std::optional<Product> productOf(const Instruction& instruction) {
  if (statementRole(instruction) != StatementRole::IntegerMath) return std::nullopt;
  const std::string_view name = instruction.desc->stl;
  if (name == "*I") return Product::Whole;
  return name == "*D" ? std::optional(Product::LowHalf) : std::nullopt;
}

bool comparesForEquality(const Instruction& instruction) {
  const std::string_view name = instruction.desc->stl;
  return statementRole(instruction) == StatementRole::Compare && (name.starts_with("==") || name.starts_with("<>"));
}

bool loadsElement(const Instruction& instruction) {
  const std::string_view name = instruction.desc->stl;
  return name == "L T" || name == "LC T" || name == "L C" || name == "LC C";
}

bool loadsStatus(const Instruction& instruction) { return instruction.desc->stl == "L STW"; }

bool loadsBlockFact(const Instruction& instruction) { return instruction.desc->stl.starts_with("L D"); }

bool loadsInstanceNumber(const Instruction& instruction) { return instruction.desc->stl == "L DINO"; }
const Desc* setRloStatement() { return s7300Instructions().named("SET"); }

bool asksOverflow(const Instruction& instruction) {
  const StatementRole role = statementRole(instruction);
  const std::string_view name = instruction.desc->stl;
  if (role == StatementRole::JumpByResult) return name == "JO" || name == "JOS";
  const bool isScan = role == StatementRole::AndScan || role == StatementRole::OrScan || role == StatementRole::XorScan;
  if (!isScan || instruction.operands.empty() || instruction.operands[0].kind != OperandKind::Constant) return false;
  return instruction.operands[0].text == "OV" || instruction.operands[0].text == "OS";
}

}  // namespace rungproof
