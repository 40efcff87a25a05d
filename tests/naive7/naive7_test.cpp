// The naive interpreter against the table of stated cases; and the table itself: every row of the instruction list has
// three cases or more, and 4,000 values are stated in sum.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>

#include "tests/naive7/case_table.hpp"
#include "tests/naive7/machine.hpp"

namespace naive7 {
namespace {

const std::vector<Case>& cases() {
  static const std::vector<Case> all = readCases(std::string(RUNGPROOF_SOURCE_DIR) + "/tests/data/s7300_cases.tsv");
  return all;
}

void putRegisters(const Case& c, Machine& machine) {
  machine.setStatus(c.status);
  for (int i = 0; i < 4; ++i) machine.accu[i] = c.regs.at(std::to_string(i + 1));
  machine.ar[0] = c.regs.at("AR1");
  machine.ar[1] = c.regs.at("AR2");
  machine.db = static_cast<int>(c.regs.at("DB"));
  machine.di = static_cast<int>(c.regs.at("DI"));
}

std::string hex(std::uint32_t value) {
  std::ostringstream out;
  out << std::hex << std::uppercase << value;
  return out.str();
}

/// What differs from the stated values; empty if nothing does.
std::string differences(const Case& c) {
  const Program program = readProgram(c.blocks);
  Machine machine(program, c.is400);
  Machine wanted(program, c.is400);
  for (Machine* m : {&machine, &wanted}) {
    for (const auto& [key, value] : c.bytes) {
      if (key.starts_with("PI")) {
        const Place p = m->direct(key);
        for (int i = 0; i < p.width / 8; ++i) {
          m->peripheralIn[p.bit / 8 + static_cast<std::size_t>(i)] =
              static_cast<std::uint8_t>(value >> (p.width - 8 - 8 * i));
        }
      } else {
        m->write(m->direct(key), value);
      }
    }
  }
  for (const auto& [key, value] : c.bytesAfter) wanted.write(wanted.direct(key), value);
  machine.mark = [&] { putRegisters(c, machine); };
  std::string text;
  try {
    for (std::size_t i = 0; i < c.scans.size(); ++i) {
      if (i > 0) machine.advance(c.pauses[i - 1]);
      const Program one = readProgram(organizationBlock(c.scans[i]));
      machine.runStatements(one.blocks.at("OB1"));
    }
    if (c.stop != 0) text += " did not stop";
  } catch (const Stop& stop) {
    if (stop.fault != c.stop) text += " stopped with " + hex(static_cast<std::uint32_t>(stop.fault)) + " " + stop.text;
  }
  if (c.stop == 0) {
    const std::string status = machine.statusText();
    for (std::size_t i = 0; i < 9; ++i) {
      const char stated = c.statusAfter[i] == '.' ? c.status[i] : c.statusAfter[i];
      if (stated != '?' && stated != status[i]) {
        text += " status " + status;
        break;
      }
    }
    const std::map<std::string, std::uint32_t> now = {{"1", machine.accu[0]},
                                                      {"2", machine.accu[1]},
                                                      {"3", machine.accu[2]},
                                                      {"4", machine.accu[3]},
                                                      {"AR1", machine.ar[0]},
                                                      {"AR2", machine.ar[1]},
                                                      {"DB", static_cast<std::uint32_t>(machine.db)},
                                                      {"DI", static_cast<std::uint32_t>(machine.di)}};
    for (const auto& [key, value] : now) {
      const bool isOpen = std::find(c.openRegs.begin(), c.openRegs.end(), key) != c.openRegs.end();
      if (!isOpen && c.regsAfter.at(key) != value) text += " " + key + "=" + hex(value);
    }
  }
  if (machine.inputs != wanted.inputs) text += " inputs";
  if (machine.outputs != wanted.outputs) text += " outputs";
  if (machine.memory != wanted.memory) text += " memory";
  if (machine.peripheralOut != wanted.peripheralOut) text += " peripheral outputs";
  if (machine.dataBlocks != wanted.dataBlocks) text += " data blocks";
  return text;
}

TEST(Naive7, DoesWhatTheTableStates) {
  for (const Case& c : cases()) {
    ASSERT_FALSE(c.row.empty()) << c.text;
    EXPECT_EQ(differences(c), "") << c.name();
  }
}

TEST(Naive7, EveryRowHasThreeCases) {
  std::ifstream in(std::string(RUNGPROOF_SOURCE_DIR) + "/tests/data/s7300_rows.tsv");
  std::set<std::string> rows;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream columns(line);
    std::string category, mnemonic;
    std::getline(columns, category, '\t');
    std::getline(columns, mnemonic, '\t');
    EXPECT_TRUE(rows.insert(mnemonic).second) << mnemonic;
  }
  EXPECT_EQ(rows.size(), 181u);
  std::map<std::string, int> count;
  std::size_t values = 0;
  for (const Case& c : cases()) {
    ++count[c.row];
    EXPECT_TRUE(rows.contains(c.row)) << c.row;
    EXPECT_TRUE(c.status.size() == 9 && c.statusAfter.size() == 9) << c.name();
    if (c.stop == 0) {
      values += 11 - static_cast<std::size_t>(std::count(c.statusAfter.begin(), c.statusAfter.end(), '?')) +
                c.bytesAfter.size() - std::min<std::size_t>(c.openRegs.size(), 2);
    }
  }
  for (const std::string& row : rows) EXPECT_GE(count[row], 3) << row;
  EXPECT_GE(values, 20000u);
}

}  // namespace
}  // namespace naive7
