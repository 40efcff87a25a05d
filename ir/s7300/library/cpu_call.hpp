// What a call of a block of the CPU does beside its outputs: to interrupts, errors and the watchdog (002:1192-1212,
// 002:2342-2353). A block that does something has `template <class D> static void act(CpuCall<D>&)` in its struct,
// which runs in front of the block. Each domain compiles this in one source file (ir/machine/dispatch.hpp). Tested by
// tests/step7/interrupt_lock_test.cpp and tests/step7/organization_block_test.cpp.
#pragma once

#include "ir/machine/machine.hpp"
#include "ir/s7300/place.hpp"

namespace rungproof {

/// The call of such a block by its statement.
template <class D>
class CpuCall {
 public:
  using Bool = typename D::Bool;
  using Bits = typename D::Bits;

  CpuCall(Machine<D>& machine, const Instruction& call)
      : m(machine), d(machine.d), s(machine.step7), call_(call), db_(machine.step7.db) {}

  Machine<D>& m;
  D& d;
  Step7Registers<D>& s;

  /// Whether the statement names as many parameters; an incomplete call does nothing.
  bool gives(std::size_t parameters) const { return call_.operands.size() > parameters; }
  /// What the statement gives to a parameter, in the order of the interface from 0. The DB register stays.
  Bits value(std::size_t parameter, Width width) {
    Step7Places<D> places(m);
    const Bits loaded = places.load(places.find(call_.operands[parameter + 1], width), width);
    s.db = db_;
    return loaded;
  }
  /// The same of 16 bits.
  Bits word(std::size_t parameter) { return d.extract(value(parameter, Width::Word), 15, 0); }

 private:
  const Instruction& call_;
  Bits db_;
};

}  // namespace rungproof
