// The timer families on which model checkers have been compared, as STL programs of any size: start/stop latches with
// interlocks, phase rings, timer chains, timers against an independent count of scans. With scans of 100 ms a timer of
// 100 ms gets one tick a scan.
#pragma once

#include <string>

namespace rungproof::families {

/// Address of the i-th bit: "M3.5".
inline std::string bitOf(const std::string& area, int i) {
  return area + std::to_string(i / 8) + "." + std::to_string(i % 8);
}
/// The i-th timer of 100 ms: T37 .. T63, T101 .. T255.
inline std::string timerOf(int i) { return "T" + std::to_string(i < 27 ? 37 + i : 101 + i - 27); }

inline std::string programOf(const std::string& properties, const std::string& networks) {
  return "ORGANIZATION_BLOCK MAIN:OB1\n" + properties + "BEGIN\n" + networks + "END_ORGANIZATION_BLOCK\n";
}

/// n motors M with start I and stop V1000.., each with a timer; no two neighbours run. V bits come from outside.
inline std::string starter(int n) {
  std::string properties = "//@ external VB1000..VB1031\n", networks;
  for (int i = 0; i < n; ++i) {
    networks += "Network " + std::to_string(i + 1) + "\nLD " + bitOf("I", i) + "\nO " + bitOf("M", i) + "\nAN " +
                bitOf("V", 8000 + i) + "\n";
    if (i > 0) networks += "AN " + bitOf("M", i - 1) + "\n";
    if (i + 1 < n) networks += "AN " + bitOf("M", i + 1) + "\n";
    networks += "= " + bitOf("M", i) + "\nTON " + timerOf(i) + ", " + std::to_string(100 + i) + "\n";
    if (i + 1 < n)
      properties +=
          "//@ prove interlock " + std::to_string(i) + ": never " + bitOf("M", i) + " and " + bitOf("M", i + 1) + "\n";
  }
  return programOf(properties, networks);
}

/// n phases M in a ring, each left when its timer has run out; never two at once: one property for each pair of
/// neighbours.
inline std::string phase(int n) {
  std::string properties, networks = "Network 1\nLD SM0.1\nS M0.0, 1\n";
  for (int i = 0; i < n; ++i) {
    networks += "Network " + std::to_string(i + 2) + "\nLD I0.0\nA " + bitOf("M", i) + "\nTON " + timerOf(i) + ", " +
                std::to_string(100 + i) + "\n";
  }
  // From the last to the first, so that a phase lasts a scan at least; the first is entered last.
  for (int k = 0; k < n; ++k) {
    const int i = (2 * n - 2 - k) % n;
    networks += "Network " + std::to_string(n + 2 + k) + "\nLD " + timerOf(i) + "\nA " + bitOf("M", i) + "\nR " +
                bitOf("M", i) + ", 1\nS " + bitOf("M", (i + 1) % n) + ", 1\n";
    properties +=
        "//@ prove apart " + std::to_string(i) + ": never " + bitOf("M", i) + " and " + bitOf("M", (i + 1) % n) + "\n";
  }
  return programOf(properties, networks);
}

/// n timers, each started by the bit of the one before: a later bit needs the earlier one.
inline std::string chain(int n) {
  std::string properties, networks;
  for (int i = 0; i < n; ++i) {
    networks += "Network " + std::to_string(i + 1) + "\nLD " + (i == 0 ? "I0.0" : timerOf(i - 1)) + "\nTON " +
                timerOf(i) + ", " + std::to_string(100 + i) + "\n";
    if (i > 0)
      properties += "//@ prove order " + std::to_string(i) + ": " + timerOf(i) + " implies " + timerOf(i - 1) + "\n";
  }
  return programOf(properties, networks);
}

/// n timers with presets from `preset` on, each against a count of the scans that its input has been on since: for
/// scans of 100 ms. The scan that enables a timer brings it no tick (001:6590) and is not counted either: M remembers
/// the input of the scan before.
inline std::string timed(int n, int preset) {
  std::string properties, networks;
  for (int i = 0; i < n; ++i) {
    const std::string in = bitOf("I", i), before = bitOf("M", i), count = "VW" + std::to_string(2 * i), limit = std::to_string(preset + i);
    networks += "Network " + std::to_string(i + 1) + "\nLD " + in + "\nTON " + timerOf(i) + ", " + limit + "\nLD " +
                in + "\nA " + before + "\nAW< " + count + ", 32767\nINCW " + count + "\nLDN " + in + "\nMOVW 0, " +
                count + "\nLD " + in + "\n= " + before + "\n";
    properties += "//@ prove exact " + std::to_string(i) + ": " + timerOf(i) + " = (" + count + " >= " + limit + ")\n";
  }
  return programOf(properties, networks);
}

}  // namespace rungproof::families
