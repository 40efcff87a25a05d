// Both families' instructions on the S7-200 SMART, engine and naive interpreter side by side on a CPU ST60: operands
// that both have, and comparisons of numbers that are none. The seed stands in every failure; RUNGPROOF_SEED sets it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "ir/s7200/cpu.hpp"
#include "ir/s7200/isa.hpp"
#include "likeness.hpp"
#include "smart_case.hpp"
#include "tests/manual/plant.hpp"

namespace rungproof::reference {
namespace {

constexpr Target onSmart{s7200Cpu("ST60"), Edition::Smart28};

TEST(SmartReference, WhatBothFamiliesHave) {
  int compared = 0;
  for (const Desc& desc : s7200Instructions().all()) {
    const std::string name(desc.stl);
    const bool isOfBoth = (desc.cpus & s7200Cpus) != 0 && (desc.cpus & cpuBit(onSmart.cpu)) != 0;
    const auto signature = naive::signatureOf(name);
    if (!isOfBoth || !signature || signature->empty() || desc.control != Control::None) continue;
    if (signature->find_first_not_of("bwdrBWDR") != std::string_view::npos) continue;  // of one value each
    ++compared;
    for (std::uint64_t seed = smartSeed(); seed < smartSeed() + smartCases(60) && !HasFatalFailure(); ++seed)
      compareOnSmart(name, seed * 104729);
  }
  EXPECT_GT(compared, 120);
}

/// A REAL that is no number stops an S7-200 (fatal error 0012); here the contact is 0 and the scan goes on.
TEST(SmartReference, NoComparisonStopsTheCpu) {
  for (const char* relation : {"=", "<>", "<", "<=", ">", ">="}) {
    for (const char* joint : {"LD", "A", "O"}) {
      manual::Plant plant(fmt::format("LD SM0.0; {}R{} VD0, VD4; = Q0.0; LD SM0.0; = Q0.1", joint, relation), onSmart);
      plant.set("VD0", 0x7FC00000).set("VD4", 0x3F800000);
      naive::Interpreter plain(plant.program());
      copyState(plant, plain);
      plant.scan();
      plain.scan(0, 0);
      EXPECT_EQ(plant.outside.hazards().size(), 1U) << "an error that is reported, not fatal";
      EXPECT_FALSE(plant.halted) << joint << relation;
      EXPECT_EQ(plant.value("Q0.1"), 1U) << joint << relation;
      EXPECT_EQ(plant.value("Q0.0"), std::string_view(joint) == "O" ? 1U : 0U) << joint << relation;
      EXPECT_EQ(plain.memory.at(Area::Q)[0], plant.value("QB0")) << joint << relation;
    }
  }
}

}  // namespace
}  // namespace rungproof::reference
