// Semaphore, hysteresis and the blocks for regulation as plain C++, each written down from the annex of the standard;
// REAL is float, and times are ms. TIME_TO_REAL gives ms, as the default reading does.
#pragma once

#include <cstdint>

namespace rungproof::iec_naive {

struct Semaphore {
  bool isTaken = false;
  void call(bool claim, bool release) { isTaken = claim || (isTaken && !release); }
};

struct Hysteresis {
  bool q = false;
  void call(float value, float limit, float width) {
    if (q && value < limit - width)
      q = false;
    else if (!q && value > limit + width)
      q = true;
  }
};

struct Integral {
  float out = 0;
  bool q = false;
  void call(bool run, bool reset, float in, float start, std::int64_t cycle) {
    q = !reset;
    if (reset)
      out = start;
    else if (run)
      out = out + in * static_cast<float>(cycle);
  }
};

struct Derivative {
  float out = 0, x1 = 0, x2 = 0, x3 = 0;
  void call(bool run, float in, std::int64_t cycle) {
    if (!run) {
      out = 0;
      x1 = x2 = x3 = in;
      return;
    }
    out = (3.0F * (in - x3) + x1 - x2) / (10.0F * static_cast<float>(cycle));
    x3 = x2;
    x2 = x1;
    x1 = in;
  }
};

struct Pid {
  Integral integral;
  Derivative derivative;
  float out = 0;
  struct Inputs {
    bool isAutomatic;
    float value, wanted, start, gain, resetTime, derivativeTime;
    std::int64_t cycle;
  };
  void call(const Inputs& in) {
    const float error = in.value - in.wanted;
    integral.call(in.isAutomatic, !in.isAutomatic, error, in.resetTime * (in.start - error), in.cycle);
    derivative.call(in.isAutomatic, error, in.cycle);
    out = in.gain * (error + integral.out / in.resetTime + derivative.out * in.derivativeTime);
  }
};

struct Ramp {
  float out = 0, from = 0;
  std::int64_t passed = 0;
  bool isBusy = false;
  void call(bool run, float start, float end, std::int64_t duration, std::int64_t cycle) {
    isBusy = run;
    if (!run) {
      out = from = start;
      passed = 0;
    } else if (passed >= duration) {
      isBusy = false;
      out = end;
    } else {
      out = from + (end - from) * static_cast<float>(passed) / static_cast<float>(duration);
      passed += cycle;
    }
  }
};

}  // namespace rungproof::iec_naive
