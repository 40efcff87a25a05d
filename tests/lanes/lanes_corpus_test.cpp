// Many traces of the programs of the corpus, and what sets a trace apart.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "frontend/input/project.hpp"
#include "tests/lanes/many_pair.hpp"

namespace rungproof::test {
namespace {

namespace fs = std::filesystem;

Program programOf(const std::string& networks) {
  return readText("small.awl", "ORGANIZATION_BLOCK MAIN:OB1\nBEGIN\n" + networks + "END_ORGANIZATION_BLOCK\n");
}

bool hasErrors(const Program& program) {
  return std::ranges::any_of(program.findings, [](const Finding& f) { return f.severity == Severity::Error; });
}

/// Programs that need a device or an interrupt from the first scan on, or write what belongs to the CPU.
const std::set<std::string> neverSideBySide = {
    "data/clock_schedule.awl",              // TODR
    "data/freeport_echo.awl",               // ATCH, RCV
    "data/hsc_batch.awl",                   // HDEF, HSC
    "data/pwm_lamp.awl",                    // PLS
    "data/tank_pid.awl",                    // ATCH
    "defects/blip_written_out.awl",         // ATCH
    "defects/interrupt_byte.awl",           // ATCH
    "defects/interrupt_byte_repaired.awl",  // ATCH
    "faulty/ranges.awl",                    // writes SM0
    "smart/gate_train.awl",                 // ATCH, PLS
    "timers/interrupt_count.awl",           // ATCH
};

TEST(LanesOfTheCorpus, Agree) {
  std::size_t programs = 0, side = 0, scans = 0;
  std::set<std::string> apart;
  const fs::path corpus = fs::path(RUNGPROOF_SOURCE_DIR) / "corpus";
  for (const auto& entry : fs::recursive_directory_iterator(corpus)) {
    if (entry.path().extension() != ".awl") continue;
    const Program program = readProgram({entry.path().string()});
    if (hasErrors(program) || program.instructionCount() == 0) continue;
    ManyOptions options;
    options.scans = 12;
    options.writesMemory = false;
    if (programs % 3 == 0) options.most = lanes::Vectors::Bits256;
    RandomSource random(testSeed());
    const ManyOutcome outcome = runBeside(program, random, options);
    EXPECT_EQ(outcome.difference, "") << entry.path() << " seed " << testSeed();
    ++programs;
    scans += outcome.traceScans;
    side += outcome.sideBySide;
    if (outcome.sideBySide == 0) apart.insert(fs::relative(entry.path(), corpus).string());
  }
  EXPECT_EQ(apart, neverSideBySide);
  EXPECT_GE(side * 100, scans * 90);
  std::printf("%zu programs, %zu of %zu trace-scans side by side\n", programs, side, scans);
}

const Operand q00 = direct(Area::Q, Width::Bit, 0, 0);

/// Trace k has input I0.0 on in scan k + 1: there it executes STOP, and the others go on side by side.
TEST(Lanes, OneThatStopsIsSetApartAndStaysStopped) {
  const Program program = programOf("Network 1\nLD I0.0\nSTOP\nLDN I0.0\n= Q0.0\n");
  ManyTraces many(program, {}, 3);
  ASSERT_EQ(many.hindrance(), "");
  for (std::size_t scan = 0; scan < 3; ++scan) {
    many.setInput(0, 0, {std::uint64_t{1} << scan});
    many.scan();
    EXPECT_EQ(many.sideBySide(), 2 - scan);
    for (std::size_t trace = 0; trace < 3; ++trace)
      EXPECT_EQ(many.store(trace).get(Reg::Running, 0), trace <= scan ? 0U : 1U) << trace << " in scan " << scan;
  }
}

/// A truth table by 256 traces: of two inputs, each in half of them.
TEST(Lanes, WhereABitIsOn) {
  const Program program = programOf("Network 1\nLD I0.0\nA I0.1\n= Q0.0\n");
  ManyTraces many(program, {}, 256);
  EXPECT_EQ(many.lanes(), 256U);  // truth values only
  const ManyTraces::TraceSet odd(4, 0xAAAAAAAAAAAAAAAA), upper{0, 0, ~0ULL, ~0ULL};
  many.setInput(0, 0, odd);
  many.setInput(0, 1, upper);
  many.scan();
  EXPECT_EQ(many.whereOn(q00), (ManyTraces::TraceSet{0, 0, odd[2], odd[3]}));
}

/// A trace that is set apart repeats the scans since the last checkpoint, of which there is one every 64 scans: the
/// counter has all of them, wherever between two checkpoints it stops.
TEST(Lanes, NothingIsLostBetweenCheckpoints) {
  const Program program = programOf("Network 1\nLD SM0.0\nINCW VW0\nLD I0.0\nSTOP\n");
  ManyTraces many(program, {}, 100);
  ManyTraces::TraceSet stopped(2);
  for (std::size_t scan = 0; scan < 100; ++scan) {
    stopped[scan / 64] |= std::uint64_t{1} << (scan % 64);
    many.setInput(0, 0, stopped);
    many.scan();
  }
  for (std::size_t trace = 0; trace < 100; ++trace)
    EXPECT_EQ(many.read(trace, direct(Area::V, Width::Word, 0, 0)), trace + 1) << trace;
}

/// 32,767 + 1 is an overflow (001:4831); only trace 1 has that word.
TEST(Lanes, AnErrorIsThatOfItsTrace) {
  const Program program = programOf("Network 1\nLD SM0.0\n+I 1, VW0\n");
  ManyTraces many(program, {}, 2);
  many.write(1, direct(Area::V, Width::Word, 0, 0), 32767);
  many.scan();
  EXPECT_TRUE(many.errors(0).empty());
  ASSERT_EQ(many.errors(1).size(), 1U);
  EXPECT_EQ(many.errors(1).front().first, Hazard::Overflow);
  EXPECT_EQ(many.sideBySide(), 2U);
}

/// A scan that is shorter than its program would last longer than asked, by trace for another time.
TEST(Lanes, AScanShorterThanTheProgramIsForTheSimulator) {
  std::string networks = "Network 1\n";
  for (int i = 0; i < 20; ++i) networks += "LD I0.0\n= Q0.0\n";
  const Program program = programOf(networks);
  ManyTraces many(program, {}, 2);
  many.scan(10'000);
  EXPECT_EQ(many.sideBySide(), 2U);
  many.scan(1);
  EXPECT_EQ(many.sideBySide(), 0U);
}

/// A module says at once what it says when the image is read (002:1292): input 0.0 of trace 1 alone is on.
TEST(Lanes, ModulesThatAreAskedAtOnceSayWhatTheInputsAre) {
  ReadOptions reading;
  reading.dialect = "s7-300";
  const Program program = readText(
      "small.awl", "ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\nL PIB 0;\nT MB 0;\nEND_ORGANIZATION_BLOCK\n", reading);
  ManyTraces many(program, {}, 2);
  many.setInput(0, 0, {0b10});
  many.scan(10'000);
  EXPECT_EQ(many.read(0, direct(Area::M, Width::Byte, 0)), 0U);
  EXPECT_EQ(many.read(1, direct(Area::M, Width::Byte, 0)), 1U);
}

TEST(Lanes, WhatTheCpuWritesIsNotForPrograms) {
  const Program program = programOf("Network 1\nLD I0.0\nMOVW 5, SMW22\n");
  EXPECT_EQ(ManyTraces(program, {}, 2).hindrance(), "the program writes what belongs to the CPU");
}

}  // namespace
}  // namespace rungproof::test
