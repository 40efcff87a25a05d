// Classes of obligations as programs that grow: step chains and rings, waits that are one tick short, timed steps in a
// row, counters, queues, tables, pointers, shift registers, calls, flicker relays, and words that are tied by a linear
// relation. Each family names the sizes at which it is measured and the verdict that all its properties have.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tests/timing/stl_families.hpp"

namespace rungproof::families {

struct ObligationFamily {
  std::string_view name;
  std::string_view verdict;  ///< of every property
  std::vector<int> sizes;    ///< from small to large
  std::size_t decided;       ///< how many of these sizes are decided today, the smallest first
  std::string (*program)(int n);
};

inline std::string wordOf(int i) { return "VW" + std::to_string(2 * i); }

inline std::string network(int number, const std::string& statements) {
  return "Network " + std::to_string(number) + "\n" + statements;
}

/// "//@ prove name: ..." and the like.
inline std::string property(const std::string& text) { return "//@ " + text + "\n"; }

/// n steps M set and reset one after the other, each left by an input of its own; back to the first from the last if it
/// is a ring. From the last to the first, so that a step lasts a scan at least.
inline std::string steps(int n, bool isRing) {
  std::string networks = network(1, "LD SM0.1\nS M0.0, 1\n");
  for (int k = 0; k + (isRing ? 0 : 1) < n; ++k) {
    const int i = isRing ? (2 * n - 2 - k) % n : n - 2 - k;
    networks += network(k + 2, "LD " + bitOf("M", i) + "\nA " + bitOf("I", i % 64) + "\nR " + bitOf("M", i) +
                                   ", 1\nS " + bitOf("M", (i + 1) % n) + ", 1\n");
  }
  networks += network(
      n + 2, "LD " + bitOf("M", 1) + "\nO " + bitOf("M", n / 2) + "\n= Q0.0\nLD " + bitOf("M", n - 1) + "\n= Q0.1\n");
  return programOf(property("prove ends: never M0.0 and " + bitOf("M", n - 1)) +
                       property("prove middle: never " + bitOf("M", n / 2) + " and " + bitOf("M", n / 2 + 1)) +
                       property("prove outputs: never Q0.0 and Q0.1"),
                   networks);
}
inline std::string stepChain(int n) { return steps(n, false); }
inline std::string stepRing(int n) { return steps(n, true); }

/// n steps as control relays, S0.0 to S31.7.
inline std::string relayChain(int n) {
  std::string networks = network(1, "LD SM0.1\nS S0.0, 1\n");
  for (int i = 0; i < n; ++i) {
    std::string part = "LSCR " + bitOf("S", i) + "\nLD SM0.0\n= " + bitOf("M", i) + "\n";
    if (i + 1 < n) part += "LD " + bitOf("I", i % 64) + "\nSCRT " + bitOf("S", i + 1) + "\n";
    networks += network(i + 2, part + "SCRE\n");
  }
  return programOf(property("prove ends: never S0.0 and " + bitOf("S", n - 1)) +
                       property("prove middle: never " + bitOf("S", n / 2) + " and " + bitOf("S", n / 2 + 1)),
                   networks);
}

/// `count` timers of `preset` ticks of 100 ms, each behind an input: the property of each asks whether the timer has
/// run out when its input has been on for `excess` ms more than the preset.
inline std::string waits(int count, int preset, int excess) {
  std::string properties, networks;
  for (int i = 0; i < count; ++i) {
    const std::string in = bitOf("I", i), out = bitOf("Q", i),
                      milliseconds = std::to_string((preset + i) * 100 + excess);
    networks += network(i + 1, "LD " + in + "\nTON " + timerOf(i) + ", " + std::to_string(preset + i) + "\nLD " +
                                   timerOf(i) + "\n= " + out + "\n");
    properties +=
        property("prove wait " + std::to_string(i) + ": held(" + in + ", " + milliseconds + "ms) implies " + out);
  }
  return programOf(properties, networks);
}
/// The scan that sees the input first counts the ticks of the scan before, the last one those of the last but one
/// (001:6590). So the timer of a run of scans e0 .. ek still runs if fewer ticks than the preset fall between the
/// beginning of scan 0 and the end of scan k - 1, less than preset * 100 ms; the input has then been on since the end
/// of scan 0, which lasts 1 ms at least, until that of scan k, which lasts 500 ms at most: preset * 100 + 498 ms at
/// most.
constexpr int oneTickShort = 400, enough = 500;
inline std::string shortWait(int preset) { return waits(1, preset, oneTickShort); }
inline std::string fourShortWaits(int preset) { return waits(4, preset, oneTickShort); }
inline std::string longWait(int preset) { return waits(1, preset, enough); }
/// The other direction: the timer's bit says that its input has been on. Its ticks may have begun before: 1 ms more
/// than (preset - 1) * 100 ms lie between the beginning of scan 0 and the end of scan k - 1, up to 500 ms of them
/// before the end of scan 0, and scan k lasts 1 ms at least: preset * 100 - 598 ms.
inline std::string ended(int preset, int lack) {
  return programOf(property("prove ended: Q0.0 implies held(I0.0, " + std::to_string(preset * 100 - lack) + "ms)"),
                   network(1, "LD I0.0\nTON T37, " + std::to_string(preset) + "\nLD T37\n= Q0.0\n"));
}
inline std::string earlyEnd(int preset) { return ended(preset, 500); }
inline std::string lateEnd(int preset) { return ended(preset, 600); }

/// The same with a timer of 10 ms, whose bit may come almost half a second before its input has been on for the preset,
/// since the ticks of a long first scan count: two ticks less are asked for.
inline std::string fineEnd(int preset) {
  return programOf(property("prove ended: Q0.0 implies held(I0.0, " + std::to_string(preset * 10 - 20) + "ms)"),
                   network(1, "LD I0.0\nTON T33, " + std::to_string(preset) + "\nLD T33\n= Q0.0\n"));
}
/// A premise that needs as many edges of one input as the counter counts.
inline std::string counterReached(int preset) {
  return programOf(property("prove counted: Q0.0 implies C5.value >= " + std::to_string(preset)),
                   network(1, "LD I0.0\nLD I0.1\nCTU C5, " + std::to_string(preset) + "\nLD C5\n= Q0.0\n"));
}

/// A debouncing counter: full after n scans with the input on. A scan lasts 1 to 500 ms, and from the end of the first
/// of n scans to that of the last one n - 1 of them pass.
inline std::string scanCount(int n) {
  const std::string end = std::to_string(n);
  return programOf(property("prove sees: I0.0 held " + std::to_string(n / 2 + 1) + "s implies Q0.0") +
                       property("prove not early: rises(Q0.0) implies held(I0.0, " + std::to_string(n - 1) + "ms)"),
                   network(1, "LD I0.0\nAW< VW0, " + end + "\nINCW VW0\n") + network(2, "LDN I0.0\nMOVW 0, VW0\n") +
                       network(3, "LDW>= VW0, " + end + "\n= Q0.0\n"));
}

/// A set value that rises by 10 a scan up to n and falls by 20: n / 20 scans of 500 ms, and one more that is not whole.
inline std::string ramp(int n) {
  const std::string top = std::to_string(n);
  return programOf(property("prove stops: not I0.0 held " + std::to_string(n / 40 + 1) + "s implies VW0 = 0"),
                   network(1, "LD I0.0\nAW< VW0, " + top + "\n+I 10, VW0\n") +
                       network(2, "LDN I0.0\nAW> VW0, 0\n-I 20, VW0\n") +
                       network(3, "LDW> VW0, " + top + "\nMOVW " + top + ", VW0\nLDW< VW0, 0\nMOVW 0, VW0\n"));
}

/// n steps in a row, each of a minute: started by an edge, each left when its timer has run out.
inline std::string timedRow(int n, const std::string& properties) {
  std::string networks = network(1, "LD I0.0\nEU\nLD M0.0\n");
  for (int i = 1; i <= n; ++i) networks += "O " + bitOf("M", i) + "\n";
  networks += "NOT\nALD\nS M0.0, 1\n";
  for (int k = 0; k < n; ++k) {
    const int i = n - 1 - k;
    networks += network(k + 2, "LD " + bitOf("M", i) + "\nTON " + timerOf(i) + ", 600\nLD " + bitOf("M", i) + "\nA " +
                                   timerOf(i) + "\nR " + bitOf("M", i) + ", 1\nS " + bitOf("M", i + 1) + ", 1\n");
  }
  networks += network(n + 2, "LD " + bitOf("M", n) + "\n= Q0.0\nR " + bitOf("M", n) + ", 1\n");
  return programOf(properties, networks);
}
/// Each step lasts between 59 s and 61.6 s: ticks of its first scan do not count, those of its last scan come late.
inline std::string timedRowLeads(int n) {
  return timedRow(n, property("prove comes: M0.0 leads to Q0.0 within " + std::to_string(n * 61600 + 2000) + "ms"));
}
inline std::string timedRowOnlyAfter(int n) {
  return timedRow(n, property("prove waits: Q0.0 only after held(" + bitOf("M", n - 1) + ", 58s)") +
                         property("prove started: Q0.0 only after I0.0"));
}
/// Timers in series, 40 minutes each, one after the other behind one input: the last has run out only after their sum.
inline std::string seriesOnlyAfter(int n) {
  std::string networks;
  for (int i = 0; i < n; ++i)
    networks +=
        network(i + 1, "LD " + (i == 0 ? std::string("I0.0") : timerOf(i - 1)) + "\nTON " + timerOf(i) + ", 24000\n");
  networks += network(n + 1, "LD " + timerOf(n - 1) + "\n= Q0.0\n");
  return programOf(property("prove hours: Q0.0 only after held(I0.0, " + std::to_string(n * 2400 - 5 * n) + "s)"),
                   networks);
}

/// A counter up to n and its lamp.
inline std::string counterLamp(int n) {
  const std::string limit = std::to_string(n);
  return programOf(property("prove lamp full: Q0.0 = (C0.value >= " + limit + ")") +
                       property("prove not below: C0.value < " + limit + " implies not Q0.0"),
                   network(1, "LD I0.0\nLD I0.1\nCTU C0, " + limit + "\n") + network(2, "LD C0\n= Q0.0\n"));
}

/// Room for n pieces between two counts.
inline std::string queue(int n) {
  const std::string room = std::to_string(n);
  return programOf(property("prove room: VW0 - VW2 <= " + room) + property("prove order: VW2 <= VW0"),
                   network(1, "LD I0.0\nEU\nAW< VW4, " + room + "\nAW< VW0, 32000\nINCW VW0\nINCW VW4\n") +
                       network(2, "LD I0.1\nEU\nAW> VW4, 0\nINCW VW2\nDECW VW4\n"));
}

/// A table of n entries, filled and emptied.
inline std::string table(int n) {
  const std::string room = std::to_string(n);
  return programOf("//@ external VW0\n" + property("prove entries: VW102 >= 0 and VW102 <= " + room) +
                       property("prove size: not first_scan implies VW100 = " + room),
                   network(1, "LD SM0.1\nMOVW " + room + ", VW100\nMOVW 0, VW102\n") +
                       network(2, "LD I0.0\nEU\nATT VW0, VW100\n") + network(3, "LD I0.1\nEU\nFIFO VW100, VW400\n"));
}

/// A ring of n words that a pointer walks round.
inline std::string pointerRing(int n) {
  return programOf(property("prove place: VW400 >= 0 and VW400 < " + std::to_string(n)),
                   network(1, "LD SM0.1\nMOVD &VB0, VD404\nMOVW 0, VW400\n") +
                       network(2, "LD I0.0\nEU\nMOVW AIW0, *VD404\n+D 2, VD404\nINCW VW400\nAW>= VW400, " +
                                      std::to_string(n) + "\nMOVD &VB0, VD404\nMOVW 0, VW400\n"));
}

/// A shift register of n places.
inline std::string shiftRegister(int n) {
  return programOf(property("prove seen before: " + bitOf("V", n - 1) + " only after I0.1") +
                       property("prove lamp: Q0.0 = " + bitOf("V", n - 1)),
                   network(1, "LD I0.0\nEU\nSHRB I0.1, V0.0, " + std::to_string(n) + "\n") +
                       network(2, "LD " + bitOf("V", n - 1) + "\n= Q0.0\n"));
}

/// A subroutine with two interlocked coils, called n times.
inline std::string calls(int n) {
  std::string networks;
  for (int i = 0; i < n; ++i)
    networks +=
        network(i + 1, "LD SM0.0\nCALL SBR0, " + bitOf("I", 2 * i % 128) + ", " + bitOf("I", (2 * i + 1) % 128) + ", " +
                           bitOf("V", 2 * i) + ", " + bitOf("V", 2 * i + 1) + "\n");
  std::string program =
      programOf(property("prove first: never V0.0 and V0.1") +
                    property("prove last: never " + bitOf("V", 2 * n - 2) + " and " + bitOf("V", 2 * n - 1)),
                networks);
  return program +
         "SUBROUTINE_BLOCK DRIVE:SBR0\nVAR_INPUT\nA:BOOL;\nB:BOOL;\nEND_VAR\nVAR_OUTPUT\nC:BOOL;\nD:BOOL;\nEND_VAR\n"
         "BEGIN\nNetwork 1\nLD L0.0\nAN L0.1\n= L0.2\nNetwork 2\nLD L0.1\nAN L0.0\n= L0.3\nEND_SUBROUTINE_BLOCK\n";
}

/// Two timers that start each other.
inline std::string flicker(int preset) {
  const std::string ticks = std::to_string(preset);
  return programOf(
      property("prove lit while on: Q0.0 implies I0.0") +
          property("prove not at once: Q0.0 implies held(I0.0, " + std::to_string(preset * 100 - 1200) + "ms)"),
      network(1, "LD I0.0\nAN T38\nTON T37, " + ticks + "\n") + network(2, "LD T37\nTON T38, " + ticks + "\n") +
          network(3, "LD T37\nA I0.0\n= Q0.0\n"));
}

/// Books with n accounts: each booking takes from one what it gives to the next, never more than is there.
inline std::string books(int n) {
  std::string networks = network(1, "LD SM0.1\nMOVW 1000, VW0\n"), sum = "VW0";
  for (int i = 0; i < n; ++i) {
    const std::string from = wordOf(i), to = wordOf((i + 1) % n);
    networks += network(i + 2, "LD " + bitOf("I", i) + "\nAW>= VW200, 0\nAW>= " + from + ", VW200\n-I VW200, " + from +
                                   "\n+I VW200, " + to + "\n");
    if (i > 0) sum += " + " + from;
  }
  return programOf("//@ external VW200\n" + property("prove books: first_scan or " + sum + " = 1000"), networks);
}
/// n bins in a ring, each of which gives a piece to the next while it has one and the next has room.
inline std::string bins(int n) {
  std::string networks = network(1, "LD SM0.1\nMOVW 50, VW0\n"), sum = "VW0";
  for (int i = 0; i < n; ++i) {
    const std::string from = wordOf(i), to = wordOf((i + 1) % n);
    networks += network(i + 2, "LD " + bitOf("I", i) + "\nEU\nAW> " + from + ", 0\nAW< " + to + ", 60\nDECW " + from +
                                   "\nINCW " + to + "\n");
    if (i > 0) sum += " + " + from;
  }
  return programOf(property("prove pieces: first_scan or " + sum + " = 50"), networks);
}
/// n pairs of debit and credit in one unit: both totals are equal.
inline std::string ledgers(int n) {
  std::string networks, debit = "VW0", credit = "VW100";
  for (int i = 0; i < n; ++i) {
    const std::string left = wordOf(i), right = wordOf(50 + (i + 1) % n);
    networks +=
        network(i + 1, "LD " + bitOf("I", i) + "\nEU\nAW< " + left + ", 1000\nINCW " + left + "\nINCW " + right + "\n");
    if (i > 0) debit += " + " + left, credit += " + " + wordOf(50 + i);
  }
  return programOf(property("prove totals: " + debit + " = " + credit), networks);
}
/// A sum over the last n samples, kept by adding the new one and taking away the oldest.
inline std::string runningSum(int n) {
  std::string shift = "LD SM0.0\nITD " + wordOf(n - 1) + ", AC0\n-D AC0, VD200\n", sum = "VW0";
  for (int i = n - 1; i > 0; --i) {
    shift += "MOVW " + wordOf(i - 1) + ", " + wordOf(i) + "\n";
    sum += " + " + wordOf(n - i);
  }
  shift += "MOVW AIW0, VW0\nITD VW0, AC0\n+D AC0, VD200\n";
  return programOf(property("prove sum: VD200 = " + sum), network(1, shift));
}
/// The mean of two inputs lies between them; n: their range.
inline std::string meanOfTwo(int n) {
  const std::string most = std::to_string(n);
  return programOf(property("prove between: (VW4 >= VW0 or VW4 >= VW2) and (VW4 <= VW0 or VW4 <= VW2)"),
                   network(1, "LDW>= AIW0, 0\nAW<= AIW0, " + most + "\nAW>= AIW2, 0\nAW<= AIW2, " + most +
                                  "\nMOVW AIW0, VW0\nMOVW AIW2, VW2\nITD VW0, AC0\nITD VW2, AC1\n+D AC1, AC0\n/D 2, "
                                  "AC0\nDTI AC0, VW4\n"));
}

inline std::vector<ObligationFamily> obligationFamilies() {
  return {{"step chain", "PROVED", {50, 100, 200}, 3, stepChain},
          {"step ring", "PROVED", {50, 100, 200}, 3, stepRing},
          {"relay chain", "PROVED", {50, 100, 200}, 3, relayChain},
          {"short wait", "VIOLATED", {50, 3000, 30000}, 3, shortWait},
          {"four short waits", "VIOLATED", {50, 3000, 30000}, 3, fourShortWaits},
          {"long wait", "PROVED", {50, 3000, 30000}, 3, longWait},
          {"early end", "VIOLATED", {50, 3000, 30000}, 3, earlyEnd},
          {"fine end", "VIOLATED", {50, 3000, 30000}, 3, fineEnd},
          {"late end", "PROVED", {50, 3000, 30000}, 3, lateEnd},
          {"timed row leads", "PROVED", {1, 2, 4}, 2, timedRowLeads},
          {"timed row only after", "PROVED", {1, 2, 4}, 3, timedRowOnlyAfter},
          {"series only after", "PROVED", {1, 2, 3}, 3, seriesOnlyAfter},
          {"counter lamp", "PROVED", {10, 1000, 32767}, 3, counterLamp},
          {"counter reached", "PROVED", {10, 1000, 32767}, 3, counterReached},
          {"scan count", "PROVED", {10, 50, 200}, 3, scanCount},
          {"ramp", "PROVED", {100, 400, 1000}, 3, ramp},
          {"queue", "PROVED", {6, 100, 1000}, 3, queue},
          {"table", "PROVED", {10, 50, 100}, 3, table},
          {"pointer ring", "PROVED", {10, 50, 100}, 3, pointerRing},
          {"shift register", "PROVED", {8, 32, 64}, 3, shiftRegister},
          {"calls", "PROVED", {10, 50, 100}, 3, calls},
          {"flicker", "PROVED", {50, 3000, 30000}, 3, flicker},
          {"books", "PROVED", {2, 4, 8}, 2, books},
          {"bins", "PROVED", {3, 4, 8}, 3, bins},
          {"ledgers", "PROVED", {2, 4, 8}, 2, ledgers},
          {"running sum", "PROVED", {2, 4, 8}, 3, runningSum},
          {"mean of two", "PROVED", {100, 4000, 32000}, 3, meanOfTwo}};
}

}  // namespace rungproof::families
