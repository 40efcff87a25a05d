// The walk over a program: jumps, guards and the concrete domain together.
#include <gtest/gtest.h>

#include "engine/concrete.hpp"
#include "ir/families/run.hpp"
#include "ir/s7200/isa.hpp"

namespace rungproof {
namespace {

struct Nothing final : Outside {
  std::uint64_t external(const ExternalSite&, int) override { return 0; }
  void report(Hazard, const Instruction*) override {}
};
struct NoHooks {
  void before(auto&, const FlowStep&) {}
  void callWithoutBody(auto&, const Instruction&) {}
  void freshLocal(auto&, unsigned, std::uint32_t) {}
};

Instruction make(std::string_view mnemonic, Operands operands = {}) {
  Instruction instruction;
  instruction.desc = s7200Instructions().named(mnemonic);
  instruction.operands = std::move(operands);
  return instruction;
}

TEST(Scan, ContactsAndCoilsMakeAnAndGate) {
  Program program;
  program.pous.push_back({});
  program.pous[0].networks.push_back({});
  program.pous[0].networks[0].instructions = {make("LD", {direct(Area::I, Width::Bit, 0, 0)}),
                                              make("A", {direct(Area::I, Width::Bit, 0, 1)}),
                                              make("=", {direct(Area::Q, Width::Bit, 0, 0)})};
  program.number();
  const Plan plan(program);
  for (int inputs = 0; inputs < 4; ++inputs) {
    Nothing outside;
    Concrete domain(outside);
    Concrete::Store store(plan);
    store.area(Area::I)[0] = static_cast<std::uint8_t>(inputs);
    Machine<Concrete> machine(domain, store, plan);
    NoHooks hooks;
    Scan<Concrete, NoHooks> scan(machine, hooks);
    scan.program();
    EXPECT_EQ(store.area(Area::Q)[0] & 1, inputs == 3 ? 1 : 0) << inputs;
  }
}

}  // namespace
}  // namespace rungproof
