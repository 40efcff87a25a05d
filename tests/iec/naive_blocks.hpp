// The blocks of the standard as plain C++, each written down from its description with an absolute clock; nothing of
// reader, lowering or engine is shared. Times are ms.
#pragma once

#include <cstdint>

namespace rungproof::iec_naive {

struct OnDelay {
  int state = 0;  ///< 0 idle, 1 running, 2 done
  bool before = false, q = false;
  std::int64_t start = 0, et = 0;
  void call(bool in, std::int64_t pt, std::int64_t now) {
    if (state == 0 && in && !before) {
      state = 1;
      start = now;
      q = false;
      et = 0;
    } else if (!in) {
      state = 0;
      q = false;
      et = 0;
    } else if (state == 1) {
      const bool isOver = start + pt <= now;
      if (isOver) {
        state = 2;
        q = true;
      }
      et = isOver ? pt : now - start;
    }
    before = in;
  }
};

struct Pulse {
  int state = 0;
  bool before = false, q = false;
  std::int64_t start = 0, et = 0;
  void call(bool in, std::int64_t pt, std::int64_t now) {
    if (state == 0 && in && !before) {
      state = 1;
      start = now;
      q = true;
    } else if (state == 1) {
      const bool isOver = start + pt <= now;
      if (isOver) {
        state = 2;
        q = false;
      }
      et = isOver ? pt : now - start;
    }
    if (state == 2 && !in) {
      state = 0;
      et = 0;
    }
    before = in;
  }
};

struct OffDelay {
  int state = 0;
  bool before = false, q = false;
  std::int64_t start = 0, et = 0;
  void call(bool in, std::int64_t pt, std::int64_t now) {
    if (state == 0 && !in && before) {
      state = 1;
      start = now;
    } else if (in) {
      state = 0;
      et = 0;
    } else if (state == 1) {
      const bool isOver = start + pt <= now;
      if (isOver) state = 2;
      et = isOver ? pt : now - start;
    }
    q = in || state == 1;
    before = in;
  }
};

/// Counting stops at the preset, and downwards at 0.
struct Counter {
  bool up = false, down = false, qu = false, qd = false;
  std::int64_t cv = 0;
  void countUp(bool cu, bool r, std::int64_t pv) {
    const bool rises = cu && !up;
    up = cu;
    if (r)
      cv = 0;
    else if (rises && cv < pv)
      ++cv;
    qu = cv >= pv;
  }
  void countDown(bool cd, bool ld, std::int64_t pv) {
    const bool rises = cd && !down;
    down = cd;
    if (ld)
      cv = pv;
    else if (rises && cv > 0)
      --cv;
    qd = cv <= 0;
  }
  void countBoth(bool cu, bool cd, bool r, bool ld, std::int64_t pv) {
    const bool rises = cu && !up, falls = cd && !down;
    up = cu;
    down = cd;
    if (r)
      cv = 0;
    else if (ld)
      cv = pv;
    else if (rises && !falls && cv < pv)
      ++cv;
    else if (falls && !rises && cv > 0)
      --cv;
    qu = cv >= pv;
    qd = cv <= 0;
  }
};

struct Edge {
  bool before = false, q = false;
  void rising(bool clk) {
    q = clk && !before;
    before = clk;
  }
  /// Of a block that has not been called its memory is FALSE: FALSE in the first call is an edge.
  void falling(bool clk) {
    q = !clk && !before;
    before = !clk;
  }
};

}  // namespace rungproof::iec_naive
