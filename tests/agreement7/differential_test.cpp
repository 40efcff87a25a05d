// Random S7-300/400 programs on the engine and on the naive interpreter: the same inputs and times lead to the same
// memory, outputs and data blocks after every scan; the status word, the accumulators and the other registers are
// stored at the end of OB1. A program that fails is shown as small as it can be made. RUNGPROOF_SEED chooses other
// programs, RUNGPROOF_SCANS how many scans are compared.
#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <sstream>

#include "tests/agreement7/engine_run.hpp"
#include "tests/agreement7/ir_of_text.hpp"
#include "tests/naive7/case_table.hpp"
#include "tests/naive7/program_generator.hpp"

namespace rungproof::agreement7 {
namespace {

constexpr int scansOfAProgram = 20;

/// The first difference, or nothing; `scans` counts those that were compared.
std::string firstDifference(const std::string& text, std::uint64_t seed, bool is400, int& scans, int& stops) {
  const naive7::Program blocks = naive7::readProgram(text);
  std::string faults;
  const Program program = irOf(blocks, is400, faults);
  if (!faults.empty()) return "unreadable: " + faults;
  for (const Pou& pou : program.pous) {
    if (!flowOf(pou).faults.empty()) return "unreadable: flow";
  }
  const Plan plan(program);
  Concrete::Store store(plan);
  for (const auto& [number, bytes] : blocks.dataBlocks) {
    for (std::uint32_t i = 0; i < bytes.size(); ++i)
      store.save(Area::DB, dataByte(static_cast<std::uint32_t>(number), i) * 8, 8, bytes[i], true);
  }
  naive7::Machine plain(blocks, is400);
  Around around;
  around.value = [&](const ExternalSite& site, int width) -> std::uint64_t {
    if (site.kind != External::AnalogInput) return 0;
    std::uint64_t value = 0;
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(width) / 8; ++i)
      value = value << 8 | plain.peripheralIn[site.index + i];
    return value;
  };
  std::mt19937_64 random(seed);
  for (int scan = 1; scan <= scansOfAProgram; ++scan) {
    const auto ms = static_cast<std::uint32_t>(random() % 60);
    for (std::uint32_t i = 0; i < 4; ++i) {
      plain.inputs[i] = static_cast<std::uint8_t>(random());
      plain.peripheralIn[256 + i] = static_cast<std::uint8_t>(random());
    }
    for (std::uint32_t i = 0; i < plain.inputs.size(); ++i) store.save(Area::I, i * 8, 8, plain.inputs[i], true);
    for (std::uint32_t i = 256; i < 260; ++i) store.save(Area::PI, i * 8, 8, plain.peripheralIn[i], true);
    around.hazards.clear();
    const bool runs = runOnce(program, store, around, ms, nullptr, nullptr);
    plain.advance(ms);
    plain.setStatus("000000000");
    for (std::uint32_t& accu : plain.accu) accu = 0;
    plain.ar[0] = plain.ar[1] = 0;
    plain.db = plain.di = 0;
    try {
      plain.run("OB1");
    } catch (const naive7::Stop& stop) {
      if (stop.fault == 0xFF) return "unreadable: " + stop.text;
      ++stops;
      return runs ? "scan " + std::to_string(scan) + ": only the naive interpreter stops, " + stop.text : "";
    }
    ++scans;
    if (!runs) return "scan " + std::to_string(scan) + ": only the engine stops";
    std::ostringstream wrong;
    const auto compare = [&](const std::string& name, Area area, std::uint32_t first,
                             const std::vector<std::uint8_t>& bytes, std::size_t count) {
      for (std::uint32_t i = 0; i < count; ++i) {
        const auto actual = store.load(area, (first + i) * 8, 8);
        if (actual != bytes[i]) {
          wrong << " " << name << i << ": naive " << std::hex << static_cast<int>(bytes[i]) << ", engine " << actual
                << std::dec;
        }
      }
    };
    compare("QB", Area::Q, 0, plain.outputs, 16);
    compare("MB", Area::M, 0, plain.memory, 256);
    compare("PQB", Area::PQ, 0, plain.peripheralOut, 300);
    for (const auto& [number, bytes] : plain.dataBlocks) {
      compare("DB" + std::to_string(number) + ".DBB", Area::DB, dataByte(static_cast<std::uint32_t>(number), 0), bytes,
              bytes.size());
    }
    if (!wrong.str().empty()) return "scan " + std::to_string(scan) + ":" + wrong.str();
  }
  return {};
}

std::string shrunk(std::string text, std::uint64_t seed, bool is400) {
  int scans = 0, stops = 0;
  for (bool smaller = true; smaller;) {
    smaller = false;
    for (std::size_t begin = 0; begin < text.size();) {
      const std::size_t end = text.find('\n', begin) + 1;
      // Only statements are left out, and none in front of LOOP, which would then find a count that does not fall.
      const bool isCountOfLoop = text.substr(end, text.find('\n', end) - end).find("LOOP ") != std::string::npos;
      if (text[begin] != ' ' || text.find(" : ", begin) < end || isCountOfLoop) {
        begin = end;
        continue;
      }
      const std::string shorter = text.substr(0, begin) + text.substr(end);
      const std::string wrong = firstDifference(shorter, seed, is400, scans, stops);
      if (!wrong.empty() && !wrong.starts_with("unreadable")) {
        text = shorter;
        smaller = true;
      } else {
        begin = end;
      }
    }
  }
  return text;
}

std::uint64_t given(const char* name, std::uint64_t standard) {
  const char* text = std::getenv(name);
  return text == nullptr ? standard : std::strtoull(text, nullptr, 10);
}

// Between L and T an interrupt comes: ACCU1 is as before behind it, and what it writes stays.
TEST(Differential7, MarksInterrupt) {
  const std::string text =
      naive7::organizationBlock("  L 5 ;\n  BLD 235 ;\n  T MW 10 ;\n") +
      "ORGANIZATION_BLOCK OB 35\nBEGIN\nNETWORK\n  L 7 ;\n  T MW 12 ;\nEND_ORGANIZATION_BLOCK\n";
  const naive7::Program blocks = naive7::readProgram(text);
  naive7::Machine plain(blocks, false);
  plain.run("OB1");
  EXPECT_EQ(plain.memory[11], 5);
  EXPECT_EQ(plain.memory[13], 7);
  int scans = 0, stops = 0;
  EXPECT_EQ(firstDifference(text, 1, false, scans, stops), "");
}

TEST(Differential7, EngineAgreesWithTheNaiveInterpreter) {
  const std::uint64_t seed = given("RUNGPROOF_SEED", 30040601);
  const auto wanted = static_cast<int>(given("RUNGPROOF_SCANS", 10000));
  int scans = 0, stops = 0, programs = 0, failures = 0;
  for (; scans < wanted; ++programs) {
    const std::uint64_t one = seed + static_cast<std::uint64_t>(programs);
    naive7::GeneratorChoices choices;
    choices.is400 = one % 2 == 0;
    choices.interrupts = one % 4 < 2;
    const std::string text = naive7::ProgramGenerator(one, choices).program();
    const std::string wrong = firstDifference(text, one, choices.is400, scans, stops);
    EXPECT_FALSE(wrong.starts_with("unreadable")) << "seed " << one << " " << wrong;
    if (wrong.empty()) continue;
    std::printf("seed %llu: %s\n", static_cast<unsigned long long>(one), wrong.c_str());
    const std::string small = shrunk(text, one, choices.is400);
    ADD_FAILURE() << "seed " << one << (choices.is400 ? " S7-400" : " S7-300") << "\n"
                  << small << firstDifference(small, one, choices.is400, scans, stops);
    if (++failures == static_cast<int>(given("RUNGPROOF_FAILURES", 1))) break;
  }
  std::printf("seed %llu: %d scans of %d programs, %d stopped\n", static_cast<unsigned long long>(seed), scans,
              programs, stops);
  EXPECT_GT(stops, 0);
}

}  // namespace
}  // namespace rungproof::agreement7
