// The forms of meanings that are compiled for one area do the same as the general ones: random programs of contacts,
// stack instructions and coils, run both ways from the same state.
#include <gtest/gtest.h>

#include <random>

#include "engine/dispatch_concrete.hpp"
#include "engine/start_up.hpp"
#include "ir/families/run.hpp"
#include "ir/s7200/isa.hpp"

namespace rungproof {
namespace {

struct Nothing final : Outside {
  std::uint64_t external(const ExternalSite&, int) override { return 0; }
  void report(Hazard, const Instruction*) override {}
};
struct GeneralForms {
  void before(auto&, const FlowStep&) {}
  void callWithoutBody(auto&, const Instruction&) {}
  void freshLocal(auto&, unsigned, std::uint32_t) {}
};
struct ChosenForms : GeneralForms {
  Execute<Concrete> entry(const FlowStep& step) { return executionOf(*step.instruction, StatementForm::Rungs); }
};

template <class Hooks>
Concrete::Store runOnce(const Plan& plan, Concrete::Store store) {
  Nothing outside;
  Concrete domain(outside);
  Machine<Concrete> machine(domain, store, plan);
  Hooks hooks;
  Scan<Concrete, Hooks> scan(machine, hooks);
  scan.program();
  return store;
}

Program randomProgram(std::mt19937& random) {
  static constexpr std::array<std::string_view, 16> names = {"LD",  "LDN", "A",   "AN",  "O",   "ON", "LDI", "AI",
                                                             "NOT", "ALD", "OLD", "LPS", "LPP", "=",  "=I",  "="};
  static constexpr std::array<Area, 9> areas = {Area::I,  Area::Q, Area::V, Area::M, Area::S,
                                                Area::SM, Area::L, Area::T, Area::C};
  Program program;
  program.pous.push_back({});
  program.pous[0].networks.push_back({});
  for (int i = 0; i < 200; ++i) {
    Instruction instruction;
    instruction.desc = s7200Instructions().named(names[random() % names.size()]);
    if (instruction.desc->operandCount == 1) {
      Area area = areas[random() % areas.size()];
      if (instruction.desc->stl == "=I") area = Area::Q;
      if (instruction.desc->stl == "LDI" || instruction.desc->stl == "AI") area = Area::I;
      instruction.operands.push_back(direct(area, Width::Bit, random() % 16, random() % 8));
    }
    program.pous[0].networks[0].instructions.push_back(std::move(instruction));
  }
  program.number();
  return program;
}

TEST(Dispatch, FormsForAreasAgreeWithTheGeneralForms) {
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  for (int round = 0; round < 300; ++round) {
    const Program program = randomProgram(random);
    const Plan plan(program);
    Concrete::Store start = powerUpState(plan, Choices{});
    for (const Area area : {Area::I, Area::Q, Area::V, Area::M, Area::S, Area::SM}) {
      for (std::size_t i = 0; i < 16; ++i) start.area(area)[i] = static_cast<std::uint8_t>(random());
    }
    for (std::uint32_t i = 0; i < 16; ++i) start.set(Reg::TimerBit, i, random() & 1, true);
    ASSERT_EQ(runOnce<ChosenForms>(plan, start), runOnce<GeneralForms>(plan, start));
  }
}

TEST(Dispatch, ControlInstructionsHaveNoFunction) {
  Instruction jump;
  jump.desc = s7200Instructions().named("JMP");
  jump.operands.push_back(constant(1));
  EXPECT_EQ(executionOf(jump, StatementForm::Rungs), nullptr);
}

}  // namespace
}  // namespace rungproof
