// Instructions per second of the reference engine on programs of contacts, coils and sets, and on programs with 40 %
// word arithmetic; sizes 100, 1000 and 10000 instructions. One item is one instruction of the program.
#include <benchmark/benchmark.h>

#include "engine/simulator.hpp"
#include "ir/s7200/isa.hpp"

namespace rungproof {
namespace {

Instruction make(std::string_view mnemonic, Operands operands = {}) {
  Instruction instruction;
  instruction.desc = s7200Instructions().named(mnemonic);
  instruction.operands = std::move(operands);
  return instruction;
}

Operand bit(Area area, std::uint32_t number) { return direct(area, Width::Bit, number / 8, number % 8); }

/// Rungs with a latch, a branch and a set coil, over changing addresses.
void addBitRung(std::vector<Instruction>& list, std::uint32_t k) {
  list.push_back(make("LD", {bit(Area::I, k % 64)}));
  list.push_back(make("O", {bit(Area::M, k % 200)}));
  list.push_back(make("AN", {bit(Area::I, (k * 7 + 3) % 64)}));
  list.push_back(make("=", {bit(Area::M, k % 200)}));
  list.push_back(make("LD", {bit(Area::M, (k * 5 + 1) % 200)}));
  list.push_back(make("A", {bit(Area::I, (k * 3) % 64)}));
  list.push_back(make("LDN", {bit(Area::M, (k * 11) % 200)}));
  list.push_back(make("OLD"));
  list.push_back(make("=", {bit(Area::Q, k % 64)}));
  list.push_back(make("S", {bit(Area::M, 200 + k % 40), constant(1)}));
}

Program program(std::size_t size, bool mixed) {
  Program result;
  Pou main;
  main.networks.push_back({});
  std::vector<Instruction>& list = main.networks[0].instructions;
  for (std::uint32_t k = 0; list.size() < size; ++k) {
    addBitRung(list, k);
    if (!mixed) continue;
    const auto word = [&](std::uint32_t n) { return direct(Area::V, Width::Word, n % 500 * 2, 0); };
    list.push_back(make("MOVW", {word(k), word(k + 1)}));
    list.push_back(make("+I", {constant(3), word(k + 1)}));
    list.push_back(make("INCW", {word(k + 7)}));
    list.push_back(make("LDW>=", {word(k + 2), constant(100)}));
    list.push_back(make("-I", {word(k + 5), word(k + 4)}));
    list.push_back(make("+I", {word(k + 6), word(k + 3)}));
  }
  list.resize(size);
  result.pous.push_back(std::move(main));
  result.number();
  return result;
}

void run(benchmark::State& state, bool mixed) {
  const Program source = program(static_cast<std::size_t>(state.range(0)), mixed);
  Simulator simulator(source);
  std::uint64_t inputs = 0x123456789ABCDEFULL;
  for (auto _ : state) {
    inputs = inputs * 6364136223846793005ULL + 1442695040888963407ULL;
    simulator.write(direct(Area::I, Width::DWord, 0), inputs >> 32);
    simulator.write(direct(Area::I, Width::DWord, 4), inputs & 0xFFFFFFFF);
    simulator.scan();
    benchmark::DoNotOptimize(simulator.store());
  }
  state.SetItemsProcessed(state.iterations() * state.range(0));
}

void bitLogic(benchmark::State& state) { run(state, false); }
void mixed(benchmark::State& state) { run(state, true); }

BENCHMARK(bitLogic)->Arg(100)->Arg(1000)->Arg(10000);
BENCHMARK(mixed)->Arg(100)->Arg(1000)->Arg(10000);

}  // namespace
}  // namespace rungproof

BENCHMARK_MAIN();
