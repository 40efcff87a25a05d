// Random S7-300/400 programs and the table of stated cases on the transition system that proofs are about.
// RUNGPROOF_SEED chooses other programs, RUNGPROOF_ENCODED how many scans of them are compared.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <map>

#include "ir/block_map.hpp"
#include "tests/agreement7/encoder_run.hpp"
#include "tests/agreement7/ir_of_text.hpp"
#include "tests/naive7/case_table.hpp"
#include "tests/naive7/program_generator.hpp"

namespace rungproof::agreement7 {
namespace {

using naive7::Case;

std::uint64_t number(const char* name, std::uint64_t standard) {
  const char* text = std::getenv(name);
  return text == nullptr ? standard : std::strtoull(text, nullptr, 10);
}

std::string withoutStatement(const std::string& text, std::size_t begin, std::size_t end) {
  return text.substr(0, begin) + text.substr(end);
}

std::string wrongOf(const std::string& text, std::uint64_t seed, bool is400) {
  std::string faults;
  const Program program = irOf(naive7::readProgram(text), is400, faults);
  if (!faults.empty()) return {};
  for (const Pou& pou : program.pous) {
    if (!flowOf(pou).faults.empty()) return {};
  }
  return compareWithEngine(program, seed, 10).difference;
}

std::string smaller(std::string text, std::uint64_t seed, bool is400) {
  for (bool again = true; again;) {
    again = false;
    for (std::size_t begin = 0; begin < text.size();) {
      const std::size_t end = text.find('\n', begin) + 1;
      const bool isStatement = text[begin] == ' ' && text.find(" : ", begin) >= end;
      if (isStatement && !wrongOf(withoutStatement(text, begin, end), seed, is400).empty()) {
        text = withoutStatement(text, begin, end);
        again = true;
      } else {
        begin = end;
      }
    }
  }
  return text;
}

/// Programs until so many of their scans were compared; `interrupts`: with OB35 and OB40.
void compareRandom(std::uint64_t seed, int wanted, bool interrupts) {
  int scans = 0, programs = 0, exact = 0;
  std::map<std::string, int> reasons;
  for (; scans < wanted && programs < wanted; ++programs) {
    const std::uint64_t one = seed + static_cast<std::uint64_t>(programs);
    naive7::GeneratorChoices choices;
    choices.is400 = one % 2 == 0;
    choices.interrupts = interrupts;
    choices.snippets = interrupts ? 1 : 6;  // interrupts may come anywhere, which makes encodings large
    choices.timers = !interrupts;
    choices.overlappingModules = false;  // replay gives a byte one value in a scan
    const std::string text = naive7::ProgramGenerator(one, choices).program();
    std::string faults;
    const Program program = irOf(naive7::readProgram(text), choices.is400, faults);
    ASSERT_EQ(faults, "") << "seed " << one;
    const AgreementOutcome outcome = compareWithEngine(program, one, 10);
    scans += outcome.scans;
    exact += outcome.isExact ? 1 : 0;
    if (!outcome.isExact) ++reasons[outcome.approximation];
    if (outcome.difference.empty()) continue;
    const std::string small = smaller(text, one, choices.is400);
    FAIL() << "seed " << one << (choices.is400 ? " S7-400" : " S7-300") << "\n"
           << small << wrongOf(small, one, choices.is400);
  }
  std::printf("seed %llu: %d scans of %d programs, %d exact\n", static_cast<unsigned long long>(seed), scans, programs,
              exact);
  for (const auto& [reason, count] : reasons) std::printf("%d times %s", count, reason.c_str());
  EXPECT_GT(exact * 2, programs);
}

TEST(Encoder7, AgreesWithTheEngineOnRandomPrograms) {
  compareRandom(number("RUNGPROOF_SEED", 40040601), static_cast<int>(number("RUNGPROOF_ENCODED", 15000)), false);
}

// RUNGPROOF_INTERRUPTED scans: a program in some dozens takes minutes.
TEST(Encoder7, AgreesWhereOrganizationBlocksInterrupt) {
  compareRandom(number("RUNGPROOF_SEED", 40040601), static_cast<int>(number("RUNGPROOF_INTERRUPTED", 100)), true);
}

std::string hexWord(std::uint32_t value) {
  std::array<char, 24> text{};
  std::snprintf(text.data(), text.size(), "DW#16#%08X", value);
  return text.data();
}

/// Statements that give the registers the values of `before`.
std::string puttingIn(const Case& c) {
  const auto say = [](const std::string& statement) { return "  " + statement + " ;\n"; };
  std::uint32_t status = 0;
  for (char bit : c.status) status = status << 1 | (bit == '1' ? 1U : 0U);
  std::string text = say("LAR1 P#0.0");
  text += say("L " + hexWord(c.regs.at("AR1"))) + say("LAR1") + say("L " + hexWord(c.regs.at("AR2"))) + say("LAR2");
  text += say("OPN DB " + std::to_string(c.regs.at("DB"))) + say("OPN DI " + std::to_string(c.regs.at("DI")));
  if (c.is400) {
    text += say("L " + hexWord(status)) + say("T STW") + say("L " + hexWord(c.regs.at("4")));
    for (int i = 0; i < 3; ++i) text += say("PUSH");
    text += say("L " + hexWord(c.regs.at("3"))) + say("PUSH") + say("PUSH");
  } else {  // /FC, OR and STA come from logic, the others from T STW
    const bool orBit = c.status[5] == '1', sta = c.status[6] == '1', first = c.status[8] == '1';
    text += say("SET") + say("= M 250.1") + say("CLR") + say("= M 250.0");
    text += say(sta ? "SET" : "CLR");
    if (orBit) text += say("A M 250.1") + say("O");
    if (first) text += say(sta ? "A M 250.1" : "A M 250.0");
    text += say("L " + hexWord(status)) + say("T STW");
  }
  return text + say("L " + hexWord(c.regs.at("2"))) + say("L " + hexWord(c.regs.at("1")));
}

std::string takingOut(const Case& c) {
  std::string text;
  const auto say = [&](const std::string& statement) { text += "  " + statement + " ;\n"; };
  for (const char* s : {"MCRD", "T MD 200", "TAK", "T MD 204"}) say(s);
  if (c.is400) {
    for (const char* s : {"LEAVE", "TAK", "T MD 224", "LEAVE", "TAK", "T MD 228"}) say(s);
  }
  for (const char* s : {"L STW", "T MW 208", "TAR1 MD 212", "TAR2 MD 216", "L DBNO", "T MW 220", "L DINO", "T MW 222"})
    say(s);
  return text;
}

bool usesModules(const Case& c) {
  return c.text.find("PI") != std::string::npos ||
         std::ranges::any_of(c.bytes, [](const auto& byte) { return byte.first.starts_with("PI"); });
}

/// What the transition system leaves otherwise than stated; nothing where the case cannot be asked so.
std::string caseDifference(const Case& c, int& asked) {
  if (c.stop != 0 || c.scans.size() != 1 || c.regs.at("DB") == 0 || usesModules(c)) return {};
  std::string put = puttingIn(c), statements = c.scans[0];
  // Inputs and local data begin with any value.
  std::string memory = "  L 0 ;\n  T ID 0 ;\n  T ID 4 ;\n  T LD 20 ;\n";
  naive7::Program blocks = naive7::readProgram(c.blocks);
  naive7::Machine before(blocks, c.is400);
  for (const auto& [key, value] : c.bytes) {
    before.write(before.direct(key), value);
    if (key.starts_with("DB")) continue;
    const bool isBit = key.find('.') != std::string::npos;
    memory += isBit ? std::string("  ") + (value != 0 ? "SET" : "CLR") + " ;\n  = " + key + " ;\n"
                    : "  L " + hexWord(value) + " ;\n  T " + key + " ;\n";
  }
  naive7::Machine wanted = before;
  for (const auto& [key, value] : c.bytesAfter) wanted.write(wanted.direct(key), value);
  const std::size_t mark = statements.find("  @ ;\n");
  statements.replace(mark, 6, put);
  naive7::Program one = naive7::readProgram(c.blocks + naive7::organizationBlock(memory + statements + takingOut(c)));
  one.dataBlocks = before.dataBlocks;
  std::string faults;
  const Program program = irOf(one, c.is400, faults);
  if (!faults.empty()) return faults;
  std::map<Area, std::map<std::uint32_t, bool>> bits;
  const auto keep = [&](const Place& place, std::uint64_t value) {
    if (place.isRegister) return;
    for (std::uint32_t i = 0; i < place.width; ++i) {
      const std::uint32_t at = place.at + i;
      bits[place.area][at / 8 * 8 + 7 - at % 8] = (value >> (place.width - 1 - i) & 1U) != 0;
    }
  };
  AgreementOutcome outcome;
  Choices choices;
  EXPECT_TRUE(choices.set("s5-time", "synchronous"));                       // within a scan no time is stated to pass
  for (std::uint64_t seed = 1; seed <= 60 && outcome.scans == 0; ++seed) {  // not all inputs make a scan
    outcome = compareWithEngine(program, seed, 1, keep, choices);
    if (!outcome.difference.empty()) return outcome.difference;
    if (!outcome.isExact) return {};  // more rounds of a loop than are followed
  }
  if (outcome.scans == 0) return "no scan";
  ++asked;
  std::string text;
  const auto bitOf = [&](Area area, std::uint32_t at, bool otherwise) {
    const auto found = bits[area].find(at);
    return found == bits[area].end() ? otherwise : found->second;
  };
  const auto doubleAt = [&](std::uint32_t byte, std::uint32_t count) {
    std::uint32_t value = 0;
    for (std::uint32_t i = 0; i < count * 8; ++i)
      value = value << 1 | (bitOf(Area::M, (byte + i / 8) * 8 + 7 - i % 8, false) ? 1U : 0U);
    return value;
  };
  const std::uint32_t status = doubleAt(208, 2);
  for (std::size_t i = 0; i < 9; ++i) {
    const bool isHidden = !c.is400 && (i == 5 || i == 6 || i == 8);
    const char stated = c.statusAfter[i] == '.' ? c.status[i] : c.statusAfter[i];
    if (!isHidden && stated != '?' && (stated == '1') != ((status >> (8 - i) & 1U) != 0))
      text += " status bit " + std::to_string(8 - i);
  }
  std::map<std::string, std::uint32_t> actual = {{"1", doubleAt(200, 4)},   {"2", doubleAt(204, 4)},
                                                 {"AR1", doubleAt(212, 4)}, {"AR2", doubleAt(216, 4)},
                                                 {"DB", doubleAt(220, 2)},  {"DI", doubleAt(222, 2)}};
  if (c.is400) actual.insert({{"3", doubleAt(224, 4)}, {"4", doubleAt(228, 4)}});
  for (const auto& [key, value] : actual) {
    if (std::ranges::find(c.openRegs, key) == c.openRegs.end() && c.regsAfter.at(key) != value)
      text += " " + key + "=" + hexWord(value);
  }
  const auto compare = [&](Area area, std::uint32_t first, const std::vector<std::uint8_t>& after, std::size_t count,
                           const std::vector<std::uint8_t>& start) {
    for (std::uint32_t at = 0; at < count * 8; ++at) {
      const bool old = (start[at / 8] >> at % 8 & 1U) != 0, stated = (after[at / 8] >> at % 8 & 1U) != 0;
      if (bitOf(area, first * 8 + at, old) != stated)
        text += " " + std::string(areaName(area)) + std::to_string(first + at / 8) + "." + std::to_string(at % 8);
    }
  };
  compare(Area::Q, 0, wanted.outputs, wanted.outputs.size(), before.outputs);
  compare(Area::M, 0, wanted.memory, 200, before.memory);
  for (const auto& [block, bytes] : wanted.dataBlocks)
    compare(Area::DB, dataByte(static_cast<std::uint32_t>(block), 0), bytes, bytes.size(), before.dataBlocks.at(block));
  return text;
}

TEST(Encoder7, DoesWhatTheTableStates) {
  const std::vector<Case> cases = naive7::readCases(std::string(RUNGPROOF_SOURCE_DIR) + "/tests/data/s7300_cases.tsv");
  int asked = 0;
  for (const Case& c : cases) EXPECT_EQ(caseDifference(c, asked), "") << c.name();
  std::printf("%d cases asked\n", asked);
  EXPECT_GT(asked, 2000);
}

}  // namespace
}  // namespace rungproof::agreement7
