// The engine against the naive interpreter on random programs. Both run the same scans; memory, accumulators, timers
// and counters must agree after each. The seed is printed with every failure (RUNGPROOF_SEED sets it); at least
// 200,000 instructions are executed, and each mnemonic that the naive interpreter knows in one of the random tests.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <random>

#include "engine/simulator.hpp"
#include "frontend/input/project.hpp"
#include "ir/s7200/cpu.hpp"
#include "ir/s7200/isa.hpp"
#include "likeness.hpp"
#include "naive.hpp"
#include "program_generator.hpp"

namespace rungproof::reference {
namespace {

/// REAL results that the manual leaves to rounding, with the size of the intermediate results: see
/// program_generator.hpp.
constexpr std::pair<std::uint32_t, double> rounded[] = {{52, 1e-30}, {56, 1e-30}, {60, 1e-30}, {64, 1e-30}, {68, 1e-30},
                                                        {72, 1e-30}, {76, 1e-30}, {1268, 10},  {1288, 10}};

std::string memoryThatDiffers(const Simulator& engine, naive::Interpreter& plain) {
  const Concrete::Store& s = engine.store();
  for (const auto& [byte, least] : rounded) {
    const Operand place = direct(Area::V, Width::DWord, byte);
    const auto actual = static_cast<std::uint32_t>(s.load(Area::V, byte * 8, 32));
    if (!isClose(actual, plain.read(place, 4), least))
      return fmt::format("VD{}: naive {:x}, engine {:x}", byte, plain.read(place, 4), actual);
    plain.write(place, 4, actual);
  }
  for (const auto& [area, first, last] : {std::tuple{Area::V, 0U, 1300U},
                                          {Area::M, 0U, 31U},
                                          {Area::Q, 0U, 15U},
                                          {Area::S, 0U, 31U},
                                          {Area::SM, 1U, 1U},
                                          {Area::SM, 4U, 4U}}) {
    for (std::uint32_t byte = first; byte <= last; ++byte) {
      const std::uint8_t transmitters = area == Area::SM && byte == 4 ? 0x60 : 0;  // SM4.5 and SM4.6: ports
      const auto expected = plain.memory.at(area)[byte] | transmitters, actual = s.area(area)[byte] | transmitters;
      if (expected != actual) return fmt::format("{}B{}: naive {}, engine {}", areaName(area), byte, expected, actual);
    }
  }
  return {};
}

/// What differs between the two after a scan, or nothing.
std::string difference(const Simulator& engine, naive::Interpreter& plain) {
  const Concrete::Store& s = engine.store();
  if (const std::string wrong = memoryThatDiffers(engine, plain); !wrong.empty()) return wrong;
  for (std::uint32_t n = 0; n < 4; ++n) {
    if (s.get(Reg::Accumulator, n) != plain.accumulator[n])
      return fmt::format("AC{}: naive {:x}, engine {:x}", n, plain.accumulator[n], s.get(Reg::Accumulator, n));
  }
  for (std::uint32_t n = 0; n < 256; ++n) {
    if (static_cast<std::int16_t>(s.get(Reg::TimerCurrent, n)) != plain.timer[n] ||
        (s.get(Reg::TimerBit, n) != 0) != plain.timerBit[n]) {
      return fmt::format("T{}: naive {} {}, engine {} {}", n, plain.timer[n], plain.timerBit[n],
                         s.get(Reg::TimerCurrent, n), s.get(Reg::TimerBit, n));
    }
    if (static_cast<std::int16_t>(s.get(Reg::CounterCurrent, n)) != plain.counter[n] ||
        (s.get(Reg::CounterBit, n) != 0) != plain.counterBit[n]) {
      return fmt::format("C{}: naive {} {}, engine {} {}", n, plain.counter[n], plain.counterBit[n],
                         s.get(Reg::CounterCurrent, n), s.get(Reg::CounterBit, n));
    }
  }
  if ((s.get(Reg::Eno, 0) != 0) != plain.eno) return fmt::format("ENO: naive {}", plain.eno);
  if ((s.get(Reg::DiagnosticLed, 0) != 0) != plain.diagnosticLed) return "DIAG LED";
  return {};
}

/// Whether loops, jumps and segments are whole; the naive interpreter needs that.
bool isWhole(const Program& program) {
  for (const Pou& pou : program.pous) {
    if (!flowOf(pou).faults.empty()) return false;
  }
  return true;
}

/// Runs both for `scans` scans with inputs and lengths drawn from `seed`; gives the first difference.
std::string firstDifference(const std::string& text, std::uint64_t seed, int scans,
                            std::map<std::string, std::uint64_t>* executed) {
  const Program program = readText("random.awl", text);
  if (hasReadErrors(program) || !isWhole(program)) return "unreadable";
  std::mt19937_64 random(seed);
  const auto pick = [&](std::uint64_t n) { return random() % n; };
  Simulator engine(program, SimulatorOptions{});
  naive::Interpreter plain(program);
  std::uint64_t before = 0;
  for (int scan = 0; scan < scans; ++scan) {
    const auto inputs = static_cast<std::uint8_t>(pick(256));
    plain.memory[Area::I][0] = plain.inputs[0] = inputs;
    const std::uint64_t now = engine.timeUs() / 1000;
    for (unsigned bit = 0; bit < 8; ++bit) engine.write(direct(Area::I, Width::Bit, 0, bit), inputs >> bit & 1U);
    const std::uint32_t length = 5 + static_cast<std::uint32_t>(pick(150));
    engine.scan({.lengthUs = length * 1000});
    plain.scan(static_cast<int>(now / 10 - before / 10), static_cast<int>(now / 100 - before / 100));
    before = now;
    if (const std::string wrong = difference(engine, plain); !wrong.empty())
      return fmt::format("scan {}: {}", scan + 1, wrong);
  }
  if (executed != nullptr) {
    for (const auto& [name, count] : plain.executed) (*executed)[name] += count;
  }
  return {};
}

/// The same failure with as few lines as can be had by taking out lines one by one.
std::string shrunk(std::string text, std::uint64_t seed, int scans) {
  for (bool smaller = true; smaller;) {
    smaller = false;
    for (std::size_t begin = 0; begin < text.size();) {
      const std::size_t end = text.find('\n', begin) + 1;
      std::string shorter = text.substr(0, begin) + text.substr(end);
      const std::string wrong = firstDifference(shorter, seed, scans, nullptr);
      if (!wrong.empty() && wrong.rfind("unreadable", 0) != 0) {
        text = std::move(shorter);
        smaller = true;
      } else {
        begin = end;
      }
    }
  }
  return text;
}

/// Mnemonics that random programs do not hold: the moment within a scan decides their result, they end the program, or
/// they are in no text. single_test and sequence_test compare them.
const std::set<std::string> notInPrograms = {"TODR",    "TODRX",    "BITIM",   "CITIM",   "STOP",
                                             "MEND",    "RET",      "SR",      "RS",      "CTU.IEC",
                                             "CTD.IEC", "CTUD.IEC", "TON.IEC", "TOF.IEC", "TP.IEC"};
/// Those that the naive interpreter leaves out: devices, and interrupt routines that run.
const std::set<std::string> leftOut = {"NETR", "NETW", "XMT", "RCV", "HDEF", "HSC", "PLS", "CRETI", "RETI"};

TEST(Reference, EngineAgreesWithTheNaiveInterpreter) {
  const char* given = std::getenv("RUNGPROOF_SEED");
  const std::uint64_t seed = given == nullptr ? 20040601 : std::strtoull(given, nullptr, 10);
  std::map<std::string, std::uint64_t> executed;
  std::uint64_t total = 0;
  for (std::uint64_t round = 0; total < 600000; ++round) {
    const std::string text = ProgramGenerator(seed + round).program();
    const std::string wrong = firstDifference(text, seed + round, 15, &executed);
    ASSERT_EQ(wrong, "") << "seed " << seed + round << "\n" << shrunk(text, seed + round, 15);
    total = 0;
    for (const auto& [name, count] : executed) total += count;
  }
  fmt::print("seed {}: {} instructions executed, {} mnemonics\n", seed, total, executed.size());
  for (const Desc& desc : s7200Instructions().all()) {
    const std::string name(desc.stl);
    if ((desc.cpus & s7200Cpus) == 0 || !naive::signatureOf(name) || notInPrograms.contains(name)) continue;
    EXPECT_GT(executed[name], 0U) << name << " was never executed";
  }
}

TEST(Reference, TheNaiveInterpreterKnowsAllButDevices) {
  for (const Desc& desc : s7200Instructions().all()) {
    if ((desc.cpus & s7200Cpus) == 0) continue;  // it is an S7-200
    const std::string name(desc.stl);
    EXPECT_NE(naive::signatureOf(name).has_value(), leftOut.contains(name)) << name;
  }
}

}  // namespace
}  // namespace rungproof::reference
