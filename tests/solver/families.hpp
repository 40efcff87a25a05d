// Hand-made transition systems with known answers, in sizes: start/stop latches, phase rings, timer chains, timers
// against an independent count of scans, timers behind a latch. A timer counts one tick a scan and stops at 32767
// as on the CPU, or at its preset where the name says "saturated".
#pragma once

#include <memory>
#include <string>

#include "analysis/graph/transition_system.hpp"

namespace rungproof::families {

/// A transition system that owns its graph.
struct Family {
  std::unique_ptr<Graph> graph = std::make_unique<Graph>();
  TransitionSystem system;

  Family() { system.graph = graph.get(); }
  Node number(std::uint64_t value, int width) { return graph->constantNode(value, width); }
  Node input(const std::string& name, int width = 1) {
    system.inputs.push_back(graph->variable(name, width, false));
    return system.inputs.back();
  }
  Node state(const std::string& name, int width = 1, std::uint64_t init = 0) {
    const Node n = graph->variable(name, width, true);
    system.states.push_back({n, number(init, width), n});
    return n;
  }
  void next(Node variable, Node value) {
    for (StateVariable& s : system.states) {
      if (s.node == variable) s.next = value;
    }
  }
  void ask(const std::string& name, Node bad) { system.questions.push_back({name, bad}); }
  Node no(Node a) { return graph->make(Op::Not, 1, a); }
  Node both(Node a, Node b) { return graph->make(Op::And, 1, a, b); }
  Node either(Node a, Node b) { return graph->make(Op::Or, 1, a, b); }
  Node differ(Node a, Node b) { return graph->make(Op::Xor, 1, a, b); }
  Node choose(Node c, Node a, Node b) { return graph->make(Op::Ite, (*graph)[a].width, c, a, b); }
  Node atLeast(Node a, std::uint64_t n) { return graph->make(Op::Ule, 1, number(n, (*graph)[a].width), a); }
  /// min(a + 1, cap) while `running`, else 0.
  Node counted(Node a, Node running, std::uint64_t cap) {
    const int w = (*graph)[a].width;
    const Node sum = graph->make(Op::Add, w, a, number(1, w));
    return choose(running, choose(atLeast(a, cap), number(cap, w), sum), number(0, w));
  }

  struct Timer {
    Node value, bit;        ///< before the scan
    Node valueNow, bitNow;  ///< after it
  };
  Timer timer(const std::string& name, Node running, std::uint64_t preset, std::uint64_t cap) {
    Timer t{};
    t.value = state(name + ".value", 16);
    t.bit = state(name);
    t.valueNow = counted(t.value, running, cap);
    t.bitNow = atLeast(t.valueNow, preset);
    next(t.value, t.valueNow);
    next(t.bit, t.bitNow);
    return t;
  }
};

/// n motors with start, stop and mutual interlock: no two neighbours run. One question for each pair of neighbours.
inline Family starter(int n) {
  Family f;
  std::vector<Node> motors, after;
  for (int i = 0; i < n; ++i) motors.push_back(f.state("Q" + std::to_string(i)));
  for (int i = 0; i < n; ++i) {
    const Node start = f.input("start" + std::to_string(i)), stop = f.input("stop" + std::to_string(i));
    Node on = f.both(f.either(start, motors[i]), f.no(stop));
    if (i > 0) on = f.both(on, f.no(after[i - 1]));
    if (i + 1 < n) on = f.both(on, f.no(motors[i + 1]));
    after.push_back(on);
    f.next(motors[i], on);
    f.timer("T" + std::to_string(i), on, 100 + i, 32767);
  }
  for (int i = 0; i + 1 < n; ++i) f.ask("interlock " + std::to_string(i), f.both(motors[i], motors[i + 1]));
  return f;
}

/// n phases in a ring, each left when its timer has run out: never two at once. One question.
inline Family phase(int n) {
  Family f;
  std::vector<Node> phases;
  for (int i = 0; i < n; ++i) phases.push_back(f.state("S" + std::to_string(i), 1, i == 0 ? 1 : 0));
  const Node enable = f.input("enable");
  std::vector<Node> leave;
  for (int i = 0; i < n; ++i) {
    const Family::Timer t = f.timer("T" + std::to_string(i), f.both(enable, phases[i]), 100 + i, 32767);
    leave.push_back(f.both(phases[i], t.bitNow));
  }
  Node two = f.number(0, 1), some = f.number(0, 1);
  for (int i = 0; i < n; ++i) {
    f.next(phases[i], f.either(f.both(phases[i], f.no(leave[i])), leave[(i + n - 1) % n]));
    two = f.either(two, f.both(some, phases[i]));
    some = f.either(some, phases[i]);
  }
  f.ask("one phase", two);
  return f;
}

/// n timers, each started by the bit of the one before: a later bit needs the earlier one. One question for each.
inline Family chain(int n, bool saturated = false) {
  Family f;
  Node running = f.input("start");
  std::vector<Node> bits;
  for (int i = 0; i < n; ++i) {
    const std::uint64_t preset = 100 + i;
    const Family::Timer t = f.timer("T" + std::to_string(i), running, preset, saturated ? preset : 32767);
    bits.push_back(t.bit);
    running = t.bitNow;
  }
  for (int i = 0; i + 1 < n; ++i) f.ask("order " + std::to_string(i), f.both(bits[i + 1], f.no(bits[i])));
  return f;
}

/// n timers with presets preset + i, each against a count of the scans its input has been on: the bit is on exactly
/// from the preset on. One question for each timer.
inline Family timed(int n, std::uint64_t preset, bool saturated) {
  Family f;
  for (int i = 0; i < n; ++i) {
    const std::string number = std::to_string(i);
    const Node in = f.input("in" + number);
    const std::uint64_t limit = preset + i;
    const Family::Timer t = f.timer("T" + number, in, limit, saturated ? limit : 32767);
    const Node scans = f.state("scans" + number, 16);
    f.next(scans, f.counted(scans, in, limit));
    f.ask("exact " + number, f.differ(t.bit, f.atLeast(scans, limit)));
  }
  return f;
}

/// One timer behind a start/stop latch: can its bit come on? Yes, in scan `preset`.
inline Family reach(std::uint64_t preset) {
  Family f;
  const Node start = f.input("start"), stop = f.input("stop");
  const Node latch = f.state("M0.0");
  const Node on = f.both(f.either(start, latch), f.no(stop));
  f.next(latch, on);
  const Family::Timer t = f.timer("T37", on, preset, 32767);
  f.ask("T37 comes on", t.bitNow);
  return f;
}

}  // namespace rungproof::families
