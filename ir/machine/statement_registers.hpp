// The registers of an S7-300/400: status word, accumulators, address and data block registers, nesting and MCR stacks
// (002:1424-1438, 002:1549-1581). They are values of one run of an organization block: nothing of them outlives it, and
// what they hold at its start is not stated, so that a program that depends on it shows it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "ir/flow.hpp"

namespace rungproof {

/// What an opening parenthesis joins the inner result with, as the nesting stack keeps it.
enum class Joint : std::uint8_t { And, AndNot, Or, OrNot, Xor, XorNot };

inline constexpr std::size_t nestingLevels = 7;  // general knowledge
inline constexpr std::size_t mcrLevels = 8;      // general knowledge

/// A block that runs, with what its operands depend on.
template <class D>
struct Activation {
  using Bits = typename D::Bits;
  const Pou* pou = nullptr;
  const Instruction* call = nullptr;  ///< nullptr: an organization block
  const Activation* caller = nullptr;
  std::uint32_t localBase = 0;  ///< byte of L memory at which its own begins
  int level = 0;
  Bits callerDb{}, callerDi{}, callerAr2{};  ///< registers at the call
};

/// A pointer as a parameter (ir/s7300/handed_pointer.hpp).
template <class D>
struct HandedPointer {
  using Bits = typename D::Bits;
  Bits head{};     ///< of an ANY: 16#10, type, number of elements; 32 bits
  Bits block{};    ///< 16 bits
  Bits pointer{};  ///< 32 bits
};

template <class D>
struct Step7Registers {
  using Bool = typename D::Bool;
  using Bits = typename D::Bits;
  struct Nesting {
    Bool rlo, orBit, firstCheck;
    Bits joint;  ///< 3 bits
  };

  explicit Step7Registers(D& d)
      : br(d.constant(false)),
        cc1(br),
        cc0(br),
        ov(br),
        os(br),
        orBit(br),
        sta(br),
        rlo(br),
        firstCheck(br),
        mcrActive(br),
        syncError(br),
        accessError(br),
        failed(br),
        isMasking(br),
        isReplaced(br),
        jumps(br) {
    accu.fill(d.literal(0, 32));
    ar.fill(d.literal(0, 32));
    db = di = d.literal(0, 16);
    fault = delays = d.literal(0, 8);
    replacement = d.literal(0, 32);
    nesting.fill({br, br, br, d.literal(0, 3)});
    mcr.fill(d.constant(true));
  }

  /// Calls onBit(register) and onBits(register, width) for all of them.
  template <class OnBit, class OnBits>
  void each(OnBit&& onBit, OnBits&& onBits) {
    for (Bool* bit : {&br, &cc1, &cc0, &ov, &os, &orBit, &sta, &rlo, &firstCheck, &mcrActive}) onBit(*bit);
    for (Bool& level : mcr) onBit(level);
    for (Bits& a : accu) onBits(a, 32);
    for (Bits& a : ar) onBits(a, 32);
    onBits(db, 16);
    onBits(di, 16);
    onBits(delays, 8);
    onBit(isMasking);
    onBit(isReplaced);
    onBits(replacement, 32);
    for (Nesting& n : nesting) {
      onBit(n.rlo);
      onBit(n.orBit);
      onBit(n.firstCheck);
      onBits(n.joint, 3);
    }
  }

  Bool br, cc1, cc0, ov, os, orBit, sta, rlo;
  Bool firstCheck;  ///< /FC: 0 where the next scan begins a logic string (003:1292)
  std::array<Bits, 4> accu;
  std::array<Bits, 2> ar;
  Bits db, di;                                 ///< numbers of the open blocks, 16 bits; 0: none
  std::array<Nesting, nestingLevels> nesting;  ///< [0] was opened last
  Bool mcrActive;
  std::array<Bool, mcrLevels> mcr;  ///< [0] was pushed last; levels that nothing was pushed to are 1
  Bool syncError;                   ///< OB121 is due (002:1278)
  Bits fault;                       ///< of it, 8 bits, as OB121_SW_FLT; 0: not known
  Bool accessError;                 ///< OB122 is due (002:1292)
  Bool failed;                      ///< the instruction has met one of both, masked or not
  Bool isMasking;                   ///< SFC 36 has been called and SFC 37 not since
  bool isErrorBlock = false;        ///< OB121, OB122 or what they call
  Bits delays;                      ///< calls of SFC 41 that SFC 42 has not taken back, 8 bits
  Bool isReplaced;                  ///< SFC 44 has given the error block's result for ACCU1 (002:2342)
  Bits replacement;
  Bool jumps;  ///< what a branching instruction decided
  const Activation<D>* running = nullptr;
};

}  // namespace rungproof
