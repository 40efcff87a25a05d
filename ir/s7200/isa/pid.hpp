// PID loop (001:5056-5325). The loop table, REAL fields at offsets from TBL: 0 PV, 4 SP, 8 output M,
// 12 Kc, 16 Ts (s), 20 Ti (min), 24 Td (min), 28 bias MX, 32 previous PV. Autotune (chapter 15) is not modelled.
// Rising power flow makes the loop bumpless: SP = previous PV = PV, MX = M (001:5289-5293); the history bit of a loop
// is 1 after power-up and STOP to RUN (001:5295). Tests: tests/manual/pid_test.cpp.
#pragma once

#include <bit>

#include "ir/s7200/isa/group.hpp"

namespace rungproof::isa {

struct Pid {
  /// 16 loops from V2.8 on; the rule on features tells what older firmware has.
  static constexpr CpuSet many = cpusWith([](const CpuRow& row) { return row.features.pidLoops == 16; });
  static constexpr Desc desc =
      withOperands({.stl = "PID",
                    .meaning = "PID loop",
                    .group = "math, increment, decrement",
                    .role = Role::Pid,
                    .execution = Execution::Sampled,
                    .stack = {1, 0, 0},
                    .eno = true,
                    .affects = status::Overflow,
                    .time = 40000,
                    .manual = "001:5069"},
                   {inout("TBL", Type::Byte, form::V).elements(36, 80),
                    in("LOOP", Type::Byte, form::Const).within({{0, 7, everyCpu & ~many}, {0, 15, many}})});

  enum Field : int { PV, SP, M, Kc, Ts, Ti, Td, MX, previousPV };

  template <class D>
  static void run(Machine<D>& m, Args<D>& a) {
    const std::uint32_t loop = a.number(1);
    if (loop >= regInfo(Reg::PidHistory).count) return;
    const auto flow = m.powerFlow();
    const auto rising = m.d.land(flow, m.d.lnot(m.getBit(Reg::PidHistory, loop)));
    m.setBit(Reg::PidHistory, loop, flow);
    m.when(flow, [&] { calculate(m, a, rising); });
  }

 private:
  template <class D>
  static void calculate(Machine<D>& m, Args<D>& a, typename D::Bool rising) {
    D& d = m.d;
    const auto field = [&](Field f) { return a.element(0, f, Width::DWord); };
    const auto real = [&](float value) { return m.number(std::bit_cast<std::uint32_t>(value), 32); };
    const auto zero = real(0.0F), one = real(1.0F);
    const auto clamp = [&](typename D::Bits x) {
      return d.select(d.rless(x, zero), zero, d.select(d.rless(one, x), one, x, 32), 32);
    };
    const auto minutes = d.select(m.reads({Choice::PidTimeUnit, "minutes"}), real(60.0F), one, 32);

    const auto pv = field(PV), kc = field(Kc), ts = field(Ts);
    const auto sp = d.select(rising, pv, field(SP), 32);
    const auto previous = d.select(rising, pv, field(previousPV), 32);
    const auto bias = d.select(rising, field(M), field(MX), 32);
    const auto gain = d.select(d.requal(kc, zero), one, kc, 32);  // 001:5205
    const auto error = d.rsub(sp, pv);
    const auto proportional = d.rmul(kc, error);
    const auto integral = d.radd(d.rmul(d.rdiv(d.rmul(gain, ts), d.rmul(field(Ti), minutes)), error), bias);
    const auto differential = d.rmul(d.rdiv(d.rmul(gain, d.rmul(field(Td), minutes)), ts), d.rsub(previous, pv));
    const auto others = d.radd(proportional, differential);
    const auto output = d.radd(others, integral);

    // An arithmetic error aborts the instruction (001:5307); what it has written by then is not stated: nothing here.
    const auto legal = d.rlegal(output);
    m.hazard(Hazard::Overflow, d.lnot(legal));
    m.flag(status::Overflow, d.lnot(legal));
    m.when(legal, [&] {
      const auto above = d.rsub(one, others), below = d.rsub(zero, others);  // 001:5271-5273
      const auto newBias =
          d.select(d.rless(one, output), above, d.select(d.rless(output, zero), below, integral, 32), 32);
      m.when(rising, [&] { a.storeElement(0, SP, Width::DWord, sp); });
      a.storeElement(0, M, Width::DWord, clamp(output));
      a.storeElement(0, MX, Width::DWord, clamp(newBias));
      a.storeElement(0, previousPV, Width::DWord, pv);
    });
  }
};

using PidGroup = Group<Pid>;

}  // namespace rungproof::isa
