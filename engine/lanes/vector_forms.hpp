// VectorForms: one vector instruction in its forms for bytes, words, double and quad words.
#pragma once

#include <asmjit/x86.h>

#include <array>

#include "engine/lanes/lane_layout.hpp"

namespace rungproof::lanes {

using VectorForms = std::array<asmjit::InstId, 4>;
constexpr asmjit::InstId formOf(const VectorForms& forms, Rep rep) { return forms[static_cast<std::size_t>(rep) - 1]; }

namespace forms {
using namespace asmjit::x86;
inline constexpr VectorForms addition = {Inst::kIdVpaddb, Inst::kIdVpaddw, Inst::kIdVpaddd, Inst::kIdVpaddq};
inline constexpr VectorForms subtraction = {Inst::kIdVpsubb, Inst::kIdVpsubw, Inst::kIdVpsubd, Inst::kIdVpsubq};
/// Of AVX2: all ones where both are the same.
inline constexpr VectorForms equality = {Inst::kIdVpcmpeqb, Inst::kIdVpcmpeqw, Inst::kIdVpcmpeqd, Inst::kIdVpcmpeqq};
/// Bytes have none.
inline constexpr VectorForms shiftLeft = {Inst::kIdNone, Inst::kIdVpsllw, Inst::kIdVpslld, Inst::kIdVpsllq};
inline constexpr VectorForms shiftRight = {Inst::kIdNone, Inst::kIdVpsrlw, Inst::kIdVpsrld, Inst::kIdVpsrlq};
/// Of AVX-512: under a mask, from or to memory too.
inline constexpr VectorForms maskedMove = {Inst::kIdVmovdqu8, Inst::kIdVmovdqu16, Inst::kIdVmovdqa32,
                                           Inst::kIdVmovdqa64};
inline constexpr VectorForms bitTest = {Inst::kIdVptestmb, Inst::kIdVptestmw, Inst::kIdVptestmd, Inst::kIdVptestmq};
}  // namespace forms

}  // namespace rungproof::lanes
