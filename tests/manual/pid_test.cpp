// PID (001:5056-5325). All numbers are exact in binary. Unless said otherwise Ts = 60 s, Ti = 2 min, Td = 0.5 min, so
// that Ts/Ti = 60/120 = 0.5 and Td/Ts = 30/60 = 0.5. Fields: VD0 PV, VD4 SP, VD8 M, VD12 Kc, VD16 Ts, VD20 Ti, VD24 Td,
// VD28 MX, VD32 previous PV. M = Kc e + MI + MD, e = SP - PV, MI = k Ts/Ti e + MX, MD = k Td/Ts (previous - PV).
#include "example.hpp"

namespace rungproof::manual {
namespace {

const std::string times = " VD16=60.0 VD20=2.0 VD24=0.5 PID.history[0]=1";

}  // namespace

TEST(Pid, FormulaWithinTheRange) {
  check({
      // e = 0.5: MP = 0.125, MI = 0.25 * 0.5 * 0.5 + 0.125 = 0.1875, MD = 0.25 * 0.5 * 0.25 = 0.03125.
      {"PID VB0, 0", "VD0=0.25 VD4=0.75 VD8=0.5 VD12=0.25 VD28=0.125 VD32=0.5" + times,
       "VD8=0.34375 VD28=0.1875 VD32=0.25 SM1.1=0"},
      // Negative gain, e = -0.5: MP = 0.125, MI = -0.25 * 0.5 * -0.5 + 0.25 = 0.3125, MD = -0.25 * 0.5 * -0.25 =
      // 0.03125.
      {"PID VB0, 0", "VD0=0.75 VD4=0.25 VD12=-0.25 VD28=0.25 VD32=0.5" + times,
       "VD8=0.46875 VD28=0.3125 VD32=0.75 SM1.1=0"},
      // Kc = 0 leaves I and D with gain 1 (001:5205): MI = 0.5 * 0.5 + 0.125 = 0.375, MD = 0.5 * 0.25 = 0.125.
      {"PID VB0, 0", "VD0=0.25 VD4=0.75 VD28=0.125 VD32=0.5" + times, "VD8=0.5 VD28=0.375 VD32=0.25 SM1.1=0"},
      // Ti infinite and Td 0 leave MP + MX: 0.125 + 0.125.
      {"PID VB0, 0", "VD0=0.25 VD4=0.75 VD12=0.25 VD16=60.0 VD20=inf VD28=0.125 VD32=0.5 PID.history[0]=1",
       "VD8=0.25 VD32=0.25 SM1.1=0"},
      // The factors without 60: Ts = 2, Ti = 4, Td = 1 give the same ratios.
      {"PID VB0, 0", "VD0=0.25 VD4=0.75 VD12=0.25 VD16=2.0 VD20=4.0 VD24=1.0 VD28=0.125 VD32=0.5 PID.history[0]=1",
       "VD8=0.34375 VD28=0.1875 VD32=0.25 SM1.1=0", "", "pid-time-unit=seconds"},
      // The table may stand anywhere in V.
      {"PID VB100, 7",
       "VD100=0.25 VD104=0.75 VD112=0.25 VD116=60.0 VD120=2.0 VD124=0.5 VD128=0.125 VD132=0.5 PID.history[7]=1",
       "VD108=0.34375 VD128=0.1875 VD132=0.25 SM1.1=0"},
  });
}

TEST(Pid, OutputAndBiasAreKeptBetween0And1) {
  check({
      // Kc = 1, e = 0.5: MP 0.5, MI 0.25 + 0.75 = 1.0, MD 0.5 * -0.125 = -0.0625: M = 1.4375, MX = 1 - 0.4375.
      {"PID VB0, 0", "VD0=0.25 VD4=0.75 VD12=1.0 VD28=0.75 VD32=0.125" + times,
       "VD8=1.0 VD28=0.5625 VD32=0.25 SM1.1=0"},
      // Kc = 2: MP 1.0, MI 0.5 + 0.125, MD 0.25: M = 1.875, MX = 1 - 1.25 is below 0.
      {"PID VB0, 0", "VD0=0.25 VD4=0.75 VD12=2.0 VD28=0.125 VD32=0.5" + times, "VD8=1.0 VD28=0.0 VD32=0.25 SM1.1=0"},
      // e = -0.5: MP -0.5, MI -0.25 + 0.125, MD 0.5 * 0.125 = 0.0625: M = -0.5625, MX = 0.4375.
      {"PID VB0, 0", "VD0=0.75 VD4=0.25 VD8=0.5 VD12=1.0 VD28=0.125 VD32=0.875" + times,
       "VD8=0.0 VD28=0.4375 VD32=0.75 SM1.1=0"},
      // M within the range but MI = 0.25 + 1 = 1.25 above it: MP 0.5, MD 0.5 * -2 = -1: M = 0.75, MX = 1.
      {"PID VB0, 0", "VD0=0.25 VD4=0.75 VD12=1.0 VD28=1.0 VD32=-1.75" + times, "VD8=0.75 VD28=1.0 VD32=0.25 SM1.1=0"},
  });
}

TEST(Pid, RisingPowerFlowIsBumpless) {
  // 001:5289-5293: SP = PV, previous PV = PV, MX = M; so e = 0 and M stays.
  check({
      {"PID VB0, 2", "VD0=0.25 VD4=0.75 VD8=0.375 VD12=1.0 VD16=60.0 VD20=2.0 VD24=0.5 VD28=0.125 VD32=0.5",
       "PID.history[2]=1 VD4=0.25 VD8=0.375 VD28=0.375 VD32=0.25 SM1.1=0"},
      {"LDN SM0.0; PID VB0, 2", "PID.history[2]=1 PID.history[1]=1 VD0=0.25 VD4=0.75 VD8=0.375",
       "PID.history[2]=0 ENO[0]=0"},
      {"LDN SM0.0; PID VB0, 2", "VD0=0.25 VD4=0.75 VD8=0.375", "ENO[0]=0"},
  });
}

TEST(Pid, ArithmeticErrorsAbort) {
  check({
      {"PID VB0, 0", "VD0=0.25 VD4=0.75 VD12=1.0 VD20=2.0 PID.history[0]=1", "SM1.1=1", "SM1.1"},   // Ts = 0: 0/0
      {"PID VB0, 0", "VD0=0.25 VD4=0.75 VD12=1.0 VD16=60.0 PID.history[0]=1", "SM1.1=1", "SM1.1"},  // Ti = 0
      {"PID VB0, 0", "VD0=0.25 VD4=16#7FC00000 VD12=1.0" + times, "SM1.1=1", "SM1.1"},              // SP is no number
      {"PID VB0, 0", "VD0=0.25 VD4=3.0e38 VD12=3.0e38" + times, "SM1.1=1", "SM1.1"},
  });
}

}  // namespace rungproof::manual
