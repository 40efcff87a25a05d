// Planted faults: slips that people make in programs, as changed copies of a program. A property set that
// notices none of them says little. Used by the self-check (self_check.hpp). Covered by tests/selfcheck.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "ir/program.hpp"

namespace rungproof {

enum class FaultKind : std::uint8_t {
  Polarity,         ///< normally open for normally closed, or the reverse
  RemovedContact,   ///< bridged in a series, cut out of a parallel circuit
  SetForReset,      ///< S for R, R for S, SR for RS
  LatchOrder,       ///< the rungs of an S and an R of one bit in the other order
  Edge,             ///< EU for ED or the reverse
  TimerKind,        ///< TON for TOF or the reverse
  Preset,           ///< half or twice the preset of a timer or counter
  SwappedNetworks,  ///< two neighbours in the other order
  Connective,       ///< IEC 61131-3: OR for AND or the reverse
};
std::string_view faultKindName(FaultKind kind);

struct Fault {
  FaultKind kind = FaultKind::Polarity;
  std::string text;                ///< "LDN I0.3 for LD I0.3", "NOT Stop for Stop"; of a removed contact "LD I0.3"
  std::uint32_t pou = 0;           ///< index in Program::pous
  std::uint32_t network = 0;       ///< index in Pou::networks
  std::uint32_t instruction = 0;   ///< index in Network::instructions; of a network its first one
  const Desc* desc = nullptr;      ///< what the instruction becomes; nullptr: unchanged
  bool isInserted = false;         ///< that comes behind the instruction instead
  Operands operands{};             ///< with desc: its operands
  std::uint32_t otherNetwork = 0;  ///< LatchOrder: the second rung
  std::uint32_t otherInstruction = 0;
};

/// All faults that can be planted in a program, in program order.
std::vector<Fault> faultsOf(const Program& program);

/// The program with the fault. Instructions keep their numbers, so that the two programs can be compared place by
/// place, but for one that is inserted; call Program::number() for anything that wants them in order.
Program planted(const Program& program, const Fault& fault);

}  // namespace rungproof
